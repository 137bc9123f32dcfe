#include <isect/ray_cone.h>

#include <isect/methods/ray_cone.h>
#include "bench/ray_cylinder/families.h"
#include "bench/ray_cylinder/oracle.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/ray_round_pairs.h"

namespace ray_cone_test {
using namespace isect;
using tests::inf, tests::not_a_number;

namespace {

template <class S>
Ray<S, 3> ray(double x, double y, double dx, double dy, double lo = 0, double hi = inf) {
  return {{S(x), S(y), 0}, {S(dx), S(dy), 0}, {S(lo), S(hi)}};
}
/// A cone with its apex at (0, 0, 0) and its base around (4, 0, 0).
template <class S>
Cone<S> lying(double radius) {
  return {{0, 0, 0}, {4, 0, 0}, S(radius)};
}
template <class S>
std::optional<Interval<S>> part(const Ray<S, 3>& line, const Cone<S>& c) {
  const auto found = intersect(line, c);
  CHECK(first_hit(line, c) == (found ? std::optional(found->lo) : std::nullopt));
  CHECK(intersects(line, c) == found.has_value());
  return found;
}

}  // namespace

TEMPLATE_TEST_CASE("the part of a ray in a cone, by its side, its base and its apex", "[ray_cone]", float, double) {
  using S = TestType;
  using Part = Interval<S>;
  const Cone<S> c = lying<S>(4);                             // as steep as (1, 1)
  CHECK(part(ray<S>(2, 5, 0, -1), c) == Part{3, 7});         // through both sides
  CHECK(part(ray<S>(2, 5, 0, -1, 4, 6), c) == Part{4, 6});   // all of it within
  CHECK(part(ray<S>(2, 5, 0, -1, -inf), c) == Part{3, 7});   // the line
  CHECK(part(ray<S>(2, 0, 0, -4), c) == Part{0, S(0.5)});    // from within
  CHECK(part(ray<S>(-9, 0, 1, 0), c) == Part{9, 13});        // by the apex, out by the base
  CHECK(part(ray<S>(13, 0, -1, 0), c) == Part{9, 13});       // and turned round
  CHECK(part(ray<S>(-9, 1, 1, 0), c) == Part{10, 13});       // in by the side, where its polynomial falls to -infinity
  CHECK(part(ray<S>(13, 1, -1, 0), c) == Part{9, 12});       // in by the base
  CHECK(part(ray<S>(-1, -1, 1, 1), c) == Part{1, 5});        // along a line of the side
  CHECK(part(ray<S>(0, -2, 1, 1), c) == Part{1, 4});         // parallel to one, in by the side
  CHECK_FALSE(part(ray<S>(0, 2, 1, 1), c));                  // parallel to one, outside
  CHECK(part(ray<S>(4, -9, 0, 1), c) == Part{5, 13});        // in the base
  CHECK(part(ray<S>(0, -9, 0, 1), c) == Part{9, 9});         // across the apex
  CHECK(part(ray<S>(-1, 2, 1, -2), c) == Part{1, 1});        // the same, aslant
  CHECK(part(ray<S>(-1, 1, 1, -1), c) == Part{1, 5});        // by the apex along a line of the side
  CHECK(part(ray<S>(4, 5, 0, 0, 0, 1), c) == std::nullopt);  // no direction
  CHECK(part(ray<S>(4, 4, 0, 0, 0, 1), c) == Part{0, 1});
  CHECK_FALSE(part(ray<S>(-2, -1, 0, 1), c));  // only the other half of the double cone
  CHECK_FALSE(part(ray<S>(-2, 9, 0, -1, -inf), c));
  CHECK_FALSE(part(ray<S>(5, 9, 0, -1), c));
  CHECK(part(ray<S>(2, 5, 0, -1), lying<S>(0)) == Part{5, 5});  // a segment
  CHECK(part(ray<S>(-9, 0, 1, 0), lying<S>(0)) == Part{9, 13});
  CHECK_FALSE(part(ray<S>(2, 5, 0, -1, 8), c));
  CHECK_FALSE(part(ray<S>(2, 5, 0, -1, 0, S(2.5)), c));
  CHECK_FALSE(part(ray<S>(2, 5, 0, -1, 6, 5), c));
  CHECK_FALSE(part(ray<S>(2, 5, 0, -1, not_a_number), c));
  for (const double bad : {not_a_number, inf, -1.0}) CHECK_FALSE(part(ray<S>(2, 5, 0, -1), lying<S>(bad)));
  CHECK_FALSE(part(ray<S>(1, 5, 0, -1), Cone<S>{{1, 0, 0}, {1, 0, 0}, 3}));
}

TEMPLATE_TEST_CASE("ray and cone: an ulp decides at the side, at the base and at the apex", "[ray_cone]", float,
                   double) {
  using S = TestType;
  const S more = std::nextafter(S(4), S(5)), least = std::numeric_limits<S>::denorm_min();
  const Ray<S, 3> beside = {{4, -9, 4}, {0, 1, 0}};
  CHECK(part(beside, lying<S>(4)) == Interval<S>{9, 9});
  CHECK_FALSE(part(Ray<S, 3>{{4, -9, more}, {0, 1, 0}}, lying<S>(4)));
  CHECK_FALSE(part(Ray<S, 3>{{more, -9, 0}, {0, 1, 0}}, lying<S>(4)));
  CHECK(part(Ray<S, 3>{{2, -9, 2}, {0, 1, 0}}, lying<S>(4)) == Interval<S>{9, 9});
  CHECK_FALSE(part(Ray<S, 3>{{2, -9, std::nextafter(S(2), S(3))}, {0, 1, 0}}, lying<S>(4)));
  CHECK_FALSE(part(Ray<S, 3>{{-least, -9, 0}, {0, 1, 0}}, lying<S>(4)));
  CHECK_FALSE(part(Ray<S, 3>{{0, -9, least}, {0, 1, 0}}, lying<S>(4)));
}

TEMPLATE_TEST_CASE("a segment keeps both its ends as it enters a cone", "[ray_cone]", float, double) {
  using S = TestType;
  // q - p is rounded in S: as a ray it would end a hair before or behind q
  const Segment<S, 3> segment = {{S(1e8), 0, 0}, {S(1 / 3.), 0, 0}};
  CHECK(intersect(segment, Cone<S>{{0, 0, 0}, {S(1 / 3.), 0, 0}, 1}) == Interval<S>{1, 1});
  CHECK_FALSE(intersects(segment, Cone<S>{{0, 0, 0}, {std::nextafter(S(1 / 3.), S(0)), 0, 0}, 1}));
  CHECK(intersect(Segment<S, 3>{{2, 2, 0}, {2, 2, 0}}, lying<S>(4)) == Interval<S>{0, 1});
  CHECK_FALSE(intersect(Segment<S, 3>{{S(not_a_number), 0, 0}, {0, 0, 0}}, lying<S>(1)));
}

TEST_CASE("ray and cone: the events tell where the line comes in between apex and base, and out", "[ray_cone]") {
  using namespace ray_cone;
  const auto told = [](const Ray<double, 3>& line) {
    Record<Event> record;
    intersect(line, Cone<double>{{0, 0, 0}, {4, 0, 0}, 2}, record);
    std::erase_if(record.events, [](const Event& event) { return std::holds_alternative<Fallback>(event); });
    return record.events;
  };
  const std::vector<Event> along = told({{-9, 1, 0}, {1, 0, 0}});
  REQUIRE(along.size() == 2);
  const Stop in = std::get<Stop>(along[0]), out = std::get<Stop>(along[1]);
  CHECK((!in.ends && in.at == Limit::first && in.inside == false));
  CHECK((out.ends && out.at == Limit::last && out.inside));
  const std::vector<Event> across = told({{1, 9, 0}, {0, -1, 0}});
  REQUIRE(across.size() == 3);
  CHECK(std::get<Stop>(across[0]).at == Limit::range);
  CHECK(std::get<Stop>(across[1]).at == Limit::none);
  const Side side = std::get<Side>(across[2]);
  CHECK((side.falls && side.rises && side.root));
}

TEMPLATE_TEST_CASE("ray and cone: where the ray enters and leaves is what rational arithmetic says", "[ray_cone]",
                   float, double) {
  tests::ray_round_pairs::check<TestType, Cone, ray_cone::Event>(bench::ray_cone_draws<TestType>);
}

TEMPLATE_TEST_CASE("the quadratic of a cone's side is right where rounding does not decide", "[ray_cone]", float,
                   double) {
  tests::ray_round_pairs::check_method<TestType, Cone>(
      [](const auto& line, const auto& solid) { return ray_cone::quadratic(line, solid); });
  Record<ray_cone::QuadraticEvent<double>> record;
  CHECK(ray_cone::quadratic<double>(ray<double>(2, 5, 0, -1), lying<double>(4), record) == 3.0);
  CHECK(std::get<ray_cone::Coefficients<double>>(record.events.at(0)).a == 256);
}

}  // namespace ray_cone_test
