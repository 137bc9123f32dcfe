#pragma once
// k-DOP against k-DOP with the same normals.
//
// Where the intervals of one slab are disjoint, a plane across that normal parts the two: they are disjoint for
// certain. Where all overlap, the k-DOPs may still be disjoint, parted along a direction other than their
// normals: "may" is all that the test says, and all that a bounding volume needs. Only inputs are compared: exact
// for free.
//
// Whether touching objects have touching slabs was decided when their k-DOPs were built. With normals such as (1, 1,
// 0) the products of grid coordinates are exact, and so are the ends. Divided by sqrt 2 they round, each object's in
// its own way, and a quarter of exact touches comes apart.
//
// Source: the note, N08; Klosowski, Held, Mitchell, Sowizral, Zikan, Efficient collision detection using bounding
// volume hierarchies of k-DOPs, IEEE TVCG 4 (1998).

#include <optional>
#include <variant>

#include <isect/interval_interval.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace kdop_kdop {

/// One slab of each; the first disjoint pair ends the test.
template <class S>
struct Slab {
  int slab;
  Interval<S> a, b;
  bool disjoint;
};
template <class S>
using Event = std::variant<Slab<S>>;

namespace detail {

/// The first slab whose intervals are disjoint, or one of which is empty or NaN.
template <class S, int N, class Trace>
std::optional<int> first_apart(const Kdop<S, N>& a, const Kdop<S, N>& b, Trace&& trace) {
  for (std::size_t i = 0; i < a.slabs.size(); ++i) {
    const bool disjoint = !intersects(a.slabs[i], b.slabs[i]);
    if constexpr (heard<Trace>) trace(Slab<S>{static_cast<int>(i), a.slabs[i], b.slabs[i], disjoint});
    if (disjoint) return static_cast<int>(i);
  }
  return {};
}

}  // namespace detail

}  // namespace kdop_kdop

/// Whether the k-DOPs may have a common point: false is certain, true only possible. The normals of both must be the
/// same, in the same order. An empty slab, NaN or an infinite coordinate: no.
template <class S, int N, class Trace = NoTrace>
bool may_intersect(const Kdop<S, N>& a, const Kdop<S, N>& b, Trace&& trace = {}) {
  return !kdop_kdop::detail::first_apart(a, b, trace) && finite(a) && finite(b);
}

}  // namespace isect
