// Volumes against rationals, areas of known solids, and what fits leave void.

#include <isect/volume.h>

#include <Eigen/Geometry>
#include <cstdio>
#include <limits>

#include <isect/aabb_aabb.h>
#include <isect/directions.h>
#include <isect/fit_tight.h>
#include <isect/kdop_kdop.h>
#include <isect/obb_obb.h>
#include <isect/sphere_sphere.h>
#include "bench/growth.h"
#include "bench/random_shapes.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace volume_test {
using namespace isect;
using oracle::Rational;
using oracle::operator-;

namespace {

template <class S>
std::vector<Point<S, 3>> brick(S x, S y, S z) {
  std::vector<Point<S, 3>> corners;
  for (int i = 0; i < 8; ++i) corners.push_back(Point<S, 3>(i & 1 ? x : S(0), i & 2 ? y : S(0), i & 4 ? z : S(0)));
  return corners;
}

}  // namespace

TEMPLATE_TEST_CASE("a brick has its volume and its surface, whatever bounds it", "[volume]", float, double) {
  using S = TestType;
  for (const int exponent : {0, 30, -30}) {
    const S k = std::ldexp(S(1), exponent);
    const std::vector<Point<S, 3>> points = brick<S>(1 * k, 2 * k, 3 * k);
    const Aabb<S, 3> box = fit_aabb(points);
    const Hull3<S> hull = convex_hull(points);
    const Kdop<S, 3> kdop = fit_kdop(points, directions<S, 3>(14));
    CHECK(volume(box) == 6 * k * k * k);
    CHECK(surface_area(box) == 22 * k * k);
    CHECK(volume(hull) == 6 * k * k * k);
    CHECK(surface_area(hull) == 22 * k * k);
    CHECK(volume(kdop) == 6 * k * k * k);
    CHECK(surface_area(kdop) == 22 * k * k);
    Obb<S, 3> obb = {(box.lo + box.hi) / 2, Eigen::Matrix<S, 3, 3>::Identity(), (box.hi - box.lo) / 2};
    CHECK(volume(obb) == 6 * k * k * k);
    CHECK(surface_area(obb) == 22 * k * k);
    obb.axes *= S(2);  // axes are taken literally
    CHECK(volume(obb) == 48 * k * k * k);
    CHECK(surface_area(obb) == 88 * k * k);
    CHECK(void_volume(box, volume(hull)) == 0);
    CHECK(void_volume(fit_sphere_smallest(points), volume(hull)) > 0);
  }
}

TEMPLATE_TEST_CASE("balls and figures of the plane have theirs", "[volume]", float, double) {
  using S = TestType;
  CHECK(volume(Sphere<S, 3>{{0, 0, 0}, 2}) == Approx(33.510321638291124));
  CHECK(surface_area(Sphere<S, 3>{{0, 0, 0}, 2}) == Approx(50.26548245743669));
  CHECK(volume(Sphere<S, 2>{{0, 0}, 2}) == Approx(12.566370614359172));
  CHECK(surface_area(Sphere<S, 2>{{0, 0}, 2}) == Approx(12.566370614359172));
  CHECK(volume(Aabb<S, 2>{{0, 0}, {2, 3}}) == 6);
  CHECK(surface_area(Aabb<S, 2>{{0, 0}, {2, 3}}) == 10);
  CHECK(surface_area(Obb<S, 2>{{0, 0}, Eigen::Matrix<S, 2, 2>::Identity(), {1, 2}}) == 12);
  const Kdop<S, 2> diamond = {directions<S, 2>(8), {{-1, 1}, {-1, 1}, {-1, 1}, {-1, 1}}};
  CHECK(volume(diamond) == 2);
  CHECK(surface_area(diamond) == Approx(4 * std::sqrt(2.0)));
}

TEMPLATE_TEST_CASE("what is empty has no volume, and NaN has NaN", "[volume]", float, double) {
  using S = TestType;
  constexpr S nan = std::numeric_limits<S>::quiet_NaN(), inf = std::numeric_limits<S>::infinity();
  CHECK(volume(Aabb<S, 3>{{0, 0, 0}, {1, -1, 1}}) == 0);
  CHECK(volume(Sphere<S, 3>{{0, 0, 0}, -1}) == 0);
  CHECK(volume(convex_hull(std::vector<Point<S, 3>>{})) == 0);
  CHECK(volume(Kdop<S, 2>{directions<S, 2>(8), {{0, 1}, {0, 1}, {3, 4}, {0, 1}}}) == 0);  // contradictory
  CHECK(std::isnan(volume(Aabb<S, 3>{{0, 0, 0}, {1, inf, 1}})));
  CHECK(std::isnan(volume<S>({{nan, 0, 0}}, {})));
  const S most = std::numeric_limits<S>::max();
  CHECK(volume(Aabb<S, 3>{{0, 0, 0}, {most, most, most}}) == inf);
}

TEMPLATE_TEST_CASE("volumes of hulls are within two ulps of the rational ones", "[volume]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  double worst = 0;
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(6, 1000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      std::vector<Point<S, 3>> points(4 + random.below(12));
      for (Point<S, 3>& p : points) p = bench::vector<S, 3>(random, numbers);
      const Hull3<S> hull = convex_hull(points);
      Rational sum = 0;
      for (const auto& [a, b, c] : hull.triangles)  // from the origin, which may be far away
        sum += oracle::dot(
            oracle::rational<S, 3>(hull.vertices[a]),
            oracle::cross(oracle::rational<S, 3>(hull.vertices[b]), oracle::rational<S, 3>(hull.vertices[c])));
      worst = std::max(worst, oracle::ulps(volume(hull), Rational(sum / 6)));
      REQUIRE(worst <= 2);
      if (numbers == bench::Numbers::ordinary) {
        REQUIRE(void_volume(fit_aabb(points), volume(hull)) >= 0);
        REQUIRE(void_volume(fit_obb_tight(points), volume(hull)) >= 0);
        REQUIRE(void_volume(fit_kdop(points, directions<S, 3>(26)), volume(hull)) >= -1e-5);  // rounded vertices
        REQUIRE(surface_area(hull) <= surface_area(fit_aabb(points)) * (1 + 1e-6));           // convex in convex
      }
    }
}

// The trade-off of the note, N04: run with [.table] to see it.
TEST_CASE("tightness, storage and the cost of the pair test", "[.table]") {
  bench::Random random(tests::seed());
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  std::vector<Point<double, 3>> points;
  for (int i = 0; i < 2000; ++i) points.push_back(turn * random.heading<3>().cwiseProduct(Eigen::Vector3d(3, 1, 0.5)));
  const Hull3<double> hull = convex_hull(points);
  const double object = volume(hull);
  std::vector<Vector<double, 3>> offsets;
  for (int i = 0; i < 1 << 16; ++i) offsets.push_back(random.in_box<3>(6));

  std::printf("\n%-20s %8s %12s %8s %8s\n", "volume", "numbers", "void/object", "pair ns", "hits %");
  const auto row = [&](const char* name, const auto& fit, const auto& overlap) {
    const auto first = fit(points);
    std::vector<std::remove_const_t<decltype(first)>> others;
    for (std::size_t i = 0; i < 1 << 12; ++i) {
      std::vector<Point<double, 3>> moved(points.begin(), points.begin() + 50);
      for (Point<double, 3>& p : moved) p += offsets[i];
      others.push_back(fit(moved));
    }
    const auto meets = [&](const auto& other) { return overlap(first, other); };
    const double ns = bench::least_each(bench::Session({}, 1), others, meets);
    const auto hits = std::ranges::count_if(others, meets);
    std::printf("%-20s %8zu %12.2f %8.1f %8.1f\n", name, numbers_kept(first), void_volume(first, object) / object, ns,
                100.0 * static_cast<double>(hits) / static_cast<double>(others.size()));
  };
  using P = std::vector<Point<double, 3>>;
  const auto pair = [](const auto& a, const auto& b) { return intersects(a, b); };
  const auto slabs = [](const auto& a, const auto& b) { return may_intersect(a, b); };
  row(
      "AABB", [](const P& p) { return fit_aabb(p); }, pair);
  row(
      "sphere", [](const P& p) { return fit_sphere_smallest(p); }, pair);
  row(
      "sphere, Ritter", [](const P& p) { return fit_sphere_ritter(p); }, pair);
  row(
      "OBB", [](const P& p) { return fit_obb(p); }, pair);
  for (const int k : {14, 18, 26})
    row(("k-DOP " + std::to_string(k)).c_str(), [&](const P& p) { return fit_kdop(p, directions<double, 3>(k)); },
        slabs);
}

}  // namespace volume_test
