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

#include <isect/convex_hull.h>
#include <isect/orient.h>
#include <isect/parts/convex_hull_3d_growth.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

/// A convex polytope by its boundary. In `dimension` 3 the triangles are counter-clockwise seen from outside. In 2 the
/// vertices are a polygon in their order, the triangles cover it on both sides; in 1 or 0 they are the ends of a
/// segment or a point, without triangles; no points give -1.
template <class S>
struct Hull3 {
  std::vector<Point<S, 3>> vertices;
  std::vector<std::array<int, 3>> triangles;
  int dimension = -1;
};

namespace convex_hull_3d {

namespace detail {

/// The vertices, in order, of points in one plane that are not on one line; found in their projection.
inline std::vector<int> polygon(const Points& points, int axis) {
  Ring<double, 2> flat;
  for (const Point<double, 3>& p : points) flat.push_back(without_axis(p, axis));
  std::map<std::pair<double, double>, int> index;
  for (std::size_t i = 0; i < flat.size(); ++i) index.try_emplace({flat[i][0], flat[i][1]}, static_cast<int>(i));
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

}  // namespace detail

}  // namespace convex_hull_3d

/// The hull of the points. Exact: its vertices are the points given, as they are, that are in no hull of the others, in
/// the order given (for a polygon, in the polygon's order), each once; points within faces and edges and repeated ones
/// are left out. O(n log n) for most inputs. Throws std::invalid_argument where a coordinate is NaN or infinite.
template <class S, class Trace = NoTrace>
Hull3<S> convex_hull(std::span<const Point<S, 3>> points, Trace&& trace = {}) {
  static_assert(is_scalar<S>());
  convex_hull_3d::detail::Points wide;
  wide.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!finite(points[i]))
      throw std::invalid_argument("convex_hull: point " + std::to_string(i) + " has a NaN or infinite coordinate");
    wide.push_back(points[i].template cast<double>());
  }
  const convex_hull_3d::detail::Indices indices = convex_hull_3d::detail::hull(wide, trace);

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
