#include <isect/cylinder_half_spaces.h>

#include <isect/plane_cylinder.h>
#include <isect/point_cylinder.h>
#include <isect/point_plane.h>
#include <isect/ray_cylinder.h>
#include "bench/cylinder_half_spaces/families.h"
#include "bench/cylinder_half_spaces/oracle.h"
#include "tests/core/half_spaces_round_pairs.h"

namespace cylinder_half_spaces_test {
using namespace isect;

namespace {

HalfSpaces box(const Point<double, 3>& lo, const Point<double, 3>& hi) {
  return half_spaces_of(Aabb<double, 3>{lo, hi});
}

}  // namespace

TEMPLATE_TEST_CASE("a box touches a cylinder by a face, an edge or a corner, and an ulp decides",
                   "[cylinder_half_spaces]", float, double) {
  using S = TestType;
  const Cylinder<S> c = {{0, 0, -3}, {0, 0, 3}, 5};
  const double more = std::nextafter(5., 6.), less = std::nextafter(5., 4.);
  const auto face = [&](double x) { return relate(c, box({x, -1, -9}, {9, 1, 9})); };
  CHECK(face(5) == Relation::touching);
  CHECK(face(more) == Relation::disjoint);
  CHECK(face(less) == Relation::overlapping);
  const auto edge = [&](double y) { return relate(c, box({3, y, -1}, {9, 9, 1})); };  // parallel to the axis, at 3, 4
  CHECK(edge(4) == Relation::touching);
  CHECK(edge(std::nextafter(4., 5.)) == Relation::disjoint);
  CHECK(edge(std::nextafter(4., 3.)) == Relation::overlapping);
  const auto end = [&](double z) { return relate(c, box({-1, -1, z}, {1, 1, 9})); };
  CHECK(end(3) == Relation::touching);
  CHECK(end(std::nextafter(3., 4.)) == Relation::disjoint);
  CHECK(end(std::nextafter(3., 2.)) == Relation::overlapping);
  const auto rim = [&](double y) { return relate(c, box({3, y, 3}, {9, 9, 9})); };  // its corner on the rim
  CHECK(rim(4) == Relation::touching);
  CHECK(rim(std::nextafter(4., 5.)) == Relation::disjoint);
  CHECK(rim(std::nextafter(4., 3.)) == Relation::touching);
  // An edge across the rim: of {x + z >= 8}, which leans on it at (5, 0, 3)
  const auto leaning = [&](double d) { return relate(c, HalfSpaces{{{half_spaces::Level{{1, 0, 1}, d}}}}); };
  CHECK(leaning(-8) == Relation::touching);
  CHECK(leaning(std::nextafter(-8., -9.)) == Relation::disjoint);
  CHECK(leaning(std::nextafter(-8., 0.)) == Relation::overlapping);
}

TEMPLATE_TEST_CASE("a cylinder lies in a box, or a box in the cylinder", "[cylinder_half_spaces]", float, double) {
  using S = TestType;
  const Cylinder<S> c = {{0, 0, -3}, {0, 0, 3}, 5};
  CHECK(relate(c, box({-5, -5, -3}, {5, 5, 3})) == Relation::a_inside_b);
  CHECK(relate(c, box({-5, -5, -3}, {5, std::nextafter(5., 4.), 3})) == Relation::overlapping);
  CHECK(relate(c, box({-5, -5, std::nextafter(-3., 0.)}, {5, 5, 3})) == Relation::overlapping);
  CHECK(relate(c, box({-3, -4, -3}, {3, 4, 3})) == Relation::b_inside_a);
  CHECK(relate(c, box({-3, -4, -3}, {3, std::nextafter(4., 5.), 3})) == Relation::overlapping);
  CHECK(relate(c, box({3, 4, 3}, {3, 4, 3})) == Relation::b_inside_a);    // a point of the rim
  CHECK(relate(c, box({0, 0, -9}, {0, 0, 9})) == Relation::overlapping);  // the axis, lengthened
  CHECK(relate(c, box({5, 0, -9}, {5, 0, 9})) == Relation::touching);     // a line of the side
  CHECK(relate(c, box({-9, -9, 3}, {9, 9, 3})) == Relation::touching);    // a plate on an end
  CHECK(relate(c, box({-9, -9, 2}, {9, 9, 2})) == Relation::overlapping);
  CHECK(relate(c, box({-4, 0, -3}, {4, 0, 3})) == Relation::b_inside_a);  // a plate
  CHECK(relate(c, {}) == Relation::a_inside_b);                           // all of space
}

TEMPLATE_TEST_CASE("a cylinder of radius 0 is a segment", "[cylinder_half_spaces]", float, double) {
  using S = TestType;
  const Cylinder<S> thin = {{0, 0, 0}, {0, 0, 3}, 0};
  CHECK(relate(thin, box({0, 0, 0}, {0, 0, 3})) == Relation::equal);
  CHECK(relate(thin, box({0, 0, 0}, {1, 1, 3})) == Relation::a_inside_b);
  CHECK(relate(thin, box({0, 0, 1}, {0, 0, 2})) == Relation::b_inside_a);
  CHECK(relate(thin, box({0, 0, 3}, {1, 1, 4})) == Relation::touching);
  CHECK(relate(thin, box({0, 0, 2}, {1, 1, 4})) == Relation::touching);  // along an edge
  CHECK(relate(thin, box({-1, -1, 2}, {1, 1, 4})) == Relation::overlapping);
  CHECK(relate(thin, box({std::numeric_limits<double>::denorm_min(), 0, 0}, {1, 1, 4})) == Relation::disjoint);
}

TEST_CASE("cylinder and half-spaces: the events tell how the shadow lies, and what lies inside",
          "[cylinder_half_spaces]") {
  Record<cylinder_half_spaces::Event> record;
  relate(Cylinder<double>{{0, 0, -3}, {0, 0, 3}, 5}, box({5, -1, -1}, {9, 1, 1}), record);
  std::erase_if(record.events, [](const auto& event) { return std::holds_alternative<Fallback>(event); });
  REQUIRE(record.events.size() == 2);
  CHECK(std::get<cylinder_half_spaces::Shadow>(record.events[0]).reach == 0);
  const auto& inside = std::get<cylinder_half_spaces::Contained>(record.events[1]);
  CHECK((!inside.round && !inside.other));
}

TEMPLATE_TEST_CASE("cylinder and half-spaces: verdicts are the true ones", "[cylinder_half_spaces]", float, double) {
  tests::half_spaces_round_pairs::check<TestType, Cylinder, cylinder_half_spaces::Event>();
}

TEST_CASE("a cylinder beside boxes, frusta and hulls", "[cylinder_half_spaces]") {
  tests::half_spaces_round_pairs::check_forms<Cylinder<double>>();
}

TEST_CASE("a cylinder lies alike however many faces the solid is given by", "[cylinder_half_spaces]") {
  tests::half_spaces_round_pairs::check_many_faces<Cylinder<double>>();
}

TEST_CASE("a cylinder beside a half-space, a segment and a point", "[cylinder_half_spaces]") {
  tests::half_spaces_round_pairs::check_thin_and_endless<Cylinder>();
}

TEST_CASE("cylinder and half-spaces: what is empty, NaN or infinite meets nothing", "[cylinder_half_spaces]") {
  tests::half_spaces_round_pairs::check_nothing(Cylinder<double>{{-3, 0, 0}, {3, 0, 0}, 2});
}

TEST_CASE("a cylinder that is turned round lies alike", "[cylinder_half_spaces]") {
  bench::Random random(tests::seed());
  for (const auto& family : bench::solid_and_kdop_draws<double, Cylinder>)
    for (int i = 0; i < tests::cases(100, 10000); ++i) {
      INFO("seed " << tests::seed() << ", family " << family.name << ", case " << i);
      const auto c = family.draw(random);
      const HalfSpaces solid = half_spaces_of(c.b);
      REQUIRE(relate(Cylinder<double>{c.a.q, c.a.p, c.a.radius}, solid) == relate(c.a, solid));
    }
}

}  // namespace cylinder_half_spaces_test
