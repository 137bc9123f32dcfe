#pragma once
// The boundary of a polygon as pieces that meet in their end points only: what the maps of point location start from.
//
// A line sweeps over the vertices, by x, and by y where x is the same: as if the plane were sheared a little, so that
// no two have the same x and no edge is vertical. The edges on the line are kept in order, from below to above. It
// changes at vertices only, unless two edges cross elsewhere; and those were neighbours before. So every two that
// become neighbours are looked at. At a vertex the pieces that hold it end, and start again there if they went on:
// the vertex lies on them exactly, and cuts no corner. Edges that leave it in one direction are one piece, up to the
// nearest of their ends. Just above a piece the polygon winds as often as just below, once more for each edge that
// runs to the right, once less for each that runs to the left.
//
// All of it is comparisons and signs of orient2d: exact. O((n + k) log n) time, where k counts the vertices within
// edges, and O(n) more for each crossing at a vertex. Source: Shamos, Hoey, Geometric intersection problems, FOCS
// (1976); de Berg et al., Computational Geometry (2008), 2.1, for what happens at a vertex.

#include <algorithm>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/orient.h"
#include "core/point_polygon.h"
#include "core/shapes.h"

namespace isect {

/// The edge from vertex `index` of ring `ring` to the next one.
struct PolygonEdge {
  int ring, index;
  friend bool operator==(const PolygonEdge&, const PolygonEdge&) = default;
};

/// The boundary of a polygon. The pieces have a length, are distinct, and have no point in common but their ends.
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
    const Piece& s = pieces[static_cast<std::size_t>(piece)];
    return orient2d(vertex(s.low), vertex(s.high), p, trace);
  }
  const Point<double, 2>& vertex(int i) const { return vertices[static_cast<std::size_t>(i)]; }
};

namespace polygon_pieces {

/// By x, and by y where that is the same.
inline bool before(const Point<double, 2>& a, const Point<double, 2>& b) {
  return a[0] < b[0] || (a[0] == b[0] && a[1] < b[1]);
}

/// The pieces on the sweeping line, and what is still to come.
class Sweep {
 public:
  explicit Sweep(PolygonPieces& out) : out_(out), line_(Below{&out}), first_(out.vertices.size(), none) {}

  /// An edge, or what is left of one, that will be met at its low end.
  void add(int low, int high, int times, const PolygonEdge& edge) {
    int& first = first_[static_cast<std::size_t>(low)];
    strands_.push_back({high, times, edge, first});
    first = static_cast<int>(strands_.size()) - 1;
  }

  void visit(int v) {
    auto [from, to] = line_.equal_range(Vertex{v});
    for (auto it = from; it != to; ++it) {
      PolygonPieces::Piece& piece = out_.pieces[static_cast<std::size_t>(*it)];
      if (piece.high != v) add(v, piece.high, piece.times, piece.edge);
      piece.high = v;
    }
    const Line::iterator above = line_.erase(from, to);
    const int below = above == line_.begin() ? none : *std::prev(above);

    int lowest = none, winding = below == none ? 0 : piece_above(below), last = below;
    collect(v);
    for (std::size_t i = 0; i < around_.size();) {
      const Strand head = strands_[static_cast<std::size_t>(around_[i])];
      int times = 0;
      for (; i < around_.size() && same_direction(v, head, around_[i]); ++i) {
        const Strand strand = strands_[static_cast<std::size_t>(around_[i])];
        times += strand.times;
        if (strand.high != head.high) add(head.high, strand.high, strand.times, strand.edge);
      }
      winding += times;
      last = static_cast<int>(out_.pieces.size());
      out_.pieces.push_back({v, head.high, times, winding, head.edge});
      line_.emplace_hint(above, last);
      if (lowest == none) lowest = last;
    }

    if (lowest != none) refuse_crossing(below, lowest);
    if (above != line_.end()) refuse_crossing(last, *above);
  }

 private:
  static constexpr int none = -1;
  struct Strand {
    int high, times;
    PolygonEdge edge;
    int next;  ///< another one with the same low end
  };
  struct Vertex {
    int index;
  };
  /// The order on the line. Pieces are compared where the later of them starts.
  struct Below {
    using is_transparent = void;
    const PolygonPieces* all;

    bool operator()(int a, const Vertex& v) const { return all->side(a, all->vertex(v.index)) > 0; }
    bool operator()(const Vertex& v, int a) const { return all->side(a, all->vertex(v.index)) < 0; }
    bool operator()(int a, int b) const {
      const PolygonPieces::Piece &s = all->pieces[static_cast<std::size_t>(a)],
                                 &t = all->pieces[static_cast<std::size_t>(b)];
      if (s.low > t.low) return all->side(b, all->vertex(s.low)) < 0;
      return all->side(a, all->vertex(s.low < t.low ? t.low : t.high)) > 0;
    }
  };
  using Line = std::set<int, Below>;

  int piece_above(int piece) const { return out_.pieces[static_cast<std::size_t>(piece)].above; }

  /// What starts at a vertex, from below to above, of one direction the nearest end first.
  void collect(int v) {
    around_.clear();
    for (int s = first_[static_cast<std::size_t>(v)]; s != none;
         s = strands_[static_cast<std::size_t>(s)].next)
      around_.push_back(s);
    std::sort(around_.begin(), around_.end(), [&](int a, int b) {
      const int p = strands_[static_cast<std::size_t>(a)].high,
                q = strands_[static_cast<std::size_t>(b)].high;
      const int turn = orient2d(out_.vertex(v), out_.vertex(p), out_.vertex(q));
      return turn != 0 ? turn > 0 : p < q;
    });
  }
  bool same_direction(int v, const Strand& a, int b) const {
    const int high = strands_[static_cast<std::size_t>(b)].high;
    return a.high == high || orient2d(out_.vertex(v), out_.vertex(a.high), out_.vertex(high)) == 0;
  }

  /// Neighbours may cross at a vertex, where both will be cut.
  void refuse_crossing(int a, int b) const {
    if (a == none || b == none) return;
    const PolygonPieces::Piece &s = out_.pieces[static_cast<std::size_t>(a)],
                               &t = out_.pieces[static_cast<std::size_t>(b)];
    if (out_.side(a, out_.vertex(t.low)) * out_.side(a, out_.vertex(t.high)) >= 0 ||
        out_.side(b, out_.vertex(s.low)) * out_.side(b, out_.vertex(s.high)) >= 0)
      return;
    for (int v = std::max(s.low, t.low) + 1; v < std::min(s.high, t.high); ++v)
      if (out_.side(a, out_.vertex(v)) == 0 && out_.side(b, out_.vertex(v)) == 0) return;
    const auto name = [](const PolygonEdge& e) {
      return "edge " + std::to_string(e.index) + " of ring " + std::to_string(e.ring);
    };
    throw std::invalid_argument(name(s.edge) + " and " + name(t.edge) + " cross where there is no vertex");
  }

  PolygonPieces& out_;
  Line line_;
  std::vector<Strand> strands_;
  std::vector<int> first_;  ///< a strand that starts at each vertex
  std::vector<int> around_;
};

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
  if (all.vertices.size() >= std::size_t{1} << 30)
    throw std::length_error("a polygon of 2^30 vertices or more");

  std::vector<int> sorted(all.vertices.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) sorted[i] = static_cast<int>(i);
  std::sort(sorted.begin(), sorted.end(),
            [&](int a, int b) { return polygon_pieces::before(all.vertex(a), all.vertex(b)); });
  std::vector<Point<double, 2>> distinct;
  std::vector<int> number(sorted.size());  // of each vertex, among the distinct ones
  for (const int i : sorted) {
    if (distinct.empty() || all.vertex(i) != distinct.back()) distinct.push_back(all.vertex(i));
    number[static_cast<std::size_t>(i)] = static_cast<int>(distinct.size()) - 1;
  }
  all.vertices = std::move(distinct);

  polygon_pieces::Sweep sweep(all);
  std::size_t start = 0;
  for (std::size_t r = 0; r < rings.size(); start += rings[r].size(), ++r)
    for (std::size_t i = 0; i < rings[r].size(); ++i) {
      const int a = number[start + i], b = number[start + (i + 1 < rings[r].size() ? i + 1 : 0)];
      if (a != b)
        sweep.add(std::min(a, b), std::max(a, b), a < b ? 1 : -1, {static_cast<int>(r), static_cast<int>(i)});
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
