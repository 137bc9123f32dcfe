#pragma once
// Convex polygons that are hard to tell apart.

#include <cmath>
#include <numbers>

#include <isect/convex_hull.h>
#include <isect/convex_polygons.h>
#include "bench/named_draw.h"
#include "bench/ordinary_shapes.h"
#include "bench/random_shapes.h"

namespace isect::bench {

template <class S>
using ConvexPolygons = Pair<ConvexPolygon<S>, ConvexPolygon<S>>;

namespace convex_polygon_families {

/// The hull of a few points, some of them vertices of `other`, on its edges up to rounding, or inside it. Nothing if
/// it has no area.
template <class S>
std::optional<ConvexPolygon<S>> of_any_numbers(Random& random, Numbers numbers, const Ring<S, 2>& other) {
  Ring<S, 2> r;
  const auto any = [&] { return other[random.below(static_cast<int>(other.size()))]; };
  const bool near = !other.empty() && random.one_in(2);
  for (int n = 3 + random.below(random.one_in(4) ? 12 : 3); n > 0; --n) {
    Point<S, 2> p = vector<S, 2>(random, numbers);
    const S t = static_cast<S>(random.integer(0, 4)) / 4;
    if (near && !random.one_in(3)) p = any() * (S(1) - t) + any() * t;
    if (near && random.one_in(8)) p[0] = moved(p[0], random.integer(-1, 1));
    r.push_back(p);
  }
  if (near && random.one_in(6)) r = other;
  return make_convex(convex_hull(r));
}
template <class S, Numbers numbers>
ConvexPolygons<S> any_pair(Random& random) {
  for (;;) {
    const auto a = of_any_numbers<S>(random, numbers, {});
    const auto b = a ? of_any_numbers<S>(random, numbers, a->vertices) : std::nullopt;
    if (b) return {*a, *b};
  }
}

/// Points of an ellipse around a center, eight or so.
template <class S>
ConvexPolygon<S> round(Random& random, const Point<double, 2>& center) {
  const int n = random.integer(5, 12);
  const double wide = random.uniform(0.3, 1), high = random.uniform(0.3, 1), first = random.uniform(0, 6);
  Ring<S, 2> r;
  for (int i = 0; i < n; ++i) {
    const double angle = first + 2 * std::numbers::pi * i / n;
    r.push_back((center + Vector<double, 2>(wide * std::cos(angle), high * std::sin(angle))).template cast<S>());
  }
  return *make_convex(r);
}
template <class S>
ConvexPolygons<S> ordinary(Random& random) {
  const Point<double, 2> a = random.in_box<2>(1), b = random.in_box<2>(1);
  const ConvexPolygon<S> first = round<S>(random, a);
  return {first, round<S>(random, b)};
}
/// A corner of the second at an edge of the first, up to rounding and a few ulp.
template <class S>
ConvexPolygons<S> near_touch(Random& random) {
  const ConvexPolygon<S> a = round<S>(random, {0, 0});
  const std::size_t n = a.vertices.size(), i = static_cast<std::size_t>(random.below(static_cast<int>(n)));
  const Point<double, 2> p = a.vertices[i].template cast<double>(), q = a.vertices[(i + 1) % n].template cast<double>();
  const Vector<double, 2> along = q - p, outwards = Vector<double, 2>(along[1], -along[0]).normalized();
  const Point<double, 2> at = p + random.uniform(0.1, 0.9) * along;
  Point<S, 2> corner = at.cast<S>();
  for (S& x : corner) x = moved(x, random.integer(-2, 2));
  const auto beyond = [&](double aside) {
    return Point<S, 2>((at + random.uniform(0.2, 1) * outwards + aside * along).template cast<S>());
  };
  const Point<S, 2> first = beyond(-0.7), second = beyond(0.7);
  const auto b = make_convex(convex_hull(Ring<S, 2>{corner, first, second}));
  return b ? ConvexPolygons<S>{a, *b} : near_touch<S>(random);
}
/// Pairs in which products overflow or vanish.
template <class S>
ConvexPolygons<S> scale(Random& random) {
  ConvexPolygons<S> c = near_touch<S>(random);
  const int exponent = beyond_squares<S>(random);
  for (auto* polygon : {&c.a, &c.b})
    for (Point<S, 2>& v : polygon->vertices) bench::scale(exponent, v);
  for (auto* polygon : {&c.a, &c.b})
    if (!make_convex(polygon->vertices)) return scale<S>(random);
  return c;
}

}  // namespace convex_polygon_families

template <class S>
constexpr std::array<NamedDraw<ConvexPolygons<S>>, 5> convex_polygons_draws = {{
    {"ordinary", convex_polygon_families::ordinary<S>},
    {"near-touch", convex_polygon_families::near_touch<S>, "a corner at an edge but for a few ulp."},
    {"exact-touch", convex_polygon_families::any_pair<S, Numbers::grid>, "small integers: they touch and coincide."},
    {"nudged", convex_polygon_families::any_pair<S, Numbers::nudged>, "the same, up to 2 ulp off."},
    {"scale", convex_polygon_families::scale<S>, "sizes at which products overflow or vanish."},
}};

}  // namespace isect::bench
