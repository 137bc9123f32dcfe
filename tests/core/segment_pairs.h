#pragma once
// Segments that are hard to tell apart, and what they truly share, in rationals.

#include <algorithm>
#include <vector>

#include <isect/segment_segment.h>
#include "bench/random_shapes.h"
#include "bench/rational.h"

namespace isect::tests::segment_pairs {

using bench::Numbers, bench::Random;
using oracle::Rational;
using segment_segment::Meeting;

template <class S>
struct Pair {
  Segment<S, 2> a, b;
};

/// Two segments: any, or with ends of one on the other, shared ends, or on one line, as nearly as S can represent it.
template <class S>
Pair<S> draw(Random& random, Numbers numbers) {
  const auto any = [&] { return bench::vector<S, 2>(random, numbers); };
  Pair<S> c = {{any(), any()}, {any(), any()}};
  const auto on_a = [&](int most) {
    const Point<S, 2> x =
        c.a.p + (c.a.q - c.a.p) * static_cast<S>(random.integer(-most, 2 * most)) / static_cast<S>(most);
    return finite(x) ? x : c.a.p;
  };
  switch (random.below(6)) {
    case 0:
      break;
    case 1:
      c.b.p = on_a(2);
      break;
    case 2:
      c.b = {on_a(3), on_a(3)};
      break;
    case 3:
      (random.one_in(2) ? c.b.p : c.b.q) = random.one_in(2) ? c.a.p : c.a.q;
      break;
    case 4:
      if (finite(Vector<S, 2>(2 * on_a(4) - c.b.p))) c.b.q = 2 * on_a(4) - c.b.p;
      break;
    default:
      c.b.p = on_a(1);
      c.b.p[random.below(2)] = bench::moved(c.b.p[0], random.integer(-1, 1));
  }
  if (random.one_in(12)) c.b.q = c.b.p;
  if (random.one_in(12)) c.a.q = c.a.p;
  if (!finite(c.b)) c.b = {any(), any()};
  return random.one_in(2) ? c : Pair<S>{c.b, c.a};
}

using P = oracle::Coordinates<2>;

inline Rational cross2(const P& x, const P& y) { return x[0] * y[1] - x[1] * y[0]; }

/// Whether x = p + k (q - p) for some k of [0, 1].
inline bool holds(const P& p, const P& q, const P& x) {
  using oracle::operator-;
  const P d = q - p, f = x - p;
  const int i = d[0] != 0 ? 0 : 1;
  if (d[i] == 0) return x == p;
  const Rational k = f[i] / d[i];
  return 0 <= k && k <= 1 && k * d[0] == f[0] && k * d[1] == f[1];
}

struct Truth {
  Meeting relation = Meeting::disjoint;
  std::vector<P> points;  ///< the common point, or the ends of the common stretch in any order
};

/// The truth by solving for the parameters; for parallel segments by each end point.
template <class S>
Truth truth(const Pair<S>& c) {
  using oracle::operator-;
  using oracle::operator+;
  using oracle::operator*;
  const P p = oracle::rational<S, 2>(c.a.p), q = oracle::rational<S, 2>(c.a.q), r = oracle::rational<S, 2>(c.b.p),
          s = oracle::rational<S, 2>(c.b.q);
  const P d = q - p, e = s - r;
  const Rational determinant = cross2(d, e);
  if (determinant != 0) {
    const Rational t = cross2(r - p, e) / determinant, u = cross2(r - p, d) / determinant;
    if (t < 0 || t > 1 || u < 0 || u > 1) return {};
    const bool at_end = t == 0 || t == 1 || u == 0 || u == 1;
    return {at_end ? Meeting::touch : Meeting::cross, {p + t * d}};
  }
  Truth result;
  const auto add = [&](const P& x) {
    if (std::find(result.points.begin(), result.points.end(), x) == result.points.end()) result.points.push_back(x);
  };
  for (const P& x : {p, q})
    if (holds(r, s, x)) add(x);
  for (const P& x : {r, s})
    if (holds(p, q, x)) add(x);
  constexpr Meeting by_count[] = {Meeting::disjoint, Meeting::touch, Meeting::overlap};
  result.relation = by_count[result.points.size()];
  return result;
}

}  // namespace isect::tests::segment_pairs
