// Areas and normals by name, by property, and against Newell's sum in rationals.

#include <isect/polygon.h>

#include <Eigen/Geometry>

#include "tests/catch.h"
#include "tests/core/area_rings.h"
#include "tests/settings.h"

namespace polygon_test {
using namespace isect;
using bench::Numbers;
using oracle::Rational;
using namespace tests::area_rings;

namespace {

template <class S, int N>
Ring<S, N> ring(std::initializer_list<std::array<double, N>> vertices) {
  Ring<S, N> r;
  for (const auto& coordinates : vertices) {
    r.emplace_back();
    for (int k = 0; k < N; ++k) r.back()[k] = static_cast<S>(coordinates[k]);
  }
  return r;
}

}  // namespace

TEMPLATE_TEST_CASE("areas in the plane have the sign of the orientation", "[polygon]", float, double) {
  using S = TestType;
  const Ring<S, 2> square = ring<S, 2>({{1, 1}, {3, 1}, {3, 3}, {1, 3}});
  CHECK(area(square) == S(4));
  CHECK(area(Ring<S, 2>(square.rbegin(), square.rend())) == S(-4));
  CHECK(area(ring<S, 2>({{0, 0}, {2, 2}, {2, 0}, {0, 2}})) == S(0));
  CHECK(area(ring<S, 2>({{0, 0}, {1, 0}, {0, 1}, {0, 0}, {1, 0}, {0, 1}})) == S(1));
  CHECK(area(Ring<S, 2>{}) == S(0));
  CHECK(area(ring<S, 2>({{1, 1}})) == S(0));
  CHECK(area(ring<S, 2>({{1, 1}, {2, 5}})) == S(0));
  CHECK(std::isnan(area(ring<S, 2>({{1, 1}, {2, 5}, {std::nan(""), 0}}))));
}

TEMPLATE_TEST_CASE("normals obey the right hand", "[polygon]", float, double) {
  using S = TestType;
  const Ring<S, 3> square = ring<S, 3>({{1, 1, 5}, {3, 1, 5}, {3, 3, 5}, {1, 3, 5}});
  CHECK(normal(square) == Vector<S, 3>(0, 0, 1));
  CHECK(normal(Ring<S, 3>(square.rbegin(), square.rend())) == Vector<S, 3>(0, 0, -1));
  CHECK(area(square) == S(4));
  CHECK(normal(ring<S, 3>({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}})) == Vector<S, 3>(0, 0, 1));
  CHECK(normal(ring<S, 3>({{1, 1, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 0}, {2, 0, 0}})) == Vector<S, 3>(0, 0, 1));
}

TEMPLATE_TEST_CASE("no area, no normal", "[polygon]", float, double) {
  using S = TestType;
  for (const Ring<S, 3>& r :
       {Ring<S, 3>{}, ring<S, 3>({{1, 2, 3}}), ring<S, 3>({{1, 2, 3}, {3, 4, 5}}),
        ring<S, 3>({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}), ring<S, 3>({{0, 0, 1}, {2, 2, 1}, {2, 0, 1}, {0, 2, 1}}),
        ring<S, 3>({{.1, .2, .3}, {.1, .2, .3}, {.7, .8, .9}})}) {
    CHECK_FALSE(normal(r));
    CHECK(area(r) == S(0));
  }
  for (const double bad : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    CHECK_FALSE(normal(ring<S, 3>({{0, 0, 0}, {1, 0, 0}, {0, bad, 0}})));
    CHECK(std::isnan(area(ring<S, 3>({{0, 0, 0}, {1, 0, 0}, {0, bad, 0}}))));
  }
}

TEMPLATE_TEST_CASE("the least and the largest polygons have normals", "[polygon]", float, double) {
  using S = TestType;
  for (const S k : {std::numeric_limits<S>::denorm_min(), std::numeric_limits<S>::min(), std::numeric_limits<S>::max()})
    CHECK(normal(Ring<S, 3>{{0, 0, 0}, {k, 0, 0}, {0, k, 0}}) == Vector<S, 3>(0, 0, 1));
  CHECK(normal(ring<S, 3>({{0, 0, 0}, {1e-23, 0, 0}, {0, 1e-23, 0}})) == Vector<S, 3>(0, 0, 1));
  const S most = std::numeric_limits<S>::max();
  CHECK(area(Ring<S, 3>{{0, 0, 0}, {most, 0, 0}, {0, most, 0}}) == std::numeric_limits<S>::infinity());
  CHECK(area(Ring<S, 3>{{0, 0, 0}, {most, 0, 0}, {0, 2, 0}}) == most);
}

TEST_CASE("outlines at the end of the range keep their normal where a corner is given twice", "[polygon]") {
  using Ring3 = Ring<double, 3>;
  for (const double most : {1e308, std::numeric_limits<double>::max()}) {
    const Ring3 open = {{-most, 0, 0}, {most, 0, 0}, {most, 1, 0}};
    Ring3 closed = open, twice = open;
    closed.push_back(open[0]), twice.insert(twice.begin(), open[0]);
    for (const Ring3& r : {open, closed, twice}) {
      CHECK(normal(r) == Vector<double, 3>(0, 0, 1));
      CHECK(area(r) == most);
    }
  }
  const Ring3 slanted = {{-1e308, 1, 2}, {1e308, 0, 0}, {0, 1, 1}},
              twice = {slanted[0], slanted[0], slanted[1], slanted[2]};
  CHECK(normal(slanted) == Vector<double, 3>(1e-308, 0, 1));
  CHECK(normal(twice) == normal(slanted));
  CHECK(area(twice) == area(slanted));
}

TEST_CASE("a small tilted quad far away keeps its normal", "[polygon]") {
  const Ring<float, 3> quad = ring<float, 3>(
      {{10000, 10000, 10000}, {10000.1, 10000, 10000.05}, {10000.1, 10000.1, 10000.1}, {10000, 10000.1, 10000.05}});
  const auto n = normal(quad);
  REQUIRE(n);
  const auto exact = truth(quad);
  const Rational length = root(oracle::dot(exact, exact));
  for (int k = 0; k < 3; ++k) CHECK((*n)[k] == Approx(static_cast<double>(exact[k] / length)).margin(1e-7));
}

TEMPLATE_TEST_CASE("areas and normals agree with rationals", "[polygon]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  const Rational eps(std::numeric_limits<S>::epsilon());
  int none = 0, all = 0;
  Rational worst = 0;
  for (const Numbers numbers : bench::all_numbers_and_ends)
    for (int i = 0; i < tests::cases(800, 120000); ++i) {
      INFO("seed " << tests::seed() << ", family " << static_cast<int>(numbers) << ", case " << i);
      const Ring<S, 2> flat = random_ring<S, 2>(random, numbers);
      const Rational signed_area = truth(flat);
      REQUIRE(oracle::ulps(area(flat), signed_area) <= 2);
      if (abs(signed_area) > Rational(std::numeric_limits<S>::min())) REQUIRE((area(flat) > 0) == (signed_area > 0));

      const Ring<S, 3> r = random_ring<S, 3>(random, numbers);
      const std::array<Rational, 3> twice = truth(r);
      const Rational length = root(oracle::dot(twice, twice));
      const auto n = normal(r);
      Record<polygon_area::Event> record;
      REQUIRE(normal(r, record) == n);
      REQUIRE(n.has_value() == (length != 0));
      REQUIRE(oracle::ulps(area(r), Rational(length / 2)) <= 3);
      ++all;
      if (!n) {
        ++none;
        continue;
      }
      for (int k = 0; k < 3; ++k) {
        const Rational error = abs(Rational((*n)[k]) - twice[k] / length);
        if (error > worst) worst = error;
        REQUIRE(error <= eps);
      }
      // the same vertices the other way round, and in other octants
      const Vector<S, 3> back = *normal(Ring<S, 3>(r.rbegin(), r.rend()));
      REQUIRE((back + *n).cwiseAbs().maxCoeff() <= 2 * std::numeric_limits<S>::epsilon());
      Ring<S, 3> turned;
      for (const Point<S, 3>& p : r) turned.push_back({-p[1], p[0], p[2]});
      REQUIRE(normal(turned) == Vector<S, 3>(-(*n)[1], (*n)[0], (*n)[2]));
    }
  CHECK(none > all / 20);
  CHECK(none < all / 2);
  CHECK(worst > eps / 8);  // the bound is not too loose
}

TEST_CASE("the events tell the area vector, and the fallback before it", "[polygon]") {
  Record<polygon_area::Event> record;
  normal(ring<double, 3>({{0, 0, 0}, {2, 0, 0}, {0, 2, 1}}), record);
  REQUIRE(record.events.size() == 1);
  const auto n = std::get<polygon_area::AreaVector>(record.events[0]);
  CHECK(n.largest == 2);
  CHECK(n.scaled[1] == -0.5L);
  record.events.clear();
  normal(ring<double, 3>({{.1, .1, .1}, {.2, .2, .2}, {.3, .3, .3}}), record);
  CHECK(std::holds_alternative<Fallback>(record.events.front()));
}

}  // namespace polygon_test
