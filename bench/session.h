#pragma once
// One run of a suite: what to measure, how thoroughly, and where the findings go.

#include <functional>
#include <string>
#include <utility>
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
  /// Times nothing, and judges only what promises to be exact.
  static Effort verdicts() { return {1 << 16, 1 << 16, 0, 0, 0, false}; }
  bool timed() const { return most_passes > 0; }
};

class Session {
 public:
  Session(const Effort& the_effort, unsigned long long the_seed) : effort(the_effort), seed(the_seed) {
    found.seed = seed, found.quick = effort.judged < effort.cases;
  }

  /// Adds a target of this suite; the report shows whether it was met.
  void aim(Target target) { found.targets.push_back(std::move(target)); }
  /// Adds the targets that every test has on hard input: in its worst family, and where shapes touch exactly.
  void aim_on_hard_input(const std::string& test, std::string worst_limit = {}, std::string touch_limit = {}) {
    aim({.work = test + ", worst family",
         .kind = Target::hard,
         .test = test,
         .theirs = "naive",
         .at_most = 30,
         .limit = std::move(worst_limit)});
    aim({.work = test + ", exact touch",
         .kind = Target::touch,
         .test = test,
         .theirs = "ordinary",
         .at_most = 10,
         .limit = std::move(touch_limit)});
  }

  const Effort effort;
  const unsigned long long seed;
  Report found;
  std::function<void(const std::string&)> progress = [](const std::string&) {};  ///< told what comes next
};

}  // namespace isect::bench
