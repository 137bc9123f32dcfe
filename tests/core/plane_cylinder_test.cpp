#include <isect/plane_cylinder.h>

#include <isect/methods/plane_cylinder.h>
#include "bench/plane_cylinder/families.h"
#include "bench/plane_cylinder/oracle.h"
#include "tests/catch.h"
#include "tests/core/plane_round_pairs.h"

namespace plane_cylinder_test {
using namespace isect;
using tests::plane_round_pairs::related;

TEMPLATE_TEST_CASE("a plane misses a cylinder, touches it, or cuts it, and an ulp decides", "[plane_cylinder]", float,
                   double) {
  using S = TestType;
  const Cylinder<S> c = {{-3, 0, 0}, {3, 0, 0}, 5};
  const auto by = [&](S x, S y, S z, S d) { return related(Plane<S, 3>{{x, y, z}, d}, c); };
  const auto more = [](S x) { return std::nextafter(x, S(2) * x); };
  CHECK(by(1, 0, 0, -3) == Relation::touching);  // in an end
  CHECK(by(1, 0, 0, more(-3)) == Relation::disjoint);
  CHECK(by(1, 0, 0, std::nextafter(S(-3), S(0))) == Relation::overlapping);
  CHECK(by(0, 3, 4, -25) == Relation::touching);  // along the side
  CHECK(by(0, 3, 4, more(-25)) == Relation::disjoint);
  CHECK(by(0, 3, 4, std::nextafter(S(-25), S(0))) == Relation::overlapping);
  CHECK(by(4, 3, 0, -27) == Relation::touching);  // at the rim
  CHECK(by(4, 3, 0, more(-27)) == Relation::disjoint);
  CHECK(by(4, 3, 0, 0) == Relation::overlapping);
  CHECK(side(Plane<S, 3>{{1, 0, 0}, 4}, c) == 1);
  CHECK(side(Plane<S, 3>{{1, 0, 0}, -4}, c) == -1);
}

TEMPLATE_TEST_CASE("plane and cylinder: without a radius, a normal, an axis or a number", "[plane_cylinder]", float,
                   double) {
  using S = TestType;
  const Cylinder<S> thin = {{-3, 0, 0}, {3, 0, 0}, 0}, c = {{-3, 0, 0}, {3, 0, 0}, 5};
  CHECK(related(Plane<S, 3>{{0, 1, 0}, 0}, thin) == Relation::touching);
  CHECK(related(Plane<S, 3>{{1, 1, 0}, -3}, thin) == Relation::touching);
  CHECK(related(Plane<S, 3>{{1, 1, 0}, -1}, thin) == Relation::overlapping);
  const auto nothing = [](const Plane<S, 3>& plane, const Cylinder<S>& cylinder) {
    CHECK(related(plane, cylinder) == Relation::disjoint);
    CHECK(side(plane, cylinder) == 0);
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

TEST_CASE("plane and cylinder: the events tell the signs of the lowest and the highest point", "[plane_cylinder]") {
  Record<plane_cylinder::Event> record;
  relate(Plane<double, 3>{{1, 0, 0}, -3}, Cylinder<double>{{-3, 0, 0}, {3, 0, 0}, 5}, record);
  const auto& signs = std::get<plane_cylinder::Decision>(record.events.back());
  CHECK((signs.lowest == -1 && signs.highest == 0));
}

TEMPLATE_TEST_CASE("plane and cylinder: verdicts are those of rational arithmetic", "[plane_cylinder]", float, double) {
  tests::plane_round_pairs::check<TestType, Cylinder, plane_cylinder::Event>(bench::plane_cylinder_draws<TestType>);
}

TEMPLATE_TEST_CASE("the heights of a cylinder are right where rounding does not decide", "[plane_cylinder]", float,
                   double) {
  tests::plane_round_pairs::check_method<TestType, Cylinder>(
      [](const auto& plane, const auto& solid) { return plane_cylinder::by_heights(plane, solid); });
  Record<plane_cylinder::HeightsEvent<double>> record;
  CHECK(plane_cylinder::by_heights<double>({{0, 3, 4}, 1}, {{-3, 0, 0}, {3, 0, 0}, 5}, record));
  CHECK(std::get<plane_cylinder::Heights<double>>(record.events.at(0)).reach == 25);
}

}  // namespace plane_cylinder_test
