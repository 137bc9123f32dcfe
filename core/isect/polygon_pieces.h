#pragma once
// The boundary of a polygon as pieces that meet in their end points only: what the maps of point location start from.
//
// A line sweeps over the vertices, by x, and by y where x is the same: as if the plane were sheared a little, so that
// no two have the same x and no edge is vertical. The edges on the line are kept in order, from below to above. It
// changes at vertices only, unless two edges cross elsewhere; and those were neighbours before. So every two that
// become neighbours are looked at. At a vertex the pieces that hold it end, and start again there if they went on:
// the vertex lies on them exactly, and cuts no corner. Edges that leave it in one direction are one piece, up to the
// nearest of their ends; there the others go on as one heap, cut as a whole however many edges run along it. Just above
// a piece the polygon winds as often as just below, once more for each edge that runs to the right, once less for each
// that runs to the left.
//
// All of it is comparisons and signs of polynomials, mostly orient2d: exact. The pieces are the edges of a planar
// graph, fewer than 3 n: O(n log n) for any polygon. Source: Shamos, Hoey, Geometric intersection problems, FOCS
// (1976); de Berg et al., Computational Geometry (2008), 2.1, for what happens at a vertex; Sleator, Tarjan,
// Self-adjusting heaps, SIAM J. Comput. 15 (1986), for the heaps.

#include <algorithm>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <isect/orient.h>
#include <isect/parts/sort_points.h>
#include <isect/point_polygon.h>
#include <isect/shapes.h>

namespace isect {

/// The edge from vertex `index` of ring `ring` to the next one.
struct PolygonEdge {
  int ring, index;
  friend bool operator==(const PolygonEdge&, const PolygonEdge&) = default;
};

/// The boundary of a polygon. The pieces have a length, are distinct, and have no point in common except their ends.
struct PolygonPieces {
  struct Piece {
    int low, high;     ///< its ends, as numbers of vertices: low < high
    int times;         ///< how many edges run along it from low to high, less those that run back
    int above;         ///< the winding number above it: on the left of low -> high
    PolygonEdge edge;  ///< one of those that it is part of
  };
  std::vector<Point<double, 2>> vertices;  ///< distinct; by x, and by y where that is the same
  std::vector<Piece> pieces;               ///< by their low ends, and from below to above

  /// On which side of a piece a point lies: 1 above, -1 below, 0 on its line.
  template <class Trace = NoTrace>
  int side(int piece, const Point<double, 2>& p, Trace&& trace = {}) const {
    const Piece& s = pieces[piece];
    return orient2d(vertex(s.low), vertex(s.high), p, trace);
  }
  const Point<double, 2>& vertex(int i) const { return vertices[i]; }
};

namespace polygon_pieces {

namespace detail {

/// The pieces on the sweeping line, and what is still to come.
class Sweep {
 public:
  explicit Sweep(PolygonPieces& out) : out_(out), first_(out.vertices.size(), none), last_(out.vertices.size(), none) {}

  /// Adds an edge, which the line will meet at its low end.
  void add(int low, int high, int times, const PolygonEdge& edge) {
    strands_.push_back({high, times, times, edge, none, none, none});
    start(low, static_cast<int>(strands_.size()) - 1);
  }

  void visit(int v) {
    const auto [from, to] = through(v);
    for (auto it = from; it != to; ++it) {
      out_.pieces[it->piece].high = v;
      int left = it->strands;
      while (left != none && strand(left).high == v) left = without_first(left);
      if (left != none) start(v, left);
    }
    const Line::iterator above = line_.erase(from, to);
    const Line::iterator below = above == line_.begin() ? line_.end() : std::prev(above);

    int winding = below == line_.end() ? 0 : out_.pieces[below->piece].above;
    collect(v);
    for (std::size_t i = 0; i < around_.size();) {
      int strands = around_[i];
      while (++i < around_.size() && same_direction(v, strands, around_[i])) strands = merged(strands, around_[i]);
      const Strand top = strand(strands);
      winding += top.all;
      const int piece = static_cast<int>(out_.pieces.size());
      out_.pieces.push_back({v, top.high, top.all, winding, top.edge});
      places_.push_back(line_.insert(above, {out_.vertex(v), out_.vertex(top.high), piece, strands}));
      last_[top.high] = piece;
    }

    const Line::iterator highest = above == line_.begin() ? line_.end() : std::prev(above);
    if (highest != below) refuse_crossing(below, below == line_.end() ? line_.begin() : std::next(below));
    refuse_crossing(highest, above);
  }

 private:
  static constexpr int none = -1;
  /// An edge, or what is left of one. Those along one piece are a skew heap, the nearest end at its root.
  struct Strand {
    int high, times;
    int all;  ///< for a root: the sum of `times` over its heap
    PolygonEdge edge;
    int left, right;
    int next;  ///< for a root: another heap that starts at the same vertex
  };
  /// A piece on the line. It carries its points: a search that fetched them would wait for memory. When
  /// the piece is cut, `high` stays; that is on the same line.
  struct Standing {
    Point<double, 2> low, high;
    int piece, strands;

    int side(const Point<double, 2>& p) const { return orient2d(low, high, p); }
  };
  /// The order on the line. Pieces are compared where the later of them starts.
  struct Below {
    using is_transparent = void;

    bool operator()(const Standing& a, const Point<double, 2>& v) const { return a.side(v) > 0; }
    bool operator()(const Point<double, 2>& v, const Standing& a) const { return a.side(v) < 0; }
    bool operator()(const Standing& a, const Standing& b) const {
      if (before(b.low, a.low)) return b.side(a.low) < 0;
      return a.side(before(a.low, b.low) ? b.low : b.high) > 0;
    }
  };
  using Line = std::set<Standing, Below>;

  Strand& strand(int i) { return strands_[i]; }
  void start(int v, int strands) {
    int& first = first_[v];
    strand(strands).next = first;
    first = strands;
  }
  /// Merges two heaps along the same line.
  int merged(int a, int b) {
    const int all = (a == none ? 0 : strand(a).all) + (b == none ? 0 : strand(b).all);
    int root = none;
    for (int* place = &root;;) {
      if (a == none || b == none) {
        *place = a == none ? b : a;
        break;
      }
      if (strand(b).high < strand(a).high) std::swap(a, b);
      *place = a;
      Strand& nearest = strand(a);
      a = nearest.right, nearest.right = nearest.left;
      place = &nearest.left;
    }
    if (root != none) strand(root).all = all;
    return root;
  }
  int without_first(int root) {
    const int all = strand(root).all - strand(root).times, left = strand(root).left, right = strand(root).right;
    const int rest = merged(left, right);
    if (rest != none) strand(rest).all = all;
    return rest;
  }

  /// The pieces on the line that hold a vertex. Most vertices end a piece, whose place is known: its neighbours may
  /// hold the vertex too. Else it is searched for.
  std::pair<Line::iterator, Line::iterator> through(int v) const {
    const int known = last_[v];
    if (known == none || out_.pieces[known].high != v) return line_.equal_range(out_.vertex(v));
    const auto holds = [&](const Standing& other) { return other.side(out_.vertex(v)) == 0; };
    Line::iterator from = places_[known], to = std::next(from);
    while (from != line_.begin() && holds(*std::prev(from))) --from;
    while (to != line_.end() && holds(*to)) ++to;
    return {from, to};
  }

  /// Collects what starts at a vertex, from below to above, in one direction the nearest end first.
  void collect(int v) {
    around_.clear();
    for (int s = first_[v]; s != none; s = strand(s).next) around_.push_back(s);
    std::sort(around_.begin(), around_.end(), [&](int a, int b) {
      const int p = strand(a).high, q = strand(b).high;
      const int turn = orient2d(out_.vertex(v), out_.vertex(p), out_.vertex(q));
      return turn != 0 ? turn > 0 : p < q;
    });
  }
  bool same_direction(int v, int a, int b) {
    const int p = strand(a).high, q = strand(b).high;
    return p == q || orient2d(out_.vertex(v), out_.vertex(p), out_.vertex(q)) == 0;
  }

  /// Throws where neighbours cross, unless they do so at a vertex, where both will be cut.
  void refuse_crossing(Line::iterator a, Line::iterator b) const {
    if (a == line_.end() || b == line_.end()) return;
    if (a->side(b->low) * a->side(b->high) >= 0 || b->side(a->low) * b->side(a->high) >= 0) return;
    const PolygonPieces::Piece &s = out_.pieces[a->piece], &t = out_.pieces[b->piece];
    int first = std::max(s.low, t.low) + 1, last = std::min(s.high, t.high);  // the crossing lies between them
    while (first < last) {
      const int middle = first + (last - first) / 2;
      if (comes_before_crossing(out_.vertex(middle), *a, *b))
        first = middle + 1;
      else
        last = middle;
    }
    if (a->side(out_.vertex(first)) == 0 && b->side(out_.vertex(first)) == 0) return;
    const auto name = [](const PolygonEdge& e) {
      return "edge " + std::to_string(e.index) + " of ring " + std::to_string(e.ring);
    };
    throw std::invalid_argument(name(s.edge) + " and " + name(t.edge) + " cross where there is no vertex");
  }

  /// Whether v comes before the point X in which two pieces cross. With their directions d and e,
  ///   (v - X) d x e = (v - a.low) d x e - ((b.low - a.low) x e) d.
  static bool comes_before_crossing(const Point<double, 2>& v, const Standing& a, const Standing& b) {
    const int turn = a.side(b.high);  // the sign of d x e, as b.low lies on the other side
    for (const int i : {0, 1}) {
      const auto beyond = [&]<class W>() -> W {
        const Components<W, 2> d = difference<W, 2>(a.high, a.low), e = difference<W, 2>(b.high, b.low),
                               f = difference<W, 2>(b.low, a.low);
        return difference<W>(v[i], a.low[i]) * (d[0] * e[1] - d[1] * e[0]) - (f[0] * e[1] - f[1] * e[0]) * d[i];
      };
      if (const int side = turn * sign_of(beyond); side != 0) return side < 0;
    }
    return false;
  }

  PolygonPieces& out_;
  Line line_;
  std::vector<Strand> strands_;
  std::vector<int> first_;              ///< a heap of strands that starts at each vertex
  std::vector<int> last_;               ///< a piece that ends at each vertex, unless it was cut before
  std::vector<Line::iterator> places_;  ///< of each piece, while it is on the line
  std::vector<int> around_;
};

}  // namespace detail

}  // namespace polygon_pieces

/// The pieces of the boundary of several rings. Edges may share end points, points and stretches, and cross where one
/// of them has a vertex, or a third; edges without length are a vertex only. Throws std::invalid_argument that names
/// the two when edges cross elsewhere. Nothing when a coordinate is NaN or infinite: such a polygon meets nothing.
template <class S>
PolygonPieces make_polygon_pieces(std::span<const Ring<S, 2>> rings) {
  PolygonPieces all;
  for (const Ring<S, 2>& ring : rings) {
    if (!finite(ring)) return {};
    for (const Point<S, 2>& v : ring) all.vertices.push_back(v.template cast<double>());
  }
  if (all.vertices.size() >= std::size_t{1} << 30) throw std::length_error("a polygon of 2^30 vertices or more");

  struct Numbered {
    Point<double, 2> at;
    std::size_t number;
  };
  std::vector<Numbered> sorted;
  for (const Point<double, 2>& v : all.vertices) sorted.push_back({v, sorted.size()});
  std::sort(sorted.begin(), sorted.end(), [](const Numbered& a, const Numbered& b) { return before(a.at, b.at); });
  std::vector<Point<double, 2>> distinct;
  std::vector<int> number(sorted.size());  // of each vertex, among the distinct ones
  for (const Numbered& v : sorted) {
    if (distinct.empty() || v.at != distinct.back()) distinct.push_back(v.at);
    number[v.number] = static_cast<int>(distinct.size()) - 1;
  }
  all.vertices = std::move(distinct);

  polygon_pieces::detail::Sweep sweep(all);
  std::size_t start = 0;
  for (std::size_t r = 0; r < rings.size(); start += rings[r].size(), ++r)
    for (std::size_t i = 0; i < rings[r].size(); ++i) {
      const int a = number[start + i], b = number[start + (i + 1 < rings[r].size() ? i + 1 : 0)];
      if (a != b) sweep.add(std::min(a, b), std::max(a, b), a < b ? 1 : -1, {static_cast<int>(r), static_cast<int>(i)});
    }
  for (int v = 0; v < static_cast<int>(all.vertices.size()); ++v) sweep.visit(v);
  return all;
}

/// Where a point with this winding number lies; nothing stands for the boundary.
inline Location location(const std::optional<int>& winding, FillRule rule) {
  if (!winding) return Location::on;
  return (rule == FillRule::even_odd ? *winding % 2 != 0 : *winding != 0) ? Location::in : Location::out;
}

}  // namespace isect
