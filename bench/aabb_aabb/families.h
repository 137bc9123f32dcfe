#pragma once
// Pairs of boxes, and of intervals, that are hard to tell apart.

#include <array>

#include "bench/named_draw.h"
#include "bench/ordinary_shapes.h"
#include "bench/simple_shapes.h"

namespace isect::bench {

template <class S>
using Intervals = Pair<Interval<S>, Interval<S>>;
template <class S, int N>
using Boxes = Pair<Aabb<S, N>, Aabb<S, N>>;

namespace interval_families {

template <class S>
Intervals<S> ordinary(Random& random) {
  const auto one = [&]() -> Interval<S> {
    const S x = number<S>(random, Numbers::ordinary), y = number<S>(random, Numbers::ordinary);
    return {std::min(x, y), std::max(x, y)};
  };
  const Interval<S> a = one();
  return {a, one()};
}

/// Two intervals that share an end, or miss it by an ulp. The end is a multiple of 0.1, so sums and differences round.
template <class S, int most>
Intervals<S> touching(Random& random) {
  const auto typed = [](int n) { return static_cast<S>(n / 10.0); };
  const int end = random.integer(-50, 50);
  Intervals<S> c = {{typed(end - random.integer(0, 50)), typed(end)}, {typed(end), typed(end + random.integer(0, 50))}};
  c.b.lo = moved(c.b.lo, random.integer(-most, most)), c.b.hi = std::max(c.b.hi, c.b.lo);
  if (random.one_in(2)) std::swap(c.a, c.b);
  return c;
}

/// Intervals so large or small that sums overflow, or halves vanish.
template <class S>
Intervals<S> scale(Random& random) {
  Intervals<S> c = random.one_in(2) ? touching<S, 0>(random) : ordinary<S>(random);
  constexpr int most = std::numeric_limits<S>::max_exponent - 4, least = std::numeric_limits<S>::min_exponent - 20;
  const int across = random.one_in(2) ? most : random.integer(least, least + 8);
  bench::scale(across, c.a.lo, c.a.hi, c.b.lo, c.b.hi);
  return c;
}

/// Inverted, or with NaN.
template <class S>
Intervals<S> invalid(Random& random) {
  Intervals<S> c = random.one_in(2) ? ordinary<S>(random) : touching<S, 0>(random);
  Interval<S>& spoilt = random.one_in(2) ? c.a : c.b;
  if (random.one_in(2))
    spoilt = {spoilt.hi, spoilt.lo};
  else
    (random.one_in(2) ? spoilt.lo : spoilt.hi) = std::numeric_limits<S>::quiet_NaN();
  return c;
}

/// Half-lines and lines.
template <class S>
Intervals<S> unbounded(Random& random) {
  Intervals<S> c = ordinary<S>(random);
  if (random.one_in(2)) c.a.lo = infinite<S>.lo;
  if (random.one_in(2)) c.a.hi = infinite<S>.hi;
  if (random.one_in(4)) c.b.lo = infinite<S>.lo;
  if (random.one_in(4)) c.b.hi = infinite<S>.hi;
  if (random.one_in(8)) std::swap(c.b.lo, c.b.hi);  // [inf, -inf] holds no number
  return c;
}

}  // namespace interval_families

template <class S>
constexpr std::array<NamedDraw<Intervals<S>>, 6> interval_draws = {{
    {"ordinary", interval_families::ordinary<S>},
    {"touching", interval_families::touching<S, 0>, "intervals that share an end, as typed in tenths."},
    {"near-touch", interval_families::touching<S, 2>, "the same, an end up to 2 ulp off."},
    {"scale", interval_families::scale<S>, "sizes at which sums overflow or halves vanish."},
    {"unbounded", interval_families::unbounded<S>, "half-lines and lines; from inf to -inf is none."},
    {"invalid", interval_families::invalid<S>, "inverted intervals and NaN."},
}};

namespace aabb_aabb_families {

template <class S>
Boxes<S, 3> ordinary(Random& random) {
  const Aabb<S, 3> a = ordinary_box<S>(random);
  return {a, ordinary_box<S>(random)};
}

/// Boxes that have these intervals on one axis or more, and equal ones on the other axes.
template <class S, Intervals<S> (*draw)(Random&)>
Boxes<S, 3> along_some(Random& random) {
  Boxes<S, 3> c;
  const int sure = random.below(3);
  for (int i = 0; i < 3; ++i) {
    const Intervals<S> x = draw(random);
    c.a.lo[i] = x.a.lo, c.a.hi[i] = x.a.hi;
    c.b.lo[i] = x.b.lo, c.b.hi[i] = x.b.hi;
    if (i == sure || random.one_in(2)) continue;
    c.b.lo[i] = c.a.lo[i], c.b.hi[i] = c.a.hi[i];
  }
  return c;
}

/// Boxes beside each other and far away: centers and half-sides have rounded off the deciding digits.
template <class S>
Boxes<S, 3> far(Random& random) {
  const double away = std::ldexp(random.uniform(1, 2), std::numeric_limits<S>::digits - 6);
  Boxes<S, 3> c = ordinary<S>(random);
  const int i = random.below(3);
  c.b = c.a;
  for (Aabb<S, 3>* box : {&c.a, &c.b})
    for (Point<S, 3>* p : {&box->lo, &box->hi})
      for (S& x : *p) x += static_cast<S>(away);
  c.b.lo[i] = moved(c.a.hi[i], random.integer(-1, 1)), c.b.hi[i] = c.b.lo[i] + static_cast<S>(random.uniform(0, 3));
  return c;
}

}  // namespace aabb_aabb_families

template <class S>
constexpr std::array<NamedDraw<Boxes<S, 3>>, 6> aabb_aabb_draws = {{
    {"ordinary", aabb_aabb_families::ordinary<S>},
    {"touching", aabb_aabb_families::along_some<S, interval_families::touching<S, 0>>,
     "boxes that share a face, an edge or a corner, as typed in tenths."},
    {"near-touch", aabb_aabb_families::along_some<S, interval_families::touching<S, 2>>, "the same, up to 2 ulp off."},
    {"far", aabb_aabb_families::far<S>, "small boxes far from the origin, a face at a face but for an ulp."},
    {"scale", aabb_aabb_families::along_some<S, interval_families::scale<S>>,
     "sizes at which sums overflow or halves vanish."},
    {"invalid", aabb_aabb_families::along_some<S, interval_families::invalid<S>>, "inverted boxes and NaN."},
}};

}  // namespace isect::bench
