#pragma once
// Where a ray meets a polygon in space, in rationals.

#include <algorithm>
#include <vector>

#include "bench/rational.h"

namespace isect::oracle {

/// What a ray and a polygon truly have in common.
struct RayPolygon {
  bool flat = false, coplanar = false, parallel = true;
  Location location = Location::out;
  Rational t;
  bool hit = false;
};

using P2 = Coordinates<2>;

/// The location: on an edge by a parameter; else by counting the edges whose crossing with the line y = p.y, a
/// quotient, is right of p.
inline Location locate(const P2& p, const std::vector<P2>& ring) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const P2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if (a[1] == b[1]) {
      if (p[1] == a[1] && std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0])) return Location::on;
      continue;
    }
    const Rational k = (p[1] - a[1]) / (b[1] - a[1]), x = a[0] + k * (b[0] - a[0]);
    if (0 <= k && k <= 1 && x == p[0]) return Location::on;
    if ((a[1] <= p[1]) != (b[1] <= p[1]) && x > p[0]) inside = !inside;
  }
  return inside ? Location::in : Location::out;
}

/// Where a point lies in several rings, by the even-odd rule.
inline Location locate(const P2& p, const std::vector<std::vector<P2>>& rings) {
  bool inside = false;
  for (const std::vector<P2>& ring : rings) {
    const Location where = locate(p, ring);
    if (where == Location::on) return Location::on;
    inside ^= where == Location::in;
  }
  return inside ? Location::in : Location::out;
}

/// The axis of the largest component.
inline int steepest(const Coordinates<3>& n) {
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (abs(n[k]) > abs(n[axis])) axis = k;
  return axis;
}
/// Newell's form, by trapezoids.
inline Coordinates<3> newell(const std::vector<Coordinates<3>>& v) {
  Coordinates<3> n = {0, 0, 0};
  for (std::size_t i = 0; i < v.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const auto &a = v[i], &b = v[(i + 1) % v.size()];
      n[k] += (a[(k + 1) % 3] - b[(k + 1) % 3]) * (a[(k + 2) % 3] + b[(k + 2) % 3]);
    }
  return n;
}

/// Uses Newell's plane, and the outline without the coordinate of its largest component. For finite shapes.
template <class S>
RayPolygon ray_polygon(const Coordinates<3>& o, const Coordinates<3>& d, const Interval<S>& range,
                       const Ring<S, 3>& ring) {
  RayPolygon result;
  std::vector<Coordinates<3>> v;
  for (const Point<S, 3>& x : ring) v.push_back(rational<S, 3>(x));
  const Coordinates<3> n = newell(v);
  result.flat = dot(n, n) == 0;
  if (result.flat) return result;
  const Rational at_0 = dot(n, o - v[0]), at_1 = dot(n, o + d - v[0]);
  result.parallel = at_0 == at_1;
  result.coplanar = result.parallel && at_0 == 0;
  if (result.parallel) return result;

  result.t = at_0 / (at_0 - at_1);
  const auto p = o + result.t * d;
  const int axis = steepest(n), x = axis == 0 ? 1 : 0, y = axis == 2 ? 1 : 2;
  std::vector<P2> outline;
  for (const auto& q : v) outline.push_back({q[x], q[y]});
  result.location = locate({p[x], p[y]}, outline);
  result.hit = result.location != Location::out && holds(range, result.t);
  return result;
}
template <class S>
RayPolygon ray_polygon(const Ray<S, 3>& ray, const Ring<S, 3>& ring) {
  return ray_polygon(rational<S, 3>(ray.origin), rational<S, 3>(ray.direction), ray.range, ring);
}

}  // namespace isect::oracle
