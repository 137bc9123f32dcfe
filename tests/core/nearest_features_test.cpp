#include <isect/nearest_features.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/random.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/nearest_pairs.h"
#include "tests/settings.h"

namespace nearest_features_test {
using namespace isect;
using namespace isect::nearest_features;
using oracle::Rational;
using tests::inf;
using tests::not_a_number;
using tests::pairs_in_rationals;
using tests::stretch;
using tests::whole_segment;

namespace {

using Segment3 = Segment<double, 3>;
using Capsule3 = Capsule<double, 3>;

bool same(const std::vector<Pair>& x, const std::vector<Pair>& y) {
  return x.size() == y.size() && std::is_permutation(x.begin(), x.end(), y.begin());
}
Segment3 scaled(const Segment3& x, double by) { return {x.p * by, x.q * by}; }

}  // namespace

TEST_CASE("two segments: the nearest pairs of features are those of rationals, ties included", "[nearest_features]") {
  bench::Random random(tests::seed());
  int ties = 0, interiors = 0, ends = 0, meet = 0;
  for (int i = 0; i < tests::cases(3000, 100000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const Segment3 a = whole_segment(random), b = whole_segment(random);
    const std::vector<Pair> found = nearest_pairs(a, b);
    REQUIRE(same(found, pairs_in_rationals(stretch(a), stretch(b))));
    for (const double by : {0x1p-1000, 0x1p1000}) REQUIRE(found == nearest_pairs(scaled(a, by), scaled(b, by)));
    ties += found.size() == 2;
    interiors += found.front() == Pair{Nearest::between, Nearest::between};
    ends += found.front().on_a != Nearest::between && found.front().on_b != Nearest::between;
    const Rational truth = oracle::distance2<3>(stretch(a), stretch(b));
    CHECK(oracle::ulps(rounded_distance2(a, b), truth) <= 0.5);
    meet += truth == 0;
  }
  for (const int seen : {ties, interiors, ends, meet}) CHECK(seen > 0);
}

TEST_CASE("two segments: one that is a point has one end, and both may be one point", "[nearest_features]") {
  const Segment3 point = {{1, 2, 0}, {1, 2, 0}}, along = {{0, 0, 0}, {4, 0, 0}};
  CHECK(nearest_pairs(point, along) == std::vector<Pair>{{Nearest::p, Nearest::between}});
  CHECK(nearest_pairs(along, point) == std::vector<Pair>{{Nearest::between, Nearest::p}});
  CHECK(nearest_pairs(point, point) == std::vector<Pair>{{Nearest::p, Nearest::p}});
  CHECK(rounded_distance2(point, along) == 4);
  CHECK(rounded_distance2(point, point) == 0);
}

TEST_CASE("two segments: a square beyond the largest double is infinite, one below the least is 0",
          "[nearest_features]") {
  const Segment3 a = {{0, 0, 0}, {4, 0, 0}}, b = {{1, 3, 0}, {2, 3, 0}};
  CHECK(rounded_distance2(scaled(a, 0x1p1000), scaled(b, 0x1p1000)) == inf);
  CHECK(rounded_distance2(scaled(a, 0x1p-1000), scaled(b, 0x1p-1000)) == 0);
  CHECK(rounded_distance2(scaled(a, 0x1p500), scaled(b, 0x1p500)) == 9 * 0x1p1000);
}

TEST_CASE("two capsules: the sign of the distance less a clearance is that of rationals", "[nearest_features]") {
  bench::Random random(tests::seed());
  int at_bound = 0, below = 0;
  for (int i = 0; i < tests::cases(3000, 100000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const Segment3 x = whole_segment(random), y = whole_segment(random);
    const Capsule3 a = {x.p, x.q, double(random.integer(0, 2))}, b = {y.p, y.q, double(random.integer(0, 2))};
    const double clearance = random.integer(-4, 3);
    const Rational bound = Rational(a.radius) + Rational(b.radius) + Rational(clearance);
    const int truth = bound < 0 ? 1 : oracle::sign(oracle::distance2<3>(stretch(x), stretch(y)) - bound * bound);
    REQUIRE(order(a, b, clearance) == truth);
    CHECK(intersects(a, b) == (order(a, b, 0) <= 0));
    at_bound += truth == 0, below += bound < 0;
  }
  for (const int seen : {at_bound, below}) CHECK(seen > 0);
}

TEST_CASE("what is not finite has no nearest features, and it and an empty capsule are farther than any clearance",
          "[nearest_features]") {
  const Segment3 good = {{0, 0, 0}, {1, 0, 0}};
  for (const double bad : {not_a_number, inf}) {
    const Segment3 x = {{bad, 0, 0}, {1, 1, 1}};
    CHECK(nearest_pairs(x, good).empty());
    CHECK(nearest_pairs(good, x).empty());
    CHECK(std::isnan(rounded_distance2(x, good)));
    CHECK(order({x.p, x.q, 1}, {good.p, good.q, 1}, 1) == 1);
    CHECK(order({good.p, good.q, bad}, {good.p, good.q, 1}, 1) == 1);
    CHECK(order({good.p, good.q, 1}, {good.p, good.q, 1}, bad) == 1);
  }
  CHECK(order({good.p, good.q, -1}, {good.p, good.q, 2}, 5) == 1);
  CHECK(order({good.p, good.q, 0}, {good.p, good.q, 0}, 0) == 0);
}

}  // namespace nearest_features_test
