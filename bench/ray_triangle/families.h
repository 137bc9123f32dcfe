#pragma once
// Rays and triangles that are hard to tell apart.

#include <Eigen/Geometry>
#include <array>

#include "bench/named_draw.h"
#include "bench/ordinary_shapes.h"
#include "bench/random_shapes.h"

namespace isect::bench {

template <class S>
using RayAndTriangle = Pair<Ray<S, 3>, Triangle<S, 3>>;

namespace ray_triangle_families {

template <class S>
RayAndTriangle<S> ordinary(Random& random) {
  const Ray<S, 3> ray = ordinary_ray<S>(random);
  return {ray, ordinary_triangle<S>(random)};
}

/// The ray through `target`, as nearly as S can represent it.
template <class S>
void aim(Ray<S, 3>& ray, const Point<S, 3>& target) {
  ray.direction = target - ray.origin;
}

/// A point of the triangle's edge between these vertices.
template <class S>
Point<S, 3> on_edge(Random& random, const Triangle<S, 3>& x, int i, int j) {
  const S u = static_cast<S>(random.unit());
  return x.vertices[i] + u * (x.vertices[j] - x.vertices[i]);
}

template <class S>
RayAndTriangle<S> edge_aimed(Random& random) {
  RayAndTriangle<S> c = ordinary<S>(random);
  const int i = random.below(3);
  aim(c.a, on_edge(random, c.b, i, (i + 1) % 3));
  return c;
}

template <class S>
RayAndTriangle<S> vertex_aimed(Random& random) {
  RayAndTriangle<S> c = ordinary<S>(random);
  aim(c.a, c.b.vertices[random.below(3)]);
  return c;
}

/// Small integers: rays exactly through vertices, edges and the inside. None lies in the plane: that counts as a hit
/// for some, and not for us.
template <class S>
RayAndTriangle<S> grid(Random& random) {
  const auto any = [&] { return vector<S, 3>(random, Numbers::grid); };
  for (;;) {
    RayAndTriangle<S> c = {{Point<S, 3>(S(16) * any()), {}}, {{any(), any(), any()}}};
    const auto& [p, q, r] = c.b.vertices;
    const S i = static_cast<S>(random.integer(0, 4)) / 4, j = static_cast<S>(random.integer(0, 4)) / 4;
    aim(c.a, Point<S, 3>(p + (q - p) * i + (r - p) * (j * (1 - i))));
    if ((q - p).cross(r - p).dot(c.a.direction) != 0) return c;  // no rounding: quarters of small integers
  }
}

/// A triangle of height 1e-9 (1e-4 in float) and less, the ray aimed at it.
template <class S>
RayAndTriangle<S> needle(Random& random) {
  RayAndTriangle<S> c = ordinary<S>(random);
  auto& [p, q, r] = c.b.vertices;
  constexpr double most = std::numeric_limits<S>::digits == 53 ? -9 : -4;
  r = p + static_cast<S>(random.unit()) * (q - p) +
      (random.magnitude(most - 4, most) * random.heading<3>()).template cast<S>();
  aim(c.a, Point<S, 3>(p + static_cast<S>(random.unit()) * (q - p) + static_cast<S>(random.unit()) * (r - p)));
  return c;
}

/// The triangle 1e8 (1e4 in float) away from the frame's origin, aimed at the inside or an edge; the ray comes from
/// near that origin or near the triangle.
template <class S>
RayAndTriangle<S> far(Random& random) {
  RayAndTriangle<S> c = ordinary<S>(random);
  const Vector<S, 3> away =
      ((std::numeric_limits<S>::digits == 53 ? 1e8 : 1e4) * random.heading<3>()).template cast<S>();
  for (Point<S, 3>& p : c.b.vertices) p += away;
  if (random.one_in(2)) c.a.origin += away;
  const int i = random.below(3);
  aim(c.a, random.one_in(2) ? on_edge(random, c.b, i, (i + 1) % 3)
                            : Point<S, 3>((c.b.vertices[0] + c.b.vertices[1] + c.b.vertices[2]) / 3));
  return c;
}

/// From a point 1e-15 to 1e-10 (in float 1e-7 to 1e-2) beside the plane, along it to a point of the triangle.
template <class S>
RayAndTriangle<S> near_coplanar(Random& random) {
  RayAndTriangle<S> c = ordinary<S>(random);
  const auto in_plane = [&x = c.b.vertices](double u, double v) -> Point<S, 3> {
    return x[0] + static_cast<S>(u) * (x[1] - x[0]) + static_cast<S>(v) * (x[2] - x[0]);
  };
  constexpr double least = std::numeric_limits<S>::digits == 53 ? -15 : -7;
  c.a.origin = in_plane(random.uniform(-3, 3), random.uniform(-3, 3)) +
               (random.magnitude(least, least + 5) * random.heading<3>()).template cast<S>();
  const double u = random.unit();
  aim(c.a, in_plane(u, random.uniform(0, 1 - u)));
  return c;
}

}  // namespace ray_triangle_families

template <class S>
constexpr std::array<NamedDraw<RayAndTriangle<S>>, 7> ray_triangle_draws = {{
    {"ordinary", ray_triangle_families::ordinary<S>},
    {"edge-aimed", ray_triangle_families::edge_aimed<S>, "rays towards a point of an edge."},
    {"vertex-aimed", ray_triangle_families::vertex_aimed<S>, "rays towards a vertex."},
    {"grid", ray_triangle_families::grid<S>, "small integers: rays through vertices, edges and the inside exactly."},
    {"needle", ray_triangle_families::needle<S>, "triangles 1e-9 high (1e-4 in float) and less."},
    {"far", ray_triangle_families::far<S>, "1e8 away (1e4 in float), aimed at the inside or an edge."},
    {"near-coplanar", ray_triangle_families::near_coplanar<S>,
     "rays that run within 1e-15 to 1e-10 of the plane (1e-7 to 1e-2 in float)."},
}};

}  // namespace isect::bench
