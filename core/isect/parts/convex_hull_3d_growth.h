#pragma once
// The hull in space while it grows: its faces, the points on their lists, and what one more point does to them.
// isect/convex_hull_3d.h says how and why.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <variant>
#include <vector>

#include <isect/orient.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace convex_hull_3d {

/// A point joins the hull: how many faces it saw.
struct Added {
  int point, seen;
};
/// A point that joined the hull is dropped: it is not a strict vertex.
struct Dropped {
  int point;
};

namespace detail {

/// The first four points, by their indices.
struct Simplex {
  std::array<int, 4> points;
};

using Points = std::vector<Point<double, 3>>;

struct Face {
  std::array<int, 3> vertices;
  std::array<int, 3> neighbors;  ///< across the edge from vertex i to the next
  Vector<double, 3> normal;      ///< outwards, rounded
  double error;                  ///< of any height above the face
  double distance = -1;          ///< of the farthest point outside, rounded
  int farthest = -1, outside = -1;
  int asked = -1;  ///< the last point for which `seen` was found
  bool seen = false;
};

inline Point<double, 2> without_axis(const Point<double, 3>& p, int axis) {
  return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

/// An axis along which the points may be projected without coming to lie on one line; -1 when they are on one.
template <class Trace>
int projection(const Point<double, 3>& a, const Point<double, 3>& b, const Point<double, 3>& c, Trace&& trace) {
  for (int axis = 0; axis < 3; ++axis)
    if (orient2d(without_axis(a, axis), without_axis(b, axis), without_axis(c, axis), trace) != 0) return axis;
  return -1;
}

/// The index of the greatest rounded size among points that qualify; -1 when none does.
template <class Size, class Does>
int choose(const Points& points, const Size& size, const Does& does) {
  int best = 0;
  for (int i = 1; i < static_cast<int>(points.size()); ++i)
    if (size(points[i]) > size(points[best])) best = i;
  if (does(points[best])) return best;
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
    if (does(points[i])) return i;
  return -1;
}

inline bool before(const Point<double, 3>& p, const Point<double, 3>& q) {
  return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
}

/// Points that span the hull's affine space: as many as its dimension, and one more.
template <class Trace>
std::vector<int> span(const Points& points, Trace&& trace) {
  if (points.empty()) return {};
  const auto least = std::min_element(points.begin(), points.end(), before);
  const Point<double, 3> a = *least;
  std::vector<int> found = {static_cast<int>(least - points.begin())};
  const auto add = [&](const auto& size, const auto& does) {
    const int i = choose(points, size, does);
    if (i >= 0) found.push_back(i);
    return i >= 0;
  };
  if (!add([&](const auto& p) { return (p - a).squaredNorm(); }, [&](const auto& p) { return p != a; })) return found;

  const Point<double, 3> b = points[found[1]];
  const Vector<double, 3> ab = b - a;
  const auto normal = [&](const Point<double, 3>& p) -> Vector<double, 3> {
    const Vector<double, 3> ap = p - a;
    return {ab[1] * ap[2] - ab[2] * ap[1], ab[2] * ap[0] - ab[0] * ap[2], ab[0] * ap[1] - ab[1] * ap[0]};
  };
  if (!add([&](const auto& p) { return normal(p).squaredNorm(); },
           [&](const auto& p) { return projection(a, b, p, trace) >= 0; }))
    return found;

  const Point<double, 3> c = points[found[2]];
  const Vector<double, 3> n = normal(c);
  add([&](const auto& p) { return std::abs(n.dot(p - a)); },
      [&](const auto& p) { return orient3d(a, b, c, p, trace) != 0; });
  return found;
}

/// The growing hull.
template <class Trace>
class Growth {
 public:
  Growth(const Points& points, std::array<int, 4> simplex, Trace& trace)
      : points_(points), next_(points.size(), -1), start_(points.size(), -1), trace_(trace) {
    lo_ = hi_ = points[0];
    for (const Point<double, 3>& p : points) lo_ = lo_.cwiseMin(p), hi_ = hi_.cwiseMax(p);

    auto [a, b, c, d] = simplex;
    if (orient3d(points[a], points[b], points[c], points[d], trace) < 0) std::swap(a, b);
    create({a, b, c}), create({b, a, d}), create({c, b, d}), create({a, c, d});
    for (int f = 0; f < 4; ++f)
      for (int i = 0; i < 3; ++i)
        for (int g = 0; g < 4; ++g)
          if (edge_from(g, end(f, i)) >= 0 && end(g, edge_from(g, end(f, i))) == faces_[f].vertices[i])
            faces_[f].neighbors[i] = g;
    std::vector<int> all = {0, 1, 2, 3};
    for (int p = 0; p < static_cast<int>(points.size()); ++p) hand_over(p, all);
    pending_ = all;
  }

  /// Goes in rounds: new faces wait until all others had their turn, so the hull grows evenly. Else two circles around
  /// one axis would take O(n^2): one would be finished first, as a fan around a single point of the other.
  void run() {
    for (std::vector<int> round; !pending_.empty(); round.clear()) {
      round.swap(pending_);
      for (const int face : round)
        if (faces_[face].outside >= 0) add(faces_[face].farthest, face);
    }
  }

  /// The faces, cut up anew so that they have strict vertices only.
  std::vector<std::array<int, 3>> strict_triangles() {
    std::vector<int> sharp_edges(points_.size(), 0);
    for (int f = 0; f < static_cast<int>(faces_.size()); ++f)
      for (int i = 0; i < 3; ++i)
        if (alive(f) && sharp(f, i)) ++sharp_edges[faces_[f].vertices[i]];

    std::vector<std::array<int, 3>> triangles;
    std::vector<bool> done(faces_.size(), false);
    std::vector<int> plane, ring;
    for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
      if (!alive(f) || done[f]) continue;
      int first = -1;
      plane = {f},
      done[f] = true;  // all faces coplanar with f; start_ tells the next vertex along their border
      for (std::size_t k = 0; k < plane.size(); ++k)
        for (int i = 0; i < 3; ++i) {
          const int g = faces_[plane[k]].neighbors[i], from = faces_[plane[k]].vertices[i];
          if (sharp(plane[k], i)) {
            start_[from] = end(plane[k], i);
            if (sharp_edges[from] >= 3) first = from;
          } else if (!done[g]) {
            plane.push_back(g), done[g] = true;
          }
        }
      ring.clear();
      int v = first;
      do {
        if (sharp_edges[v] >= 3) ring.push_back(v);
        v = start_[v];
      } while (v != first);
      for (std::size_t k = 2; k < ring.size(); ++k) triangles.push_back({ring[0], ring[k - 1], ring[k]});
    }
    if constexpr (heard<Trace>) {
      for (int f = 0; f < static_cast<int>(faces_.size()); ++f)
        for (int& v : faces_[f].vertices)
          if (alive(f) && sharp_edges[v] < 3) trace_(Dropped{v}), sharp_edges[v] = 3;
    }
    return triangles;
  }

 private:
  int end(int face, int edge) const { return faces_[face].vertices[(edge + 1) % 3]; }
  int edge_from(int face, int vertex) const {
    for (int i = 0; i < 3; ++i)
      if (faces_[face].vertices[i] == vertex) return i;
    return -1;
  }
  bool alive(int face) const { return faces_[face].vertices[0] >= 0; }

  int create(const std::array<int, 3>& vertices) {
    Face face;
    face.vertices = vertices;
    using W = Bounded<double>;
    const Point<double, 3>&a = points_[vertices[0]], &b = points_[vertices[1]], &c = points_[vertices[2]];
    const Components<W, 3> n = cross(difference<W, 3>(b, a), difference<W, 3>(c, a));
    face.normal = {n[0].value(), n[1].value(), n[2].value()};
    face.error = dot(n, difference<W, 3>(hi_, lo_)).error();  // no point is farther from a, and no product is larger
    if (free_.empty()) {
      faces_.push_back(face);
      return static_cast<int>(faces_.size()) - 1;
    }
    const int index = free_.back();
    free_.pop_back();
    faces_[index] = face;
    return index;
  }

  double height(const Face& face, int p) const {
    const Point<double, 3>&a = points_[face.vertices[0]], &x = points_[p];
    return face.normal[0] * (x[0] - a[0]) + face.normal[1] * (x[1] - a[1]) + face.normal[2] * (x[2] - a[2]);
  }
  /// 1 when p lies above the face, -1 below, 0 in its plane.
  int side(const Face& face, int p, double height) {
    if (height > face.error) return 1;
    if (height < -face.error) return -1;
    const Point<double, 3>&a = points_[face.vertices[0]], &b = points_[face.vertices[1]],
                        &c = points_[face.vertices[2]], &x = points_[p];
    return x == a || x == b || x == c ? 0 : -orient3d(a, b, c, x, trace_);
  }
  /// Whether the neighbor across the edge is in another plane.
  bool sharp(int face, int edge) {
    const int g = faces_[face].neighbors[edge], apex = end(g, (edge_from(g, end(face, edge)) + 1) % 3);
    const int f = std::min(face, g);  // one question for both
    const int other = face < g ? apex : end(face, (edge + 1) % 3);
    return side(faces_[f], other, height(faces_[f], other)) != 0;
  }

  /// Puts p on the list of the first of the faces that it lies above, if any.
  void hand_over(int p, const std::vector<int>& faces) {
    for (const int f : faces) {
      Face& face = faces_[f];
      const double h = height(face, p);
      if (side(face, p, h) <= 0) continue;
      next_[p] = face.outside, face.outside = p;
      if (h > face.distance || face.farthest < 0) face.farthest = p, face.distance = h;
      return;
    }
  }

  /// Whether p sees the face, found once for each p.
  bool sees(int p, int f) {
    Face& face = faces_[f];
    if (face.asked != p) face.asked = p, face.seen = side(face, p, height(face, p)) > 0;
    return face.seen;
  }

  void add(int p, int face) {
    seen_ = {face}, created_.clear();
    faces_[face].asked = p, faces_[face].seen = true;
    for (std::size_t k = 0; k < seen_.size(); ++k)
      for (int i = 0; i < 3; ++i) {
        const int f = seen_[k], g = faces_[f].neighbors[i];
        const bool known = faces_[g].asked == p;
        if (sees(p, g)) {
          if (!known) seen_.push_back(g);
          continue;
        }
        const int from = faces_[f].vertices[i], to = end(f, i);
        const int fresh = create({from, to, p});
        faces_[fresh].neighbors[0] = g, faces_[g].neighbors[edge_from(g, to)] = fresh;
        start_[from] = fresh;
        created_.push_back(fresh);
      }
    for (const int f : created_) {
      const int g = start_[end(f, 0)];
      faces_[f].neighbors[1] = g, faces_[g].neighbors[2] = f;
    }

    for (const int f : seen_) {
      for (int q = faces_[f].outside, after = -1; q >= 0; q = after) {
        after = next_[q];
        if (q != p) hand_over(q, created_);
      }
      faces_[f].vertices[0] = -1, faces_[f].outside = -1;
      free_.push_back(f);
    }
    for (const int f : created_)
      if (faces_[f].outside >= 0) pending_.push_back(f);
    trace_(Added{p, static_cast<int>(seen_.size())});
  }

  const Points& points_;
  Point<double, 3> lo_, hi_;
  std::vector<Face> faces_;
  std::vector<int> free_, pending_;
  std::vector<int> next_;   ///< of each point on a list
  std::vector<int> start_;  ///< of each vertex on the horizon, the new face whose edge starts there
  std::vector<int> seen_, created_;
  Trace& trace_;
};

}  // namespace detail

using Event = std::variant<detail::Simplex, Added, Dropped, Fallback>;

}  // namespace convex_hull_3d

}  // namespace isect
