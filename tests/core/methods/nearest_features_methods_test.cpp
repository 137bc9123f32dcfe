#include <isect/methods/nearest_features.h>

#include <cmath>

#include "bench/random.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/nearest_pairs.h"
#include "tests/settings.h"

namespace nearest_features_methods_test {
using namespace isect;
using namespace isect::nearest_features;
using oracle::Rational;
using tests::not_a_number;
using tests::stretch;
using tests::Stretch3;
using tests::whole_point;
using tests::whole_segment;

namespace {

using Segment3 = Segment<double, 3>;
using Capsule3 = Capsule<double, 3>;
using Box3 = Aabb<double, 3>;

}  // namespace

TEST_CASE("two segments: the distance in doubles is that of rationals but for rounding", "[nearest_features_methods]") {
  bench::Random random(tests::seed());
  int too_large = 0;
  for (int i = 0; i < tests::cases(3000, 100000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const Segment3 a = whole_segment(random), b = whole_segment(random);
    const double truth = oracle::real(oracle::distance2<3>(stretch(a), stretch(b))).nearest;
    CHECK(distance2(a, b) == Approx(truth).margin(1e-12));
    const double once = distance2_clamped_once(a, b);
    CHECK(once >= truth - 1e-12);
    too_large += once > truth + 1e-6;
    const Point<double, 3> c = whole_point(random);
    const Stretch3 at = {oracle::rational(c), oracle::rational(Vector<double, 3>(0, 0, 0))};
    CHECK(distance2(c, a) == Approx(oracle::real(oracle::distance2<3>(at, stretch(a))).nearest).margin(1e-12));
  }
  CHECK(too_large > 0);
}

TEST_CASE("two segments: clamping each place once misses the nearest points", "[nearest_features_methods]") {
  const Segment3 a = {{-2, 0, 0}, {0, 0, 0}}, b = {{1, 1, 0}, {5, 5, 0}};
  CHECK(distance2(a, b) == 2);
  const Segment3 along = {{0, 0, 0}, {4, 0, 0}}, above = {{6, 4, 0}, {5, 1, 0}};
  CHECK(distance2(along, above) == 2);
  CHECK(distance2_clamped_once(along, above) == 2);
  const Segment3 tilted = {{6, 1, 0}, {2, 5, 0}};
  CHECK(distance2(along, tilted) < distance2_clamped_once(along, tilted));
}

TEST_CASE("two segments: the method tells the lines, the places and the points", "[nearest_features_methods]") {
  Record<SegmentEvent<double, 3>> record;
  distance2<double, 3>(Segment3{{-3, 0, 0}, {3, 0, 0}}, Segment3{{0, -2, 5}, {0, 2, 5}}, record);
  REQUIRE(record.events.size() == 4);
  CHECK(std::get<Lines<double>>(record.events[0]).determinant == 36 * 16);
  const auto& on_a = std::get<Found<double>>(record.events[1]);
  CHECK((on_a.what == Find::on_a && on_a.clamped == 0.5 && on_a.denominator == 36 * 16));
  CHECK(std::get<Found<double>>(record.events[2]).clamped == 0.5);
  CHECK(std::get<Closest<double, 3>>(record.events[3]).distance2 == 25);

  record.events.clear();
  distance2<double, 3>(Segment3{{0, 0, 0}, {4, 0, 0}}, Segment3{{1, 2, 0}, {9, 2, 0}}, record);
  REQUIRE(record.events.size() == 4);
  CHECK(std::get<Lines<double>>(record.events[0]).parallel);
  CHECK(std::get<Found<double>>(record.events[2]).what == Find::again_on_a);
}

TEST_CASE("two boxes: the squared distance is the sum of the squared gaps", "[nearest_features_methods]") {
  const Box3 a = {{0, 0, 0}, {1, 1, 1}};
  CHECK(distance2(a, Box3{{4, 0, 0}, {5, 1, 1}}) == 9);
  CHECK(distance2(a, Box3{{4, 5, 0}, {5, 6, 1}}) == 25);
  CHECK(distance2(a, Box3{{-3, -4, -7}, {-2, -3, -6}}) == 4 + 9 + 36);
  CHECK(distance2(a, Box3{{1, 1, 1}, {2, 2, 2}}) == 0);
  CHECK(distance2(a, Box3{{0.5, 0.5, 0.5}, {2, 2, 2}}) == 0);
  Record<BoxEvent<double>> record;
  distance2<double, 3>(a, Box3{{4, 0, -3}, {5, 1, -1}}, record);
  REQUIRE(record.events.size() == 3);
  const auto& z = std::get<Gap<double>>(record.events[2]);
  CHECK((z.axis == 2 && z.gap == 1 && z.distance2 == 10));
}

TEST_CASE("two capsules: within a clearance but for rounding, and a bound below 0 is no",
          "[nearest_features_methods]") {
  bench::Random random(tests::seed());
  int misled = 0;
  for (int i = 0; i < tests::cases(3000, 100000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const Segment3 x = whole_segment(random), y = whole_segment(random);
    const Capsule3 a = {x.p, x.q, double(random.integer(0, 2))}, b = {y.p, y.q, double(random.integer(0, 2))};
    const double clearance = random.integer(-4, 3), bound = a.radius + b.radius + clearance;
    const Rational excess = oracle::distance2<3>(stretch(x), stretch(y)) - Rational(bound * bound);
    if (abs(excess) > 1e-9 || bound < 0) CHECK(within(a, b, clearance) == (bound >= 0 && excess < 0));
    misled += bound < 0 && within_by_squares(a, b, clearance);
  }
  CHECK(misled > 0);
}

TEST_CASE("NaN is in no distance's way", "[nearest_features_methods]") {
  const Segment3 bad = {{not_a_number, 0, 0}, {1, 1, 1}}, good = {{0, 0, 0}, {1, 0, 0}};
  CHECK(std::isnan(distance2(bad, good)));
  CHECK_FALSE(within(Capsule3{bad.p, bad.q, 1}, Capsule3{good.p, good.q, 1}, 1.0));
}

}  // namespace nearest_features_methods_test
