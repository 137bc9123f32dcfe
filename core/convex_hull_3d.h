#pragma once
// The convex hull of points in space.
//
// From a tetrahedron the hull grows point by point. Every point still outside is on the list of one face that it lies
// strictly above. The farthest point of some list is added: the faces that it sees, those it lies strictly above, are
// a disc; they go, and each edge of the disc's border, the horizon, gets a new face to the point. Their lists are
// handed to the new faces. Nothing is lost: a point q above a face A that goes, and outside the new hull, sees faces
// on either side of some edge of the horizon, and so the new face N there. For N's plane turns about that edge
// between the two planes, with p above A and not above B:  n = a A + b B,  a >= 0, b > 0,  hence n(q) > 0.
//
// orient3d makes every decision, so the hull is exact; rounding decides which point is farthest, for speed only. A
// face keeps its normal and the error bound of all heights above it in the cloud, which settle nearly every question.
//
// Strictly seen means that a point in the plane of a face leaves the face and extends it by coplanar ones, never by
// one without area: a point on the line of a horizon edge would not see the face behind it. But vertices may thereby
// end up within a face or an edge. At a strict vertex three planes or more meet, so three or more of its edges are
// sharp, their two faces not coplanar; the others have two or none. They are dropped, and coplanar faces cut up anew.
//
// Source: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, The quickhull algorithm for convex hulls, ACM TOMS 22 (1996).

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "core/convex_hull.h"
#include "core/orient.h"
#include "core/shapes.h"
#include "core/trace.h"

namespace isect {

/// A convex polytope by its boundary. In `dimension` 3 the triangles are counter-clockwise seen from outside. In 2
/// the vertices are a polygon in their order, the triangles cover it on both sides; in 1 or 0 they are the ends of a
/// segment or a point, without triangles; -1 of no points.
template <class S>
struct Hull3 {
  std::vector<Point<S, 3>> vertices;
  std::vector<std::array<int, 3>> triangles;
  int dimension = -1;
};

namespace convex_hull_3d {

/// The first four points, by their indices.
struct Simplex {
  std::array<int, 4> points;
};
/// A point joins the hull; it has seen so many faces.
struct Added {
  int point, seen;
};
/// A point that the hull passed through was no strict vertex.
struct Dropped {
  int point;
};
using Event = std::variant<Simplex, Added, Dropped, Fallback>;

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
int projection(const Point<double, 3>& a, const Point<double, 3>& b, const Point<double, 3>& c,
               Trace&& trace) {
  for (int axis = 0; axis < 3; ++axis)
    if (orient2d(without_axis(a, axis), without_axis(b, axis), without_axis(c, axis), trace) != 0)
      return axis;
  return -1;
}

/// The index of the greatest rounded size among points that will do; -1 when none does.
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
  if (!add([&](const auto& p) { return (p - a).squaredNorm(); }, [&](const auto& p) { return p != a; }))
    return found;

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

  void run() {
    while (!pending_.empty()) {
      const int face = pending_.back();
      pending_.pop_back();
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
    face.error =
        dot(n, difference<W, 3>(hi_, lo_)).error();  // no point is farther from a, nor any product larger
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

/// The vertices, in order, of points in one plane that are not on one line; found in their projection.
inline std::vector<int> polygon(const Points& points, int axis) {
  Ring<double, 2> flat;
  for (const Point<double, 3>& p : points) flat.push_back(without_axis(p, axis));
  std::map<std::pair<double, double>, int> index;
  for (std::size_t i = 0; i < flat.size(); ++i)
    index.try_emplace({flat[i][0], flat[i][1]}, static_cast<int>(i));
  std::vector<int> ring;
  for (const Point<double, 2>& p : convex_hull(flat)) ring.push_back(index.at({p[0], p[1]}));
  return ring;
}

/// The hull in indices: the vertices, and the triangles of them.
struct Indices {
  std::vector<int> vertices;
  std::vector<std::array<int, 3>> triangles;
  int dimension;
};

template <class Trace>
Indices hull(const Points& points, Trace&& trace) {
  const std::vector<int> first = span(points, trace);
  Indices result = {first, {}, static_cast<int>(first.size()) - 1};
  if (first.size() == 2) {
    const auto most = std::max_element(points.begin(), points.end(), before);
    result.vertices[1] = static_cast<int>(most - points.begin());
  }
  if (first.size() == 3) {
    std::vector<int>& ring = result.vertices;
    ring = polygon(points, projection(points[first[0]], points[first[1]], points[first[2]], trace));
    for (std::size_t k = 2; k < ring.size(); ++k) {
      result.triangles.push_back({ring[0], ring[k - 1], ring[k]});
      result.triangles.push_back({ring[0], ring[k], ring[k - 1]});
    }
  }
  if (first.size() < 4) return result;

  const std::array<int, 4> simplex = {first[0], first[1], first[2], first[3]};
  trace(Simplex{simplex});
  Growth growth(points, simplex, trace);
  growth.run();
  result.triangles = growth.strict_triangles();
  result.vertices.clear();
  std::vector<bool> used(points.size(), false);
  for (const std::array<int, 3>& triangle : result.triangles)
    for (const int v : triangle) used[v] = true;
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
    if (used[i]) result.vertices.push_back(i);
  return result;
}

}  // namespace convex_hull_3d

/// The hull of the points. Exact: its vertices are the points given, as they are, that are in no hull of the others,
/// in the order given (of a polygon in its own), each once; points within faces and edges and repeated ones are left
/// out. O(n log n) for most inputs. Throws std::invalid_argument where a coordinate is NaN or infinite.
template <class S, class Trace = NoTrace>
Hull3<S> convex_hull(std::span<const Point<S, 3>> points, Trace&& trace = {}) {
  convex_hull_3d::Points wide;
  wide.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!finite(points[i]))
      throw std::invalid_argument("convex_hull: point " + std::to_string(i) +
                                  " has a NaN or infinite coordinate");
    wide.push_back(points[i].template cast<double>());
  }
  const convex_hull_3d::Indices indices = convex_hull_3d::hull(wide, trace);

  Hull3<S> hull;
  hull.dimension = indices.dimension;
  std::vector<int> place(points.size(), -1);
  for (const int i : indices.vertices) {
    place[i] = static_cast<int>(hull.vertices.size());
    hull.vertices.push_back(points[i]);
  }
  hull.triangles.reserve(indices.triangles.size());
  for (const auto& [a, b, c] : indices.triangles) hull.triangles.push_back({place[a], place[b], place[c]});
  return hull;
}
template <class S, class Trace = NoTrace>
Hull3<S> convex_hull(const std::vector<Point<S, 3>>& points, Trace&& trace = {}) {
  return convex_hull(std::span<const Point<S, 3>>(points), trace);
}

}  // namespace isect
