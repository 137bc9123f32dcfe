#pragma once
// Random coordinates in the families that break naive tests, for any shape made of numbers.

#include <cmath>
#include <limits>

#include "bench/random.h"

namespace isect::bench {

/// Where the numbers of a shape come from.
enum class Numbers {
  ordinary,  ///< uniform in [-1, 1]
  grid,      ///< integers of [-4, 4]: shapes touch, coincide and align
  nudged,    ///< the same, up to two ulps off: they nearly do
  decimal,   ///< multiples of 0.1: what users type, and rounding spoils
  distant,   ///< grid points 1e8 away
  wide,      ///< sizes from 1e-300 to 1e300, mixed
  tiny,      ///< grid times 2^-996
  huge,      ///< grid times 2^993
  ends       ///< the least and the largest numbers, 0 and 1: so few that they are often equal
};
inline constexpr Numbers all_numbers[] = {Numbers::ordinary, Numbers::grid, Numbers::nudged, Numbers::decimal,
                                          Numbers::distant,  Numbers::wide, Numbers::tiny,   Numbers::huge};
/// All families and the ends of the range: sums and differences of two such numbers may not be numbers of S.
inline constexpr Numbers all_numbers_and_ends[] = {Numbers::ordinary, Numbers::grid,    Numbers::nudged,
                                                   Numbers::decimal,  Numbers::distant, Numbers::wide,
                                                   Numbers::tiny,     Numbers::huge,    Numbers::ends};

/// x moved by `steps` representable numbers of S.
template <class S>
S moved(S x, int steps) {
  const S end = steps < 0 ? -std::numeric_limits<S>::infinity() : std::numeric_limits<S>::infinity();
  for (int i = 0; i < std::abs(steps); ++i) x = std::nextafter(x, end);
  return x;
}

/// One number of S; the families of extreme sizes shrink to fit a float.
template <class S>
S number(Random& random, Numbers numbers) {
  constexpr bool is_float = std::is_same_v<S, float>;
  const double grid = random.integer(-4, 4);
  switch (numbers) {
    case Numbers::ordinary:
      return static_cast<S>(random.uniform(-1, 1));
    case Numbers::grid:
      return static_cast<S>(grid);
    case Numbers::nudged:
      return moved(static_cast<S>(grid), random.integer(-2, 2));
    case Numbers::decimal:
      return static_cast<S>(random.integer(-20, 20) * 0.1);
    case Numbers::distant:
      return static_cast<S>(1e8 + grid);
    case Numbers::wide:
      return static_cast<S>(random.magnitude(is_float ? -37 : -300, is_float ? 37 : 300));
    case Numbers::tiny:
      return static_cast<S>(std::ldexp(grid, is_float ? -120 : -996));
    case Numbers::ends: {
      using Limits = std::numeric_limits<S>;
      const S sizes[] = {0, 1, Limits::max(), Limits::max() / 2, Limits::min(), Limits::denorm_min()};
      return sizes[random.below(6)] * static_cast<S>(random.sign());
    }
    default:
      return static_cast<S>(std::ldexp(grid, is_float ? 124 : 993));
  }
}

/// An exponent of two at which the squares of lengths around one overflow or vanish, and the lengths don't.
template <class S>
int beyond_squares(Random& random) {
  constexpr int most = std::numeric_limits<S>::max_exponent;
  const int size = random.integer(most / 2 + 2, most - 6);
  return random.one_in(2) ? size : -size;
}

/// Multiplies numbers and vectors by 2^exponent.
template <class... Lengths>
void scale(int exponent, Lengths&... lengths) {
  const auto one = [exponent](auto& x) {
    if constexpr (requires { x.size(); })
      for (auto& coordinate : x) coordinate = std::ldexp(coordinate, exponent);
    else
      x = std::ldexp(x, exponent);
  };
  (one(lengths), ...);
}

template <class S, int N>
Vector<S, N> vector(Random& random, Numbers numbers) {
  Vector<S, N> v;
  for (int i = 0; i < N; ++i) v[i] = number<S>(random, numbers);
  return v;
}

}  // namespace isect::bench
