#pragma once
// Pairs of balls that are hard to tell apart.

#include <array>

#include "bench/named_draw.h"
#include "bench/ordinary_shapes.h"
#include "bench/ray_sphere/generators.h"
#include "bench/simple_shapes.h"

namespace isect::bench {

template <class S, int N>
using Balls = Pair<Sphere<S, N>, Sphere<S, N>>;

enum class Touch { outside, inside, either };

/// A second ball that touches the first one, up to rounding and `most` ulps: from outside, from inside, or around
/// it.
template <class S, int N>
Sphere<S, N> neighbour(Random& random, const Sphere<S, N>& a, Touch touch = Touch::either, int most = 2) {
  const double r = a.radius, s = random.one_in(2) ? r : r * random.uniform(0, 2);
  const bool outside = touch == Touch::either ? random.one_in(2) : touch == Touch::outside;
  // along an axis the touch is often exact
  const Vector<double, N> heading = random.one_in(2) ? random.heading<N>() : Vector<double, N>::Unit(random.below(N));
  Sphere<S, N> b = {a.center + ((outside ? r + s : r - s) * heading).template cast<S>(), S(0)};
  const double d = (b.center - a.center).template cast<double>().norm();
  b.radius = moved(static_cast<S>(outside ? d - r : s < r ? r - d : r + d), random.integer(-most, most));
  return b;
}

namespace sphere_sphere_families {

template <class S>
Balls<S, 3> ordinary(Random& random) {
  const Sphere<S, 3> a = ordinary_sphere<S>(random);
  return {a, ordinary_sphere<S>(random)};
}

template <class S, Touch touch>
Balls<S, 3> near_touch(Random& random) {
  const Sphere<S, 3> a = ordinary_sphere<S>(random);
  return {a, neighbour(random, a, touch)};
}

/// Integers whose distance is whole, so that the touch is exact, at any scale that a square still fits into.
template <class S>
Balls<S, 3> exact_touch(Random& random) {
  const auto [n, length] = generators::pythagorean<3>(random, generators::wide<S> ? 1000 : 15);
  const generators::Whole<3> center = generators::small<3>(random, generators::wide<S> ? 1 << 30 : 1 << 16);
  const long long r = random.integer(0, static_cast<int>(length));
  Balls<S, 3> c = {{center.cast<S>(), static_cast<S>(r)},
                   {(center + n).eval().template cast<S>(), static_cast<S>(length - r)}};
  bench::scale(random.integer(-20, 20), c.a.center, c.a.radius, c.b.center, c.b.radius);
  return c;
}

/// Radii and a distance along an axis that add up in tenths, as users type them: .1 and .2 at .3 apart.
template <class S>
Balls<S, 3> decimal(Random& random) {
  const auto tenths = [](int n) { return static_cast<S>(n / 10.0); };
  const int r = random.integer(0, 99), s = random.integer(0, 99), i = random.below(3);
  Balls<S, 3> c = {{Point<S, 3>::Zero(), tenths(r)}, {Point<S, 3>::Zero(), tenths(s)}};
  c.b.center[i] = tenths(r + s);
  return c;
}

/// Balls around the origin, with radii within an ulp, and centers that are off by what squares lose.
template <class S>
Balls<S, 3> concentric(Random& random) {
  constexpr double least = std::numeric_limits<S>::min_exponent10;
  const S radius = ordinary_sphere<S>(random).radius;
  Balls<S, 3> c = {{Point<S, 3>::Zero(), radius}, {Point<S, 3>::Zero(), moved(radius, random.integer(-1, 1))}};
  if (random.one_in(2)) c.b.center[random.below(3)] = static_cast<S>(random.magnitude(least, -7));
  return c;
}

/// Pairs in which squares overflow or vanish.
template <class S>
Balls<S, 3> scale(Random& random) {
  Balls<S, 3> c = ordinary<S>(random);
  bench::scale(beyond_squares<S>(random), c.a.center, c.a.radius, c.b.center, c.b.radius);
  return c;
}

/// One ball spoilt: a NaN, an infinity, or a radius below 0.
template <class S>
Balls<S, 3> invalid(Random& random) {
  using Limits = std::numeric_limits<S>;
  Balls<S, 3> c = ordinary<S>(random);
  Sphere<S, 3>& spoilt = random.one_in(2) ? c.a : c.b;
  S& number = random.one_in(2) ? spoilt.radius : spoilt.center[random.below(3)];
  const std::array<S, 2> bad = {Limits::quiet_NaN(), Limits::infinity()};
  if (random.one_in(3))
    spoilt.radius = -spoilt.radius;
  else
    number = bad[random.below(2)];
  return c;
}

}  // namespace sphere_sphere_families

/// Not all are hard for whether they meet: inner touch and concentric balls are so for the relation only.
template <class S>
constexpr std::array<NamedDraw<Balls<S, 3>>, 8> sphere_sphere_draws = {{
    {"ordinary", sphere_sphere_families::ordinary<S>},
    {"near-touch", sphere_sphere_families::near_touch<S, Touch::outside>,
     "balls that touch from outside but for a few ulp."},
    {"inner-touch", sphere_sphere_families::near_touch<S, Touch::inside>,
     "balls that touch from inside but for a few ulp."},
    {"exact-touch", sphere_sphere_families::exact_touch<S>,
     "integers whose distance is whole: the balls share one point, which a strict < leaves out by convention."},
    {"decimal", sphere_sphere_families::decimal<S>,
     "radii of .1 and .2 at a distance of .3, as users type them: rounding decides what is true."},
    {"concentric", sphere_sphere_families::concentric<S>, "nearly the same centre and radius."},
    {"scale", sphere_sphere_families::scale<S>, "sizes at which squares overflow or vanish."},
    {"invalid", sphere_sphere_families::invalid<S>, "a NaN, an infinity or a negative radius in one ball."},
}};

}  // namespace isect::bench
