// What readers could not answer from the lessons' texts alone, and now can: each sentence about shapes is computed
// here.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include <isect/convex_hull.h>
#include <isect/methods/clip_polygon.h>
#include <isect/methods/ray_polygon.h>
#include <isect/methods/triangle_triangle.h>
#include <isect/point_convex_polygon.h>
#include <isect/point_polygon.h>
#include <isect/ray_polygon.h>
#include <isect/triangle_half_spaces.h>
#include <Eigen/Geometry>
#include "bench/random.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"

namespace answers_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;

namespace {

constexpr double full_turn = 2 * std::numbers::pi;

double cross(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

}  // namespace

TEST_CASE("of the outline the count says HIT or MISS, so the correction asks for the outline before", "[words]") {
  const Erratum& e = lesson("ray-polygon").errata.front();
  CHECK(e.corrected.find("ON") < e.corrected.find("the count is odd"));
  const Ring<double, 3> square = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  int hits = 0, misses = 0;
  for (const double x : {0.0, 4.0}) {
    const Ray<double, 3> ray = {{x, 2, 1}, {0, 0, -1}};
    CHECK(intersect(ray, square).location == Location::on);
    const bool hit = ray_polygon::projected(ray, square).has_value();
    hits += hit, misses += !hit;
  }
  CHECK((hits == 1 && misses == 1));
}

TEST_CASE("at the common edge of two polygons that lie in no plane a ray may miss both, or hit both", "[words]") {
  CHECK(solved_with("ray-polygon", "a ray may miss both, or hit both"));
  const Ring<double, 3> left = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}};
  const Ring<double, 3> right = {{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0.5}};
  const auto hits = [&](const Vec3& d) {
    const Vec3 origin = Vec3(1, 0.5, 0.25) - d;
    const Ray<double, 3> ray = {origin, d};
    return int(ray_polygon::projected(ray, left).has_value()) + int(ray_polygon::projected(ray, right).has_value());
  };
  CHECK(hits({-1, 0, -1}) == 0);
  CHECK(hits({1, 0, -1}) == 2);
}

TEST_CASE("a side and a cross product order directions all around, angles of atan2 do so from the first on",
          "[words]") {
  CHECK(solved_with("convex-polygon", "else the left one comes first"));
  CHECK(solved_with("convex-polygon", "It jumps from one to the other where a direction points straight to the left."));
  CHECK((std::atan2(0.0, -1.0) == std::numbers::pi && std::atan2(-0.0, -1.0) == -std::numbers::pi));
  bench::Random random = random_of("turns");
  const int n = 11;
  const double wedge = full_turn / n;
  int wrong = 0;
  for (int k = 0; k < 300; ++k) {
    const double first = random.uniform(0, full_turn), share = random.uniform(0.01, 0.99);
    const int at = random.below(n);  // the wedge of p
    const auto direction = [&](double turn) { return Vec2(std::cos(first + turn), std::sin(first + turn)); };
    const Vec2 start = direction(0), p = direction((at + share) * wedge);
    const auto angle = [](const Vec2& x) { return std::atan2(x.y(), x.x()); };
    const auto from_start = [&](const Vec2& x) {
      const double a = angle(x) - angle(start);
      return a < 0 ? a + full_turn : a;
    };
    for (int i = 1; i < n; ++i) {
      const Vec2 v = direction(i * wedge);
      const bool p_left = cross(start, p) >= 0, v_left = cross(start, v) >= 0;
      CHECK((p_left == v_left ? cross(v, p) > 0 : v_left) == (i <= at));
    }
    const auto found = [&](const auto& measure) {
      int lo = 0, hi = n;
      while (hi - lo > 1) {
        const int mid = (lo + hi) / 2;
        (measure(direction(mid * wedge)) <= measure(p) ? lo : hi) = mid;
      }
      return lo;
    };
    CHECK(found(from_start) == at);
    wrong += found(angle) != at;
  }
  CHECK(wrong > 0);
}

TEST_CASE("a bowl's hull has a lid, and a grid leaves nearly all pairs where one cell holds nearly all", "[words]") {
  CHECK(solved_with("collision", "a bowl would have a lid"));
  const Ring<double, 2> bowl = {{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
  const Point<double, 2> within(2, 2);
  CHECK(winding(within, bowl).even_odd == Location::out);
  CHECK(locate(within, convex_hull(bowl)) == Location::in);

  CHECK(solved_with("collision", "almost all pairs are left"));
  CHECK(solved_with("collision", "is listed in very many"));
  std::map<std::pair<int, int>, std::vector<int>> cells;
  std::map<int, int> listed;
  const auto add = [&](int body, int x, int y, int size) {
    for (int i = x; i < x + size; ++i)
      for (int j = y; j < y + size; ++j) cells[{i, j}].push_back(body), ++listed[body];
  };
  for (int body = 0; body < 49; ++body) add(body, 100, 100, 1);
  add(49, 0, 0, 30);
  std::set<std::pair<int, int>> pairs;
  for (const auto& [cell, bodies] : cells)
    for (const int a : bodies)
      for (const int b : bodies)
        if (a < b) pairs.insert({a, b});
  CHECK(100 * pairs.size() > 95U * 50 * 49 / 2);
  CHECK(listed[49] == 900);
}

TEST_CASE("moved out of a box by as much as is told, a ball touches it, and by no less", "[words]") {
  CHECK(
      solved_with("sphere-aabb", "in the box r plus the distance to that face. Moved so far, the ball just touches."));
  bench::Random random = random_of("ways out");
  for (int k = 0; k < 100; ++k) {
    const Vec3 half(random.uniform(0.5, 3), random.uniform(0.5, 3), random.uniform(0.5, 3));
    const Vec3 c = random.in_box<3>(1).cwiseProduct(half);
    const double r = random.uniform(0.1, 2);
    const auto gap = [&](const Vec3& x) {
      const Vec3 clamped = x.cwiseMax(-half).cwiseMin(half), f = x - clamped;
      return f.norm();
    };
    CHECK(gap(c) == 0);
    double least = INFINITY;
    Vec3 n = Vec3::Zero();
    for (int i = 0; i < 3; ++i)
      for (const double side : {-1.0, 1.0})
        if (const double distance = half[i] - side * c[i]; distance < least) least = distance, n = side * Vec3::Unit(i);
    const double depth = least + r;
    CHECK(gap(c + depth * n) == Approx(r));
    for (int j = 0; j < 50; ++j) CHECK(gap(c + 0.99 * depth * random.heading<3>()) < r);
    const Vec3 outside = c + (least + 0.25 * r) * n, nearest = outside.cwiseMax(-half).cwiseMin(half);
    const Vec3 f = outside - nearest;
    CHECK(gap(outside + (r - f.norm()) * f.normalized()) == Approx(r));
  }
}

namespace {

/// The features of a ring that is nearest to a point: 2 i is its vertex i, 2 i + 1 the edge that begins there.
struct Features {
  Ring<double, 2> ring;

  int size() const { return static_cast<int>(ring.size()); }
  const Point<double, 2>& vertex(int i) const { return ring[static_cast<std::size_t>((i + size()) % size())]; }
  /// The feature itself if p lies in its region, else the neighbour on whose side p lies.
  int next(int feature, const Vec2& p) const {
    const int i = feature / 2;
    const Vec2 f = p - vertex(i), on = vertex(i + 1) - vertex(i), back = vertex(i - 1) - vertex(i);
    const int all = 2 * size();
    if (feature % 2 == 1) return f.dot(on) < 0 ? 2 * i : f.dot(on) > on.dot(on) ? (2 * i + 2) % all : feature;
    return f.dot(on) > 0 ? 2 * i + 1 : f.dot(back) > 0 ? (2 * i - 1 + all) % all : feature;
  }
  double distance(int feature, const Vec2& p) const {
    const Vec2 f = p - vertex(feature / 2), d = vertex(feature / 2 + 1) - vertex(feature / 2);
    const double t = feature % 2 == 0 ? 0 : std::clamp(f.dot(d) / d.dot(d), 0.0, 1.0);
    const Vec2 rest = f - t * d;
    return rest.norm();
  }
  double least(const Vec2& p) const {
    double best = INFINITY;
    for (int i = 0; i < 2 * size(); ++i) best = std::min(best, distance(i, p));
    return best;
  }
};

}  // namespace

TEST_CASE("features are followed in a step or two, however many there are, with dents they mislead", "[words]") {
  CHECK(solved_with("distance", "a step or two is enough, however many there are: O(1)"));
  CHECK(solved_with("distance", "With dents the walk may stop at a pair that is not nearest."));
  for (const int n : {8, 64, 512}) {
    Features round;
    for (int i = 0; i < n; ++i) round.ring.emplace_back(std::cos(full_turn * i / n), std::sin(full_turn * i / n));
    const double step = 0.45 * full_turn / n;  // less than a feature, seen from the centre
    int feature = 0, most = 0;
    for (int k = 0; k < 3 * n; ++k) {
      const Vec2 p(2 * std::cos(k * step), 2 * std::sin(k * step));
      int steps = 0;
      for (int to = round.next(feature, p); to != feature && steps < 2 * n; to = round.next(feature, p))
        feature = to, ++steps;
      most = std::max(most, steps);
      CHECK(round.distance(feature, p) == Approx(round.least(p)));
    }
    INFO(n);
    CHECK((1 <= most && most <= 2));
  }
  const Features bowl = {{{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}};
  const Vec2 p(2.25, 2.5);
  const int left = 2 * 5 + 1;  // the inner side of the left arm
  CHECK(bowl.next(left, p) == left);
  CHECK(bowl.distance(left, p) > bowl.least(p));
}

TEST_CASE("eleven axes separate triangles in two planes, and six normals of sides those in one", "[words]") {
  CHECK(solved_with("triangle-triangle", "Eleven, if no plane holds both"));
  bench::Random random = random_of("axes");
  int apart = 0, meet = 0, flat = 0;
  for (int k = 0; k < 600; ++k) {
    const bool same = k % 2 == 0;
    const auto triangle = [&] {
      Triangle<double, 3> t;
      for (auto& v : t.vertices)
        for (int i = 0; i < 3; ++i) v[i] = i == 2 && same ? 0 : random.integer(0, 6);
      return t;
    };
    const Triangle<double, 3> a = triangle(), b = triangle();
    const auto side = [](const Triangle<double, 3>& t, std::size_t i) {
      return Vec3(t.vertices[(i + 1) % 3] - t.vertices[i]);
    };
    const Vec3 n_a = side(a, 0).cross(side(a, 1)), n_b = side(b, 0).cross(side(b, 1));
    if (n_a.isZero(0) || n_b.isZero(0)) continue;
    const bool one_plane =
        std::ranges::all_of(b.vertices, [&](const Vec3& v) { return n_a.dot(Vec3(v - a.vertices[0])) == 0; });
    std::vector<Vec3> axes;
    if (!one_plane) axes = {n_a, n_b};
    for (std::size_t i = 0; i < 3; ++i) {
      if (one_plane) axes.emplace_back(n_a.cross(side(a, i))), axes.emplace_back(n_a.cross(side(b, i)));
      for (std::size_t j = 0; j < 3 && !one_plane; ++j) axes.emplace_back(side(a, i).cross(side(b, j)));
    }
    CHECK(axes.size() == (one_plane ? 6U : 11U));
    const auto reach = [](const Triangle<double, 3>& t, const Vec3& n) {
      return std::minmax({n.dot(t.vertices[0]), n.dot(t.vertices[1]), n.dot(t.vertices[2])});
    };
    const bool separated = std::ranges::any_of(axes, [&](const Vec3& n) {
      const std::pair<double, double> x = reach(a, n), y = reach(b, n);
      return x.second < y.first || y.second < x.first;
    });
    CHECK(separated != intersects(a, b));
    apart += separated, meet += !separated, flat += one_plane;
  }
  for (const int seen : {apart, meet, flat}) CHECK(seen > 20);
}

TEST_CASE("with heights taken for 0 triangles a little apart meet, heights grow with the cube of the size", "[words]") {
  CHECK(solved_with("triangle-triangle", "triangles a little apart may count as meeting"));
  CHECK(solved_with("triangle-triangle", "grow with the cube of the size"));
  namespace own = triangle_triangle::detail;
  const double gap = 0x1p-24;
  const Triangle<double, 3> a = {{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)}};
  const Triangle<double, 3> b = {{Vec3(1, 1, gap), Vec3(5, 1, gap), Vec3(1, 5, gap)}};
  CHECK_FALSE(intersects(a, b));
  const std::array<double, 3> heights = own::heights<double>(b, own::normal(a), a.vertices[0]);
  for (const double h : heights) CHECK((h > 0 && h < 1e-5));  // of 1e-5 in size and less all are 0
  const auto turn = [](const Vec2& p, const Vec2& q, const Vec2& r) { return own::sign<double>(cross(q - p, r - p)); };
  CHECK(own::meet_in_plane(a, b, 2, turn, NoTrace{}));
  const auto twice = [](Triangle<double, 3> t) {
    for (auto& v : t.vertices) v = 2 * v;
    return t;
  };
  const std::array<double, 3> larger = own::heights<double>(twice(b), own::normal(twice(a)), twice(a).vertices[0]);
  for (std::size_t i = 0; i < 3; ++i) CHECK(larger[i] == 8 * heights[i]);
}

TEST_CASE("what each edge puts out makes the ring of the method, a convex outline is crossed twice at most",
          "[words]") {
  CHECK(solved_with("clipping", "An edge from in to in puts out its end; from in to out, the crossing."));
  CHECK(solved_with("clipping", "From out to in it puts out the crossing, then its end; from out to out, nothing."));
  CHECK(solved_with("clipping", "a cut that adds two vertices removes at least one"));
  bench::Random random = random_of("four cases");
  std::array<int, 4> cases = {};
  for (int k = 0; k < 300; ++k) {
    Ring<double, 2> ring;
    for (int i = 0; i < 8; ++i) ring.push_back(random.in_box<2>(1));
    const bool convex = k % 2 == 0;
    if (convex) ring = convex_hull(ring);
    const Plane<double, 2> side = {random.heading<2>(), random.uniform(-0.5, 0.5)};
    Ring<double, 2> out;
    std::size_t crossings = 0, removed = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point<double, 2>&s = ring[i], &e = ring[(i + 1) % ring.size()];
      const double from = side.normal.dot(s) + side.d, to = side.normal.dot(e) + side.d;
      REQUIRE((from != 0 && to != 0));
      const Point<double, 2> crossing = s + (from / (from - to)) * (e - s);
      ++cases[(from > 0 ? 2U : 0U) + (to > 0 ? 1U : 0U)];
      if ((from > 0) != (to > 0)) out.push_back(crossing), ++crossings;
      if (to > 0) out.push_back(e);
      removed += from < 0;
    }
    if (!out.empty() && out.back() == ring.front()) std::ranges::rotate(out, out.end() - 1);
    CHECK(out == clip_polygon::sutherland_hodgman(ring, side));
    if (!convex) continue;
    CHECK(crossings <= 2);
    CHECK((crossings == 0 || removed >= 1));
  }
  for (const int seen : cases) CHECK(seen > 0);
}

}  // namespace answers_words_test
