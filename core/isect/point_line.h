#pragma once
// Point beside a line, a ray or a segment: on it, in line with it beyond an end, or aside; in the plane on which side.
//
// With o the origin, d the direction and f = x - o, the point x is on the line iff f x d = 0; in the plane d x f > 0
// says that it lies on the left of it, seen along d. On the line it is at t = f.d / d.d, which is compared with the
// ends of the range multiplied out. Source: Shewchuk, Adaptive precision floating-point arithmetic and fast robust
// geometric predicates, Discrete & Computational Geometry 18 (1997), for the side.

#include <cmath>
#include <variant>

#include <isect/numbers/predicate.h>
#include <isect/parts/ray_range.h>
#include <isect/parts/straight.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

/// How a point lies to a line, a ray or a segment.
enum class Beside {
  on,      ///< on it
  before,  ///< on its line, but before its range begins
  beyond,  ///< on its line, but behind the range's end
  left,    ///< in the plane: off its line, on the left, seen along the direction
  right,   ///< in the plane: off its line, on the right
  aside    ///< in space: off its line; in the plane: off a point, a line without direction
};

namespace point_line {

/// The sign of d x (x - o) in the plane; in space 1 where it is not 0.
struct Side {
  int sign;
};
/// The signs of t - t_lo and t - t_hi, of a point on the line.
struct Along {
  int from_lo, from_hi;
};
using Event = std::variant<Side, Along, Fallback>;

namespace detail {

/// Component `i` of d x (x - o): in the plane there is one.
template <PolynomialScalar W, int N, bool ends>
W turn(const Straight<N, ends>& line, const Point<double, N>& point, int i) {
  const Components<W, N> d = line.template along<W>(), f = difference<W, N>(point, line.origin);
  const auto x = static_cast<std::size_t>(N == 2 ? 0 : (i + 1) % 3),
             y = static_cast<std::size_t>(N == 2 ? 1 : (i + 2) % 3);
  return d[x] * f[y] - d[y] * f[x];
}

template <int N, bool ends, class Trace>
Beside beside(const Straight<N, ends>& line, const Point<double, N>& point, Trace&& trace) {
  if (line.is_point()) return point == line.origin && ray_range::has_points(line.range) ? Beside::on : Beside::aside;
  int side = 0;
  for (int i = 0; i < (N == 2 ? 1 : 3) && side == 0; ++i)
    side = sign_of([&]<class W>() -> W { return turn<W, N>(line, point, i); }, trace);
  if (N == 3) side = std::abs(side);
  trace(Side{side});
  if (side != 0) return N == 3 ? Beside::aside : side > 0 ? Beside::left : Beside::right;

  const auto t = [&]<class W>() -> Ratio<W> {
    const Components<W, N> d = line.template along<W>();
    return {dot(difference<W, N>(point, line.origin), d), dot(d, d)};
  };
  const Along along = {ray_range::compare(t, 1, line.range.lo, trace), ray_range::compare(t, 1, line.range.hi, trace)};
  trace(along);
  return along.from_lo < 0 ? Beside::before : along.from_hi > 0 ? Beside::beyond : Beside::on;
}

}  // namespace detail

}  // namespace point_line

/// How a point lies to a ray, or to a line, whose range is infinite at both ends.
///
/// Exact, for all finite input of any magnitude. An end of the range belongs to it. No point lies on an empty range: a
/// point of its line is before or beyond it. A zero direction makes the ray a point: any other lies aside. NaN or an
/// infinite coordinate: aside.
template <class S, int N, class Trace = NoTrace>
Beside beside(const Point<S, N>& point, const Ray<S, N>& ray, Trace&& trace = {}) {
  if (!finite(point) || !finite(ray)) return Beside::aside;
  return point_line::detail::beside<N>(straight(ray), point.template cast<double>(), trace);
}
/// How a point lies to a segment with both ends as given: before p, beyond q. A segment whose ends coincide is a point.
template <class S, int N, class Trace = NoTrace>
Beside beside(const Point<S, N>& point, const Segment<S, N>& segment, Trace&& trace = {}) {
  if (!finite(point) || !finite(segment)) return Beside::aside;
  return point_line::detail::beside<N>(straight(segment), point.template cast<double>(), trace);
}

}  // namespace isect
