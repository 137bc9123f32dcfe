#pragma once
// Point against k-DOP: n.x against both ends of every slab lo <= n.x <= hi.
//
// With normals and points on a grid the products are exact; else rounding could move a point across a slanted plane,
// so each comparison is the sign of a polynomial, n.x - lo or n.x - hi. Source: the note, N08.

#include <cassert>
#include <variant>

#include <isect/numbers/predicate.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace point_kdop {

/// One slab: the signs of n.x - lo and n.x - hi. The first that shuts the point out ends the test.
struct Slab {
  int slab, from_lo, from_hi;
};
using Event = std::variant<Slab, Fallback>;

namespace detail {

/// The sign of n.x - end.
template <int N, class Trace>
int beyond(const Vector<double, N>& normal, const Point<double, N>& point, double end, Trace&& trace) {
  return sign_of([&]<class W>() -> W { return dot(exactly<W>(normal), exactly<W>(point)) - W(end); }, trace);
}

}  // namespace detail

}  // namespace point_kdop

/// Where the point lies: `on` when it lies in the k-DOP and in the plane of some face. Exact. A zero normal makes no
/// face: its slab is all of space when it holds 0, and empty otherwise. An empty slab, NaN or an infinite coordinate:
/// out. There must be as many slabs as normals; with none, every point is `in`.
template <class S, int N, class Trace = NoTrace>
Location locate(const Point<S, N>& point, const Kdop<S, N>& kdop, Trace&& trace = {}) {
  assert(kdop.normals.size() == kdop.slabs.size());
  if (empty(kdop) || !finite(kdop) || !finite(point)) return Location::out;
  const Point<double, N> x = point.template cast<double>();

  Location location = Location::in;
  for (std::size_t i = 0; i < kdop.slabs.size(); ++i) {
    const Vector<double, N> normal = kdop.normals[i].template cast<double>();
    const Interval<double> slab = cast<double>(kdop.slabs[i]);

    const int from_lo = point_kdop::detail::beyond<N>(normal, x, slab.lo, trace);
    const int from_hi = point_kdop::detail::beyond<N>(normal, x, slab.hi, trace);
    trace(point_kdop::Slab{static_cast<int>(i), from_lo, from_hi});

    if (from_lo < 0 || from_hi > 0) return Location::out;
    const bool in_face_plane = from_lo == 0 || from_hi == 0;
    if (in_face_plane && !normal.isZero(0)) location = Location::on;
  }
  return location;
}

}  // namespace isect
