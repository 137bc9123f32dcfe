// Polygons with points and rays, and segments.

#include "bench/point_polygon/families.h"
#include "bench/polygon_polygon/families.h"
#include "bench/polygon_polygon/oracle.h"
#include "bench/ray_polygon/families.h"
#include "bench/ray_polygon/oracle.h"
#include "tests/cases/shapes.h"
#include "tests/core/point_location.h"
#include "tests/core/segment_pairs.h"

namespace isect::cases {

namespace {

using oracle::operator-;

template <class S>
using Rings = std::vector<Ring<S, 2>>;

/// By the winding number, which tells both rules.
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

/// Whether the point is at the height of an edge, and so near to it that doubles err about every other time.
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

Case polygons(const Polygon<double, 2>& a, const Polygon<double, 2>& b) {
  return {{{"a", outlines(a)}, {"b", outlines(b)}},
          related(oracle::polygon_polygon_truth(a, b).relation()),
          is_f32<double>};
}

/// The ends differ.
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
    file.family(name, 6, [&](Random& r) { return draw.template operator()<double>(r); });
    file.family(std::string(name) + ", in floats", 3, [&](Random& r) { return draw.template operator()<float>(r); });
  }
  const auto almost = [&]<class S>(Random& random) -> std::optional<Case> {
    const Ring<S, 2> ring = bench::polygon_families::star<S>(random, 6);
    const Point<S, 2> p = bench::polygon_families::near_edge(random, ring);
    return almost_on_an_edge(p, ring) ? std::optional(located<S>(p, {ring})) : std::nullopt;
  };
  const char* nearer = "nearer to an edge than rounding sees";
  file.family(nearer, 20, [&](Random& r) { return almost.template operator()<double>(r); });
  file.family(std::string(nearer) + ", in floats", 10, [&](Random& r) { return almost.template operator()<float>(r); });
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
  by_families(file, 4, bench::ray_polygon_draws<double>, bench::ray_polygon_draws<float>, ask);
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

}  // namespace isect::cases
