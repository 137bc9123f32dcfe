#pragma once
// The side of a line, or of a plane, that a point is on: the predicate that most others are made of.
//
// Source: Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric predicates, Discrete
// Comput. Geom. 18 (1997).

#include <variant>

#include <isect/numbers/predicate.h>
#include <isect/shapes.h>

namespace isect {

namespace orient {

/// Fallback is reported to anyone; operations and stages, to a listener that derives from HearsOperations and
/// HearsStages.
using Event = std::variant<Operation, Stage, Fallback>;

namespace detail {

/// Twice the signed area of a b c.
template <PolynomialScalar W>
ISECT_INLINE W area2(const Point<double, 2>& a, const Point<double, 2>& b, const Point<double, 2>& c) {
  return difference<W>(a[0], c[0]) * difference<W>(b[1], c[1]) - difference<W>(a[1], c[1]) * difference<W>(b[0], c[0]);
}

/// Six times the signed volume of a b c d.
template <PolynomialScalar W>
W volume6(const Point<double, 3>& a, const Point<double, 3>& b, const Point<double, 3>& c, const Point<double, 3>& d) {
  return dot(difference<W>(a, d), cross(difference<W>(b, d), difference<W>(c, d)));
}

}  // namespace detail

}  // namespace orient

/// +1 when a, b, c turn counter-clockwise, -1 clockwise, 0 on one line. Exact; finite arguments.
template <class Trace = NoTrace>
int orient2d(const Point<double, 2>& a, const Point<double, 2>& b, const Point<double, 2>& c, Trace&& trace = {}) {
  return sign_of([&]<class W>() -> W { return orient::detail::area2<W>(a, b, c); }, trace);
}

/// +1 when d lies below the plane of a, b, c, which turn counter-clockwise seen from above; -1 above; 0 in it. Exact;
/// finite arguments.
template <class Trace = NoTrace>
int orient3d(const Point<double, 3>& a, const Point<double, 3>& b, const Point<double, 3>& c, const Point<double, 3>& d,
             Trace&& trace = {}) {
  return sign_of([&]<class W>() -> W { return orient::detail::volume6<W>(a, b, c, d); }, trace);
}

}  // namespace isect
