#pragma once
// Pairs of oriented boxes that are hard to tell apart: in touch, up to rounding, along a direction that is known.

#include <array>

#include "bench/named_draw.h"
#include "bench/ordinary_shapes.h"
#include "bench/random_obb.h"

namespace isect::bench {

template <class S>
using OrientedBoxes = Pair<Obb<S, 3>, Obb<S, 3>>;

namespace obb_obb_families {

using Wide = Obb<double, 3>;

template <class S>
OrientedBoxes<S> ordinary(Random& random) {
  const Obb<S, 3> a = ordinary_obb<S>(random, 1.5);
  return {a, ordinary_obb<S>(random, 1.5)};
}

/// The sum of the box's half-axes, each turned towards l or away from it (side -1); axis `free` has a random factor.
inline Vector<double, 3> support(Random& random, const Wide& box, const Vector<double, 3>& l, double side,
                                 int free = -1) {
  Vector<double, 3> sum = Vector<double, 3>::Zero();
  for (int i = 0; i < 3; ++i) {
    const double towards = box.axes.col(i).dot(l) > 0 ? side : -side;
    sum += (i == free ? random.uniform(-1, 1) : towards) * box.half[i] * box.axes.col(i);
  }
  return sum;
}

/// Rounds, and moves one coordinate of b by a few ulp.
template <class S>
OrientedBoxes<S> rounded(Random& random, const Wide& a, const Wide& b, int most = 4) {
  OrientedBoxes<S> c = {cast<S>(a), cast<S>(b)};
  S& x = c.b.center[random.below(3)];
  x = moved(x, random.integer(-most, most));
  if (random.one_in(2)) std::swap(c.a, c.b);
  return c;
}

/// A corner of b at a face of a; `gap` farther off.
template <class S>
OrientedBoxes<S> face_touch(Random& random, const Wide& a, Wide b, double gap) {
  const int face = random.below(3);
  const Vector<double, 3> l = random.sign() * a.axes.col(face);
  Point<double, 3> p = a.center + (a.half[face] + gap) * l;
  for (int i = 0; i < 3; ++i)
    if (i != face) p += random.uniform(-1, 1) * a.half[i] * a.axes.col(i);
  b.center = p - support(random, b, l, -1);
  return rounded<S>(random, a, b);
}

template <class S>
OrientedBoxes<S> corner_at_face(Random& random) {
  const Wide a = ordinary_obb<double>(random, 1);
  return face_touch<S>(random, a, ordinary_obb<double>(random, 1), 0);
}

/// Edges that cross in a point of both.
template <class S>
OrientedBoxes<S> edge_at_edge(Random& random) {
  const Wide a = ordinary_obb<double>(random, 1);
  Wide b = ordinary_obb<double>(random, 1);
  const int i = random.below(3), j = random.below(3);
  const Vector<double, 3> u = a.axes.col(i), v = b.axes.col(j), l = random.sign() * u.cross(v);
  b.center = a.center + support(random, a, l, 1, i) - support(random, b, l, -1, j);
  return rounded<S>(random, a, b);
}

template <class S>
OrientedBoxes<S> corner_at_corner(Random& random) {
  const Wide a = ordinary_obb<double>(random, 1);
  Wide b = ordinary_obb<double>(random, 1);
  const Vector<double, 3> l = random.heading<3>();
  b.center = a.center + support(random, a, l, 1) - support(random, b, l, -1);
  return rounded<S>(random, a, b);
}

/// Axes that differ by a rotation of 1e-12 to 1e-6. The boxes face each other, in touch, or apart or overlapping by
/// 1e-12 (1e-6 in float) to 1e-3, more or less than an epsilon of 1e-6 sees.
template <class S>
OrientedBoxes<S> near_parallel(Random& random) {
  const Wide a = ordinary_obb<double>(random, 1);
  Wide b = ordinary_obb<double>(random, 1);
  b.axes = a.axes * permutation<double, 3>(random) * rotation<double, 3>(random, std::abs(random.magnitude(-12, -6)));
  constexpr double least = std::numeric_limits<S>::digits == 53 ? -12 : -6;
  return face_touch<S>(random, a, b, random.one_in(3) ? 0 : random.magnitude(least, -3));
}

/// 1e5 long and 0.01 thick, one beside the other at 0.1, in touch or overlapping: an absolute epsilon times such a
/// length is more than the gap.
template <class S>
OrientedBoxes<S> slender(Random& random) {
  Wide a = ordinary_obb<double>(random, 1);
  a.half = {1e5, 0.01, 0.01};
  Wide b = a;
  b.axes = a.axes * rotation<double, 3>(random, std::abs(random.magnitude(-12, -7)));
  const int face = random.integer(1, 2);
  const Vector<double, 3> l = random.sign() * a.axes.col(face);
  const double reach = a.half[face] - support(random, b, l, -1).dot(l);  // of both, along l
  const double gap = random.one_in(3) ? 0 : random.one_in(2) ? 0.1 : -0.001;
  b.center = a.center + (reach + gap) * l + random.uniform(-1, 1) * a.axes.col(0);
  return rounded<S>(random, a, b);
}

/// Touching faces of boxes along the axes, in integers.
template <class S>
OrientedBoxes<S> exact_touch(Random& random) {
  OrientedBoxes<S> c;
  for (Obb<S, 3>* box : {&c.a, &c.b}) {
    box->axes = permutation<S, 3>(random);
    for (int i = 0; i < 3; ++i) box->half[i] = static_cast<S>(random.integer(1, 9));
  }
  const Vector<S, 3> reach = c.a.axes.cwiseAbs() * c.a.half + c.b.axes.cwiseAbs() * c.b.half;
  for (int i = 0; i < 3; ++i) {
    c.a.center[i] = static_cast<S>(random.integer(-1000, 1000));
    const S most = reach[i], sign = static_cast<S>(random.sign());
    c.b.center[i] = c.a.center[i] + (random.one_in(2) ? sign * most : std::floor(static_cast<S>(random.unit()) * most));
  }
  return c;
}

}  // namespace obb_obb_families

template <class S>
constexpr std::array<NamedDraw<OrientedBoxes<S>>, 7> obb_obb_draws = {{
    {"ordinary", obb_obb_families::ordinary<S>},
    {"corner-at-face", obb_obb_families::corner_at_face<S>,
     "a corner of one box at a face of the other but for a few ulp."},
    {"edge-at-edge", obb_obb_families::edge_at_edge<S>, "edges that cross in one point but for a few ulp."},
    {"corner-at-corner", obb_obb_families::corner_at_corner<S>, "a corner at a corner but for a few ulp."},
    {"exact-touch", obb_obb_families::exact_touch<S>, "integers: boxes along the axes that touch exactly."},
    {"near-parallel", obb_obb_families::near_parallel<S>,
     "boxes turned by 1e-12 to 1e-6 against each other, a hair apart or not."},
    {"slender", obb_obb_families::slender<S>, "boxes 1e5 long and 0.01 thick, 0.1 apart, in touch or overlapping."},
}};

}  // namespace isect::bench
