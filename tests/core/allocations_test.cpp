// No verdict between two shapes touches the heap: on integers, where shapes touch, on tenths, on doubles of like size,
// where all stages of the ladder are asked, and in every hard family.

#include <isect/aabb_aabb.h>
#include <isect/capsule_capsule.h>
#include <isect/obb_obb.h>
#include <isect/orient.h>
#include <isect/plane_aabb.h>
#include <isect/plane_cone.h>
#include <isect/plane_cylinder.h>
#include <isect/plane_sphere.h>
#include <isect/point_cone.h>
#include <isect/point_cylinder.h>
#include <isect/point_obb.h>
#include <isect/point_point.h>
#include <isect/point_polygon.h>
#include <isect/point_sphere.h>
#include <isect/ray_aabb.h>
#include <isect/ray_cone.h>
#include <isect/ray_cylinder.h>
#include <isect/ray_obb.h>
#include <isect/ray_plane.h>
#include <isect/ray_polygon.h>
#include <isect/ray_sphere.h>
#include <isect/ray_triangle.h>
#include <isect/segment_segment.h>
#include <isect/sphere_aabb.h>
#include <isect/sphere_capsule.h>
#include <isect/sphere_cone.h>
#include <isect/sphere_cylinder.h>
#include <isect/sphere_sphere.h>
#include <isect/triangle_aabb.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "bench/capsule_capsule/families.h"
#include "bench/obb_obb/families.h"
#include "bench/orient2d/families.h"
#include "bench/plane_cylinder/families.h"
#include "bench/point_cylinder/families.h"
#include "bench/point_polygon/families.h"
#include "bench/random.h"
#include "bench/ray_aabb/families.h"
#include "bench/ray_cylinder/families.h"
#include "bench/ray_obb/families.h"
#include "bench/ray_plane/families.h"
#include "bench/ray_polygon/families.h"
#include "bench/ray_sphere/families.h"
#include "bench/ray_triangle/families.h"
#include "bench/sphere_aabb/families.h"
#include "bench/sphere_capsule/families.h"
#include "bench/sphere_cylinder/families.h"
#include "bench/sphere_sphere/families.h"
#include "bench/triangle_aabb/families.h"
#include "tests/catch.h"
#include "tests/core/heap.h"
#include "tests/settings.h"

namespace allocations_test {
using namespace isect;

namespace {

using Vec = Vector<double, 3>;

/// Shapes whose coordinates come from one kind of number.
template <class Number>
struct Draw {
  bench::Random& random;
  const Number& number;

  double size() const { return std::abs(number(random)); }
  Vec vec() const { return {number(random), number(random), number(random)}; }
  Vec heading() const {
    for (;;)
      if (const Vec v = vec(); v.norm() > 0) return v;
  }
  Ray<double, 3> ray() const { return {vec(), heading()}; }
  Sphere<double, 3> sphere() const { return {vec(), size()}; }
  Capsule<double, 3> capsule() const { return {vec(), vec(), size()}; }
  Plane<double, 3> plane() const { return {heading(), number(random)}; }
  Triangle<double, 3> triangle() const { return {{vec(), vec(), vec()}}; }
  Segment<double, 2> segment() const { return {point(), point()}; }
  Point<double, 2> point() const { return {number(random), number(random)}; }
  Ring<double, 3> ring() const { return {vec(), vec(), vec(), vec(), vec()}; }
  Aabb<double, 3> box() const {
    const Vec a = vec(), b = vec();
    return {a.cwiseMin(b), a.cwiseMax(b)};
  }
  /// An oriented box turned by the angle of the triangle 3, 4, 5, so that axes meet on integers, too.
  Obb<double, 3> obb() const {
    Eigen::Matrix3d axes;
    axes << 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1;
    return {vec(), axes, {size(), size(), size()}};
  }
};

template <class Number>
void ask_all(const Number& number) {
  bench::Random random(tests::seed());
  const Draw<Number> d{random, number};
  int said = 0;  // so that nothing is left out
  const int cases = tests::cases(2000, 200000);
  const std::size_t before = heap::calls;
  for (int i = 0; i < cases; ++i) {
    said += orient2d(d.point(), d.point(), d.point());
    said += orient3d(d.vec(), d.vec(), d.vec(), d.vec());
    said += equal(d.vec(), d.vec()) + nearly_equal(d.vec(), d.vec(), d.size());
    said += static_cast<int>(relate(d.box(), d.box())) + static_cast<int>(relate(d.sphere(), d.sphere()));
    said += static_cast<int>(relate(d.sphere(), d.box())) + static_cast<int>(relate(d.sphere(), d.capsule()));
    said += static_cast<int>(relate(d.capsule(), d.capsule())) + static_cast<int>(relate(d.obb(), d.obb()));
    said += static_cast<int>(relate(d.plane(), d.sphere())) + static_cast<int>(relate(d.plane(), d.box()));
    said += static_cast<int>(locate(d.vec(), d.sphere())) + static_cast<int>(locate(d.vec(), d.obb()));
    said += intersects(d.triangle(), d.box()) + intersects(d.segment(), d.segment());
    said += intersect(d.ray(), d.sphere()).line_roots + intersects(d.ray(), d.box()) + intersects(d.ray(), d.obb());
    said += bool(intersect(d.ray(), d.plane())) + bool(intersect(d.ray(), d.triangle()));
  }
  const std::size_t after = heap::calls;
  INFO("answers add up to " << said);
  CHECK(after == before);
}

/// Checks polygons. They are drawn before the calls are counted, as their vertices stand on the heap.
template <class Number>
void ask_polygons(const Number& number) {
  bench::Random random(tests::seed());
  const Draw<Number> d{random, number};
  int said = 0;
  std::size_t calls = 0;
  const int cases = tests::cases(1000, 100000);
  for (int i = 0; i < cases; ++i) {
    const Ring<double, 3> ring = d.ring();
    Ring<double, 2> outline;
    for (const Vec& v : ring) outline.emplace_back(v[0], v[1]);
    const Ray<double, 3> ray = d.ray();
    const Point<double, 2> point = d.point();
    const std::size_t before = heap::calls;
    said += bool(intersect(ray, ring)) + winding(point, outline).winding;
    calls += heap::calls - before;
  }
  INFO("answers add up to " << said);
  CHECK(calls == 0);
}

/// Asks every family's cases; `ask` returns some part of the answer.
template <class Draws, class Ask>
void ask_families(const Draws& draws, const Ask& ask) {
  const int cases = tests::cases(300, 30000);
  for (const auto& family : draws) {
    bench::Random random(tests::seed());
    int said = 0;
    std::size_t calls = 0;
    for (int i = 0; i < cases; ++i) {
      const auto c = family.draw(random);
      const std::size_t before = heap::calls;
      said += static_cast<int>(ask(c));
      calls += heap::calls - before;
    }
    INFO(family.name << ": answers add up to " << said);
    CHECK(calls == 0);
  }
}

constexpr auto related = [](const auto& c) { return relate(c.a, c.b); };

}  // namespace

TEST_CASE("the count of calls of the heap can fail", "[allocations]") {
  const std::size_t before = heap::calls;
  const auto kept = std::make_unique<int>(1);
  CHECK(heap::calls == before + *kept);
}

TEST_CASE("no verdict on integers asks for memory", "[allocations]") {
  const auto integer = [](bench::Random& random) -> double { return random.integer(-4, 4); };
  ask_all(integer);
  ask_polygons(integer);
}

TEST_CASE("no verdict on tenths asks for memory", "[allocations]") {
  const auto tenth = [](bench::Random& random) { return random.integer(-9, 9) / 10.0; };
  ask_all(tenth);
  ask_polygons(tenth);
}

TEST_CASE("no verdict on doubles of like size asks for memory", "[allocations]") {
  const auto any = [](bench::Random& random) { return random.uniform(-1, 1); };
  ask_all(any);
  ask_polygons(any);
}

TEST_CASE("no verdict on a few doubles of 53 bits, where ties go to the end of the ladder, asks for memory",
          "[allocations]") {
  bench::Random random(tests::seed());
  std::array<double, 4> few{};
  for (double& x : few) x = random.uniform(-1, 1);
  const auto one = [few](bench::Random& r) { return few[static_cast<std::size_t>(r.below(4))] * r.integer(-1, 1); };
  ask_all(one);
  ask_polygons(one);
}

TEMPLATE_TEST_CASE("no verdict in a hard family asks for memory", "[allocations]", float, double) {
  using S = TestType;
  ask_families(bench::sphere_sphere_draws<S>, related);
  ask_families(bench::sphere_aabb_draws<S>, related);
  ask_families(bench::sphere_capsule_draws<S>, related);
  ask_families(bench::capsule_capsule_draws<S>, related);
  ask_families(bench::obb_obb_draws<S>, related);
  ask_families(bench::triangle_aabb_draws<S>, related);
  ask_families(bench::ray_sphere_families<S, 3>(), [](const auto& c) { return bool(intersect(c.ray, c.sphere)); });
  ask_families(bench::ray_plane_draws<S>, [](const auto& c) { return bool(intersect(c.ray, c.plane)); });
  ask_families(bench::ray_polygon_draws<S>, [](const auto& c) { return bool(intersect(c.a, c.b)); });
  ask_families(bench::ray_triangle_draws<S>, [](const auto& c) { return bool(intersect(c.a, c.b)); });
  ask_families(bench::ray_aabb_draws<S>, [](const auto& c) { return bool(intersect(c.a, c.b)); });
  ask_families(bench::ray_obb_draws<S>, [](const auto& c) { return bool(intersect(c.a, c.b)); });
  const auto located = [](const auto& c) { return locate(c.a, c.b); };
  const auto hit = [](const auto& c) { return bool(intersect(c.a, c.b)); };
  ask_families(bench::point_cylinder_draws<S>, located);
  ask_families(bench::point_cone_draws<S>, located);
  ask_families(bench::plane_cylinder_draws<S>, related);
  ask_families(bench::plane_cone_draws<S>, related);
  ask_families(bench::ray_cylinder_draws<S>, hit);
  ask_families(bench::ray_cone_draws<S>, hit);
  ask_families(bench::sphere_cylinder_draws<S>, related);
  ask_families(bench::sphere_cone_draws<S>, related);
  std::vector<bench::PolygonFamily<S>> polygons;
  for (const char* name : {"ordinary", "near-edge", "on-vertex", "horizontal", "degenerate", "bow-tie", "far 1e8",
                           "near-horizontal", "near-vertical", "coincident"})
    polygons.push_back(bench::polygon_family<S>(name, 20));
  ask_families(polygons, [](const auto& c) { return winding(c.point, *c.ring).winding; });
  const auto wide = [](const Point<S, 2>& p) { return Point<double, 2>(p.template cast<double>()); };
  ask_families(bench::orient2d_draws<S>, [&](const auto& c) { return orient2d(wide(c.a), wide(c.b), wide(c.c)); });
}

}  // namespace allocations_test
