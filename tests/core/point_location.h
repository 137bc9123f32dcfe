#pragma once
// What the tests of point location share: polygons that are hard to prepare, points that are hard to locate, and the
// truth in rationals.

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <isect/point_polygon.h>
#include <isect/polygon_pieces.h>
#include "bench/random_shapes.h"
#include "bench/rational.h"

namespace isect::tests {

template <class S>
using Rings = std::vector<Ring<S, 2>>;

/// Whether two edges cross at a point that is not a vertex: then the maps refuse.
template <class S>
bool cross_apart_from_vertices(const Rings<S>& rings) {
  using oracle::Rational, oracle::operator-, oracle::operator+, oracle::operator*;
  std::vector<std::array<oracle::Coordinates<2>, 2>> edges;
  for (const Ring<S, 2>& r : rings)
    for (std::size_t i = 0; i < r.size(); ++i)
      edges.push_back({oracle::rational(r[i]), oracle::rational(r[(i + 1) % r.size()])});
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto& [a, b] = edges[i];
      const auto& [c, d] = edges[j];
      const auto e = b - a, f = d - c, g = c - a;
      const Rational turn = e[0] * f[1] - e[1] * f[0];
      if (turn == 0) continue;
      const Rational s = (g[0] * f[1] - g[1] * f[0]) / turn, t = (g[0] * e[1] - g[1] * e[0]) / turn;
      if (s <= 0 || s >= 1 || t <= 0 || t >= 1) continue;
      const auto x = a + s * e;
      if (std::none_of(edges.begin(), edges.end(), [&](const auto& k) { return k[0] == x; })) return true;
    }
  return false;
}

/// The winding number by a ray in a random direction that meets no vertex; nothing on the boundary.
template <class S>
std::optional<int> true_winding(bench::Random& random, const Point<S, 2>& point, const Rings<S>& rings) {
  using oracle::Rational, oracle::operator-;
  const auto p = oracle::rational(point);
  for (;;) {
    const std::array<Rational, 2> d = {random.integer(-1000, 1000), random.integer(1, 1000)};
    int winding = 0;
    bool clear = true;
    for (const Ring<S, 2>& r : rings)
      for (std::size_t i = 0; i < r.size() && clear; ++i) {
        const auto a = oracle::rational(r[i]) - p, b = oracle::rational(r[(i + 1) % r.size()]) - p;
        if (a[0] * b[1] == a[1] * b[0] && oracle::dot(a, b) <= 0) return {};
        const int sa = oracle::sign(d[0] * a[1] - d[1] * a[0]), sb = oracle::sign(d[0] * b[1] - d[1] * b[0]);
        clear = (sa != 0 || oracle::dot(a, d) < 0) && (sb != 0 || oracle::dot(b, d) < 0);
        // the ray is crossed, not the line behind it, iff p lies on the left of an edge that goes to the left
        if (sa < 0 && sb > 0 && a[0] * b[1] > a[1] * b[0]) ++winding;
        if (sa > 0 && sb < 0 && a[0] * b[1] < a[1] * b[0]) --winding;
      }
    if (clear) return winding;
  }
}

/// Vertices around the origin, ordered by their direction; a few rays hold several.
template <class S>
Ring<S, 2> star(bench::Random& random, bench::Numbers numbers, int n) {
  Ring<S, 2> r;
  const Point<double, 2> origin = {0, 0};
  const auto upper = [](const Point<S, 2>& v) { return v[1] > 0 || (v[1] == 0 && v[0] >= 0); };
  for (int i = 0; i < n; ++i) r.push_back(bench::vector<S, 2>(random, numbers));
  std::sort(r.begin(), r.end(), [&](const Point<S, 2>& a, const Point<S, 2>& b) {
    if (upper(a) != upper(b)) return upper(a);
    return orient2d(origin, a.template cast<double>(), b.template cast<double>()) > 0;
  });
  return r;
}

/// Two chains from left to right, the upper one at least as high; shared and vertical edges are likely on a grid.
template <class S>
Ring<S, 2> monotone(bench::Random& random, bench::Numbers numbers, int n) {
  Ring<S, 2> lower, upper;
  for (int i = 0; i < n; ++i) lower.push_back(bench::vector<S, 2>(random, numbers));
  std::sort(lower.begin(), lower.end(), [](const auto& a, const auto& b) { return a[0] < b[0]; });
  upper = lower;
  for (Point<S, 2>& v : upper)
    if (!random.one_in(3)) v[1] = random.one_in(2) ? bench::moved(v[1], random.integer(0, 2)) : v[1] + std::abs(v[1]);
  lower.insert(lower.end(), upper.rbegin(), upper.rend());
  return lower;
}

/// Rectangles of a grid of w columns and rows, one or two units wide, of either orientation.
template <class S>
Rings<S> cells(bench::Random& random, int w, int n) {
  Rings<S> rings;
  for (int i = 0; i < n; ++i) {
    const S x = static_cast<S>(random.below(w)), y = static_cast<S>(random.below(w)),
            dx = random.one_in(6) ? S(2) : S(1);
    Ring<S, 2> r = {{x, y}, {x + dx, y}, {x + dx, y + 1}, {x, y + 1}};
    if (random.one_in(4)) r = {{x, y}, {x + dx, y}, {x + dx, y + 1}};
    if (random.one_in(2)) std::reverse(r.begin(), r.end());
    rings.push_back(r);
  }
  return rings;
}

/// A polygon of one of several kinds; the maps may have to refuse it.
template <class S>
Rings<S> random_rings(bench::Random& random, bench::Numbers numbers) {
  Rings<S> rings;
  const int kind = random.below(5), n = random.one_in(8) ? 3 + random.below(30) : random.below(9);
  if (kind == 0) rings = cells<S>(random, 2 + random.below(4), n);
  if (kind == 1) rings = {star<S>(random, numbers, n)};
  if (kind == 2) rings = {monotone<S>(random, numbers, n)};
  if (kind == 3) {  // edges that cross at a vertex, up to rounding
    const Point<S, 2> c = bench::vector<S, 2>(random, numbers), u = bench::vector<S, 2>(random, numbers) / 2,
                      w = bench::vector<S, 2>(random, numbers) / 2;
    rings = {{c - u, c + u, c - w, c + w}, {c, c + u, c + u + w, c + w}};
  }
  while (rings.empty() || random.one_in(6)) {  // anything, few vertices
    Ring<S, 2> r;
    for (int i = random.below(6); i > 0; --i) {
      r.push_back(bench::vector<S, 2>(random, numbers));
      if (random.one_in(8)) r.push_back(r[random.below(static_cast<int>(r.size()))]);
    }
    rings.push_back(r);
  }
  for (Ring<S, 2>& r : rings) {  // spikes, and vertices within edges
    if (r.size() < 2 || !random.one_in(4)) continue;
    const std::size_t i = static_cast<std::size_t>(random.below(static_cast<int>(r.size())));
    const Point<S, 2> a = r[i], b = r[(i + 1) % r.size()], middle = a / 2 + b / 2;
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(i) + 1;
    if (random.one_in(2))
      r.insert(r.begin() + at, {middle, a, middle});
    else
      r.insert(r.begin() + at, {b, a});
  }
  return rings;
}

/// A point anywhere, or at vertices' coordinates, or up to 2 ulp from an edge.
template <class S>
Point<S, 2> random_point(bench::Random& random, bench::Numbers numbers, const Rings<S>& rings) {
  Point<S, 2> p = bench::vector<S, 2>(random, numbers);
  const Ring<S, 2>& r = rings[random.below(static_cast<int>(rings.size()))];
  if (r.empty() || random.one_in(4)) return p;
  const auto any = [&] { return static_cast<std::size_t>(random.below(static_cast<int>(r.size()))); };
  if (random.one_in(3)) {
    for (int k = 0; k < 2; ++k)
      if (!random.one_in(3)) p[k] = r[any()][k];
    return p;
  }
  const std::size_t i = any();
  const Point<S, 2>&a = r[i], &b = r[(i + 1) % r.size()];
  const S t = random.one_in(2) ? S(0.5) : static_cast<S>(random.unit());
  p = a * (S(1) - t) + b * t;
  if (random.one_in(2))
    for (int k = 0; k < 2; ++k) p[k] = bench::moved(p[k], random.integer(-2, 2));
  return p;
}

/// Counts of how a run compares with the truth.
struct Agreement {
  int refused = 0, in = 0, on = 0, out = 0, rules_differ = 0, wrong = 0;
};

/// Whether maps accept the polygons that they must, and no others, and give the answers of `winding`, and those of
/// rationals for one point of eight. `make(rings)` makes a map.
template <class S, class Make>
Agreement agreement(std::uint64_t seed, int cases, const Make& make) {
  bench::Random random(seed);
  Agreement tally;
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < cases; ++i) {
      const Rings<S> rings = random_rings<S>(random, numbers);
      const bool refuse = cross_apart_from_vertices(rings);
      try {
        const auto map = make(Polygon<S, 2>{rings});
        tally.wrong += refuse;
        for (int k = 0; k < 16; ++k) {
          const Point<S, 2> p = random_point(random, numbers, rings);
          const Winding truth = winding(p, Polygon<S, 2>{rings});
          const std::optional<int> w = winding(p, map);
          const bool on = truth.even_odd == Location::on;
          tally.wrong += on ? w.has_value() : w != truth.winding;
          if (k < 2) tally.wrong += w != true_winding(random, p, rings);
          const Location even_odd = locate(p, map), nonzero = locate(p, map, FillRule::nonzero);
          tally.wrong += even_odd != truth.even_odd || nonzero != truth.nonzero;
          ++(even_odd == Location::in ? tally.in : even_odd == Location::on ? tally.on : tally.out);
          tally.rules_differ += even_odd != nonzero;
        }
      } catch (const std::invalid_argument&) {
        ++tally.refused;
        tally.wrong += !refuse;
      }
    }
  return tally;
}

/// A simple polygon of n vertices around the origin: smooth, or with spikes from 0.1 to 1.
inline Ring<double, 2> around(bench::Random& random, int n, bool spiky) {
  Ring<double, 2> r;
  double radius = 0.7;
  for (int i = 0; i < n; ++i) {
    radius = spiky ? random.uniform(0.1, 1) : std::clamp(radius + random.uniform(-1, 1) / n, 0.4, 1.);
    const double angle = 2 * std::numbers::pi * i / n;
    r.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return r;
}

}  // namespace isect::tests
