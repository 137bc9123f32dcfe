#include "viz/player/pick.h"

#include "tests/catch.h"
#include "viz/solids.h"

namespace pick_test {
using namespace isect;
using namespace isect::viz;

namespace {

const View::ViewingRay along_z = {{0.25, 0.125, 10}, {0, 0, -1}};

Scene scene() {
  Scene s;
  s.items = {Ball{{0, 0, 0}, 1, Role::first}, Label{{0, 0, 5}, "a label is not picked", Role::text},
             solid(Aabb<double, 3>{{-1, -1, 2}, {1, 1, 3}}, Role::second),
             Region{{{{-2, -2, 5}, {2, -2, 5}, {2, 2, 5}, {-2, 2, 5}}, {{0, 0, 5}, {1, 0, 5}, {1, 1, 5}, {0, 1, 5}}}},
             Mesh{{{0, 0, 4}, {1, 0, 4}, {0, 1, 4}}, {{0, 1, 2}}, Role::first}};
  return s;
}

}  // namespace

TEST_CASE("the first item along the viewing ray is picked, where the line meets it", "[pick]") {
  Scene s = scene();
  auto picked = pick(s, along_z);  // through the region's hole
  REQUIRE(picked);
  CHECK(std::holds_alternative<Mesh>(*picked->item));
  CHECK(picked->at == Vec3(0.25, 0.125, 4));
  s.items.pop_back();
  picked = pick(s, along_z);
  REQUIRE(picked);
  CHECK(std::holds_alternative<Solid>(*picked->item));
  CHECK(picked->at.z() == 3);
  picked = pick(s, {{-0.25, 0.125, 10}, {0, 0, -2}});  // beside the hole
  REQUIRE(picked);
  CHECK(std::holds_alternative<Region>(*picked->item));
}

TEST_CASE("what lies behind the eye or beside the line is not picked", "[pick]") {
  CHECK_FALSE(pick(scene(), {{0.25, 0.125, -2}, {0, 0, -1}}));
  CHECK_FALSE(pick(scene(), {{3, 0, 10}, {0, 0, -1}}));
}

TEST_CASE("of two items met at the same place the later one is picked", "[pick]") {
  Scene s;
  s.items = {Ball{{0, 0, 0}, 1, Role::first}, Ball{{0, 0, -1}, 2, Role::second}};
  const auto picked = pick(s, {{0, 0, 10}, {0, 0, -1}});
  REQUIRE(picked);
  CHECK(std::get<Ball>(*picked->item).radius == 2);
}

}  // namespace pick_test
