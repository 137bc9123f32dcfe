#pragma once
// Balls and boxes that are hard to tell apart.

#include <array>

#include "bench/named_draw.h"
#include "bench/ordinary_shapes.h"
#include "bench/ray_sphere/generators.h"
#include "bench/simple_shapes.h"

namespace isect::bench {

template <class S, int N>
using BallAndBox = Pair<Sphere<S, N>, Aabb<S, N>>;

/// A radius that makes the ball touch the box, or contain it, or fit into it, up to rounding.
template <class S, int N>
S critical_radius(Random& random, const Point<S, N>& center, const Aabb<S, N>& box, Way way = Way::any) {
  const Vector<double, N> c = center.template cast<double>(), lo = box.lo.template cast<double>(),
                          hi = box.hi.template cast<double>();
  double r = 0;
  switch (way == Way::any ? random.below(3) : static_cast<int>(way)) {
    case static_cast<int>(Way::touch):
      r = (c - c.cwiseMax(lo).cwiseMin(hi)).stableNorm();
      break;
    case static_cast<int>(Way::contain):
      r = (c - lo).cwiseAbs().cwiseMax((hi - c).cwiseAbs()).eval().stableNorm();
      break;
    default:
      r = (c - lo).cwiseMin(hi - c).minCoeff();
  }
  return moved(static_cast<S>(r), random.integer(-2, 2));
}

namespace sphere_aabb_families {

template <class S>
BallAndBox<S, 3> ordinary(Random& random) {
  const Sphere<S, 3> ball = ordinary_sphere<S>(random);
  return {ball, ordinary_box<S>(random)};
}

/// A ball that touches a face, an edge or a corner from outside: beside the box on 1, 2 or 3 axes.
template <class S, int axes>
BallAndBox<S, 3> near_touch(Random& random) {
  BallAndBox<S, 3> c = ordinary<S>(random);
  const int first = random.below(3);
  for (int k = 0; k < 3; ++k) {
    const int i = (first + k) % 3;
    const double beyond = random.uniform(0.01, 1);
    const bool right = random.one_in(2);
    if (k >= axes)
      c.a.center[i] = static_cast<S>(random.uniform(c.b.lo[i], c.b.hi[i]));
    else
      c.a.center[i] = right ? c.b.hi[i] + static_cast<S>(beyond) : c.b.lo[i] - static_cast<S>(beyond);
  }
  c.a.radius = critical_radius(random, c.a.center, c.b, Way::touch);
  return c;
}

/// Integers: the center at a whole distance from a corner.
template <class S>
BallAndBox<S, 3> exact_touch(Random& random) {
  const auto [n, length] = generators::pythagorean<3>(random, generators::wide<S> ? 1000 : 15);
  const generators::Whole<3> corner = generators::small<3>(random, generators::wide<S> ? 1 << 30 : 1 << 16);
  BallAndBox<S, 3> c = {{(corner + n).eval().template cast<S>(), static_cast<S>(length)},
                        {corner.cast<S>(), corner.cast<S>()}};
  for (int i = 0; i < 3; ++i) {
    const S width = static_cast<S>(random.integer(0, 1 << 12));
    if (n[i] > 0)
      c.b.lo[i] -= width;
    else
      c.b.hi[i] += width;
  }
  bench::scale(random.integer(-20, 20), c.a.center, c.a.radius, c.b.lo, c.b.hi);
  return c;
}

/// Pairs in which squares overflow or vanish.
template <class S>
BallAndBox<S, 3> scale(Random& random) {
  BallAndBox<S, 3> c = ordinary<S>(random);
  bench::scale(beyond_squares<S>(random), c.a.center, c.a.radius, c.b.lo, c.b.hi);
  return c;
}

/// NaN or an infinity somewhere, an inverted box, or a radius below 0.
template <class S>
BallAndBox<S, 3> invalid(Random& random) {
  using Limits = std::numeric_limits<S>;
  BallAndBox<S, 3> c = ordinary<S>(random);
  const S bad = random.one_in(2) ? Limits::quiet_NaN() : Limits::infinity();
  const int i = random.below(3);
  switch (random.below(5)) {
    case 0:
      c.a.center[i] = bad;
      break;
    case 1:
      c.b.lo[i] = -bad;
      break;
    case 2:
      c.b.hi[i] = bad;
      break;
    case 3:
      std::swap(c.b.lo[i], c.b.hi[i]);
      break;
    default:
      c.a.radius = -c.a.radius;
  }
  return c;
}

}  // namespace sphere_aabb_families

template <class S>
constexpr std::array<NamedDraw<BallAndBox<S, 3>>, 7> sphere_aabb_draws = {{
    {"ordinary", sphere_aabb_families::ordinary<S>},
    {"face-touch", sphere_aabb_families::near_touch<S, 1>, "balls that touch a face but for a few ulp."},
    {"edge-touch", sphere_aabb_families::near_touch<S, 2>, "the same at an edge."},
    {"corner-touch", sphere_aabb_families::near_touch<S, 3>, "the same at a corner."},
    {"exact-touch", sphere_aabb_families::exact_touch<S>, "integers: balls that touch a corner exactly."},
    {"scale", sphere_aabb_families::scale<S>, "sizes at which squares overflow or vanish."},
    {"invalid", sphere_aabb_families::invalid<S>, "NaN, infinities, inverted boxes and negative radii."},
}};

}  // namespace isect::bench
