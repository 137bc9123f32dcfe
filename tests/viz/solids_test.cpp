#include "viz/solids.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include <isect/ray_aabb.h>
#include <isect/ray_obb.h>
#include "tests/catch.h"
#include "viz/compose/visibility.h"

namespace solids_test {
using namespace isect;
using namespace isect::viz;

namespace {

using Box = Aabb<double, 3>;

const Box unit_box = {{-1, -1, -1}, {1, 1, 1}};

View view_of(bool perspective) {
  Camera c;
  c.perspective = perspective;
  c.azimuth = 0.5;
  c.target = {0.2, 0.1, 0};
  return {c, 480, 300};
}

double length(const std::vector<Stretch>& parts, bool hidden) {
  double sum = 0;
  for (const Stretch& part : parts)
    for (std::size_t i = 1; part.hidden == hidden && i < part.points.size(); ++i)
      sum += (part.points[i] - part.points[i - 1]).norm();
  return sum;
}

/// Euler's formula, each edge between two faces, normals outwards.
void check_closed(const Solid& solid) {
  const Shell s = shell(solid);
  CHECK(solid.vertices.size() + solid.faces.size() == s.edges.size() + 2);
  for (const Shell::Edge& edge : s.edges) CHECK(edge.faces.size() == 2);
  for (std::size_t i = 0; i < solid.faces.size(); ++i)
    for (const Vec3& p : solid.vertices) CHECK(s.normals[i].dot(p - solid.vertices[solid.faces[i][0]]) < 1e-9);
}

}  // namespace

TEST_CASE("the core's convex shapes become closed solids with the right corners", "[solids]") {
  const Solid box = solid(Box{{0, 1, 2}, {3, 5, 9}}, Role::first);
  check_closed(box);
  for (const Vec3& p : box.vertices)
    for (int axis = 0; axis < 3; ++axis) CHECK((p[axis] == Vec3(0, 1, 2)[axis] || p[axis] == Vec3(3, 5, 9)[axis]));

  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const Obb<double, 3> obb = {{1, 0, 0}, turn, {1, 2, 0.5}};
  check_closed(solid(obb, Role::first));
  for (const Vec3& p : solid(obb, Role::first).vertices)
    CHECK((turn.transpose() * (p - obb.center)).cwiseAbs().isApprox(obb.half));

  const Kdop<double, 3> cut = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}, {{-1, 1}, {-1, 1}, {-1, 1}, {-2, 2}}};
  CHECK(solid(cut, Role::first).vertices.size() == 12);  // two corners are cut off, three new ones each
  check_closed(solid(cut, Role::first));
}

TEST_CASE("cylinders and cones become closed solids of many sides, whose side is drawn without edges", "[solids]") {
  const Solid pillar = solid(Cylinder<double>{{1, 2, 3}, {2, 4, 5}, 1.5}, Role::second),
              cone = solid(Cone<double>{{0, 3, 0}, {0, 0, 1e-9}, 2}, Role::second);
  check_closed(pillar);
  check_closed(cone);
  for (const Vec3& p : pillar.vertices) {
    const Vec3 axis = Vec3(1, 2, 2) / 3, off = p - Vec3(1, 2, 3);
    CHECK(off.cross(axis).norm() == Approx(1.5));
    CHECK((std::abs(off.dot(axis)) < 1e-12 || off.dot(axis) == Approx(3)));
  }
  REQUIRE(pillar.round);
  REQUIRE(cone.round);
  CHECK(pillar.round->to == Vec3(2, 4, 5));
  CHECK_FALSE(pillar.round->pointed);
  CHECK(cone.round->pointed);
  CHECK(cone.vertices.back() == Vec3(0, 3, 0));
}

TEST_CASE("a frustum's corners lie on three of its planes each", "[solids]") {
  const Frustum<double> frustum = {{{{Vec3(1, 0, -0.6), 0},
                                     {Vec3(-1, 0, -0.6), 0},
                                     {Vec3(0, 1, -0.4), 0},
                                     {Vec3(0, -1, -0.4), 0},
                                     {Vec3(0, 0, -1), -1},
                                     {Vec3(0, 0, 1), 4}}}};
  const Solid shape = solid(frustum, Role::first);
  check_closed(shape);
  for (const Vec3& p : shape.vertices) {
    int on = 0;
    for (const Plane<double, 3>& plane : frustum.planes) {
      CHECK(plane.normal.dot(p) + plane.d > -1e-12);
      on += std::abs(plane.normal.dot(p) + plane.d) < 1e-12;
    }
    CHECK(on == 3);
  }
}

TEST_CASE("a point is hidden by a box where the core's ray to the eye crosses its inside", "[solids]") {
  for (const bool perspective : {false, true}) {
    const View view = view_of(perspective);
    Occluders around;
    around.solids.push_back(shell(solid(unit_box, Role::first)));
    int seen = 0, unseen = 0;
    for (int i = 0; i < 2000; ++i) {
      const auto spread = [&](int prime) { return std::remainder(i * 0.6180339887 * prime, 1.0) * 5; };
      const Vec3 p = {spread(1), spread(2), spread(3)};
      const auto crossed = intersect(Ray<double, 3>{p, view.towards_eye(p)}, unit_box);
      const bool expected = crossed && crossed->hi > crossed->lo;
      CHECK(hidden(p, view, around) == expected);
      (expected ? unseen : seen) += 1;
    }
    CHECK(seen > 300);
    CHECK(unseen > 300);
  }
}

TEST_CASE("of a box's twelve edges nine are seen and the three at the far corner are not", "[solids]") {
  for (const bool perspective : {false, true}) {
    const View view = view_of(perspective);
    Occluders around;
    around.solids.push_back(shell(solid(unit_box, Role::first)));
    int whole[2] = {0, 0};
    for (const Shell::Edge& edge : around.solids[0].edges) {
      const std::vector<Stretch> parts = stretches(edge.from, edge.to, view, around);
      REQUIRE(parts.size() == 1);
      CHECK(parts[0].points.front() == edge.from);
      CHECK(parts[0].points.back() == edge.to);
      ++whole[parts[0].hidden];
    }
    CHECK(whole[0] == 9);
    CHECK(whole[1] == 3);
  }
}

TEST_CASE("a segment behind a box is hidden between the silhouette's two edges, however narrow", "[solids]") {
  for (const double half : {1.0, 1e-3, 1e-5}) {
    Occluders around;  // solids are drawn in by a rounding of their size
    Camera flat;
    flat.azimuth = flat.elevation = 0;
    const View front(flat, 480, 300);
    around.solids.push_back(shell(solid(Box{{-half, -1, -1}, {half, 1, 1}}, Role::first)));
    const std::vector<Stretch> parts = stretches({-2, 0, -3}, {3, 0, -3}, front, around);
    REQUIRE(parts.size() == 3);
    CHECK(parts[1].hidden);
    CHECK(parts[1].points.front().x() == Approx(-half).margin(4e-9));
    CHECK(parts[1].points.back().x() == Approx(half).margin(4e-9));
    CHECK(length(parts, true) == Approx(2 * half).margin(8e-9));
    CHECK(length(stretches({-2, 0, 3}, {3, 0, 3}, front, around), true) == 0);  // before the box
  }
}

TEST_CASE("a line through a box is hidden from where it enters", "[solids]") {
  Camera flat;
  flat.azimuth = flat.elevation = 0;
  const View front(flat, 480, 300);
  Occluders around;
  around.solids.push_back(shell(solid(unit_box, Role::first)));
  const std::vector<Stretch> parts = stretches({0, 0, 3}, {0.5, 0.5, -3}, front, around);
  REQUIRE(parts.size() == 2);
  CHECK_FALSE(parts[0].hidden);
  CHECK(parts[0].points.back().z() == Approx(1).margin(1e-6));
}

TEST_CASE("contents are not hidden by what contains them, but by themselves", "[solids]") {
  const View view = view_of(false);
  const Solid inner = solid(Box{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}, Role::first);
  Occluders all;
  all.balls = {{{0, 0, 0}, 5}, {{0, 0, 0}, 0.4}};
  all.solids = {shell(inner), shell(solid(unit_box, Role::second))};
  const Occluders around = around_solid(all, 0, inner.vertices);
  REQUIRE(around.solids.size() == 1);
  REQUIRE(around.balls.size() == 1);
  CHECK(around.balls[0].radius == 0.4);
  CHECK(length(stretches({-0.5, -0.5, -0.5}, {-0.5, 0.5, -0.5}, view, around), true) == Approx(1));
  CHECK(around_ball(all, 1).solids.empty());
  CHECK(around_ball(all, 1).balls.size() == 1);
  CHECK(around_ball(all, 0).solids.size() == 2);
  CHECK(around_solid(all, 1, solid(unit_box, Role::second).vertices).solids.size() == 2);
}

TEST_CASE("a region that hides is a screen, and hides nothing on itself", "[solids]") {
  const View view = view_of(false);
  Occluders around;
  around.screens.push_back({{{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}}}});
  CHECK(hidden({0, -0.2, 0}, view, around));
  CHECK_FALSE(hidden({0, 0.2, 0}, view, around));
  CHECK_FALSE(hidden({0.3, 0, 0.2}, view, around));
  const std::vector<Stretch> parts = stretches({0, 1, 0}, {0, -9, 0}, view, around);
  REQUIRE(parts.size() == 3);
  CHECK(parts[1].hidden);
  CHECK(parts[1].points.front().y() == Approx(0).margin(1e-6));
}

TEST_CASE("a chain's stretches run on over its vertices and over the start of a closed one", "[solids]") {
  Camera flat;
  flat.azimuth = flat.elevation = 0;
  const View front(flat, 480, 300);
  Occluders around;
  around.solids.push_back(shell(solid(Box{{0, -5, -1}, {5, 5, 1}}, Role::first)));
  const std::vector<Vec3> square = {{-2, -2, -3}, {2, -2, -3}, {2, 2, -3}, {-2, 2, -3}};
  const std::vector<Stretch> closed = stretches(square, true, front, around);
  REQUIRE(closed.size() == 2);
  CHECK(length(closed, true) == Approx(8));
  CHECK(length(closed, false) == Approx(8));
  CHECK(stretches(square, false, front, around).size() == 3);
  CHECK(stretches(std::vector<Vec3>{{1, 1, 1}}, false, front, around).empty());
}

TEST_CASE("solids without faces, without area or with numbers that are none hide nothing", "[solids]") {
  const View view = view_of(false);
  Occluders around;
  around.solids = {shell({}), shell({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}, Role::first}),
                   shell({{{0, 0, 0}, {1, 0, 0}}, {{0, 1}}, Role::first})};
  CHECK_FALSE(hidden({0.1, 0.1, -2}, view, around));
  CHECK(stretches({-3, 0, -2}, {3, 0, -2}, view, around).size() == 1);
}

TEST_CASE("a box's face is the rectangle its plane cuts out", "[solids]") {
  const Region side = face(Box{{0, 1, 2}, {3, 5, 9}}, 1, 4, Role::hit);
  REQUIRE(side.rings.size() == 1);
  REQUIRE(side.rings[0].size() == 4);
  const Vec3 area = (side.rings[0][1] - side.rings[0][0]).cross(side.rings[0][2] - side.rings[0][1]);
  CHECK(area == Vec3(0, 21, 0));
  for (const Vec3& p : side.rings[0]) CHECK(p.y() == 4);
}

}  // namespace solids_test
