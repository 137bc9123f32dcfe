// Convex polygons against each other: by name, by property, and against their common part, clipped in rationals.

#include <isect/convex_polygons.h>

#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "bench/convex_polygons/families.h"
#include "bench/convex_polygons/oracle.h"
#include "tests/catch.h"
#include "tests/core/growth.h"
#include "tests/core/hull_oracle.h"
#include "tests/settings.h"

namespace convex_polygons_test {
using namespace isect;
using bench::Numbers;
namespace convex_polygon_families = bench::convex_polygon_families;

namespace {

template <class S>
ConvexPolygon<S> convex(std::initializer_list<std::array<double, 2>> vertices) {
  Ring<S, 2> r;
  for (const auto& [x, y] : vertices) r.push_back({static_cast<S>(x), static_cast<S>(y)});
  return *make_convex(r);
}
template <class S>
ConvexPolygon<S> box(double x0, double y0, double x1, double y1) {
  return convex<S>({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

/// Whether the witness holds in rationals.
template <class S>
bool separates(const ConvexPolygon<S>& of, int index, const ConvexPolygon<S>& other) {
  const std::size_t i = static_cast<std::size_t>(index);
  return std::all_of(other.vertices.begin(), other.vertices.end(), [&](const Point<S, 2>& p) {
    return oracle::area2(of.vertices[i], of.vertices[(i + 1) % of.vertices.size()], p) < 0;
  });
}

}  // namespace

TEMPLATE_TEST_CASE("squares lie in all six relations", "[convex_polygons]", float, double) {
  using S = TestType;
  const ConvexPolygon<S> a = box<S>(0, 0, 4, 4);
  CHECK(relate(a, box<S>(5, 0, 6, 4)) == Relation::disjoint);
  CHECK(relate(a, box<S>(4, 1, 6, 2)) == Relation::touching);
  CHECK(relate(a, box<S>(4, 4, 6, 6)) == Relation::touching);
  CHECK(relate(a, box<S>(3, 1, 6, 2)) == Relation::overlapping);
  CHECK(relate(a, box<S>(1, 1, 2, 2)) == Relation::b_inside_a);
  CHECK(relate(a, box<S>(0, 1, 4, 2)) == Relation::b_inside_a);
  CHECK(relate(box<S>(1, 1, 2, 4), a) == Relation::a_inside_b);
  CHECK(relate(a, convex<S>({{4, 4}, {0, 4}, {0, 0}, {4, 0}})) == Relation::equal);
  CHECK(relate(a, box<S>(1, -1, 2, 5)) == Relation::overlapping);  // a cross: no vertex inside the other
  CHECK_FALSE(intersects(a, box<S>(5, 0, 6, 4)));
  CHECK(intersects(a, box<S>(4, 4, 6, 6)));
  CHECK(intersects(a, box<S>(1, 1, 2, 2)));
}

TEMPLATE_TEST_CASE("the separating edge may belong to either", "[convex_polygons]", float, double) {
  using S = TestType;
  using convex_polygons::Edge;
  const ConvexPolygon<S> a = box<S>(0, 0, 4, 4),
                         b = convex<S>({{4, 5}, {5, 4}, {9, 9}});  // x + y >= 9 cuts the corner off
  CHECK(separating_edge(a, b) == Edge{true, 0});
  CHECK(separating_edge(b, a) == Edge{false, 0});
  CHECK(separating_edge(a, box<S>(5, 0, 6, 4)) == Edge{false, 1});
  CHECK_FALSE(separating_edge(a, a));
}

TEMPLATE_TEST_CASE("two polygons: an ulp decides between apart, touching and overlapping", "[convex_polygons]", float,
                   double) {
  using S = TestType;
  const ConvexPolygon<S> a = box<S>(0, 0, 1, 1);
  const auto with_left = [&](S x) { return relate(a, box<S>(x, 0.25, 3, 0.5)); };
  CHECK(with_left(std::nextafter(S(1), S(2))) == Relation::disjoint);
  CHECK(with_left(S(1)) == Relation::touching);
  CHECK(with_left(std::nextafter(S(1), S(0))) == Relation::overlapping);
}

TEMPLATE_TEST_CASE("the largest and the least are as good as others", "[convex_polygons]", float, double) {
  using S = TestType;
  for (const S k : {std::numeric_limits<S>::max(), std::numeric_limits<S>::denorm_min()}) {
    const ConvexPolygon<S> a = *make_convex(Ring<S, 2>{{0, 0}, {k, 0}, {0, k}}),
                           b = *make_convex(Ring<S, 2>{{k, 0}, {k, k}, {0, k}});
    CHECK(relate(a, b) == Relation::touching);
    CHECK(relate(a, a) == Relation::equal);
    CHECK(relate(a, *make_convex(Ring<S, 2>{{-k, -k}, {k, 0}, {0, k}})) == Relation::a_inside_b);
  }
}

TEMPLATE_TEST_CASE("relations agree with the common part in rationals", "[convex_polygons]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  int counts[6] = {}, all = 0;
  for (const Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(250, 30000); ++i) {
      INFO("seed " << tests::seed() << ", family " << static_cast<int>(numbers) << ", case " << i);
      const auto a = convex_polygon_families::of_any_numbers<S>(random, numbers, {});
      if (!a) continue;
      const auto b = convex_polygon_families::of_any_numbers<S>(random, numbers, a->vertices);
      if (!b) continue;
      const Relation relation = relate(*a, *b);
      REQUIRE(relation == oracle::relation(*a, *b));
      ++counts[static_cast<int>(relation)], ++all;

      Record<convex_polygons::Event> record;
      REQUIRE(relate(*a, *b, record) == relation);
      REQUIRE(relate(*b, *a) == reversed(relation));
      REQUIRE(intersects(*a, *b) == (relation != Relation::disjoint));
      const auto edge = separating_edge(*a, *b);
      REQUIRE(edge.has_value() == (relation == Relation::disjoint));
      if (edge) REQUIRE((edge->of_b ? separates(*b, edge->index, *a) : separates(*a, edge->index, *b)));

      ConvexPolygon<S> turned_a = *a, turned_b = *b;  // by a quarter, from another first vertex
      for (ConvexPolygon<S>* p : {&turned_a, &turned_b}) {
        for (Point<S, 2>& v : p->vertices) v = {-v[1], v[0]};
        std::rotate(p->vertices.begin(), p->vertices.begin() + 1, p->vertices.end());
      }
      REQUIRE(relate(turned_a, turned_b) == relation);
    }
  for (const int count : counts) CHECK(count > all / 200);
}

TEST_CASE("round polygons roll past each other", "[convex_polygons]") {
  Ring<double, 2> round;
  for (int k = 0; k < 1000; ++k)
    round.push_back({std::cos(k * 0.006283185307179587), std::sin(k * 0.006283185307179587)});
  const auto a = make_convex(round);
  REQUIRE(a);
  REQUIRE(a->vertices.size() == 1000);
  const auto moved_by = [&](double x, double y) {
    ConvexPolygon<double> b = *a;
    for (Point<double, 2>& v : b.vertices) v += Vector<double, 2>(x, y);
    return b;
  };
  CHECK(relate(*a, box<double>(1, -1, 3, 1)) == Relation::touching);
  CHECK(relate(*a, moved_by(1.5, 1.2)) == Relation::overlapping);
  CHECK(relate(*a, moved_by(1.5, 1.5)) == Relation::disjoint);
  ConvexPolygon<double> half = *a;
  for (Point<double, 2>& v : half.vertices) v /= 2;
  CHECK(relate(*a, half) == Relation::b_inside_a);
}

TEST_CASE("the events tell the farthest vertex of each edge", "[convex_polygons]") {
  using namespace convex_polygons;
  Record<Event> record;
  const ConvexPolygon<double> a = convex<double>({{0, 0}, {9, 1}, {3, 8}});
  CHECK(relate(a, convex<double>({{9, 2}, {12, 3}, {10, 7}}), record) == Relation::disjoint);
  REQUIRE(record.events.size() == 2);
  const Farthest below = std::get<Farthest>(record.events[0]), right = std::get<Farthest>(record.events[1]);
  CHECK(below.edge == Edge{false, 0});
  CHECK(below.vertex == 2);
  CHECK(below.side == 1);
  CHECK(right.edge == Edge{false, 1});
  CHECK(right.vertex == 0);
  CHECK(right.side == -1);

  record.events.clear();
  CHECK(relate(a, convex<double>({{3, 2}, {5, 3}, {4, 4}}), record) == Relation::b_inside_a);
  CHECK(record.events.size() == 7);
  CHECK(std::get<Contained>(record.events.back()).b_in_a);
}

TEST_CASE("two convex polygons take O(n + m), or with a logarithm, however they lie", "[convex_polygons]") {
  using Pair = std::pair<ConvexPolygon<double>, ConvexPolygon<double>>;
  const auto arc = [](int n, double x, double y, double turn) {  // on a parabola: vertices are what they seem
    ConvexPolygon<double> polygon;
    for (double k = 0; k < n; ++k) polygon.vertices.push_back({x + k, y + turn * k * (k - n)});
    if (turn < 0) std::reverse(polygon.vertices.begin(), polygon.vertices.end());
    return polygon;
  };
  const std::pair<std::string, std::function<Pair(int)>> families[] = {
      {"the same", [&](int n) { return Pair(arc(n, 0, 0, 1), arc(n, 0, 0, 1)); }},
      {"one above the other", [&](int n) { return Pair(arc(n, 0, 0, 1), arc(n, 0, 1, -1)); }},
      {"chord against chord", [&](int n) { return Pair(arc(n, 0, 0, 1), arc(n, 0, 0, -1)); }},
      {"one beside the other", [&](int n) { return Pair(arc(n, 0, 0, 1), arc(n, n, 0, 1)); }},
      {"bulge against bulge", [&](int n) { return Pair(arc(n, 0, 0, 1), arc(n, 0, -0.5 * n * n, -1)); }},
      {"moved a little", [&](int n) { return Pair(arc(n, 0, 0, 1), arc(n, 0.5, 0.5, 1)); }},
      {"a triangle within", [&](int n) {
         return Pair(arc(n, 0, 0, 1), convex<double>({{n / 2., -5}, {n / 2. + 1, -5}, {n / 2., -4}}));
       }}};
  for (const auto& [name, draw] : families) {
    const double yes_or_no = tests::growth(2000, draw, [](const Pair&p) { return intersects(p.first, p.second); }),
                 how = tests::growth(2000, draw, [](const Pair&p) { return relate(p.first, p.second); });
    INFO(name << ": n^" << yes_or_no << ", n^" << how);
    CHECK(yes_or_no < 1.5);
    CHECK(how < 1.5);
  }
}

}  // namespace convex_polygons_test
