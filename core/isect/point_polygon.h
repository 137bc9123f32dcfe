#pragma once
// Point against polygon: crossings and winding number.
//
// The ray from the point p to the right crosses the boundary of a bounded region an odd number of times iff p lies
// inside (Jordan). An edge a b crosses it iff a and b lie on different sides of the line y = p.y and p lies on the
// left of the edge seen upwards. A vertex on the line counts as below it: so a chain that only touches the ray
// crosses it twice or never, and an edge along the line never. Upward crossings minus downward ones are the winding
// number. The point is on the boundary iff it is a vertex, or between the ends of an edge along the line, or orient2d
// is zero for an edge that crosses the line.
//
// All of it is comparisons of coordinates and signs of orient2d: exact. And p is known through three predicates only,
// so the text serves points that have no coordinates, such as that of a line in a plane.
//
// Source: the note, N22; W. R. Franklin, PNPOLY (1970), for the half-open rule; K. Hormann, A. Agathos, The point in
// polygon problem for arbitrary polygons, Comput. Geom. 20 (2001).

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <span>
#include <variant>

#include <isect/orient.h>
#include <isect/parts/point_polygon_fast.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

/// Which points of a polygon are inside: those with an odd number of crossings, or those whose winding number is not 0.
enum class FillRule { even_odd, nonzero };

/// Where a point lies, by either rule.
struct Winding {
  Location even_odd, nonzero;
  int winding;    ///< how many times the rings go around the point, counter-clockwise; meaningless on the boundary
  int crossings;  ///< how many edges the ray to the right crosses; meaningless on the boundary
};

namespace point_polygon {

/// How an edge lies to the ray from the point to the right.
enum class Passage {
  above,          ///< above the line y = p.y
  below,          ///< below it, or with its upper end on it
  horizontal,     ///< along the line, without the point
  crossed_left,   ///< crosses the line on the left of the point: does not count
  crossed_right,  ///< crosses the ray: counts
  on              ///< holds the point
};
/// The edge from vertex `index` of a ring to the next one; `turn` is orient2d(a, b, p) where it was asked, else 0.
struct Edge {
  int ring, index;
  Passage passage;
  int turn;
};
using Event = std::variant<Edge, Fallback>;

/// What the ray meets.
struct Crossings {
  int crossings = 0, winding = 0;
  bool on = false;  ///< an edge holds the point, and the others do not matter
};

namespace detail {

/// The passage of an edge that crosses the line upwards (1) or downwards (-1).
inline Passage crossed(int turn, int up) {
  if (turn == 0) return Passage::on;
  return turn == up ? Passage::crossed_right : Passage::crossed_left;
}

/// Counts what the ray meets of the edges first, ..., last - 1 of a ring; see `wind`.
template <class Vertex, class Height, class Abscissa, class Side, class Trace = NoTrace>
Crossings walk(std::span<const Vertex> vertices, std::size_t first, std::size_t last, const Height& height,
               const Abscissa& abscissa, const Side& side, int ring = 0, Trace&& trace = {}) {
  Crossings met;
  int a_height = 0, b_height = height(vertices[first]);
  for (std::size_t i = first; i < last; ++i) {
    const Vertex &a = vertices[i], &b = vertices[i + 1 < vertices.size() ? i + 1 : 0];
    const int index = static_cast<int>(i);
    a_height = b_height, b_height = height(b);

    if (a_height == b_height && a_height != 0) {
      trace(Edge{ring, index, a_height > 0 ? Passage::above : Passage::below, 0});
      continue;
    }
    if (a_height == 0) {
      const int a_abscissa = abscissa(a);
      met.on = a_abscissa == 0 || (b_height == 0 && a_abscissa != abscissa(b));
    }
    if (met.on) {
      trace(Edge{ring, index, Passage::on, 0});
      return met;
    }

    const int up = (b_height > 0) - (a_height > 0);
    if (up == 0) {
      trace(Edge{ring, index, a_height == b_height ? Passage::horizontal : Passage::below, 0});
      continue;
    }
    const int turn = side(a, b);
    met.on = turn == 0;
    const bool counts = turn == up;
    met.crossings += counts, met.winding += counts ? up : 0;
    trace(Edge{ring, index, crossed(turn, up), turn});
    if (met.on) return met;
  }
  return met;
}

}  // namespace detail

/// Counts what the ray meets of a ring of any type of vertices, seen through predicates of the caller's own:
/// `height(v)` and `abscissa(v)` are the signs of v.y - p.y and v.x - p.x, `side(a, b)` is orient2d(a, b, p). The
/// counts are as right as they are. The number `ring` is for the events.
template <class Vertex, class Height, class Abscissa, class Side, class Trace = NoTrace>
Crossings wind(std::span<const Vertex> vertices, const Height& height, const Abscissa& abscissa, const Side& side,
               int ring = 0, Trace&& trace = {}) {
  if (vertices.empty()) return {};
  return detail::walk(vertices, 0, vertices.size(), height, abscissa, side, ring, trace);
}

namespace detail {

/// Counts what the ray meets of a ring with coordinates; nothing when one of those looked at is not finite.
/// Comparisons, many at once, settle most edges.
template <class S, class Trace>
std::optional<Crossings> wind_points(const Point<S, 2>& p, std::span<const Point<S, 2>> vertices, int ring,
                                     Trace&& trace) {
  const auto height = [&](const Point<S, 2>& v) { return (v[1] > p[1]) - (v[1] < p[1]); };
  const auto abscissa = [&](const Point<S, 2>& v) { return (v[0] > p[0]) - (v[0] < p[0]); };
  const auto side = [&](const Point<S, 2>& a, const Point<S, 2>& b) {
    return orient2d(a.template cast<double>(), b.template cast<double>(), p.template cast<double>(), trace);
  };
  const auto all_finite = [&] {
    return std::all_of(vertices.begin(), vertices.end(), [](const Point<S, 2>& v) { return finite(v); });
  };

  using Fast = Scan<S>;
  if (!heard<Trace> && vertices.size() >= Fast::few) {
    Crossings met;
    for (std::size_t first = 0; first < vertices.size(); first += Fast::most) {
      Scanned scanned;
      const std::size_t last = std::min(first + Fast::most, vertices.size());
      const Point<S, 2>& before = first > 0 ? vertices[first - 1] : vertices.back();
      simd::run(widest(), Fast{p, vertices, before, first, last, scanned});
      if (!scanned.finite) return {};
      met.crossings += scanned.crossings, met.winding += scanned.winding;
      for (std::size_t word = 0; word < scanned.words; ++word)
        for (std::uint64_t rest = scanned.open[word].bits; rest != 0; rest &= rest - 1) {
          const std::size_t end = scanned.open[word].first + static_cast<std::size_t>(std::countr_zero(rest)) / 2;
          const std::size_t edge = (end > 0 ? end : vertices.size()) - 1;
          if (!finite(vertices[edge])) return {};  // of the first edge it is the last vertex, not scanned yet
          const Crossings part = walk(vertices, edge, edge + 1, height, abscissa, side);
          met = {met.crossings + part.crossings, met.winding + part.winding, part.on};
          if (part.on) return met;
        }
    }
    return met;
  }
  if (!all_finite()) return {};
  return wind(vertices, height, abscissa, side, ring, trace);
}

template <class S, class Trace>
Winding winding(const Point<S, 2>& p, std::span<const Ring<S, 2>> rings, Trace&& trace) {
  constexpr Winding outside = {Location::out, Location::out, 0, 0}, boundary = {Location::on, Location::on, 0, 0};
  if (!finite(p)) return outside;

  Crossings sum;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    const std::optional<Crossings> part =
        wind_points(p, std::span<const Point<S, 2>>(rings[i]), static_cast<int>(i), trace);
    if (!part) return outside;
    if (part->on) {
      const bool usable = std::all_of(rings.begin(), rings.end(), [](const Ring<S, 2>& r) { return finite(r); });
      return usable ? boundary : outside;
    }
    sum.crossings += part->crossings, sum.winding += part->winding;
  }

  const auto where = [](bool inside) { return inside ? Location::in : Location::out; };
  return {where(sum.crossings % 2 != 0), where(sum.winding != 0), sum.winding, sum.crossings};
}

}  // namespace detail

}  // namespace point_polygon

/// Where the point lies by both rules, with the winding number and the number of crossings; over all rings together,
/// which may cross themselves and each other. On the boundary means on any edge of any ring. Exact. A ring of two
/// vertices is a segment, one of one vertex a point: they have a boundary only. NaN or an infinite coordinate, in the
/// point or anywhere in the polygon: out.
template <class S, class Trace = NoTrace>
Winding winding(const Point<S, 2>& point, const Polygon<S, 2>& polygon, Trace&& trace = {}) {
  return point_polygon::detail::winding(point, std::span<const Ring<S, 2>>(polygon.rings), trace);
}
template <class S, class Trace = NoTrace>
Winding winding(const Point<S, 2>& point, const Ring<S, 2>& ring, Trace&& trace = {}) {
  static_assert(is_scalar<S>());
  return point_polygon::detail::winding(point, std::span<const Ring<S, 2>>(&ring, 1), trace);
}

/// Where the point lies by one rule. Otherwise as `winding`.
template <class S, class Trace = NoTrace>
Location locate(const Point<S, 2>& point, const Polygon<S, 2>& polygon, FillRule rule = FillRule::even_odd,
                Trace&& trace = {}) {
  const Winding w = winding(point, polygon, trace);
  return rule == FillRule::even_odd ? w.even_odd : w.nonzero;
}
template <class S, class Trace = NoTrace>
Location locate(const Point<S, 2>& point, const Ring<S, 2>& ring, FillRule rule = FillRule::even_odd,
                Trace&& trace = {}) {
  const Winding w = winding(point, ring, trace);
  return rule == FillRule::even_odd ? w.even_odd : w.nonzero;
}

}  // namespace isect
