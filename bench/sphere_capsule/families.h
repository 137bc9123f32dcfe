#pragma once
// Balls and capsules that are hard to tell apart.

#include <algorithm>
#include <array>

#include <isect/methods/sphere_capsule.h>
#include "bench/named_draw.h"
#include "bench/ordinary_shapes.h"
#include "bench/ray_sphere/generators.h"
#include "bench/simple_shapes.h"

namespace isect::bench {

template <class S, int N>
using BallAndCapsule = Pair<Sphere<S, N>, Capsule<S, N>>;

/// Divides points by a power of two that leaves no coordinate above 1, so that no square overflows or vanishes that
/// matters. Returns its exponent.
template <class... Points>
int normalise(Points&... points) {
  const double largest = std::max({points.cwiseAbs().maxCoeff()...});
  const int exponent = largest > 0 ? std::ilogb(largest) + 1 : 0;
  scale(-exponent, points...);
  return exponent;
}

/// The distance of a point from the segment, rounded.
template <int N>
double distance(Point<double, N> c, Capsule<double, N> segment) {
  const int exponent = normalise(c, segment.p, segment.q);
  Record<sphere_capsule::MethodEvent<double, N>> record;
  sphere_capsule::clamped<double, N>({c, 0}, segment, record);
  return std::ldexp((c - std::get<sphere_capsule::Foot<double, N>>(record.events.front()).at).norm(), exponent);
}

/// A radius that makes the ball touch the capsule, up to rounding, or fit into it, or contain it.
template <class S, int N>
S critical_radius(Random& random, const Point<S, N>& center, const Capsule<S, N>& capsule, Way way = Way::any) {
  const Point<double, N> c = center.template cast<double>();
  const Capsule<double, N> wide = cast<double>(capsule);
  const double d = distance<N>(c, wide), s = wide.radius;
  const double farthest = std::max((wide.p - c).stableNorm(), (wide.q - c).stableNorm());
  const std::array<double, 3> radii = {d - s, s + farthest, s - d};  // in the order of Way
  const double r = radii[way == Way::any ? random.below(3) : static_cast<int>(way)];
  return moved(static_cast<S>(r), random.integer(-2, 2));
}

namespace sphere_capsule_families {

template <class S>
BallAndCapsule<S, 3> ordinary(Random& random) {
  const Sphere<S, 3> ball = ordinary_sphere<S>(random);
  return {ball, ordinary_capsule<S>(random)};
}

/// A ball that touches the capsule from outside, beside its segment or beyond an end.
template <class S, bool side>
BallAndCapsule<S, 3> near_touch(Random& random) {
  BallAndCapsule<S, 3> c = {{}, ordinary_capsule<S>(random)};
  const Vector<double, 3> p = c.b.p.template cast<double>(), u = c.b.q.template cast<double>() - p;
  Vector<double, 3> away = random.heading<3>();
  if (side)
    away = (away - away.dot(u) / u.squaredNorm() * u).normalized();
  else if (away.dot(u) < 0)
    away = -away;
  const double t = side ? random.uniform(0.05, 0.95) : 1;
  c.a.center = (p + t * u + (c.b.radius + random.uniform(0.05, 1)) * away).template cast<S>();
  if (random.one_in(2)) std::swap(c.b.p, c.b.q);
  c.a.radius = critical_radius(random, c.a.center, c.b, Way::touch);
  return c;
}

/// A touch beside a segment 1e3 to 1e9 (1e4 in float) times as long as in near_touch: to it the ball is a speck.
template <class S>
BallAndCapsule<S, 3> far_end(Random& random) {
  BallAndCapsule<S, 3> c = near_touch<S, true>(random);
  const double length = std::abs(random.magnitude(3, generators::wide<S> ? 9 : 4));
  const Vector<double, 3> p = c.b.p.template cast<double>(), u = c.b.q.template cast<double>() - p;
  c.b.q = (p + length * u).template cast<S>();
  c.a.radius = critical_radius(random, c.a.center, c.b, Way::touch);
  return c;
}

/// Integers: the center at a whole distance from a point of the segment, at a right angle to it.
template <class S>
BallAndCapsule<S, 3> exact_touch(Random& random) {
  const generators::Tangent<3> t = generators::tangent<S, 3>(random);
  const long long s = random.integer(0, static_cast<int>(std::min(t.radius, 1LL << 20)));
  const generators::Whole<3> p = t.point - random.integer(0, 8) * t.along, q = t.point + random.integer(0, 8) * t.along;
  BallAndCapsule<S, 3> c = {{t.center.cast<S>(), static_cast<S>(t.radius - s)},
                            {p.cast<S>(), q.cast<S>(), static_cast<S>(s)}};
  bench::scale(random.integer(-20, 20), c.a.center, c.a.radius, c.b.p, c.b.q, c.b.radius);
  return c;
}

/// Pairs in which squares overflow or vanish.
template <class S>
BallAndCapsule<S, 3> scale(Random& random) {
  BallAndCapsule<S, 3> c = ordinary<S>(random);
  bench::scale(beyond_squares<S>(random), c.a.center, c.a.radius, c.b.p, c.b.q, c.b.radius);
  return c;
}

/// A number that is NaN or infinite, or a radius below 0.
template <class S>
void spoil(Random& random, Capsule<S, 3>& capsule) {
  using Limits = std::numeric_limits<S>;
  const S bad = random.one_in(2) ? Limits::quiet_NaN() : Limits::infinity();
  switch (random.below(4)) {
    case 0:
      capsule.p[random.below(3)] = bad;
      break;
    case 1:
      capsule.q[random.below(3)] = -bad;
      break;
    case 2:
      capsule.radius = bad;
      break;
    default:
      capsule.radius = -capsule.radius;
  }
}
template <class S>
BallAndCapsule<S, 3> invalid(Random& random) {
  BallAndCapsule<S, 3> c = ordinary<S>(random);
  if (random.one_in(2)) {
    spoil(random, c.b);
  } else {
    Capsule<S, 3> ball = {c.a.center, c.a.center, c.a.radius};
    spoil(random, ball);
    c.a = {ball.p + (ball.q - c.a.center), ball.radius};
  }
  return c;
}

}  // namespace sphere_capsule_families

template <class S>
constexpr std::array<NamedDraw<BallAndCapsule<S, 3>>, 7> sphere_capsule_draws = {{
    {"ordinary", sphere_capsule_families::ordinary<S>},
    {"side-touch", sphere_capsule_families::near_touch<S, true>, "balls that touch the side but for a few ulp."},
    {"end-touch", sphere_capsule_families::near_touch<S, false>, "the same beyond an end."},
    {"far-end", sphere_capsule_families::far_end<S>,
     "the same at the side of capsules a thousand times longer, or more."},
    {"exact-touch", sphere_capsule_families::exact_touch<S>, "integers: balls that touch exactly."},
    {"scale", sphere_capsule_families::scale<S>, "sizes at which squares overflow or vanish."},
    {"invalid", sphere_capsule_families::invalid<S>, "NaN, infinities and negative radii."},
}};

}  // namespace isect::bench
