#pragma once
// Timing for the speed programs: passes over many distinct cases, so that neither branch prediction nor the cache knows
// the answers, and the least time of the passes.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace isect::bench {

struct Timing {
  double least, median;  ///< ns a case
  long hits;             ///< of one pass
};

/// Times `passes` passes of count(case) -> a number to add up; the sum keeps the compiler from dropping the work. The
/// least time is that of each thousand cases, added up: on a machine that others share hardly a pass runs through.
template <class Case, class Count>
Timing timed(const std::vector<Case>& cases, int passes, const Count& count) {
  constexpr std::size_t length = 1024;
  const double all = static_cast<double>(cases.size());
  std::vector<double> times, least((cases.size() + length - 1) / length, std::numeric_limits<double>::infinity());
  long hits = 0;
  for (int pass = 0; pass < passes; ++pass) {
    hits = 0;
    times.push_back(0);
    for (std::size_t run = 0; run < least.size(); ++run) {
      const std::size_t first = run * length, last = std::min(first + length, cases.size());
      const auto start = std::chrono::steady_clock::now();
      for (std::size_t i = first; i < last; ++i) hits += static_cast<long>(count(cases[i]));
      const std::chrono::duration<double, std::nano> passed = std::chrono::steady_clock::now() - start;
      asm volatile("" : : "g"(hits));
      times.back() += passed.count() / all;
      least[run] = std::min(least[run], passed.count() / all);
    }
  }
  std::sort(times.begin(), times.end());
  return {std::accumulate(least.begin(), least.end(), 0.), times[times.size() / 2], hits};
}

inline std::string cpu() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

/// Methods of one question, each beside the first.
class Table {
 public:
  explicit Table(std::string question) : question_(std::move(question)) {}

  void row(const char* method, const Timing& t) {
    if (first_ == 0) first_ = t.least;
    std::printf("%-34s %-26s %10.2f %10.2f %8.2f %9ld\n", question_.c_str(), method, t.least, t.median,
                t.least / first_, t.hits);
    std::fflush(stdout);
  }
  static void head(const char* flags, const char* cases) {
    std::printf("compiler %s\nflags    %s\ncpu      %s\ncases    %s\n\n", __VERSION__, flags, cpu().c_str(), cases);
    std::printf("%-34s %-26s %10s %10s %8s %9s\n", "question", "method", "ns least", "median", "/first", "hits");
  }

 private:
  std::string question_;
  double first_ = 0;
};

}  // namespace isect::bench
