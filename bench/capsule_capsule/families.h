#pragma once
// Pairs of capsules that are hard to tell apart.

#include <algorithm>
#include <array>
#include <utility>

#include <isect/methods/capsule_capsule.h>
#include "bench/sphere_capsule/families.h"

namespace isect::bench {

template <class S, int N>
using Capsules = Pair<Capsule<S, N>, Capsule<S, N>>;

/// The distance of both segments, rounded.
template <int N>
double distance(Capsule<double, N> a, Capsule<double, N> b) {
  const int exponent = normalise(a.p, a.q, b.p, b.q);
  Record<capsule_capsule::MethodEvent<double, N>> record;
  capsule_capsule::clamped(a, b, record);
  const auto& closest = std::get<capsule_capsule::Closest<double, N>>(record.events.at(1));
  return std::ldexp((closest.on_a - closest.on_b).norm(), exponent);
}

/// A radius of a with which, up to rounding, the capsules touch, or a contains b, or a fits into b.
template <class S, int N>
S critical_radius(Random& random, const Capsule<S, N>& a, const Capsule<S, N>& b, Way way = Way::any) {
  const Capsule<double, N> x = cast<double>(a), y = cast<double>(b);
  const auto farthest = [](const Capsule<double, N>& ends, const Capsule<double, N>& segment) {
    return std::max(distance<N>(ends.p, segment), distance<N>(ends.q, segment));
  };
  const std::array<double, 3> radii = {distance(x, y) - y.radius, y.radius + farthest(y, x),
                                       y.radius - farthest(x, y)};  // in the order of Way
  const double r = radii[way == Way::any ? random.below(3) : static_cast<int>(way)];
  return moved(static_cast<S>(r), random.integer(-2, 2));
}

namespace capsule_capsule_families {

using Wide = Capsule<double, 3>;

template <class S>
Capsules<S, 3> ordinary(Random& random) {
  const Capsule<S, 3> a = ordinary_capsule<S>(random);
  return {a, ordinary_capsule<S>(random)};
}

/// Rounds both and sets the radius of a so that they touch, nearly; then may exchange them.
template <class S>
Capsules<S, 3> touching(Random& random, const Wide& a, const Wide& b) {
  Capsules<S, 3> c = {cast<S>(a), cast<S>(b)};
  if (random.one_in(2)) std::swap(c.b.p, c.b.q);
  c.a.radius = critical_radius(random, c.a, c.b, Way::touch);
  if (random.one_in(2)) std::swap(c.a, c.b);
  return c;
}

/// The place for b's nearest point: beside the point t of a, farther off than the radius of b.
inline Point<double, 3> beside(Random& random, const Wide& a, double t, double radius, const Vector<double, 3>& away) {
  return a.p + t * (a.q - a.p) + (radius + random.uniform(0.05, 1)) * away;
}

/// Segments that pass each other, nearest somewhere between their ends, at an angle of about `angle`.
template <class S>
Capsules<S, 3> passing(Random& random, double angle) {
  const Wide a = ordinary_capsule<double>(random);
  Wide b = ordinary_capsule<double>(random);
  const Vector<double, 3> u = a.q - a.p, away = u.cross(random.heading<3>()).normalized();
  const Vector<double, 3> v = std::cos(angle) * u + std::sin(angle) * away.cross(u);
  const Point<double, 3> nearest = beside(random, a, random.uniform(0.1, 0.9), b.radius, away);
  b.p = nearest - random.uniform(0.1, 1) * v;
  b.q = nearest + random.uniform(0.1, 1) * v;
  return touching<S>(random, a, b);
}
template <class S>
Capsules<S, 3> sides_touch(Random& random) {
  return passing<S>(random, random.uniform(0.2, 1.5));
}
template <class S>
Capsules<S, 3> nearly_parallel(Random& random) {
  return passing<S>(random, std::abs(random.magnitude(generators::wide<S> ? -9 : -4, -2)));
}
/// The second direction is the first one, up to the rounding of four ends.
template <class S>
Capsules<S, 3> parallel(Random& random) {
  return passing<S>(random, 0);
}

/// An end of b at the side of a, or at its end; b leads away from there.
template <class S, bool side>
Capsules<S, 3> end_touch(Random& random) {
  const Wide a = ordinary_capsule<double>(random);
  Wide b = ordinary_capsule<double>(random);
  const Vector<double, 3> u = a.q - a.p;
  Vector<double, 3> away = random.heading<3>(), v = random.heading<3>();
  if (side)
    away = (away - away.dot(u) / u.squaredNorm() * u).normalized();
  else if (away.dot(u) < 0)
    away = -away;
  if (v.dot(away) < 0) v = -v;
  b.p = beside(random, a, side ? random.uniform(0.1, 0.9) : 1, b.radius, away);
  b.q = b.p + random.uniform(0.1, 1) * v;
  return touching<S>(random, a, b);
}

/// Integers: nearest at a whole distance, at right angles to both. A factor of 0 puts the nearest point at an end.
template <class S>
Capsules<S, 3> exact_touch(Random& random) {
  constexpr int most = generators::wide<S> ? 1 << 10 : 4;
  const auto [n, length] = generators::pythagorean<3>(random, generators::wide<S> ? 100 : 6);
  const auto across = [&, n = n] { return n.cross(generators::small<3>(random, 8)).eval(); };  // 0: a ball
  const generators::Whole<3> at = generators::small<3>(random, generators::wide<S> ? 1 << 30 : 1 << 16);
  const generators::Whole<3> u = across(), v = random.one_in(4) ? u : across(), beside = at + n;
  const auto some = [&] { return random.one_in(4) ? 0 : random.integer(1, most); };
  const long long r = random.integer(0, static_cast<int>(length));
  Capsules<S, 3> c = {
      {(at - some() * u).eval().template cast<S>(), (at + some() * u).eval().template cast<S>(), static_cast<S>(r)},
      {(beside - some() * v).eval().template cast<S>(), (beside + some() * v).eval().template cast<S>(),
       static_cast<S>(length - r)}};
  bench::scale(random.integer(-20, 20), c.a.p, c.a.q, c.a.radius, c.b.p, c.b.q, c.b.radius);
  return c;
}

/// Segments of integers that cross in a point, or miss it by one unit in one coordinate.
template <class S>
Capsules<S, 3> crossing(Random& random) {
  constexpr int most = generators::wide<S> ? 1 << 20 : 1 << 10;
  const generators::Whole<3> u = generators::small<3>(random, most), v = generators::small<3>(random, most);
  const generators::Whole<3> at = generators::small<3>(random, most);
  const auto some = [&] { return random.integer(0, 8); };
  Capsules<S, 3> c = {{(at - some() * u).eval().template cast<S>(), (at + some() * u).eval().template cast<S>(), 0},
                      {(at - some() * v).eval().template cast<S>(), (at + some() * v).eval().template cast<S>(), 0}};
  if (random.one_in(2)) c.b.q[random.below(3)] += static_cast<S>(random.sign());
  return c;
}

/// Pairs in which squares overflow or vanish.
template <class S>
Capsules<S, 3> scale(Random& random) {
  Capsules<S, 3> c = ordinary<S>(random);
  bench::scale(beyond_squares<S>(random), c.a.p, c.a.q, c.a.radius, c.b.p, c.b.q, c.b.radius);
  return c;
}

/// One capsule spoilt.
template <class S>
Capsules<S, 3> invalid(Random& random) {
  Capsules<S, 3> c = ordinary<S>(random);
  sphere_capsule_families::spoil(random, random.one_in(2) ? c.a : c.b);
  return c;
}

}  // namespace capsule_capsule_families

template <class S>
constexpr std::array<NamedDraw<Capsules<S, 3>>, 10> capsule_capsule_draws = {{
    {"ordinary", capsule_capsule_families::ordinary<S>},
    {"sides-touch", capsule_capsule_families::sides_touch<S>,
     "capsules that pass each other and touch side by side but for a few ulp."},
    {"end-at-side", capsule_capsule_families::end_touch<S, true>, "the same with an end at the other's side."},
    {"end-at-end", capsule_capsule_families::end_touch<S, false>, "the same with two ends."},
    {"parallel", capsule_capsule_families::parallel<S>, "sides that are parallel but for rounding, and touch so."},
    {"nearly-parallel", capsule_capsule_families::nearly_parallel<S>,
     "the same at angles up to a hundredth, down to 1e-9 in double, 1e-4 in float."},
    {"exact-touch", capsule_capsule_families::exact_touch<S>, "integers: capsules that touch exactly."},
    {"crossing", capsule_capsule_families::crossing<S>,
     "integers: segments, which are capsules of radius 0, that cross or miss by a unit."},
    {"scale", capsule_capsule_families::scale<S>, "sizes at which squares overflow or vanish."},
    {"invalid", capsule_capsule_families::invalid<S>, "NaN, infinities and negative radii."},
}};

}  // namespace isect::bench
