#pragma once
// Polygons and points that are hard to locate in them, each family a seeded generator. Their true location
// stands in oracle.h.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <isect/conventions.h>
#include <isect/shapes.h>
#include "bench/random_shapes.h"

namespace isect::bench {

/// Cases of one family share few rings, as queries of one polygon do.
template <class S>
struct PolygonCase {
  Point<S, 2> point;
  const Ring<S, 2>* ring;
};

/// Its rings, and how to draw a point for one of them.
template <class S>
struct PolygonFamily {
  const char* name;
  bool simple;  ///< no ring touches or crosses itself
  std::vector<Ring<S, 2>> rings;
  Point<S, 2> (*point)(Random&, const Ring<S, 2>&);
  const char* note = "";  ///< of NamedDraw

  PolygonCase<S> draw(Random& random) const {
    const Ring<S, 2>& ring = rings[random.below(static_cast<int>(rings.size()))];
    return {point(random, ring), &ring};
  }
};

namespace polygon_families {

/// A simple polygon around the origin, its radius wandering between 0.4 and 1; then moved to `center`.
template <class S>
Ring<S, 2> star(Random& random, int n, double center = 0) {
  Ring<S, 2> ring;
  double radius = 0.7;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    radius = std::clamp(radius + random.uniform(-1, 1) * 3 / std::sqrt(n), 0.4, 1.0);
    ring.push_back(
        {static_cast<S>(center + radius * std::cos(angle)), static_cast<S>(center + radius * std::sin(angle))});
  }
  return ring;
}

/// A staircase up and another one down in steps of 0.1: every second edge is horizontal, and many share a height.
template <class S>
Ring<S, 2> steps(Random& random, int n) {
  Ring<S, 2> ring;
  const int stairs = n / 4;
  const auto at = [](int x, int y) { return Point<S, 2>(S(x) / S(10), S(y) / S(10)); };
  int y = 0;
  for (int i = 0; i < stairs; ++i) {
    ring.push_back(at(i, y));
    ring.push_back(at(i + 1, y));
    y = std::clamp(y + random.integer(1, 3) * (random.one_in(2) ? 1 : -1), -5, 5);
  }
  for (int i = stairs; i > 0; --i) {
    y = 7 + random.below(6);
    ring.push_back(at(i, y));
    ring.push_back(at(i - 1, y));
  }
  return ring;
}

/// Thin teeth whose edges all lead from one side to the other, the tips up to 1e-9 apart: nearly along `axis`, and so
/// nearly along slabs or walls.
template <class S>
Ring<S, 2> comb(Random& random, int n, int axis) {
  Ring<S, 2> ring;
  double height = 0;
  for (int i = 0; i < n - 2; ++i) {
    height += random.uniform(0.1, 1) * (std::is_same_v<S, float> ? 1e-5 : 1e-9);
    Point<S, 2> v = {static_cast<S>(i % 2 == 0 ? 0 : 1 + random.unit()), static_cast<S>(height)};
    if (axis == 1) std::swap(v[0], v[1]), v[0] = -v[0];
    ring.push_back(v);
  }
  const Point<S, 2> far = axis == 0 ? Point<S, 2>(-1, S(height)) : Point<S, 2>(-S(height), -1);
  ring.push_back(far);
  ring.push_back(axis == 0 ? Point<S, 2>(-1, 0) : Point<S, 2>(0, -1));
  return ring;
}

/// Two chains from bottom to top, one up to 2 ulp right of the other: every slab holds two edges that roundoff can't
/// tell apart, many times over as the chains wind.
template <class S>
Ring<S, 2> coincident(Random& random, int n) {
  Ring<S, 2> up, down;
  S y = 0;
  for (int i = 0; i < n / 2; ++i) {
    const S x = static_cast<S>(random.uniform(-1, 1));
    y += static_cast<S>(random.uniform(0.01, 1));
    down.push_back({x, y});
    up.push_back({moved(x, random.integer(1, 2)), y});
  }
  up.insert(up.end(), down.rbegin(), down.rend());
  return up;
}

/// Vertices that are repeated, within edges, back on the way they came, or all on one line.
template <class S>
Ring<S, 2> degenerate(Random& random, int n) {
  Ring<S, 2> ring;
  const bool flat = random.one_in(8);
  while (static_cast<int>(ring.size()) < n) {
    const double x = random.uniform(-1, 1), y = flat ? 0.1 * x : random.uniform(-1, 1);
    ring.push_back({static_cast<S>(x), static_cast<S>(y)});
    if (ring.size() < 2 || !random.one_in(2)) continue;
    const Point<S, 2> a = ring[ring.size() - 2], b = ring.back(), middle = a / S(2) + b / S(2);
    const Ring<S, 2> spike = {a, b}, twice = {b}, within = {middle, b};
    for (const Point<S, 2>& v : random.one_in(3) ? spike : random.one_in(2) ? twice : within) ring.push_back(v);
  }
  return ring;
}

/// A ring that crosses itself.
template <class S>
Ring<S, 2> bow_tie(Random& random, int n) {
  Ring<S, 2> ring;
  for (int i = 0; i < n; ++i) ring.push_back(random.in_box<2>(1).template cast<S>());
  return ring;
}

template <class S>
Point<S, 2> anywhere(Random& random, const Ring<S, 2>&) {
  return random.in_box<2>(1).template cast<S>();
}
/// A point on an edge up to rounding, and up to 2 ulp beside that.
template <class S>
Point<S, 2> near_edge(Random& random, const Ring<S, 2>& ring) {
  const std::size_t i = static_cast<std::size_t>(random.below(static_cast<int>(ring.size())));
  const Point<S, 2>&a = ring[i], &b = ring[(i + 1) % ring.size()];
  const S t = random.one_in(4) ? S(0.5) : static_cast<S>(random.unit());
  Point<S, 2> p = a * (S(1) - t) + b * t;
  for (int k = 0; k < 2; ++k) p[k] = moved(p[k], random.integer(-2, 2));
  return p;
}
template <class S>
Point<S, 2> on_vertex(Random& random, const Ring<S, 2>& ring) {
  return ring[random.below(static_cast<int>(ring.size()))];
}
/// A point at the height of a vertex and so of horizontal edges: on one, or in line with several.
template <class S>
Point<S, 2> at_height(Random& random, const Ring<S, 2>& ring) {
  const Point<S, 2> v = on_vertex(random, ring);
  const S last = ring[ring.size() / 2][0];
  return {random.one_in(2) ? static_cast<S>(random.uniform(-0.2, 1.2)) * last : on_vertex(random, ring)[0], v[1]};
}

/// Draws `count` rings by make(random).
template <class S, class Make>
std::vector<Ring<S, 2>> several(int count, const Make& make) {
  Random random(stream(1, "polygons"));
  std::vector<Ring<S, 2>> rings;
  for (int i = 0; i < count; ++i) rings.push_back(make(random));
  return rings;
}

}  // namespace polygon_families

/// The family of that name with rings of n vertices, n >= 4 (some have a few more); throws std::invalid_argument.
template <class S>
PolygonFamily<S> polygon_family(const std::string& name, int n) {
  using namespace polygon_families;
  const auto stars = [&](double center) { return several<S>(1, [=](Random& r) { return star<S>(r, n, center); }); };
  if (name == "ordinary") return {"ordinary", true, stars(0), anywhere<S>};
  if (name == "near-edge")
    return {"near-edge", true, stars(0), near_edge<S>,
            "points on an edge but for rounding, and up to 2 ulp beside that."};
  if (name == "on-vertex")
    return {"on-vertex", true, stars(0), on_vertex<S>, "the vertices themselves: a closed polygon has them."};
  if (name == "horizontal")
    return {"horizontal", true, several<S>(16, [=](Random& r) { return steps<S>(r, n); }), at_height<S>,
            "staircases of decimal fractions, and points at the height of their steps."};
  if (name == "degenerate")
    return {"degenerate", false, several<S>(64, [=](Random& r) { return degenerate<S>(r, n); }), near_edge<S>,
            "repeated vertices, vertices within edges, spikes, polygons without area; points near edges."};
  if (name == "bow-tie")
    return {"bow-tie", false, several<S>(64, [=](Random& r) { return bow_tie<S>(r, n); }), near_edge<S>,
            "polygons that cross themselves all over; points near edges."};
  if (name == "far 1e5")
    return {"far 1e5", true, stars(1e5), near_edge<S>, "points near edges of a polygon of size 1 at 100,000."};
  if (name == "far 1e8") return {"far 1e8", true, stars(1e8), near_edge<S>, "the same at 100,000,000."};
  if (name == "near-horizontal")
    return {"near-horizontal", true, several<S>(1, [=](Random& r) { return comb<S>(r, n, 0); }), near_edge<S>,
            "a comb of long edges nearly along the slabs; points near edges."};
  if (name == "near-vertical")
    return {"near-vertical", true, several<S>(1, [=](Random& r) { return comb<S>(r, n, 1); }), near_edge<S>,
            "the same comb upright, nearly along the trapezoids' walls."};
  if (name == "coincident")
    return {"coincident", true, several<S>(1, [=](Random& r) { return coincident<S>(r, n); }), near_edge<S>,
            "two chains of edges an ulp or two apart; points near edges."};
  throw std::invalid_argument(name);
}

}  // namespace isect::bench
