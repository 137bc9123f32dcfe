#pragma once
// Polygon against polygon, and what runs along a line against a polygon: outlines of any form, with holes, in parts.
//
// A polygon is what `locate` of isect/point_polygon.h makes of its rings: interior where an odd number of edges is
// crossed on the way out, boundary on every edge. Every edge of both is cut where another one meets it. Then each piece
// lies in the interior of A, on the boundary of A, or outside, as a whole, and so does the plane just beside it, on the
// left and on the right; the same of B. As both are bounded, all regions of the plane lie beside some piece:
//
//   the interiors meet    iff a piece has both on one side,
//   A does not lie in B   iff a piece has A and not B on one side, or is of A and lies outside of B.
//
// No point is computed. Along an edge e the left side is followed on the line of e, moved to the left by an
// infinitesimal: another edge changes it iff that line parts its ends, those on the line of e counted as right of it.
// From one edge to the next, around their common corner, it changes with every other edge that leaves the corner within
// the angle on the left. For the first edge of a ring the crossings of a ray to the right tell it. The right side
// differs from the left if an odd number of edges runs along the piece. Where several edges meet e, the order is that
// of the quotients t = (r - p) x (s - r) / (d x (s - r)): the sign of a polynomial of degree four. So all of it is
// comparisons and true signs.
//
// A hierarchy of the edges' boxes finds which meet, edge by edge, in O(n) space, until nothing is left open: two that
// overlap are soon decided. Else it takes O((n + k) lg (n + k)) with k pairs of edges whose boxes have a common point,
// pairs of one polygon counted as well, and for each ring a ray past all edges to the right of it. Long edges side by
// side, as of a comb that stands obliquely, have k near n^2; n small rings in rows may take n^1.5.
//
// Source: M. Margalit, G. Knott, An algorithm for computing the union, intersection or difference of two polygons,
// Computers & Graphics 13 (1989), for edges that are cut and classified; Edelsbrunner, Mücke, Simulation of simplicity,
// ACM Trans. Graphics 9 (1990), for lines moved by an infinitesimal.

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <isect/many/bvh.h>
#include <isect/many/bvh_pairs.h>
#include <isect/orient.h>
#include <isect/point_polygon.h>
#include <isect/segment_segment.h>
#include <isect/shapes.h>

namespace isect {

namespace polygon_polygon {

namespace detail {

using Point2 = Point<double, 2>;

/// The line of a segment p q that has a length: t = 0 at p, t = 1 at q.
struct LineOfSegment {
  Point2 origin, end;

  int side(const Point2& x) const { return orient2d(origin, end, x); }
  int heading(int axis) const { return (end[axis] > origin[axis]) - (end[axis] < origin[axis]); }
  template <PolynomialScalar W>
  Components<W, 2> direction() const {
    return difference<W, 2>(end, origin);
  }
};
/// The line of a ray whose direction is not 0.
struct LineOfRay {
  Point2 origin, along;

  int side(const Point2& x) const {
    return sign_of([&]<class W>() -> W {
      return W(along[0]) * difference<W>(x[1], origin[1]) - W(along[1]) * difference<W>(x[0], origin[0]);
    });
  }
  int heading(int axis) const { return (along[axis] > 0) - (along[axis] < 0); }
  template <PolynomialScalar W>
  Components<W, 2> direction() const {
    return exactly<W, 2>(along);
  }
};

/// A place on a line: where the line of r s crosses it, a point r that it holds, or a number t.
struct Mark {
  enum class Kind { crossing, point, number } kind;
  Point2 r = Point2::Zero(), s = Point2::Zero();
  double number = 0;
  int den = 1;         ///< the sign of the denominator of t
  bool flips = false;  ///< whether the left side changes there
  int cover = 0;       ///< how many edges that run along the line begin there, less those that end
  bool of_b = false;
  enum class Role { boundary, from, to } role = Role::boundary;
};

/// The order of the marks on a line.
template <class Line>
class Order {
 public:
  explicit Order(const Line& line) : line_(line), axis_(line.heading(0) != 0 ? 0 : 1), heading_(line.heading(axis_)) {}

  /// The mark where edge r s crosses the line, with the sides of both, or ends on it.
  Mark crossing(const Point2& r, const Point2& s, int side_r, int side_s) const {
    return {Mark::Kind::crossing, r, s, 0, side_s > side_r ? 1 : -1, (side_r > 0) != (side_s > 0)};
  }
  Mark point(const Point2& x, int cover) const { return {Mark::Kind::point, x, x, 0, heading_, false, cover}; }

  /// The sign of t less u.
  int compare(const Mark& t, const Mark& u) const {
    if (t.kind == Mark::Kind::point && u.kind == Mark::Kind::point) return compare(t.r, u.r);
    return t.den * u.den * sign_of([&]<class W>() -> W {
             const Ratio<W> x = at<W>(t), y = at<W>(u);
             return x.num * y.den - y.num * x.den;
           });
  }
  /// The sign of the t of x less that of y, for two points that the line holds.
  int compare(const Point2& x, const Point2& y) const {
    return heading_ * ((x[axis_] > y[axis_]) - (x[axis_] < y[axis_]));
  }

 private:
  template <PolynomialScalar W>
  Ratio<W> at(const Mark& m) const {
    if (m.kind == Mark::Kind::number) return {W(m.number), W(1.)};
    const Components<W, 2> d = line_.template direction<W>();
    if (m.kind == Mark::Kind::point) return {difference<W>(m.r[axis_], line_.origin[axis_]), d[axis_]};
    const Components<W, 2> e = difference<W, 2>(m.s, m.r), f = difference<W, 2>(m.r, line_.origin);
    return {f[0] * e[1] - f[1] * e[0], d[0] * e[1] - d[1] * e[0]};
  }

  const Line& line_;
  int axis_, heading_;
};

/// An edge from p to q, which differ unless the ring is a point. `start`: it is the first of its ring.
struct Edge {
  Point2 p, q;
  bool of_b, start;
  int before;  ///< the edge that ends where this one begins

  bool is_point() const { return p == q; }
};

template <class S>
bool all_finite(const Polygon<S, 2>& x) {
  return std::all_of(x.rings.begin(), x.rings.end(), [](const Ring<S, 2>& r) { return finite(r); });
}

/// The edges of the rings, ring after ring, without those that have no length.
template <class S>
void add_edges(const Polygon<S, 2>& polygon, bool of_b, std::vector<Edge>& edges) {
  std::vector<Point2> corners;
  for (const Ring<S, 2>& ring : polygon.rings) {
    corners.clear();
    for (const Point<S, 2>& v : ring) {
      const Point2 corner = v.template cast<double>();
      if (corners.empty() || corners.back() != corner) corners.push_back(corner);
    }
    while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
    const int first = static_cast<int>(edges.size()), last = first + static_cast<int>(corners.size()) - 1;
    for (std::size_t i = 0; i < corners.size(); ++i)
      edges.push_back({corners[i], corners[i + 1 < corners.size() ? i + 1 : 0], of_b, i == 0,
                       i == 0 ? last : first + static_cast<int>(i) - 1});
  }
}

inline Aabb<double, 2> box_of(const Point2& p, const Point2& q) { return {p.cwiseMin(q), p.cwiseMax(q)}; }

template <class S>
std::optional<Aabb<double, 2>> box_of(const Polygon<S, 2>& polygon) {
  std::optional<Aabb<double, 2>> box;
  for (const Ring<S, 2>& ring : polygon.rings)
    for (const Point<S, 2>& v : ring) {
      const Point2 p = v.template cast<double>();
      box = box ? Aabb<double, 2>{box->lo.cwiseMin(p), box->hi.cwiseMax(p)} : Aabb<double, 2>{p, p};
    }
  return box;
}

/// Whether the ray from p to the right crosses an edge; p on it counts as right of it, level with an end as above that.
inline bool crossed_rightwards(const Edge& e, const Point2& p) {
  const bool up = e.q[1] > p[1];
  if ((e.p[1] > p[1]) == up) return false;
  return up ? orient2d(e.p, e.q, p) > 0 : orient2d(e.q, e.p, p) > 0;
}

/// Edges with the hierarchy of their boxes; for a few edges there is none.
struct Edges {
  static constexpr std::size_t few = 24;

  std::vector<Edge> all;
  std::vector<Aabb<double, 2>> boxes;
  Bvh<double, 2> tree;

  explicit Edges(std::vector<Edge> edges) : all(std::move(edges)) {
    boxes.reserve(all.size());
    for (const Edge& e : all) boxes.push_back(box_of(e.p, e.q));
    if (all.size() > few) tree = build_bvh(boxes);
  }

  /// Calls visit(number of an edge) for all whose boxes `near` does not rule out, until it returns true.
  template <class Near, class Visit>
  bool any(const Near& near, const Visit& visit) const {
    if (tree.nodes.empty()) {
      for (int i = 0; i < static_cast<int>(all.size()); ++i)
        if (near(boxes[i]) && visit(i)) return true;
      return false;
    }
    std::vector<int> stack = {0};
    while (!stack.empty()) {
      const BvhNode<double, 2>& node = tree.nodes[stack.back()];
      stack.pop_back();
      if (!near(node.box)) continue;
      if (!node.leaf()) {
        stack.push_back(node.first + 1);
        stack.push_back(node.first);
        continue;
      }
      for (int k = node.first; k < node.first + node.count; ++k)
        if (near(boxes[tree.primitives[k]]) && visit(tree.primitives[k])) return true;
    }
    return false;
  }

  /// Whether a point lies within A, and within B, by the ray to the right.
  std::array<bool, 2> within(const Point2& p) const {
    std::array<bool, 2> odd = {};
    any([&](const Aabb<double, 2>& b) { return b.lo[1] <= p[1] && p[1] <= b.hi[1] && p[0] <= b.hi[0]; },
        [&](int i) {
          odd[all[i].of_b] ^= crossed_rightwards(all[i], p);
          return false;
        });
    return odd;
  }
};

/// Whether direction v x lies strictly within the angle from v a counter-clockwise to v b; the full one if both are
/// the same.
inline bool within_angle(const Point2& v, const Point2& a, const Point2& x, const Point2& b) {
  const auto same = [&](const Point2& y, const Point2& z) {  // on one line through v
    return ((y.array() < v.array()) == (z.array() < v.array())).all() &&
           ((y.array() > v.array()) == (z.array() > v.array())).all();
  };
  const int whole = orient2d(v, a, b);
  if (whole > 0) return orient2d(v, a, x) > 0 && orient2d(v, x, b) > 0;
  if (whole < 0) return !(orient2d(v, b, x) >= 0 && orient2d(v, x, a) >= 0);
  const int turn = orient2d(v, a, x);
  if (!same(a, b)) return turn > 0;
  return turn != 0 || !same(a, x);
}

/// Whether direction v x lies within the angle from the right, without that, counter-clockwise to v d, with that.
inline bool from_right(const Point2& v, const Point2& x, const Point2& d) {
  const auto half = [&](const Point2& y) {
    if (y[1] == v[1]) return y[0] < v[0] ? 0 : -1;
    return y[1] > v[1] ? 0 : 1;
  };
  const int of_x = half(x), of_d = half(d);
  if (of_x < 0 || of_x > of_d) return false;
  return of_x < of_d || orient2d(v, x, d) >= 0;
}

/// What is known of two sets.
struct Found {
  bool common = false, interiors = false, a_leaves_b = false, b_leaves_a = false;

  bool all() const { return common && interiors && a_leaves_b && b_leaves_a; }

  Relation relation() const {
    if (!common) return Relation::disjoint;
    if (!a_leaves_b) return b_leaves_a ? Relation::a_inside_b : Relation::equal;
    if (!b_leaves_a) return Relation::b_inside_a;
    return interiors ? Relation::overlapping : Relation::touching;
  }
};

/// All edges of both polygons, cut where they meet.
class Overlay {
 public:
  explicit Overlay(const Edges& edges) : edges_(edges) {
    for (int i = 0; i < static_cast<int>(edges.all.size()) && !found_.all(); ++i) {
      find_meetings(i);
      edges.all[i].is_point() ? point(i) : edge(i);
    }
  }

  const Found& found() const { return found_; }

 private:
  /// Another edge that has a common point with the one in question: the sides of the other's ends, and whether it holds
  /// the first end of that one, or the last.
  struct Meeting {
    int other, p, q;
    bool at_start, at_end;
  };

  void find_meetings(int i) {
    const Edge& e = edges_.all[i];
    const Aabb<double, 2>& box = edges_.boxes[i];
    meetings_.clear();
    edges_.any([&](const Aabb<double, 2>& other) { return bvh_pairs::detail::meet(box, other); },
               [&](int j) {
                 if (j != i) add(e, j);
                 return false;
               });
  }
  void add(const Edge& e, int j) {
    const Edge& f = edges_.all[j];
    const segment_segment::Sides side = segment_segment::detail::sides({e.p, e.q}, {f.p, f.q}, NoTrace());
    if (!side.p || *side.p * *side.q > 0) return;
    const bool on_line = side.r == 0 && side.s == 0 && side.p == 0 && side.q == 0;
    const auto held = [&](int beside, const Point2& x) {
      return beside == 0 && (!on_line || bvh_pairs::detail::meet(edges_.boxes[j], {x, x}));
    };
    meetings_.push_back({j, side.r, side.s, held(*side.p, e.p), held(*side.q, e.q)});
    found_.common |= e.of_b != f.of_b;
  }

  template <class Use>
  void each_meeting(const Use& use) const {
    for (const Meeting& m : meetings_) use(m, edges_.all[m.other]);
  }

  /// Settles a ring that is a point.
  void point(int i) {
    const Edge& e = edges_.all[i];
    bool in_other = false;
    each_meeting([&](const Meeting&, const Edge& f) { in_other |= f.of_b != e.of_b; });
    if (!in_other) in_other = edges_.within(e.p)[!e.of_b];
    found_.common |= in_other;
    (e.of_b ? found_.b_leaves_a : found_.a_leaves_b) |= !in_other;
  }

  /// Calls use(x, of_b) for each other edge that leaves the first end of edge i towards x.
  template <class Use>
  void each_leaving(int i, const Use& use) const {
    const Point2& v = edges_.all[i].p;
    each_meeting([&](const Meeting& m, const Edge& f) {
      if (!m.at_start) return;
      if (f.p != v) use(f.p, f.of_b);
      if (f.q != v) use(f.q, f.of_b);
    });
  }

  /// Whether A, and B, lies on the left of the beginning of the first edge of a ring.
  std::array<bool, 2> first_left(int i) const {
    const Edge& e = edges_.all[i];
    std::array<bool, 2> left = edges_.within(e.p);
    left[e.of_b] ^= from_right(e.p, e.q, e.q);
    each_leaving(i, [&](const Point2& x, bool of_b) { left[of_b] ^= from_right(e.p, x, e.q); });
    return left;
  }
  /// Whether A, and B, lies on the left of the beginning of an edge; `left` says so for the end of the one before.
  std::array<bool, 2> next_left(int i, std::array<bool, 2> left) const {
    const Edge& e = edges_.all[i];
    each_leaving(i,
                 [&](const Point2& x, bool of_b) { left[of_b] ^= within_angle(e.p, e.q, x, edges_.all[e.before].p); });
    return left;
  }

  void edge(int i) {
    const Edge& e = edges_.all[i];
    left_ = e.start ? first_left(i) : next_left(i, left_);
    if (e.start) first_of_ring_ = i, left_of_ring_ = left_;

    const LineOfSegment line = {e.p, e.q};
    const Order order(line);
    std::array<int, 2> cover = {!e.of_b, e.of_b};
    marks_.clear();
    each_meeting([&](const Meeting& m, const Edge& f) {
      if (m.p == 0 && m.q == 0) {
        const bool forth = order.compare(f.p, f.q) <= 0;
        const Point2 &low = forth ? f.p : f.q, &high = forth ? f.q : f.p;
        if (order.compare(low, high) >= 0 || order.compare(high, e.p) <= 0 || order.compare(low, e.q) >= 0) return;
        if (order.compare(low, e.p) <= 0)
          ++cover[f.of_b];
        else
          marks_.push_back(order.point(low, 1)), marks_.back().of_b = f.of_b;
        if (order.compare(high, e.q) < 0) marks_.push_back(order.point(high, -1)), marks_.back().of_b = f.of_b;
      } else if (!m.at_start && !m.at_end) {
        marks_.push_back(order.crossing(f.p, f.q, m.p, m.q)), marks_.back().of_b = f.of_b;
      }
    });
    std::sort(marks_.begin(), marks_.end(), [&](const Mark& t, const Mark& u) { return order.compare(t, u) < 0; });

    piece(cover);
    for (std::size_t k = 0; k < marks_.size(); ++k) {
      left_[marks_[k].of_b] ^= marks_[k].flips, cover[marks_[k].of_b] += marks_[k].cover;
      if (k + 1 == marks_.size() || order.compare(marks_[k], marks_[k + 1]) != 0) piece(cover);
    }
    const bool last = i + 1 == static_cast<int>(edges_.all.size()) || edges_.all[i + 1].start;
    if (last) assert(comes_round());
  }

  /// Whether the ring's first edge has on its left again what it had.
  bool comes_round() {
    find_meetings(first_of_ring_);
    return next_left(first_of_ring_, left_) == left_of_ring_;
  }

  void piece(const std::array<int, 2>& cover) {
    const bool on_a = cover[0] > 0, on_b = cover[1] > 0;
    const auto [a, b] = left_;
    const bool right_a = a != (cover[0] % 2 != 0), right_b = b != (cover[1] % 2 != 0);
    found_.interiors |= (a && b) || (right_a && right_b);
    found_.common |= (on_a || a) && (on_b || b);
    found_.a_leaves_b |= (a && !b) || (right_a && !right_b) || (on_a && !on_b && !b);
    found_.b_leaves_a |= (b && !a) || (right_b && !right_a) || (on_b && !on_a && !a);
  }

  const Edges& edges_;
  std::vector<Meeting> meetings_;  ///< of one edge
  std::vector<Mark> marks_;        ///< on it
  std::array<bool, 2> left_ = {}, left_of_ring_ = {};
  int first_of_ring_ = 0;
  Found found_;
};

/// How a part of a line (A) lies to a polygon: the part between two marks, or from one on, or all of the line.
template <class Line, class S>
Relation relate_part(const Line& line, const std::optional<Mark>& from, const std::optional<Mark>& to,
                     const Polygon<S, 2>& polygon) {
  std::vector<Edge> edges;
  add_edges(polygon, true, edges);
  const Order order(line);
  Found found;
  std::vector<Mark> marks;
  for (const Edge& e : edges) {
    const int p = line.side(e.p), q = line.side(e.q);
    found.b_leaves_a |= p != 0 || q != 0;
    if (p * q > 0) continue;
    if (p != 0 || q != 0) {
      marks.push_back(order.crossing(e.p, e.q, p, q));
      continue;
    }
    const int forth = order.compare(e.q, e.p);
    marks.push_back(order.point(e.p, forth));
    marks.push_back(order.point(e.q, -forth));
  }
  const auto end = [&](Mark mark, Mark::Role role) {
    mark.role = role;
    marks.push_back(mark);
  };
  if (from) end(*from, Mark::Role::from);
  if (to) end(*to, Mark::Role::to);
  std::sort(marks.begin(), marks.end(), [&](const Mark& t, const Mark& u) { return order.compare(t, u) < 0; });

  bool active = !from, left = false;
  int cover = 0;
  found.a_leaves_b = !from || !to;  // the polygon is bounded
  for (std::size_t k = 0; k < marks.size();) {
    bool boundary = false, begins = false, ends = false;
    const bool before = left || cover > 0;
    std::size_t next = k;
    for (; next < marks.size() && order.compare(marks[k], marks[next]) == 0; ++next) {
      const Mark& m = marks[next];
      boundary |= m.role == Mark::Role::boundary, begins |= m.role == Mark::Role::from,
          ends |= m.role == Mark::Role::to;
      left ^= m.flips, cover += m.cover;
    }
    const bool in_part = active || begins, in_polygon = boundary || before;
    found.common |= in_part && in_polygon;
    found.a_leaves_b |= in_part && !in_polygon;
    found.b_leaves_a |= boundary && !in_part;

    active = in_part && !ends;
    if (active && next < marks.size()) {
      found.interiors |= left && cover == 0;
      found.common |= left || cover > 0;
      found.a_leaves_b |= !left && cover == 0;
    }
    k = next;
  }
  return found.relation();
}

/// How a point (A), which is its own interior, lies to a polygon.
template <class S>
Relation relate_point(const Point<S, 2>& p, const Polygon<S, 2>& polygon) {
  if (locate(p, polygon) == Location::out) return Relation::disjoint;
  for (const Ring<S, 2>& ring : polygon.rings)
    for (const Point<S, 2>& v : ring)
      if (v != p) return Relation::a_inside_b;
  return Relation::equal;
}

}  // namespace detail

}  // namespace polygon_polygon

/// How two polygons lie, each with its boundary: outlines, holes, islands, several parts, whatever the even-odd rule
/// makes of the rings, which may go either way, name a corner again, and cross themselves and each other.
///
/// Exact for all finite input of any magnitude. The interior is where `locate` says `in`, the set all where it does not
/// say `out`: every edge belongs to it, one that parts nothing as well. So a polygon without an area has no interior,
/// and touches what it meets unless one lies in the other. A polygon without a vertex is disjoint from everything; NaN
/// or an infinite coordinate: disjoint. O((n + k) lg (n + k)), with k pairs of edges whose boxes meet, and a ray for
/// each ring.
template <class S>
Relation relate(const Polygon<S, 2>& a, const Polygon<S, 2>& b) {
  using namespace polygon_polygon::detail;
  if (!all_finite(a) || !all_finite(b)) return Relation::disjoint;
  const std::optional<Aabb<double, 2>> box_a = box_of(a), box_b = box_of(b);
  if (!box_a || !box_b || !intersects(*box_a, *box_b)) return Relation::disjoint;
  std::vector<Edge> edges;
  add_edges(a, false, edges);
  add_edges(b, true, edges);
  const Edges sorted(std::move(edges));
  return Overlay(sorted).found().relation();
}

/// Whether two polygons have a common point. Exact; see relate. It stops at the first edges that meet: O(n lg m), and
/// the pairs of an edge of each whose boxes meet.
template <class S>
bool intersects(const Polygon<S, 2>& a, const Polygon<S, 2>& b) {
  using namespace polygon_polygon::detail;
  if (!all_finite(a) || !all_finite(b)) return false;
  const std::optional<Aabb<double, 2>> box_a = box_of(a), box_b = box_of(b);
  if (!box_a || !box_b || !intersects(*box_a, *box_b)) return false;
  std::vector<Edge> of_a, of_b;
  add_edges(a, false, of_a);
  add_edges(b, true, of_b);
  const Edges sorted(std::move(of_b));
  for (const Edge& e : of_a) {
    const Aabb<double, 2> box = box_of(e.p, e.q);
    const Segment<double, 2> edge = {e.p, e.q};
    const auto meets = [&](int i) { return intersects(edge, Segment<double, 2>{sorted.all[i].p, sorted.all[i].q}); };
    if (sorted.any([&](const Aabb<double, 2>& other) { return intersects(box, other); }, meets)) return true;
  }
  // no ring crosses another one's edges: all of it lies within, or nothing
  for (const Edge& e : of_a)
    if (e.start && sorted.within(e.p)[1]) return true;
  const Edges others(std::move(of_a));
  return std::any_of(sorted.all.begin(), sorted.all.end(),
                     [&](const Edge& e) { return e.start && others.within(e.p)[0]; });
}

/// How a segment (A) lies to a polygon (B), a set as above. The segment has its interior between its ends: what pierces
/// overlaps, what runs along the boundary and leaves it touches, what lies within or along an edge lies in the polygon.
/// Ends that coincide are a point: it lies in the polygon or is disjoint. Exact for all finite input; O(n lg n). NaN or
/// an infinite coordinate: disjoint.
template <class S>
Relation relate(const Segment<S, 2>& a, const Polygon<S, 2>& b) {
  using namespace polygon_polygon::detail;
  if (!finite(a) || !all_finite(b)) return Relation::disjoint;
  if (a.p == a.q) return relate_point(a.p, b);
  const Segment<double, 2> wide = cast<double>(a);
  Mark from = {Mark::Kind::number}, to = {Mark::Kind::number};
  to.number = 1;
  return relate_part(LineOfSegment{wide.p, wide.q}, from, to, b);
}

/// Whether a segment and a polygon have a common point. Exact; O(n).
template <class S>
bool intersects(const Segment<S, 2>& a, const Polygon<S, 2>& b) {
  if (!finite(a) || !polygon_polygon::detail::all_finite(b)) return false;
  for (const Ring<S, 2>& ring : b.rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (intersects(a, Segment<S, 2>{ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]})) return true;
  return locate(a.p, b) != Location::out;
}

/// How a ray, a segment o + t d or a line (A) lies to a polygon (B): as a segment does, with the ends of the range,
/// which may be infinite. A zero direction, or a range of one t, is a point. Empty, NaN, or another number that is
/// infinite: disjoint. Exact; O(n lg n).
template <class S>
Relation relate(const Ray<S, 2>& a, const Polygon<S, 2>& b) {
  using namespace polygon_polygon::detail;
  constexpr Interval<S> all = infinite<S>;
  const bool has_t = a.range.lo <= a.range.hi && a.range.lo < all.hi && a.range.hi > all.lo;
  if (!has_t || !finite(a.origin) || !finite(a.direction) || !all_finite(b)) return Relation::disjoint;
  if (a.direction == Vector<S, 2>(S(0), S(0))) return relate_point(a.origin, b);
  const Ray<double, 2> wide = cast<double>(a);
  const auto end = [](double t) -> std::optional<Mark> {
    if (std::isinf(t)) return {};
    Mark mark = {Mark::Kind::number};
    mark.number = t;
    return mark;
  };
  return relate_part(LineOfRay{wide.origin, wide.direction}, end(wide.range.lo), end(wide.range.hi), b);
}

/// Whether a ray and a polygon have a common point. Exact; see relate.
template <class S>
bool intersects(const Ray<S, 2>& a, const Polygon<S, 2>& b) {
  return relate(a, b) != Relation::disjoint;
}

}  // namespace isect
