#pragma once
// Shapes of any kind from any numbers, so that every pair of shapes has the same families of cases. All are in doubles.

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <isect/convex_hull_3d.h>
#include <isect/half_spaces.h>
#include <isect/point_convex_polygon.h>
#include <isect/polygon_triangles.h>
#include <isect/triangle_mesh.h>
#include "bench/full_precision.h"
#include "bench/ordinary_shapes.h"
#include "bench/random_obb.h"
#include "bench/random_shapes.h"

namespace isect::bench {

/// Where the numbers of a case come from. Directions are not lengths: their numbers are near one.
struct Source {
  Random& random;
  Numbers numbers = Numbers::ordinary;

  template <int N = 3>
  Vector<double, N> vector() {
    return bench::vector<double, N>(random, numbers);
  }
  template <int N = 3>
  Vector<double, N> direction() {
    const bool near_one = numbers == Numbers::ordinary || numbers == Numbers::nudged || numbers == Numbers::decimal;
    Vector<double, N> d;
    do d = bench::vector<double, N>(random, near_one ? numbers : Numbers::grid);
    while (d.isZero(0));
    return d;
  }
  double length() {
    if (numbers == Numbers::ordinary) return random.uniform(0.2, 0.8);
    return numbers == Numbers::distant ? random.integer(0, 8) : std::abs(number<double>(random, numbers));
  }
};

/// A convex solid as its planes bound it, normal.x + d >= 0: in the usual form, with its corners, and in the core's
/// form.
struct Body {
  std::vector<Plane<double, 3>> planes;
  std::vector<Point<double, 3>> corners;          ///< rounded
  std::vector<Vector<double, 3>> normals, edges;  ///< no two of one direction
  HalfSpaces core;
};

inline std::string full_precision(const Body& x) {
  std::string all = "planes:";
  for (const Plane<double, 3>& plane : x.planes) (all += ' ') += full_precision(plane);
  return all;
}

/// A solid that is seen whole from its center, and bounded by the triangles: each of them makes a tetrahedron
/// with it, and these are the solid.
struct Star {
  Point<double, 3> center;
  TriangleMesh<double> mesh;
};

inline std::string full_precision(const Star& x) {
  std::string all = text("center", x.center);
  for (const Point<double, 3>& v : x.mesh.vertices) (all += ' ') += text("vertex", v);
  return all;
}

namespace pair_draws {

template <int N>
Point<double, N> drawn(Source s, const Point<double, N>*) {
  return s.vector<N>();
}
template <int N>
Segment<double, N> drawn(Source s, const Segment<double, N>*) {
  const Point<double, N> p = s.vector<N>();
  return {p, s.vector<N>()};
}
template <int N>
Ray<double, N> drawn(Source s, const Ray<double, N>*) {
  const Point<double, N> origin = s.vector<N>();
  return {origin, s.direction<N>()};
}
template <int N>
Plane<double, N> drawn(Source s, const Plane<double, N>*) {
  const Vector<double, N> normal = s.direction<N>();
  return {normal, -normal.dot(s.vector<N>())};
}
template <int N>
Sphere<double, N> drawn(Source s, const Sphere<double, N>*) {
  const Point<double, N> center = s.vector<N>();
  return {center, s.length()};
}
template <int N>
Capsule<double, N> drawn(Source s, const Capsule<double, N>*) {
  const Point<double, N> p = s.vector<N>(), q = s.vector<N>();
  return {p, q, s.length() / 2};
}
inline Cylinder<double> drawn(Source s, const Cylinder<double>*) {
  const Point<double, 3> p = s.vector(), q = s.vector();
  return {p, q, s.length() / 2};
}
inline Cone<double> drawn(Source s, const Cone<double>*) {
  const Point<double, 3> apex = s.vector(), base = s.vector();
  return {apex, base, s.length()};
}
template <int N>
Aabb<double, N> drawn(Source s, const Aabb<double, N>*) {
  const Point<double, N> a = s.vector<N>(), b = s.vector<N>();
  return {a.cwiseMin(b), a.cwiseMax(b)};
}
inline Obb<double, 3> drawn(Source s, const Obb<double, 3>*) {
  if (s.numbers == Numbers::ordinary) return ordinary_obb<double>(s.random, 1);
  Obb<double, 3> box;
  box.center = s.vector();
  box.axes = permutation<double, 3>(s.random);
  if (s.random.one_in(2)) box.axes = box.axes * rotation<double, 3>(s.random, 3);
  for (double& h : box.half) h = s.length();
  return box;
}
inline Kdop<double, 3> drawn(Source s, const Kdop<double, 3>*) {
  Kdop<double, 3> k = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, -1, 1}}, {}};
  if (s.numbers == Numbers::ordinary)
    for (Vector<double, 3>& n : k.normals) n = s.random.heading<3>();
  const Point<double, 3> center = s.vector();
  for (const Vector<double, 3>& n : k.normals) {
    const double lo = n.dot(center) - s.length();
    k.slabs.push_back({lo, lo + 2 * s.length()});
  }
  return k;
}
inline Triangle<double, 3> drawn(Source s, const Triangle<double, 3>*) {
  for (;;) {
    const Point<double, 3> a = s.vector(), b = s.vector(), c = s.vector();
    // at the size of one, so that the area does not vanish
    const double size = std::max({(b - a).cwiseAbs().maxCoeff(), (c - a).cwiseAbs().maxCoeff(), 1e-300});
    if (Vector<double, 3>((b - a) / size).cross(Vector<double, 3>((c - a) / size)).norm() > 1e-3) return {{a, b, c}};
  }
}
/// A pyramid that is cut off.
inline Frustum<double> drawn(Source s, const Frustum<double>*) {
  const Point<double, 3> eye = s.vector();
  std::array<Vector<double, 3>, 5> n = {{{1, 0, 1}, {-1, 0, 1}, {0, 1, 2}, {0, -1, 2}, {0, 0, 1}}};
  if (s.numbers == Numbers::ordinary)
    for (const Eigen::Matrix3d turn = rotation<double, 3>(s.random, 3); Vector<double, 3> & v : n) v = turn * v;
  const double near = s.length() / 2, far = near + s.length() * 2;
  const auto plane = [&](const Vector<double, 3>& v, double d) { return Plane<double, 3>{v, d - v.dot(eye)}; };
  return {{plane(n[0], 0), plane(n[1], 0), plane(n[2], 0), plane(n[3], 0), plane(n[4], -near), plane(-n[4], far)}};
}

/// The directions, keeping one of each set that differs in length and sign only.
inline std::vector<Vector<double, 3>> once(const std::vector<Vector<double, 3>>& all) {
  std::vector<Vector<double, 3>> kept;
  for (const Vector<double, 3>& v : all) {
    const auto parallel = [&](const Vector<double, 3>& w) { return v.cross(w).norm() <= 1e-9 * v.norm() * w.norm(); };
    if (v.norm() > 1e-9 && std::ranges::none_of(kept, parallel)) kept.push_back(v);
  }
  return kept;
}
/// The solid that the planes bound, in every form that the methods need.
inline Body body(const std::vector<Plane<double, 3>>& planes) {
  Body made = {planes, {}, {}, {}, {}};
  for (const Plane<double, 3>& p : planes) {
    made.core.faces.push_back({half_spaces::Level{p.normal, p.d}});
    made.normals.push_back(p.normal);
  }
  made.normals = once(made.normals);
  std::vector<Vector<double, 3>> along;
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      const Vector<double, 3> edge = planes[i].normal.cross(planes[j].normal);
      bool bounds = false;
      for (std::size_t k = 0; k < planes.size(); ++k) {
        const double determinant = edge.dot(planes[k].normal);
        if (k == i || k == j || std::abs(determinant) < 1e-9) continue;
        const Point<double, 3> x = -(planes[k].d * edge + planes[i].d * planes[j].normal.cross(planes[k].normal) +
                                     planes[j].d * planes[k].normal.cross(planes[i].normal)) /
                                   determinant;
        const auto holds = [&](const Plane<double, 3>& p) {
          return p.normal.dot(x) + p.d >= -1e-12 * (std::abs(p.d) + p.normal.cwiseAbs().dot(x.cwiseAbs()));
        };
        if (!std::ranges::all_of(planes, holds)) continue;
        bounds = true;
        if (k > j) made.corners.push_back(x);
      }
      if (bounds) along.push_back(edge);
    }
  made.edges = once(along);
  return made;
}
inline Body drawn(Source s, const Body*) {
  std::vector<Plane<double, 3>> planes;
  const Kdop<double, 3> k = drawn(s, static_cast<const Kdop<double, 3>*>(nullptr));
  for (std::size_t i = 0; i < k.normals.size(); ++i)
    planes.push_back({k.normals[i], -k.slabs[i].lo}), planes.push_back({-k.normals[i], k.slabs[i].hi});
  const Body made = body(planes);
  return made.corners.empty() ? drawn(s, static_cast<const Body*>(nullptr)) : made;
}

/// An octahedron with each corner at its own distance from the center.
inline Star drawn(Source s, const Star*) {
  Star made;
  made.center = s.vector();
  const Eigen::Matrix3d turn =
      s.numbers == Numbers::ordinary ? rotation<double, 3>(s.random, 3) : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  for (int i = 0; i < 6; ++i) {
    double far = 0;
    while (far == 0) far = s.length();
    made.mesh.vertices.push_back(made.center + (i % 2 == 0 ? far : -far) * turn.col(i / 2));
  }
  for (const int x : {0, 1})
    for (const int y : {2, 3})
      for (const int z : {4, 5})
        made.mesh.triangles.push_back((x + y + z) % 2 == 0 ? std::array{x, y, z} : std::array{y, x, z});
  for (int i = 0; i < 3; ++i)  // rounding may leave nothing between the center and a corner
    if (made.mesh.vertices[2 * i] == made.center || made.mesh.vertices[2 * i + 1] == made.center)
      return drawn(s, static_cast<const Star*>(nullptr));
  return made;
}

/// The hull of a few points, with a volume.
inline Hull3<double> drawn(Source s, const Hull3<double>*) {
  for (;;) {
    std::vector<Point<double, 3>> points;
    for (int i = s.random.integer(4, 7); i > 0; --i) points.push_back(s.vector());
    Hull3<double> hull = convex_hull(points);
    if (hull.dimension == 3) return hull;
  }
}

/// Corners around a center, in order, nearer and farther from it.
inline Ring<double, 2> outline(Source s) {
  Ring<double, 2> ring;
  if (s.numbers != Numbers::ordinary) {
    for (int i = s.random.integer(3, 6); i > 0; --i) ring.push_back(s.vector<2>());
    return ring;
  }
  const Point<double, 2> center = s.random.in_box<2>(0.5);
  for (int i = 0, n = s.random.integer(4, 9); i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    ring.push_back(center + s.random.uniform(0.3, 1) * Vector<double, 2>(std::cos(angle), std::sin(angle)));
  }
  return ring;
}
inline Polygon<double, 2> drawn(Source s, const Polygon<double, 2>*) { return {{outline(s)}}; }
/// A polygon in one plane up to rounding: along a coordinate plane, or slanted.
inline Polygon<double, 3> drawn(Source s, const Polygon<double, 3>*) {
  const double slope = s.numbers == Numbers::ordinary ? s.random.uniform(-1, 1) : s.random.integer(-1, 1);
  const double height = s.vector()[0];
  Ring<double, 3> ring;
  for (const Point<double, 2>& v : outline(s)) ring.emplace_back(v[0], v[1], height + slope * (v[0] - v[1]));
  return {{ring}};
}
inline TriangulatedPolygon<double> drawn(Source s, const TriangulatedPolygon<double>*) {
  for (;;)
    if (auto made = triangulated(drawn(s, static_cast<const Polygon<double, 3>*>(nullptr)).rings[0]); !empty(made))
      return made;
}
template <int N>
Ring<double, N> drawn(Source s, const Ring<double, N>*) {
  return drawn(s, static_cast<const Polygon<double, N>*>(nullptr)).rings[0];
}
template <class Shape>
Shape drawn(Source s) {
  return drawn(s, static_cast<const Shape*>(nullptr));
}

// Moves a shape by v.

template <int N>
void move(Point<double, N>& x, const Vector<double, N>& v) {
  x += v;
}
template <int N>
void move(Segment<double, N>& x, const Vector<double, N>& v) {
  x.p += v, x.q += v;
}
inline void move(Cylinder<double>& x, const Vector<double, 3>& v) { x.p += v, x.q += v; }
inline void move(Cone<double>& x, const Vector<double, 3>& v) { x.apex += v, x.base += v; }
template <int N>
void move(Ray<double, N>& x, const Vector<double, N>& v) {
  x.origin += v;
}
template <int N>
void move(Plane<double, N>& x, const Vector<double, N>& v) {
  x.d -= x.normal.dot(v);
}
template <int N>
void move(Sphere<double, N>& x, const Vector<double, N>& v) {
  x.center += v;
}
template <int N>
void move(Capsule<double, N>& x, const Vector<double, N>& v) {
  x.p += v, x.q += v;
}
template <int N>
void move(Aabb<double, N>& x, const Vector<double, N>& v) {
  x.lo += v, x.hi += v;
}
inline void move(Triangle<double, 3>& x, const Vector<double, 3>& v) {
  for (Point<double, 3>& p : x.vertices) p += v;
}
inline void move(Body& x, const Vector<double, 3>& v) {
  for (Plane<double, 3>& p : x.planes) move(p, v);
  for (std::size_t i = 0; i < x.planes.size(); ++i)
    x.core.faces[i] = {half_spaces::Level{x.planes[i].normal, x.planes[i].d}};
  for (Point<double, 3>& p : x.corners) p += v;
}
inline void move(Star& x, const Vector<double, 3>& v) {
  x.center += v;
  for (Point<double, 3>& p : x.mesh.vertices) p += v;
}
template <int N>
void move(Ring<double, N>& x, const Vector<double, N>& v) {
  for (Point<double, N>& p : x) p += v;
}
inline void move(TriangulatedPolygon<double>& x, const Vector<double, 3>& v) {
  move(x.outline, v);
  x = triangulated(x.outline);  // rounding may fold it
}

template <class Shape>
constexpr int dimension = 3;
template <>
inline constexpr int dimension<Ring<double, 2>> = 2;
template <>
inline constexpr int dimension<Sphere<double, 2>> = 2;
template <>
inline constexpr int dimension<Capsule<double, 2>> = 2;
template <>
inline constexpr int dimension<Aabb<double, 2>> = 2;
template <>
inline constexpr int dimension<Segment<double, 2>> = 2;
template <>
inline constexpr int dimension<Ray<double, 2>> = 2;

/// Draws a before b, since the order in which arguments are evaluated is unspecified.
template <class A, class B>
Pair<A, B> pair(Source s) {
  A a = drawn<A>(s);
  return {std::move(a), drawn<B>(s)};
}
template <class A, class B, Numbers numbers>
Pair<A, B> of_numbers(Random& random) {
  return pair<A, B>({random, numbers});
}
/// So large that squares overflow, or so small that they vanish.
template <class A, class B>
Pair<A, B> scale(Random& random) {
  return pair<A, B>({random, random.one_in(2) ? Numbers::huge : Numbers::tiny});
}

/// Two shapes where the answer changes: the first one moves along a line, and the change is bisected 52 times.
template <class A, class B, class Answer>
Pair<A, B> at_the_edge(Random& random, const Answer& answer) {
  for (int tries = 0; tries < 1000; ++tries) {
    const Pair<A, B> from = pair<A, B>({random});
    const Vector<double, dimension<A>> way = random.in_box<dimension<A>>(3);
    const auto moved_by = [&](double t) {
      Pair<A, B> c = from;
      move(c.a, Vector<double, dimension<A>>(t * way));
      return c;
    };
    double lo = 0, hi = 1;
    const auto at_lo = answer(from);
    if (answer(moved_by(1)) == at_lo) continue;
    for (int i = 0; i < 52; ++i) {
      const double middle = lo + (hi - lo) / 2;
      (answer(moved_by(middle)) == at_lo ? lo : hi) = middle;
    }
    return moved_by(random.one_in(2) ? lo : hi);
  }
  return pair<A, B>({random});
}

}  // namespace pair_draws

}  // namespace isect::bench
