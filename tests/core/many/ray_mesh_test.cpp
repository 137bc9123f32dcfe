// Prepared meshes against isect/triangle_mesh.h, and their parts against what they are a bound of.

#include <isect/many/ray_mesh.h>

#include <limits>

#include "tests/catch.h"
#include "tests/core/meshes.h"
#include "tests/settings.h"

namespace ray_mesh_test {
using namespace isect;
using bench::Random;
using tests::aimed, tests::ball, tests::brute_force, tests::soup;

TEMPLATE_TEST_CASE("a prepared mesh gets the answers of the mesh, from any numbers", "[ray_mesh]", float, double) {
  using S = TestType;
  Random random(tests::seed());
  int hits = 0, misses = 0, wide = 0;
  for (int i = 0; i < tests::cases(2000, 100'000); ++i) {
    const auto numbers = bench::all_numbers[random.below(static_cast<int>(std::size(bench::all_numbers)))];
    const TriangleMesh<S> mesh = soup<S>(random, numbers);
    const RayMesh<S> prepared = make_ray_mesh(mesh);
    wide += prepared.nodes.size() > 1;
    for (int j = 0; j < 5; ++j) {
      const Ray<S, 3> ray = aimed(random, mesh, numbers);
      INFO("seed " << tests::seed() << ", mesh " << i << ", ray " << j);
      const auto closest = closest_hit(prepared, ray);
      REQUIRE(closest == brute_force(mesh, ray));
      REQUIRE(any_hit(prepared, ray) == closest.has_value());
      ++(closest ? hits : misses);
    }
  }
  CHECK(hits > 1000);
  CHECK(misses > 1000);
  CHECK(wide > 100);
}

TEMPLATE_TEST_CASE("a large prepared mesh, far and near, gets the answers of the mesh", "[ray_mesh]", float, double) {
  using S = TestType;
  Random random(tests::seed());
  int hits = 0, misses = 0;
  for (const double away : {0.0, 1.0, 1000.0, 1e6}) {
    const Vector<double, 3> center = {away, -2 * away, away / 3};
    const double radius = away > 1e5 ? 100 : 3;
    const TriangleMesh<S> mesh = ball<S>(40, 61, center, radius);
    const Bvh<S, 3> bvh = build_bvh(boxes(mesh));
    const RayMesh<S> prepared = make_ray_mesh(mesh);
    for (int i = 0; i < tests::cases(1000, 100'000); ++i) {
      const Point<S, 3> from = (center + random.in_box<3>(2 * radius)).template cast<S>();
      const auto& [a, b, c] = triangle(mesh, random.below(static_cast<int>(mesh.triangles.size()))).vertices;
      const S w = static_cast<S>(random.unit());
      const Point<S, 3> target = random.one_in(3) ? a
                                 : random.one_in(2)
                                     ? Point<S, 3>(a + w * (b - a))
                                     : Point<S, 3>(center.cast<S>() + random.in_box<3>(2 * radius).cast<S>());
      Ray<S, 3> ray = {from, target - from};
      if (random.one_in(3)) ray.direction[random.below(3)] = S(0);
      if (random.one_in(4)) ray.range = infinite<S>;
      if (random.one_in(4)) ray.range = {S(-0.5), S(1)};
      INFO("seed " << tests::seed() << ", away " << away << ", case " << i);
      const auto closest = closest_hit(bvh, mesh, ray);
      REQUIRE(closest_hit(prepared, ray) == closest);
      REQUIRE(any_hit(prepared, ray) == closest.has_value());
      ++(closest ? hits : misses);
    }
  }
  CHECK(hits > 500);
  CHECK(misses > 100);
}

TEST_CASE("what is not finite is not hit, and leaves the rest", "[ray_mesh]") {
  const Ray<double, 3> ray = {{0, 0, 5}, {0, 0, -1}};
  TriangleMesh<double> mesh;
  CHECK(!closest_hit(make_ray_mesh(mesh), ray));
  CHECK(!any_hit(make_ray_mesh(mesh), ray));
  mesh = {{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, 0, std::numeric_limits<double>::quiet_NaN()}},
          {{0, 1, 3}, {0, 1, 2}}};
  const RayMesh<double> prepared = make_ray_mesh(mesh);
  CHECK(closest_hit(prepared, ray) == BvhHit<double>{5, 1});
  CHECK(any_hit(prepared, ray));
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(!any_hit(prepared, Ray<double, 3>{{0, 0, 5}, {0, 0, -infinity}}));
  CHECK(!any_hit(prepared, Ray<double, 3>{{0, 0, 5}, {0, 0, -1}, {6, 4}}));
  CHECK(!any_hit(prepared, Ray<double, 3>{{0, 0, 5}, {0, 0, 0}}));
}

TEST_CASE("rounding down and up brackets any number", "[ray_mesh]") {
  Random random(tests::seed());
  for (const auto numbers : bench::all_numbers)
    for (int i = 0; i < 2000; ++i) {
      const double x = bench::number<double>(random, numbers);
      if (std::abs(x) > std::numeric_limits<float>::max()) continue;
      REQUIRE(double{ray_mesh::detail::down(x)} < x);
      REQUIRE(double{ray_mesh::detail::up(x)} > x);
      REQUIRE(std::abs(double{ray_mesh::detail::up(x)} - x) <= 0x1p-22 * std::abs(x) + 0x1p-147);
    }
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(ray_mesh::detail::down(-infinity) == -infinity);
  CHECK(ray_mesh::detail::up(infinity) == infinity);
}

TEST_CASE("the screen is sure of the truth only, and nearly always sure", "[ray_mesh]") {
  Random random(tests::seed());
  int sure = 0, missed = 0, all = 0;
  for (const auto numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(1000, 50'000); ++i) {
      const TriangleMesh<double> mesh = soup<double>(random, numbers);
      const Ray<double, 3> ray = aimed(random, mesh, numbers);
      if (!finite(ray)) continue;
      const Triangle<double, 3> two[2] = {triangle(mesh, 0),
                                          triangle(mesh, static_cast<int>(mesh.triangles.size()) - 1)};
      if (!finite(two[0]) || !finite(two[1])) continue;
      double reach = 0;
      for (const auto& x : two)
        for (const auto& v : x.vertices) reach = std::max(reach, v.cwiseAbs().maxCoeff());
      const auto verdicts = ray_mesh::detail::Screen(ray, reach)(two[0], two[1]);
      for (int k = 0; k < 2; ++k) {
        const auto side = ray_triangle::detail::volumes(ray, two[k], NoTrace());
        const int most = std::max({side.a, side.b, side.c}), least = std::min({side.a, side.b, side.c});
        INFO("seed " << tests::seed() << ", family " << static_cast<int>(numbers) << ", case " << i);
        if (verdicts[k].missed) REQUIRE((most == 1 && least == -1));
        if (verdicts[k].sign != 0) REQUIRE((most == verdicts[k].sign && least == verdicts[k].sign));
        missed += verdicts[k].missed, sure += verdicts[k].sign != 0, ++all;
      }
    }
  CHECK(missed > all / 20);
  CHECK(sure > all / 100);
}

}  // namespace ray_mesh_test
