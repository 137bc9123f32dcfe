// The measurements of one suite as a program: for any machine, for one machine's instructions or beside other
// libraries. `isect bench` starts it; the report goes to stdout as JSON, what comes next to stderr.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

#include "bench/commit.h"
#include "bench/machine.h"
#include "bench/session.h"

namespace isect::bench {

void measure(Session&);  // the suite that this program is for

namespace {

Report measured(const Effort& effort, unsigned long long seed) {
  Session session(effort, seed);
  session.progress = [](const std::string& next) { std::fprintf(stderr, "%s\n", next.c_str()); };
  session.found.machine = this_machine(ISECT_FLAGS, ISECT_BUILD);
  session.found.machine.commit = commit;
#ifdef ISECT_LIBRARIES
  session.found.machine.libraries = ISECT_LIBRARIES;
#endif
  measure(session);
  if (effort.timed()) session.found.machine.noise = std::max(session.found.machine.noise, noise());
  return std::move(session.found);
}

}  // namespace
}  // namespace isect::bench

int main(int argc, char** argv) {
  using namespace isect::bench;
  Effort effort;
  unsigned long long seed = 1;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--quick") == 0)
      effort = Effort::quick();
    else if (std::strcmp(argv[i], "--verdicts") == 0)
      effort = Effort::verdicts();
    else if (std::strcmp(argv[i], "--seed") == 0 && i + 1 < argc)
      seed = std::strtoull(argv[++i], nullptr, 10);
    else if (std::strcmp(argv[i], "--commit") == 0)
      return std::printf("%s\n", commit) < 0 ? 4 : 0;
    else
      return std::fprintf(stderr, "usage: %s [--quick | --verdicts] [--seed N], or --commit\n", argv[0]), 2;
  }
  try {
    const std::string text = json(measured(effort, seed));
    return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0 ? 0 : 4;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s: %s\n", argv[0], e.what());
    return 1;
  }
}
