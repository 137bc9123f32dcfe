#pragma once
// Triangles and boxes that are hard to tell apart, of any numbers.

#include <utility>

#include "bench/random_shapes.h"

namespace isect::tests::triangle_box_pairs {

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
