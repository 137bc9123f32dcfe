#pragma once
// How two polygons lie, and a part of a line and a polygon, in rationals.
//
// The plane is cut into slabs at every x where an edge ends or two edges cross. Between two such x the edges that pass
// keep their order, and part the slab into trapezoids, each in A or not, in B or not: so the areas of A n B, A \ B and
// B \ A are sums. What has no area is looked at on the vertical lines at those x and midway between them: at each edge
// there, and midway between two. What runs along a line is asked at all its crossings, and midway between two.

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <vector>

#include <isect/conventions.h>
#include <isect/shapes.h>
#include "bench/rational.h"

namespace isect::oracle {

struct PolygonPolygon {
  Rational common = 0, only_a = 0, only_b = 0;  ///< areas
  bool meet = false, a_in_b = true, b_in_a = true;

  Relation relation() const {
    if (!meet) return Relation::disjoint;
    if (a_in_b) return b_in_a ? Relation::equal : Relation::a_inside_b;
    if (b_in_a) return Relation::b_inside_a;
    return common > 0 ? Relation::overlapping : Relation::touching;
  }
};

namespace polygon_polygon {

struct Edge {
  Coordinates<2> p, q;
  bool of_b;
};

template <class S>
std::vector<Edge> edges(const Polygon<S, 2>& polygon, bool of_b) {
  std::vector<Edge> all;
  for (const Ring<S, 2>& ring : polygon.rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      all.push_back({rational<S, 2>(ring[i]), rational<S, 2>(ring[(i + 1) % ring.size()]), of_b});
  return all;
}

inline Rational cross2(const Coordinates<2>& x, const Coordinates<2>& y) { return x[0] * y[1] - x[1] * y[0]; }

/// Where the lines of two edges meet, as p + t (q - p) of the first; nothing if they are parallel.
inline std::optional<Rational> meeting(const Edge& e, const Edge& f) {
  const Coordinates<2> d = e.q - e.p, g = f.q - f.p;
  const Rational turn = cross2(d, g);
  if (turn == 0) return {};
  return Rational(cross2(f.p - e.p, g) / turn);
}

/// A vertical line, or what lies at it: which edges it meets, and where.
class Column {
 public:
  Column(const std::vector<Edge>& all, const Rational& x) {
    for (const Edge& e : all) {
      const Rational &lo = std::min(e.p[0], e.q[0]), &hi = std::max(e.p[0], e.q[0]);
      if (x < lo || hi < x) continue;
      if (lo == hi) {
        spans_.push_back({std::min(e.p[1], e.q[1]), std::max(e.p[1], e.q[1]), e.of_b, false});
        levels.push_back(spans_.back().lo), levels.push_back(spans_.back().hi);
      } else {
        const Rational y = e.p[1] + (e.q[1] - e.p[1]) * (x - e.p[0]) / (e.q[0] - e.p[0]);
        spans_.push_back({y, y, e.of_b, x < hi});
        levels.push_back(y);
      }
    }
    std::sort(levels.begin(), levels.end());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  }

  struct Place {
    std::array<bool, 2> on = {}, in = {};
    bool held(int i) const { return on[i] || in[i]; }
  };
  Place at(const Rational& y) const {
    Place place;
    for (const Span& s : spans_) {
      place.on[s.of_b] |= s.lo <= y && y <= s.hi;
      place.in[s.of_b] ^= s.counts && s.lo > y;
    }
    for (int i = 0; i < 2; ++i) place.in[i] = place.in[i] && !place.on[i];
    return place;
  }

  std::vector<Rational> levels;

 private:
  struct Span {
    Rational lo, hi;
    bool of_b, counts;
  };
  std::vector<Span> spans_;
};

inline void look(const Column& column, PolygonPolygon& found) {
  const auto at = [&](const Rational& y) {
    const Column::Place p = column.at(y);
    found.meet |= p.held(0) && p.held(1);
    found.a_in_b &= !p.held(0) || p.held(1);
    found.b_in_a &= !p.held(1) || p.held(0);
  };
  for (std::size_t i = 0; i < column.levels.size(); ++i) {
    at(column.levels[i]);
    if (i > 0) at(Rational((column.levels[i - 1] + column.levels[i]) / 2));
  }
}

}  // namespace polygon_polygon

/// All numbers are finite.
template <class S>
PolygonPolygon polygon_polygon_truth(const Polygon<S, 2>& a, const Polygon<S, 2>& b) {
  namespace of = polygon_polygon;
  std::vector<of::Edge> all = of::edges(a, false);
  for (of::Edge& e : of::edges(b, true)) all.push_back(e);

  std::vector<Rational> xs;
  for (const of::Edge& e : all) {
    xs.push_back(e.p[0]);
    for (const of::Edge& f : all)
      if (const auto t = of::meeting(e, f); t && *t > 0 && *t < 1) xs.push_back(e.p[0] + *t * (e.q[0] - e.p[0]));
  }
  std::sort(xs.begin(), xs.end());
  xs.erase(std::unique(xs.begin(), xs.end()), xs.end());

  PolygonPolygon found;
  for (std::size_t i = 0; i < xs.size(); ++i) {
    of::look(of::Column(all, xs[i]), found);
    if (i == 0) continue;
    const of::Column middle(all, Rational((xs[i - 1] + xs[i]) / 2));
    of::look(middle, found);
    for (std::size_t k = 1; k < middle.levels.size(); ++k) {
      const Rational &lo = middle.levels[k - 1], &hi = middle.levels[k];
      const of::Column::Place cell = middle.at(Rational((lo + hi) / 2));
      const Rational area = (xs[i] - xs[i - 1]) * (hi - lo);  // a trapezoid: its width, times its height in the middle
      if (cell.in[0] && cell.in[1]) found.common += area;
      if (cell.in[0] && !cell.in[1]) found.only_a += area;
      if (!cell.in[0] && cell.in[1]) found.only_b += area;
    }
  }
  // areas and places tell the same, or one of them is wrong
  if ((found.only_a > 0 && found.a_in_b) || (found.only_b > 0 && found.b_in_a) || (found.common > 0 && !found.meet))
    throw std::logic_error("an oracle that contradicts itself");
  return found;
}

/// The points p + t d with t from lo to hi, nothing for no end, and a polygon. d is not 0.
template <class S>
Relation line_polygon_truth(const Coordinates<2>& p, const Coordinates<2>& d, const std::optional<Rational>& from,
                            const std::optional<Rational>& to, const Polygon<S, 2>& polygon) {
  namespace of = polygon_polygon;
  const std::vector<of::Edge> all = of::edges(polygon, true);
  if (all.empty()) return Relation::disjoint;
  const of::Edge along = {p, p + d, false};
  const auto t_of = [&](const Coordinates<2>& x) { return Rational(dot(x - p, d) / dot(d, d)); };
  const auto on_line = [&](const Coordinates<2>& x) { return of::cross2(d, x - p) == 0; };

  std::vector<Rational> ts;
  for (const of::Edge& e : all)
    if (const auto t = of::meeting(along, e))
      ts.push_back(*t);
    else
      ts.push_back(t_of(e.p)), ts.push_back(t_of(e.q));
  const auto [least, most] = std::minmax_element(ts.begin(), ts.end());
  const Rational far_lo = *least - 1, far_hi = *most + 1;
  // without an end, it is enough to go on beyond the polygon
  const Rational lo = from ? *from : to ? std::min(far_lo, Rational(*to - 1)) : far_lo;
  const Rational hi = to ? *to : std::max(far_hi, Rational(lo + 1));
  ts.push_back(lo), ts.push_back(hi);
  std::erase_if(ts, [&](const Rational& t) { return t < lo || hi < t; });
  std::sort(ts.begin(), ts.end());

  bool meets = false, a_in_b = true, interiors = false, b_in_a = true;
  const auto look = [&](const Rational& t) {
    const Coordinates<2> x = p + t * d;
    bool on = false, in = false;
    for (const of::Edge& e : all) {
      const Coordinates<2>&r = e.p, &s = e.q;
      const bool between = std::min(r[0], s[0]) <= x[0] && x[0] <= std::max(r[0], s[0]) &&
                           std::min(r[1], s[1]) <= x[1] && x[1] <= std::max(r[1], s[1]);
      on |= between && of::cross2(s - r, x - r) == 0;
      if ((r[0] <= x[0]) != (s[0] <= x[0])) in ^= r[1] + (s[1] - r[1]) * (x[0] - r[0]) / (s[0] - r[0]) > x[1];
    }
    meets |= on || in;
    a_in_b &= on || in;
    interiors |= !on && in && ((lo < t && t < hi) || lo == hi);
  };
  for (std::size_t i = 0; i < ts.size(); ++i) {
    look(ts[i]);
    if (i > 0) look(Rational((ts[i - 1] + ts[i]) / 2));
  }
  for (const of::Edge& e : all) b_in_a &= on_line(e.p) && lo <= t_of(e.p) && t_of(e.p) <= hi;
  if (!meets) return Relation::disjoint;
  if (a_in_b) return b_in_a ? Relation::equal : Relation::a_inside_b;
  if (b_in_a) return Relation::b_inside_a;
  return interiors ? Relation::overlapping : Relation::touching;
}

}  // namespace isect::oracle
