// Orientations against rational arithmetic, over every hard family.

#include <isect/orient.h>

#include "bench/orient2d/families.h"
#include "bench/orient2d/oracle.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace orient_test {
using namespace isect;
using namespace isect::bench;

TEMPLATE_TEST_CASE("three points turn as rationals say, in every family", "[orient]", float, double) {
  using S = TestType;
  for (const NamedDraw<OrientCase<S>>& family : orient2d_draws<S>) {
    Random random(stream(tests::seed(), family.name));
    int counts[3] = {};
    for (int i = tests::cases(3000, 300'000); i > 0; --i) {
      const OrientCase<S> t = family.draw(random);
      const auto at = [](const Point<S, 2>& p) { return Point<double, 2>(p.template cast<double>()); };
      const int turn = orient2d(at(t.a), at(t.b), at(t.c));
      INFO(family.name << ", ISECT_SEED=" << tests::seed());
      REQUIRE(turn == oracle::orientation(t.a, t.b, t.c));
      REQUIRE(orient2d(at(t.b), at(t.c), at(t.a)) == turn);
      REQUIRE(orient2d(at(t.b), at(t.a), at(t.c)) == -turn);
      ++counts[turn + 1];
    }
    CHECK(std::min(counts[0], counts[2]) > 100);
  }
}

TEST_CASE("four points turn as rationals say", "[orient]") {
  using oracle::operator-;
  Random random(stream(tests::seed(), "orient3d"));
  const auto corner = [&](Numbers numbers) { return vector<double, 3>(random, numbers); };
  int counts[3] = {};
  for (const Numbers numbers : all_numbers)
    for (int i = tests::cases(2000, 50'000); i > 0; --i) {
      const Point<double, 3> a = corner(numbers), b = corner(numbers), c = corner(numbers), d = corner(numbers);
      const auto o = oracle::rational(a);
      const int truth = -oracle::sign(
          oracle::dot(oracle::cross(oracle::rational(b) - o, oracle::rational(c) - o), oracle::rational(d) - o));
      REQUIRE(orient3d(a, b, c, d) == truth);
      REQUIRE(orient3d(b, a, c, d) == -truth);
      ++counts[truth + 1];
    }
  for (const int count : counts) CHECK(count > 100);
  CHECK(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}) == 1);
}

}  // namespace orient_test
