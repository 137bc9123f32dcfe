#include <isect/ray_cylinder.h>

#include <isect/methods/ray_cylinder.h>
#include "bench/ray_cylinder/families.h"
#include "bench/ray_cylinder/oracle.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/ray_round_pairs.h"

namespace ray_cylinder_test {
using namespace isect;
using tests::inf, tests::not_a_number;

namespace {

template <class S>
Ray<S, 3> ray(double x, double y, double dx, double dy, double lo = 0, double hi = inf) {
  return {{S(x), S(y), 0}, {S(dx), S(dy), 0}, {S(lo), S(hi)}};
}
/// A cylinder from (-3, 0, 0) to (3, 0, 0).
template <class S>
Cylinder<S> lying(double radius) {
  return {{-3, 0, 0}, {3, 0, 0}, S(radius)};
}
/// The part of the line in the cylinder, checked with the cylinder's ends swapped, and by first_hit.
template <class S>
std::optional<Interval<S>> part(const Ray<S, 3>& line, const Cylinder<S>& c) {
  const auto found = intersect(line, c);
  CHECK(intersect(line, Cylinder<S>{c.q, c.p, c.radius}) == found);
  CHECK(first_hit(line, c) == (found ? std::optional(found->lo) : std::nullopt));
  CHECK(intersects(line, c) == found.has_value());
  return found;
}

}  // namespace

TEMPLATE_TEST_CASE("the part of a ray in a cylinder, by its side and by its ends", "[ray_cylinder]", float, double) {
  using S = TestType;
  using Part = Interval<S>;
  const Cylinder<S> c = lying<S>(2);
  CHECK(part(ray<S>(1, 5, 0, -1), c) == Part{3, 7});            // through both sides
  CHECK(part(ray<S>(1, 5, 0, -1, 4, 6), c) == Part{4, 6});      // all of it within
  CHECK(part(ray<S>(1, 5, 0, -1, -inf), c) == Part{3, 7});      // the line
  CHECK(part(ray<S>(1, 0, 0, -4), c) == Part{0, S(0.5)});       // from within, in units of the direction
  CHECK(part(ray<S>(-9, 1, 2, 0), c) == Part{3, 6});            // through both ends
  CHECK(part(ray<S>(9, 1, -1, 0), c) == Part{6, 12});           // and turned round
  CHECK(part(ray<S>(-9, 2, 1, 0), c) == Part{6, 12});           // along the side
  CHECK(part(ray<S>(3, -9, 0, 1), c) == Part{7, 11});           // in the plane of an end
  CHECK(part(ray<S>(-5, 0, 1, 1), c) == Part{2, 2});            // at the rim, in passing
  CHECK(part(ray<S>(-5, 1, 1, 0.5), c) == Part{2, 2});          // the same from below
  CHECK(part(ray<S>(-5, -1, 1, 1), c) == Part{2, 3});           // in by an end, out by the side
  CHECK(part(ray<S>(0, 5, 1, -1), c) == Part{3, 3});            // at the rim
  CHECK(part(ray<S>(-1, 5, 1, -1), c) == Part{3, 4});           // in by the side, out by an end
  CHECK(part(ray<S>(1, 5, 0, -1), lying<S>(0)) == Part{5, 5});  // a segment
  CHECK(part(ray<S>(-9, 0, 1, 0), lying<S>(0)) == Part{6, 12});
  CHECK(part(ray<S>(1, 2, 0, 0, -3, 8), c) == Part{-3, 8});  // no direction
  CHECK(part(ray<S>(1, 2, 0, 0), c) == Part{0, S(inf)});
  CHECK_FALSE(part(ray<S>(1, 3, 0, 0, -3, 8), c));
  CHECK_FALSE(part(ray<S>(4, 0, 0, 1), c));  // beyond an end
  CHECK_FALSE(part(ray<S>(-5, 0, 0, 1), c));
  CHECK_FALSE(part(ray<S>(1, 5, 0, -1, 8), c));
  CHECK_FALSE(part(ray<S>(1, 5, 0, -1, 0, S(2.5)), c));
  CHECK_FALSE(part(ray<S>(1, 5, 0, -1, 6, 5), c));
  CHECK_FALSE(part(ray<S>(1, 5, 0, -1, not_a_number), c));
  for (const double bad : {not_a_number, inf, -1.0}) CHECK_FALSE(part(ray<S>(1, 5, 0, -1), lying<S>(bad)));
  CHECK_FALSE(part(ray<S>(1, 5, 0, -1), Cylinder<S>{{1, 0, 0}, {1, 0, 0}, 3}));
}

TEMPLATE_TEST_CASE("ray and cylinder: an ulp decides at the side, at an end and at the rim", "[ray_cylinder]", float,
                   double) {
  using S = TestType;
  const S less = std::nextafter(S(2), S(0)), more = std::nextafter(S(3), S(4));
  CHECK(part(ray<S>(-9, 2, 1, 0), lying<S>(2)));
  CHECK_FALSE(part(ray<S>(-9, 2, 1, 0), lying<S>(less)));
  CHECK(part(ray<S>(3, -9, 0, 1), lying<S>(2)));
  CHECK_FALSE(part(ray<S>(more, -9, 0, 1), lying<S>(2)));
  CHECK(part(ray<S>(-5, 0, 1, 1), lying<S>(2)));
  CHECK_FALSE(part(ray<S>(-5, 0, 1, 1), lying<S>(less)));
  const Ray<S, 3> beside = {{1, -9, 2}, {0, 1, 0}};  // in space, above the axis
  CHECK(part(beside, lying<S>(2)) == Interval<S>{9, 9});
  CHECK_FALSE(part(beside, lying<S>(less)));
}

TEMPLATE_TEST_CASE("a segment keeps both its ends as it enters a cylinder", "[ray_cylinder]", float, double) {
  using S = TestType;
  // q - p is rounded in S: as a ray it would end a hair before or behind q
  const Segment<S, 3> segment = {{S(1e8), 0, 0}, {S(1 / 3.), 0, 0}};
  const Cylinder<S> touched = {{0, 0, 0}, {S(1 / 3.), 0, 0}, 1};
  CHECK(intersect(segment, touched) == Interval<S>{1, 1});
  CHECK_FALSE(intersects(segment, Cylinder<S>{{0, 0, 0}, {std::nextafter(S(1 / 3.), S(0)), 0, 0}, 1}));
  CHECK(intersect(Segment<S, 3>{{1, 2, 0}, {1, 2, 0}}, lying<S>(2)) == Interval<S>{0, 1});
  CHECK_FALSE(intersect(Segment<S, 3>{{S(not_a_number), 0, 0}, {0, 0, 0}}, lying<S>(1)));
}

TEST_CASE("ray and cylinder: the events tell where the line comes in between the ends, and out", "[ray_cylinder]") {
  using namespace ray_cylinder;
  const auto told = [](const Ray<double, 3>& line) {
    Record<Event> record;
    intersect(line, Cylinder<double>{{-3, 0, 0}, {3, 0, 0}, 2}, record);
    std::erase_if(record.events, [](const Event& event) { return std::holds_alternative<Fallback>(event); });
    return record.events;
  };
  const std::vector<Event> along = told({{-9, 1, 0}, {1, 0, 0}});
  REQUIRE(along.size() == 2);
  const Stop in = std::get<Stop>(along[0]), out = std::get<Stop>(along[1]);
  CHECK((!in.ends && in.at == Limit::first && in.inside == true));
  CHECK((out.ends && out.at == Limit::last && out.inside));
  const std::vector<Event> across = told({{1, 9, 0}, {0, -1, 0}});
  REQUIRE(across.size() == 3);
  CHECK(std::get<Stop>(across[0]).at == Limit::range);
  CHECK(std::get<Stop>(across[1]).at == Limit::none);
  const Side side = std::get<Side>(across[2]);
  CHECK((side.falls && side.rises && side.root));
}

TEMPLATE_TEST_CASE("ray and cylinder: where the ray enters and leaves is what rational arithmetic says",
                   "[ray_cylinder]", float, double) {
  tests::ray_round_pairs::check<TestType, Cylinder, ray_cylinder::Event>(bench::ray_cylinder_draws<TestType>);
}

TEMPLATE_TEST_CASE("the quadratic of a cylinder's side is right where rounding does not decide", "[ray_cylinder]",
                   float, double) {
  tests::ray_round_pairs::check_method<TestType, Cylinder>(
      [](const auto& line, const auto& solid) { return ray_cylinder::quadratic(line, solid); });
  Record<ray_cylinder::QuadraticEvent<double>> record;
  CHECK(ray_cylinder::quadratic<double>(ray<double>(1, 5, 0, -1), lying<double>(2), record) == 3.0);
  CHECK(std::get<ray_cylinder::Coefficients<double>>(record.events.at(1)).a == 36);
}

}  // namespace ray_cylinder_test
