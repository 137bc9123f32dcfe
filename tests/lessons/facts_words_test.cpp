// Facts that stand in solutions of exercises and in a sentence of a step. Each is computed here.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include <isect/fit_tight.h>
#include <isect/methods/ray_sphere.h>
#include <isect/ray_triangle.h>
#include <Eigen/Geometry>
#include "bench/random.h"
#include "tests/lessons/orders.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"

namespace facts_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using isect::test::Contains;

TEST_CASE("the smallest ball around two balls has the radius that is told", "[words]") {
  CHECK(solved_with("sphere-sphere", "(5 + 3 + 4) / 2 = 6"));
  const double a = 3, b = 4, d = 5, radius = (d + a + b) / 2;
  const double centre = radius - a;  // from the centre of a towards b
  CHECK(radius == 6);
  CHECK(centre + a == radius);
  CHECK((d - centre) + b == radius);
  std::vector<Point<double, 2>> points;
  for (int k = 0; k < 64; ++k) {  // both ends of the line through the centres are among them
    const double angle = 2 * std::numbers::pi * k / 64;
    const Vec2 n(std::cos(angle), std::sin(angle));
    points.push_back(a * n);
    points.push_back(Vec2(d, 0) + b * n);
  }
  const Sphere<double, 2> smallest = fit_sphere_smallest(points);
  CHECK(smallest.radius == Approx(radius));
  CHECK(smallest.center.x() == Approx(centre));
}

TEST_CASE("a projection along an axis keeps the told part of an area", "[words]") {
  CHECK(solved_with("ray-polygon", "of its size, so the largest"));
  bench::Random random = random_of("areas");
  for (int k = 0; k < 100; ++k) {
    const Vec3 u = random.in_box<3>(2), v = random.in_box<3>(2), n = u.cross(v);
    const double area = std::sqrt(u.dot(u) * v.dot(v) - u.dot(v) * u.dot(v));
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, l = (i + 2) % 3;
      const double flat = std::abs(u[j] * v[l] - u[l] * v[j]);
      CHECK(flat == Approx(area * std::abs(n[i]) / n.norm()).margin(1e-12));
    }
  }
}

TEST_CASE("a mixed form of the quadratic takes misses for hits, or hits for misses", "[words]") {
  CHECK(solved_with("ray-sphere", "turns some misses into hits"));
  int false_hits = 0, false_misses = 0;
  for (int a = 1; a < 8; ++a)
    for (int c = 1; c < 8; ++c)
      for (int half = -12; half < 0; ++half) {
        const int b = 2 * half;
        const bool hit = half * half - a * c >= 0;
        CHECK(hit == (b * b - 4 * a * c >= 0));
        const bool whole_in_half = b * b - a * c >= 0, half_in_whole = half * half - 4 * a * c >= 0;
        if (hit) CHECK(whole_in_half);
        if (!hit) CHECK_FALSE(half_in_whole);
        false_hits += whole_in_half && !hit, false_misses += hit && !half_in_whole;
      }
  CHECK((false_hits > 0 && false_misses > 0));
}

TEST_CASE("a direction that is nearly of length 1 costs Haines's method as much as is told", "[words]") {
  CHECK(solved_with("ray-sphere", "If it is 1 + ε"));
  CHECK(solved_with("ray-sphere", "too small for ε > 0"));
  for (const double e : {1e-7, -1e-7})
    for (const double aside : {0.0, 0.5, 0.9})
      for (const double away : {2.0, 5.0, 20.0}) {
        const Sphere<double, 3> ball = {{away, aside, 0}, 1};
        const double q = std::sqrt(1 - aside * aside), distance = away - q;
        const auto found = ray_sphere::haines(Ray<double, 3>{{0, 0, 0}, {1 + e, 0, 0}}, ball);
        REQUIRE(found);
        CHECK((*found < distance) == (e > 0));
        CHECK((*found - distance) / distance == Approx(-e * away / q).epsilon(1e-3));
      }
}

TEST_CASE("insertion sort moves as many times as there are inversions", "[words]") {
  CHECK(solved_with("collision", "O(n + inversions)"));
  bench::Random random = random_of("inversions");
  for (int k = 0; k < 20; ++k) {
    std::vector<int> x(30);
    for (int& value : x) value = random.below(100);
    int inversions = 0, moves = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t j = i + 1; j < x.size(); ++j) inversions += x[i] > x[j];
    for (std::size_t i = 1; i < x.size(); ++i)
      for (std::size_t j = i; j > 0 && x[j - 1] > x[j]; --j) std::swap(x[j - 1], x[j]), ++moves;
    CHECK(std::ranges::is_sorted(x));
    CHECK(moves == inversions);
  }
}

TEST_CASE("disjoint segments part a box into as many trapezoids as is told", "[words]") {
  CHECK(solved_with("concave-polygon", "3n + 1 at most"));
  bench::Random random = random_of("trapezoids");
  for (int n = 1; n < 12; ++n) {
    // Horizontal segments, one at each height, and no two ends at one x.
    std::vector<double> ends;
    for (int i = 0; i < 2 * n; ++i) ends.push_back(i + random.uniform(0.1, 0.9));
    std::vector<double> order = ends;
    for (std::size_t i = order.size(); i > 1; --i)
      std::swap(order[i - 1], order[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    int trapezoids = 0;
    std::set<std::pair<int, int>> before;
    for (int slab = 0; slab <= 2 * n; ++slab) {
      std::set<std::pair<int, int>> here;  // the segments below and above each trapezoid
      int below = -1;
      for (int i = 0; i < n; ++i) {
        const auto [from, to] =
            std::minmax(order[static_cast<std::size_t>(2 * i)], order[static_cast<std::size_t>(2 * i + 1)]);
        const double x = slab == 0 ? -1 : ends[static_cast<std::size_t>(slab - 1)] + 1e-9;
        if (from < x && x < to) here.insert({below, i}), below = i;
      }
      here.insert({below, n});
      for (const auto& trapezoid : here) trapezoids += !before.contains(trapezoid);
      before = here;
    }
    CHECK(trapezoids == 3 * n + 1);
  }
}

TEST_CASE("tests that reject are in the best order by cost divided by the chance to reject", "[words]") {
  CHECK(solved_with("rules-of-thumb", "cost divided by the chance to reject"));
  bench::Random random = random_of("orders");
  for (int k = 0; k < 50; ++k) {
    std::array<double, 4> cost = {}, chance = {};
    for (std::size_t i = 0; i < 4; ++i) cost[i] = random.uniform(1, 10), chance[i] = random.uniform(0.05, 0.95);
    std::array<std::size_t, 4> order = {0, 1, 2, 3};
    const auto expected = [&](const std::array<std::size_t, 4>& tests) {
      double sum = 0, reached = 1;
      for (const std::size_t i : tests) sum += reached * cost[i], reached *= 1 - chance[i];
      return sum;
    };
    const double least = least_of_all_orders(order, expected);
    std::ranges::sort(order, {}, [&](std::size_t i) { return cost[i] / chance[i]; });
    CHECK(expected(order) == Approx(least));
  }
}

TEST_CASE("a ray from inside a closed mesh, through an edge, meets two triangles", "[words]") {
  CHECK(solved_with("ray-triangle", "a ray through an edge or a vertex meets several"));
  const Vec3 a(1, -1, -1), b(1, 1, -1), c(1, 1, 1), d(1, -1, 1);  // a face of a cube around the origin
  const Triangle<double, 3> lower = {{a, b, c}}, upper = {{a, c, d}};
  const auto met = [&](const Vec3& direction) {
    const Ray<double, 3> ray = {{0, 0, 0}, direction};
    return int(intersects(ray, lower)) + int(intersects(ray, upper));
  };
  CHECK(met({1, 0, 0}) == 2);         // the diagonal
  CHECK(met({1, 0.25, 0.125}) == 1);  // beside it
}

TEST_CASE("from either end an edge is cut in another point, so the order of its ends counts", "[words]") {
  CHECK_THAT(find(walk_of("clipping", "cut"), "sides")->caption, Contains("from the edge's inner to its outer end"));
  bench::Random random = random_of("ends");
  int apart = 0;
  for (int k = 0; k < 200; ++k) {
    const Vec2 p(random.uniform(-1, 0), random.uniform(-1, 1)), q(random.uniform(0, 1), random.uniform(-1, 1));
    const auto cut = [](const Vec2& from, const Vec2& to) {
      return from.y() + -from.x() / (to.x() - from.x()) * (to.y() - from.y());
    };
    apart += cut(p, q) != cut(q, p);
  }
  CHECK(apart > 0);
}

}  // namespace facts_words_test
