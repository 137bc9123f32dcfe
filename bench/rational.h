#pragma once
// Rational numbers for oracles: GMP's, which share nothing with isect/numbers/exact.h.
//
// An oracle states a test's meaning in the plainest way, with divisions, projections of all corners, or brute force
// over candidates: whatever differs from the core's text.

#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>

#include <isect/shapes.h>
#include "bench/oracle.h"

namespace isect::oracle {

using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

template <int N>
using Coordinates = std::array<Rational, N>;

/// x itself; x must be finite.
template <class S, int N>
Coordinates<N> rational(const Vector<S, N>& x) {
  Coordinates<N> v;
  for (int i = 0; i < N; ++i) v[i] = Rational(x[i]);
  return v;
}

template <std::size_t N>
std::array<Rational, N> operator-(const std::array<Rational, N>& x, const std::array<Rational, N>& y) {
  std::array<Rational, N> v;
  for (std::size_t i = 0; i < N; ++i) v[i] = x[i] - y[i];
  return v;
}
template <std::size_t N>
std::array<Rational, N> operator+(const std::array<Rational, N>& x, const std::array<Rational, N>& y) {
  std::array<Rational, N> v;
  for (std::size_t i = 0; i < N; ++i) v[i] = x[i] + y[i];
  return v;
}
template <std::size_t N>
std::array<Rational, N> operator*(const Rational& k, const std::array<Rational, N>& x) {
  std::array<Rational, N> v;
  for (std::size_t i = 0; i < N; ++i) v[i] = k * x[i];
  return v;
}
template <std::size_t N>
Rational dot(const std::array<Rational, N>& x, const std::array<Rational, N>& y) {
  Rational sum = 0;
  for (std::size_t i = 0; i < N; ++i) sum += x[i] * y[i];
  return sum;
}
inline std::array<Rational, 3> cross(const std::array<Rational, 3>& x, const std::array<Rational, 3>& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

inline int sign(const Rational& x) { return x.sign(); }

/// x as a double and what that leaves; infinite beyond the largest double.
inline Real real(const Rational& x) {
  const double nearest = static_cast<double>(x);
  if (std::isinf(nearest)) return {nearest, 0};
  return {nearest, static_cast<double>(Rational(x - Rational(nearest)))};
}

/// Whether a range, whose ends may be infinite, holds t.
template <class S>
bool holds(const Interval<S>& range, const Rational& t) {
  if (!(range.lo <= range.hi) || range.lo == infinite<S>.hi || range.hi == infinite<S>.lo) return false;
  return (std::isinf(range.lo) || Rational(range.lo) <= t) && (std::isinf(range.hi) || t <= Rational(range.hi));
}

/// How far x lies from the true value, in units in the last place of S at the truth; the subnormal unit at least. An
/// infinite x is right where the truth is beyond the largest S.
template <class S>
double ulps(S x, const Rational& truth) {
  using Limits = std::numeric_limits<S>;
  const S nearest = static_cast<S>(static_cast<double>(truth));  // as good as its neighbours for finding the unit
  if (std::isinf(x)) return abs(truth) >= Rational(Limits::max()) && (x > 0) == (truth > 0) ? 0 : Limits::infinity();
  if (std::isnan(x)) return Limits::infinity();
  const S size = std::isinf(nearest) ? Limits::max() : std::abs(nearest);
  const S unit = std::max(std::ldexp(Limits::epsilon(), size > 0 ? std::ilogb(size) : Limits::min_exponent - 1),
                          Limits::denorm_min());
  return static_cast<double>(Rational(abs(Rational(x) - truth) / Rational(unit)));
}

}  // namespace isect::oracle
