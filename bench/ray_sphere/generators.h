#pragma once
// What the ray-sphere families are made of: shapes at a distance, exact shapes of integers, moved by ulps and
// scaled.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bench/ray_sphere/families.h"

namespace isect::bench::generators {

template <class S, int N>
using Case = RaySphereCase<S, N>;
template <int N>
using Wide = RaySphereCase<double, N>;

/// Sizes that S can hold with room for a factor of a million: 10^-reach to 10^reach.
template <class S>
inline constexpr double reach = std::numeric_limits<S>::max_exponent10 - 8;
/// Whether S holds integers of 53 bits, and not of 24 only.
template <class S>
inline constexpr bool wide = std::numeric_limits<S>::digits == 53;

template <class S, int N>
Case<S, N> narrowed(const Wide<N>& c) {
  return {{c.ray.origin.template cast<S>(),
           c.ray.direction.template cast<S>(),
           {static_cast<S>(c.ray.range.lo), static_cast<S>(c.ray.range.hi)}},
          {c.sphere.center.template cast<S>(), static_cast<S>(c.sphere.radius)}};
}

/// x moved by up to `most` representable numbers, either way.
template <class S>
S nudged(Random& random, S x, int most) {
  const S towards = static_cast<S>(random.sign()) * std::numeric_limits<S>::infinity();
  for (int i = random.integer(0, most); i > 0; --i) x = std::nextafter(x, towards);
  return x;
}

/// One number of the case moved by a few ulp.
template <class S, int N>
Case<S, N> nudged(Random& random, Case<S, N> c, int most = 4) {
  const int i = random.below(N);
  switch (random.below(4)) {
    case 0:
      c.ray.origin[i] = nudged(random, c.ray.origin[i], most);
      break;
    case 1:
      c.ray.direction[i] = nudged(random, c.ray.direction[i], most);
      break;
    case 2:
      c.sphere.center[i] = nudged(random, c.sphere.center[i], most);
      break;
    default:
      c.sphere.radius = std::abs(nudged(random, c.sphere.radius, most));
  }
  return c;
}

/// Lengths times 2^across, the direction times 2^along, t to suit.
template <class S, int N>
Case<S, N> scaled(Case<S, N> c, int across, int along) {
  const auto by = [](S x, int e) { return std::ldexp(x, e); };
  for (int i = 0; i < N; ++i) {
    c.ray.origin[i] = by(c.ray.origin[i], across);
    c.ray.direction[i] = by(c.ray.direction[i], along);
    c.sphere.center[i] = by(c.sphere.center[i], across);
  }
  c.sphere.radius = by(c.sphere.radius, across);
  c.ray.range = {by(c.ray.range.lo, across - along), by(c.ray.range.hi, across - along)};
  return c;
}

/// The case scaled by random powers of two up to 2^most.
template <class S, int N>
Case<S, N> scaled(Random& random, const Case<S, N>& c, int most) {
  const int across = random.integer(-most, most);
  return scaled(c, across, random.integer(-most, most));
}

/// From how far a ray sets out, and at how many radii it passes the center.
struct Aim {
  double radius, distance, offset;
};

template <int N>
Wide<N> aimed(Random& random, const Aim& aim) {
  const auto [radius, distance, offset] = aim;
  const Point<double, N> center = random.in_box<N>(2 * radius);
  const Vector<double, N> from = random.heading<N>();
  Vector<double, N> aside = random.heading<N>();
  aside = (aside - aside.dot(from) * from).normalized();
  const Point<double, N> origin = center + distance * from;
  const Vector<double, N> direction = ((center + offset * radius * aside) - origin).normalized();
  return {{origin, direction}, {center, radius}};
}

// Integers, for families that must be exact. A Pythagorean tuple n, |n| whole, gives a surface point c + k n.

template <int N>
using Whole = Eigen::Matrix<long long, N, 1>;

template <int N>
struct Tangent {
  Whole<N> center, point, along;  ///< a surface point, and a direction orthogonal to its radius
  long long radius;
};

template <int N>
Whole<N> small(Random& random, int most) {
  Whole<N> v;
  do {
    for (int i = 0; i < N; ++i) v[i] = random.integer(-most, most);
  } while ((v.array() == 0).all());
  return v;
}

/// Integers n with |n| = length; their order and signs are random.
template <int N>
std::pair<Whole<N>, long long> pythagorean(Random& random, int most) {
  const auto draw = [&] { return static_cast<long long>(random.integer(0, most)); };
  const long long p = draw(), q = draw(), s = N == 2 ? 0 : draw(), t = N == 2 ? 0 : draw();
  Whole<N> n;
  if constexpr (N == 2)
    n = {p * p - q * q, 2 * p * q};
  else
    n = {p * p + q * q - s * s - t * t, 2 * (p * t + q * s), 2 * (q * t - p * s)};
  for (int i = 0; i < N; ++i) {
    std::swap(n[i], n[random.below(N)]);
    if (random.one_in(2)) n[i] = -n[i];
  }
  const long long length = p * p + q * q + s * s + t * t;
  if (length == 0) return pythagorean<N>(random, most);
  return {n, length};
}

/// Small enough that S holds every integer of a case that sets out from point - 60 along.
template <class S, int N>
Tangent<N> tangent(Random& random) {
  const auto [n, length] = pythagorean<N>(random, wide<S> ? 1000 : 15);
  Whole<N> along;
  if constexpr (N == 2) {
    along = {-n[1], n[0]};
  } else {
    do {
      along = n.cross(small<3>(random, 8));
    } while ((along.array() == 0).all());
  }
  const long long k = random.integer(1, wide<S> ? 100 : 8);
  const Whole<N> center = small<N>(random, wide<S> ? 1 << 30 : 1 << 20);
  return {center, center + k * n, along, k * length};
}

/// Numbers of S from exact integers.
template <class S, int N>
Case<S, N> exactly(const Whole<N>& origin, const Whole<N>& direction, const Whole<N>& center, long long radius) {
  return {{origin.template cast<S>(), direction.template cast<S>()},
          {center.template cast<S>(), static_cast<S>(radius)}};
}

}  // namespace isect::bench::generators
