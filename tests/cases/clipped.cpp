// What half-spaces and boxes leave of segments and polygons, and what is decided by clipping: how convex polygons lie.

#include <isect/clip_segment.h>
#include <isect/methods/clip_segment.h>
#include "bench/clip_polygon/oracle.h"
#include "bench/clip_segment/oracle.h"
#include "bench/convex_polygons/families.h"
#include "bench/convex_polygons/oracle.h"
#include "tests/cases/shapes.h"

namespace isect::cases {

namespace {

using oracle::operator+, oracle::operator-, oracle::operator*;

template <class S, int N>
Json segment_fields(const Segment<S, N>& s) {
  return {{"segment", {json<S, N>(s.p), json<S, N>(s.q)}}};
}
/// The ends of the part that is kept.
Json ends(const std::optional<oracle::Kept>& kept) {
  return {{"t_in", kept ? json(nearest(*kept->lo)) : Json(nullptr)},
          {"t_out", kept ? json(nearest(*kept->hi)) : Json(nullptr)}};
}

template <class S, int N>
Case segment_and_plane(const Segment<S, N>& s, const Plane<S, N>& plane) {
  const Rational p = oracle::height<S, N>(plane, oracle::rational<S, N>(s.p)),
                 q = oracle::height<S, N>(plane, oracle::rational<S, N>(s.q));
  const bool parallel = p == q, coplanar = parallel && p == 0;
  Json expected = {{"parallel", parallel},
                   {"coplanar", coplanar},
                   {"line_hit", !parallel || coplanar},
                   {"t", parallel ? Json(nullptr) : json(nearest(p / (p - q)))},
                   {"hit", oracle::sign(p) * oracle::sign(q) <= 0}};
  expected.update(ends(oracle::clipped<S, N>(s, plane)));
  return {both(segment_fields(s), fields(plane)), expected, is_f32<S>};
}

template <class S, int N>
Case segment_and_box(const Segment<S, N>& s, const Aabb<S, N>& box) {
  const auto kept = oracle::clipped<S, N>(s, box);
  return {both(segment_fields(s), fields(box)), both({{"hit", kept.has_value()}}, ends(kept)), is_f32<S>};
}

template <std::size_t N>
Json points(const std::vector<std::array<Rational, N>>& ring) {
  Json all = Json::array();
  for (const auto& v : ring) {
    Json one = Json::array();
    for (const Rational& x : v) one.push_back(json(nearest(x)));
    all.push_back(one);
  }
  return {{"hit", !ring.empty()}, {"points", all}};
}

template <class S, int N>
Case polygon_and_plane(const Ring<S, N>& ring, const Plane<S, N>& plane) {
  return {both({{"polygon", json<S, N>(ring)}}, fields(plane)), points(oracle::clipped<S, N>(ring, plane)), is_f32<S>};
}

/// Clips side by side. Nothing if a vertex that is not a number of S is cut again, since the result then can't be given
/// in ulps.
template <class S, int N>
std::optional<Case> polygon_and_box(const Ring<S, N>& ring, const Aabb<S, N>& box) {
  std::vector<oracle::Coordinates<N>> left;
  for (const Point<S, N>& v : ring) left.push_back(oracle::rational<S, N>(v));
  const auto is_number = [](const Rational& x) { return Rational(static_cast<S>(nearest(x))) == x; };
  for (int axis = 0; axis < N; ++axis)
    for (const int side : {1, -1}) {
      const Rational bound = Rational(side > 0 ? box.lo[axis] : box.hi[axis]);
      std::vector<oracle::Coordinates<N>> next;
      for (std::size_t i = 0; i < left.size(); ++i) {
        const auto &x = left[i], &y = left[(i + 1) % left.size()];
        const Rational from = side * (x[axis] - bound), to = side * (y[axis] - bound);
        if (!is_number(x[axis])) return {};
        if (from >= 0) next.push_back(x);
        if (oracle::sign(from) * oracle::sign(to) >= 0) continue;
        if (!std::ranges::all_of(x, is_number) || !std::ranges::all_of(y, is_number)) return {};
        next.push_back(x + Rational(from / (from - to)) * (y - x));
      }
      left = next;
    }
  return Case{both({{"polygon", json<S, N>(ring)}}, fields(box)), points(left), is_f32<S>};
}

template <class S>
Case polygons(const ConvexPolygon<S>& a, const ConvexPolygon<S>& b) {
  return {{{"a", json<S, 2>(a.vertices)}, {"b", json<S, 2>(b.vertices)}}, related(oracle::relation(a, b)), is_f32<S>};
}

/// A plane through x, up to rounding and an ulp.
template <class S, int N>
Plane<S, N> plane_near(Random& random, Numbers numbers, const Point<S, N>& x) {
  const Vector<S, N> normal = bench::vector<S, N>(random, random.one_in(2) ? Numbers::grid : numbers);
  const double d = -normal.template cast<double>().dot(x.template cast<double>());
  return {normal, random.one_in(3) ? bench::number<S>(random, numbers)
                                   : bench::moved(static_cast<S>(d), random.integer(-1, 1))};
}
template <class S, int N>
bool usable(const Plane<S, N>& plane) {
  return finite(plane) && !plane.normal.isZero(0);
}
template <class S, int N>
Aabb<S, N> box_of(Random& random, Numbers numbers) {
  const Point<S, N> a = bench::vector<S, N>(random, numbers), b = bench::vector<S, N>(random, numbers);
  return {a.cwiseMin(b), a.cwiseMax(b)};
}

}  // namespace

CaseFile segment_plane() {
  CaseFile file("segment_plane");
  const auto add = [&](const char* note, Point<double, 2> p, Point<double, 2> q, Plane<double, 2> plane) {
    file.add(note, segment_and_plane<double, 2>({p, q}, plane));
  };
  add("across the plane", {0, 0}, {4, 1}, {{1, 0}, -1});
  add("it ends in the plane", {0, 0}, {1, 1}, {{1, 0}, -1});
  add("it ends an ulp before the plane", {0, 0}, {std::nextafter(1., 0.), 1}, {{1, 0}, -1});
  add("within the plane", {1, 0}, {1, 5}, {{1, 0}, -1});
  add("beside the plane by an ulp", {std::nextafter(1., 2.), 0}, {std::nextafter(1., 2.), 5}, {{1, 0}, -1});
  add("its direction rounds: it ends at 1", {1e16 + 2, 0}, {1, 0}, {{-1, 0}, .5});
  add("a point on the plane", {.5, .5}, {.5, .5}, {{1, 1}, -1});
  add("a point above it", {.5, .75}, {.5, .75}, {{1, 1}, -1});
  add("products that overflow", {-1e200, 0}, {1e200, 0}, {{1e200, 0}, 1e300});
  add("products that vanish", {-1e-200, 0}, {1e-200, 0}, {{1e-200, 0}, 1e-320});
  add("t is beyond the largest number", {0, 0}, {1e-200, 0}, {{1, 0}, -1e200});
  by_numbers(file, 3, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const Segment<S, 3> s = {bench::vector<S, 3>(random, numbers), bench::vector<S, 3>(random, numbers)};
    const Plane<S, 3> plane = plane_near<S, 3>(random, numbers, random.one_in(2) ? s.p : s.q);
    if (!usable(plane)) return {};
    return segment_and_plane(s, plane);
  });
  return file;
}

CaseFile segment_box() {
  CaseFile file("segment_box");
  const Aabb<double, 2> unit = {{-1, -1}, {1, 1}};
  const auto add = [&](const char* note, Point<double, 2> p, Point<double, 2> q, Aabb<double, 2> box) {
    file.add(note, segment_and_box<double, 2>({p, q}, box));
  };
  add("into it", {-3, 0}, {1, 0}, unit);
  add("within", {0, 0}, {.5, .5}, unit);
  add("at a corner", {-2, 0}, {0, 2}, unit);
  add("an ulp beside the corner", {-2, 0}, {0, std::nextafter(2., 3.)}, unit);
  add("along a side", {-3, 1}, {3, 1}, unit);
  add("along a side, an ulp beside it", {-3, std::nextafter(1., 2.)}, {3, std::nextafter(1., 2.)}, unit);
  add("it ends on a side", {-3, 0}, {-1, .1}, unit);
  add("it ends an ulp before the side", {-3, 0}, {std::nextafter(-1., -2.), .1}, unit);
  add("its direction rounds: it ends at 1", {1e16 + 2, 0}, {1, 0}, {{0, -1}, {.5, 1}});
  add("tenths, through the corner but for rounding", {1.7, 1.7}, {2.9, -.4}, {{-2, -1}, {2, 1.175}});
  add("a point in it", {.5, .5}, {.5, .5}, unit);
  add("an inverted box is empty", {-1, 0}, {1, 0}, {{1, 1}, {-1, -1}});
  add("a box that is a point", {0, 0}, {.9, .3}, {{.3, .1}, {.3, .1}});
  add("from the least to the most", {-most, -most}, {most, most}, {{-least, -least}, {least, least}});
  const auto beside_edge = []<class S>(Random& random) -> std::optional<Case> {
    const Aabb<S, 3> box = box_of<S, 3>(random, Numbers::ordinary);
    Point<S, 3> edge = box.lo + static_cast<S>(random.unit()) * (box.hi - box.lo);
    for (int k = 0, free = random.below(3); k < 3; ++k)
      if (k != free) edge[k] = random.one_in(2) ? box.lo[k] : box.hi[k];
    const Point<S, 3> p = bench::vector<S, 3>(random, Numbers::ordinary);
    const Segment<S, 3> s = {p, edge + static_cast<S>(random.unit()) * (edge - p)};
    const bool kept = oracle::clipped<S, 3>(s, box).has_value();
    return kept == clip_segment::liang_barsky(s, box).has_value() ? std::nullopt
                                                                  : std::optional(segment_and_box(s, box));
  };
  const char* nearer = "passes an edge nearer than rounding sees";
  file.family(nearer, 6, [&](Random& r) { return beside_edge.template operator()<double>(r); });
  file.family(std::string(nearer) + ", in floats", 3,
              [&](Random& r) { return beside_edge.template operator()<float>(r); });
  by_numbers(file, 3, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const Aabb<S, 3> box = box_of<S, 3>(random, numbers);
    Segment<S, 3> s = {bench::vector<S, 3>(random, numbers), bench::vector<S, 3>(random, numbers)};
    if (random.one_in(2)) {  // through an edge, up to rounding
      Point<S, 3> edge = box.lo + static_cast<S>(random.unit()) * (box.hi - box.lo);
      for (int k = 0, free = random.below(3); k < 3; ++k)
        if (k != free) edge[k] = random.one_in(2) ? box.lo[k] : box.hi[k];
      s.q = edge + static_cast<S>(random.unit()) * (edge - s.p);
    } else {
      for (int k = 0; k < 3; ++k)  // ends on faces, edges and corners
        if (random.one_in(3)) s.q[k] = random.one_in(2) ? box.lo[k] : box.hi[k];
    }
    if (!finite(s)) return {};
    return segment_and_box(s, box);
  });
  return file;
}

CaseFile convex_polygons() {
  CaseFile file("convex_polygons");
  const auto add = [&](const char* note, const Ring<double, 2>& a, const Ring<double, 2>& b) {
    file.add(note, polygons<double>({a}, {b}));
  };
  const Ring<double, 2> square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const double before = std::nextafter(4., 0.), beyond = std::nextafter(4., 5.);
  add("a corner at a side", square, {{4, 2}, {6, 1}, {6, 3}});
  add("an ulp beside the side", square, {{beyond, 2}, {6, 1}, {6, 3}});
  add("an ulp across the side", square, {{before, 2}, {6, 1}, {6, 3}});
  add("corner at corner", square, {{4, 4}, {6, 5}, {5, 6}});
  add("side at side", square, {{4, 1}, {6, 1}, {6, 9}, {4, 9}});
  add("an edge of the second cuts a corner off", square, {{4, 5}, {5, 4}, {9, 9}});
  add("equal, from another corner on", square, {{4, 4}, {0, 4}, {0, 0}, {4, 0}});
  add("within, and it touches from there", square, {{0, 1}, {4, 2}, {0, 3}});
  add("a cross: no corner in the other", square, {{1, -1}, {3, -1}, {3, 5}, {1, 5}});
  by_families(file, 3, bench::convex_polygons_draws<double>, bench::convex_polygons_draws<float>,
              [](const auto& c) { return polygons(c.a, c.b); });
  by_numbers(file, 1, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const auto a = bench::convex_polygon_families::of_any_numbers<S>(random, numbers, {});
    if (!a) return {};
    const auto b = bench::convex_polygon_families::of_any_numbers<S>(random, numbers, a->vertices);
    if (!b) return {};
    return polygons(*a, *b);
  });
  return file;
}

CaseFile polygon_plane() {
  CaseFile file("polygon_plane");
  const Ring<double, 2> square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const auto add = [&](const char* note, const Ring<double, 2>& ring, Plane<double, 2> plane) {
    file.add(note, polygon_and_plane(ring, plane));
  };
  add("cut in two", square, {{1, 0}, -1});
  add("a corner is left", square, {{-1, -1}, 2});
  add("all is left", square, {{1, 0}, 1});
  add("along a side, from within", square, {{1, 0}, 0});
  add("along a side, from outside", square, {{-1, 0}, 0});
  add("at a corner", square, {{-1, -1}, 0});
  add("an ulp beside the corner", {{least, 0}, {4, 0}, {4, 4}, {0, 4}}, {{-1, -1}, 0});
  add("through two corners", square, {{1, -1}, 0});
  add("no vertices", {}, {{1, 0}, 0});
  add("one vertex", {{.5, .5}}, {{1, 1}, -1});
  add("products that overflow", {{-1e200, 0}, {1e200, 0}, {0, 1e200}}, {{1e200, 0}, 1e300});
  add("products that vanish", {{-1e-200, 0}, {1e-200, 0}, {0, 1e-200}}, {{1e-200, 0}, 1e-320});
  by_numbers(file, 2, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    Ring<S, 3> ring;
    for (int i = 0; i < 3; ++i) ring.push_back(bench::vector<S, 3>(random, numbers));
    const Plane<S, 3> plane = plane_near<S, 3>(random, numbers, ring[0]);
    if (!usable(plane)) return {};
    return polygon_and_plane(ring, plane);
  });
  return file;
}

CaseFile polygon_box() {
  CaseFile file("polygon_box");
  const Ring<double, 2> square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const auto add = [&](const char* note, const Ring<double, 2>& ring, Aabb<double, 2> box) {
    file.add(note, *polygon_and_box(ring, box));
  };
  add("a corner is left", square, {{2, 2}, {9, 9}});
  add("all of the box is left", square, {{1, 1}, {3, 3}});
  add("all of the polygon is left", square, {{-1, -1}, {9, 9}});
  add("side at side", square, {{4, 1}, {9, 3}});
  add("side beside side, by an ulp", square, {{std::nextafter(4., 5.), 1}, {9, 3}});
  add("corner at corner", square, {{4, 4}, {9, 9}});
  add("a corner of the box on an edge", {{0, 0}, {4, 0}, {0, 4}}, {{2, 2}, {9, 9}});
  add("an ulp beside it", {{0, 0}, {4, 0}, {0, 4}}, {{2, std::nextafter(2., 3.)}, {9, 9}});
  add("a box that is a point within", square, {{.1, .3}, {.1, .3}});
  add("an inverted box is empty", square, {{3, 3}, {1, 1}});
  add("no vertices", {}, {{-1, -1}, {1, 1}});
  by_numbers(file, 2, [&]<class S>(Random& random, Numbers numbers) -> std::optional<Case> {
    const Aabb<S, 2> box = box_of<S, 2>(random, numbers);
    Ring<S, 2> ring;
    for (int i = 0; i < 3; ++i) ring.push_back(bench::vector<S, 2>(random, numbers));
    for (Point<S, 2>& v : ring)  // at its sides and corners
      for (int k = 0; k < 2; ++k)
        if (random.one_in(4)) v[k] = random.one_in(2) ? box.lo[k] : box.hi[k];
    return polygon_and_box(ring, box);
  });
  return file;
}

}  // namespace isect::cases
