#include <isect/plane_cone.h>

#include <isect/methods/plane_cone.h>
#include "bench/plane_cylinder/families.h"
#include "bench/plane_cylinder/oracle.h"
#include "tests/catch.h"
#include "tests/core/plane_round_pairs.h"

namespace plane_cone_test {
using namespace isect;
using tests::plane_round_pairs::related;

TEMPLATE_TEST_CASE("a plane misses a cone, touches it, or cuts it, and an ulp decides", "[plane_cone]", float, double) {
  using S = TestType;
  const Cone<S> c = {{-3, 0, 0}, {3, 0, 0}, 5};
  const auto by = [&](S x, S y, S z, S d) { return related(Plane<S, 3>{{x, y, z}, d}, c); };
  const auto more = [](S x) { return std::nextafter(x, S(2) * x); };
  CHECK(by(1, 0, 0, -3) == Relation::touching);  // in the base
  CHECK(by(1, 0, 0, more(-3)) == Relation::disjoint);
  CHECK(by(1, 0, 0, std::nextafter(S(-3), S(0))) == Relation::overlapping);
  CHECK(by(1, 0, 0, 3) == Relation::touching);  // at the apex
  CHECK(by(1, 0, 0, more(3)) == Relation::disjoint);
  CHECK(by(-5, 6, 0, -15) == Relation::touching);  // along the side
  CHECK(by(-5, 6, 0, more(-15)) == Relation::disjoint);
  CHECK(by(-5, 6, 0, std::nextafter(S(-15), S(0))) == Relation::overlapping);
  CHECK(by(4, 3, 0, -27) == Relation::touching);  // at the rim
  CHECK(by(4, 3, 0, more(-27)) == Relation::disjoint);
  CHECK(by(4, 3, 0, 0) == Relation::overlapping);
  CHECK(side(Plane<S, 3>{{1, 0, 0}, 4}, c) == 1);
  CHECK(side(Plane<S, 3>{{1, 0, 0}, -4}, c) == -1);
}

TEMPLATE_TEST_CASE("plane and cone: without a radius, a normal, an axis or a number", "[plane_cone]", float, double) {
  using S = TestType;
  const Cone<S> thin = {{-3, 0, 0}, {3, 0, 0}, 0}, c = {{-3, 0, 0}, {3, 0, 0}, 5};
  CHECK(related(Plane<S, 3>{{0, 1, 0}, 0}, thin) == Relation::touching);
  CHECK(related(Plane<S, 3>{{1, 1, 0}, -3}, thin) == Relation::touching);
  CHECK(related(Plane<S, 3>{{1, 1, 0}, -1}, thin) == Relation::overlapping);
  const auto nothing = [](const Plane<S, 3>& plane, const Cone<S>& cone) {
    CHECK(related(plane, cone) == Relation::disjoint);
    CHECK(side(plane, cone) == 0);
  };
  nothing({{0, 0, 0}, 1}, c);
  nothing({{1, 0, 0}, 0}, {{1, 0, 0}, {1, 0, 0}, 5});
  nothing({{1, 0, 0}, 0}, {{-3, 0, 0}, {3, 0, 0}, -1});
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    nothing({{1, S(bad), 0}, 0}, c);
    nothing({{1, 0, 0}, S(bad)}, c);
    nothing({{1, 0, 0}, 0}, {{-3, 0, 0}, {3, 0, 0}, S(bad)});
  }
}

TEST_CASE("plane and cone: the events tell the signs of the lowest and the highest point", "[plane_cone]") {
  Record<plane_cone::Event> record;
  relate(Plane<double, 3>{{1, 0, 0}, -3}, Cone<double>{{-3, 0, 0}, {3, 0, 0}, 5}, record);
  const auto& signs = std::get<plane_cone::Decision>(record.events.back());
  CHECK((signs.lowest == -1 && signs.highest == 0));
}

TEMPLATE_TEST_CASE("plane and cone: verdicts are those of rational arithmetic", "[plane_cone]", float, double) {
  tests::plane_round_pairs::check<TestType, Cone, plane_cone::Event>(bench::plane_cone_draws<TestType>);
}

TEMPLATE_TEST_CASE("the heights of a cone are right where rounding does not decide", "[plane_cone]", float, double) {
  tests::plane_round_pairs::check_method<TestType, Cone>(
      [](const auto& plane, const auto& solid) { return plane_cone::by_heights(plane, solid); });
  Record<plane_cone::HeightsEvent<double>> record;
  CHECK(plane_cone::by_heights<double>({{0, 3, 4}, 1}, {{-3, 0, 0}, {3, 0, 0}, 5}, record));
  CHECK(std::get<plane_cone::Heights<double>>(record.events.at(0)).reach == 25);
}

}  // namespace plane_cone_test
