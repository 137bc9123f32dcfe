#pragma once
// Pairs of tetrahedra that touch along a diagonal, for k-DOPs to be made of; and whether their true slabs overlap.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include <isect/directions.h>
#include "bench/full_precision.h"
#include "bench/named_draw.h"
#include "bench/random_shapes.h"
#include "bench/rational.h"

namespace isect::bench {

template <class S>
struct Tetrahedra {
  std::array<Point<S, 3>, 4> a, b;
};
template <class S>
std::string full_precision(const Tetrahedra<S>& c) {
  const auto points = [](const std::array<Point<S, 3>, 4>& p) { return text("", p[0], "", p[1], "", p[2], "", p[3]); };
  return "a:" + points(c.a) + "; b:" + points(c.b);
}

namespace kdop_kdop_families {

template <class S>
Tetrahedra<S> ordinary(Random& random) {
  Tetrahedra<S> c;
  const Vector<S, 3> apart = random.in_box<3>(1.5).cast<S>();
  for (Point<S, 3>& p : c.a) p = random.in_box<3>(1).cast<S>();
  for (Point<S, 3>& p : c.b) p = random.in_box<3>(1).cast<S>() + apart;
  return c;
}

/// b is a mirrored in a's farthest corner p along a diagonal n, then moved across n: both slabs along n end at n.p, and
/// rarely at a common corner. Numbers are multiples of `unit`, rounded, and up to `most` ulps off.
template <class S>
Tetrahedra<S> touching(Random& random, double unit, int most) {
  const std::vector<Vector<double, 3>> normals = directions<double, 3>(14);
  const Vector<double, 3> n = random.sign() * normals[random.integer(3, 6)];
  std::array<Point<double, 3>, 4> corners;
  for (Point<double, 3>& p : corners)
    for (double& x : p) x = random.integer(-20, 20);
  const Point<double, 3> farthest =
      *std::ranges::max_element(corners, {}, [&](const Point<double, 3>& p) { return n.dot(p); });
  Vector<double, 3> any;
  for (double& x : any) x = random.integer(-1, 1);
  const Vector<double, 3> across = n.cross(any);
  const auto typed = [&](double x) { return moved(static_cast<S>(x * unit), random.integer(-most, most)); };
  Tetrahedra<S> c;
  for (std::size_t i = 0; i < 4; ++i)
    for (int k = 0; k < 3; ++k) {
      c.a[i][k] = typed(corners[i][k]);
      c.b[i][k] = typed(2 * farthest[k] + across[k] - corners[i][k]);
    }
  return c;
}
template <class S>
Tetrahedra<S> grid(Random& random) {
  return touching<S>(random, 1, 0);
}
template <class S>
Tetrahedra<S> decimal(Random& random) {
  return touching<S>(random, 0.1, 0);
}
template <class S>
Tetrahedra<S> nudged(Random& random) {
  return touching<S>(random, 1, 1);
}

}  // namespace kdop_kdop_families

template <class S>
constexpr std::array<NamedDraw<Tetrahedra<S>>, 4> kdop_kdop_draws = {{
    {"ordinary", kdop_kdop_families::ordinary<S>},
    {"grid-touch", kdop_kdop_families::grid<S>, "tetrahedra of integers that touch across a diagonal."},
    {"decimal-touch", kdop_kdop_families::decimal<S>, "the same in tenths."},
    {"near-touch", kdop_kdop_families::nudged<S>, "the same, each number up to an ulp off."},
}};

/// Whether the true slabs of both overlap along each of the normals, which may have any length.
template <class S>
bool true_slabs_overlap(const Tetrahedra<S>& c, const std::vector<Vector<S, 3>>& normals) {
  using oracle::Rational;
  for (const Vector<S, 3>& n : normals) {
    const auto along = [&](const std::array<Point<S, 3>, 4>& points) {
      std::vector<Rational> values;
      for (const Point<S, 3>& p : points)
        values.push_back(oracle::dot(oracle::rational<S, 3>(n), oracle::rational<S, 3>(p)));
      return values;
    };
    const std::vector<Rational> a = along(c.a), b = along(c.b);
    if (*std::ranges::max_element(a) < *std::ranges::min_element(b)) return false;
    if (*std::ranges::max_element(b) < *std::ranges::min_element(a)) return false;
  }
  return true;
}

}  // namespace isect::bench
