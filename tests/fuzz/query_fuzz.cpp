// Any bytes as a line of `isect query`: an answer or an error, one line of JSON, and no crash.

#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "app/query/query.h"
#include "tests/fuzz/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string line(reinterpret_cast<const char*>(data), size);
  std::erase(line, '\n');
  const isect::query::Answer answer = isect::query::answer(line);
  require(answer.text.find('\n') == std::string::npos, "one line", line);
  const nlohmann::json reply = nlohmann::json::parse(answer.text);
  require(reply.contains("id"), "an id", line);
  require(reply.contains("error") == answer.error, "an error that is told", line);
  require(reply.contains("result") != answer.error, "a result or an error", line);
  return 0;
}
