#include "lessons/concave_polygon/triangles.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <isect/convex_polygons.h>
#include <isect/orient.h>
#include <isect/point_convex_polygon.h>

namespace isect::lessons::concave_polygon_lesson {
namespace {

using Index = std::size_t;

/// A polygon of vertex numbers, counter-clockwise; a vertex may come twice, where a slit leads to a hole.
using Outline = std::vector<int>;

class Clipper {
 public:
  explicit Clipper(const std::vector<Point<double, 2>>& vertices) : vertices_(vertices) {}

  /// Cuts off ears until a triangle is left.
  void clip(Outline outline, bool inside, std::vector<Triangle>& out) const {
    while (outline.size() > 2) {
      const Index n = outline.size();
      Index best = n;
      for (Index i = 0; i < n; ++i)
        if (ear(outline, i) && (best == n || roundness(outline, i) > roundness(outline, best))) best = i;
      if (best == n) throw std::logic_error("an outline without an ear");
      const Index i = best;
      out.push_back({{outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n]}, inside});
      outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

 private:
  const Point<double, 2>& at(int v) const { return vertices_[v]; }

  bool ear(const Outline& outline, Index i) const {
    const Index n = outline.size();
    const int a = outline[(i + n - 1) % n], b = outline[i], c = outline[(i + 1) % n];
    if (orient2d(at(a), at(b), at(c)) <= 0) return false;
    return std::ranges::none_of(outline, [&](int v) {
      if (v == a || v == b || v == c) return false;
      return orient2d(at(a), at(b), at(v)) >= 0 && orient2d(at(b), at(c), at(v)) >= 0 &&
             orient2d(at(c), at(a), at(v)) >= 0;
    });
  }

  /// The area over the square of the longest side: it is small for slivers, which make poor pictures.
  double roundness(const Outline& outline, Index i) const {
    const Index n = outline.size();
    const Vector<double, 2> u = at(outline[(i + n - 1) % n]) - at(outline[i]),
                            v = at(outline[(i + 1) % n]) - at(outline[i]);
    return std::abs(u.x() * v.y() - u.y() * v.x()) /
           std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()});
  }

  const std::vector<Point<double, 2>>& vertices_;
};

bool has(const Triangle& t, int v) { return std::ranges::find(t.corners, v) != t.corners.end(); }

/// The edges opposite to v in its triangles, joined to an outline.
Outline around(const Level& level, int v) {
  Outline outline;
  std::vector<std::array<int, 2>> edges;
  for (const Triangle& t : level.triangles)
    for (Index k = 0; k < 3; ++k)
      if (t.corners[k] == v) edges.push_back({t.corners[(k + 1) % 3], t.corners[(k + 2) % 3]});
  outline.push_back(edges.front()[0]);
  while (outline.size() < edges.size())
    outline.push_back((*std::ranges::find_if(edges, [&](const auto& e) { return e[0] == outline.back(); }))[1]);
  return outline;
}

/// Vertices of degree at most 8, no two of them joined, those of least degree first.
std::vector<int> independent(const Level& level, int vertices) {
  std::vector<std::pair<int, int>> by_degree;
  for (int v = 0; v < vertices; ++v) {
    const auto degree = std::ranges::count_if(level.triangles, [&](const auto& t) { return has(t, v); });
    if (degree > 0 && degree <= 8) by_degree.emplace_back(static_cast<int>(degree), v);
  }
  std::ranges::sort(by_degree);
  std::vector<int> chosen;
  for (const auto& [_, vertex] : by_degree) {
    const int v = vertex;  // older compilers capture no binding
    if (std::ranges::none_of(level.triangles, [&](const Triangle& t) {
          return has(t, v) && std::ranges::any_of(chosen, [&](int c) { return has(t, c); });
        }))
      chosen.push_back(v);
  }
  return chosen;
}

Level coarser(const Hierarchy& h, const Level& fine) {
  Level level;
  for (const Triangle& t : fine.triangles)
    if (std::ranges::none_of(fine.removed, [&](int v) { return has(t, v); })) level.triangles.push_back({t.corners});
  for (const int v : fine.removed) Clipper(h.vertices).clip(around(fine, v), false, level.triangles);
  for (Triangle& t : level.triangles)
    for (Index k = 0; k < fine.triangles.size(); ++k) {
      const Relation r =
          relate(ConvexPolygon<double>{h.triangle(t)}, ConvexPolygon<double>{h.triangle(fine.triangles[k])});
      if (r != Relation::disjoint && r != Relation::touching) t.links.push_back(static_cast<int>(k));
    }
  return level;
}

}  // namespace

Ring<double, 2> Hierarchy::triangle(const Triangle& t) const {
  Ring<double, 2> ring;
  for (const int v : t.corners) ring.push_back(vertices[v]);
  return ring;
}

Hierarchy make_hierarchy(const Ring<double, 2>& ring, const Aabb<double, 2>& box) {
  Hierarchy h;
  h.vertices = ring;
  const int n = static_cast<int>(ring.size());
  for (const auto& [x, y] : {std::pair{box.lo.x(), box.lo.y()},
                             {box.hi.x(), box.lo.y()},
                             {box.hi.x(), box.hi.y()},
                             {box.lo.x(), box.hi.y()}})
    h.vertices.push_back({x, y});

  Level finest;
  Outline inner;
  for (int v = 0; v < n; ++v) inner.push_back(v);
  Clipper(h.vertices).clip(inner, true, finest.triangles);
  // The part between box and polygon. A slit joins a lower corner of the box to the lowest vertex, so it stays outside.
  const int lowest = static_cast<int>(
      std::ranges::min_element(ring, {}, [](const Point<double, 2>& v) { return v.y(); }) - ring.begin());
  Outline outer = {n, n + 1, n + 2, n + 3, n};
  for (int k = 0; k <= n; ++k) outer.push_back((lowest + n - k) % n);
  Clipper(h.vertices).clip(outer, false, finest.triangles);

  h.levels.push_back(finest);
  while (h.levels.back().triangles.size() > 2) {
    h.levels.back().removed = independent(h.levels.back(), n);
    h.levels.push_back(coarser(h, h.levels.back()));
  }
  return h;
}

std::vector<int> descend(const Hierarchy& h, const Point<double, 2>& p) {
  std::vector<int> path;
  std::vector<int> candidates = {0, 1};
  for (Index level = h.levels.size(); level-- > 0;) {
    const auto& triangles = h.levels[level].triangles;
    const auto found = std::ranges::find_if(
        candidates, [&](int k) { return locate(p, ConvexPolygon<double>{h.triangle(triangles[k])}) != Location::out; });
    if (found == candidates.end()) return path;
    path.push_back(*found);
    candidates = triangles[*found].links;
  }
  return path;
}

}  // namespace isect::lessons::concave_polygon_lesson
