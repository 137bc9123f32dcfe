#pragma once
// Two rays, lines or segments in space.
//
// With the directions u, v and w from one origin to the other, n = u x v: the lines are skew iff w.n != 0; parallel iff
// n = 0; else they meet at t = (w x v).n / n.n of the first and (w x u).n / n.n of the second, which must lie in both
// ranges. Parallel ones have more than a point in common only on one line, w x u = 0, where the ends of both ranges are
// compared along u. Source: Ericson, Real-Time Collision Detection (2005), 5.1.8.

#include <cmath>
#include <cstddef>
#include <optional>
#include <variant>

#include <isect/parts/ray_range.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace line_line {

enum class Meeting {
  skew,      ///< no plane holds both
  parallel,  ///< on different lines of one direction
  apart,     ///< in one plane, or on one line, but nothing in common
  point,     ///< one point in common
  stretch    ///< more than a point
};

/// t of the first, where there is one point.
struct Result {
  Meeting meeting;
  std::optional<double> t = {};

  bool meets() const { return meeting == Meeting::point || meeting == Meeting::stretch; }
};

using Event = std::variant<Fallback>;

/// A line by origin, direction and range; a segment by its two ends as given.
struct Straight {
  Point<double, 3> origin;
  Vector<double, 3> direction;  ///< or the other end of a segment
  Interval<double> range;
  bool segment = false;

  Straight(const Ray<double, 3>& ray) : origin(ray.origin), direction(ray.direction), range(ray.range) {}
  Straight(const Segment<double, 3>& s) : origin(s.p), direction(s.q), range{0, 1}, segment(true) {}

  template <PolynomialScalar W>
  Components<W, 3> along() const {
    return segment ? difference<W>(direction, origin) : exactly<W>(direction);
  }
  bool is_finite() const {
    return finite(origin) && finite(direction) && !std::isnan(range.lo) && !std::isnan(range.hi);
  }
};

namespace detail {

template <class Text, class Trace>
bool vanishes(const Text& text, Trace&& trace) {
  for (std::size_t i = 0; i < 3; ++i)
    if (sign_of([&]<class W>() -> W { return text.template operator()<W>()[i]; }, trace) != 0) return false;
  return true;
}

/// Intersects a and b on one line; the direction of a is not 0.
template <class Trace>
Result on_one_line(const Straight& a, const Straight& b, Trace&& trace) {
  const auto product = [&]<class W>() -> W { return dot(a.along<W>(), b.along<W>()); };
  const int way = sign_of(product, trace);  // 0: b is a point
  // Where the point at s of b lies on a, as t
  const auto place = [&](double s) {
    return [&, s]<class W>() -> Ratio<W> {
      const Components<W, 3> u = a.along<W>();
      const W start = dot(difference<W>(b.origin, a.origin), u);
      return {s == 0 ? start : start + W(s) * product.template operator()<W>(), dot(u, u)};
    };
  };
  const double first = way == 0  ? 0
                       : way > 0 ? b.range.lo
                                 : b.range.hi,
               last = way == 0  ? 0
                      : way > 0 ? b.range.hi
                                : b.range.lo;
  // The sign of the t of b's end less an end of a
  const auto compared = [&](double s, double end) {
    if (std::isinf(end)) return end > 0 ? -1 : 1;
    return ray_range::compare(place(s), 1, end, trace);
  };
  const bool no_first = std::isinf(first), no_last = std::isinf(last);
  const int to_end = no_first ? -1 : compared(first, a.range.hi), to_start = no_last ? 1 : compared(last, a.range.lo);
  if (to_end > 0 || to_start < 0) return {Meeting::apart};
  const auto value = [&](double s) { return ray_range::clamped(value_of<double>(place(s), trace), a.range); };
  if (way == 0) return {Meeting::point, value(0)};
  if (to_end == 0) return {Meeting::point, a.range.hi};
  if (to_start == 0) return {Meeting::point, a.range.lo};
  if (a.range.lo == a.range.hi) return {Meeting::point, a.range.lo};
  if (first == last) return {Meeting::point, value(first)};
  const bool from_b = !no_first && compared(first, a.range.lo) > 0;
  if (from_b) return {Meeting::stretch, value(first)};
  return {Meeting::stretch, std::isinf(a.range.lo) ? std::nullopt : std::optional(a.range.lo)};
}

}  // namespace detail

}  // namespace line_line

/// How they lie, and the first t of `a` that they have in common (none where there is no first). Every verdict is
/// exact, t within 2 ulp and in its range. A zero direction makes either a point. An empty range, NaN or an infinite
/// coordinate: apart.
template <class Trace = NoTrace>
line_line::Result intersect(const line_line::Straight& a, const line_line::Straight& b, Trace&& trace = {}) {
  using line_line::Meeting;
  using line_line::detail::vanishes;
  if (!a.is_finite() || !b.is_finite() || !ray_range::has_points(a.range) || !ray_range::has_points(b.range))
    return {Meeting::apart};
  const auto u = [&]<class W>() -> Components<W, 3> { return a.along<W>(); };
  const auto v = [&]<class W>() -> Components<W, 3> { return b.along<W>(); };
  const auto w = [&]<class W>() -> Components<W, 3> { return difference<W>(b.origin, a.origin); };
  const bool point_a = vanishes(u, trace), point_b = vanishes(v, trace);
  if (point_a && point_b)
    return vanishes(w, trace) ? line_line::Result{Meeting::point, ray_range::clamped(0.0, a.range)}
                              : line_line::Result{Meeting::apart};
  if (point_a) {  // the other way round
    const line_line::Result other = intersect(b, a, trace);
    return other.meets() ? line_line::Result{Meeting::point, ray_range::clamped(0.0, a.range)}
                         : line_line::Result{Meeting::apart};
  }
  const auto n = [&]<class W>() -> Components<W, 3> { return cross(a.along<W>(), b.along<W>()); };
  if (vanishes(n, trace)) {
    const auto off = [&]<class W>() -> Components<W, 3> { return cross(w.template operator()<W>(), a.along<W>()); };
    if (!vanishes(off, trace)) return {point_b ? Meeting::apart : Meeting::parallel};
    return line_line::detail::on_one_line(a, b, trace);
  }
  const auto volume = [&]<class W>() -> W { return dot(w.template operator()<W>(), n.template operator()<W>()); };
  if (sign_of(volume, trace) != 0) return {Meeting::skew};
  const auto place = [&](bool on_a) {
    return [&, on_a]<class W>() -> Ratio<W> {
      const Components<W, 3> normal = n.template operator()<W>();
      return {dot(cross(w.template operator()<W>(), on_a ? b.along<W>() : a.along<W>()), normal), dot(normal, normal)};
    };
  };
  if (!ray_range::holds(a.range, place(true), 1, trace) || !ray_range::holds(b.range, place(false), 1, trace))
    return {Meeting::apart};
  return {Meeting::point, ray_range::clamped(value_of<double>(place(true), trace), a.range)};
}

}  // namespace isect
