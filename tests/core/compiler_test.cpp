// What isect::core asks of the compiler: arithmetic as it is written. The options come with the target.

#include "tests/catch.h"

namespace compiler_test {

#if defined(__GNUC__) && !defined(__clang__)
#define OPTIMIZED [[gnu::noinline, gnu::optimize("O3")]]
#else
#define OPTIMIZED [[gnu::noinline]]
#endif

/// Two numbers side by side, as in a vector that is cast to float and back.
OPTIMIZED void through_floats(const double* x, double* rounded) {
  const float first = static_cast<float>(x[0]), second = static_cast<float>(x[1]);
  rounded[0] = first, rounded[1] = second;
}

TEST_CASE("a double that becomes a float and a double again is rounded", "[compiler]") {
  const double tenths[2] = {.1, .2};
  double rounded[2];
  through_floats(tenths, rounded);
  CHECK(rounded[0] == .1F);  // GCC 12 with -ftree-slp-vectorize: .1
  CHECK(rounded[1] == .2F);
}

#if defined(__x86_64__)
[[gnu::noinline, gnu::target("fma")]] double product_and_sum(double a, double b, double c) { return a * b + c; }

TEST_CASE("a product is rounded before it is added", "[compiler]") {
  if (!__builtin_cpu_supports("fma")) return;
  const double a = 1 + 0x1p-30;
  CHECK(product_and_sum(a, a, -1 - 0x1p-29) == 0);  // -ffp-contract=fast: 2^-60
}
#endif

}  // namespace compiler_test
