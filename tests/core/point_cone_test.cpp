#include <isect/point_cone.h>

#include <isect/methods/point_cone.h>
#include "bench/point_cylinder/families.h"
#include "bench/point_cylinder/oracle.h"
#include "tests/catch.h"
#include "tests/core/motion.h"
#include "tests/core/point_round_pairs.h"

namespace point_cone_test {
using namespace isect;

TEMPLATE_TEST_CASE("a point lies in a cone, on it or out of it", "[point_cone]", float, double) {
  using S = TestType;
  const Cone<S> c = {{0, 0, 0}, {6, 0, 0}, 10};
  const auto where = [&](S x, S y, S z) { return locate(Point<S, 3>(x, y, z), c); };
  CHECK(where(3, 0, 0) == Location::in);
  CHECK(where(3, 3, 4) == Location::on);
  CHECK(where(3, 3, std::nextafter(S(4), S(5))) == Location::out);
  CHECK(where(3, 3, std::nextafter(S(4), S(3))) == Location::in);
  CHECK(where(0, 0, 0) == Location::on);  // the apex
  CHECK(where(0, std::numeric_limits<S>::denorm_min(), 0) == Location::out);
  CHECK(where(6, 1, 1) == Location::on);  // on the base
  CHECK(where(std::nextafter(S(6), S(7)), 1, 1) == Location::out);
  CHECK(where(std::nextafter(S(6), S(0)), 1, 1) == Location::in);
  CHECK(where(6, 8, -6) == Location::on);  // on the rim
  CHECK(where(-3, 0, 0) == Location::out);
  CHECK(where(-3, 3, 4) == Location::out);  // of the double cone
}

TEMPLATE_TEST_CASE("a cone of radius 0 is a segment, and one without an axis is empty", "[point_cone]", float, double) {
  using S = TestType;
  const S least = std::numeric_limits<S>::denorm_min();
  const Cone<S> thin = {{S(0.1), S(0.1), 0}, {S(0.7), S(0.7), 0}, 0};
  CHECK(locate(Point<S, 3>(S(0.3), S(0.3), 0), thin) == Location::on);
  CHECK(locate(Point<S, 3>(S(0.7), S(0.7), 0), thin) == Location::on);
  CHECK(locate(Point<S, 3>(S(0.3), S(0.3), least), thin) == Location::out);
  CHECK(locate(Point<S, 3>(S(0.8), S(0.8), 0), thin) == Location::out);
  CHECK(locate(Point<S, 3>(1, 1, 1), Cone<S>{{1, 1, 1}, {1, 1, 1}, 2}) == Location::out);
  CHECK(locate(Point<S, 3>(1, 1, 1), Cone<S>{{1, 1, 1}, {1, 1, 1}, 0}) == Location::out);
  CHECK(locate(Point<S, 3>(0, 0, 0), Cone<S>{{-1, 0, 0}, {1, 0, 0}, -1}) == Location::out);
  CHECK(locate(Point<S, 3>(0, 0, 0), Cone<S>{{-least, 0, 0}, {least, 0, 0}, least}) == Location::in);
}

TEST_CASE("point and cone: the events tell all three signs", "[point_cone]") {
  Record<point_cone::Event> record;
  locate(Point<double, 3>{3, 3, 4}, Cone<double>{{0, 0, 0}, {6, 0, 0}, 10}, record);
  const auto& signs = std::get<point_cone::Signs>(record.events.back());
  CHECK((signs.first == 1 && signs.last == -1 && signs.side == 0));
}

TEMPLATE_TEST_CASE("point and cone: every verdict is that of rational arithmetic", "[point_cone]", float, double) {
  tests::point_round_pairs::check<TestType, Cone, point_cone::Event>(bench::point_cone_draws<TestType>);
}

TEMPLATE_TEST_CASE("a cone by the height of a point over the apex is right where rounding does not decide",
                   "[point_cone]", float, double) {
  tests::point_round_pairs::check_method<TestType, Cone>(
      [](const auto& point, const auto& solid) { return point_cone::by_height(point, solid); });
  Record<point_cone::HeightEvent<double>> record;
  CHECK(point_cone::by_height<double>({1, 0.5, 0}, {{0, 0, 0}, {4, 0, 0}, 2}, record));
  const auto& told = std::get<point_cone::Height<double>>(record.events.at(0));
  CHECK((told.t == 0.25 && told.distance == 0.5));
}

}  // namespace point_cone_test
