#pragma once
// Rings whose area and normal are hard to get, and the true ones, in rationals.

#include <array>

#include "bench/random_shapes.h"
#include "bench/rational.h"

namespace isect::tests::area_rings {

using bench::Numbers;
using oracle::Rational;

/// The square root of x >= 0 within a relative 2^-127.
inline Rational root(const Rational& x) {
  using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
  const Integer a = numerator(x), b = denominator(x), scale = Integer(1) << 128;
  return Rational(Integer(sqrt(Integer(a * b * scale * scale)))) / Rational(Integer(b * scale));
}

/// Twice the area vector, from the coordinates themselves.
template <class S>
std::array<Rational, 3> truth(const Ring<S, 3>& r) {
  std::array<Rational, 3> sum = {0, 0, 0};
  for (std::size_t i = 0; i < r.size(); ++i) {
    const auto a = oracle::rational(r[i]), b = oracle::rational(r[(i + 1) % r.size()]);
    const auto term = oracle::cross(a, b);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += term[k];
  }
  return sum;
}
template <class S>
Rational truth(const Ring<S, 2>& r) {
  Rational sum = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const auto a = oracle::rational(r[i]), b = oracle::rational(r[(i + 1) % r.size()]);
    sum += (a[0] - b[0]) * (a[1] + b[1]);
  }
  return sum / 2;
}

/// A ring of any shape, nearly plane, on a line up to rounding, a needle, or there and back.
template <class S, int N>
Ring<S, N> random_ring(bench::Random& random, Numbers numbers) {
  const Point<S, N> o = bench::vector<S, N>(random, numbers), a = bench::vector<S, N>(random, numbers),
                    b = bench::vector<S, N>(random, numbers);
  const int kind = random.below(7);
  Ring<S, N> r;
  for (int n = 2 + random.below(7); n > 0; --n) {
    const S s = static_cast<S>(random.integer(0, 8)) / 16, t = static_cast<S>(random.integer(0, 8)) / 16;
    Point<S, N> p = bench::vector<S, N>(random, numbers);
    if (numbers == Numbers::ends) {  // whose sums may overflow
      r.push_back(!r.empty() && random.one_in(3) ? random.one_in(2) ? r.front() : r.back() : p);
      continue;
    }
    if (kind == 1) p = o * (S(1) - s - t) + a * s + b * t;
    if (kind == 2) p = o * (S(1) - s) + a * s;
    if (kind == 3) p[0] = o[0];
    if (kind == 5) p = o * (S(1) - s) + a * s + b * static_cast<S>(random.magnitude(-8, -2));
    r.push_back(p);
  }
  if (kind == 4)
    for (std::size_t i = r.size(); i-- > 0;) r.push_back(r[i]);
  return r;
}

}  // namespace isect::tests::area_rings
