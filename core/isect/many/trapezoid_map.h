#pragma once
// Point location by a trapezoidal map: O(log n) expected, in O(n) space, after O(n log n) expected preparation.
//
// From every vertex a wall runs up and down to the next edge. Walls and edges cut the plane into at most 3 n + 1
// trapezoids, each between a top and a bottom edge and two walls; the winding number is constant in each. The map
// grows edge by edge, in random order. The edge is followed through the trapezoids that it cuts, from its left end:
// where the right wall of one is reached, the vertex of the wall lies above or below the edge, and so tells the next.
// Each is cut by the edge, and by a wall at an end of it; pieces that a wall no longer parts become one again.
//
// How the map grew answers where a point is. Where a trapezoid was cut there is a question now: left or right of the
// vertex, above or below the edge? Questions lead to further ones and at last to a trapezoid of today: a graph
// without cycles, whose paths have O(log n) steps on average over the orders, whatever the polygon.
//
// Points are ordered by x, then by y: as if sheared a little, so that no two are one above the other and vertical
// edges are edges like others. Above and below are signs of orient2d: all of it is exact.
//
// Source: Mulmuley, A fast planar partition algorithm, J. Symb. Comput. 10 (1990); Seidel, A simple and fast
// incremental randomized algorithm, Comput. Geom. 1 (1991); de Berg et al., Computational Geometry (2008), ch. 6;
// Amenta, Choi, Rote, Incremental constructions con BRIO, SoCG (2003), for the rounds.

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include <isect/polygon_pieces.h>

namespace isect {

/// A polygon prepared for point location. `make_trapezoid_map` makes it.
struct TrapezoidMap {
  /// The region between two pieces of the boundary and two walls; without one of them it goes on for ever.
  struct Trapezoid {
    int bottom, top;  ///< pieces; -1 for none
    int left, right;  ///< the vertices of its walls; -1 and the number of vertices for none
  };
  enum class Ask : std::int32_t {
    vertex,  ///< first: before it, second: after it
    piece,   ///< first: below it, second: above it
    nothing  ///< `index` is a trapezoid
  };
  struct Node {
    Ask ask;
    int index, first, second;
  };
  PolygonPieces boundary;
  std::vector<int> lonely;  ///< vertices without a piece: points that rings of one point have
  std::vector<Trapezoid> trapezoids;
  std::vector<Node> nodes;  ///< the first one is asked first

  std::size_t bytes() const {
    return boundary.vertices.size() * sizeof boundary.vertices[0] + boundary.pieces.size() * sizeof boundary.pieces[0] +
           lonely.size() * sizeof lonely[0] + trapezoids.size() * sizeof(Trapezoid) + nodes.size() * sizeof(Node);
  }
  /// The winding number in the interior of a trapezoid.
  int winding(const Trapezoid& t) const { return t.bottom < 0 ? 0 : boundary.pieces[t.bottom].above; }
};

namespace trapezoid_map {

/// The point comes before (-1) or after (1) a vertex in the order of x, then y; or is the vertex (0).
struct VertexAsked {
  int vertex, side;
};
/// The point lies above (1), below (-1) or on (0) a piece.
struct PieceAsked {
  int piece, side;
};
struct Reached {
  int trapezoid;
};
using Event = std::variant<VertexAsked, PieceAsked, Reached, Fallback>;

/// A piece was added: how many trapezoids it cut.
struct Inserted {
  int piece, cut;
};
using BuildEvent = std::variant<Inserted>;

/// Grows the map of a boundary, piece by piece: make_trapezoid_map is this in random order. The map has its boundary,
/// and no piece yet.
class Builder {
 public:
  explicit Builder(TrapezoidMap& map) : map_(map) {
    add({none, none, none, static_cast<int>(map.boundary.vertices.size())});
    map_.nodes.push_back({TrapezoidMap::Ask::nothing, 0, none, none});
    nodes_[0] = 0;
  }

  /// Returns how many trapezoids the piece cuts.
  int insert(int piece) {
    const PolygonPieces::Piece& s = map_.boundary.pieces[piece];
    cut_.clear();
    cut_.push_back(start_of(s));
    while (at(cut_.back()).right < s.high) {
      const Links& next = links(cut_.back());
      const bool wall_above = map_.boundary.side(piece, map_.boundary.vertex(at(cut_.back()).right)) > 0;
      cut_.push_back(wall_above ? next.lower_right : next.upper_right);
    }

    int below = none, above = none;  // the new trapezoids along the piece
    for (std::size_t i = 0; i < cut_.size(); ++i) {
      const int old = cut_[i];
      const Trapezoid t = at(old);
      const Links around = links(old);
      const bool starts = i == 0, ends = i + 1 == cut_.size();
      const int left = starts && t.left != s.low ? add({t.bottom, t.top, t.left, s.low}) : none;
      const int right = ends && t.right != s.high ? add({t.bottom, t.top, s.high, t.right}) : none;
      const int from = starts ? s.low : t.left, to = ends ? s.high : t.right;

      const int below_before = below, above_before = above;
      if (below == none || at(below).bottom != t.bottom) below = add({t.bottom, piece, from, to});
      if (above == none || at(above).top != t.top) above = add({piece, t.top, from, to});
      at(below).right = at(above).right = to;

      if (left != none) {
        link_lower(around.lower_left, left), link_upper(around.upper_left, left);
        link_lower(left, below), link_upper(left, above);
      } else if (starts) {
        link_lower(around.lower_left, below), link_upper(around.upper_left, above);
      }
      if (below != below_before && !starts) {
        link_lower(around.lower_left, below), link_upper(below_before, below);
      }
      if (above != above_before && !starts) {
        link_lower(above_before, above), link_upper(around.upper_left, above);
      }
      if (right != none) {
        link_lower(below, right), link_upper(above, right);
        link_lower(right, around.lower_right), link_upper(right, around.upper_right);
      } else {
        link_lower(below, around.lower_right), link_upper(above, around.upper_right);
      }
      replace(old, piece, left, right, below, above);
    }
    for (const int old : cut_) free_.push_back(old);
    return static_cast<int>(cut_.size());
  }

 private:
  using Trapezoid = TrapezoidMap::Trapezoid;
  using Ask = TrapezoidMap::Ask;
  static constexpr int none = -1;
  /// The trapezoids beyond the walls that share the bottom (lower) or the top (upper).
  struct Links {
    int lower_left = none, upper_left = none, lower_right = none, upper_right = none;
  };

  Trapezoid& at(int i) { return map_.trapezoids[i]; }
  Links& links(int i) { return links_[i]; }
  void link_lower(int left, int right) {
    if (left != none) links(left).lower_right = right;
    if (right != none) links(right).lower_left = left;
  }
  void link_upper(int left, int right) {
    if (left != none) links(left).upper_right = right;
    if (right != none) links(right).upper_left = left;
  }

  int add(const Trapezoid& t) {
    if (free_.empty()) {
      map_.trapezoids.push_back(t), links_.push_back({}), nodes_.push_back(none);
      return static_cast<int>(map_.trapezoids.size()) - 1;
    }
    const int i = free_.back();
    free_.pop_back();
    at(i) = t, links(i) = {}, nodes_[i] = none;
    return i;
  }

  /// The trapezoid that a piece enters from its low end.
  int start_of(const PolygonPieces::Piece& s) const {
    int i = 0;
    for (;;) {
      const TrapezoidMap::Node& node = map_.nodes[i];
      if (node.ask == Ask::nothing) return node.index;
      if (node.ask == Ask::vertex) {
        i = s.low < node.index ? node.first : node.second;
        continue;
      }
      const PolygonPieces::Piece& asked = map_.boundary.pieces[node.index];
      const int ask_at = s.low == asked.low ? s.high : s.low;
      i = map_.boundary.side(node.index, map_.boundary.vertex(ask_at)) < 0 ? node.first : node.second;
    }
  }

  /// The node of a trapezoid; a new one unless it has one.
  int node_of(int trapezoid) {
    int& node = nodes_[trapezoid];
    if (node == none) {
      node = static_cast<int>(map_.nodes.size());
      map_.nodes.push_back({Ask::nothing, trapezoid, none, none});
    }
    return node;
  }
  /// Puts questions in the place of a trapezoid that was cut.
  void replace(int old, int piece, int left, int right, int below, int above) {
    const PolygonPieces::Piece& s = map_.boundary.pieces[piece];
    int place = nodes_[old];
    const auto ask = [&](const TrapezoidMap::Node& node) { map_.nodes[place] = node; };
    const auto new_node = [&] {
      map_.nodes.emplace_back();
      return static_cast<int>(map_.nodes.size()) - 1;
    };
    if (left != none) {
      const int first = node_of(left), second = new_node();
      ask({Ask::vertex, s.low, first, second});
      place = second;
    }
    if (right != none) {
      const int second = node_of(right), first = new_node();
      ask({Ask::vertex, s.high, first, second});
      place = first;
    }
    const int first = node_of(below), second = node_of(above);
    ask({Ask::piece, piece, first, second});
  }

  TrapezoidMap& map_;
  std::vector<Links> links_;
  std::vector<int> nodes_;  ///< of each trapezoid
  std::vector<int> free_;   ///< trapezoids that are no more
  std::vector<int> cut_;
};

namespace detail {

/// Brings an order drawn at random into rounds, each as large as all before, and a round's pieces into the order of the
/// boundary: neighbours are added one after the other, and what they touch is still in the cache. An early round is a
/// random sample as before, so paths stay short. The first pieces keep their order.
inline void order_rounds(std::vector<int>& order, const std::vector<PolygonPieces::Piece>& pieces) {
  const auto along = [&](int a, int b) {
    const PolygonEdge &x = pieces[a].edge, &y = pieces[b].edge;
    return std::tie(x.ring, x.index, a) < std::tie(y.ring, y.index, b);
  };
  const std::ptrdiff_t size = std::ssize(order);
  for (std::ptrdiff_t begin = 256; begin < size; begin *= 2)
    std::sort(order.begin() + begin, order.begin() + std::min(2 * begin, size), along);
}

}  // namespace detail

}  // namespace trapezoid_map

/// The map of a boundary, its pieces added in this order, each once. A bad order, such as from left to right, makes
/// paths of O(n) steps: it is for lessons and comparison.
template <class Trace = NoTrace>
TrapezoidMap make_trapezoid_map_in_order(PolygonPieces boundary, const std::vector<int>& order, Trace&& trace = {}) {
  TrapezoidMap map;
  map.boundary = std::move(boundary);
  std::vector<bool> used(map.boundary.vertices.size());
  for (const PolygonPieces::Piece& s : map.boundary.pieces) used[s.low] = used[s.high] = true;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (!used[v]) map.lonely.push_back(static_cast<int>(v));

  trapezoid_map::Builder builder(map);
  for (const int piece : order) {
    const int cut = builder.insert(piece);
    trace(trapezoid_map::Inserted{piece, cut});
  }
  return map;
}

/// The map of a boundary; another seed draws another order, and gives the same answers.
template <class Trace = NoTrace>
TrapezoidMap make_trapezoid_map(PolygonPieces boundary, std::uint64_t seed = 1, Trace&& trace = {}) {
  std::vector<int> order(boundary.pieces.size());
  std::iota(order.begin(), order.end(), 0);
  std::mt19937_64 random(seed);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  trapezoid_map::detail::order_rounds(order, boundary.pieces);
  return make_trapezoid_map_in_order(std::move(boundary), order, trace);
}

/// How many questions the longest path of a search asks.
inline int depth(const TrapezoidMap& map) {
  std::vector<int> below(map.nodes.size(), -1);  // the longest path from each node that was seen
  std::vector<int> open;
  if (!map.nodes.empty()) open.push_back(0);
  while (!open.empty()) {
    const int i = open.back();
    const TrapezoidMap::Node& node = map.nodes[i];
    const bool asks = node.ask != TrapezoidMap::Ask::nothing;
    if (asks && (below[node.first] < 0 || below[node.second] < 0)) {
      for (const int next : {node.first, node.second})
        if (below[next] < 0) open.push_back(next);
      continue;
    }
    below[i] = asks ? 1 + std::max(below[node.first], below[node.second]) : 0;
    open.pop_back();
  }
  return below.empty() ? 0 : below[0];
}
/// The map of a polygon. Throws std::invalid_argument that names two edges that cross where there is no vertex (a
/// bow-tie): see make_polygon_pieces. Any other polygon will do: several rings, of any orientation, with repeated
/// vertices, spikes, and edges that touch or coincide.
template <class S, class Trace = NoTrace>
TrapezoidMap make_trapezoid_map(std::span<const Ring<S, 2>> rings, std::uint64_t seed = 1, Trace&& trace = {}) {
  return make_trapezoid_map(make_polygon_pieces(rings), seed, trace);
}
template <class S, class Trace = NoTrace>
TrapezoidMap make_trapezoid_map(const Polygon<S, 2>& polygon, std::uint64_t seed = 1, Trace&& trace = {}) {
  return make_trapezoid_map(std::span<const Ring<S, 2>>(polygon.rings), seed, trace);
}
template <class S, class Trace = NoTrace>
TrapezoidMap make_trapezoid_map(const Ring<S, 2>& ring, std::uint64_t seed = 1, Trace&& trace = {}) {
  return make_trapezoid_map(std::span<const Ring<S, 2>>(&ring, 1), seed, trace);
}

/// How often the rings go around the point, counter-clockwise; nothing when it lies on the boundary. Exact, in
/// O(log n) expected comparisons. A point with a NaN or infinite coordinate: 0.
template <class S, class Trace = NoTrace>
std::optional<int> winding(const Point<S, 2>& point, const TrapezoidMap& map, Trace&& trace = {}) {
  using namespace trapezoid_map;
  if (!finite(point)) return 0;
  const Point<double, 2> p = point.template cast<double>();
  const auto precedes = [&](int v, const Point<double, 2>& q) { return before(map.boundary.vertex(v), q); };
  const auto lonely = std::lower_bound(map.lonely.begin(), map.lonely.end(), p, precedes);
  if (lonely != map.lonely.end() && map.boundary.vertex(*lonely) == p) return {};

  TrapezoidMap::Node node = map.nodes.front();
  while (node.ask != TrapezoidMap::Ask::nothing) {
    int side = 0;
    if (node.ask == TrapezoidMap::Ask::vertex) {
      const Point<double, 2>& v = map.boundary.vertex(node.index);
      side = before(v, p) - before(p, v);
      trace(VertexAsked{node.index, side});
    } else {
      side = map.boundary.side(node.index, p, trace);
      trace(PieceAsked{node.index, side});
    }
    if (side == 0) return {};
    node = map.nodes[side < 0 ? node.first : node.second];
  }
  trace(Reached{node.index});
  return map.winding(map.trapezoids[node.index]);
}

/// Where the point lies. Otherwise as `winding`.
template <class S, class Trace = NoTrace>
Location locate(const Point<S, 2>& point, const TrapezoidMap& map, FillRule rule = FillRule::even_odd,
                Trace&& trace = {}) {
  return location(winding(point, map, trace), rule);
}

}  // namespace isect
