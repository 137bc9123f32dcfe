// The measurements as a program of its own: for one machine's instructions (measure_native) or beside other libraries
// (measure_peers). `isect bench` starts it; the report goes to stdout as JSON, what comes next to stderr.

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

#include "bench/session.h"

int main(int argc, char** argv) {
  using namespace isect::bench;
  Effort effort;
  unsigned long long seed = 1;
  std::vector<std::string> only;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--quick") == 0)
      effort = Effort::quick();
    else if (std::strcmp(argv[i], "--seed") == 0 && i + 1 < argc)
      seed = std::strtoull(argv[++i], nullptr, 10);
    else if (argv[i][0] != '-')
      only.emplace_back(argv[i]);
    else
      return std::fprintf(stderr, "usage: %s [--quick] [--seed N] [TEST...]\n", argv[0]), 2;
  }
  try {
    const Report report =
        measure(effort, seed, only, [](const std::string& next) { std::fprintf(stderr, "%s\n", next.c_str()); });
    const std::string text = json(report);
    return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0 ? 0 : 4;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s: %s\n", argv[0], e.what());
    return 1;
  }
}
