#pragma once
// Rays and polygons in space that are hard to tell apart.

#include <array>
#include <numbers>

#include "bench/named_draw.h"
#include "bench/ordinary_shapes.h"
#include "bench/random_shapes.h"

namespace isect::bench {

template <class S>
using RayAndRing = Pair<Ray<S, 3>, Ring<S, 3>>;

namespace ray_polygon_families {

/// A frame of a plane, as doubles.
struct Frame {
  Point<double, 3> center;
  Vector<double, 3> u, v;

  Point<double, 3> at(double x, double y) const { return center + x * u + y * v; }
};
inline Frame some_frame(Random& random) {
  const Vector<double, 3> u = random.heading<3>(), other = random.heading<3>();
  return {random.in_box<3>(0.5), u, u.cross(other).normalized()};
}

/// Eight vertices around the center, near and far, so that the outline is concave.
template <class S>
Ring<S, 3> star(Random& random, const Frame& frame) {
  Ring<S, 3> ring;
  for (int i = 0; i < 8; ++i) {
    const double angle = 2 * std::numbers::pi * (i + random.unit()) / 8, radius = random.uniform(0.3, 1.5);
    ring.push_back(frame.at(radius * std::cos(angle), radius * std::sin(angle)).template cast<S>());
  }
  return ring;
}

template <class S>
Ray<S, 3> from_to(const Point<double, 3>& from, const Point<S, 3>& to) {
  const Point<S, 3> origin = from.cast<S>();
  return {origin, to - origin};
}

template <class S>
RayAndRing<S> ordinary(Random& random) {
  const Frame frame = some_frame(random);
  const Ring<S, 3> ring = star<S>(random, frame);
  const Point<double, 3> from = 3 * random.heading<3>(),
                         to = frame.at(random.uniform(-1.3, 1.3), random.uniform(-1.3, 1.3));
  return {from_to<S>(from, to.cast<S>()), ring};
}

/// A point of an edge, or a vertex.
template <class S>
Point<S, 3> on_outline(Random& random, const Ring<S, 3>& ring, bool vertex) {
  const std::size_t i = static_cast<std::size_t>(random.below(static_cast<int>(ring.size())));
  const S along = vertex ? S(0) : static_cast<S>(random.unit());
  return ring[i] + along * (ring[(i + 1) % ring.size()] - ring[i]);
}
template <class S, bool vertex>
RayAndRing<S> aimed(Random& random) {
  const Ring<S, 3> ring = star<S>(random, some_frame(random));
  const Point<double, 3> from = 3 * random.heading<3>();
  return {from_to(from, on_outline(random, ring, vertex)), ring};
}

/// Vertices of small integers in one plane exactly, aimed at its edges, vertices and half-way points.
template <class S>
RayAndRing<S> grid(Random& random) {
  const auto any = [&](int most) -> Point<S, 3> {
    return {static_cast<S>(random.integer(-most, most)), static_cast<S>(random.integer(-most, most)),
            static_cast<S>(random.integer(-most, most))};
  };
  const Point<S, 3> corner = any(4);
  const Vector<S, 3> u = any(3), v = any(3);
  const auto at = [&](S x, S y) -> Point<S, 3> { return corner + x * u + y * v; };
  Ring<S, 3> ring;
  for (int i = random.integer(3, 7); i > 0; --i)
    ring.push_back(at(static_cast<S>(random.integer(-3, 3)), static_cast<S>(random.integer(-3, 3))));
  const Point<S, 3> target =
      random.one_in(2) ? at(static_cast<S>(random.integer(-6, 6)) / 2, static_cast<S>(random.integer(-6, 6)) / 2)
                       : ring[random.below(3)];
  const Point<S, 3> origin = S(8) * any(4);
  return {{origin, target - origin}, ring};
}

/// A polygon of width 1e-9 (1e-4 in float) or less; the ray is aimed inside.
template <class S>
RayAndRing<S> needle(Random& random) {
  constexpr double most = std::numeric_limits<S>::digits == 53 ? -9 : -4;
  Frame frame = some_frame(random);
  frame.v *= random.magnitude(most - 4, most);
  const Ring<S, 3> ring = star<S>(random, frame);
  const Point<double, 3> from = 3 * random.heading<3>(), to = frame.at(random.uniform(-1, 1), random.uniform(-1, 1));
  return {from_to<S>(from, to.cast<S>()), ring};
}

/// 1e8 (1e4 in float) away from the frame's origin, aimed at the outline.
template <class S>
RayAndRing<S> far(Random& random) {
  constexpr double away = std::numeric_limits<S>::digits == 53 ? 1e8 : 1e4;
  Frame frame = some_frame(random);
  frame.center += away * random.heading<3>();
  const Ring<S, 3> ring = star<S>(random, frame);
  const Point<double, 3> from = random.one_in(2) ? Point<double, 3>(frame.center + 3 * random.heading<3>())
                                                 : Point<double, 3>(3 * random.heading<3>());
  return {from_to(from, on_outline(random, ring, random.one_in(4))), ring};
}

/// From a point 1e-15 to 1e-10 (in float 1e-7 to 1e-2) beside the plane, along it.
template <class S>
RayAndRing<S> near_coplanar(Random& random) {
  constexpr double least = std::numeric_limits<S>::digits == 53 ? -15 : -7;
  const Frame frame = some_frame(random);
  const Ring<S, 3> ring = star<S>(random, frame);
  const Point<double, 3> from = frame.at(random.uniform(-3, 3), random.uniform(-3, 3)) +
                                random.magnitude(least, least + 5) * random.heading<3>(),
                         to = frame.at(random.uniform(-1, 1), random.uniform(-1, 1));
  return {from_to<S>(from, to.cast<S>()), ring};
}

}  // namespace ray_polygon_families

template <class S>
constexpr std::array<NamedDraw<RayAndRing<S>>, 7> ray_polygon_draws = {{
    {"ordinary", ray_polygon_families::ordinary<S>},
    {"edge-aimed", ray_polygon_families::aimed<S, false>, "rays towards a point of the outline."},
    {"vertex-aimed", ray_polygon_families::aimed<S, true>, "rays towards a vertex."},
    {"grid", ray_polygon_families::grid<S>, "outlines of small integers: rays through vertices and edges exactly."},
    {"needle", ray_polygon_families::needle<S>, "outlines 1e-9 wide (1e-4 in float) and less."},
    {"far", ray_polygon_families::far<S>, "1e8 away (1e4 in float), aimed at the outline."},
    {"near-coplanar", ray_polygon_families::near_coplanar<S>,
     "rays that run within 1e-15 to 1e-10 of the plane (1e-7 to 1e-2 in float)."},
}};

}  // namespace isect::bench
