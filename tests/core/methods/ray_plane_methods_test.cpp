#include <isect/methods/ray_plane.h>

#include "bench/ray_plane/families.h"
#include "bench/ray_plane/oracle.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace ray_plane_methods_test {
using namespace isect;
using namespace isect::ray_plane;

TEMPLATE_TEST_CASE("a point of the plane gives the same t on ordinary rays", "[ray_plane_methods]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  int hits = 0;
  for (int i = 0; i < tests::cases(2000, 100000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const auto [ray, plane, point] = bench::ray_plane_families::ordinary<S>(random);
    const auto t = towards_point(ray, plane.normal, point, S(0));
    const oracle::RayPlane truth = oracle::ray_plane(ray, plane);
    const S heading = plane.normal.dot(ray.direction);
    if (std::abs(heading) < S(0.1)) continue;
    if (truth.meets != t.has_value() && abs(*truth.line) > 1e-5) FAIL("wrong");
    if (t && oracle::ulps(*t, *truth.line) * static_cast<double>(*t) > 500) FAIL("inaccurate");
    hits += t.has_value();
  }
  CHECK(hits > 100);
}

TEST_CASE("far away a point of the plane keeps what the note's formula loses", "[ray_plane_methods]") {
  const Point<float, 3> point = {1e6f, 1e6f, 1e6f};
  const Vector<float, 3> normal = {1, 3, 7};
  const Plane<float, 3> plane = {normal, -11e6f};
  const Ray<float, 3> ray = {point - Vector<float, 3>(.125f, .5f, .25f), {1, 1, 1}};
  CHECK(towards_point(ray, normal, point, 0.f) == 3.375f / 11);
  CHECK(*intersect(ray, plane).t == 3.375f / 11);
  CHECK(std::abs(*textbook(ray, plane) - 3.375f / 11) > 0.01f);
}

TEST_CASE("an epsilon misses planes by the length of their normal", "[ray_plane_methods]") {
  const Ray<double, 3> ray = {{0, 0, 1}, {0, 0, -1}};
  const Point<double, 3> point = {5, 5, 0};
  CHECK(towards_point<double, 3>(ray, {0, 0, 1e-7}, point, 0) == 1.);
  CHECK_FALSE(towards_point<double, 3>(ray, {0, 0, 1e-7}, point, 1e-6));
  CHECK_FALSE(towards_point<double, 3>(ray, {1, 0, 0}, point, 0));
  CHECK_FALSE(towards_point<double, 3>({{0, 0, -1}, {0, 0, -1}}, {0, 0, 1}, point, 0));  // behind
}

TEST_CASE("the events tell the vector and both products", "[ray_plane_methods]") {
  Record<MethodEvent<double, 3>> record;
  towards_point<double, 3>({{0, 0, 1}, {0, 0, -2}}, {0, 0, 1}, {5, 5, 0}, 0, record);
  REQUIRE(record.events.size() == 5);
  CHECK(std::get<ToPoint<double, 3>>(record.events[0]).w == Vector<double, 3>(5, 5, -1));
  CHECK(std::get<Numerator<double>>(record.events[1]).value == -1);
  CHECK(std::get<Denominator<double>>(record.events[2]).value == -2);
  CHECK(std::get<InRange<double>>(record.events[4]).t == 0.5);
}

}  // namespace ray_plane_methods_test
