#pragma once
// How a triangle and a box lie: by what clipping leaves of the triangle, in rationals.

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

#include "bench/rational.h"

namespace isect::oracle::triangle_aabb {

template <int N>
using Corners = std::vector<Coordinates<N>>;

/// The part with side (x_axis - limit) >= 0, by Sutherland and Hodgman's method.
template <int N>
std::type_identity_t<Corners<N>> clipped(const Corners<N>& polygon, int axis, const Rational& limit, int side) {
  Corners<N> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Rational from = side * (p[axis] - limit), to = side * (q[axis] - limit);
    if (from >= 0) result.push_back(p);
    if ((from > 0 && to < 0) || (from < 0 && to > 0)) result.push_back(p + Rational(from / (from - to)) * (q - p));
  }
  return result;
}

/// The corners of what triangle and box have in common; both finite.
template <class S, int N>
Corners<N> common(const Triangle<S, N>& triangle, const Aabb<S, N>& box) {
  Corners<N> polygon;
  for (const Point<S, N>& v : triangle.vertices) polygon.push_back(rational<S, N>(v));
  for (int k = 0; k < N; ++k) {
    polygon = clipped<N>(polygon, k, Rational(box.lo[k]), 1);
    polygon = clipped<N>(polygon, k, Rational(box.hi[k]), -1);
  }
  return polygon;
}

/// Whether the common part reaches into the box's interior: its centroid does if any point does.
template <class S, int N>
bool reaches_inside(const std::type_identity_t<Corners<N>>& part, const Aabb<S, N>& box) {
  Coordinates<N> sum = part[0];
  for (std::size_t i = 1; i < part.size(); ++i) sum = sum + part[i];
  for (int k = 0; k < N; ++k) {
    const Rational x = sum[k] / part.size();
    if (x <= Rational(box.lo[k]) || x >= Rational(box.hi[k])) return false;
  }
  return true;
}

/// Whether some point of the common part is interior to both: its centroid is, if any point is.
template <class S, int N>
bool interiors_meet(const std::type_identity_t<Corners<N>>& part, const Triangle<S, N>& triangle,
                    const Aabb<S, N>& box) {
  Coordinates<N> x = part[0];
  for (std::size_t i = 1; i < part.size(); ++i) x = x + part[i];
  x = (Rational(1) / static_cast<int>(part.size())) * x;
  for (int k = 0; k < N; ++k) {
    const Rational lo = box.lo[k], hi = box.hi[k];
    if (lo == hi ? x[k] != lo : x[k] <= lo || x[k] >= hi) return false;
  }
  const Coordinates<N> origin = rational<S, N>(triangle.vertices[0]);
  const Coordinates<N> a = rational<S, N>(triangle.vertices[1]) - origin,
                       b = rational<S, N>(triangle.vertices[2]) - origin, w = x - origin;
  const Rational aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), d = aa * bb - ab * ab;
  if (d != 0) {
    const Rational s = dot(w, a) * bb - dot(w, b) * ab, t = dot(w, b) * aa - dot(w, a) * ab;
    return s > 0 && t > 0 && s + t < d;
  }
  const Coordinates<N>& along = aa > bb ? a : b;  // a segment or a point
  const auto [lo, hi] = std::minmax({Rational(0), dot(a, along), dot(b, along)});
  return lo == hi || (lo < dot(w, along) && dot(w, along) < hi);
}

template <class S, int N>
Relation relation(const Triangle<S, N>& triangle, const Aabb<S, N>& box) {
  const Corners<N> part = common(triangle, box);
  if (part.empty()) return Relation::disjoint;
  bool a_in_b = true, b_in_a = true;
  for (const Point<S, N>& v : triangle.vertices) a_in_b &= !common<S, N>({{v, v, v}}, box).empty();
  for (int corner = 0; corner < 1 << N; ++corner) {
    Point<S, N> c;
    for (int k = 0; k < N; ++k) c[k] = corner & (1 << k) ? box.hi[k] : box.lo[k];
    b_in_a &= !common<S, N>(triangle, {c, c}).empty();
  }
  if (a_in_b && b_in_a) return Relation::equal;
  if (a_in_b || b_in_a) return a_in_b ? Relation::a_inside_b : Relation::b_inside_a;
  return interiors_meet(part, triangle, box) ? Relation::overlapping : Relation::touching;
}

}  // namespace isect::oracle::triangle_aabb
