#pragma once
// All edges of two polygons, cut where they meet, and a part of a line, cut by those of a polygon: on which sides of a
// piece each set lies. See isect/polygon_polygon.h.

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>
#include <vector>

#include <isect/parts/polygon_edges.h>

namespace isect::polygon_polygon::detail {

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

}  // namespace isect::polygon_polygon::detail
