#pragma once
// Time against size: the least of a few passes at each size, gathered into the growths of a session.

#include <time.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "bench/session.h"

namespace isect::bench {

/// Powers of ten from `least` to `most`, but to 10^4 only in a quick run.
inline std::vector<int> sizes(const Session& session, int least, int most = 1'000'000) {
  std::vector<int> all;
  for (int n = least; n <= std::min(most, session.effort.all_sizes ? 1'000'000 : 10'000); n *= 10) all.push_back(n);
  return all;
}

/// The processor time of this thread in ns, so that other work on the machine does not count. All that is measured this
/// way runs in one thread.
inline double processor_time() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
}

template <class Result>
struct Timed {
  Result result;
  double ns;
};
/// Returns the result of run() and the ns of its fastest pass. Passes go on for half a second, at least three, unless
/// they take 20 seconds; in a quick run, for the session's effort.
template <class Run>
auto timed(const Session& session, const Run& run) -> Timed<decltype(run())> {
  double least = std::numeric_limits<double>::infinity(), spent = 0;
  const double budget = session.effort.all_sizes ? 0.5e9 : 1e9 * session.effort.seconds;
  const int passes = session.effort.all_sizes ? 3 : 1;
  for (int pass = 1;; ++pass) {
    const double start = processor_time();
    auto result = run();
    asm volatile("" : : "r"(&result) : "memory");
    const double passed = processor_time() - start;
    least = std::min(least, passed), spent += passed;
    const bool enough = (pass >= passes && spent >= budget) || pass >= session.effort.most_passes || spent >= 20e9;
    if (enough) return {std::move(result), least};
  }
}
template <class Run>
double least_time(const Session& session, const Run& run) {
  return timed(session, run).ns;
}

/// Nanoseconds per case, in the fastest pass over all of them; answer(case) returns a number to add up. Give fewer
/// cases if one takes long.
template <class Case, class Answer>
double least_each(const Session& session, const std::vector<Case>& cases, const Answer& answer) {
  const auto pass = [&] {
    long sum = 0;
    for (const Case& c : cases) sum += static_cast<long>(answer(c));
    return sum;
  };
  return least_time(session, pass) / static_cast<double>(cases.size());
}

/// One curve, point by point.
class Grown {
 public:
  Grown(std::string test, std::string method, std::string unit, std::string library = "isect") {
    curve_.test = std::move(test), curve_.method = std::move(method);
    curve_.library = std::move(library), curve_.unit = std::move(unit);
  }
  void add(double n, double ns) { curve_.n.push_back(n), curve_.ns.push_back(ns); }
  /// Adds the curve to the session, with its exponent, if it has two points or more.
  void report(Session& session) {
    if (curve_.n.size() < 2) return;
    curve_.exponent = fitted_exponent(curve_.n, curve_.ns);
    session.found.growths.push_back(curve_);
  }

 private:
  Growth curve_;
};

/// One method at all sizes from a thousand on: make(n) makes what run(it) is timed on.
template <class Make, class Run>
void grow(Session& session, const char* test, const char* method, const char* unit, const Make& make, const Run& run,
          const char* library = "isect") {
  session.progress(std::string(test) + ", " + (library == std::string("isect") ? method : library));
  Grown grown(test, method, unit, library);
  for (const int n : sizes(session, 1000)) {
    const auto made = make(n);
    grown.add(n, least_time(session, [&] { return run(made); }));
  }
  grown.report(session);
}

}  // namespace isect::bench
