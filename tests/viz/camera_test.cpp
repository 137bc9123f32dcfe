#include "viz/camera.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "tests/catch.h"

namespace camera_test {
using namespace isect::viz;

namespace {

const Vec3 some_point = {0.3, -1.2, 2.1};

Camera camera(bool perspective) {
  Camera c;
  c.target = {0.5, 1, -0.25};
  c.perspective = perspective;
  return c;
}

}  // namespace

TEST_CASE("on the way from one camera to another each is a valid one, and the shorter way is taken", "[camera]") {
  constexpr double degree = std::numbers::pi / 180;
  const Camera a = {{0, 0, 0}, 170 * degree, 0, 1, false}, b = {{4, 0, 0}, -170 * degree, 1, 4, true};
  const Camera end = between(a, b, 1);
  CHECK(std::abs(std::remainder(end.azimuth - b.azimuth, 360 * degree)) < 1e-12);
  CHECK(end.half_height == Approx(4));
  CHECK(end.field_of_view == b.field_of_view);
  CHECK(between(a, a, 0.3) == a);
  const Camera middle = between(a, b, 0.5);
  CHECK(middle.target == Vec3(2, 0, 0));
  CHECK(std::abs(middle.azimuth) == Approx(180 * degree));
  CHECK(middle.half_height == Approx(2));
  CHECK((middle.perspective && middle.field_of_view > 0 && middle.field_of_view < b.field_of_view));
  CHECK(ease_in_out(0) == 0);
  CHECK(ease_in_out(0.1) < 0.1);
  CHECK(ease_in_out(0.5) == 0.5);
  CHECK(ease_in_out(1) == 1);
}

TEST_CASE("the target is drawn in the middle of the viewport", "[camera]") {
  for (const bool perspective : {false, true}) {
    const View view(camera(perspective), 640, 400, {10, 20});
    const Projected p = view.project(camera(perspective).target);
    CHECK(p.at.x() == Approx(330));
    CHECK(p.at.y() == Approx(220));
    CHECK(p.depth > 0);
  }
}

TEST_CASE("half_height reaches from the middle to the top edge at the target", "[camera]") {
  for (const bool perspective : {false, true}) {
    const View view(camera(perspective), 640, 400);
    const Vec3 top = view.camera().target + view.camera().half_height * view.up();
    CHECK(view.project(top).at.y() == Approx(0).margin(1e-9));
    CHECK(view.scale_at(view.camera().target) == Approx(200 / view.camera().half_height));
  }
}

TEST_CASE("a viewing ray through a point's pixel runs through the point", "[camera]") {
  for (const bool perspective : {false, true}) {
    const View view(camera(perspective), 640, 400, {5, 7});
    const View::ViewingRay line = view.viewing_ray(view.project(some_point).at);
    CHECK(line.direction.norm() == Approx(1));
    const Vec3 off = (some_point - line.origin).cross(line.direction);
    CHECK(off.norm() < 1e-9);
    CHECK((line.direction + view.towards_eye(some_point)).norm() < 1e-9);
  }
}

TEST_CASE("dragging keeps a point on its plane that faces the viewer", "[camera]") {
  for (const bool perspective : {false, true}) {
    const View view(camera(perspective), 640, 400);
    const Vec2 pixel = {123, 321};
    const Vec3 moved = view.on_facing_plane(pixel, some_point);
    CHECK((view.project(moved).at - pixel).norm() < 1e-9);
    CHECK((moved - some_point).dot(view.forward()) == Approx(0).margin(1e-9));
  }
}

TEST_CASE("y is up, x to the right and z towards the viewer at azimuth and elevation 0", "[camera]") {
  Camera c;
  c.azimuth = c.elevation = 0;
  const View view(c, 100, 100);
  CHECK((view.right() - Vec3::UnitX()).norm() < 1e-15);
  CHECK((view.up() - Vec3::UnitY()).norm() < 1e-15);
  CHECK((view.forward() + Vec3::UnitZ()).norm() < 1e-15);
  CHECK(view.project({0, 1, 0}).at.y() < view.project({0, 0, 0}).at.y());
}

}  // namespace camera_test
