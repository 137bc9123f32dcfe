#pragma once
// A ray, a line or a segment against a convex solid given by half-spaces (isect/half_spaces.h): a k-DOP, a frustum.
//
// Each half-space a.x + w >= 0 says (a.d) t + (a.o + w) >= 0: a first t, a last one, or for a.d = 0 all or none. The
// greatest of the first and the least of the last are found by comparing quotients multiplied out. Source: Cyrus, Beck,
// Generalized two- and three-dimensional clipping, Computers & Graphics 3 (1978).

#include <algorithm>
#include <optional>
#include <variant>

#include <isect/half_spaces.h>
#include <isect/parts/ray_range.h>

namespace isect {

namespace ray_half_spaces {

using Event = std::variant<Fallback>;

namespace detail {

/// The t of `range` whose point lies in the solid. `direction` is operator()<W>() -> Components<W, 3>.
template <class S, class Direction, class Trace>
std::optional<Interval<S>> clip(const Point<double, 3>& origin, const Direction& direction, const Interval<S>& range,
                                const HalfSpaces& solid, Trace&& trace) {
  if (!ray_range::has_points(range)) return {};
  const auto bound = [&](int i) {
    return [&, i]<class W>() -> Ratio<W> {
      const inequalities::Row<W> row = half_spaces::detail::row<W>(solid.faces[static_cast<std::size_t>(i)]);
      const Components<W, 3> n = inequalities::detail::normal(row);
      return {-(dot(n, exactly<W>(origin)) + row[3]), dot(n, direction.template operator()<W>())};
    };
  };
  const auto rate = [&](int i) {
    return sign_of<long_text>([&]<class W>() -> W { return bound(i).template operator()<W>().den; }, trace);
  };
  // The sign of t_i - t_j, whose rates have the same sign
  const auto order = [&](int i, int j) {
    return sign_of<long_text>(
        [&]<class W>() -> W {
          const Ratio<W> x = bound(i).template operator()<W>(), y = bound(j).template operator()<W>();
          return x.num * y.den - y.num * x.den;
        },
        trace);
  };
  int first = -1, last = -1;
  for (int i = 0; i < half_spaces::detail::count(solid.faces); ++i) {
    const int sign = rate(i);
    if (sign > 0 && (first < 0 || order(i, first) > 0)) first = i;
    if (sign < 0 && (last < 0 || order(i, last) < 0)) last = i;
    if (sign == 0 &&
        sign_of<long_text>([&]<class W>() -> W { return bound(i).template operator()<W>().num; }, trace) > 0)
      return {};
  }
  const auto after = [&](int i, int side, const S& end) {
    return ray_range::compare(bound(i), side, static_cast<double>(end), trace);
  };
  if (first >= 0 && last >= 0) {
    const auto gap = [&]<class W>() -> W {  // the rates have opposite signs
      const Ratio<W> x = bound(first).template operator()<W>(), y = bound(last).template operator()<W>();
      return y.num * x.den - x.num * y.den;
    };
    if (sign_of<long_text>(gap, trace) > 0) return {};
  }
  Interval<S> result = range;
  if (first >= 0) {
    if (after(first, 1, range.hi) > 0) return {};
    if (after(first, 1, range.lo) > 0) result.lo = ray_range::clamped(value_of<S>(bound(first), trace), range);
  }
  if (last >= 0) {
    if (after(last, -1, range.lo) < 0) return {};
    if (after(last, -1, range.hi) < 0) result.hi = ray_range::clamped(value_of<S>(bound(last), trace), range);
  }
  result.hi = std::max(result.lo, result.hi);
  return result;
}

}  // namespace detail

}  // namespace ray_half_spaces

/// The part of the range in the solid. The verdict is exact, each end within 2 ulp. NaN or an infinite coordinate, and
/// a solid without a point: none.
template <class S, int N, class Trace = NoTrace>
std::optional<Interval<S>> intersect(const Ray<S, N>& ray, const HalfSpaces& solid, Trace&& trace = {}) {
  if (!finite(ray)) return {};
  const Vector<double, 3> d = half_spaces::detail::in_space<S, N>(ray.direction);
  const auto direction = [&]<class W>() -> Components<W, 3> { return exactly<W>(d); };
  return ray_half_spaces::detail::clip<S>(half_spaces::detail::in_space<S, N>(ray.origin), direction, ray.range, solid,
                                          trace);
}

/// The t of [0, 1] at which the segment, with both ends as given, is in the solid; otherwise as for a ray.
template <class S, int N, class Trace = NoTrace>
std::optional<Interval<S>> intersect(const Segment<S, N>& segment, const HalfSpaces& solid, Trace&& trace = {}) {
  if (!finite(segment)) return {};
  const Point<double, 3> p = half_spaces::detail::in_space<S, N>(segment.p),
                         q = half_spaces::detail::in_space<S, N>(segment.q);
  const auto direction = [&]<class W>() -> Components<W, 3> { return difference<W>(q, p); };
  return ray_half_spaces::detail::clip<S>(p, direction, {S(0), S(1)}, solid, trace);
}

/// Whether a ray, or a segment with both ends as given, has a point in the solid. Exact.
template <class S, int N>
bool intersects(const Ray<S, N>& ray, const HalfSpaces& solid) {
  return intersect(ray, solid).has_value();
}
template <class S, int N>
bool intersects(const Segment<S, N>& segment, const HalfSpaces& solid) {
  return intersect(segment, solid).has_value();
}

/// The least t in the solid: the first of what `intersect` finds.
template <class S, int N>
std::optional<S> first_hit(const Ray<S, N>& ray, const HalfSpaces& solid) {
  const std::optional<Interval<S>> part = intersect(ray, solid);
  return part ? std::optional<S>(part->lo) : std::nullopt;
}
template <class S, int N>
std::optional<S> first_hit(const Segment<S, N>& segment, const HalfSpaces& solid) {
  const std::optional<Interval<S>> part = intersect(segment, solid);
  return part ? std::optional<S>(part->lo) : std::nullopt;
}

}  // namespace isect
