#pragma once
// Rays and planes that are hard to tell apart; each plane also by a point, exactly on it where S can represent that.

#include <array>

#include "bench/full_precision.h"
#include "bench/named_draw.h"
#include "bench/random_shapes.h"

namespace isect::bench {

template <class S>
struct RayPlaneCase {
  Ray<S, 3> ray;
  Plane<S, 3> plane;
  Point<S, 3> point;
};
template <class S>
std::string full_precision(const RayPlaneCase<S>& c) {
  return full_precision(c.ray) + " " + full_precision(c.plane);
}

namespace ray_plane_families {

/// The plane across `normal` through `point`, d rounded.
template <class S>
Plane<S, 3> through(const Vector<S, 3>& normal, const Point<S, 3>& point) {
  return {normal, static_cast<S>(-normal.template cast<double>().dot(point.template cast<double>()))};
}

template <class S>
RayPlaneCase<S> ordinary(Random& random) {
  const Vector<S, 3> normal = random.heading<3>().template cast<S>();
  const Point<S, 3> point = random.in_box<3>(2).template cast<S>();
  const Ray<S, 3> ray = ordinary_ray<S>(random);
  return {ray, through(normal, point), point};
}

/// Small integers; `most` bounds the coordinates of the point.
template <class S>
RayPlaneCase<S> whole(Random& random, int most) {
  Vector<S, 3> normal, point;
  do {
    for (S& x : normal) x = static_cast<S>(random.integer(-5, 5));
  } while (normal.isZero(0));
  for (S& x : point) x = static_cast<S>(random.integer(-most, most));
  return {{}, through(normal, point), point};
}

/// An origin near the plane, both far from the frame's origin: n.o + D cancels.
template <class S>
RayPlaneCase<S> far(Random& random) {
  constexpr bool wide = std::numeric_limits<S>::digits == 53;
  RayPlaneCase<S> c = whole<S>(random, wide ? 1 << 30 : 1 << 18);
  c.ray.origin = c.point + (random.magnitude(wide ? -6 : -1, wide ? -3 : 1) * random.heading<3>()).template cast<S>();
  c.ray.direction = random.heading<3>().template cast<S>();
  return c;
}

/// The origin in the plane, or an ulp beside it: t = 0 or so, of either sign.
template <class S>
RayPlaneCase<S> origin_on_plane(Random& random) {
  RayPlaneCase<S> c = whole<S>(random, 1000);
  const Vector<S, 3> aside(c.plane.normal[1], -c.plane.normal[0], S(0));
  c.ray.origin = (c.point + static_cast<S>(random.integer(-9, 9)) * aside) / 10;
  c.point /= 10, c.plane.d = through(c.plane.normal, c.point).d;
  S& x = c.ray.origin[random.below(3)];
  x = moved(x, random.integer(-1, 1));
  c.ray.direction = random.heading<3>().template cast<S>();
  return c;
}

/// Directions of tenths that lie in the plane, up to rounding: it decides whether they meet, and where.
template <class S>
RayPlaneCase<S> near_parallel(Random& random) {
  RayPlaneCase<S> c = whole<S>(random, 10);
  Vector<S, 3> other;
  for (S& x : other) x = static_cast<S>(random.integer(-50, 50));
  const Vector<S, 3> within = c.plane.normal.cross(other);
  c.ray.origin = random.in_box<3>(10).template cast<S>();
  c.ray.direction = within / 10;
  if (random.one_in(2)) c.plane.normal /= 10, c.plane.d = through(c.plane.normal, c.point).d;
  if (random.one_in(2)) {
    S& x = c.ray.direction[random.below(3)];
    x = moved(x, random.integer(-2, 2));
  }
  return c;
}

/// Pairs in which products overflow or vanish.
template <class S>
RayPlaneCase<S> scale(Random& random) {
  constexpr int most = std::numeric_limits<S>::max_exponent;
  const auto across = [&] { return random.integer(most / 2, most - 6) * (random.one_in(2) ? 1 : -1); };
  const int normal = across() / 2, lengths = across(), along = across();
  RayPlaneCase<S> c = ordinary<S>(random);
  bench::scale(normal, c.plane.normal);
  bench::scale(lengths, c.ray.origin, c.point);
  bench::scale(along, c.ray.direction);
  bench::scale(std::clamp(normal + lengths, -most, most - 4), c.plane.d);
  return c;
}

}  // namespace ray_plane_families

template <class S>
constexpr std::array<NamedDraw<RayPlaneCase<S>>, 5> ray_plane_draws = {{
    {"ordinary", ray_plane_families::ordinary<S>},
    {"far", ray_plane_families::far<S>, "an origin near the plane, both far from the frame's origin."},
    {"origin-on-plane", ray_plane_families::origin_on_plane<S>, "rays that start on the plane but for an ulp."},
    {"near-parallel", ray_plane_families::near_parallel<S>, "directions that lie in the plane but for rounding."},
    {"scale", ray_plane_families::scale<S>, "sizes at which products overflow or vanish."},
}};

}  // namespace isect::bench
