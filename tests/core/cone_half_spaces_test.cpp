#include <isect/cone_half_spaces.h>

#include <isect/plane_cone.h>
#include <isect/point_cone.h>
#include <isect/point_plane.h>
#include <isect/ray_cone.h>
#include "bench/cylinder_half_spaces/families.h"
#include "bench/cylinder_half_spaces/oracle.h"
#include "tests/core/half_spaces_round_pairs.h"

namespace cone_half_spaces_test {
using namespace isect;

namespace {

HalfSpaces box(const Point<double, 3>& lo, const Point<double, 3>& hi) {
  return half_spaces_of(Aabb<double, 3>{lo, hi});
}

}  // namespace

TEMPLATE_TEST_CASE("a box touches a cone by a face, an edge or a corner, and an ulp decides", "[cone_half_spaces]",
                   float, double) {
  using S = TestType;
  const Cone<S> c = {{0, 0, 4}, {0, 0, 0}, 4};  // its side falls as fast as it widens
  const auto edge = [&](double z) { return relate(c, box({1, -9, z}, {9, 9, 9})); };  // across the side
  CHECK(edge(3) == Relation::touching);
  CHECK(edge(std::nextafter(3., 4.)) == Relation::disjoint);
  CHECK(edge(std::nextafter(3., 2.)) == Relation::overlapping);
  const Cone<S> steep = {{0, 0, 2}, {0, 0, 0}, 10};
  const auto corner = [&](double y) { return relate(steep, box({3, y, 1}, {9, 9, 9})); };  // 5 wide there
  CHECK(corner(4) == Relation::touching);
  CHECK(corner(std::nextafter(4., 5.)) == Relation::disjoint);
  CHECK(corner(std::nextafter(4., 3.)) == Relation::overlapping);
  const auto on_apex = [&](double z) { return relate(c, box({-1, -1, z}, {1, 1, 9})); };
  CHECK(on_apex(4) == Relation::touching);
  CHECK(on_apex(std::nextafter(4., 5.)) == Relation::disjoint);
  CHECK(on_apex(std::nextafter(4., 3.)) == Relation::overlapping);
  const auto below = [&](double z) { return relate(c, box({-1, -1, -9}, {1, 1, z})); };
  CHECK(below(0) == Relation::touching);
  CHECK(below(-std::numeric_limits<double>::denorm_min()) == Relation::disjoint);
  CHECK(below(std::numeric_limits<double>::denorm_min()) == Relation::overlapping);
  // {x + z >= 4} lies along a line of the side
  const auto leaning = [&](double d) { return relate(c, HalfSpaces{{{half_spaces::Level{{1, 0, 1}, d}}}}); };
  CHECK(leaning(-4) == Relation::touching);
  CHECK(leaning(std::nextafter(-4., -5.)) == Relation::disjoint);
  CHECK(leaning(std::nextafter(-4., 0.)) == Relation::overlapping);
}

TEST_CASE("only the apex, or only what lies beyond it", "[cone_half_spaces]") {
  const Cone<double> c = {{0, 0, 0}, {0, 0, 4}, 3};
  CHECK(relate(c, box({0, 0, -9}, {0, 0, 0})) == Relation::touching);
  CHECK(relate(c, box({0, 0, 0}, {9, 9, 0})) == Relation::touching);
  CHECK(relate(c, box({0, 0, 0}, {0, 0, 0})) == Relation::b_inside_a);
  CHECK(relate(c, box({1, 0, 0}, {9, 9, 0})) == Relation::disjoint);
  CHECK(relate(c, box({-1, -1, -4}, {1, 1, -1})) == Relation::disjoint);  // in the other half of the double cone
  CHECK(relate(c, box({0, 0, -4}, {9, 9, 4})) == Relation::overlapping);
  // Through the apex, and beside all else: a segment along x, and a half-space that is steeper than the side
  CHECK(relate(c, box({-9, 0, 0}, {9, 0, 0})) == Relation::touching);
  CHECK(relate(c, HalfSpaces{{{half_spaces::Level{{4, 0, -4}, 0}}}}) == Relation::touching);
  CHECK(relate(c, HalfSpaces{{{half_spaces::Level{{4, 0, -3}, 0}}}}) == Relation::touching);  // a line of the side
  CHECK(relate(c, HalfSpaces{{{half_spaces::Level{{4, 0, -2}, 0}}}}) == Relation::overlapping);
}

TEMPLATE_TEST_CASE("a cone lies in a box, or a box in the cone", "[cone_half_spaces]", float, double) {
  using S = TestType;
  const Cone<S> c = {{0, 0, 2}, {0, 0, 0}, 10};
  CHECK(relate(c, box({-10, -10, 0}, {10, 10, 2})) == Relation::a_inside_b);
  CHECK(relate(c, box({-10, -10, 0}, {10, 10, std::nextafter(2., 1.)})) == Relation::overlapping);
  CHECK(relate(c, box({-10, -10, 0}, {std::nextafter(10., 9.), 10, 2})) == Relation::overlapping);
  CHECK(relate(c, box({-3, -4, 0}, {3, 4, 1})) == Relation::b_inside_a);
  CHECK(relate(c, box({-3, -4, 0}, {3, 4, std::nextafter(1., 2.)})) == Relation::overlapping);
  CHECK(relate(c, box({6, 8, 0}, {6, 8, 0})) == Relation::b_inside_a);  // a point of the rim
  CHECK(relate(c, box({0, 0, -9}, {0, 0, 9})) == Relation::overlapping);
  CHECK(relate(c, box({-99, -99, 0}, {99, 99, 0})) == Relation::touching);
  CHECK(relate(c, {}) == Relation::a_inside_b);  // all of space
  const Cone<S> thin = {{0, 0, 0}, {0, 0, 3}, 0};
  CHECK(relate(thin, box({0, 0, 0}, {0, 0, 3})) == Relation::equal);
  CHECK(relate(thin, box({-1, -1, 2}, {1, 1, 4})) == Relation::overlapping);
  CHECK(relate(thin, box({0, 0, 3}, {1, 1, 4})) == Relation::touching);
}

TEST_CASE("cone and half-spaces: the events tell how the shadow lies, and what lies inside", "[cone_half_spaces]") {
  Record<cone_half_spaces::Event> record;
  relate(Cone<double>{{0, 0, 2}, {0, 0, 0}, 10}, box({3, 4, 1}, {9, 9, 9}), record);
  std::erase_if(record.events, [](const auto& event) { return std::holds_alternative<Fallback>(event); });
  REQUIRE(record.events.size() == 2);
  CHECK(std::get<cone_half_spaces::Shadow>(record.events[0]).reach == 0);
  const auto& inside = std::get<cone_half_spaces::Contained>(record.events[1]);
  CHECK((!inside.round && !inside.other));
}

TEMPLATE_TEST_CASE("cone and half-spaces: verdicts are the true ones", "[cone_half_spaces]", float, double) {
  tests::half_spaces_round_pairs::check<TestType, Cone, cone_half_spaces::Event>();
}

TEST_CASE("a cone beside boxes, frusta and hulls", "[cone_half_spaces]") {
  tests::half_spaces_round_pairs::check_forms<Cone<double>>();
}

TEST_CASE("a cone lies alike however many faces the solid is given by", "[cone_half_spaces]") {
  tests::half_spaces_round_pairs::check_many_faces<Cone<double>>();
}

TEST_CASE("a cone beside a half-space, a segment and a point", "[cone_half_spaces]") {
  tests::half_spaces_round_pairs::check_thin_and_endless<Cone>();
}

TEST_CASE("cone and half-spaces: what is empty, NaN or infinite meets nothing", "[cone_half_spaces]") {
  tests::half_spaces_round_pairs::check_nothing(Cone<double>{{-3, 0, 0}, {3, 0, 0}, 2});
}

}  // namespace cone_half_spaces_test
