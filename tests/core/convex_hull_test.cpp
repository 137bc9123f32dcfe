// Hulls by name, by property, and against gift wrapping in rationals.

#include <isect/convex_hull.h>

#include <limits>
#include <string>

#include "tests/catch.h"
#include "tests/core/clouds.h"
#include "tests/core/hull_oracle.h"
#include "tests/settings.h"

namespace convex_hull_test {
using namespace isect;
using bench::Numbers;
using namespace tests::clouds;

namespace {

template <class S>
Ring<S, 2> points(std::initializer_list<std::array<double, 2>> coordinates) {
  Ring<S, 2> r;
  for (const auto& [x, y] : coordinates) r.push_back({static_cast<S>(x), static_cast<S>(y)});
  return r;
}

}  // namespace

TEMPLATE_TEST_CASE("the hull holds strict vertices, counter-clockwise from the lowest x", "[convex_hull]", float,
                   double) {
  using S = TestType;
  CHECK(convex_hull(points<S>({{2, 2}, {0, 0}, {1, 1}, {2, 0}, {0, 2}, {1, 0}, {2, 1}, {2, 2}})) ==
        points<S>({{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
  CHECK(convex_hull(points<S>({{0, 1}, {-1, 0}, {0, -1}, {1, 0}})) == points<S>({{-1, 0}, {0, -1}, {1, 0}, {0, 1}}));
  CHECK(convex_hull(points<S>({{0, 0}, {3, 3}, {3, 4}})) == points<S>({{0, 0}, {3, 3}, {3, 4}}));
}

TEMPLATE_TEST_CASE("points without area give two, one or no vertices", "[convex_hull]", float, double) {
  using S = TestType;
  CHECK(convex_hull(Ring<S, 2>{}).empty());
  CHECK(convex_hull(points<S>({{1, 2}})) == points<S>({{1, 2}}));
  CHECK(convex_hull(points<S>({{1, 2}, {1, 2}, {1, 2}})) == points<S>({{1, 2}}));
  CHECK(convex_hull(points<S>({{1, 2}, {0, 0}})) == points<S>({{0, 0}, {1, 2}}));
  CHECK(convex_hull(points<S>({{2, 2}, {0, 0}, {3, 3}, {1, 1}, {3, 3}})) == points<S>({{0, 0}, {3, 3}}));
  CHECK(convex_hull(points<S>({{1, 5}, {1, -5}, {1, 0}})) == points<S>({{1, -5}, {1, 5}}));
  CHECK(convex_hull(points<S>({{0.0, -0.0}, {-0.0, 0.0}})).size() == 1);
}

TEMPLATE_TEST_CASE("an ulp makes a vertex", "[convex_hull]", float, double) {
  using S = TestType;
  const S below = std::nextafter(S(1), S(0)), above = std::nextafter(S(1), S(2));
  CHECK(convex_hull(points<S>({{0, 0}, {1, 1}, {3, 3}, {0, 3}})).size() == 3);
  CHECK(convex_hull(points<S>({{0, 0}, {1, below}, {3, 3}, {0, 3}})).size() == 4);
  CHECK(convex_hull(points<S>({{0, 0}, {1, above}, {3, 3}, {0, 3}})).size() == 3);
  const S most = std::numeric_limits<S>::max(), least = std::numeric_limits<S>::denorm_min();
  for (const S k : {most, least}) CHECK(convex_hull(Ring<S, 2>{{-k, 0}, {k, 0}, {0, k}, {0, -k}, {0, 0}}).size() == 4);
}

TEMPLATE_TEST_CASE("a NaN or infinite coordinate is refused by its number", "[convex_hull]", float, double) {
  using S = TestType;
  for (const S bad : {std::numeric_limits<S>::quiet_NaN(), std::numeric_limits<S>::infinity()}) {
    Ring<S, 2> r = points<S>({{0, 0}, {1, 0}, {0, 1}});
    r[2][1] = bad;
    CHECK_THROWS_WITH(convex_hull(r), isect::test::Contains("point 2"));
    CHECK_THROWS_WITH(convex_hull_2d::monotone_chain(r), isect::test::Contains("point 2"));
  }
}

TEMPLATE_TEST_CASE("hulls agree with gift wrapping in rationals", "[convex_hull]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  int sizes[5] = {};
  for (const Numbers numbers : bench::all_numbers)
    for (const Cloud kind : {Cloud::family, Cloud::line, Cloud::near_line, Cloud::circle, Cloud::cluster})
      for (int i = 0; i < tests::cases(40, 4000); ++i) {
        INFO("seed " << tests::seed() << ", family " << static_cast<int>(numbers) << ", cloud "
                     << static_cast<int>(kind) << ", case " << i);
        const int n = random.one_in(10) ? random.below(30) : random.below(9);
        Ring<S, 2> cloud_points = cloud<S>(random, kind, numbers, n);
        const Ring<S, 2> hull = convex_hull(cloud_points);
        REQUIRE(hull == oracle::hull(cloud_points));
        ++sizes[std::min<std::size_t>(hull.size(), 4)];
        if (hull.size() > 2) REQUIRE(make_convex(hull)->vertices.size() == hull.size());

        for (std::size_t k = cloud_points.size(); k > 1; --k)
          std::swap(cloud_points[k - 1], cloud_points[random.below(static_cast<int>(k))]);
        Record<convex_hull_2d::Event<S>> record;
        REQUIRE(convex_hull(cloud_points, record) == hull);

        for (Point<S, 2>& p : cloud_points) p = {-p[1], p[0]};
        REQUIRE(convex_hull(cloud_points).size() == hull.size());
      }
  for (const int count : sizes) CHECK(count > 0);
  CHECK(sizes[4] > sizes[0]);
}

TEMPLATE_TEST_CASE("discarding points of the interior does not change the hull", "[convex_hull]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  for (const Numbers numbers : bench::all_numbers)
    for (const Cloud kind : {Cloud::family, Cloud::line, Cloud::near_line, Cloud::circle, Cloud::cluster})
      for (int i = 0; i < tests::cases(1, 15); ++i) {
        if (!tests::long_run() && random.one_in(2)) continue;
        INFO("seed " << tests::seed() << ", family " << static_cast<int>(numbers) << ", cloud "
                     << static_cast<int>(kind) << ", case " << i);
        const Ring<S, 2> many = cloud<S>(random, kind, numbers, 10000);
        const Ring<S, 2> hull = convex_hull(many);
        REQUIRE(hull == convex_hull_2d::monotone_chain(many));
        if (i == 0 && hull.size() > 2)
          REQUIRE(std::none_of(many.begin(), many.end(), [&](const Point<S, 2>& p) {
            return locate(p, ConvexPolygon<S>{hull}) == Location::out;
          }));
      }
  Ring<S, 2> square;
  for (int i = 0; i < 10000; ++i) square.push_back(random.in_box<2>(1).cast<S>());
  CHECK(convex_hull_2d::detail::without_interior(std::span<const Point<S, 2>>(square)).size() < 1500);
  square[9999] = {S(3), S(0)};  // outside all columns
  CHECK(convex_hull(square) == convex_hull_2d::monotone_chain(square));
}

TEMPLATE_TEST_CASE("points are sorted wherever they lie", "[convex_hull]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  const S most = std::numeric_limits<S>::max();
  for (const std::size_t count : {0, 1, 7, 4095, 4096, 9000})
    for (int kind = 0; kind < 5; ++kind) {
      Ring<S, 2> points;
      while (points.size() < count) {
        Point<S, 2> p = random.in_box<2>(1).template cast<S>();
        if (kind == 1) p[0] = S(3);                                               // one column
        if (kind == 2 && !random.one_in(100)) p *= S(1e-6);                       // nearly all in one
        if (kind == 3) p = {S(random.integer(-5, 5)), S(random.integer(-5, 5))};  // repeated
        if (kind == 4) p *= most;                                                 // the extent overflows
        points.push_back(p);
      }
      Ring<S, 2> sorted = points;
      sort_points(points);
      std::sort(sorted.begin(), sorted.end(), before<S>);
      REQUIRE(points == sorted);
    }
}

TEST_CASE("a NaN or infinite coordinate among many points is refused by its number", "[convex_hull]") {
  bench::Random random(tests::seed());
  for (const std::size_t bad : {0, 20, 12345, 19999}) {
    Ring<double, 2> points;
    while (points.size() < 20000) points.push_back(random.in_box<2>(1));
    points[bad][1] = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH(convex_hull(points),
                      "convex_hull: point " + std::to_string(bad) + " has a NaN or infinite coordinate");
  }
}

TEST_CASE("the events tell each turn of the chain", "[convex_hull]") {
  using namespace convex_hull_2d;
  Record<Event<double>> record;
  convex_hull(points<double>({{0, 0}, {1, 1}, {2, 0}}), record);
  REQUIRE(record.events.size() == 8);
  CHECK(std::get<Remaining>(record.events[0]).count == 3);
  const auto removed = std::get<Removed<double>>(record.events[3]);
  CHECK(removed.p == Point<double, 2>(1, 1));
  CHECK(removed.next == Point<double, 2>(2, 0));
  CHECK(removed.turn == -1);
  CHECK(std::get<Added<double>>(record.events[4]).p == Point<double, 2>(2, 0));
}

TEMPLATE_TEST_CASE("the chain of n sorted points asks for fewer than 4 n turns", "[convex_hull]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  for (const std::size_t n : {1000, 10'000, 100'000})
    for (const int kind : {0, 1, 2}) {
      Ring<S, 2> given;
      while (given.size() < n) {
        const Point<double, 2> p = kind == 0 ? random.heading<2>() : random.in_box<2>(1);
        given.push_back(p.template cast<S>());
        if (kind == 2) given.back()[1] = given.back()[0] * given.back()[0];  // all of them vertices
      }
      Record<convex_hull_2d::Event<S>> record;
      convex_hull_2d::monotone_chain(given, record);
      std::size_t turns = 0;  // each either takes a point off the chain or lets one join it
      for (const auto& event : record.events) turns += !std::holds_alternative<Fallback>(event);
      INFO(n << " points, kind " << kind);
      CHECK(turns < 4 * n);
    }
}

}  // namespace convex_hull_test
