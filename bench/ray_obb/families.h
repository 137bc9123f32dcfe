#pragma once
// Rays and oriented boxes that are hard to tell apart.

#include <array>
#include <limits>

#include "bench/named_draw.h"
#include "bench/ordinary_shapes.h"
#include "bench/random_obb.h"

namespace isect::bench {

template <class S>
using RayAndObb = Pair<Ray<S, 3>, Obb<S, 3>>;

namespace ray_obb_families {

using Wide = RayAndObb<double>;

inline Wide some_pair(Random& random) {
  const Ray<double, 3> ray = ordinary_ray<double>(random);
  return {ray, ordinary_obb<double>(random, 1)};
}
template <class S>
RayAndObb<S> ordinary(Random& random) {
  const Wide c = some_pair(random);
  return {cast<S>(c.a), cast<S>(c.b)};
}

/// A point of the box, at one end or the other of its first `fixed` axes, from a random one on.
inline Point<double, 3> on(Random& random, const Obb<double, 3>& box, int fixed) {
  Vector<double, 3> along;
  const int first = random.below(3);
  for (int k = 0; k < 3; ++k) along[(first + k) % 3] = k < fixed ? random.sign() : random.uniform(-1, 1);
  return box.center + box.axes * along.cwiseProduct(box.half);
}

/// Rounds, and aims the ray at `target` as nearly as S can represent it.
template <class S>
RayAndObb<S> towards(const Wide& c, const Point<double, 3>& target) {
  RayAndObb<S> result = {cast<S>(c.a), cast<S>(c.b)};
  result.a.direction = target.cast<S>() - result.a.origin;
  return result;
}

/// A ray aimed at a point of an edge, fixed on 2 axes, or at a corner, fixed on 3.
template <class S, int fixed>
RayAndObb<S> aimed(Random& random) {
  const Wide c = some_pair(random);
  return towards<S>(c, on(random, c.b, fixed));
}

/// A ray in the plane of a face up to rounding, towards a point of it.
template <class S>
RayAndObb<S> along_face(Random& random) {
  Wide c = some_pair(random);
  const int face = random.below(3);
  const double side = random.sign();
  const auto in_plane = [&](double most) -> Point<double, 3> {
    Vector<double, 3> along = random.in_box<3>(most);
    along[face] = side;
    return c.b.center + c.b.axes * along.cwiseProduct(c.b.half);
  };
  c.a.origin = in_plane(4);
  return towards<S>(c, in_plane(1));
}

/// A ray from a face outwards, inwards or along it, up to rounding.
template <class S>
RayAndObb<S> on_surface(Random& random) {
  Wide c = some_pair(random);
  c.a.origin = on(random, c.b, 1);
  c.a.direction = random.heading<3>();
  if (random.one_in(3)) c.a.direction = random.sign() * c.b.axes.col(random.below(3));
  return {cast<S>(c.a), cast<S>(c.b)};
}

/// Axes off unit length and right angles by 1e-12 to 1e-4 (1e-6 to 1e-3 in float), as repeated rotations leave them;
/// aimed at an edge.
template <class S>
RayAndObb<S> drifted(Random& random) {
  Wide c = some_pair(random);
  constexpr bool is_float = std::is_same_v<S, float>;
  for (int i = 0; i < 3; ++i)
    c.b.axes.col(i) += random.magnitude(is_float ? -6 : -12, is_float ? -3 : -4) * random.heading<3>();
  c.b = cast<double>(cast<S>(c.b));
  return towards<S>(c, on(random, c.b, 2));
}

/// 1e5 long and 0.01 thick, aimed at an edge.
template <class S>
RayAndObb<S> slender(Random& random) {
  Wide c = some_pair(random);
  c.b.half = {1e5, 0.01, 0.01};
  return towards<S>(c, on(random, c.b, 2));
}

/// The box 1e8 (1e4 in float) away from the frame's origin, the ray from beside it or from there, aimed at an edge.
template <class S>
RayAndObb<S> far(Random& random) {
  Wide c = some_pair(random);
  const Vector<double, 3> away = (std::is_same_v<S, float> ? 1e4 : 1e8) * random.heading<3>();
  c.b.center += away;
  if (random.one_in(2)) c.a.origin += away;
  return towards<S>(c, on(random, c.b, 2));
}

/// Lengths so large or small that their squares overflow or vanish, aimed at an edge.
template <class S>
RayAndObb<S> scale(Random& random) {
  RayAndObb<S> c = aimed<S, 2>(random);
  bench::scale(beyond_squares<S>(random), c.a.origin, c.a.direction, c.b.center, c.b.half);
  return c;
}

/// NaN, an infinity, a negative half-length or dependent axes.
template <class S>
RayAndObb<S> invalid(Random& random) {
  using Limits = std::numeric_limits<S>;
  RayAndObb<S> c = aimed<S, 0>(random);
  const S bad = random.one_in(2) ? Limits::quiet_NaN() : Limits::infinity();
  const int i = random.below(3);
  switch (random.below(6)) {
    case 0:
      c.a.origin[i] = bad;
      break;
    case 1:
      c.a.direction[i] = bad;
      break;
    case 2:
      c.b.center[i] = bad;
      break;
    case 3:
      c.b.axes(i, random.below(3)) = bad;
      break;
    case 4:
      c.b.half[i] = random.one_in(2) ? bad : -c.b.half[i];
      break;
    default:
      c.b.axes.col(i) = c.b.axes.col((i + 1) % 3);
  }
  return c;
}

}  // namespace ray_obb_families

template <class S>
constexpr std::array<NamedDraw<RayAndObb<S>>, 10> ray_obb_draws = {{
    {"ordinary", ray_obb_families::ordinary<S>},
    {"edge-aimed", ray_obb_families::aimed<S, 2>, "rays towards a point of an edge."},
    {"corner-aimed", ray_obb_families::aimed<S, 3>, "rays towards a corner."},
    {"along-face", ray_obb_families::along_face<S>, "rays in the plane of a face but for rounding."},
    {"on-surface", ray_obb_families::on_surface<S>, "rays that start on a face but for rounding."},
    {"drifted", ray_obb_families::drifted<S>,
     "axes off right angles by 1e-12 to 1e-4 (1e-6 to 1e-3 in float), taken literally; rays towards an edge."},
    {"slender", ray_obb_families::slender<S>, "boxes 1e5 long and 0.01 thick, and rays towards an edge."},
    {"far", ray_obb_families::far<S>, "boxes 1e8 away (1e4 in float), and rays towards an edge."},
    {"scale", ray_obb_families::scale<S>, "sizes at which squares overflow or vanish."},
    {"invalid", ray_obb_families::invalid<S>, "NaN, infinities, negative half-lengths and dependent axes."},
}};

}  // namespace isect::bench
