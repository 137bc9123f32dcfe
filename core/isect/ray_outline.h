#pragma once
// Ray, segment or line against polygon, in the plane of both: where it first meets the inside or the boundary.
//
// A ray that starts in the polygon, or on its boundary, meets it there. Any other first meets it on the boundary: where
// it passes a corner, or where it crosses an edge whose ends lie on different sides of the line. With d the direction
// and o the origin that is, for a corner a with d x (a - o) = 0 and for an edge a b, at
//
//   t = (a - o).d / d.d,   t = (a - o) x (b - a) / d x (b - a).
//
// An edge along the line begins and ends with a corner, so it needs no case of its own. The least t in the range is
// found by comparing quotients multiplied out. In space a ray may lie in the polygon's plane: then both are projected
// along the axis of the largest |n_i|, which drops a coordinate and rounds nothing.
//
// Source: Preparata, Shamos, Computational Geometry (1985), 2.2.1, for the start; Cyrus, Beck, Generalized two- and
// three-dimensional clipping, Computers & Graphics 3 (1978), for the edges.

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <variant>

#include <isect/numbers/quotient.h>
#include <isect/parts/ray_range.h>
#include <isect/parts/straight.h>
#include <isect/point_polygon.h>
#include <isect/segment_polygon.h>

namespace isect {

namespace ray_outline {

/// Where the start of the range lies, if it has one and the ray a direction; else where the origin does.
struct Start {
  Location location;
};
/// The edge that begins at corner `index` of a ring is crossed, or that corner passed, in the range and before all that
/// were met so far.
struct Nearer {
  int ring, index;
  bool corner;
};
using Event = std::variant<Start, Nearer, point_polygon::Edge, Fallback>;

namespace detail {

template <PolynomialScalar W>
W cross(const Components<W, 2>& x, const Components<W, 2>& y) {
  return x[0] * y[1] - x[1] * y[0];
}

/// Where the line's point at t lies, by the rule.
template <class S, bool ends, class Trace>
Location locate(const Straight<2, ends>& line, double t, std::span<const Ring<S, 2>> rings, FillRule rule,
                Trace&& trace) {
  const auto seen = [&]<class W>(const Point<S, 2>& v) -> Components<W, 2> {
    Components<W, 2> x = difference<W, 2>(v.template cast<double>(), line.origin);
    if (t == 0) return x;
    const Components<W, 2> d = line.template along<W>();
    for (std::size_t i = 0; i < 2; ++i) x[i] = x[i] - W(t) * d[i];
    return x;
  };
  const auto along = [&](const Point<S, 2>& v, std::size_t i) {
    return sign_of([&]<class W>() -> W { return seen.template operator()<W>(v)[i]; }, trace);
  };
  const auto abscissa = [&](const Point<S, 2>& v) { return along(v, 0); };
  const auto height = [&](const Point<S, 2>& v) { return along(v, 1); };
  const auto side = [&](const Point<S, 2>& a, const Point<S, 2>& b) {
    return sign_of(
        [&]<class W>() -> W { return cross(seen.template operator()<W>(a), seen.template operator()<W>(b)); }, trace);
  };
  point_polygon::Crossings sum;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const std::span<const Point<S, 2>> ring = rings[i];
    const point_polygon::Crossings part = point_polygon::wind(ring, height, abscissa, side, static_cast<int>(i), trace);
    if (part.on) return Location::on;
    sum.crossings += part.crossings, sum.winding += part.winding;
  }
  const bool inside = rule == FillRule::even_odd ? sum.crossings % 2 != 0 : sum.winding != 0;
  return inside ? Location::in : Location::out;
}

/// A corner that the line passes, b = a, or an edge that it crosses; `den` is the sign of its quotient's denominator.
struct Met {
  Point<double, 2> a, b;
  int den;
};
template <PolynomialScalar W, bool ends>
Ratio<W> parameter(const Straight<2, ends>& line, const Met& met) {
  const Components<W, 2> d = line.template along<W>(), f = difference<W, 2>(met.a, line.origin);
  if (met.a == met.b) return {dot(f, d), dot(d, d)};
  const Components<W, 2> edge = difference<W, 2>(met.b, met.a);
  return {cross(f, edge), cross(d, edge)};
}

/// Finds what the line, which has a direction, first meets of the boundary in its range.
template <class S, bool ends, class Trace>
std::optional<Met> first_met(const Straight<2, ends>& line, std::span<const Ring<S, 2>> rings, Trace&& trace) {
  std::optional<Met> first;
  const auto take = [&](const Met& met, std::size_t ring, std::size_t index) {
    const auto t = [&]<class W>() -> Ratio<W> { return parameter<W>(line, met); };
    if (ray_range::compare(t, met.den, line.range.lo, trace) < 0) return;
    if (ray_range::compare(t, met.den, line.range.hi, trace) > 0) return;
    const auto excess = [&]<class W>() -> W {
      const Ratio<W> x = parameter<W>(line, met), y = parameter<W>(line, *first);
      return x.num * y.den - y.num * x.den;
    };
    if (first && sign_of(excess, trace) * met.den * first->den >= 0) return;
    first = met;
    trace(Nearer{static_cast<int>(ring), static_cast<int>(index), met.a == met.b});
  };
  for (std::size_t k = 0; k < rings.size(); ++k) {
    const Ring<S, 2>& ring = rings[k];
    const auto corner = [&](std::size_t i) -> Point<double, 2> {
      return ring[i < ring.size() ? i : 0].template cast<double>();
    };
    const auto side = [&](const Point<double, 2>& a) {
      return sign_of([&]<class W>() -> W { return cross(line.template along<W>(), difference<W, 2>(a, line.origin)); },
                     trace);
    };
    int next = ring.empty() ? 0 : side(corner(0));
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point<double, 2> a = corner(i), b = corner(i + 1);
      const int of_a = next;
      next = side(b);
      if (of_a == 0) take({a, a, 1}, k, i);
      if (of_a * next < 0) take({a, b, next}, k, i);
    }
  }
  return first;
}

/// The first t: start() where the range begins in the polygon, met(text) of what is met first, or nothing.
template <class S, bool ends, class Trace, class Start, class AtMet>
auto first(const Straight<2, ends>& line, std::span<const Ring<S, 2>> rings, FillRule rule, Trace&& trace,
           const Start& start, const AtMet& at_met) -> std::optional<decltype(start())> {
  const bool point = line.is_point();
  if (point || std::isfinite(line.range.lo)) {
    const Location at = locate(line, point ? 0 : line.range.lo, rings, rule, trace);
    trace(ray_outline::Start{at});
    if (at != Location::out) return start();
  }
  if (point) return {};
  const std::optional<Met> met = first_met(line, rings, trace);
  if (!met) return {};
  return at_met([&]<class W>() -> Ratio<W> { return parameter<W>(line, *met); });
}

template <class S>
bool all_finite(std::span<const Ring<S, 2>> rings) {
  return std::ranges::all_of(rings, [](const Ring<S, 2>& ring) { return finite(ring); });
}

template <class S, bool ends, class Trace>
std::optional<S> first_hit(const Straight<2, ends>& line, const Interval<S>& range, std::span<const Ring<S, 2>> rings,
                           FillRule rule, Trace&& trace) {
  if (!ray_range::has_points(range) || !all_finite(rings)) return {};
  return in_doubles_first<S>(
      [&](auto& pass) {
        return first(
            line, rings, rule, pass, [&]() -> S { return range.lo; },
            [&](const auto& t) -> S { return ray_range::clamped(value_of<S>(t, pass), range); });
      },
      trace);
}

/// Drops the coordinate along which an outline's normal is largest.
template <class S>
Point<S, 2> flattened(const Point<S, 3>& x, int axis) {
  return {x[(axis + 1) % 3], x[(axis + 2) % 3]};
}
template <class S>
Polygon<S, 2> flattened(std::span<const Ring<S, 3>> rings, int axis) {
  Polygon<S, 2> flat;
  for (const Ring<S, 3>& ring : rings) {
    flat.rings.emplace_back();
    for (const Point<S, 3>& v : ring) flat.rings.back().push_back(flattened<S>(v, axis));
  }
  return flat;
}
template <class S>
Ray<S, 2> flattened(const Ray<S, 3>& ray, int axis) {
  return {flattened<S>(ray.origin, axis), flattened<S>(ray.direction, axis), ray.range};
}
template <class S>
Segment<S, 2> flattened(const Segment<S, 3>& segment, int axis) {
  return {flattened<S>(segment.p, axis), flattened<S>(segment.q, axis)};
}

}  // namespace detail

}  // namespace ray_outline

/// The first t at which a ray, segment or line meets a polygon in the plane, its boundary included; its rings are
/// outline, holes, islands, whatever the fill rule makes of them.
///
/// Whether there is one is true for all finite input of any magnitude. It is the range's lower end where that lies in
/// the polygon, else within 2 ulp of S of its true value, in the range. A ring of two corners is a segment, one of one
/// a point. A zero direction makes the ray a point: the range's lower end if it lies in the polygon. NaN or an infinite
/// coordinate, or an empty range: none.
template <class S, class Trace = NoTrace>
std::optional<S> first_hit(const Ray<S, 2>& ray, const Polygon<S, 2>& polygon, FillRule rule = FillRule::even_odd,
                           Trace&& trace = {}) {
  if (!finite(ray)) return {};
  return ray_outline::detail::first_hit<S>(straight(ray), ray.range, polygon.rings, rule, trace);
}
/// The first t of [0, 1] at which the segment, with both ends as given, meets the polygon; otherwise as for a ray.
template <class S, class Trace = NoTrace>
std::optional<S> first_hit(const Segment<S, 2>& segment, const Polygon<S, 2>& polygon,
                           FillRule rule = FillRule::even_odd, Trace&& trace = {}) {
  if (!finite(segment)) return {};
  return ray_outline::detail::first_hit<S>(straight(segment), {S(0), S(1)}, polygon.rings, rule, trace);
}

/// The first t at which a ray or a line meets a polygon in space, its boundary included: where `intersect` of
/// isect/ray_polygon.h says, or, for a line in the plane, which the first ring spans, as in 2D. Exact, and with the
/// bounds of both; none for a first ring without area.
template <class S>
std::optional<S> first_hit(const Ray<S, 3>& ray, const Polygon<S, 3>& polygon, FillRule rule = FillRule::even_odd) {
  using namespace ray_outline::detail;
  const RayPolygon<S> across = intersect(ray, polygon, rule);
  if (!across.coplanar) return across.t;
  const int axis = segment_polygon::detail::steepest(polygon.rings[0]);
  return first_hit(flattened(ray, axis), flattened<S>(polygon.rings, axis), rule);
}
/// The first t of [0, 1] at which the segment, with both ends as given, meets the polygon; otherwise as for a ray.
template <class S>
std::optional<S> first_hit(const Segment<S, 3>& segment, const Polygon<S, 3>& polygon,
                           FillRule rule = FillRule::even_odd) {
  using namespace ray_outline::detail;
  const RayPolygon<S> across = intersect(segment, polygon, rule);
  if (!across.coplanar) return across.t;
  const int axis = segment_polygon::detail::steepest(polygon.rings[0]);
  return first_hit(flattened(segment, axis), flattened<S>(polygon.rings, axis), rule);
}

}  // namespace isect
