#pragma once
// Triangles and boxes that are hard to tell apart: in touch, up to rounding, in a plane that parts them.

#include <Eigen/Geometry>
#include <array>
#include <limits>

#include "bench/named_draw.h"
#include "bench/ordinary_shapes.h"
#include "bench/random_shapes.h"

namespace isect::bench {

template <class S>
using TriangleAndBox = Pair<Triangle<S, 3>, Aabb<S, 3>>;

namespace triangle_aabb_families {

using Wide = TriangleAndBox<double>;

template <class S>
TriangleAndBox<S> ordinary(Random& random) {
  const Triangle<S, 3> triangle = ordinary_triangle<S>(random);
  return {triangle, ordinary_box<S>(random)};
}

/// A vertex in a face of the box, the others beyond it.
inline Wide vertex_at_face(Random& random) {
  Wide c = {{}, ordinary_box<double>(random)};
  const int face = random.below(3);
  const double side = random.sign();
  Point<double, 3> touched;
  for (int k = 0; k < 3; ++k) touched[k] = random.uniform(c.b.lo[k], c.b.hi[k]);
  touched[face] = side > 0 ? c.b.hi[face] : c.b.lo[face];
  for (Point<double, 3>& v : c.a.vertices) {
    v = touched + random.in_box<3>(1);
    v[face] = touched[face] + side * std::abs(v[face] - touched[face]);
  }
  c.a.vertices[random.below(3)] = touched;
  return c;
}

/// Its plane through a corner of the box, which lies within the triangle.
inline Wide plane_at_corner(Random& random) {
  Wide c = {{}, ordinary_box<double>(random)};
  Point<double, 3> corner;
  Vector<double, 3> outwards;
  for (int k = 0; k < 3; ++k) {
    const double side = random.sign();
    corner[k] = side > 0 ? c.b.hi[k] : c.b.lo[k], outwards[k] = side * random.uniform(0.1, 1);
  }
  const Vector<double, 3> u = outwards.cross(random.heading<3>()).normalized(), v = outwards.cross(u).normalized();
  for (int i = 0; i < 3; ++i) {
    const double angle = 2 * std::numbers::pi * (i + random.uniform(0, 0.4)) / 3, radius = random.uniform(0.3, 1.5);
    c.a.vertices[i] = corner + radius * (std::cos(angle) * u + std::sin(angle) * v);
  }
  return c;
}

/// An edge across an edge of the box, the third vertex beyond.
inline Wide edge_at_edge(Random& random) {
  Wide c = {{}, ordinary_box<double>(random)};
  const int along = random.below(3);
  Point<double, 3> touched;
  Vector<double, 3> outwards;
  for (int k = 0; k < 3; ++k) {
    const double side = random.sign();
    touched[k] = side > 0 ? c.b.hi[k] : c.b.lo[k], outwards[k] = side * random.uniform(0.1, 1);
  }
  touched[along] = random.uniform(c.b.lo[along], c.b.hi[along]), outwards[along] = 0;
  const Vector<double, 3> edge = Vector<double, 3>::Unit(along), across = outwards.cross(edge).normalized();
  const Vector<double, 3> w = across + random.uniform(-1, 1) * edge;
  c.a.vertices = {touched + random.uniform(0.2, 1) * w, touched - random.uniform(0.2, 1) * w,
                  touched + outwards + random.uniform(-1, 1) * w};
  return c;
}

inline Wide some_touch(Random& random) {
  switch (random.below(3)) {
    case 0:
      return vertex_at_face(random);
    case 1:
      return plane_at_corner(random);
    default:
      return edge_at_edge(random);
  }
}

/// Rounds, and moves one coordinate of the triangle by up to 4 ulp.
template <class S>
TriangleAndBox<S> rounded(Random& random, const Wide& c) {
  TriangleAndBox<S> result = {cast<S>(c.a), cast<S>(c.b)};
  S& x = result.a.vertices[random.below(3)][random.below(3)];
  x = moved(x, random.integer(-4, 4));
  return result;
}
template <class S, Wide (*draw)(Random&)>
TriangleAndBox<S> nearly(Random& random) {
  return rounded<S>(random, draw(random));
}

/// Small integers: faces, edges and corners that meet exactly.
template <class S>
TriangleAndBox<S> grid(Random& random) {
  const auto any = [&] { return Point<S, 3>(vector<S, 3>(random, Numbers::grid)); };
  for (;;) {
    const Point<S, 3> p = any(), q = any();
    const TriangleAndBox<S> c = {{{any(), any(), any()}}, {p.cwiseMin(q), p.cwiseMax(q)}};
    const auto& [u, v, w] = c.a.vertices;
    if ((v - u).cross(w - u) != Vector<S, 3>::Zero()) return c;
  }
}

/// Triangles whose third vertex lies 1e-9 (1e-4 in float) and less off the first edge, which crosses one of the box's.
template <class S>
TriangleAndBox<S> needle(Random& random) {
  Wide c = edge_at_edge(random);
  auto& [p, q, r] = c.a.vertices;
  constexpr double most = std::numeric_limits<S>::digits == 53 ? -9 : -4;
  r = p + random.unit() * (q - p) + random.magnitude(most - 4, most) * random.heading<3>();
  return rounded<S>(random, c);
}

/// Triangle and box both 1e8 (1e4 in float) away from the frame's origin.
template <class S>
TriangleAndBox<S> far(Random& random) {
  Wide c = some_touch(random);
  const Vector<double, 3> away = (std::numeric_limits<S>::digits == 53 ? 1e8 : 1e4) * random.heading<3>();
  for (Point<double, 3>& v : c.a.vertices) v += away;
  c.b.lo += away, c.b.hi += away;
  return rounded<S>(random, c);
}

/// Pairs in which squares overflow or vanish.
template <class S>
TriangleAndBox<S> scale(Random& random) {
  TriangleAndBox<S> c = rounded<S>(random, some_touch(random));
  auto& [p, q, r] = c.a.vertices;
  bench::scale(beyond_squares<S>(random), p, q, r, c.b.lo, c.b.hi);
  return c;
}

/// NaN, an infinity or an inverted box.
template <class S>
TriangleAndBox<S> invalid(Random& random) {
  using Limits = std::numeric_limits<S>;
  TriangleAndBox<S> c = ordinary<S>(random);
  const S bad = random.one_in(2) ? Limits::quiet_NaN() : Limits::infinity();
  const int i = random.below(3);
  switch (random.below(3)) {
    case 0:
      c.a.vertices[random.below(3)][i] = bad;
      break;
    case 1:
      (random.one_in(2) ? c.b.lo : c.b.hi)[i] = bad;
      break;
    default:
      std::swap(c.b.lo[i], c.b.hi[i]);
  }
  return c;
}

}  // namespace triangle_aabb_families

template <class S>
constexpr std::array<NamedDraw<TriangleAndBox<S>>, 9> triangle_aabb_draws = {{
    {"ordinary", triangle_aabb_families::ordinary<S>},
    {"vertex-at-face", triangle_aabb_families::nearly<S, triangle_aabb_families::vertex_at_face>,
     "a vertex at a face of the box but for a few ulp."},
    {"plane-at-corner", triangle_aabb_families::nearly<S, triangle_aabb_families::plane_at_corner>,
     "a corner of the box in the triangle but for a few ulp."},
    {"edge-at-edge", triangle_aabb_families::nearly<S, triangle_aabb_families::edge_at_edge>,
     "edges that cross in one point but for a few ulp."},
    {"grid", triangle_aabb_families::grid<S>, "small integers: faces, edges and corners that meet exactly."},
    {"needle", triangle_aabb_families::needle<S>,
     "triangles 1e-9 high (1e-4 in float) and less, an edge at an edge of the box."},
    {"far", triangle_aabb_families::far<S>, "in touch but for a few ulp, 1e8 away (1e4 in float)."},
    {"scale", triangle_aabb_families::scale<S>, "sizes at which squares overflow or vanish."},
    {"invalid", triangle_aabb_families::invalid<S>, "NaN, infinities and inverted boxes."},
}};

}  // namespace isect::bench
