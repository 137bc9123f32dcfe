#include "lessons/collision/flight.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "lessons/shared/flat.h"

namespace isect::lessons::collision_lesson {

using namespace viz;

namespace {

Region filled_box(const Aabb<double, 2>& b, Role role) {
  Region r;
  r.rings = {corners(b)};
  r.role = role;
  return r;
}
Chain outline_of(const Aabb<double, 2>& b, Role role) { return {corners(b), true, role, Pen::construction}; }

}  // namespace

Moving<Aabb, double, 2> bullet_at(const Vec3& p, double speed) {
  return {{{p.x() - 0.25, p.y() - 0.25}, {p.x() + 0.25, p.y() + 0.25}}, {speed, 0}};
}
Moving<Aabb, double, 2> the_wall() { return {{{0.4, -1.75}, {0.6, 1.75}}, {0, 0}}; }

Aabb<double, 2> FlightPicture::place(double t) const {
  return motion::moved(bullet_.shape, Vector<double, 2>(t * bullet_.velocity));
}

Scene FlightPicture::picture() const {
  Scene scene = drawn({});
  if (rests()) return scene;
  const std::optional<double> first = grown_ && truth_ ? std::optional(truth_->lo) : std::nullopt;
  const auto at = [flight = *this](double t) { return flight.drawn(t); };
  scene.time = std::make_shared<const Scene::Time>(Scene::Time{0, duration, std::max(at_, 0.0), first, at});
  return scene;
}

Scene FlightPicture::drawn(std::optional<double> now) const {
  Scene scene;
  scene.items.emplace_back(filled_box(wall_.shape, Role::second));
  if (!grown_) scene.items.emplace_back(Label{Vec3(wall_.shape.hi.x(), 1.5, 0), "wall", Role::second});
  if (swept_) {
    const Vector<double, 2> way = duration * bullet_.velocity;
    scene.items.emplace_back(outline_of(swept_aabb(bullet_.shape, way), Role::construction));
  }
  for (const double t : seen_) scene.items.emplace_back(outline_of(place(t), Role::first));
  if (grown_) draw_contact(scene);
  if (now) {
    draw_now(scene, *now);
  } else if (at_ >= 0) {
    scene.items.emplace_back(filled_box(place(at_), Role::first));
    scene.items.emplace_back(
        Label{middle(place(at_)) + Vec3(0, 0.25, 0), fmt::format("*t* = {}", shown(at_)), Role::first});
  }
  scene.items.emplace_back(Dot{middle(place(0)), Mark::disc, Role::first});
  scene.items.emplace_back(Label{middle(place(0)), "**p**", Role::first});
  scene.handles.push_back({"p", Handle::Kind::point, middle(place(0)), Vec3::Zero(), Role::first});
  return scene;
}

/// Draws the expanded wall, the path of the box's centre, and where it enters and leaves.
void FlightPicture::draw_contact(Scene& scene) const {
  const Vector<double, 2> half = (bullet_.shape.hi - bullet_.shape.lo) / 2;
  scene.items.emplace_back(outline_of({wall_.shape.lo - half, wall_.shape.hi + half}, Role::second));
  scene.items.emplace_back(Arrow{middle(place(0)), middle(place(duration)), Role::first, Pen::solid});
  if (!truth_) return;
  scene.items.emplace_back(Dot{middle(place(truth_->lo)), Mark::disc, Role::hit});
  scene.items.emplace_back(Label{middle(place(truth_->lo)), "*t*_{in}", Role::hit});
  if (!(truth_->hi < duration)) return;
  scene.items.emplace_back(Dot{middle(place(truth_->hi)), Mark::ring, Role::hit});
  scene.items.emplace_back(Label{middle(place(truth_->hi)), "*t*_{out}", Role::hit});
}

void FlightPicture::draw_now(Scene& scene, double now) const {
  if (!grown_) return void(scene.items.emplace_back(filled_box(place(now), Role::first)));
  scene.items.emplace_back(outline_of(place(now), Role::first));
  scene.items.emplace_back(Dot{middle(place(now)), Mark::disc, Role::first});
}

}  // namespace isect::lessons::collision_lesson
