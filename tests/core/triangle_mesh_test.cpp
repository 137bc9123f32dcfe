#include <isect/triangle_mesh.h>

#include <limits>
#include <numbers>

#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/core/meshes.h"
#include "tests/settings.h"

namespace triangle_mesh_test {
using namespace isect;
using bench::Random;
using oracle::Rational;
using tests::aimed, tests::ball, tests::brute_force, tests::soup;
using oracle::operator-;  // of coordinates

namespace {

/// The true t, by Cramer's rule in rationals.
template <class S>
std::optional<Rational> truth(const Ray<S, 3>& ray, const Triangle<S, 3>& triangle) {
  const auto o = oracle::rational<S, 3>(ray.origin), d = oracle::rational<S, 3>(ray.direction),
             a = oracle::rational<S, 3>(triangle.vertices[0]);
  const auto e1 = oracle::rational<S, 3>(triangle.vertices[1]) - a,
             e2 = oracle::rational<S, 3>(triangle.vertices[2]) - a;
  const auto p = oracle::cross(d, e2), from = o - a, q = oracle::cross(from, e1);
  const Rational determinant = oracle::dot(p, e1);
  if (determinant == 0) return {};
  const Rational u = oracle::dot(from, p) / determinant, v = oracle::dot(d, q) / determinant,
                 t = oracle::dot(e2, q) / determinant;
  if (u < 0 || v < 0 || u + v > 1 || !oracle::holds(ray.range, t)) return {};
  return t;
}

}  // namespace

TEMPLATE_TEST_CASE("a mesh is valid when its indices name vertices", "[triangle_mesh]", float, double) {
  TriangleMesh<TestType> mesh = ball<TestType>(4, 6, {0, 0, 0}, 1);
  CHECK(valid(mesh));
  CHECK(mesh.triangles.size() == 2u * 6 * 3);
  mesh.triangles[3][1] = static_cast<int>(mesh.vertices.size());
  CHECK(!valid(mesh));
  mesh.triangles[3][1] = -1;
  CHECK(!valid(mesh));
  CHECK(valid(TriangleMesh<TestType>{}));
}

TEMPLATE_TEST_CASE("an empty mesh is not hit, nor is one of NaN", "[triangle_mesh]", float, double) {
  using S = TestType;
  const Ray<S, 3> ray = {{S(0), S(0), S(5)}, {S(0), S(0), S(-1)}};
  TriangleMesh<S> mesh;
  CHECK(!closest_hit(build_bvh(boxes(mesh)), mesh, ray));
  mesh = ball<S>(4, 6, {0, 0, 0}, 1);
  CHECK(closest_hit(build_bvh(boxes(mesh)), mesh, ray));
  for (auto& vertex : mesh.vertices) vertex[2] = std::numeric_limits<S>::quiet_NaN();
  CHECK(!closest_hit(build_bvh(boxes(mesh)), mesh, ray));
  CHECK(!any_hit(build_bvh(boxes(mesh)), mesh, ray));
}

TEMPLATE_TEST_CASE("a ray through a shared edge hits the triangle of the least index", "[triangle_mesh]", float,
                   double) {
  using S = TestType;
  const TriangleMesh<S> mesh = {{{S(0), S(0), S(0)}, {S(1), S(0), S(0)}, {S(1), S(1), S(0)}, {S(0), S(1), S(0)}},
                                {{0, 2, 3}, {0, 1, 2}}};
  const Bvh<S, 3> bvh = build_bvh(boxes(mesh), {1});
  const Ray<S, 3> edge = {{S(0.5), S(0.5), S(3)}, {S(0), S(0), S(-2)}},
                  corner = {{S(1), S(0), S(3)}, {S(0), S(0), S(-2)}};
  CHECK(closest_hit(bvh, mesh, edge) == BvhHit<S>{S(1.5), 0});
  CHECK(closest_hit(bvh, mesh, corner) == BvhHit<S>{S(1.5), 1});
  const Ray<S, 3> coplanar = {{S(-1), S(0.5), S(0)}, {S(1), S(0), S(0)}};
  CHECK(!any_hit(bvh, mesh, coplanar));
}

TEMPLATE_TEST_CASE("no ray slips between the triangles of a closed mesh", "[triangle_mesh]", float, double) {
  using S = TestType;
  Random random(tests::seed());
  for (const double away : {0.0, 1.0, 1000.0, 1e6}) {
    const Vector<double, 3> center = {away, -2 * away, away / 3};
    const double radius = away > 1e5 ? 100 : 3;
    const TriangleMesh<S> mesh = ball<S>(14, 23, center, radius);
    const Bvh<S, 3> bvh = build_bvh(boxes(mesh));
    for (int i = 0; i < tests::cases(500, 100'000); ++i) {
      const Point<S, 3> inside = (center + random.in_box<3>(radius / 4)).template cast<S>();
      const auto& [a, b, c] = triangle(mesh, random.below(static_cast<int>(mesh.triangles.size()))).vertices;
      const S w = static_cast<S>(random.unit());
      const Point<S, 3> target = random.one_in(3)   ? a
                                 : random.one_in(2) ? Point<S, 3>(a + w * (b - a))
                                                    : Point<S, 3>(b + w * (c - b));
      Ray<S, 3> ray = {inside, target - inside};
      INFO("seed " << tests::seed() << ", away " << away << ", case " << i);
      const auto hit = closest_hit(bvh, mesh, ray);
      REQUIRE(hit);
      REQUIRE(hit->t > S(0));
      REQUIRE(any_hit(bvh, mesh, ray));
      ray.range = infinite<S>;  // the other side as well
      REQUIRE(closest_hit(bvh, mesh, ray)->t < S(0));
    }
  }
}

TEMPLATE_TEST_CASE("the closest hit on a mesh is the true one", "[triangle_mesh]", float, double) {
  using S = TestType;
  Random random(tests::seed());
  int hits = 0, misses = 0, shared = 0;
  for (int i = 0; i < tests::cases(300, 6000); ++i) {
    const auto numbers = bench::all_numbers[random.below(static_cast<int>(std::size(bench::all_numbers)))];
    const TriangleMesh<S> mesh = soup<S>(random, numbers);
    const Bvh<S, 3> bvh = build_bvh(boxes(mesh), {random.integer(1, 3), 1});
    for (int j = 0; j < 5; ++j) {
      const Ray<S, 3> ray = aimed(random, mesh, numbers);
      INFO("seed " << tests::seed() << ", mesh " << i << ", ray " << j);
      const auto closest = closest_hit(bvh, mesh, ray);
      REQUIRE(closest == brute_force(mesh, ray));
      REQUIRE(any_hit(bvh, mesh, ray) == closest.has_value());
      const std::vector<BvhHit<S>> all = all_hits(bvh, mesh, ray);
      REQUIRE(all.empty() == !closest);
      if (closest) REQUIRE(all.front() == *closest);
      REQUIRE(std::ranges::is_sorted(all, {}, &BvhHit<S>::t));

      std::optional<Rational> least;
      int at_least = 0;
      for (int k = 0; k < static_cast<int>(mesh.triangles.size()); ++k) {
        const auto t = truth(ray, triangle(mesh, k));
        REQUIRE(std::ranges::count(all, k, &BvhHit<S>::primitive) == (t ? 1 : 0));
        if (!t || (least && *t > *least)) continue;
        at_least = least && *t == *least ? at_least + 1 : 1;
        least = *t;
      }
      REQUIRE(closest.has_value() == least.has_value());
      ++(closest ? hits : misses);
      if (!closest) continue;
      shared += at_least > 1;
      REQUIRE(oracle::ulps(closest->t, *least) <= 2);
      const auto own = truth(ray, triangle(mesh, closest->primitive));
      REQUIRE(own);
      REQUIRE(oracle::ulps(closest->t, *own) <= 2);
    }
  }
  CHECK(hits > 300);
  CHECK(misses > 100);
  CHECK(shared > 50);
}

}  // namespace triangle_mesh_test
