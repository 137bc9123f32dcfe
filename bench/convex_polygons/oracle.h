#pragma once
// How two convex polygons lie, in rationals: by the area of their common part, clipped edge by edge.

#include <vector>

#include <isect/point_convex_polygon.h>
#include "bench/rational.h"

namespace isect::oracle {

namespace convex_polygons {

using Vertices = std::vector<Coordinates<2>>;

inline Rational cross(const Coordinates<2>& a, const Coordinates<2>& b, const Coordinates<2>& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}
inline Rational area(const Vertices& v) {
  Rational sum = 0;
  for (std::size_t i = 0; i < v.size(); ++i) sum += cross({0, 0}, v[i], v[(i + 1) % v.size()]);
  return sum;
}
/// Clips by one closed half-plane after another (Sutherland, Hodgman).
inline Vertices clipped(Vertices v, const Vertices& by) {
  for (std::size_t i = 0; i < by.size(); ++i) {
    Vertices kept;
    for (std::size_t j = 0; j < v.size(); ++j) {
      const auto &p = v[j], &q = v[(j + 1) % v.size()];
      const Rational s = cross(by[i], by[(i + 1) % by.size()], p), t = cross(by[i], by[(i + 1) % by.size()], q);
      if (s >= 0) kept.push_back(p);
      if (sign(s) * sign(t) < 0) kept.push_back(p + Rational(s / (s - t)) * (q - p));
    }
    v = kept;
  }
  return v;
}
template <class S>
Vertices vertices(const ConvexPolygon<S>& polygon) {
  Vertices all;
  for (const Point<S, 2>& p : polygon.vertices) all.push_back(rational(p));
  return all;
}

}  // namespace convex_polygons

template <class S>
Relation relation(const ConvexPolygon<S>& a, const ConvexPolygon<S>& b) {
  using namespace convex_polygons;
  const Vertices v = vertices(a), w = vertices(b), common = clipped(v, w);
  if (common.empty()) return Relation::disjoint;
  const Rational shared = area(common), of_a = area(v), of_b = area(w);
  if (shared == of_a && shared == of_b) return Relation::equal;
  if (shared == of_a) return Relation::a_inside_b;
  if (shared == of_b) return Relation::b_inside_a;
  return shared == 0 ? Relation::touching : Relation::overlapping;
}

}  // namespace isect::oracle
