#include "viz/compose/visibility.h"
#include "viz/compose/outlines.h"

#include <Eigen/Geometry>

#include <isect/ray_polygon.h>
#include <isect/ray_sphere.h>
#include <random>
#include "tests/catch.h"

namespace visibility_test {
using namespace isect;
using namespace isect::viz;

namespace {

View view_of(bool perspective) {
  Camera c;
  c.perspective = perspective;
  c.target = {0.2, 0.1, 0};
  return {c, 480, 300};
}

/// Whether the core's own ray through this pixel meets the ball.
bool meets(const View& view, const Vec2& pixel, const Ball& ball) {
  const View::ViewingRay line = view.viewing_ray(pixel);
  return static_cast<bool>(
      intersect(Ray<double, 3>{line.origin, line.direction}, Sphere<double, 3>{ball.center, ball.radius}));
}

bool inside(const Outline& o, const Vec2& p) {
  const Vec2 d = p - o.center;
  const double u = d.dot(o.major) / o.major.squaredNorm(), v = d.dot(o.minor) / o.minor.squaredNorm();
  return u * u + v * v <= 1;
}

/// Views and points that come again in every run.
struct Chance {
  explicit Chance(unsigned seed) : random(seed) {}
  double any(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(random); }
  Vec3 at() {
    const double x = any(-3, 3), y = any(-3, 3), z = any(-3, 3);
    return {x, y, z};
  }
  View view(bool perspective) {
    Camera camera;
    camera.perspective = perspective;
    camera.azimuth = any(-3, 3), camera.elevation = any(-1.4, 1.4);
    return {camera, 480, 300};
  }
  std::mt19937_64 random;
};

}  // namespace

TEST_CASE("a ball's outline is where the core's rays begin to meet it, pixel by pixel", "[visibility]") {
  for (const bool perspective : {false, true}) {
    const View view = view_of(perspective);
    for (const Ball& ball : {Ball{{0, 0, 0}, 1}, Ball{{2, 1, -1}, 0.7}, Ball{{-1.5, -1, 2}, 0.4}}) {
      const Outline o = outline(ball, view);
      int differ = 0, met = 0;
      for (int y = 0; y < 300; ++y) {
        for (int x = 0; x < 480; ++x) {
          const Vec2 pixel = {x + 0.5, y + 0.5};
          const bool hit = meets(view, pixel, ball);
          met += hit;
          if (hit == inside(o, pixel)) continue;
          // Only rounding on the outline itself may tell them apart.
          const Vec2 d = pixel - o.center;
          const double u = d.dot(o.major) / o.major.squaredNorm(), v = d.dot(o.minor) / o.minor.squaredNorm();
          CHECK(std::abs(std::hypot(u, v) - 1) < 1e-9);
          ++differ;
        }
      }
      CHECK(met > 500);
      CHECK(differ <= 2);
    }
  }
}

TEST_CASE("a segment behind a ball is hidden between the outline's two crossings", "[visibility]") {
  const View view = view_of(false);
  const Occluders balls = {{{{0, 0, 0}, 1}}};
  const Vec3 back = 3 * view.forward(), side = 2 * view.right();
  const std::vector<Stretch> parts = stretches(back - side, back + side, view, balls);
  REQUIRE(parts.size() == 3);
  CHECK_FALSE(parts[0].hidden);
  CHECK(parts[1].hidden);
  CHECK_FALSE(parts[2].hidden);
  const Vec3 cut = parts[1].points.front() - back;
  CHECK(cut.dot(view.right()) == Approx(-1).epsilon(1e-6));
  CHECK((parts[0].points.back() - parts[1].points.front()).norm() < 1e-9);
}

TEST_CASE("nothing in front of a ball is hidden, everything inside it is", "[visibility]") {
  for (const bool perspective : {false, true}) {
    const View view = view_of(perspective);
    const Occluders balls = {{{{0, 0, 0}, 1}}};
    CHECK_FALSE(hidden(-2 * view.forward(), view, balls));
    CHECK(hidden(Vec3::Zero(), view, balls));
    CHECK(hidden(2 * view.forward(), view, balls));
    CHECK_FALSE(hidden(2 * view.forward() + 3 * view.right(), view, balls));
  }
}

TEST_CASE("a point on the near side of the surface is visible, on the far side hidden", "[visibility]") {
  const View view = view_of(false);
  const Occluders balls = {{{{0.3, 0.1, -0.2}, 1.5}}};
  for (int i = 1; i < 40; ++i) {
    const double angle = 0.1 + 0.08 * i;  // from facing the eye to facing away
    const Vec3 n = -std::cos(angle) * view.forward() + std::sin(angle) * view.right();
    const Vec3 p = balls.balls[0].center + balls.balls[0].radius * n;
    if (std::abs(std::cos(angle)) > 1e-3) CHECK(hidden(p, view, balls) == (std::cos(angle) < 0));
  }
}

TEST_CASE("half of a ball's equator is hidden by the ball itself", "[visibility]") {
  const View view = view_of(false);
  const Occluders balls = {{{{0, 0, 0}, 1}}};
  double length[2] = {0, 0};
  for (const Stretch& part : stretches(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitZ(), view, balls, 0))
    for (std::size_t i = 1; i < part.points.size(); ++i)
      length[part.hidden] += (part.points[i] - part.points[i - 1]).norm();
  CHECK(length[0] == Approx(std::numbers::pi).epsilon(1e-3));
  CHECK(length[1] == Approx(std::numbers::pi).epsilon(1e-3));
}

TEST_CASE("a screen hides what the core's own ray meets it from, on it and seen edge-on, too", "[visibility]") {
  Chance chance(11);
  int hides = 0, on_it = 0;
  for (int k = 0; k < 4000; ++k) {
    const View view = chance.view(k % 2 == 0);
    const Vec3 p = chance.at(), towards = view.towards_eye(p);
    const Vec3 u = chance.at(),
               v = k % 3 == 0 ? Vec3(towards + 1e-9 * chance.any(-1, 1) * chance.at()) : chance.at();  // or edge-on
    const double small = k % 5 == 0 ? 1e-6 : 1;
    const double ahead = k % 7 == 0 ? 0 : chance.any(-1, 3);  // of the point on the way to the eye
    const Vec3 corner = p + ahead * towards - small * (chance.any(-0.2, 1.2) * u + chance.any(-0.2, 1.2) * v);
    const Polygon<double, 3> screen = {{{corner, corner + small * u, corner + small * (u + v), corner + small * v}}};
    const Vec3 from = k % 2 ? p : Vec3(p + 1e-10 * chance.any(-1, 1) * chance.at());
    const double beyond = 0x1p-30 * std::max(view.camera().half_height, from.norm());
    const double to_eye = view.camera().perspective ? (view.eye() - from).norm() : HUGE_VAL;
    const bool met = intersect(Ray<double, 3>{from, view.towards_eye(from), {beyond, to_eye}}, screen).t.has_value();
    CAPTURE(k);
    CHECK(hidden(from, view, {{}, {}, {screen}}) == met);
    hides += met, on_it += k % 7 == 0 && !met;
  }
  CHECK(hides > 1000);
  CHECK(on_it > 200);
}

TEST_CASE("a ball hides what the core's own ray enters it from, closely past its outline, too", "[visibility]") {
  Chance chance(12);
  int hides = 0, closely_past = 0;
  for (int k = 0; k < 4000; ++k) {
    const View view = chance.view(k % 2 == 0);
    const Vec3 p = chance.at(), towards = view.towards_eye(p), aside = towards.cross(chance.at()).normalized();
    const double radius = std::pow(10, chance.any(-4, 0.5)), off = std::pow(10, chance.any(-12, 0)) * (k % 3 - 1);
    const double ahead = k % 7 == 0 ? 0 : chance.any(-2, 3);  // of the point on the way to the eye
    const Ball ball{p + ahead * towards + radius * (1 + off) * aside, radius};
    const double to_eye = view.camera().perspective ? (view.eye() - p).norm() : HUGE_VAL;
    const auto shared =
        intersect(Ray<double, 3>{p, towards, {0, to_eye}}, Sphere<double, 3>{ball.center, ball.radius * (1 - 0x1p-30)});
    const bool entered = shared && shared.solid->hi > shared.solid->lo;
    CAPTURE(k);
    CHECK(hidden(p, view, {{ball}, {}, {}}) == entered);
    hides += entered, closely_past += !entered && ahead > 0 && std::abs(off) < 1e-6;
  }
  CHECK(hides > 400);
  CHECK(closely_past > 400);
}

TEST_CASE("a screen lies behind the bodies that stand before its plane, all of them, as the eye sees it",
          "[visibility]") {
  const Polygon<double, 3> floor = {{{{-4, 0, -4}, {4, 0, -4}, {4, 0, 4}, {-4, 0, 4}}}};
  Camera camera;
  camera.elevation = 0.5;
  const View above(camera, 480, 300);
  camera.elevation = -0.5;
  const View below(camera, 480, 300);
  const Ball standing{{0, 1, 0}, 1}, higher{{1, 3, 0}, 0.5}, sunk{{2, 0.5, 0}, 1}, under{{0, -2, 0}, 1};
  Solid cube;
  for (int i = 0; i < 8; ++i) cube.vertices.emplace_back(i & 1, (i >> 1 & 1), i >> 2);
  cube.faces = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  Solid lower = cube;
  for (Vec3& v : lower.vertices) v.y() -= 0.25;

  CHECK(lies_behind(floor, above, {{standing, higher}, {}, {}}));
  CHECK_FALSE(lies_behind(floor, below, {{standing, higher}, {}, {}}));
  CHECK_FALSE(lies_behind(floor, above, {{standing, sunk}, {}, {}}));
  CHECK_FALSE(lies_behind(floor, above, {{standing, under}, {}, {}}));
  CHECK(lies_behind(floor, below, {{under}, {}, {}}));
  CHECK(lies_behind(floor, above, {{standing}, {shell(cube)}, {}}));
  CHECK_FALSE(lies_behind(floor, above, {{standing}, {shell(lower)}, {}}));
  CHECK_FALSE(lies_behind(floor, above, {{}, {}, {}}));  // then nothing is to be drawn over it
  CHECK_FALSE(lies_behind({}, above, {{standing}, {}, {}}));
}

TEST_CASE("each part of a segment among many balls is hidden or not, as its points are", "[visibility]") {
  Chance chance(13);
  int parts = 0, hides = 0;
  for (int k = 0; k < 500; ++k) {
    const View view = chance.view(k % 2 == 0);
    Occluders all;
    for (int i = 0; i < 8; ++i) all.balls.push_back({chance.at(), chance.any(0.1, 1)});
    for (const Stretch& part : stretches(chance.at(), chance.at(), view, all)) {
      CHECK(hidden((part.points.front() + part.points.back()) / 2, view, all) == part.hidden);
      ++parts, hides += part.hidden;
    }
  }
  CHECK(parts > 600);
  CHECK(hides > 200);
}

TEST_CASE("balls that are seen apart hide nothing of each other, in either projection", "[visibility]") {
  for (const bool perspective : {false, true}) {
    const View view = view_of(perspective);
    Chance chance(11);
    int apart = 0, together = 0;
    for (int i = 0; i < 600; ++i) {
      const auto place = [&] { return Vec3(chance.any(-3, 3), chance.any(-3, 3), chance.any(-3, 3)); };
      const Ball a = {place(), chance.any(0.1, 1.5)}, b = {place(), chance.any(0.1, 1.5)};
      if (!seen_apart(view, a.center, a.radius, b.center, b.radius)) {
        ++together;
        continue;
      }
      ++apart;
      for (int k = 0; k < 24; ++k) {
        const Vec3 way(chance.any(-1, 1), chance.any(-1, 1), chance.any(-1, 1));
        CHECK_FALSE(hidden(a.center + a.radius * way.normalized(), view, {{b}, {}, {}}));
      }
      Occluders all;
      all.balls = {a, b};
      CHECK(around_ball(all, 0, &view).balls.size() == 1);
    }
    CHECK((apart > 200 && together > 50));
  }
}

}  // namespace visibility_test
