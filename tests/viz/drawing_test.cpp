#include "viz/drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/catch.h"

namespace drawing_test {
using namespace isect::viz;

namespace {

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length2 = along.squaredNorm();
  const double u = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0;
  return (p - a - u * along).norm();
}

double distance_to_polyline(const Vec2& p, const std::vector<Vec2>& points) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < points.size(); ++i)
    least = std::min(least, distance_to_segment(p, points[i - 1], points[i]));
  return least;
}

}  // namespace

TEST_CASE("a polyline keeps its points in order", "[drawing]") {
  const std::vector<Vec2> points = {{0, 0}, {1, 0}, {1, 2}};
  CHECK(flatten(polyline(points)) == points);
  CHECK(flatten(polyline(points, true)) == points);
  CHECK(polyline(points, true).closed);
  CHECK_FALSE(polyline(points).closed);
}

TEST_CASE("a polyline of one point or of none has no segment", "[drawing]") {
  CHECK(polyline({}).segments.empty());
  CHECK_FALSE(polyline({}, true).closed);
  CHECK(polyline({{3, 4}}).start == Vec2(3, 4));
  CHECK(polyline({{3, 4}}).segments.empty());
}

TEST_CASE("facets are as many fills, each with a seam of its colour, for what knows no facets", "[drawing]") {
  Facets facets = {{{0, 0}, {4, 0}, {0, 3}, {1, 1}, {5, 1}, {1, 4}}, {{1, 0, 0}, {0, 1, 0}}, 0.5, 7};
  const Text text{"", Vec2::Zero(), 10, {}};
  const std::vector<Shape> shapes = expanded(std::vector<Shape>{text, facets, text});
  REQUIRE(shapes.size() == 6);
  const Fill& fill = std::get<Fill>(shapes[3]);
  const Stroke& seam = std::get<Stroke>(shapes[4]);
  CHECK(flatten(fill.path) == std::vector<Vec2>{{1, 1}, {5, 1}, {1, 4}});
  CHECK((fill.path.closed && seam.path.closed));
  CHECK(flatten(seam.path) == flatten(fill.path));
  CHECK((fill.colour == facets.colours[1] && seam.colour == facets.colours[1]));
  CHECK((seam.width == 0.5 && seam.object == 7 && fill.object == 7));
  facets.seam = 0;
  CHECK(expanded(facets).size() == 2);
  Shape moved = facets;
  move(moved, {10, 20});
  CHECK(std::get<Facets>(moved).corners.back() == Vec2(11, 24));
}

TEST_CASE("an ellipse of cubics stays within 3e-4 of the radius", "[drawing]") {
  const Vec2 center(7, -3);
  const double radius = 40;
  for (const Vec2& p : flatten(circle(center, radius), 1e-6))
    REQUIRE(std::abs((p - center).norm() - radius) < 3e-4 * radius);

  const Vec2 major(30, 10), minor(-4, 12);
  for (const Vec2& p : flatten(ellipse(center, major, minor), 1e-6)) {
    const Vec2 from = p - center;
    const double u = from.dot(major) / major.squaredNorm(), v = from.dot(minor) / minor.squaredNorm();
    REQUIRE(std::abs(std::hypot(u, v) - 1) < 3e-4);
  }
}

TEST_CASE("a flattened curve stays within its tolerance and wastes few points", "[drawing]") {
  const Path::Cubic cubic{{0, 90}, {100, -80}, {110, 20}};
  const Path path{{0, 0}, {cubic}, false};
  for (const double tolerance : {1.0, 0.05, 0.001}) {
    const std::vector<Vec2> points = flatten(path, tolerance);
    for (int i = 0; i <= 1000; ++i) {
      const double u = i / 1000.0, v = 1 - u;
      const Vec2 on = 3 * v * v * u * cubic.control1 + 3 * v * u * u * cubic.control2 + u * u * u * cubic.to;
      REQUIRE(distance_to_polyline(on, points) <= tolerance);
    }
    CHECK(static_cast<double>(points.size()) < 2 + 20 / std::sqrt(tolerance));
  }
}

TEST_CASE("flattening repeats no point, neither a neighbour nor a closed path's start", "[drawing]") {
  const std::vector<Vec2> round = flatten(circle({0, 0}, 1), 0.01);
  CHECK(round.front() != round.back());
  for (std::size_t i = 1; i < round.size(); ++i) REQUIRE(round[i] != round[i - 1]);

  CHECK(flatten(polyline({{0, 0}, {0, 0}, {1, 0}, {1, 0}, {0, 0}}, true)) == std::vector<Vec2>{{0, 0}, {1, 0}});
  CHECK(flatten(polyline({{0, 0}, {1, 0}, {0, 0}})) == std::vector<Vec2>{{0, 0}, {1, 0}, {0, 0}});
}

TEST_CASE("a straight, huge or undefined cubic flattens to a bounded number of points", "[drawing]") {
  const auto count = [](const Path::Cubic& cubic) { return flatten({{0, 0}, {cubic}, false}).size(); };
  CHECK(count({{1, 0}, {2, 0}, {3, 0}}) == 2);
  CHECK(count({{1e9, 1e9}, {-1e9, 1e9}, {0, 5}}) <= 4097);
  CHECK(count({{std::nan(""), 0}, {1, 1}, {2, 2}}) == 2);
}

}  // namespace drawing_test
