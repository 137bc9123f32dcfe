#include <isect/sphere_cylinder.h>

#include <isect/methods/sphere_cylinder.h>
#include "bench/sphere_cylinder/families.h"
#include "bench/sphere_cylinder/oracle.h"
#include "tests/catch.h"
#include "tests/core/sphere_round_pairs.h"

namespace sphere_cylinder_test {
using namespace isect;

TEMPLATE_TEST_CASE("a ball touches a cylinder at its side, an end or the rim, and an ulp decides", "[sphere_cylinder]",
                   float, double) {
  using S = TestType;
  const Cylinder<S> c = {{-3, 0, 0}, {3, 0, 0}, 5};
  const auto by = [&](S x, S y, S z, S s) {
    CHECK(relate(Sphere<S, 3>{{x, y, z}, std::nextafter(s, S(0))}, c) == Relation::disjoint);
    CHECK(relate(Sphere<S, 3>{{x, y, z}, std::nextafter(s, S(99))}, c) == Relation::overlapping);
    return relate(Sphere<S, 3>{{x, y, z}, s}, c);
  };
  CHECK(by(1, 6, 8, 5) == Relation::touching);    // beside the side
  CHECK(by(3, 6, 8, 5) == Relation::touching);    // where that ends
  CHECK(by(5, 3, 4, 2) == Relation::touching);    // beyond an end, over its rim
  CHECK(by(-7, 1, 1, 4) == Relation::touching);   // beyond an end
  CHECK(by(6, 0, 9, 5) == Relation::touching);    // by 3, 4 and 5 from the rim
  CHECK(by(-6, -9, 0, 5) == Relation::touching);  // and from the other
}

TEMPLATE_TEST_CASE("a ball lies in a cylinder, or the cylinder in a ball", "[sphere_cylinder]", float, double) {
  using S = TestType;
  const Cylinder<S> c = {{-3, 0, 0}, {3, 0, 0}, 4};
  const auto by = [&](S x, S y, S z, S s) { return relate(Sphere<S, 3>{{x, y, z}, s}, c); };
  const auto more = [](S x) { return std::nextafter(x, S(99)); };
  CHECK(by(0, 0, 0, 3) == Relation::a_inside_b);  // from end to end
  CHECK(by(0, 0, 0, more(3)) == Relation::overlapping);
  CHECK(by(0, 0, 3, 1) == Relation::a_inside_b);  // to the side
  CHECK(by(0, 0, 3, more(1)) == Relation::overlapping);
  CHECK(by(0, 0, 0, 5) == Relation::b_inside_a);  // to both rims, by 3, 4 and 5
  CHECK(by(0, 0, 0, std::nextafter(S(5), S(0))) == Relation::overlapping);
  CHECK(by(3, 0, 0, 0) == Relation::a_inside_b);  // a point of an end
  CHECK(by(more(3), 0, 0, 0) == Relation::disjoint);
  const Cylinder<S> thin = {{-3, 0, 0}, {3, 0, 0}, 0};
  CHECK(relate(Sphere<S, 3>{{0, 4, 0}, 5}, thin) == Relation::b_inside_a);
  CHECK(relate(Sphere<S, 3>{{0, 4, 0}, 4}, thin) == Relation::touching);
  CHECK(relate(Sphere<S, 3>{{1, 0, 0}, 0}, thin) == Relation::a_inside_b);
}

TEMPLATE_TEST_CASE("sphere and cylinder: what is empty, NaN or infinite meets nothing", "[sphere_cylinder]", float,
                   double) {
  using S = TestType;
  const Cylinder<S> c = {{-3, 0, 0}, {3, 0, 0}, 5};
  const Sphere<S, 3> ball = {{0, 0, 0}, 1};
  const auto nothing = [](const Sphere<S, 3>& a, const Cylinder<S>& b) {
    CHECK(relate(a, b) == Relation::disjoint);
    CHECK_FALSE(intersects(a, b));
  };
  nothing({{0, 0, 0}, -1}, c);
  nothing(ball, {{-3, 0, 0}, {3, 0, 0}, -1});
  nothing(ball, {{0, 0, 0}, {0, 0, 0}, 1});
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    nothing({{0, S(bad), 0}, 1}, c);
    nothing({{0, 0, 0}, S(bad)}, c);
    nothing(ball, {{-3, 0, 0}, {3, S(bad), 0}, 5});
  }
}

TEST_CASE("sphere and cylinder: the events tell what is nearest, and what lies inside", "[sphere_cylinder]") {
  Record<sphere_cylinder::Event> record;
  relate(Sphere<double, 3>{{6, 0, 9}, 6}, Cylinder<double>{{-3, 0, 0}, {3, 0, 0}, 5}, record);
  std::erase_if(record.events, [](const auto& event) { return std::holds_alternative<Fallback>(event); });
  REQUIRE(record.events.size() == 2);
  const auto& reach = std::get<sphere_cylinder::Reach>(record.events[0]);
  CHECK((reach.nearest == sphere_cylinder::Nearest::rim_q && reach.sign == -1));
  const auto& inside = std::get<sphere_cylinder::Contained>(record.events[1]);
  CHECK((!inside.ball && !inside.cylinder));
}

TEMPLATE_TEST_CASE("sphere and cylinder: verdicts are the true ones", "[sphere_cylinder]", float, double) {
  using namespace sphere_cylinder;
  tests::sphere_round_pairs::check<TestType, Cylinder, Event, Reach, 6>(bench::sphere_cylinder_draws<TestType>);
}

TEMPLATE_TEST_CASE("the clamped point of a cylinder is right where rounding does not decide", "[sphere_cylinder]",
                   float, double) {
  tests::sphere_round_pairs::check_method<TestType, Cylinder>(
      [](const auto& ball, const auto& solid) { return sphere_cylinder::clamped(ball, solid); });
  Record<sphere_cylinder::GapsEvent<double>> record;
  CHECK(sphere_cylinder::clamped<double>({{6, 0, 9}, 6}, {{-3, 0, 0}, {3, 0, 0}, 5}, record));
  const auto& gaps = std::get<sphere_cylinder::Gaps<double>>(record.events.at(0));
  CHECK((gaps.beyond == 3 && gaps.beside == 4));
}

}  // namespace sphere_cylinder_test
