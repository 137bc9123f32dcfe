// No verdict between two shapes touches the heap: on integers, where shapes touch, on tenths, and on doubles of like
// size, where all stages of the ladder are asked.

#include <isect/aabb_aabb.h>
#include <isect/capsule_capsule.h>
#include <isect/obb_obb.h>
#include <isect/orient.h>
#include <isect/plane_aabb.h>
#include <isect/plane_sphere.h>
#include <isect/point_obb.h>
#include <isect/point_point.h>
#include <isect/point_sphere.h>
#include <isect/ray_aabb.h>
#include <isect/ray_obb.h>
#include <isect/ray_plane.h>
#include <isect/ray_sphere.h>
#include <isect/ray_triangle.h>
#include <isect/segment_segment.h>
#include <isect/sphere_aabb.h>
#include <isect/sphere_capsule.h>
#include <isect/sphere_sphere.h>
#include <isect/triangle_aabb.h>

#include <array>
#include <cmath>
#include <memory>

#include "bench/random.h"
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
  Aabb<double, 3> box() const {
    const Vec a = vec(), b = vec();
    return {a.cwiseMin(b), a.cwiseMax(b)};
  }
  /// Turned by the angle of the triangle 3, 4, 5, so that axes meet on integers, too.
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

}  // namespace

TEST_CASE("the count of calls of the heap can fail", "[allocations]") {
  const std::size_t before = heap::calls;
  const auto kept = std::make_unique<int>(1);
  CHECK(heap::calls == before + *kept);
}

TEST_CASE("no verdict on integers asks for memory", "[allocations]") {
  ask_all([](bench::Random& random) -> double { return random.integer(-4, 4); });
}

TEST_CASE("no verdict on tenths asks for memory", "[allocations]") {
  ask_all([](bench::Random& random) { return random.integer(-9, 9) / 10.0; });
}

TEST_CASE("no verdict on doubles of like size asks for memory", "[allocations]") {
  ask_all([](bench::Random& random) { return random.uniform(-1, 1); });
}

TEST_CASE("no verdict on a few doubles of 53 bits, where ties go to the end of the ladder, asks for memory",
          "[allocations]") {
  bench::Random random(tests::seed());
  std::array<double, 4> few{};
  for (double& x : few) x = random.uniform(-1, 1);
  ask_all([few](bench::Random& r) { return few[static_cast<std::size_t>(r.below(4))] * r.integer(-1, 1); });
}

}  // namespace allocations_test
