#pragma once
// Convex solids that are hard to tell from ones that miss a cylinder, or a cone, or fit in, or hold it: k-DOPs with
// normals of any direction.

#include <algorithm>
#include <cmath>

#include "bench/full_precision.h"
#include "bench/round_families.h"

namespace isect::bench {

template <class S, class Solid>
using SolidAndKdop = Pair<Solid, Kdop<S, 3>>;

namespace solid_and_kdop {

using Vec = Vector<double, 3>;

/// The level of the plane through x with that normal.
template <class S>
S level(const Vector<S, 3>& normal, const Point<double, 3>& x) {
  return static_cast<S>(normal.template cast<double>().dot(x));
}
/// Adds the slab between the levels of two points, each moved by up to `ulps`.
template <class S>
void add_slab(Random& random, Kdop<S, 3>& kdop, const Vec& normal, const Point<double, 3>& x, const Point<double, 3>& y,
              int ulps = 0) {
  kdop.normals.push_back(normal.cast<S>());
  const S a = moved(level(kdop.normals.back(), x), random.integer(-ulps, ulps)),
          b = moved(level(kdop.normals.back(), y), random.integer(-ulps, ulps));
  kdop.slabs.push_back({std::min(a, b), std::max(a, b)});
}

/// A k-DOP with a face, an edge or a corner at `at`, as `faces` is 1, 2 or 3, and all of it on the side to which the
/// normal points. The normal and both tangents are orthogonal; with integers all is exact up to `ulps`.
template <class S>
Kdop<S, 3> resting(Random& random, const Point<double, 3>& at, const Vec& normal, const Vec& tangent, const Vec& second,
                   int faces, int ulps) {
  const std::array<Vec, 3> normals =
      faces == 1   ? std::array<Vec, 3>{normal, tangent, second}
      : faces == 2 ? std::array<Vec, 3>{normal + tangent, normal - tangent, second}
                   : std::array<Vec, 3>{normal + tangent, normal + second, normal - tangent - second};
  Kdop<S, 3> kdop;
  for (int i = 0; i < 3; ++i) {
    const Vec& n = normals[static_cast<std::size_t>(i)];
    const Vec far = random.integer(i < faces ? 0 : -3, 3) * n, near = random.integer(0, 3) * n;
    add_slab(random, kdop, n, i < faces ? at : Point<double, 3>(at - near), at + far, ulps);
  }
  return kdop;
}
template <class S>
Kdop<S, 3> resting(Random& random, const Spot& spot, double size, int ulps) {
  const Vec tangent = spot.normal.cross(random.heading<3>()).normalized(), second = spot.normal.cross(tangent);
  return resting<S>(random, spot.at, size * spot.normal, size * tangent, size * second, random.integer(1, 3), ulps);
}

/// A box that is turned at will, and cut at a corner now and then.
template <class S, template <class> class Solid>
SolidAndKdop<S, Solid<S>> ordinary(Random& random) {
  SolidAndKdop<S, Solid<S>> c = {ordinary_solid<Solid<S>>(random), {}};
  const Vec u = random.heading<3>(), v = u.cross(random.heading<3>()).normalized(), w = u.cross(v);
  const Point<double, 3> center = random.in_box<3>(4);
  for (const Vec& n : {u, v, w}) {
    const Vec half = random.uniform(0.1, 2) * n;
    add_slab<S>(random, c.b, n, center - half, center + half);
  }
  if (random.one_in(2)) add_slab<S>(random, c.b, u + v + w, center - 0.5 * w, center + 9 * w);
  return c;
}

template <class S, template <class> class Solid, Patch patch>
SolidAndKdop<S, Solid<S>> near_touch(Random& random) {
  const Solid<S> solid = ordinary_solid<Solid<S>>(random);
  return {solid, resting<S>(random, spot(random, cast<double>(solid), patch), random.uniform(0.1, 2), 2)};
}

/// Slabs that hold the solid up to rounding, all of it or a part.
template <class S, template <class> class Solid>
SolidAndKdop<S, Solid<S>> near_fit(Random& random) {
  SolidAndKdop<S, Solid<S>> c = {ordinary_solid<Solid<S>>(random), {}};
  Solid<double> wide = cast<double>(c.a);
  const auto [p, q, narrow] = axis_of(wide);
  const Vec along = (q - p).normalized(), across = along.cross(random.heading<3>()).normalized();
  for (const Vec& n : {along, across, Vec(along.cross(across))}) {
    const Vec reach = wide.radius * (n - n.dot(along) * along);
    const double less = random.one_in(3) ? 0.7 : 1;
    add_slab<S>(random, c.b, n, less == 1 ? p - reach : Point<double, 3>(q - less * reach),
                less == 1 ? q + reach : Point<double, 3>(q + less * reach), 2);
  }
  return c;
}

/// Integers: in touch from outside with a face, an edge or a corner; one time in four nearly, to an ulp.
template <class S, template <class> class Solid>
SolidAndKdop<S, Solid<S>> exact_touch(Random& random) {
  const auto whole = whole_solid<Solid<double>>(random, all_patches[random.below(3)]);
  const Vec second = whole.normal.cross(whole.tangent) / 75;
  const double k = random.integer(1, 3);
  SolidAndKdop<S, Solid<S>> c = {
      cast<S>(whole.solid), resting<S>(random, whole.at, whole.normal / (random.one_in(2) ? 1 : 5), k * whole.tangent,
                                       k * second, random.integer(1, 3), random.one_in(4) ? 1 : 0)};
  return c;
}

/// Integers: a plate through the axis that ends at the side and the discs, or slabs that just hold the solid.
template <class S, template <class> class Solid>
SolidAndKdop<S, Solid<S>> exact_fit(Random& random) {
  auto whole = whole_solid<Solid<double>>(random, Patch::side);
  const auto [p, q, narrow] = axis_of(whole.solid);
  const double r = whole.solid.radius, s = r / 45;
  const Vec along = (q - p) / (20 * s), radial = along.cross(whole.tangent) / 3;  // 3 and 15 long
  const int ulps = random.one_in(4) ? 1 : 0;
  SolidAndKdop<S, Solid<S>> c = {cast<S>(whole.solid), {}};
  if (random.one_in(2)) {  // held
    const double i = random.integer(0, static_cast<int>(s));
    const Vec reach = 3 * (narrow > 0 ? s : i) * radial;
    add_slab<S>(random, c.b, along, p + 20 * i * along, q, ulps);
    add_slab<S>(random, c.b, radial, p - reach, p + reach, ulps);
    add_slab<S>(random, c.b, whole.tangent, p, p);
  } else {
    add_slab<S>(random, c.b, along, p, q, ulps);
    for (const Vec& n : {radial, whole.tangent}) add_slab<S>(random, c.b, n, p - 3 * s * n, p + 3 * s * n, ulps);
  }
  return c;
}

template <class S, class Solid>
void scale(int exponent, SolidAndKdop<S, Solid>& c) {
  scale_solid(exponent, c.a);
  for (Interval<S>& slab : c.b.slabs) bench::scale(exponent, slab.lo, slab.hi);
}

/// Pairs in which squares overflow or vanish.
template <class S, template <class> class Solid>
SolidAndKdop<S, Solid<S>> scaled(Random& random) {
  auto c = random.one_in(2) ? exact_touch<S, Solid>(random) : near_touch<S, Solid, Patch::rim>(random);
  constexpr int most = std::numeric_limits<S>::max_exponent;
  const int size = random.integer(most / 4, most - 26);  // slabs are up to 2^22 times as far
  scale(random.one_in(2) ? size : -size, c);
  return c;
}

template <class S, template <class> class Solid>
SolidAndKdop<S, Solid<S>> invalid(Random& random) {
  auto c = ordinary<S, Solid>(random);
  switch (random.below(4)) {
    case 0:
      c.b.normals[1][random.below(3)] = std::numeric_limits<S>::quiet_NaN();
      break;
    case 1:
      c.b.slabs[2].hi = std::numeric_limits<S>::infinity();
      break;
    case 2:
      std::swap(c.b.slabs[0].lo, c.b.slabs[0].hi);
      break;
    default:
      spoil(random, c.a);
  }
  return c;
}

/// A box along the coordinate axes, cut at times by a plane with a normal of small integers, or one that rests on a
/// place of the surface, up to rounding.
template <class S, template <class> class Solid>
SolidAndKdop<S, Solid<S>> of_any_numbers(Random& random, Numbers numbers) {
  SolidAndKdop<S, Solid<S>> c = {solid<Solid<S>>(random, numbers), {}};
  const bool exists = finite(c.a) && !empty(c.a);
  if (exists && random.one_in(3)) {
    Solid<double> wide = cast<double>(c.a);
    const auto [p, q, narrow] = axis_of(wide);
    const double size = (q - p).stableNorm() + wide.radius;
    const Spot on = spot(random, wide, all_patches[random.below(3)]);
    const bool plain = on.at.allFinite() && on.normal.squaredNorm() > 0.5;
    if (plain && size < std::numeric_limits<S>::max() / 16) {
      c.b = resting<S>(random, on, 1, 2);
      for (Interval<S>& slab : c.b.slabs) {  // as thick as the solid is large
        const S thick = static_cast<S>(size * random.integer(0, 4) / 2);
        (random.one_in(4) ? slab.lo : slab.hi) = random.one_in(4) ? slab.lo - thick : slab.lo + thick;
        if (slab.hi < slab.lo) std::swap(slab.lo, slab.hi);
      }
      return c;
    }
  }
  for (int i = 0; i < 3; ++i) {
    c.b.normals.push_back(Vector<S, 3>::Unit(i));
    c.b.slabs.push_back(interval<S>(random, numbers));
  }
  if (random.one_in(2)) {
    Vec n;
    do n = {double(random.integer(-2, 2)), double(random.integer(-2, 2)), double(random.integer(-2, 2))};
    while (n.isZero(0));
    add_slab<S>(random, c.b, n, vector<S, 3>(random, numbers).template cast<double>(),
                vector<S, 3>(random, numbers).template cast<double>());
  }
  return c;
}

}  // namespace solid_and_kdop

template <class S, template <class> class Solid>
constexpr std::array<NamedDraw<SolidAndKdop<S, Solid<S>>>, 9> solid_and_kdop_draws = {{
    {"ordinary", solid_and_kdop::ordinary<S, Solid>},
    {"side", solid_and_kdop::near_touch<S, Solid, Patch::side>,
     "a face, an edge or a corner that touches the side but for a few ulp."},
    {"end", solid_and_kdop::near_touch<S, Solid, Patch::end>, "the same of a flat end, or the apex."},
    {"rim", solid_and_kdop::near_touch<S, Solid, Patch::rim>, "the same where both meet."},
    {"fit", solid_and_kdop::near_fit<S, Solid>, "slabs that just hold the solid, or a part of it, or do not."},
    {"exact-touch", solid_and_kdop::exact_touch<S, Solid>, "integers: a face, an edge or a corner that touches."},
    {"exact-fit", solid_and_kdop::exact_fit<S, Solid>, "integers: a plate that just fits in, or slabs around."},
    {"scale", solid_and_kdop::scaled<S, Solid>, "sizes at which squares overflow or vanish."},
    {"invalid", solid_and_kdop::invalid<S, Solid>, "NaN, infinities, what is empty, no axis."},
}};

}  // namespace isect::bench
