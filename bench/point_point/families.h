#pragma once
// Pairs of points, and tolerances, that are hard to tell apart.

#include <array>

#include "bench/full_precision.h"
#include "bench/named_draw.h"
#include "bench/random_shapes.h"

namespace isect::bench {

template <class S, int N>
struct Points {
  Point<S, N> p, q;
  S tolerance = 0;
};
template <class S, int N>
std::string full_precision(const Points<S, N>& c) {
  return text("p", c.p, "q", c.q, "tolerance", c.tolerance);
}

namespace point_point_families {

/// Pairs of points that are equal every other time.
template <class S>
Points<S, 3> ordinary(Random& random) {
  Points<S, 3> c = {random.in_box<3>(1).cast<S>(), random.in_box<3>(1).cast<S>()};
  if (random.one_in(2)) c.q = c.p;
  c.tolerance = static_cast<S>(random.uniform(0, 2));
  return c;
}

/// Multiples of 0.1, one summed up from tenths.
template <class S>
Points<S, 3> decimal(Random& random) {
  Points<S, 3> c;
  const S tenth = static_cast<S>(0.1);
  for (int i = 0; i < 3; ++i) {
    const int n = random.integer(0, 20);
    c.p[i] = static_cast<S>(n / 10.0), c.q[i] = 0;
    for (int k = 0; k < n; ++k) c.q[i] += tenth;
  }
  c.tolerance = std::numeric_limits<S>::epsilon();
  return c;
}

template <class S>
Points<S, 3> ulp_apart(Random& random) {
  Points<S, 3> c = ordinary<S>(random);
  c.q = c.p, c.p *= static_cast<S>(random.magnitude(-5, 5));
  c.q = c.p;
  S& x = c.q[random.below(3)];
  x = moved(x, random.integer(-1, 1));
  return c;
}

/// A tolerance of just about the distance.
template <class S>
Points<S, 3> near_tolerance(Random& random) {
  Points<S, 3> c = {random.in_box<3>(1).cast<S>(), random.in_box<3>(1).cast<S>()};
  if (random.one_in(2)) c.q[0] = c.p[0], c.q[1] = c.p[1];
  c.tolerance = moved(static_cast<S>((c.p - c.q).template cast<double>().norm()), random.integer(-2, 2));
  return c;
}

/// Pairs in which squares overflow or vanish.
template <class S>
Points<S, 3> scale(Random& random) {
  Points<S, 3> c = ordinary<S>(random);
  bench::scale(beyond_squares<S>(random), c.p, c.q, c.tolerance);
  return c;
}

/// NaN or an infinity in both, a tolerance below 0 or NaN.
template <class S>
Points<S, 3> invalid(Random& random) {
  using Limits = std::numeric_limits<S>;
  Points<S, 3> c = ordinary<S>(random);
  const S bad = random.one_in(2) ? Limits::quiet_NaN() : Limits::infinity();
  if (random.one_in(4))
    c.tolerance = random.one_in(2) ? -c.tolerance : bad;
  else
    c.p[random.below(3)] = bad;
  if (random.one_in(2)) c.q = c.p;
  return c;
}

}  // namespace point_point_families

template <class S>
constexpr std::array<NamedDraw<Points<S, 3>>, 6> point_point_draws = {{
    {"ordinary", point_point_families::ordinary<S>},
    {"decimal", point_point_families::decimal<S>, "tenths, one side summed up from .1: nearly the same points."},
    {"ulp-apart", point_point_families::ulp_apart<S>, "points that differ by an ulp in one coordinate, or not at all."},
    {"near-tolerance", point_point_families::near_tolerance<S>, "a tolerance within 2 ulp of the distance."},
    {"scale", point_point_families::scale<S>, "sizes at which squares overflow or vanish."},
    {"invalid", point_point_families::invalid<S>, "a NaN or an infinity in one point or in both."},
}};

}  // namespace isect::bench
