#include "viz/gl/tessellate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "tests/catch.h"
#include "viz/gl/triangle_batch.h"

namespace tessellate_test {
using namespace isect::viz;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr unsigned seed = 20240607;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

double signed_area(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a) / 2; }

double polygon_area(const std::vector<Vec2>& p) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += cross(p[i], p[(i + 1) % p.size()]) / 2;
  return sum;
}

/// How often the outline goes round `p`: upward edges to the right of it minus downward ones.
int winding(const std::vector<Vec2>& outline, const Vec2& p) {
  int turns = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    const double side = signed_area(a, b, p);
    if (a.y() <= p.y() && b.y() > p.y() && side > 0) ++turns;
    if (a.y() > p.y() && b.y() <= p.y() && side < 0) --turns;
  }
  return turns;
}

int total_winding(const Triangles& triangles, const Vec2& p) {
  int sum = 0;
  for (std::size_t i = 0; i < triangles.size(); i += 3)
    sum += winding(std::vector<Vec2>(triangles.begin() + static_cast<std::ptrdiff_t>(i),
                                     triangles.begin() + static_cast<std::ptrdiff_t>(i + 3)),
                   p);
  return sum;
}

/// Whether some triangle, of either orientation, covers `p`.
bool covers(const Triangles& triangles, const Vec2& p) {
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const double a = signed_area(triangles[i], triangles[i + 1], p);
    const double b = signed_area(triangles[i + 1], triangles[i + 2], p);
    const double c = signed_area(triangles[i + 2], triangles[i], p);
    if ((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0)) return true;
  }
  return false;
}

double distance(const Polyline& line, const Vec2& p) {
  double least = infinity;
  const std::size_t n = line.points.size();
  for (std::size_t i = 0; i + 1 < n + (line.closed ? 1 : 0); ++i) {
    const Vec2 a = line.points[i], along = line.points[(i + 1) % n] - a;
    const double share = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - a - share * along).norm());
  }
  return least;
}

double length(const Polyline& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.points.size(); ++i) sum += (line.points[i] - line.points[i - 1]).norm();
  return sum;
}

std::vector<Vec2> star(int corners, int step) {
  std::vector<Vec2> points;
  for (int i = 0; i < corners; ++i) {
    const double at = 2 * pi * step * i / corners;
    points.push_back({std::cos(at), std::sin(at)});
  }
  return points;
}

}  // namespace

TEST_CASE("an outline that turns one way once round is convex", "[tessellate]") {
  CHECK(is_convex(star(4, 1)));
  CHECK(is_convex(star(100, 1)));
  CHECK(is_convex(star(100, 99)));                             // the other way round
  CHECK(is_convex({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}));  // a corner on an edge
  CHECK_FALSE(is_convex(star(5, 2)));                          // turns one way, but twice round
  CHECK_FALSE(is_convex({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}}));
  CHECK_FALSE(is_convex({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));  // crosses itself
}

TEST_CASE("the triangles of a convex outline cover it exactly once", "[tessellate]") {
  for (const int corners : {3, 4, 5, 6, 7, 31, 64, 65}) {
    const std::vector<Vec2> outline = star(corners, 1);
    const Triangles triangles = triangulated(outline);
    CHECK(triangles.size() == std::size_t(3 * (corners - 2)));
    double area = 0;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
      const double part = signed_area(triangles[i], triangles[i + 1], triangles[i + 2]);
      CHECK(part > 0);
      area += part;
    }
    CHECK(area == Approx(polygon_area(outline)).epsilon(1e-12));
  }
  CHECK(triangulated({{0, 0}, {1, 0}}).empty());
}

TEST_CASE("the triangles of any outline add up to its winding number everywhere", "[tessellate]") {
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int round = 0; round < 60; ++round) {
    std::vector<Vec2> outline;
    for (int i = 0; i < 3 + round % 12; ++i) outline.push_back({coordinate(random), coordinate(random)});
    const Triangles triangles = triangulated(outline);
    for (int i = 0; i < 60; ++i) {
      const Vec2 p(coordinate(random), coordinate(random));
      CHECK(total_winding(triangles, p) == winding(outline, p));
    }
  }
}

TEST_CASE("a stroke covers the points within half its width and no others", "[tessellate]") {
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  constexpr double tolerance = 1e-3;
  int inside = 0, outside = 0;
  for (int round = 0; round < 40; ++round) {
    Polyline line{{}, round % 2 == 1};
    for (int i = 0; i < 2 + round % 6; ++i) line.points.push_back({coordinate(random), coordinate(random)});
    const double half = 0.05 + 0.01 * round;
    const Triangles triangles = stroke(line, 2 * half, true, tolerance);
    for (int i = 0; i < 200; ++i) {
      const Vec2 p(2 * coordinate(random), 2 * coordinate(random));
      const double from_line = distance(line, p);
      if (std::abs(from_line - half) < tolerance) continue;
      (from_line < half ? inside : outside)++;
      CHECK(covers(triangles, p) == (from_line < half));
    }
  }
  CHECK(inside > 500);
  CHECK(outside > 1000);
}

TEST_CASE("a flattened circle's stroke is a ring of the right area", "[tessellate]") {
  const Polyline line = flat(circle({3, 4}, 10), 1e-3);
  CHECK(line.closed);
  double area = 0;
  const Triangles ring = stroke(line, 2, true, 1e-3);
  for (std::size_t i = 0; i < ring.size(); i += 3) area += std::abs(signed_area(ring[i], ring[i + 1], ring[i + 2]));
  CHECK(area == Approx(pi * (11 * 11 - 9 * 9)).epsilon(1e-3));
  for (const Vec2& p : ring) CHECK(std::abs((p - Vec2(3, 4)).norm() - 10) == Approx(1).margin(5e-3));
}

TEST_CASE("a stroke's ends are round or cut off square", "[tessellate]") {
  const Polyline line{{{0, 0}, {10, 0}}, false};
  CHECK(bounds(stroke(line, 2, false, 1e-3)).low == Vec2(0, -1));
  CHECK(bounds(stroke(line, 2, false, 1e-3)).high == Vec2(10, 1));
  CHECK(bounds(stroke(line, 2, true, 1e-3)).low.x() == Approx(-1).margin(1e-3));
  CHECK(bounds(stroke(line, 2, true, 1e-3)).high.x() == Approx(11).margin(1e-3));

  const Polyline back{{{0, 0}, {10, 0}, {0, 0}}, false};  // round at the turning point, whatever the ends are
  CHECK(bounds(stroke(back, 2, false, 1e-3)).high.x() == Approx(11).margin(1e-3));
}

TEST_CASE("a point is a disc with round caps and nothing without", "[tessellate]") {
  const Polyline point = flat(polyline({{1, 2}, {1, 2}}), 0.1);
  REQUIRE(point.points.size() == 1);
  CHECK(covers(stroke(point, 2, true, 1e-3), {1.9, 2}));
  CHECK(stroke(point, 2, false, 1e-3).empty());
  CHECK(stroke({{{0, 0}, {1, 0}}, false}, 0, true, 1e-3).empty());
  CHECK(stroke({{{0, 0}, {1, 0}}, false}, not_a_number, true, 1e-3).empty());
}

TEST_CASE("dashes are measured along the line, round its corners", "[tessellate]") {
  const Polyline line{{{0, 0}, {7, 0}, {7, 7}}, false};
  const std::vector<Polyline> pieces = dashes(line, {4, 1});
  REQUIRE(pieces.size() == 3);
  CHECK(pieces[0].points == std::vector<Vec2>{{0, 0}, {4, 0}});
  CHECK(pieces[1].points == std::vector<Vec2>{{5, 0}, {7, 0}, {7, 2}});
  CHECK(pieces[2].points == std::vector<Vec2>{{7, 3}, {7, 7}});
}

TEST_CASE("the last dash is as long as what is left", "[tessellate]") {
  const std::vector<Polyline> pieces = dashes({{{0, 0}, {10, 0}}, false}, {4, 2});
  REQUIRE(pieces.size() == 2);
  CHECK(length(pieces[1]) == Approx(4));
  const std::vector<Polyline> shorter = dashes({{{0, 0}, {8, 0}}, false}, {4, 2});
  REQUIRE(shorter.size() == 2);
  CHECK(length(shorter[1]) == Approx(2));
}

TEST_CASE("on a closed line, a dash over the start is one piece", "[tessellate]") {
  const Polyline square{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, true};
  const std::vector<Polyline> pieces = dashes(square, {3, 2});  // 0-3, 5-8, 10-13, 15-16 and on to 3
  REQUIRE(pieces.size() == 3);
  CHECK(pieces[2].points == std::vector<Vec2>{{0, 1}, {0, 0}, {3, 0}});
  CHECK(length(pieces[2]) == Approx(4));
  for (const Polyline& piece : pieces) CHECK_FALSE(piece.closed);
}

TEST_CASE("a dash that makes no sense leaves the line whole", "[tessellate]") {
  const Polyline line{{{0, 0}, {10, 0}}, false};
  using Dash = std::array<double, 2>;
  for (const Dash& dash : {Dash{0, 0}, Dash{-1, 2}, Dash{1, 0}, Dash{0, 1}, Dash{not_a_number, 1},
                           Dash{1, not_a_number}, Dash{1, infinity}, Dash{1e-9, 1e-9}, Dash{20, 1}}) {
    const std::vector<Polyline> pieces = dashes(line, dash);
    REQUIRE(pieces.size() == 1);
    CHECK(pieces[0].points == line.points);
  }
}

TEST_CASE("hatch lines rise to the right and hang on the origin", "[tessellate]") {
  constexpr double gap = 3, width = 0.5;
  const Box box{{-7, 2}, {20, 11}};
  const Triangles lines = hatch(box, gap, width);
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> x(box.low.x(), box.high.x()), y(box.low.y(), box.high.y());
  for (int i = 0; i < 2000; ++i) {
    const Vec2 p(x(random), y(random));
    const double off = std::abs(std::remainder(p.sum() / std::numbers::sqrt2, gap));  // from the nearest line
    if (std::abs(off - width / 2) < 1e-9) continue;
    CHECK(covers(lines, p) == (off < width / 2));
  }
  CHECK(hatch(box, 0, width).empty());
  CHECK(hatch(box, not_a_number, width).empty());
  CHECK(hatch(box, gap, 0).empty());
  CHECK(hatch(box, 1e-9, width).empty());
}

TEST_CASE("a path without segments or with a coordinate that is not finite is empty", "[tessellate]") {
  CHECK(flat(Path{{1, 1}, {}, true}, 0.1).points.empty());
  CHECK(flat(polyline({{0, 0}, {not_a_number, 1}, {1, 1}}), 0.1).points.empty());
  CHECK(flat(polyline({{infinity, 0}, {1, 1}}), 0.1).points.empty());
}

TEST_CASE("a line is thinned of the points that no one could tell apart", "[tessellate]") {
  constexpr double tolerance = 0.08;
  std::mt19937 random(seed);
  std::normal_distribution<double> little(0, 0.02), some(0, 0.6), far(0, 9);
  for (int i = 0; i < 400; ++i) {
    INFO("line " << i << " of seed " << seed);
    std::normal_distribution<double>& size = i % 4 == 0 ? far : i % 4 == 1 ? some : little;
    Polyline line{{{5, 3}}, i % 2 == 0};
    const Vec2 drift = i % 8 < 4 ? Vec2(0.05, 0.02) : Vec2(0, 0);
    while (line.points.size() < 300)
      line.points.push_back(line.points.back() + drift + Vec2(size(random), size(random)));
    const Polyline thin = thinned(line, tolerance);
    REQUIRE(thin.closed == line.closed);
    REQUIRE(thin.points.front() == line.points.front());
    REQUIRE(thin.points.back() == line.points.back());
    if (&size == &little) CHECK(10 * thin.points.size() < 7 * line.points.size());
    for (const Vec2& p : line.points) REQUIRE(distance(thin, p) <= tolerance * (1 + 1e-9));
    for (std::size_t k = 0, at = 0; k < thin.points.size(); ++k, ++at)  // in their order, none of them new
      while (true) {
        REQUIRE(at < line.points.size());
        if (line.points[at] == thin.points[k]) break;
        ++at;
      }
  }
  const Polyline spike{{{0, 0}, {4, 0}, {9, 0}, {4, 0}, {5, 0}, {5, 3}}, false};
  CHECK(thinned(spike, tolerance).points == std::vector<Vec2>{{0, 0}, {9, 0}, {4, 0}, {5, 0}, {5, 3}});
  const Polyline dot{{{0, 0}, {0.01, 0}, {0, 0.01}}, true};
  CHECK(thinned(dot, tolerance).points.size() == 2);
}

TEST_CASE("an outline of thousands of corners is drawn by those that can be told apart", "[tessellate]") {
  const Path outline = polyline(star(10'000, 1), true);
  for (const double scale : {100.0, 1e6}) {  // 16 and far under one corner a pixel
    TriangleBatch batch(scale);
    batch.add(Fill{outline, {}, 0, 0, {}});
    batch.add(Stroke{outline, {}, 2 / scale, {0, 0}, true});
    CHECK((batch.vertices().size() < 3'000) == (scale == 100));
    CHECK((batch.vertices().size() > 80'000) == (scale != 100));
  }
}

TEST_CASE("a closed outline does not repeat its first point", "[tessellate]") {
  const Polyline line = flat(polyline({{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 0}}, true), 0.1);
  CHECK(line.points == std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}});
}

}  // namespace tessellate_test
