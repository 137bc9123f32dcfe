#pragma once
// Timing for the speed programs: passes over many distinct cases, so that neither branch prediction nor the cache knows
// the answers, and the least time of the passes.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace isect::bench {

struct Timing {
  double least, median;  ///< ns a case
  long hits;             ///< of one pass
};

/// Times `passes` passes of count(case) -> a number to add up; the sum keeps the compiler from dropping the work.
template <class Case, class Count>
Timing timed(const std::vector<Case>& cases, int passes, const Count& count) {
  std::vector<double> times;
  long hits = 0;
  for (int pass = 0; pass < passes; ++pass) {
    hits = 0;
    const auto start = std::chrono::steady_clock::now();
    for (const Case& c : cases) hits += static_cast<long>(count(c));
    const std::chrono::duration<double, std::nano> passed = std::chrono::steady_clock::now() - start;
    asm volatile("" : : "g"(hits));
    times.push_back(passed.count() / static_cast<double>(cases.size()));
  }
  std::sort(times.begin(), times.end());
  return {times.front(), times[times.size() / 2], hits};
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
    std::printf("compiler %s\nflags    %s\ncpu      %s\ncases    %s\n\n", __VERSION__, flags, cpu().c_str(),
                cases);
    std::printf("%-34s %-26s %10s %10s %8s %9s\n", "question", "method", "ns least", "median", "/first",
                "hits");
  }

 private:
  std::string question_;
  double first_ = 0;
};

}  // namespace isect::bench
