#pragma once
// Segment, with both ends as given, against polygon in space: as isect/ray_polygon.h for a ray, but the direction q - p
// need not be a vector of floating-point numbers.
//
// The plane goes through the first vertex p_0, with Newell's normal n. The line p + t d, d = q - p, meets it at
//
//   P = p + (num / den) d,   num = n.(p_0 - p),   den = n.d,
//
// where it is located in the projection along the axis of the largest |n_i|, as there. Source: as there.

#include <optional>
#include <span>
#include <variant>

#include <isect/parts/straight.h>
#include <isect/ray_polygon.h>

namespace isect {

namespace segment_polygon {

using Event = std::variant<point_polygon::Edge, Fallback>;

namespace detail {

/// Newell's normal, from the first vertex.
template <PolynomialScalar W, class S>
Components<W, 3> normal(const Ring<S, 3>& ring) {
  const auto from_first = [&](std::size_t i) -> Components<W, 3> {
    return difference<W, 3>(ring[i].template cast<double>(), ring[0].template cast<double>());
  };
  Components<W, 3> sum = {W(0), W(0), W(0)};
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Components<W, 3> area = cross(from_first(i), from_first(i + 1));
    for (std::size_t k = 0; k < 3; ++k) sum[k] = i == 1 ? area[k] : sum[k] + area[k];
  }
  return sum;
}

/// The normal, num and den, each found once in each arithmetic that asks for it.
template <class S>
class Plane {
 public:
  Plane(const Straight<3, true>& line, const Ring<S, 3>& ring) : line_(line), ring_(ring) {}

  template <PolynomialScalar W>
  kept_t<W, ray_polygon::detail::PlanePoint<W>> point() const {
    return found_.template in<W>([&]() -> ray_polygon::detail::PlanePoint<W> {
      const Components<W, 3> n = normal<W>(ring_);
      return {n, dot(n, difference<W, 3>(ring_[0].template cast<double>(), line_.origin)),
              dot(n, line_.template along<W>())};
    });
  }

 private:
  const Straight<3, true>& line_;
  const Ring<S, 3>& ring_;
  Memo<ray_polygon::detail::PlanePoint> found_;
};

/// The axis of the largest |n_i|, the first of several.
template <class Normal, class Trace>
int steepest(const Normal& n, Trace&& trace) {
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    const NotRecorded excess{
        [&]<class W>() -> W { return abs(n.template operator()<W>(i)) - abs(n.template operator()<W>(axis)); }};
    if (sign_of(excess, trace) > 0) axis = i;
  }
  return axis;
}
template <class S>
int steepest(const Ring<S, 3>& ring) {
  return steepest([&]<class W>(int i) -> W { return normal<W>(ring)[static_cast<std::size_t>(i)]; }, NoTrace());
}

template <class S, class Trace>
RayPolygon<S> meet(const Straight<3, true>& line, std::span<const Ring<S, 3>> rings, FillRule rule, Trace& trace) {
  RayPolygon<S> result;
  const Plane<S> plane(line, rings[0]);
  const auto component = [&]<class W>(int i) -> W {
    return plane.template point<W>().normal[static_cast<std::size_t>(i)];
  };
  const int axis = steepest(component, trace);
  result.flat =
      sign_of(NotRecorded{[&]<class W>() -> W { return component.template operator()<W>(axis); }}, trace) == 0;
  if (result.flat) return result;

  const NotRecorded num{[&]<class W>() -> W { return plane.template point<W>().num; }};
  const NotRecorded den{[&]<class W>() -> W { return plane.template point<W>().den; }};
  const int heading = sign_of(den, trace);
  result.coplanar = heading == 0 && sign_of(num, trace) == 0;
  if (heading == 0) return result;

  const auto t = [&]<class W>() -> Ratio<W> {
    const ray_polygon::detail::PlanePoint<W>& p = plane.template point<W>();
    return {p.num, p.den};
  };
  result.line = value_of<S>(t, trace);

  // The vertices from P, times den, on the axes of the projection
  const int x = (axis + 1) % 3, y = (axis + 2) % 3;
  const auto from_point = [&]<class W>(const Point<S, 3>& v, int i) -> W {
    const ray_polygon::detail::PlanePoint<W>& p = plane.template point<W>();
    return difference<W>(v[i], line.origin[i]) * p.den - p.num * difference<W>(line.heading[i], line.origin[i]);
  };
  const auto along = [&](const Point<S, 3>& v, int i) {
    return heading *
           sign_of(NotRecorded{[&]<class W>() -> W { return from_point.template operator()<W>(v, i); }}, trace);
  };
  const auto abscissa = [&](const Point<S, 3>& v) { return along(v, x); };
  const auto height = [&](const Point<S, 3>& v) { return along(v, y); };
  const auto side = [&](const Point<S, 3>& a, const Point<S, 3>& b) {  // orient2d(a, b, P) den, without den's square
    const NotRecorded area{[&]<class W>() -> W {
      const ray_polygon::detail::PlanePoint<W>& p = plane.template point<W>();
      const auto from = [&](const auto& end, const Point<double, 3>& start, int i) {
        return difference<W>(end[i], start[i]);
      };
      const Point<double, 3>& o = line.origin;
      const W ab = from(a, o, x) * from(b, o, y) - from(a, o, y) * from(b, o, x);
      const Point<double, 3> first = a.template cast<double>();
      const W d = from(line.heading, o, x) * from(b, first, y) - from(line.heading, o, y) * from(b, first, x);
      return p.den * ab - p.num * d;
    }};
    return heading * sign_of(area, trace);
  };
  point_polygon::Crossings sum;
  for (std::size_t i = 0; i < rings.size() && !sum.on; ++i) {
    const std::span<const Point<S, 3>> ring = rings[i];
    const point_polygon::Crossings part = point_polygon::wind(ring, height, abscissa, side, static_cast<int>(i), trace);
    sum = {sum.crossings + part.crossings, sum.winding + part.winding, part.on};
  }
  const bool inside = rule == FillRule::even_odd ? sum.crossings % 2 != 0 : sum.winding != 0;
  result.location = sum.on ? Location::on : inside ? Location::in : Location::out;
  if (result.location == Location::out || !ray_range::holds(line.range, t, heading, trace)) return result;
  result.t = ray_range::clamped(*result.line, Interval<S>{S(0), S(1)});
  return result;
}

template <class S, class Trace>
RayPolygon<S> intersect(const Segment<S, 3>& segment, std::span<const Ring<S, 3>> rings, FillRule rule, Trace&& trace) {
  RayPolygon<S> result;
  if (!finite(segment)) return result;
  for (const Ring<S, 3>& ring : rings)
    if (!finite(ring)) return result;
  result.flat = rings.empty() || rings[0].empty();
  if (result.flat) return result;
  const Straight<3, true> line = straight(segment);
  return in_doubles_first<S>([&](auto& pass) { return meet(line, rings, rule, pass); }, trace);
}

}  // namespace detail

}  // namespace segment_polygon

/// Where a segment with both ends as given meets a polygon in space, from either side: t = 0 at p, t = 1 at q. All is
/// as `intersect` of isect/ray_polygon.h says of a ray: every verdict is true for all finite input of any magnitude,
/// for the polygon projected along the axis of the largest normal component; both t lie within 2 ulp of S, that of the
/// segment in [0, 1]. Where p is q there is no hit; it is coplanar if it lies in the plane.
template <class S, class Trace = NoTrace>
RayPolygon<S> intersect(const Segment<S, 3>& segment, const Polygon<S, 3>& polygon, FillRule rule = FillRule::even_odd,
                        Trace&& trace = {}) {
  return segment_polygon::detail::intersect(segment, std::span<const Ring<S, 3>>(polygon.rings), rule, trace);
}
template <class S, class Trace = NoTrace>
RayPolygon<S> intersect(const Segment<S, 3>& segment, const Ring<S, 3>& ring, FillRule rule = FillRule::even_odd,
                        Trace&& trace = {}) {
  return segment_polygon::detail::intersect(segment, std::span<const Ring<S, 3>>(&ring, 1), rule, trace);
}

}  // namespace isect
