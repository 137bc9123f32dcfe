#pragma once
// Triangles and boxes that are hard to tell apart, and how they truly lie: by what clipping leaves of the triangle, in
// rationals.

#include <type_traits>
#include <utility>
#include <vector>

#include "bench/random_shapes.h"
#include "bench/rational.h"

namespace isect::tests::triangle_box_pairs {

using oracle::Rational;
using oracle::operator+;
using oracle::operator-;
using oracle::operator*;

template <int N>
using Corners = std::vector<oracle::Coordinates<N>>;

/// The part with side (x_axis - limit) >= 0, by Sutherland and Hodgman.
template <int N>
std::type_identity_t<Corners<N>> clipped(const Corners<N>& polygon, int axis, const Rational& limit, int side) {
  Corners<N> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Rational from = side * (p[axis] - limit), to = side * (q[axis] - limit);
    if (from >= 0) result.push_back(p);
    if ((from > 0 && to < 0) || (from < 0 && to > 0)) result.push_back(p + Rational(from / (from - to)) * (q - p));
  }
  return result;
}

template <class S, int N>
Corners<N> common(const Triangle<S, N>& triangle, const Aabb<S, N>& box) {
  Corners<N> polygon;
  for (const Point<S, N>& v : triangle.vertices) polygon.push_back(oracle::rational<S, N>(v));
  for (int k = 0; k < N; ++k) {
    polygon = clipped<N>(polygon, k, Rational(box.lo[k]), 1);
    polygon = clipped<N>(polygon, k, Rational(box.hi[k]), -1);
  }
  return polygon;
}

/// Whether the common part reaches into the box's interior: its centroid does if any point does.
template <class S, int N>
bool reaches_inside(const std::type_identity_t<Corners<N>>& part, const Aabb<S, N>& box) {
  oracle::Coordinates<N> sum = part[0];
  for (std::size_t i = 1; i < part.size(); ++i) sum = sum + part[i];
  for (int k = 0; k < N; ++k) {
    const Rational x = sum[k] / part.size();
    if (x <= Rational(box.lo[k]) || x >= Rational(box.hi[k])) return false;
  }
  return true;
}

template <class S, int N>
Relation oracle_relate(const Triangle<S, N>& triangle, const Aabb<S, N>& box) {
  const Corners<N> part = common(triangle, box);
  if (part.empty()) return Relation::disjoint;
  bool a_in_b = true, b_in_a = true;
  for (const Point<S, N>& v : triangle.vertices) a_in_b &= !common<S, N>({{v, v, v}}, box).empty();
  for (int corner = 0; corner < 1 << N; ++corner) {
    Point<S, N> c;
    for (int k = 0; k < N; ++k) c[k] = corner & (1 << k) ? box.hi[k] : box.lo[k];
    b_in_a &= !common<S, N>(triangle, {c, c}).empty();
  }
  if (a_in_b && b_in_a) return Relation::equal;
  if (a_in_b || b_in_a) return a_in_b ? Relation::a_inside_b : Relation::b_inside_a;
  return reaches_inside(part, box) ? Relation::overlapping : Relation::touching;
}

/// A box, some of its sides flat, and a triangle with vertices at its corners and faces or nearby, or with a face,
/// an edge or the plane through one of its corners.
template <class S, int N>
std::pair<Triangle<S, N>, Aabb<S, N>> pair(bench::Random& random, bench::Numbers numbers) {
  const Point<S, N> p = bench::vector<S, N>(random, numbers), q = bench::vector<S, N>(random, numbers);
  Aabb<S, N> box = {p.cwiseMin(q), p.cwiseMax(q)};
  if (random.one_in(4)) box.hi[random.below(N)] = box.lo[0] <= box.hi[0] ? box.hi[0] : box.lo[0];
  for (int k = 0; k < N; ++k)
    if (box.lo[k] > box.hi[k] || random.one_in(8)) box.hi[k] = box.lo[k];
  const auto corner = [&] {
    Point<S, N> c;
    for (int k = 0; k < N; ++k) c[k] = random.one_in(2) ? box.lo[k] : box.hi[k];
    return c;
  };
  Triangle<S, N> triangle;
  for (Point<S, N>& v : triangle.vertices) {
    v = bench::vector<S, N>(random, numbers);
    if (random.one_in(3)) v = corner();
    if (random.one_in(6)) v = box.lo / 2 + box.hi / 2;
  }
  auto& v = triangle.vertices;
  const Point<S, N> c = corner();
  if (random.one_in(4)) v[1] = 2 * c - v[0];                          // an edge through a corner
  if (random.one_in(4)) v[2] = c + S(2) * (c - v[0] / 2 - v[1] / 2);  // or the plane
  if (random.one_in(8)) v[1] = v[0];
  if (random.one_in(8)) v[2] = v[0] / 2 + v[1] / 2;
  if (random.one_in(16)) box.hi = box.lo, v = {box.lo, box.lo, box.lo};  // a point
  if (random.one_in(4)) {
    S& x = v[random.below(3)][random.below(N)];
    x = bench::moved(x, random.integer(-2, 2));
  }
  return {triangle, box};
}

}  // namespace isect::tests::triangle_box_pairs
