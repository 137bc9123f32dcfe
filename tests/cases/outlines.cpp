// Polygons with points and rays, and segments.

#include "bench/line_triangle/oracle.h"
#include "bench/point_polygon/families.h"
#include "bench/point_polygon/oracle.h"
#include "bench/polygon_polygon/families.h"
#include "bench/polygon_polygon/oracle.h"
#include "bench/ray_outline/oracle.h"
#include "bench/ray_polygon/families.h"
#include "bench/ray_polygon/oracle.h"
#include "tests/cases/shapes.h"
#include "tests/core/point_location.h"
#include "tests/core/ray_outline_pairs.h"
#include "tests/core/segment_pairs.h"

namespace isect::cases {

namespace {

using oracle::operator-;

template <class S>
using Rings = std::vector<Ring<S, 2>>;

/// The location by the winding number, which gives it by both rules.
template <class S>
Case located(const Point<S, 2>& p, const Rings<S>& rings) {
  Json outlines = Json::array();
  for (const Ring<S, 2>& r : rings) outlines.push_back(json<S, 2>(r));
  Random any(1);  // directions of rays, which the truth doesn't depend on
  const std::optional<int> winding = tests::true_winding(any, p, rings);
  const auto where = [&](bool inside) { return word(!winding ? Location::on : inside ? Location::in : Location::out); };
  const Json expected = {{"evenodd", where(winding.value_or(0) % 2 != 0)},
                         {"nonzero", where(winding.value_or(0) != 0)},
                         {"winding", winding ? Json(*winding) : Json(nullptr)}};
  return {{{"rings", outlines}, {"point", json<S, 2>(p)}}, expected, is_f32<S>};
}

/// Whether the point is at the height of an edge, and so near it that doubles are wrong about every other time.
template <class S>
bool almost_on_an_edge(const Point<S, 2>& p, const Ring<S, 2>& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point<S, 2>&a = ring[i], &b = ring[(i + 1) % ring.size()];
    if ((a[1] > p[1]) == (b[1] > p[1])) continue;
    const auto e = oracle::rational(b) - oracle::rational(a), f = oracle::rational(p) - oracle::rational(a);
    const Rational left = e[0] * f[1], right = e[1] * f[0];
    const Rational rounding = Rational(std::numeric_limits<S>::epsilon()) * (abs(left) + abs(right)) / 16;
    if (left != right && abs(Rational(left - right)) < rounding) return true;
  }
  return false;
}

template <class S>
Case ray_and_polygon(const Ray<S, 3>& ray, const Ring<S, 3>& ring) {
  const Json in = both(fields(ray), {{"polygon", json<S, 3>(ring)}});
  const oracle::RayPolygon truth = oracle::ray_polygon(ray, ring);
  const Json expected = {{"parallel", truth.parallel},
                         {"coplanar", truth.coplanar},
                         {"hit", truth.flat || truth.coplanar ? Json(nullptr) : Json(truth.hit)},
                         {"t", truth.parallel ? Json(nullptr) : json(nearest(truth.t))},
                         {"plane_point_location", truth.parallel ? Json(nullptr) : word(truth.location)}};
  return {in, expected, is_f32<S>};
}

template <class S>
Json outlines(const Polygon<S, 2>& p) {
  Json rings = Json::array();
  for (const Ring<S, 2>& r : p.rings) rings.push_back(json<S, 2>(r));
  return rings;
}

/// The first t; if the direction is 0 and the origin is met, the start of the range.
template <class S, int N, class IsMet, class First>
Case first_t(const Ray<S, N>& ray, const Json& shape, const IsMet& is_met, const First& first) {
  std::optional<double> t;
  const auto o = oracle::rational(ray.origin), d = oracle::rational(ray.direction);
  if (!ray.direction.isZero(0)) {
    if (const std::optional<Rational> truth = first(o, d, cast<double>(ray.range))) t = nearest(*truth);
  } else if (!empty(ray.range) && is_met(o)) {
    t = ray.range.lo;
  }
  return {both(fields(ray), shape), {{"hit", t.has_value()}, {"t", t ? json(*t) : Json(nullptr)}}, is_f32<S>};
}
template <class S>
Case ray_in_plane(const Ray<S, 2>& ray, const Polygon<S, 2>& polygon) {
  const auto rings = oracle::rational(polygon);
  return first_t(
      ray, {{"rings", outlines(polygon)}}, [&](const auto& o) { return oracle::locate(o, rings) != Location::out; },
      [&](const auto& o, const auto& d, const auto& range) { return oracle::first_hit(o, d, range, rings); });
}
template <class S>
Case line_and_triangle(const Ray<S, 3>& ray, const Triangle<S, 3>& x) {
  const oracle::Corners v = oracle::corners(x);
  const Ring<S, 3> corners(x.vertices.begin(), x.vertices.end());
  return first_t(
      ray, {{"tri", json<S, 3>(corners)}}, [&](const auto& o) { return oracle::in_triangle(o, v); },
      [&](const auto& o, const auto& d, const auto& range) { return oracle::first_hit(o, d, range, v); });
}

Case polygons(const Polygon<double, 2>& a, const Polygon<double, 2>& b) {
  return {{{"a", outlines(a)}, {"b", outlines(b)}},
          related(oracle::polygon_polygon_truth(a, b).relation()),
          is_f32<double>};
}

/// The segment's ends must differ.
Case segment_and_polygon(const Segment<double, 2>& s, const Polygon<double, 2>& polygon) {
  const auto p = oracle::rational<double, 2>(s.p), q = oracle::rational<double, 2>(s.q);
  const Relation r = oracle::line_polygon_truth(p, q - p, Rational(0), Rational(1), polygon);
  return {{{"segment", {json<double, 2>(s.p), json<double, 2>(s.q)}}, {"rings", outlines(polygon)}},
          {{"intersects", r != Relation::disjoint},
           {"relation", r == Relation::a_inside_b   ? "polygon_contains_segment"
                        : r == Relation::b_inside_a ? "segment_contains_polygon"
                                                    : word(r)}},
          is_f32<double>};
}

template <class S>
Case segments(const Segment<S, 2>& a, const Segment<S, 2>& b) {
  using segment_segment::Meeting;
  constexpr const char* words[] = {"disjoint", "touch", "cross", "overlap"};
  const auto truth = tests::segment_pairs::truth<S>({a, b});
  const bool one = truth.relation == Meeting::touch || truth.relation == Meeting::cross;
  Json point;
  if (one) point = {json(nearest(truth.points[0][0])), json(nearest(truth.points[0][1]))};
  return {{{"a", {json<S, 2>(a.p), json<S, 2>(a.q)}}, {"b", {json<S, 2>(b.p), json<S, 2>(b.q)}}},
          {{"relation", words[static_cast<int>(truth.relation)]}, {"point", point}},
          is_f32<S>};
}

}  // namespace

CaseFile pip() {
  CaseFile file("pip");
  const auto add = [&](const char* note, Rings<double> rings, Point<double, 2> p) {
    file.add(note, located(p, rings));
  };
  const Ring<double, 2> square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, diamond = {{2, 0}, {4, 2}, {2, 4}, {0, 2}};
  add("level with two vertices", {diamond}, {2, 2});
  add("level with a vertex, outside", {diamond}, {-1, 2});
  add("level with the top, outside", {square}, {-1, 4});
  add("level with the bottom, outside", {square}, {5, 0});
  for (const Point<double, 2>& v : square) add("on a vertex of a square", {square}, v);
  add("on the left side", {square}, {0, 1});
  add("on the right side", {square}, {4, 1});
  add("on the bottom", {square}, {1, -0.});
  add("on the top", {square}, {1, 4});
  add("an ulp outside of the right side", {square}, {std::nextafter(4., 5.), 1});
  add("an ulp inside of the right side", {square}, {std::nextafter(4., 3.), 1});
  add("on an edge as typed, not as rounded", {{{0, 0}, {.3, .9}, {1, 0}}}, {.1, .3});
  add("translated, it would be in", {{{0, 0}, {0, 172}, {100, 0}}}, {25.374625374625374, 128.35564435564436});
  add("an antenna: on it is on the boundary", {{{0, 0}, {4, 0}, {8, 0}, {4, 0}, {4, 4}, {0, 4}}}, {6, 0});
  add("level with an antenna", {{{0, 0}, {4, 0}, {4, 2}, {8, 2}, {4, 2}, {4, 4}, {0, 4}}}, {2, 2});
  add("a bow-tie, in one wing", {{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}, {1, 2});
  add("a bow-tie, at the crossing", {{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}, {2, 2});
  add("wound twice: the rules differ", {{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}}, {1, 1});
  add("a pentagram: the rules differ in the middle", {{{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}}}, {0, 0});
  add("in a hole", {square, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}}, {2, 2});
  add("in a hole that turns the other way", {square, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}}, {2, 2});
  add("on the rim of a hole", {square, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}}, {1, 2});
  add("two rings with a side in common, on it", {square, {{4, 0}, {8, 0}, {8, 4}, {4, 4}}}, {4, 2});
  add("a ring that is a point, there", {{{1, 1}}}, {1, 1});
  add("a ring that is a segment, on it", {{{0, 0}, {2, 2}}}, {1, 1});
  add("a ring that is a segment, beside it", {{{0, 0}, {2, 2}}}, {1, std::nextafter(1., 2.)});
  add("no vertices", {Ring<double, 2>{}}, {0, 0});
  add("no rings", {}, {0, 0});
  add("all vertices equal", {{{.1, .7}, {.1, .7}, {.1, .7}}}, {.1, .7});
  add("repeated vertices", {{{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4}, {0, 4}}}, {4, 4});
  add("the smallest numbers there are", {{{0, 0}, {2 * least, 0}, {0, 2 * least}}}, {least, least});
  add("the largest numbers there are", {{{-most, -most}, {most, -most}, {0, most}}}, {0, 0});
  add("1e-300 beside 1e300", {{{0, 0}, {1e300, 1e-300}, {0, 1e300}}}, {1e299, 1e-301});
  for (const char* name : {"near-edge", "on-vertex", "horizontal", "degenerate", "bow-tie", "far 1e5", "far 1e8",
                           "near-horizontal", "near-vertical", "coincident"}) {
    const auto draw = [&]<class S>(Random& random) {
      const bench::PolygonFamily<S> rings = bench::polygon_family<S>(name, 8);
      const bench::PolygonCase<S> c = rings.draw(random);
      return located<S>(c.point, {*c.ring});
    };
    file.family(name, 3, [&](Random& r) { return draw.template operator()<double>(r); });
    file.family(std::string(name) + ", in floats", 2, [&](Random& r) { return draw.template operator()<float>(r); });
  }
  const auto almost = [&]<class S>(Random& random) -> std::optional<Case> {
    const Ring<S, 2> ring = bench::polygon_families::star<S>(random, 6);
    const Point<S, 2> p = bench::polygon_families::near_edge(random, ring);
    return almost_on_an_edge(p, ring) ? std::optional(located<S>(p, {ring})) : std::nullopt;
  };
  const char* nearer = "nearer to an edge than rounding sees";
  file.family(nearer, 8, [&](Random& r) { return almost.template operator()<double>(r); });
  file.family(std::string(nearer) + ", in floats", 4, [&](Random& r) { return almost.template operator()<float>(r); });
  by_numbers(file, 2, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const Rings<S> rings = tests::random_rings<S>(random, numbers);
    std::size_t vertices = 0;
    for (const Ring<S, 2>& r : rings) vertices += r.size();
    const Point<S, 2> p = tests::random_point(random, numbers, rings);
    if (vertices == 0 || vertices > 16 || !finite(p)) return {};
    for (const Ring<S, 2>& r : rings)
      if (!finite(r)) return {};
    return located(p, rings);
  });
  return file;
}

CaseFile ray_polygon() {
  CaseFile file("ray_polygon");
  using P = Point<double, 3>;
  const auto add = [&](const char* note, P origin, P direction, Ring<double, 3> ring,
                       Interval<double> range = semi_infinite<double>) {
    file.add(note, ray_and_polygon<double>({origin, direction, range}, ring));
  };
  const Ring<double, 3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  add("at a vertex", {1, 1, 1}, {0, 0, -1}, square);
  add("at an edge", {.5, 1, 1}, {0, 0, -1}, square);
  add("an ulp beside an edge", {.5, std::nextafter(1., 2.), 1}, {0, 0, -1}, square);
  add("in the plane", {-1, .5, 0}, {1, 0, 0}, square);
  add("parallel, the smallest number above it", {-1, .5, least}, {1, 0, 0}, square);
  add("no area: all vertices on a line", {.5, .5, 1}, {0, 0, -1}, {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}});
  add("no area: there and back", {.5, .5, 1}, {0, 0, -1}, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, 0}});
  add("two vertices", {.5, 0, 1}, {0, 0, -1}, {{0, 0, 0}, {1, 0, 0}});
  add("the first three vertices on a line", {.5, .5, 1}, {0, 0, -1}, {{0, 0, 0}, {.5, 0, 0}, {1, 0, 0}, {1, 1, 0}});
  add("repeated vertices", {.25, .5, 1}, {0, 0, -1}, {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}});
  add("a bow-tie with area, at its crossing", {1, .5, 1}, {0, 0, -1},
      {{0, 0, 0}, {2, 1, 0}, {2, 0, 0}, {0, 1, 0}, {-1, 0, 0}});
  add("wound twice: out, by the even-odd rule", {.5, .25, 1}, {0, 0, -1},
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
  add("a segment that ends in it", {.5, .5, 1}, {0, 0, -1}, square, {0, 1});
  add("a segment that ends an ulp before it", {.5, .5, 1}, {0, 0, -1}, square, {0, std::nextafter(1., 0.)});
  add("from inside the outline", {.5, .5, 0}, {0, 0, 1}, square);
  add("a triangle of size 1e-300", {2e-301, 2e-301, 1e-300}, {0, 0, -1}, {{0, 0, 0}, {1e-300, 0, 0}, {0, 1e-300, 0}});
  add("a triangle of size 1e300", {2e299, 2e299, 1e300}, {0, 0, -1}, {{0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}});
  const auto ask = [](const auto& c) { return ray_and_polygon(c.a, c.b); };
  by_families(file, 3, bench::ray_polygon_draws<double>, bench::ray_polygon_draws<float>, ask);
  return file;
}

CaseFile segment_segment() {
  CaseFile file("segment_segment");
  const auto add = [&](const char* note, Segment<double, 2> a, Segment<double, 2> b) {
    file.add(note, segments(a, b));
  };
  add("an end on the other, as typed but not as rounded", {{0, 0}, {.3, .9}}, {{.1, .3}, {1, 0}});
  add("an end at an end", {{0, 0}, {.1, .7}}, {{.1, .7}, {1, 0}});
  add("of one line, an end in common", {{0, 0}, {1, 1}}, {{1, 1}, {2, 2}});
  add("of one line, an ulp apart", {{0, 0}, {1, 0}}, {{std::nextafter(1., 2.), 0}, {2, 0}});
  add("of one line, the other way round", {{0, 0}, {3, 3}}, {{4, 4}, {1, 1}});
  add("equal", {{.1, .7}, {.3, -.9}}, {{.3, -.9}, {.1, .7}});
  add("equal points", {{.1, .7}, {.1, .7}}, {{.1, .7}, {.1, .7}});
  add("a point on a segment", {{.5, .5}, {.5, .5}}, {{0, 0}, {1, 1}});
  add("a point beside a segment by an ulp", {{.5, std::nextafter(.5, 1)}, {.5, .5}}, {{0, 0}, {1, 1}});
  add("parallel, an ulp apart", {{0, 0}, {1, 0}}, {{0, least}, {1, least}});
  add("zeros of either sign", {{-1, -0.}, {1, 0}}, {{0, -1}, {-0., 1}});
  add("products that overflow", {{-most, -most}, {most, most}}, {{-most, most}, {most, -most}});
  add("products that vanish", {{0, 0}, {2 * least, 2 * least}}, {{0, 2 * least}, {2 * least, 0}});
  by_numbers(file, 6, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const auto c = tests::segment_pairs::draw<S>(random, numbers);
    if (!finite(c.a) || !finite(c.b)) return {};
    return segments(c.a, c.b);
  });
  return file;
}

CaseFile polygon_polygon() {
  CaseFile file("polygon_polygon");
  using bench::polygon_pairs::box;
  const auto add = [&](const char* note, const Polygon<double, 2>& a, const Polygon<double, 2>& b) {
    file.add(note, polygons(a, b));
  };
  const Polygon<double, 2> square = {{box(0, 0, 4, 4)}}, frame = {{box(0, 0, 9, 9), box(3, 3, 6, 6)}};
  const Ring<double, 2> u = {{0, 0}, {5, 0}, {5, 5}, {4, 5}, {4, 1}, {1, 1}, {1, 5}, {0, 5}},
                        tie = {{0, 0}, {4, 4}, {4, 0}, {0, 4}};
  add("the same, from another corner and the other way", square, {{{{4, 4}, {4, 0}, {0, 0}, {0, 4}}}});
  add("a side in common, part of it", square, {{box(4, 1, 8, 2)}});
  add("a corner in common", square, {{box(4, 4, 8, 8)}});
  add("an ulp apart", square, {{box(std::nextafter(4., 5.), 0, 8, 4)}});
  add("an ulp across", square, {{box(std::nextafter(4., 3.), 0, 8, 4)}});
  add("a cross: no corner of either lies in the other", {{box(0, 1, 9, 2)}}, {{box(1, 0, 2, 9)}});
  add("all corners of one on the other, most of it outside", {{u}}, {{{{1, 5}, {4, 5}, {4, 3}}}});
  add("in the arms of a concave one", {{u}}, {{box(2, 2, 3, 9)}});
  add("between the arms of a concave one, along all three", {{u}}, {{box(1, 1, 4, 5)}});
  add("a hole that is filled", frame, {{box(3, 3, 6, 6)}});
  add("a hole that is not filled", frame, {{box(4, 4, 5, 5)}});
  add("a hole that is more than filled, by an ulp", frame, {{box(3, 3, 6, std::nextafter(6., 7.))}});
  add("without its hole", frame, {{box(0, 0, 9, 9)}});
  add("with a larger hole", frame, {{box(0, 0, 9, 9), box(2, 2, 7, 7)}});
  add("an island in the hole", frame, {{box(0, 0, 9, 9), box(3, 3, 6, 6), box(4, 4, 5, 5)}});
  add("a ring in a ring", {{box(0, 0, 9, 9), box(1, 1, 8, 8)}}, {{box(2, 2, 7, 7), box(3, 3, 6, 6)}});
  add("two parts and their union", {{box(0, 0, 4, 4), box(4, 0, 8, 4)}}, {{box(0, 0, 8, 4)}});
  add("a bow-tie and its wings", {{tie}}, {{{{0, 0}, {2, 2}, {0, 4}}, {{4, 0}, {2, 2}, {4, 4}}}});
  add("a bow-tie and what is between its wings", {{tie}}, {{{{0, 0}, {4, 0}, {2, 2}}}});
  add("an antenna, and what lies on it", {{{{0, 0}, {4, 0}, {8, 0}, {4, 0}, {4, 4}, {0, 4}}}}, {{box(6, 0, 7, 1)}});
  add("without an area: within", square, {{{{1, 1}, {2, 2}}}});
  add("without an area: across", square, {{{{3, 3}, {6, 6}}}});
  add("a point at a corner", square, {{{{4, 4}}}});
  add("a point as a part", {{box(0, 0, 4, 4), {{9, 9}}}}, square);
  add("repeated corners", square, {{{{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4}, {0, 4}, {0, 0}}}});
  add("corners on the sides", square, {{{{0, 0}, {1, 0}, {4, 0}, {4, 4}, {3, 4}, {0, 4}, {0, .5}}}});
  add("no rings", {}, square);
  add("no vertices", {{{}}}, square);
  add("a corner on an edge as typed, not as rounded", {{{{0, 0}, {.3, .9}, {1, 0}}}}, {{{{.1, .3}, {0, 1}, {0, .5}}}});
  add("the smallest numbers there are", {{{{0, 0}, {2 * least, 0}, {0, 2 * least}}}},
      {{{{least, least}, {2 * least, least}, {2 * least, 2 * least}}}});
  add("the largest numbers there are", {{{{-most, -most}, {most, -most}, {0, most}}}}, {{box(-1, -1, 1, 1)}});
  for (const auto& family : bench::polygon_pair_families)
    file.family(family.name, 3, [&](Random& random) {
      const bench::PolygonPair<double> c = family.draw(random);
      return polygons(c.a, c.b);
    });
  return file;
}

CaseFile segment_polygon() {
  CaseFile file("segment_polygon");
  using bench::polygon_pairs::box;
  const auto add = [&](const char* note, const Segment<double, 2>& s, const Polygon<double, 2>& p) {
    file.add(note, segment_and_polygon(s, p));
  };
  const Polygon<double, 2> frame = {{box(0, 0, 9, 9), box(3, 3, 6, 6)}};
  add("through one side", {{-1, 1}, {1, 1}}, frame);
  add("through the hole", {{-1, 5}, {10, 5}}, frame);
  add("in the hole", {{4, 4}, {5, 5}}, frame);
  add("in the hole, its ends on the rim", {{3, 3}, {6, 6}}, frame);
  add("within, to a corner of the hole", {{0, 0}, {3, 3}}, frame);
  add("along a side", {{0, 0}, {9, 0}}, frame);
  add("along a side and beyond", {{-1, 0}, {9, 0}}, frame);
  add("along the rim of the hole", {{3, 3}, {3, 6}}, frame);
  add("at a corner", {{-1, 1}, {1, -1}}, frame);
  add("an ulp beside a corner", {{-1, 1}, {1, std::nextafter(-1., -2.)}}, frame);
  add("an ulp across a corner", {{-1, 1}, {1, std::nextafter(-1., 0.)}}, frame);
  add("through a corner of each", {{-1, -1}, {10, 10}}, frame);
  add("no rings", {{0, 0}, {1, 1}}, {});
  add("a ring that is a segment", {{0, 0}, {4, 4}}, {{{{1, 1}, {3, 3}}}});
  add("a ring that is the same segment", {{0, 0}, {4, 4}}, {{{{4, 4}, {0, 0}}}});
  add("a ring that is a point of it", {{0, 0}, {4, 4}}, {{{{1, 1}}}});
  for (const auto& family : bench::polygon_pair_families)
    file.family(family.name, 3, [&](Random& random) -> std::optional<Case> {
      const bench::PolygonPair<double> c = family.draw(random);
      if (c.a.rings.empty() || c.b.rings.empty() || c.b.rings[0].empty()) return {};
      const Ring<double, 2>&of_a = c.a.rings[0], &of_b = c.b.rings[0];
      const Segment<double, 2> s = {of_b[0], random.one_in(2) && !of_a.empty() ? of_a[0] : of_b.back()};
      if (s.p == s.q) return {};
      return segment_and_polygon(s, c.a);
    });
  return file;
}

CaseFile ray_outline() {
  CaseFile file("ray_outline");
  using P = Point<double, 2>;
  const auto add = [&](const char* note, P origin, P direction, Rings<double> rings,
                       Interval<double> range = semi_infinite<double>) {
    file.add(note, ray_in_plane<double>({origin, direction, range}, {rings}));
  };
  const Ring<double, 2> square = {{1, 1}, {5, 1}, {5, 5}, {1, 5}}, hole = {{2, 2}, {4, 2}, {4, 4}, {2, 4}};
  const Ring<double, 2> tenths = {{.1, .1}, {.3, .1}, {.3, .3}, {.1, .3}}, bow = {{0, 0}, {4, 4}, {4, 0}, {0, 4}};
  const double below = std::nextafter(1., 0.);
  add("onto a side", {0, 3}, {1, 0}, {square});
  add("from inside", {3, 3}, {1, 0}, {square});
  add("from a hole", {3, 3}, {1, 0}, {square, hole});
  add("from the side of a hole, inwards", {2, 3}, {1, 0}, {square, hole});
  add("from a corner, away", {5, 5}, {1, 1}, {square});
  add("from an ulp beside a side, away", {std::nextafter(5., 6.), 3}, {1, 0}, {square});
  add("through a corner that it only touches", {0, 2}, {1, -1}, {square});
  add("an ulp beside that corner", {0, std::nextafter(2., 0.)}, {1, -1}, {square});
  add("along a side", {0, 1}, {1, 0}, {square});
  add("along a side, an ulp beside it", {0, below}, {1, 0}, {square});
  add("along a side that the range starts on", {0, 1}, {1, 0}, {square}, {3, inf});
  add("the range starts in the hole", {0, 3}, {1, 0}, {square, hole}, {2.5, inf});
  add("the range ends on the side", {0, 3}, {1, 0}, {square}, {0, 1});
  add("the range ends an ulp before the side", {0, 3}, {1, 0}, {square}, {0, below});
  add("a line, behind its origin", {9, 3}, {1, 0}, {square}, {-inf, inf});
  add("tenths: along the diagonal", {0, 0}, {.1, .1}, {tenths});
  add("tenths: a corner rounded", {0, 0}, {.3, .1}, {tenths});
  add("tenths: towards the far corner", {-.1, .5}, {.2, -.1}, {tenths});
  add("where an outline crosses itself", {2, -1}, {0, 1}, {bow});
  add("from where an outline crosses itself", {2, 2}, {0, 1}, {bow});
  add("wound twice, from within: outside by even-odd", {2, 3}, {1, 0},
      {{{1, 1}, {5, 1}, {5, 5}, {1, 5}, {1, 1}, {5, 1}, {5, 5}, {1, 5}}});
  add("onto a spike", {0, 7}, {1, 0}, {{{1, 1}, {5, 1}, {5, 5}, {3, 5}, {3, 9}, {3, 5}, {1, 5}}});
  add("a ring of two corners is a segment", {0, 0}, {1, 1}, {{{4, 0}, {0, 4}}});
  add("a ring of one corner is a point", {0, 0}, {.1, .1}, {{{.3, .3}}});
  add("a ring of one corner, beside it", {0, 0}, {.1, .1}, {{{.3, std::nextafter(.3, 1)}}});
  add("no ring", {0, 0}, {1, 1}, {});
  add("no direction, on a side", {1, 3}, {0, -0.}, {square}, {-2, 7});
  add("no direction, in the hole", {3, 3}, {0, 0}, {square, hole});
  add("an empty range", {0, 3}, {1, 0}, {square}, {3, 2});
  add("a direction whose square vanishes", {0, 3}, {1e-300, 0}, {square});
  add("a direction whose square overflows", {0, 3}, {1e300, 1e300}, {square});
  add("1e-300 beside 1e300", {-1e300, 1e-300}, {1e300, 0}, {{{0, 0}, {1, 0}, {0, 1e-300}}});
  by_numbers(file, 4, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const auto c = tests::ray_outline_pairs::draw<S>(random, numbers);
    return ray_in_plane(c.ray, c.polygon);
  });
  return file;
}

CaseFile line_triangle() {
  CaseFile file("line_triangle");
  using P = Point<double, 3>;
  const auto add = [&](const char* note, P origin, P direction, std::array<P, 3> corners,
                       Interval<double> range = semi_infinite<double>) {
    file.add(note, line_and_triangle<double>({origin, direction, range}, {corners}));
  };
  const std::array<P, 3> flat = {P(0, 0, 0), P(4, 0, 0), P(0, 4, 0)}, thin = {P(1, 1, 0), P(4, 4, 0), P(2, 2, 0)};
  const std::array<P, 3> point = {P(.1, .2, .3), P(.1, .2, .3), P(.1, .2, .3)};
  const std::array<P, 3> slanted = {P(1, 0, 0), P(0, 1, 0), P(0, 0, 1)};
  add("across its plane", {1, 1, 3}, {0, 0, -1}, flat);
  add("across an edge", {2, 2, 3}, {0, 0, -1}, flat);
  add("across its plane, an ulp beside that edge", {2, std::nextafter(2., 3.), 3}, {0, 0, -1}, flat);
  add("across a corner", {0, 4, 3}, {0, 0, -.1}, flat);
  add("in its plane, from outside", {-2, 1, 0}, {1, 0, 0}, flat);
  add("in its plane, from inside", {1, 1, 0}, {1, 0, 0}, flat);
  add("in its plane, along an edge", {-2, 0, 0}, {3, 0, 0}, flat);
  add("in its plane, at a corner", {4, -1, 0}, {0, 2, 0}, flat);
  add("in its plane, an ulp beside a corner", {std::nextafter(4., 5.), -1, 0}, {0, 2, 0}, flat);
  add("in its plane, a line", {-2, 1, 0}, {1, 0, 0}, flat, {-inf, inf});
  add("in its plane, the range ends on an edge", {-2, 1, 0}, {2, 0, 0}, flat, {0, 1});
  add("in its plane, the range ends an ulp before", {-2, 1, 0}, {2, 0, 0}, flat, {0, std::nextafter(1., 0.)});
  add("above its plane by the least", {-2, 1, least}, {1, 0, 0}, flat);
  add("in a slanted plane", {3, -1, -1}, {-2, 1, 1}, slanted);
  add("in a slanted plane, along an edge", {2, -1, 0}, {-1, 1, 0}, slanted);
  add("beside a slanted plane by an ulp", {3, -1, std::nextafter(-1., 0.)}, {-2, 1, 1}, slanted);
  add("without area, crossed", {3, 3, 3}, {0, 0, -2}, thin);
  add("without area, along it", {0, 0, 0}, {1, 1, 0}, thin);
  add("without area, from within it", {3, 3, 0}, {1, 1, 0}, thin);
  add("without area, missed beyond its end", {5, 5, 3}, {0, 0, -1}, thin);
  add("without area, missed by the least", {3, 3, 3}, {least, 0, -1}, thin);
  add("a point that is met", {0, 0, 0}, {.1, .2, .3}, point);
  add("a point that is missed by an ulp", {0, 0, 0}, {.1, .2, std::nextafter(.3, 1)}, point);
  add("no direction, inside", {1, 1, 0}, {0, -0., 0}, flat, {-2, 7});
  add("no direction, on a triangle without area", {3, 3, 0}, {0, 0, 0}, thin, {-2, 7});
  add("no direction, outside", {1, 1, 1}, {0, 0, 0}, flat);
  add("an empty range", {1, 1, 3}, {0, 0, -1}, flat, {5, 4});
  add("a direction whose square vanishes", {-2, 1, 0}, {1e-300, 0, 0}, flat);
  add("a direction whose square overflows", {-2, 1, 0}, {1e300, 0, 0}, flat);
  add("corners of 1e300", {-2, 1e299, 0}, {1, 0, 0}, {P(0, 0, 0), P(1e300, 0, 0), P(0, 1e300, 0)});
  add("corners of 1e-300", {-2, 1e-301, 0}, {1, 0, 0}, {P(0, 0, 0), P(1e-300, 0, 0), P(0, 1e-300, 0)});
  by_numbers(file, 4, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const auto corner = [&]() -> Point<S, 3> { return bench::vector<S, 3>(random, numbers); };
    Triangle<S, 3> x = {{corner(), corner(), corner()}};
    if (random.one_in(2)) x.vertices[1][2] = x.vertices[2][2] = x.vertices[0][2];
    if (random.one_in(5)) x.vertices[2] = x.vertices[0];
    Ray<S, 3> ray = {corner(), x.vertices[1] / 2 + x.vertices[2] / 2};
    ray.direction -= ray.origin;
    if (random.one_in(2)) ray.origin[2] = x.vertices[0][2], ray.direction[2] = 0;
    if (!finite(ray)) return {};
    return line_and_triangle(ray, x);
  });
  return file;
}

}  // namespace isect::cases
