#pragma once
// Ray against polygon in space.
//
// The plane of the polygon goes through its vertex p_0, with Newell's normal: twice the area vector, the sum over the
// edges of (p_i - p_0) x (p_i+1 - p_0), which any vertices have. The line o + t d meets it at
//
//   P = o + (num / den) d,   num = n.(p_0 - o),   den = n.d.
//
// Polygon and P are projected along the axis of the largest |n_i|, where P is located among the crossings of the
// outline (isect/point_polygon.h). P is rounded nowhere: on the axes x, y of the projection, for vertices a and b,
//
//   (a_y - P_y) den = (a_y - o_y) den - num d_y,
//   orient2d(a, b, P) den = den (a - o) x (b - o) - num d x (b - a),
//
// so that all verdicts are signs of polynomials. Source: the note, N21, with its question which axis to drop;
// Sutherland et al., ACM Computing Surveys 6 (1974), for Newell's normal.

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include <isect/parts/memo.h>
#include <isect/parts/ray_range.h>
#include <isect/point_polygon.h>

namespace isect {

/// What a ray and a polygon in space have in common. All t in units of |direction|.
template <class S>
struct RayPolygon {
  bool flat = false;                  ///< the outline has no area, and so no plane
  bool coplanar = false;              ///< the line lies in the plane of the polygon: an answer of its own, no hit
  std::optional<S> line;              ///< t in the plane, on the whole line; none when parallel
  Location location = Location::out;  ///< of that point, in the projected polygon
  std::optional<S> t;                 ///< where the ray meets the polygon

  explicit operator bool() const { return t.has_value(); }
};

namespace ray_polygon {

/// The axis to drop, and the signs of n.d and n.(p_0 - o).
struct Decision {
  int axis, heading, side;
};
template <class S>
struct Hit {
  S t;
};
template <class S>
using Event = std::variant<Decision, point_polygon::Edge, Hit<S>, Fallback>;

namespace detail {

/// The normal, and P by num and den.
template <PolynomialScalar W>
struct PlanePoint {
  Components<W, 3> normal;
  W num, den;
};

template <PolynomialScalar W, class S>
PlanePoint<W> plane_point(const Ray<double, 3>& ray, const Ring<S, 3>& ring) {
  const auto vertex = [&](std::size_t i) -> Point<double, 3> { return ring[i].template cast<double>(); };
  PlanePoint<W> result = {};
  const Point<double, 3> first = vertex(0);
  Components<W, 3> side = {};  // from the first vertex to the one before
  for (std::size_t i = 1; i < ring.size(); ++i) {
    Components<W, 3> next = difference<W>(vertex(i), first);
    if (i > 1) {
      const Components<W, 3> area = cross(side, next);
      for (int k = 0; k < 3; ++k) result.normal[k] = i == 2 ? area[k] : result.normal[k] + area[k];
    }
    side = std::move(next);
  }
  result.num = dot(result.normal, difference<W>(first, ray.origin));
  result.den = dot(result.normal, exactly<W>(ray.direction));
  return result;
}

/// P, found once in doubles and, where that can't decide, once in each of the others: a sum over
/// all vertices each time, which no sign of a vertex or an edge may cost.
template <class S>
class Crossing {
 public:
  Crossing(const Ray<double, 3>& ray, const Ring<S, 3>& ring)
      : ray_(ray), ring_(ring), quick_(plane_point<Bounded<double>>(ray, ring)) {}

  template <PolynomialScalar W>
  kept_t<W, PlanePoint<W>> point() const {
    if constexpr (std::is_same_v<W, Bounded<double>>)
      return quick_;
    else
      return others_.template in<W>([&] { return plane_point<W>(ray_, ring_); });
  }
  template <PolynomialScalar W>
  Ratio<W> parameter() const {
    const PlanePoint<W>& p = point<W>();
    return {p.num, p.den};
  }
  /// (a_i - P_i) den
  template <PolynomialScalar W>
  W offset(const Point<S, 3>& a, int i) const {
    const PlanePoint<W>& p = point<W>();
    return difference<W>(a[i], ray_.origin[i]) * p.den - p.num * W(ray_.direction[i]);
  }
  /// orient2d(a, b, P) den, on the axes x, y.
  template <PolynomialScalar W>
  W area2(const Point<S, 3>& a, const Point<S, 3>& b, int x, int y) const {
    const PlanePoint<W>& p = point<W>();
    const Point<double, 3>& o = ray_.origin;
    const W ab =
        difference<W>(a[x], o[x]) * difference<W>(b[y], o[y]) - difference<W>(a[y], o[y]) * difference<W>(b[x], o[x]);
    const W d = W(ray_.direction[x]) * difference<W>(b[y], a[y]) - W(ray_.direction[y]) * difference<W>(b[x], a[x]);
    return p.den * ab - p.num * d;
  }

 private:
  const Ray<double, 3>& ray_;
  const Ring<S, 3>& ring_;
  PlanePoint<Bounded<double>> quick_;
  Memo<PlanePoint> others_;
};

/// The axis of the largest |n_i|, the first of several.
template <class S, class Trace>
int steepest(const Crossing<S>& crossing, Trace&& trace) {
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    const NotRecorded excess{[&]<class W>() -> W {
      const PlanePoint<W>& p = crossing.template point<W>();
      return abs(p.normal[i]) - abs(p.normal[axis]);
    }};
    if (sign_of(excess, trace) > 0) axis = i;
  }
  return axis;
}

/// Where P lies in the polygon projected along `axis`; `den` is the sign of the denominator.
template <class S, class Trace>
Location locate(const Crossing<S>& crossing, int den, int axis, std::span<const Ring<S, 3>> rings, FillRule rule,
                Trace&& trace) {
  const int x = (axis + 1) % 3, y = (axis + 2) % 3;
  const auto along = [&](const Point<S, 3>& v, int i) -> int {
    return den * sign_of(NotRecorded{[&]<class W>() -> W { return crossing.template offset<W>(v, i); }}, trace);
  };
  const auto abscissa = [&](const Point<S, 3>& v) -> int { return along(v, x); };
  const auto height = [&](const Point<S, 3>& v) -> int { return along(v, y); };
  const auto side = [&](const Point<S, 3>& a, const Point<S, 3>& b) -> int {
    return den * sign_of(NotRecorded{[&]<class W>() -> W { return crossing.template area2<W>(a, b, x, y); }}, trace);
  };

  point_polygon::Crossings sum;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const std::span<const Point<S, 3>> ring = rings[i];
    const point_polygon::Crossings part = point_polygon::wind(ring, height, abscissa, side, static_cast<int>(i), trace);
    if (part.on) return Location::on;
    sum.crossings += part.crossings, sum.winding += part.winding;
  }
  const bool inside = rule == FillRule::even_odd ? sum.crossings % 2 != 0 : sum.winding != 0;
  return inside ? Location::in : Location::out;
}

/// The signs of the plane depend on the first ring and the ray; so in a first try NaN and infinity leave them open.
template <class S, class Trace>
RayPolygon<S> meet(const Ray<S, 3>& ray, std::span<const Ring<S, 3>> rings, FillRule rule, Trace& trace) {
  RayPolygon<S> result;
  if (!doubles_only<Trace> && !finite(ray)) return result;
  for (std::size_t i = doubles_only<Trace> ? 1 : 0; i < rings.size(); ++i)
    if (!finite(rings[i])) return result;
  result.flat = rings.empty() || rings[0].empty();
  if (result.flat) return result;

  const Ray<double, 3>& wide = in_doubles(ray);
  const Crossing<S> crossing(wide, rings[0]);
  const auto t = [&]<class W>() -> Ratio<W> { return crossing.template parameter<W>(); };
  const int axis = steepest(crossing, trace);
  result.flat =
      sign_of(NotRecorded{[&]<class W>() -> W { return crossing.template point<W>().normal[axis]; }}, trace) == 0;
  if (result.flat) return result;

  const int heading = sign_of(NotRecorded{[&]<class W>() -> W { return t.template operator()<W>().den; }}, trace);
  const int side = sign_of(NotRecorded{[&]<class W>() -> W { return t.template operator()<W>().num; }}, trace);
  trace(Decision{axis, heading, side});
  result.coplanar = heading == 0 && side == 0;
  if (heading == 0) return result;

  result.line = value_of<S>(t, trace);
  result.location = locate(crossing, heading, axis, rings, rule, trace);
  if (result.location == Location::out || !ray_range::holds(wide.range, t, heading, trace)) return result;
  result.t = ray_range::clamped(*result.line, ray.range);
  trace(Hit<S>{*result.t});
  return result;
}

template <class S, class Trace>
RayPolygon<S> intersect(const Ray<S, 3>& ray, std::span<const Ring<S, 3>> rings, FillRule rule, Trace&& trace) {
  return in_doubles_first<S>([&](auto& pass) { return meet(ray, rings, rule, pass); }, trace);
}

}  // namespace detail

}  // namespace ray_polygon

/// Where a ray, segment or line meets a polygon in space, from either side; its rings are outline, holes, islands,
/// whatever the fill rule makes of them. The first ring spans the plane.
///
/// Every verdict (flat, coplanar, location, whether line and t have values) is true for all finite input of any
/// magnitude, for the polygon projected along the axis of the largest normal component: for vertices in one plane
/// exactly, that is the polygon itself, and of two that share an edge of one plane a line through it meets both. Both
/// t lie within 2 ulp of S of the true value, that of the range in the range. A zero direction makes the ray a point:
/// no hit, coplanar if it lies in the plane. A first ring without area is flat: no hit. NaN or an infinite
/// coordinate, or an empty range: no hit.
template <class S, class Trace = NoTrace>
RayPolygon<S> intersect(const Ray<S, 3>& ray, const Polygon<S, 3>& polygon, FillRule rule = FillRule::even_odd,
                        Trace&& trace = {}) {
  return ray_polygon::detail::intersect(ray, std::span<const Ring<S, 3>>(polygon.rings), rule, trace);
}
template <class S, class Trace = NoTrace>
RayPolygon<S> intersect(const Ray<S, 3>& ray, const Ring<S, 3>& ring, FillRule rule = FillRule::even_odd,
                        Trace&& trace = {}) {
  return ray_polygon::detail::intersect(ray, std::span<const Ring<S, 3>>(&ring, 1), rule, trace);
}

}  // namespace isect
