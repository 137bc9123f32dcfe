// What each arithmetic of core/isect/numbers costs: the time of orient3d's polynomial in it, beside plain doubles.
//
//   ninja -C build/release number_costs && build/release/bench/number_costs
//
// The same 4,096 cases for all, points of [-1, 1]^3, and whole numbers for the grid. Best of nine passes. The table of
// core/isect/numbers/README.md is of this program.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include <isect/orient.h>

#include "bench/random.h"

namespace isect::bench {
namespace {

struct Four {
  std::array<Point<double, 3>, 4> p;
};

/// Plain doubles, as people write it.
double naive(const Four& c) {
  const auto& [a, b, d, o] = c.p;
  const double ax = a[0] - o[0], ay = a[1] - o[1], az = a[2] - o[2], bx = b[0] - o[0], by = b[1] - o[1],
               bz = b[2] - o[2], dx = d[0] - o[0], dy = d[1] - o[1], dz = d[2] - o[2];
  return ax * (by * dz - bz * dy) + ay * (bz * dx - bx * dz) + az * (bx * dy - by * dx);
}
/// A number that all of x goes into.
template <class W>
double told(const W& x) {
  if constexpr (requires { x.certain(); })
    return x.apparent_sign() + x.error();
  else if constexpr (requires { x.step(); })
    return x.step();
  else if constexpr (requires { x.rest; })
    return x.hi + (x.lo + x.rest);
  else if constexpr (requires { x.hi; })
    return x.hi + x.lo;
  else if constexpr (std::is_same_v<W, Exact>)
    return x.sign();
  else
    return x.sign().value_or(2);
}

/// Nanoseconds a case; `sum` keeps the compiler from leaving it out.
template <class Call>
double time_of(const std::vector<Four>& cases, int repeats, double& sum, const Call& call) {
  double best = 1e300;
  for (int pass = 0; pass < 9; ++pass) {
    const auto from = std::chrono::steady_clock::now();
    for (int i = 0; i < repeats; ++i)
      for (const Four& c : cases) sum += call(c);
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - from;
    best = std::min(best, took.count() / (static_cast<double>(cases.size()) * repeats));
  }
  return best;
}

template <class W>
[[gnu::noinline]] double in(const Four& c) {
  return told(orient::detail::volume6<W>(c.p[0], c.p[1], c.p[2], c.p[3]));
}

void measure() {
  Random random(1);
  std::vector<Four> cases(4096), whole(4096);
  for (std::size_t i = 0; i < cases.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k)
      for (int j = 0; j < 3; ++j) {
        cases[i].p[k][j] = random.uniform(-1, 1);
        whole[i].p[k][j] = random.integer(-8, 8);
      }
  double sum = 0;
  const double plain = time_of(cases, 200, sum, [](const Four& c) { return naive(c); });
  std::printf("%-22s %8.2f ns\n", "double", plain);
  const auto row = [&](const char* name, const std::vector<Four>& of, int repeats, const auto& call) {
    const double ns = time_of(of, repeats, sum, call);
    std::printf("%-22s %8.2f ns  %7.1f\n", name, ns, ns / plain);
  };
  row("Bounded<double>", cases, 100, in<Bounded<double>>);
  row("Grid", whole, 100, in<Grid>);
  row("Compensated, fused", cases, 50, [](const Four& c) {
    return compensated([&]<class W>() { return told(orient::detail::volume6<W>(c.p[0], c.p[1], c.p[2], c.p[3])); });
  });
  row("Compensated", cases, 50, in<Compensated>);
  row("TripleDouble", cases, 20, in<finer_than_t<Compensated>>);
  row("Bounded<DoubleDouble>", cases, 20, in<Bounded<DoubleDouble>>);
  row("ShortExact, integers", whole, 20, in<ShortExact>);
  row("MediumExact", cases, 10, in<MediumExact>);
  row("Exact", cases, 2, in<Exact>);
  row("sign_of", cases, 100, [](const Four& c) { return orient3d(c.p[0], c.p[1], c.p[2], c.p[3]); });
  row("sign_of, integers", whole, 50, [](const Four& c) { return orient3d(c.p[0], c.p[1], c.p[2], c.p[3]); });
  row("sign_of<long_text>", cases, 100, [](const Four& c) {
    return sign_of<long_text>(
        [&]<class W>() -> W { return orient::detail::volume6<W>(c.p[0], c.p[1], c.p[2], c.p[3]); });
  });
  if (sum == 42) std::puts("");
}

}  // namespace
}  // namespace isect::bench

int main() { isect::bench::measure(); }
