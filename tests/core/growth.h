#pragma once
// How work grows with the size of the input. It is counted, not timed, so that nothing else that runs matters: the
// program of these tests is compiled with -fsanitize-coverage=trace-pc, by which every basic block calls the function
// below.

#include <cmath>
#include <cstdint>

namespace isect::tests {

inline std::uint64_t blocks_run = 0;

}  // namespace isect::tests

#ifdef __clang__
#define ISECT_NOT_COUNTED no_sanitize("coverage")
#else
#define ISECT_NOT_COUNTED no_sanitize_coverage
#endif
extern "C" inline __attribute__((used, ISECT_NOT_COUNTED)) void __sanitizer_cov_trace_pc() {
  ++isect::tests::blocks_run;
}

namespace isect::tests {

/// How many basic blocks a run goes through.
template <class Run>
std::uint64_t work(const Run& run) {
  const std::uint64_t before = blocks_run;
  run();
  return blocks_run - before;
}

/// k, where the work of run(make(n)) grows like n^k from n to 8 n. An n lg n comes out as 1.1 or a little more; an n^2
/// as 2.
template <class Make, class Run>
double growth(int n, const Make& make, const Run& run) {
  const auto of_size = [&](int size) {
    const auto input = make(size);
    return static_cast<double>(work([&] { run(input); }));
  };
  const double first = of_size(n);
  return std::log2(of_size(8 * n) / first) / 3;
}

}  // namespace isect::tests
