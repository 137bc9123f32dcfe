// Two more forms of the crossings: right away from edges, and wrong next to them.

#include <isect/methods/point_polygon.h>

#include <isect/counted.h>
#include "bench/point_polygon/families.h"
#include "bench/point_polygon/oracle.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace point_polygon_methods_test {
using namespace isect;
using namespace isect::bench;
using point_polygon::crossings_multiplied;
using point_polygon::crossings_translated;

namespace {

/// Calls check(name, method) for both.
template <class Check>
void for_each_method(const Check& check) {
  check("multiplied", [](const auto& p, const auto& ring) { return crossings_multiplied(p, ring); });
  check("translated", [](const auto& p, const auto& ring) { return crossings_translated(p, ring); });
}

}  // namespace

TEMPLATE_TEST_CASE("both count crossings as the exact call does, away from edges", "[point_polygon_methods]", float,
                   double) {
  using S = TestType;
  for_each_method([](const char* name, const auto& method) {
    INFO(name);
    const Ring<S, 2> diamond = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    CHECK(method(Point<S, 2>(0, 0), diamond));  // a vertex on the ray counts once
    CHECK_FALSE(method(Point<S, 2>(-2, 0), diamond));
    CHECK_FALSE(method(Point<S, 2>(-2, 1), diamond));
    CHECK_FALSE(method(Point<S, 2>(0, 0), Ring<S, 2>{}));
    for (const char* drawn : {"ordinary", "bow-tie"}) {
      const PolygonFamily<S> family = polygon_family<S>(drawn, 20);
      Random random(stream(tests::seed(), drawn));
      for (int i = 0; i < 2000; ++i) {
        const Ring<S, 2>& ring = *family.draw(random).ring;
        const Point<S, 2> p = random.in_box<2>(1).template cast<S>();
        REQUIRE(method(p, ring) == (locate(p, ring) == Location::in));
      }
    }
  });
}

TEMPLATE_TEST_CASE("both are wrong within 2 ulp of an edge", "[point_polygon_methods][failure]", float, double) {
  using S = TestType;
  for_each_method([](const char* name, const auto& method) {
    INFO(name);
    const PolygonFamily<S> family = polygon_family<S>("near-edge", 10);
    Random random(stream(tests::seed(), name));
    int wrong = 0;
    for (int i = 0; i < 5000; ++i) {
      const PolygonCase<S> c = family.draw(random);
      const Location truth = locate(c.point, *c.ring);
      wrong += truth != Location::on && method(c.point, *c.ring) != (truth == Location::in);
    }
    CHECK(wrong > 20);
  });
}

TEST_CASE("moving the polygon to the point loses what even an exact sign can't bring back",
          "[point_polygon_methods][failure]") {
  const Point<double, 2> a = {0, 172}, b = {100, 0}, p = {25.374625374625374, 128.35564435564436};
  CHECK(oracle::location(p, Ring<double, 2>{{0, 0}, a, b}) == Location::out);
  CHECK(orient2d(a, b, p) == 1);
  CHECK(orient2d(a - p, b - p, {0, 0}) != 1);
}

TEST_CASE("the forms cost and tell what they say", "[point_polygon_methods]") {
  using S = Counted<double>;
  const Ring<S, 2> square = {{S(0), S(0)}, {S(2), S(0)}, {S(2), S(2)}, {S(0), S(2)}};
  const Point<S, 2> p = {S(1), S(1)};
  tally() = {};
  CHECK(crossings_multiplied(p, square));
  CHECK((tally().div == 0 && tally().mul == 4));
  Record<point_polygon::FormEvent<S>> record;
  CHECK(crossings_multiplied(p, square, record));
  CHECK(record.events.size() == 6);

  tally() = {};
  record.events.clear();
  CHECK(crossings_translated(p, square, record));
  CHECK((tally().div == 0 && tally().add == 16));  // both ends on one side: no division
  CHECK(record.events.size() == 10);
  CHECK(std::get<point_polygon::SideKnown>(record.events[4]).holds);

  const Ring<S, 2> slope = {{S(0), S(0)}, {S(4), S(0)}, {S(0), S(3)}};
  tally() = {};
  CHECK(crossings_translated(p, slope));
  CHECK(tally().div == 1);
}

TEMPLATE_TEST_CASE("the exact call agrees with the oracle in every family", "[point_polygon_methods]", float, double) {
  using S = TestType;
  int counts[3] = {};
  for (const char* name :
       {"ordinary", "near-edge", "on-vertex", "horizontal", "degenerate", "bow-tie", "far 1e5", "far 1e8"}) {
    if (std::is_same_v<S, float> && name == std::string_view("far 1e8")) continue;
    const PolygonFamily<S> family = polygon_family<S>(name, 24);
    Random random(stream(tests::seed(), name));
    for (int i = tests::cases(1000, 100'000); i > 0; --i) {
      const PolygonCase<S> c = family.draw(random);
      const Location where = locate(c.point, *c.ring);
      INFO(name << ", ISECT_SEED=" << tests::seed() << ", " << c.point.transpose());
      REQUIRE(where == oracle::location(c.point, *c.ring));
      ++counts[static_cast<int>(where)];
    }
  }
  for (const int count : counts) CHECK(count > 100);
}

TEST_CASE("the closed rule counts a vertex on the ray twice, and is right where there is none",
          "[point_polygon_methods]") {
  using point_polygon::crossings_closed;
  const Point<double, 2> p = {-0.75, 0};
  const Ring<double, 2> through = {{-2, -1.5}, {0.75, -1.75}, {2.25, 0}, {0.5, 2}, {-1.5, 1.5}};
  CHECK(crossings_closed(p, through) == 2);
  CHECK(winding(p, through).crossings == 1);
  CHECK(crossings_closed<double>({-0.75, 0.25}, through) == 1);

  const Ring<double, 2> step = {{-2, -1.75}, {2.25, -1.75}, {2.25, 0}, {0.25, 0}, {-0.25, 2}, {-1.75, 1.75}};
  Record<point_polygon::ClosedEvent<double>> record;
  CHECK(crossings_closed<double>({-1.25, 0}, step, record) == 2);  // the edge along the ray is 0 / 0
  int not_a_number = 0;
  for (const auto& event : record.events)
    if (const auto* e = std::get_if<point_polygon::CrossesAt<double>>(&event)) not_a_number += std::isnan(e->x);
  CHECK(not_a_number == 1);
}

}  // namespace point_polygon_methods_test
