#pragma once
// Two convex solids in naive code with doubles: an axis among the normals of faces, and what is at right angles to an
// edge of each, along which they do not overlap (Gottschalk, 1996).

#include <array>
#include <limits>
#include <vector>

#include <isect/shapes.h>

namespace isect::bench {

template <class Points, class Directions>
struct Convex {
  const Points& corners;
  const Directions &normals, &edges;
};
template <class Points, class Directions>
Convex(const Points&, const Directions&, const Directions&) -> Convex<Points, Directions>;

template <class Points>
Interval<double> shadow(const Points& corners, const Vector<double, 3>& axis) {
  Interval<double> of = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Point<double, 3>& x : corners) {
    const double height = axis.dot(x);
    of.lo = std::min(of.lo, height), of.hi = std::max(of.hi, height);
  }
  return of;
}

template <class A, class B>
bool separated(const A& a, const B& b) {
  const auto along = [&](const Vector<double, 3>& axis) {
    const Interval<double> p = shadow(a.corners, axis), q = shadow(b.corners, axis);
    return p.lo > q.hi || q.lo > p.hi;
  };
  for (const Vector<double, 3>& n : a.normals)
    if (along(n)) return true;
  for (const Vector<double, 3>& n : b.normals)
    if (along(n)) return true;
  for (const Vector<double, 3>& e : a.edges)
    for (const Vector<double, 3>& f : b.edges)
      if (along(e.cross(f))) return true;
  return false;
}

/// A triangle, which has faces on both sides and, for others in its plane, at its edges.
struct FlatConvex {
  std::array<Point<double, 3>, 3> corners;
  std::array<Vector<double, 3>, 4> normals;
  std::array<Vector<double, 3>, 3> edges;
};
inline FlatConvex convex(const Triangle<double, 3>& x) {
  const auto& [a, b, c] = x.vertices;
  FlatConvex made = {x.vertices, {}, {b - a, c - b, a - c}};
  made.normals[0] = made.edges[0].cross(made.edges[1]);
  for (std::size_t i = 0; i < 3; ++i) made.normals[i + 1] = made.normals[0].cross(made.edges[i]);
  return made;
}

}  // namespace isect::bench
