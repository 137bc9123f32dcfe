#pragma once
// Three points that are hard to orient, each family a seeded generator. Their true orientation stands in
// oracle.h.

#include <array>
#include <limits>
#include <type_traits>

#include <isect/shapes.h>
#include "bench/named_draw.h"
#include "bench/random_shapes.h"

namespace isect::bench {

template <class S>
struct OrientCase {
  Point<S, 2> a, b, c;
};

namespace orient_families {

template <class S>
OrientCase<S> ordinary(Random& random) {
  OrientCase<S> t;
  for (Point<S, 2>* p : {&t.a, &t.b, &t.c}) *p = random.in_box<2>(1).template cast<S>();
  return t;
}

/// A point of the 256 x 256 grid of neighbours of `corner`, against a line through two others.
/// Source: Kettner et al., Classroom examples of robustness problems in geometric computations (2008), figure 2.
template <class S>
OrientCase<S> kettner(Random& random, const Point<S, 2>& corner, const Point<S, 2>& b, const Point<S, 2>& c) {
  const S step = std::numeric_limits<S>::epsilon() / 2;  // between neighbours of 1/2
  const S i = static_cast<S>(random.below(256)), j = static_cast<S>(random.below(256));
  return {{corner[0] + i * step, corner[1] + j * step}, b, c};
}
template <class S>
OrientCase<S> kettner_a(Random& random) {
  return kettner<S>(random, {S(0.5), S(0.5)}, {12, 12}, {24, 24});
}
template <class S>
OrientCase<S> kettner_b(Random& random) {
  return kettner<S>(random, {S(0.50000000000002531), S(0.5000000000000171)},
                    {S(17.300000000000001), S(17.300000000000001)}, {S(24.00000000000005), S(24.0000000000000517765)});
}
template <class S>
OrientCase<S> kettner_c(Random& random) {
  return kettner<S>(random, {S(0.5), S(0.5)}, {S(8.8000000000000007), S(8.8000000000000007)}, {S(12.1), S(12.1)});
}

/// The third point on the line of the others up to rounding, and up to 2 ulp beside that.
template <class S>
OrientCase<S> near_collinear(Random& random) {
  OrientCase<S> t = ordinary<S>(random);
  const S along = static_cast<S>(random.uniform(-1, 2));
  t.c = t.a + along * (t.b - t.a);
  for (int k = 0; k < 2; ++k) t.c[k] = moved(t.c[k], random.integer(-2, 2));
  return t;
}

/// A point close to the middle of two others, and up to 2 ulp beside their line: to differ from them in the last digits
/// of a small number takes more digits than even long double has.
template <class S>
OrientCase<S> small_beside_large(Random& random) {
  OrientCase<S> t = ordinary<S>(random);
  t.b = -t.a;
  t.c = static_cast<S>(random.magnitude(-12, -1)) * t.a;
  for (int k = 0; k < 2; ++k) t.c[k] = moved(t.c[k], random.integer(-2, 2));
  return t;
}

/// Multiples of 0.1 that lie on one line: as typed, not as rounded.
template <class S>
OrientCase<S> decimal(Random& random) {
  const int x = random.integer(-99, 99), y = random.integer(-99, 99);
  const int dx = random.integer(-9, 9), dy = random.integer(-9, 9);
  const auto at = [&](int k) { return Point<S, 2>(S(x + k * dx) / S(10), S(y + k * dy) / S(10)); };
  const int k = random.integer(1, 9);
  return {at(0), at(k), at(k + random.integer(1, 9))};
}

/// Ordinary, but so small or large that products vanish or overflow: 1e+-200, in float 1e+-30.
template <class S>
OrientCase<S> range(Random& random) {
  constexpr bool is_float = std::is_same_v<S, float>;
  const S size = static_cast<S>(random.one_in(2) ? (is_float ? 1e-30 : 1e-200) : (is_float ? 1e30 : 1e200));
  OrientCase<S> t = ordinary<S>(random);
  for (Point<S, 2>* p : {&t.a, &t.b, &t.c}) *p *= size;
  return t;
}

}  // namespace orient_families

template <class S>
constexpr std::array<NamedDraw<OrientCase<S>>, 8> orient2d_draws = {{
    {"ordinary", orient_families::ordinary<S>},
    {"Kettner a", orient_families::kettner_a<S>,
     "neighbours of (0.5, 0.5) beside the line through (12, 12) and (24, 24)."},
    {"Kettner b", orient_families::kettner_b<S>, "neighbours of a point beside a line whose slope is not quite 1."},
    {"Kettner c", orient_families::kettner_c<S>,
     "neighbours of (0.5, 0.5) beside the line through (8.8, 8.8) and (12.1, 12.1)."},
    {"near-collinear", orient_families::near_collinear<S>, "three points on a line but for an ulp or two."},
    {"small beside large", orient_families::small_beside_large<S>,
     "a small point within 2 ulp of the line through two opposite large ones: more digits than long double has."},
    {"decimal", orient_families::decimal<S>, "decimal fractions on one line, which rounding has moved off it."},
    {"range", orient_families::range<S>, "coordinates so large or so small that their products overflow or vanish."},
}};

}  // namespace isect::bench
