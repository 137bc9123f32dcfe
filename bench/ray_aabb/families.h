#pragma once
// Rays and boxes that are hard to tell apart.

#include <array>

#include "bench/named_draw.h"
#include "bench/ordinary_shapes.h"
#include "bench/random_shapes.h"

namespace isect::bench {

template <class S>
using RayAndBox = Pair<Ray<S, 3>, Aabb<S, 3>>;

namespace ray_aabb_families {

template <class S>
RayAndBox<S> ordinary(Random& random) {
  const Ray<S, 3> ray = ordinary_ray<S>(random);
  return {ray, ordinary_box<S>(random)};
}

/// One end of the box's side.
template <class S>
S end(Random& random, const Aabb<S, 3>& box, int axis) {
  return random.one_in(2) ? box.lo[axis] : box.hi[axis];
}
/// 0 or -0.
template <class S>
S zero(Random& random) {
  return random.one_in(2) ? S(0) : -S(0);
}

/// A ray towards a point of an edge, fixed on 2 axes, or towards a corner, fixed on 3.
template <class S, int fixed>
RayAndBox<S> aimed(Random& random) {
  RayAndBox<S> c = ordinary<S>(random);
  const int first = random.below(3);
  Point<S, 3> target;
  for (int k = 0; k < 3; ++k) {
    const int i = (first + k) % 3;
    target[i] = k < fixed ? end(random, c.b, i) : static_cast<S>(random.uniform(c.b.lo[i], c.b.hi[i]));
  }
  c.a.direction = target - c.a.origin;
  return c;
}

/// A ray along a face or an edge, or an ulp beside it: 1 or 2 components are 0, and those coordinates of the origin lie
/// on planes of the box.
template <class S>
RayAndBox<S> along_slab(Random& random) {
  RayAndBox<S> c = ordinary<S>(random);
  const int first = random.below(3), zeros = random.integer(1, 2);
  for (int k = 0; k < 3; ++k) {
    const int i = (first + k) % 3;
    const double inside = random.uniform(c.b.lo[i], c.b.hi[i]);
    if (k < zeros) {
      c.a.direction[i] = zero<S>(random);
      c.a.origin[i] = random.one_in(3) ? static_cast<S>(inside) : end(random, c.b, i);
      if (random.one_in(4)) c.a.origin[i] = moved(c.a.origin[i], random.integer(-1, 1));
    } else {
      c.a.direction[i] = static_cast<S>(inside) - c.a.origin[i];
    }
  }
  return c;
}

/// Components of 0 and -0, from inside those slabs or outside.
template <class S>
RayAndBox<S> signed_zeros(Random& random) {
  RayAndBox<S> c = ordinary<S>(random);
  for (int i = 0; i < 3; ++i) {
    const double inside = random.uniform(c.b.lo[i], c.b.hi[i]);
    if (random.one_in(2))
      c.a.direction[i] = zero<S>(random), c.a.origin[i] = static_cast<S>(random.one_in(6) ? 3 : inside);
    else
      c.a.direction[i] = static_cast<S>(inside) - c.a.origin[i];
  }
  return c;
}

/// From a face, or an ulp beside it: inwards, outwards or along it.
template <class S>
RayAndBox<S> on_surface(Random& random) {
  RayAndBox<S> c = ordinary<S>(random);
  for (int i = 0; i < 3; ++i) c.a.origin[i] = static_cast<S>(random.uniform(c.b.lo[i], c.b.hi[i]));
  const int i = random.below(3);
  c.a.origin[i] = end(random, c.b, i);
  if (random.one_in(3)) c.a.origin[i] = moved(c.a.origin[i], random.integer(-1, 1));
  if (random.one_in(3)) c.a.direction[(i + 1) % 3] = zero<S>(random);
  return c;
}

/// Lengths and directions so large or small that differences overflow or vanish, and so do reciprocals.
template <class S>
RayAndBox<S> scale(Random& random) {
  using Limits = std::numeric_limits<S>;
  RayAndBox<S> c = random.one_in(2) ? ordinary<S>(random) : aimed<S, 2>(random);
  const auto across = [&] { return random.integer(Limits::min_exponent - 10, Limits::max_exponent - 3); };
  const int lengths = across(), along = random.one_in(2) ? lengths : across();
  bench::scale(lengths, c.a.origin, c.b.lo, c.b.hi);
  bench::scale(along, c.a.direction);
  return c;
}

/// NaN, or an inverted box.
template <class S>
RayAndBox<S> invalid(Random& random) {
  RayAndBox<S> c = aimed<S, 0>(random);
  const S nan = std::numeric_limits<S>::quiet_NaN();
  const int i = random.below(3);
  switch (random.below(4)) {
    case 0:
      c.a.origin[i] = nan;
      break;
    case 1:
      c.a.direction[i] = nan;
      break;
    case 2:
      (random.one_in(2) ? c.b.lo : c.b.hi)[i] = nan;
      break;
    default:
      std::swap(c.b.lo[i], c.b.hi[i]);
  }
  return c;
}

}  // namespace ray_aabb_families

template <class S>
constexpr std::array<NamedDraw<RayAndBox<S>>, 8> ray_aabb_draws = {{
    {"ordinary", ray_aabb_families::ordinary<S>},
    {"edge-aimed", ray_aabb_families::aimed<S, 2>, "rays towards a point of an edge."},
    {"corner-aimed", ray_aabb_families::aimed<S, 3>, "rays towards a corner."},
    {"along-slab", ray_aabb_families::along_slab<S>, "rays along a face or an edge, or an ulp beside it."},
    {"signed-zeros", ray_aabb_families::signed_zeros<S>, "directions with components of 0 and -0."},
    {"on-surface", ray_aabb_families::on_surface<S>, "rays that start on a face."},
    {"scale", ray_aabb_families::scale<S>, "sizes at which differences overflow or reciprocals vanish."},
    {"invalid", ray_aabb_families::invalid<S>, "inverted boxes and NaN."},
}};

}  // namespace isect::bench
