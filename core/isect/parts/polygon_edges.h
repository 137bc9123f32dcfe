#pragma once
// The edges of polygons with the hierarchy of their boxes, lines that they lie on, and the order of places on a line.
// See isect/polygon_polygon.h.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <isect/many/bvh.h>
#include <isect/many/bvh_pairs.h>
#include <isect/orient.h>
#include <isect/point_polygon.h>
#include <isect/segment_segment.h>
#include <isect/shapes.h>

namespace isect::polygon_polygon::detail {

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

}  // namespace isect::polygon_polygon::detail
