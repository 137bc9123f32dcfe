#include "lessons/culling/picture.h"

#include <fmt/format.h>

#include <cmath>

#include <isect/clip_polygon.h>
#include "viz/solids.h"

namespace isect::lessons::culling_lesson {

using namespace viz;

const char* const plane_names[6] = {"left", "right", "bottom", "top", "near", "far"};

Frustum<double> frustum(const Vec3& eye) {
  const auto plane = [&](const Vec3& normal, double distance) {
    return Plane<double, 3>{normal, -normal.dot(eye) - distance};
  };
  return {{plane({3, 0, 8}, 0), plane({3, 0, -8}, 0), plane({1, 4, 0}, 0), plane({1, -4, 0}, 0), plane({1, 0, 0}, 1.5),
           plane({-1, 0, 0}, -7)}};
}

namespace {

/// " + 12", " − 12", or nothing.
std::string plus(double x) { return x == 0 ? "" : fmt::format(" {} {}", x < 0 ? "−" : "+", shown(std::abs(x))); }

/// "*x* + 4" for −4.
std::string less(const char* name, double x) { return x == 0 ? name : name + plus(-x); }

}  // namespace

std::string inner_side(const Plane<double, 3>& plane) {
  std::string all;
  for (int axis = 0; axis < 3; ++axis) {
    const double n = plane.normal[axis];
    if (n == 0) continue;
    all += all.empty() ? (n < 0 ? "−" : "") : n < 0 ? " − " : " + ";
    all += (std::abs(n) == 1 ? "" : shown(std::abs(n)) + " ") + std::string("*") + "xyz"[axis] + "*";
  }
  return all + plus(plane.d) + " ≥ 0";
}

std::string inner_side(const Vec3& eye) {
  const std::string x = less("*x*", eye.x());
  return fmt::format("{} ≤ *x* ≤ {}, 4 |{}| ≤ {} and 8 |{}| ≤ 3 {}", shown(eye.x() + 1.5), shown(eye.x() + 7),
                     less("*y*", eye.y()), x, less("*z*", eye.z()), eye.x() == 0 ? x : "(" + x + ")");
}

namespace {

/// Records the events about planes and ignores all others.
struct Planes {
  std::vector<frustum_planes::Tested> tested;

  void operator()(const frustum_planes::Tested& event) { tested.push_back(event); }
  template <class Event>
  void operator()(const Event&) {}
};

}  // namespace

Answer ask(const Volume& volume, const Frustum<double>& view) {
  Planes planes;
  const Culling culling = std::visit([&](const auto& v) { return isect::cull(v, view, planes); }, volume);
  return {culling, planes.tested};
}

std::vector<Ring<double, 3>> faces_inside(const Box& box, const Frustum<double>& view) {
  std::vector<Ring<double, 3>> parts;
  for (int axis = 0; axis < 3; ++axis)
    for (const double at : {box.lo[axis], box.hi[axis]}) {
      Ring<double, 3> ring = face(box, axis, at, Role::hit).rings[0];
      for (const Plane<double, 3>& plane : view.planes) ring = clip(ring, plane);
      if (!ring.empty()) parts.push_back(ring);
    }
  return parts;
}

Vec3 middle(const Volume& volume) {
  if (const Ball* ball = std::get_if<Ball>(&volume)) return ball->center;
  const Box& box = std::get<Box>(volume);
  return (box.lo + box.hi) / 2;
}

const char* word(Culling c) { return c == Culling::inside ? "inside" : c == Culling::outside ? "outside" : "crossing"; }

Role role_of(Culling c) { return c == Culling::inside ? Role::hit : c == Culling::outside ? Role::miss : Role::second; }

Mark mark_of(Culling c) { return c == Culling::inside ? Mark::disc : c == Culling::outside ? Mark::no : Mark::diamond; }

void add(const Volume& volume, Role role, Scene& scene) {
  if (const Ball* ball = std::get_if<Ball>(&volume))
    scene.items.emplace_back(viz::Ball{ball->center, ball->radius, role});
  else
    scene.items.emplace_back(solid(std::get<Box>(volume), role));
}

void add(const Volume& volume, const Answer& answer, Scene& scene) {
  add(volume, role_of(answer.culling), scene);
  const Vec3 at = middle(volume);
  const Role role = answer.culling == Culling::crossing ? Role::highlight : role_of(answer.culling);
  scene.items.emplace_back(Dot{at, mark_of(answer.culling), role});
  if (answer.rejecting_plane() >= 0)
    scene.items.emplace_back(Label{at, plane_names[answer.rejecting_plane()], Role::miss});
}

void add_view(const Frustum<double>& view, const Vec3& eye, Scene& scene) {
  const Solid body = solid(view, Role::first);
  scene.items.emplace_back(body);
  for (const int corner : {0, 1, 2, 3})
    scene.items.emplace_back(Line{eye, body.vertices[corner], Role::construction, Pen::construction});
  scene.items.emplace_back(Dot{eye, Mark::disc, Role::first});
  scene.items.emplace_back(Label{eye, "eye", Role::first});
}

void add_plane(const Frustum<double>& view, int plane, Scene& scene) {
  static constexpr int face_of[6] = {0, 3, 1, 4, 2, 5};  // a solid's faces: the lower ones first
  const Solid body = solid(view, Role::first);
  Region side;
  side.role = Role::highlight, side.pen = Pen::highlight;
  side.rings.emplace_back();
  Vec3 center = Vec3::Zero();
  for (const int i : body.faces[face_of[plane]]) {
    side.rings[0].push_back(body.vertices[i]);
    center += side.rings[0].back() / 4;
  }
  scene.items.emplace_back(side);
  const Vec3 tip = center + 1.4 * view.planes[plane].normal.normalized();
  scene.items.emplace_back(Arrow{center, tip, Role::text, Pen::thick});
  scene.items.emplace_back(Label{tip, "**n**", Role::text});
}

}  // namespace isect::lessons::culling_lesson
