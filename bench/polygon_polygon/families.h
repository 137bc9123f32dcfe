#pragma once
// Pairs of polygons that are hard to tell apart: each family a seeded generator.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <isect/shapes.h>
#include "bench/random_shapes.h"

namespace isect::bench {

template <class S>
struct PolygonPair {
  Polygon<S, 2> a, b;
};

namespace polygon_pairs {

template <class S>
using Draw = PolygonPair<S> (*)(Random&);

inline Ring<double, 2> box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}
/// Any points of a small grid: it may cross itself, go back, have no area.
inline Ring<double, 2> any_ring(Random& random, int most) {
  Ring<double, 2> ring;
  const int n = random.integer(1, 7);
  for (int i = 0; i < n; ++i) ring.push_back({double(random.integer(0, most)), double(random.integer(0, most))});
  return ring;
}
/// A simple one around a point of a half grid: grid points by their angle, one in each direction.
inline Ring<double, 2> star(Random& random, int most) {
  const Point<double, 2> center = {random.below(most) + 0.5, random.below(most) + 0.5};
  Ring<double, 2> ring;
  const int n = random.integer(3, 8);
  for (int i = 0; i < n; ++i) ring.push_back({double(random.integer(0, most)), double(random.integer(0, most))});
  const auto angle = [&](const Point<double, 2>& p) { return std::atan2(p[1] - center[1], p[0] - center[0]); };
  std::sort(ring.begin(), ring.end(), [&](const auto& p, const auto& q) { return angle(p) < angle(q); });
  ring.erase(std::unique(ring.begin(), ring.end(), [&](const auto& p, const auto& q) { return angle(p) == angle(q); }),
             ring.end());
  return ring;
}
/// Teeth upwards on a bar, at whole numbers.
inline Ring<double, 2> comb(Random& random, int teeth, bool down) {
  Ring<double, 2> ring;
  const double base = random.integer(-1, 1), shift = random.integer(-1, 1), side = down ? -1 : 1;
  for (int i = 0; i < teeth; ++i) {
    ring.push_back({2 * i + shift, base + side * random.integer(0, 1)});
    ring.push_back({2 * i + 1 + shift, base + side * random.integer(2, 4)});
  }
  ring.push_back({2 * teeth + shift, base});
  ring.push_back({2 * teeth + shift, base - side});
  ring.push_back({shift, base - side});
  return ring;
}
/// A spiral in steps along the axes.
inline Ring<double, 2> spiral(Random& random, int turns) {
  Ring<double, 2> out, back;
  const double x = random.integer(-1, 1), y = random.integer(-1, 1), width = random.one_in(2) ? 1 : 2;
  for (int i = 0; i < turns; ++i) {
    const double r = 2 * i + 1;
    const Point<double, 2> turn[] = {{r, -r}, {r, r}, {-r - 1, r}, {-r - 1, -r - 2}};
    for (const Point<double, 2>& p : turn) {
      out.push_back({x + p[0], y + p[1]});
      back.push_back({x + p[0] + (p[0] > 0 ? width / 2 : -width / 2), y + p[1] + (p[1] > 0 ? width / 2 : -width / 2)});
    }
  }
  out.insert(out.end(), back.rbegin(), back.rend());
  return out;
}
inline Ring<double, 2> turned(Random& random, Ring<double, 2> ring) {
  if (ring.empty()) return ring;
  std::rotate(ring.begin(), ring.begin() + random.below(static_cast<int>(ring.size())), ring.end());
  if (random.one_in(2)) std::reverse(ring.begin(), ring.end());
  return ring;
}

inline PolygonPair<double> any(Random& random) {
  PolygonPair<double> c;
  const int most = random.integer(1, 4);
  for (Polygon<double, 2>* p : {&c.a, &c.b})
    for (int i = random.integer(1, 2); i > 0; --i) p->rings.push_back(any_ring(random, most));
  return c;
}
inline PolygonPair<double> stars(Random& random) {
  const int most = random.integer(2, 5);
  return {{{star(random, most)}}, {{star(random, most)}}};
}
/// Unions and differences of boxes: long shared sides, holes that are filled, parts that touch.
inline PolygonPair<double> boxes(Random& random) {
  PolygonPair<double> c;
  for (Polygon<double, 2>* p : {&c.a, &c.b})
    for (int i = random.integer(1, 3); i > 0; --i) {
      const int x = random.below(4), y = random.below(4);
      p->rings.push_back(turned(random, box(x, y, x + random.integer(1, 3), y + random.integer(1, 3))));
    }
  return c;
}
/// Squares one in another, of few sizes: nested holes and islands.
inline PolygonPair<double> nested(Random& random) {
  PolygonPair<double> c;
  for (Polygon<double, 2>* p : {&c.a, &c.b})
    for (int r = 5; r > 0; --r)
      if (random.one_in(2)) p->rings.push_back(turned(random, box(-r, -r, r, r)));
  return c;
}
/// The hole of one is the other, or nearly so.
inline PolygonPair<double> plugs(Random& random) {
  const Ring<double, 2> plug = star(random, 4);
  PolygonPair<double> c = {{{box(-1, -1, 5, 5), turned(random, plug)}}, {{turned(random, plug)}}};
  if (random.one_in(3)) c.b.rings.push_back(turned(random, box(-1, -1, 5 + random.below(2), 5)));
  if (random.one_in(3)) c.b.rings[0][0] += Vector<double, 2>(random.integer(-1, 1), random.integer(-1, 1));
  return c;
}
/// B has corners of A and points on its edges.
inline PolygonPair<double> shared(Random& random) {
  PolygonPair<double> c = {{{star(random, 4)}}, {{{}}}};
  const Ring<double, 2>& ring = c.a.rings[0];
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point<double, 2>&p = ring[i], &q = ring[(i + 1) % ring.size()];
    if (!random.one_in(4)) c.b.rings[0].push_back(p);
    if (random.one_in(2)) c.b.rings[0].push_back((p + q) / 2);
    if (random.one_in(6)) c.b.rings[0].push_back({double(random.below(5)), double(random.below(5))});
  }
  if (random.one_in(4)) std::swap(c.a, c.b);
  return c;
}
inline PolygonPair<double> combs(Random& random) {
  return {{{comb(random, random.integer(2, 4), false)}},
          {{turned(random, comb(random, random.integer(2, 4), random.one_in(2)))}}};
}
inline PolygonPair<double> spirals(Random& random) {
  PolygonPair<double> c = {{{spiral(random, random.integer(1, 2))}},
                           {{turned(random, spiral(random, random.integer(1, 2)))}}};
  if (random.one_in(2)) c.b.rings = {box(-1, -1, random.integer(0, 3), random.integer(0, 3))};
  return c;
}
/// Triangles as thin as doubles can represent, along one line.
inline PolygonPair<double> slivers(Random& random) {
  PolygonPair<double> c;
  for (Polygon<double, 2>* p : {&c.a, &c.b}) {
    Ring<double, 2> ring;
    for (int i = random.integer(3, 4); i > 0; --i) {
      const double x = random.integer(-30, 30) / 10.;
      ring.push_back({x, moved(0.3 * x, random.integer(-1, 1))});
    }
    p->rings.push_back(ring);
  }
  return c;
}

/// The drawing c with change(x) in place of every number x.
template <class Change>
PolygonPair<double> changed(PolygonPair<double> c, const Change& change) {
  for (Polygon<double, 2>* p : {&c.a, &c.b})
    for (Ring<double, 2>& ring : p->rings)
      for (Point<double, 2>& v : ring) v = {change(v[0]), change(v[1])};
  return c;
}
inline PolygonPair<double> lattice(Random& random) {
  constexpr Draw<double> all[] = {any, stars, boxes, nested, plugs, shared, combs, spirals};
  return all[random.below(8)](random);
}
inline PolygonPair<double> tenths(Random& random) {
  return changed(lattice(random), [](double x) { return x * 0.1; });
}
inline PolygonPair<double> nudged(Random& random) {
  return changed(lattice(random), [&](double x) { return random.one_in(4) ? moved(x, random.integer(-1, 1)) : x; });
}
inline PolygonPair<double> distant(Random& random) {
  return changed(lattice(random), [&](double x) { return 1e8 + x * 0.1; });
}
inline PolygonPair<double> huge(Random& random) {
  return changed(lattice(random), [](double x) { return std::ldexp(x, 1018); });
}
inline PolygonPair<double> tiny(Random& random) {
  return changed(lattice(random), [](double x) { return std::ldexp(x, -990); });
}
inline PolygonPair<double> subnormal(Random& random) {
  return changed(lattice(random), [](double x) { return 2 * x * std::numeric_limits<double>::denorm_min(); });
}
/// Few numbers of all sizes, from 1e-300 to 1e300.
inline PolygonPair<double> wide(Random& random) {
  const double sizes[] = {-1e300, -1, -1e-300, 0, 5e-324, 1e-300, 1, 1e300};
  PolygonPair<double> c;
  for (Polygon<double, 2>* p : {&c.a, &c.b}) {
    Ring<double, 2> ring;
    for (int i = random.integer(3, 5); i > 0; --i) ring.push_back({sizes[random.below(8)], sizes[random.below(8)]});
    p->rings.push_back(ring);
  }
  return c;
}
inline PolygonPair<double> ordinary(Random& random) {
  PolygonPair<double> c;
  for (Polygon<double, 2>* p : {&c.a, &c.b}) {
    const Point<double, 2> center = random.in_box<2>(0.7);
    Ring<double, 2> ring;
    const int n = random.integer(3, 9);
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n, r = random.uniform(0.2, 1);
      ring.push_back({center[0] + r * std::cos(angle), center[1] + r * std::sin(angle)});
    }
    p->rings.push_back(ring);
  }
  return c;
}

}  // namespace polygon_pairs

struct PolygonPairFamily {
  const char* name;
  polygon_pairs::Draw<double> draw;
  const char* note;     ///< of NamedDraw
  bool simple = false;  ///< each is one outline that neither crosses nor touches itself
};
inline constexpr PolygonPairFamily polygon_pair_families[] = {
    {"ordinary", polygon_pairs::ordinary, "outlines of 3 to 9 corners around near centers.", true},
    {"any", polygon_pairs::any, "one or two rings of any points of a small grid: they cross themselves and go back."},
    {"stars", polygon_pairs::stars, "grid points by their angle around a point of a half grid."},
    {"boxes", polygon_pairs::boxes, "unions and differences of boxes on a grid: long sides in common."},
    {"nested", polygon_pairs::nested, "squares one in another: holes and islands."},
    {"plugs", polygon_pairs::plugs, "the hole of one is the other, or nearly so."},
    {"shared", polygon_pairs::shared, "one of corners of the other and middles of its sides."},
    {"combs", polygon_pairs::combs, "combs with teeth on whole numbers.", true},
    {"spirals", polygon_pairs::spirals, "spirals in steps along the axes."},
    {"slivers", polygon_pairs::slivers, "outlines as thin as doubles can say, along one line."},
    {"tenths", polygon_pairs::tenths, "those of grids, times 0.1: what users type."},
    {"nudged", polygon_pairs::nudged, "those of grids, a quarter of the numbers an ulp off."},
    {"distant", polygon_pairs::distant, "the tenths, 1e8 away."},
    {"huge", polygon_pairs::huge, "those of grids, times 2^1018."},
    {"tiny", polygon_pairs::tiny, "those of grids, times 2^-990."},
    {"subnormal", polygon_pairs::subnormal, "those of grids, times twice the least double."},
    {"wide", polygon_pairs::wide, "few numbers of all sizes, from 5e-324 to 1e300."}};

}  // namespace isect::bench
