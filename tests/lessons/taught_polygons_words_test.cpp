// What readers could not answer in three exams from the lessons' texts: each sentence about polygons, trees and
// distances from lines is computed here.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include <isect/convex_hull.h>
#include <isect/many/bvh.h>
#include <isect/orient.h>
#include <isect/point_polygon.h>
#include "bench/random.h"
#include "tests/lessons/words.h"

namespace taught_polygons_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;

TEST_CASE("all orientations say what is told of a convex polygon, and about half reject a far point", "[words]") {
  CHECK(solved_with("convex-polygon", "and p is negative. In clockwise order the signs turn"));
  CHECK(solved_with("convex-polygon", "about half of the edges of a round polygon have"));
  CHECK(solved_with("convex-polygon", "it lies inside their triangle"));
  bench::Random random = random_of("orientations");
  for (int k = 0; k < 200; ++k) {
    Ring<double, 2> points;
    for (int i = 0; i < 7; ++i) points.emplace_back(3 * random.below(9), 3 * random.below(9));
    const Ring<double, 2> hull = isect::convex_hull(points);
    const std::size_t n = hull.size();
    if (n < 3) continue;
    const auto all_sides = [&](const Vec2& p, bool reversed, double y) {
      bool inner = true;
      for (std::size_t i = 0; i < n; ++i) {
        const auto turned = [&](const Vec2& v) { return Vec2(v.x(), y * v.y()); };
        const Vec2 u = turned(hull[i]), v = turned(hull[(i + 1) % n]), at = turned(p);
        inner = inner && (reversed ? orient2d(v, u, at) : orient2d(u, v, at)) * y * (reversed ? -1 : 1) >= 0;
      }
      return inner;
    };
    const Vec2 p(random.below(25), random.below(25)), q = (hull[0] + hull[n / 3] + hull[2 * n / 3]) / 3;  // whole
    for (const bool reversed : {false, true})
      for (const double y : {1.0, -1.0}) CHECK(all_sides(p, reversed, y) == (locate(p, hull) != Location::out));
    CHECK(locate(q, hull) == Location::in);
  }

  for (const int n : {8, 64, 1000})
    for (int k = 0; k < 20; ++k) {
      const auto vertex = [n](int i) {
        const double angle = 2 * std::numbers::pi * i / n;
        return Vec2(std::cos(angle), std::sin(angle));
      };
      const Vec2 p = 1e6 * random.in_box<2>(1).normalized();
      int reject = 0;
      for (int i = 0; i < n; ++i) reject += orient2d(vertex(i), vertex(i + 1), p) < 0;
      CHECK(std::abs(reject - n / 2) <= 1);
    }
}

TEST_CASE("a tree finds the object nearest to a point as all objects do, and leaves nodes closed", "[words]") {
  CHECK(solved_with("hierarchy", "A box farther off than that holds nothing nearer: prune it."));
  bench::Random random = random_of("nearest objects");
  std::size_t opened = 0, nodes = 0;
  for (int k = 0; k < 50; ++k) {
    std::vector<Aabb<double, 2>> boxes;
    for (int i = 0; i < 60; ++i) {
      const Vec2 at = random.in_box<2>(4);
      boxes.push_back({at, at});
    }
    const Vec2 c = random.in_box<2>(5);
    const auto squared = [&](const Aabb<double, 2>& box) {
      return (c - c.cwiseMax(box.lo).cwiseMin(box.hi)).squaredNorm();
    };
    const Bvh<double, 2> tree = build_bvh(boxes);
    double best = INFINITY;
    std::vector<int> open = {0};
    while (!open.empty()) {
      std::ranges::sort(open, {}, [&](int i) { return -squared(tree.nodes[static_cast<std::size_t>(i)].box); });
      const auto& node = tree.nodes[static_cast<std::size_t>(open.back())];
      open.pop_back();
      if (squared(node.box) > best) continue;
      ++opened;
      if (!node.leaf()) open.push_back(node.first), open.push_back(node.first + 1);
      for (int i = 0; i < node.count; ++i) {
        const int primitive = tree.primitives[static_cast<std::size_t>(node.first + i)];
        best = std::min(best, squared(boxes[static_cast<std::size_t>(primitive)]));
      }
    }
    double least = INFINITY;
    for (const auto& box : boxes) least = std::min(least, squared(box));
    CHECK(best == least);
    nodes += tree.nodes.size();
  }
  CHECK(opened < nodes);
}

TEST_CASE("lines and planes have the distances that are told", "[words]") {
  CHECK(solved_with("points", "From the plane n · x + D = 0 the distance is |n · p + D| / |n|."));
  CHECK(solved_with("points", "no division is needed"));
  const Vec3 n(2, -1, 2), d(2, 1, 2), a(1, 0, 1);
  const auto height = [&](const Vec3& p) { return std::abs(n.dot(p) - 6) / n.norm(); };
  CHECK((height({1, 2, 3}) == 0 && height({2, 1, 2}) == Approx(1.0 / 3)));
  CHECK((Vec3(5, 2, 5) - a).cross(d).isZero(0));
  bench::Random random = random_of("lines");
  for (int k = 0; k < 100; ++k) {
    const Vec3 p = random.in_box<3>(3), foot = a + (p - a).dot(d) / d.dot(d) * d;
    CHECK((p - a).cross(d).squaredNorm() / d.squaredNorm() == Approx((p - foot).squaredNorm()).margin(1e-9));
  }
}

TEST_CASE("the smallest circle around a triangle has the longest side as diameter, or all vertices on it", "[words]") {
  CHECK(solved_with("bounding-volumes", "Where an angle has 90° or more, the longest side is a diameter"));
  bench::Random random = random_of("circles");
  int wide = 0, sharp = 0;
  for (int k = 0; k < 300; ++k) {
    const Vec2 v[] = {random.in_box<2>(2), random.in_box<2>(2), random.in_box<2>(2)};
    bool by_a_side = false;  // a circle on a side contains the third vertex
    bool obtuse = false;
    for (int i = 0; i < 3; ++i) {
      const Vec2 &a = v[i], &b = v[(i + 1) % 3], &c = v[(i + 2) % 3], middle = (a + b) / 2;
      const bool contains = (c - middle).norm() <= (a - b).norm() / 2;
      if (contains) CHECK(((a - b).norm() >= (b - c).norm() && (a - b).norm() >= (a - c).norm()));
      by_a_side = by_a_side || contains;
      obtuse = obtuse || (a - c).dot(b - c) <= 0;
    }
    CHECK(by_a_side == obtuse);
    (obtuse ? wide : sharp) += 1;
    const Vec2 centre = random.in_box<2>(2);
    double mean = 0, most = 0;
    for (const Vec2& p : v) mean += (p - centre).norm() / 3, most = std::max(most, (p - centre).norm());
    CHECK(mean < most);
  }
  CHECK((wide > 0 && sharp > 0));
}

}  // namespace taught_polygons_words_test
