#pragma once
// Shapes are plain aggregates over a scalar S and a dimension N. All are closed sets.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <isect/interval.h>

namespace isect {

template <class S, int N>
using Vector = Eigen::Matrix<S, N, 1>;
template <class S, int N>
using Point = Eigen::Matrix<S, N, 1>;

/// The points origin + t direction with t in the closed `range`: a ray by default, a segment when both ends are
/// finite, a line when neither is. The direction may have any length; t is measured in it. Source: the note, N16.
template <class S, int N>
struct Ray {
  static_assert(is_scalar<S>());
  Point<S, N> origin;
  Vector<S, N> direction;
  Interval<S> range = semi_infinite<S>;

  /// Each coordinate within eps (|o_i| + |t d_i|) and the least number of S, where t d_i is not beyond the largest.
  Point<S, N> at(const S& t) const { return origin + t * direction; }
};

/// The segment from p to q, both included: t = 0 at p, t = 1 at q. The direction q - p is rounded; a test that has
/// to see both end points as they are takes a Segment.
template <class S, int N>
Ray<S, N> segment(const Point<S, N>& p, const Point<S, N>& q) {
  return {p, q - p, {S(0), S(1)}};
}
/// The line through p (t = 0) and q (t = 1).
template <class S, int N>
Ray<S, N> line_through(const Point<S, N>& p, const Point<S, N>& q) {
  return {p, q - p, infinite<S>};
}

/// The segment between two points as given; a point when they coincide.
template <class S, int N>
struct Segment {
  static_assert(is_scalar<S>());
  Point<S, N> p, q;
};

/// The points x with normal.x + d = 0, and the two half-spaces beside it. The normal may have any length but 0.
/// Source: the note, N20.
template <class S, int N>
struct Plane {
  static_assert(is_scalar<S>());
  Vector<S, N> normal;
  S d;
};

/// The closed ball around `center`; empty when radius < 0. Its surface is the sphere proper.
template <class S, int N>
struct Sphere {
  static_assert(is_scalar<S>());
  Point<S, N> center;
  S radius;
};

/// The points within `radius` of the segment from p to q; empty when radius < 0, a ball when p equals q.
template <class S, int N>
struct Capsule {
  static_assert(is_scalar<S>());
  Point<S, N> p, q;
  S radius;
};

/// The points within `radius` of the line through p and q and between the planes across it through p and q; in space.
/// Empty when radius < 0, or when p equals q, through which there is no one line; a segment when the radius is 0.
template <class S>
struct Cylinder {
  static_assert(is_scalar<S>());
  Point<S, 3> p, q;
  S radius;
};

/// The convex hull of `apex` and of the disc around `base`, across the line through both; in space. Empty when
/// radius < 0, or when apex equals base, through which there is no one line; a segment when the radius is 0.
template <class S>
struct Cone {
  static_assert(is_scalar<S>());
  Point<S, 3> apex, base;
  S radius;
};

/// The axis-aligned box lo_i <= x_i <= hi_i; empty when lo_i > hi_i for some i. Source: the note, N06.
template <class S, int N>
struct Aabb {
  static_assert(is_scalar<S>());
  Point<S, N> lo, hi;

  Interval<S> along(int axis) const { return {lo[axis], hi[axis]}; }
};

/// The box { center + sum s_i u_i, |s_i| <= half_i }, where u_i is column i of `axes`, taken literally: they need
/// neither be of unit length nor quite orthogonal (what is rounded never is), but must be independent. Empty when
/// some half_i < 0. Source: the note, N07.
template <class S, int N>
struct Obb {
  static_assert(is_scalar<S>());
  Point<S, N> center;
  Eigen::Matrix<S, N, N> axes;
  Vector<S, N> half;
};

/// The points x with slabs_i.lo <= normals_i.x <= slabs_i.hi for every i; empty when some lo > hi. The normals may
/// have any length: integer ones such as (1, 1, 0) keep touching exact. Source: the note, N08, with the sign turned.
template <class S, int N>
struct Kdop {
  static_assert(is_scalar<S>());
  std::vector<Vector<S, N>> normals;
  std::vector<Interval<S>> slabs;
};

template <class S, int N>
struct Triangle {
  static_assert(is_scalar<S>());
  std::array<Point<S, N>, 3> vertices;
};

/// A closed chain of vertices, the first not repeated at the end. Any orientation, and any number of vertices.
template <class S, int N>
using Ring = std::vector<Point<S, N>>;

/// One ring, or several: holes and islands, by the fill rule. In 3D all lie in one plane, nearly.
template <class S, int N>
struct Polygon {
  static_assert(is_scalar<S>());
  std::vector<Ring<S, N>> rings;
};

/// The points with normal.x + d >= 0 for all six planes: left, right, bottom, top, near, far.
template <class S>
struct Frustum {
  std::array<Plane<S, 3>, 6> planes;
};

// Whether every coordinate is finite. The tests check it first. Where a vector is looked at number by number, here and
// elsewhere in the core, and not by an expression of Eigen's, that is to spare compilers hundreds of small functions.

template <class S>
bool finite(const Interval<S>& x) {
  return std::isfinite(x.lo) && std::isfinite(x.hi);
}
template <class S, int N, int M>
bool finite(const Eigen::Matrix<S, N, M>& x) {
  if constexpr (M > 1) return (x - x).sum() == S(0);  // x - x is 0, or NaN; without branches
  return [&]<int... i>(std::integer_sequence<int, i...>) { return ((x.data()[i] - x.data()[i]) + ...) == S(0); }
  (std::make_integer_sequence<int, N>());
}
/// The range may be infinite, but not NaN.
template <class S, int N>
bool finite(const Ray<S, N>& x) {
  return finite(x.origin) && finite(x.direction) && !std::isnan(x.range.lo) && !std::isnan(x.range.hi);
}
template <class S, int N>
bool finite(const Segment<S, N>& x) {
  return finite(x.p) && finite(x.q);
}
template <class S, int N>
bool finite(const Plane<S, N>& x) {
  return finite(x.normal) && std::isfinite(x.d);
}
template <class S, int N>
bool finite(const Sphere<S, N>& x) {
  return finite(x.center) && std::isfinite(x.radius);
}
template <class S, int N>
bool finite(const Capsule<S, N>& x) {
  return finite(x.p) && finite(x.q) && std::isfinite(x.radius);
}
template <class S>
bool finite(const Cylinder<S>& x) {
  return finite(x.p) && finite(x.q) && std::isfinite(x.radius);
}
template <class S>
bool finite(const Cone<S>& x) {
  return finite(x.apex) && finite(x.base) && std::isfinite(x.radius);
}
template <class S, int N>
bool finite(const Aabb<S, N>& x) {
  return finite(x.lo) && finite(x.hi);
}
template <class S, int N>
bool finite(const Obb<S, N>& x) {
  return finite(x.center) && finite(x.axes) && finite(x.half);
}
template <class S>
bool finite(const Frustum<S>& x) {
  for (const Plane<S, 3>& plane : x.planes)
    if (!finite(plane)) return false;
  return true;
}
template <class S, int N>
bool finite(const Kdop<S, N>& x) {
  Vector<S, N> normals = Vector<S, N>::Zero();
  S lo = 0, hi = 0;
  for (const Vector<S, N>& n : x.normals) normals += n;
  for (const Interval<S>& slab : x.slabs) lo += slab.lo, hi += slab.hi;
  if (finite(normals) && std::isfinite(lo) && std::isfinite(hi)) [[likely]]
    return true;

  for (const Vector<S, N>& n : x.normals)  // the sums may also have overflowed
    if (!finite(n)) return false;
  for (const Interval<S>& slab : x.slabs)
    if (!finite(slab)) return false;
  return true;
}
template <class S, int N>
bool finite(const Triangle<S, N>& x) {
  return finite(x.vertices[0]) && finite(x.vertices[1]) && finite(x.vertices[2]);
}
template <class S, int N>
bool finite(const Ring<S, N>& x) {
  for (const Point<S, N>& p : x)
    if (!finite(p)) return false;
  return true;
}

/// Whether every component is 0.
template <class S, int N>
bool is_zero(const Eigen::Matrix<S, N, 1>& x) {
  bool all = true;
  for (int i = 0; i < N; ++i) all &= x[i] == 0;
  return all;
}

// Whether a shape has no point. A NaN makes it empty too, as no comparison with it holds.

template <class S>
bool empty(const Interval<S>& x) {
  return !(x.lo <= x.hi);
}
template <class S, int N>
bool empty(const Sphere<S, N>& x) {
  return !(x.radius >= 0);
}
template <class S, int N>
bool empty(const Capsule<S, N>& x) {
  return !(x.radius >= 0);
}
template <class S>
bool empty(const Cylinder<S>& x) {
  return !(x.radius >= 0) || x.p == x.q;
}
template <class S>
bool empty(const Cone<S>& x) {
  return !(x.radius >= 0) || x.apex == x.base;
}
template <class S, int N>
bool empty(const Aabb<S, N>& x) {
  bool in_order = true;
  for (int i = 0; i < N; ++i) in_order &= x.lo[i] <= x.hi[i];
  return !in_order;
}
/// Looks at each slab by itself: slabs that contradict each other are not noticed.
template <class S, int N>
bool empty(const Kdop<S, N>& x) {
  for (const Interval<S>& slab : x.slabs)
    if (empty(slab)) return true;
  return false;
}
template <class S, int N>
bool empty(const Obb<S, N>& x) {
  bool positive = true;
  for (int i = 0; i < N; ++i) positive &= x.half[i] >= 0;
  return !positive;
}

// Converts a shape to another scalar: float to double, which is exact, or double to float, which rounds.

template <class T, class S>
Interval<T> cast(const Interval<S>& x) {
  return {static_cast<T>(x.lo), static_cast<T>(x.hi)};
}
template <class T, class S, int N>
Ray<T, N> cast(const Ray<S, N>& x) {
  return {x.origin.template cast<T>(), x.direction.template cast<T>(), cast<T>(x.range)};
}
template <class T, class S, int N>
Segment<T, N> cast(const Segment<S, N>& x) {
  return {x.p.template cast<T>(), x.q.template cast<T>()};
}
template <class T, class S, int N>
Plane<T, N> cast(const Plane<S, N>& x) {
  return {x.normal.template cast<T>(), static_cast<T>(x.d)};
}
template <class T, class S, int N>
Sphere<T, N> cast(const Sphere<S, N>& x) {
  return {x.center.template cast<T>(), static_cast<T>(x.radius)};
}
template <class T, class S, int N>
Capsule<T, N> cast(const Capsule<S, N>& x) {
  return {x.p.template cast<T>(), x.q.template cast<T>(), static_cast<T>(x.radius)};
}
template <class T, class S>
Cylinder<T> cast(const Cylinder<S>& x) {
  return {x.p.template cast<T>(), x.q.template cast<T>(), static_cast<T>(x.radius)};
}
template <class T, class S>
Cone<T> cast(const Cone<S>& x) {
  return {x.apex.template cast<T>(), x.base.template cast<T>(), static_cast<T>(x.radius)};
}
template <class T, class S, int N>
Aabb<T, N> cast(const Aabb<S, N>& x) {
  return {x.lo.template cast<T>(), x.hi.template cast<T>()};
}
template <class T, class S, int N>
Obb<T, N> cast(const Obb<S, N>& x) {
  return {x.center.template cast<T>(), x.axes.template cast<T>(), x.half.template cast<T>()};
}
template <class T, class S, int N>
Triangle<T, N> cast(const Triangle<S, N>& x) {
  return {{x.vertices[0].template cast<T>(), x.vertices[1].template cast<T>(), x.vertices[2].template cast<T>()}};
}

/// The shape in doubles: itself, not a copy, if it is in doubles already.
template <template <class, int> class Shape, class S, int N>
decltype(auto) in_doubles(const Shape<S, N>& x) {
  if constexpr (std::is_same_v<S, double>)
    return (x);
  else
    return cast<double>(x);
}
template <template <class> class Shape, class S>
decltype(auto) in_doubles(const Shape<S>& x) {
  if constexpr (std::is_same_v<S, double>)
    return (x);
  else
    return cast<double>(x);
}

}  // namespace isect
