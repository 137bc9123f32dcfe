#include <isect/sphere_cone.h>

#include <isect/methods/sphere_cone.h>
#include "bench/sphere_cylinder/families.h"
#include "bench/sphere_cylinder/oracle.h"
#include "tests/catch.h"
#include "tests/core/sphere_round_pairs.h"

namespace sphere_cone_test {
using namespace isect;

TEMPLATE_TEST_CASE("a ball touches a cone at its side, base, rim or apex, and an ulp decides", "[sphere_cone]", float,
                   double) {
  using S = TestType;
  const Cone<S> c = {{0, 0, 0}, {8, 0, 0}, 6};  // its side is 10 long
  const auto by = [&](S x, S y, S z, S s) {
    CHECK(relate(Sphere<S, 3>{{x, y, z}, std::nextafter(s, S(0))}, c) == Relation::disjoint);
    CHECK(relate(Sphere<S, 3>{{x, y, z}, std::nextafter(s, S(99))}, c) == Relation::overlapping);
    return relate(Sphere<S, 3>{{x, y, z}, s}, c);
  };
  CHECK(by(1, 7, 0, 5) == Relation::touching);    // beside the middle of the side: (4, 3) and 5 across
  CHECK(by(0, 0, 10, 8) == Relation::touching);   // beside it, over the apex
  CHECK(by(5, 10, 0, 5) == Relation::touching);   // at the rim, straight above the side
  CHECK(by(12, 9, 0, 5) == Relation::touching);   // at the rim, by 3, 4 and 5
  CHECK(by(10, 0, -6, 2) == Relation::touching);  // beyond the base, over the rim
  CHECK(by(10, 1, 1, 2) == Relation::touching);   // beyond the base
  CHECK(by(-3, 4, 0, 5) == Relation::touching);   // beside the apex, straight above the side
  CHECK(by(-4, 0, 3, 5) == Relation::touching);   // beyond the apex
}

TEMPLATE_TEST_CASE("a ball lies in a cone, or the cone in a ball", "[sphere_cone]", float, double) {
  using S = TestType;
  const Cone<S> c = {{0, 0, 0}, {8, 0, 0}, 6};
  const auto by = [&](S x, S y, S z, S s) { return relate(Sphere<S, 3>{{x, y, z}, s}, c); };
  const auto more = [](S x) { return std::nextafter(x, S(99)); };
  CHECK(by(5, 0, 0, 3) == Relation::a_inside_b);  // the inscribed ball
  CHECK(by(5, 0, 0, more(3)) == Relation::overlapping);
  CHECK(by(std::nextafter(S(5), S(0)), 0, 0, 3) == Relation::overlapping);
  CHECK(by(7, 0, 0, 1) == Relation::a_inside_b);  // in touch with the base
  CHECK(by(7, 0, 0, more(1)) == Relation::overlapping);
  CHECK(by(8, 0, 0, 8) == Relation::b_inside_a);  // to the apex
  CHECK(by(8, 0, 0, std::nextafter(S(8), S(0))) == Relation::overlapping);
  CHECK(by(0, 0, 0, 10) == Relation::b_inside_a);  // to the rim
  CHECK(by(0, 0, 0, std::nextafter(S(10), S(0))) == Relation::overlapping);
  CHECK(by(0, 0, 0, 0) == Relation::a_inside_b);  // the apex
  CHECK(by(0, std::numeric_limits<S>::denorm_min(), 0, 0) == Relation::disjoint);
  const Cone<S> thin = {{-3, 0, 0}, {3, 0, 0}, 0};
  CHECK(relate(Sphere<S, 3>{{0, 4, 0}, 5}, thin) == Relation::b_inside_a);
  CHECK(relate(Sphere<S, 3>{{0, 4, 0}, 4}, thin) == Relation::touching);
  CHECK(relate(Sphere<S, 3>{{1, 0, 0}, 0}, thin) == Relation::a_inside_b);
}

TEMPLATE_TEST_CASE("sphere and cone: what is empty, NaN or infinite meets nothing", "[sphere_cone]", float, double) {
  using S = TestType;
  const Cone<S> c = {{-3, 0, 0}, {3, 0, 0}, 5};
  const Sphere<S, 3> ball = {{0, 0, 0}, 1};
  const auto nothing = [](const Sphere<S, 3>& a, const Cone<S>& b) {
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

TEST_CASE("sphere and cone: the events tell what is nearest, and what lies inside", "[sphere_cone]") {
  Record<sphere_cone::Event> record;
  relate(Sphere<double, 3>{{12, 9, 0}, 6}, Cone<double>{{0, 0, 0}, {8, 0, 0}, 6}, record);
  std::erase_if(record.events, [](const auto& event) { return std::holds_alternative<Fallback>(event); });
  REQUIRE(record.events.size() == 2);
  const auto& reach = std::get<sphere_cone::Reach>(record.events[0]);
  CHECK((reach.nearest == sphere_cone::Nearest::rim && reach.sign == -1));
  const auto& inside = std::get<sphere_cone::Contained>(record.events[1]);
  CHECK((!inside.ball && !inside.cone));
}

TEMPLATE_TEST_CASE("sphere and cone: verdicts are the true ones", "[sphere_cone]", float, double) {
  using namespace sphere_cone;
  tests::sphere_round_pairs::check<TestType, Cone, Event, Reach, 5>(bench::sphere_cone_draws<TestType>);
}

TEMPLATE_TEST_CASE("the profile of a cone is right where rounding does not decide", "[sphere_cone]", float, double) {
  tests::sphere_round_pairs::check_method<TestType, Cone>(
      [](const auto& ball, const auto& solid) { return sphere_cone::by_profile(ball, solid); });
  Record<sphere_cone::ProfileEvent<double>> record;
  CHECK(sphere_cone::by_profile<double>({{12, 9, 0}, 6}, {{0, 0, 0}, {8, 0, 0}, 6}, record));
  const auto& told = std::get<sphere_cone::InProfile<double>>(record.events.at(0));
  CHECK((told.along == 12 && told.beside == 9 && told.distance == 5));
}

}  // namespace sphere_cone_test
