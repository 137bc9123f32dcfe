// Any bytes as the trace of a walk that was accepted once: what differs from the fresh one, in words.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/fuzz/require.h"
#include "viz/formats/files.h"
#include "viz/snapshot/snapshot.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string fresh = isect::viz::read_file(ISECT_TRACE);
  const std::string accepted(reinterpret_cast<const char*>(data), size);
  const auto changes = isect::viz::compare_traces(accepted, fresh);
  for (const isect::viz::Change& change : changes) require(!change.what.empty(), "a change in words", accepted);
  if (nlohmann::json::accept(accepted))
    require(isect::viz::compare_traces(accepted, accepted).empty() || !changes.empty(), "no trace differs from itself",
            accepted);
  return 0;
}
