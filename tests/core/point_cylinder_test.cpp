#include <isect/point_cylinder.h>

#include <isect/methods/point_cylinder.h>
#include "bench/point_cylinder/families.h"
#include "bench/point_cylinder/oracle.h"
#include "tests/catch.h"
#include "tests/core/motion.h"
#include "tests/core/point_round_pairs.h"

namespace point_cylinder_test {
using namespace isect;

TEMPLATE_TEST_CASE("a point lies in a cylinder, on it or out of it", "[point_cylinder]", float, double) {
  using S = TestType;
  const Cylinder<S> c = {{-3, 0, 0}, {3, 0, 0}, 5};
  const auto where = [&](S x, S y, S z) { return locate(Point<S, 3>(x, y, z), c); };
  CHECK(where(0, 0, 0) == Location::in);
  CHECK(where(1, 3, 4) == Location::on);
  CHECK(where(1, 3, std::nextafter(S(4), S(5))) == Location::out);
  CHECK(where(1, 3, std::nextafter(S(4), S(3))) == Location::in);
  CHECK(where(3, 1, 1) == Location::on);  // on an end
  CHECK(where(std::nextafter(S(3), S(4)), 1, 1) == Location::out);
  CHECK(where(std::nextafter(S(-3), S(0)), 1, 1) == Location::in);
  CHECK(where(-3, 4, -3) == Location::on);  // on the rim
  CHECK(where(-3, 4, std::nextafter(S(-3), S(-4))) == Location::out);
  CHECK(where(6, 4, 0) == Location::out);  // in the capsule, beyond the end
}

TEMPLATE_TEST_CASE("a cylinder of radius 0 is a segment, and one without an axis is empty", "[point_cylinder]", float,
                   double) {
  using S = TestType;
  const S least = std::numeric_limits<S>::denorm_min();
  const Cylinder<S> thin = {{S(0.1), S(0.1), 0}, {S(0.7), S(0.7), 0}, 0};
  CHECK(locate(Point<S, 3>(S(0.3), S(0.3), 0), thin) == Location::on);
  CHECK(locate(Point<S, 3>(S(0.7), S(0.7), 0), thin) == Location::on);
  CHECK(locate(Point<S, 3>(S(0.3), S(0.3), least), thin) == Location::out);
  CHECK(locate(Point<S, 3>(S(0.8), S(0.8), 0), thin) == Location::out);
  CHECK(locate(Point<S, 3>(1, 1, 1), Cylinder<S>{{1, 1, 1}, {1, 1, 1}, 2}) == Location::out);
  CHECK(locate(Point<S, 3>(1, 1, 1), Cylinder<S>{{1, 1, 1}, {1, 1, 1}, 0}) == Location::out);
  CHECK(locate(Point<S, 3>(0, 0, 0), Cylinder<S>{{-1, 0, 0}, {1, 0, 0}, -1}) == Location::out);
  CHECK(locate(Point<S, 3>(0, 0, 0), Cylinder<S>{{-least, 0, 0}, {least, 0, 0}, least}) == Location::in);
}

TEST_CASE("point and cylinder: the events tell all three signs", "[point_cylinder]") {
  Record<point_cylinder::Event> record;
  locate(Point<double, 3>{1, 3, 4}, Cylinder<double>{{-3, 0, 0}, {3, 0, 0}, 5}, record);
  const auto& signs = std::get<point_cylinder::Signs>(record.events.back());
  CHECK((signs.first == 1 && signs.last == -1 && signs.side == 0));
}

TEMPLATE_TEST_CASE("point and cylinder: every verdict is that of rational arithmetic", "[point_cylinder]", float,
                   double) {
  tests::point_round_pairs::check<TestType, Cylinder, point_cylinder::Event>(bench::point_cylinder_draws<TestType>);
}

TEMPLATE_TEST_CASE("the projection of a point onto a cylinder's axis is right where rounding does not decide",
                   "[point_cylinder]", float, double) {
  tests::point_round_pairs::check_method<TestType, Cylinder>(
      [](const auto& point, const auto& solid) { return point_cylinder::projected(point, solid); });
  Record<point_cylinder::ProjectedEvent<double>> record;
  CHECK(point_cylinder::projected<double>({1, 2, 0}, {{0, 0, 0}, {4, 0, 0}, 2}, record));
  const auto& told = std::get<point_cylinder::Projected<double>>(record.events.at(0));
  CHECK((told.t == 0.25 && told.distance2 == 4));
}

}  // namespace point_cylinder_test
