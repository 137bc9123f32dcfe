#pragma once
// One run of the measurements: what to measure, how thoroughly, and where the findings go.

#include <functional>
#include <string>
#include <vector>

#include "bench/report.h"

namespace isect::bench {

struct Effort {
  long cases = 1 << 16;   ///< distinct inputs of a family
  long judged = 1 << 16;  ///< how many of them the oracle judges
  int least_passes = 7, most_passes = 31;
  double seconds = 0.06;  ///< aimed at for all passes of one method
  bool all_sizes = true;  ///< growth up to a million
  static Effort quick() { return {1 << 16, 1 << 10, 2, 7, 0.008, false}; }
};

class Session {
 public:
  Session(const Effort& the_effort, unsigned long long the_seed) : effort(the_effort), seed(the_seed) {}

  const Effort effort;
  const unsigned long long seed;
  std::vector<Row> rows;
  std::vector<Growth> growths;
  std::function<void(const std::string&)> progress = [](const std::string&) {};  ///< told what comes next
};

/// The measurements of one test or structure, by the name that a command line selects.
struct Suite {
  const char* name;
  void (*run)(Session&);
};
/// All of them, in the order of the report.
const std::vector<Suite>& suites();

/// Runs the suites named (all if none; unknown names run nothing) and says on which machine.
Report measure(const Effort&, unsigned long long seed, const std::vector<std::string>& only,
               const std::function<void(const std::string&)>& progress);

}  // namespace isect::bench
