#include <isect/point_polygon.h>
#include <isect/polygon_triangles.h>
#include <isect/sphere_triangle.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/catch.h"
#include "tests/core/polyominoes.h"
#include "tests/core/poses.h"
#include "tests/settings.h"

namespace polygon_triangles_test {
using namespace isect;
using isect::test::in_space;
using Vec3 = Vector<double, 3>;

namespace {

/// Its corners in the order of their directions from (0, 0), one in each: simple.
Ring<double, 2> star(std::mt19937& random) {
  std::uniform_int_distribution<int> whole(-6, 6), count(3, 12);
  Ring<double, 2> ring;
  const auto angle = [](const Point<double, 2>& p) { return std::atan2(p.y(), p.x()); };
  for (int i = count(random); i > 0; --i) {
    const Point<double, 2> p(whole(random), whole(random));
    const auto along = [&](const Point<double, 2>& q) { return std::abs(angle(p) - angle(q)) < 1e-9; };
    if (!p.isZero(0) && std::ranges::none_of(ring, along)) ring.push_back(p);
  }
  std::ranges::sort(ring, {}, angle);
  return ring;
}
/// Whether no gap between neighbouring directions is half a turn or more, so that it winds round (0, 0).
bool winds_round(const Ring<double, 2>& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if (a.x() * b.y() - a.y() * b.x() <= 0) return false;
  }
  return ring.size() > 2;
}

/// Twice the area of triangles of squares, in units of a square's, as it is seen along their frame's third axis.
double area2(const tests::Frame& frame, const Ring<double, 3>& ring, const std::vector<std::array<int, 3>>& triangles) {
  Eigen::Matrix3d axes;
  for (int i = 0; i < 3; ++i) axes.col(i) = frame.axes[static_cast<std::size_t>(i)];
  const auto seen = [&](int i) -> Vec3 {
    const Vec3 x = axes.inverse() * (ring[static_cast<std::size_t>(i)] / frame.unit - frame.origin);
    return {std::round(x[0]), std::round(x[1]), 0};
  };
  double sum = 0;
  for (const auto& [a, b, c] : triangles) sum += (seen(b) - seen(a)).cross(seen(c) - seen(a)).z();
  return sum;
}

}  // namespace

TEST_CASE("triangles of a polygon hold the points that it holds, and each corner is used", "[polygon_triangles]") {
  std::mt19937 random(5);
  int polygons = 0, inside = 0, outside = 0;
  for (int i = 0; i < 600; ++i) {
    Ring<double, 2> flat = star(random);
    if (!winds_round(flat)) continue;
    if (i % 2) std::ranges::reverse(flat);
    const int pose = i % 3;
    Ring<double, 3> outline;
    for (const auto& p : flat) outline.push_back(in_space(p, pose));
    const TriangulatedPolygon<double> made = triangulated(outline);
    CAPTURE(i);
    REQUIRE(made.triangles.size() == flat.size() - 2);
    ++polygons;
    for (int k = 0; k < 40; ++k) {
      const Point<double, 2> p(0.5 * (k % 8) * 3 - 6, 0.5 * (k / 8) * 5 - 5);
      bool held = false;
      for (int t = 0; t < static_cast<int>(made.triangles.size()); ++t)
        held |= intersects(Sphere<double, 3>{in_space(p, pose), 0}, triangle(made, t));
      CHECK(held == (locate(p, flat) != Location::out));
      ++(held ? inside : outside);
    }
  }
  CHECK(polygons > 100);
  CHECK(inside > 1000);
  CHECK(outside > 1000);
}

TEST_CASE("outlines that are no polygon's have no triangles, and straight corners do no harm", "[polygon_triangles]") {
  const auto flat = [](std::vector<Point<double, 2>> corners) {
    Ring<double, 3> ring;
    for (const auto& p : corners) ring.push_back(in_space(p, 2));
    return triangulated(ring).triangles;
  };
  CHECK(flat({{0, 0}, {2, 2}, {2, 0}, {0, 2}}).empty());                      // a bow tie
  CHECK(flat({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}).empty());              // a corner on an edge
  CHECK(flat({{0, 0}, {4, 0}, {2, 0}, {2, 3}}).empty());                      // back along an edge
  CHECK(flat({{0, 0}, {1, 0}, {2, 0}}).empty());                              // no area
  CHECK(flat({{0, 0}, {2, 2}, {0, 2}, {2, 2}, {4, 0}}).empty());              // a corner met twice
  CHECK(flat({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {2, 2}}).size() == 3);          // straight on at two corners
  CHECK(flat({{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4}, {0, 0}}).size() == 1);  // said twice
}

TEST_CASE("triangles of polygons of squares have their area, and turn as the outline does", "[polygon_triangles]") {
  bench::Random random(tests::seed());
  int convex = 0;
  for (int i = 0; i < tests::cases(400, 40000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const tests::Frame frame = tests::Frame::draw(random);
    const tests::Squares squares = tests::random_squares(random, random.integer(1, 5));
    const Ring<double, 3> outline = outline_in(frame, squares, random);
    const TriangulatedPolygon<double> made = triangulated(outline);
    const double covered = area2(frame, outline, made.triangles);
    std::vector<std::array<int, 3>> fan;  // which has the outline's area, and turns as it does
    for (int k = 1; k + 1 < static_cast<int>(outline.size()); ++k) fan.push_back({0, k, k + 1});
    REQUIRE(covered == area2(frame, outline, fan));
    REQUIRE(std::abs(covered) == 2. * static_cast<double>(squares.size()));
    for (std::size_t t = 0; t < made.triangles.size(); ++t)
      REQUIRE(area2(frame, outline, {made.triangles[t]}) * covered > 0);
    // A rectangle is as large as the box around it
    const auto [lo_x, hi_x] = std::ranges::minmax(squares, {}, [](const auto& s) { return s[0]; });
    const auto [lo_y, hi_y] = std::ranges::minmax(squares, {}, [](const auto& s) { return s[1]; });
    const int box = (hi_x[0] - lo_x[0] + 1) * (hi_y[1] - lo_y[1] + 1);
    REQUIRE(made.convex.size() == (box == static_cast<int>(squares.size()) ? 4 : 0));
    convex += !made.convex.empty();
    REQUIRE(off_plane(outline) == 0);
    REQUIRE(is_simple(outline));
    REQUIRE(ears(outline) == made.triangles);
  }
  CHECK(convex > 20);
}

TEST_CASE("an outline that an edge leads into a hole and back has ears, and is not simple", "[polygon_triangles]") {
  for (int pose = 0; pose < 3; ++pose) {
    Ring<double, 3> frame;
    for (const Point<double, 2>& p :
         Ring<double, 2>{{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}})
      frame.push_back(in_space(p, pose));
    CHECK_FALSE(is_simple(frame));
    CHECK(empty(triangulated(frame)));
    const auto three = ears(frame);
    CHECK(three.size() == 8);
    const auto held = [&](double x, double y) {
      return std::ranges::any_of(three, [&](const std::array<int, 3>& t) {
        const auto at = [&](std::size_t i) { return frame[static_cast<std::size_t>(t[i])]; };
        return intersects(Sphere<double, 3>{in_space({x, y}, pose), 0}, Triangle<double, 3>{{at(0), at(1), at(2)}});
      });
    };
    CHECK((held(1, 1) && held(3, 5) && held(2, 3) && held(5, 3)));
    CHECK_FALSE((held(3, 3) || held(7, 1) || held(3, 2.5)));
  }
}

TEST_CASE("corners of an outline around a convex area are found, however they are named", "[polygon_triangles]") {
  const Ring<double, 2> square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  CHECK(convex_corners(square) == square);
  CHECK(convex_corners({{0, 2}, {2, 2}, {2, 0}, {0, 0}}) == square);
  CHECK(convex_corners({{1, 0}, {2, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}, {0, 0}, {0, 0}}) == square);
  CHECK_FALSE(convex_corners({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}}));                          // a notch
  CHECK_FALSE(convex_corners({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 2}, {0, 2}}));  // twice round
  CHECK_FALSE(convex_corners({{0, 0}, {2, 2}, {2, 0}, {0, 2}}));                                  // a bow tie
  CHECK_FALSE(convex_corners({{0, 0}, {1, 1}, {2, 2}}));                                          // no area
  CHECK_FALSE(convex_corners({}));
}

TEST_CASE("how far corners lie off one plane is told, and 0 is said of none that does", "[polygon_triangles]") {
  Ring<double, 3> square = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  CHECK(off_plane(square) == 0);
  square[2].z() = 1e-300;
  CHECK(off_plane(square) > 0);
  square[2].z() = 0.25;
  CHECK(off_plane(square) == Approx(0.125).epsilon(0.01));                // the normal leans half way
  for (const int exponent : {-1060, -900, -570, -300, 300, 570, 1000}) {  // far beyond what squares can be
    Ring<double, 3> scaled = square;
    for (Vec3& v : scaled) v *= std::ldexp(1, exponent);
    INFO(exponent);
    CHECK(std::ldexp(off_plane(scaled), -exponent) ==
          Approx(off_plane(square)).epsilon(exponent < -1000 ? 0.1 : 1e-15));
  }
}

}  // namespace polygon_triangles_test
