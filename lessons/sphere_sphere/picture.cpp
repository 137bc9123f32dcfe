#include <cmath>

#include "lessons/shared/plane.h"
#include "lessons/sphere_sphere/picture.h"

namespace isect::lessons::sphere_sphere_lesson {

using namespace viz;

namespace {

/// The circle or the point that the two surfaces share, if any.
void shared(Scene& scene, const Setup& s) {
  const Vec3 l = s.b.center - s.a.center;
  const double d = l.norm(), r1 = s.a.radius, r2 = s.b.radius;
  if (!(d > 0) || s.truth == Relation::disjoint) return;
  const double along = (d * d + r1 * r1 - r2 * r2) / (2 * d), rest = r1 * r1 - along * along;
  const Vec3 middle = s.a.center + along / d * l;
  if (s.truth == Relation::overlapping && rest > 0)
    scene.items.push_back(Circle{middle, std::sqrt(rest), Role::hit, Pen::thick, true, l});
  if (s.truth == Relation::touching || s.inner_touch) scene.items.push_back(Dot{middle, Mark::disc, Role::hit});
}

}  // namespace

Setup setup(const Parameters& p) {
  Setup s;
  s.a = {std::get<Vec3>(p.at("a")), std::get<double>(p.at("r_a"))};
  s.b = {std::get<Vec3>(p.at("b")), std::get<double>(p.at("r_b"))};
  const std::string& unit = std::get<std::string>(p.at("unit"));
  s.unit = unit == "huge" ? 0x1p600 : unit == "tiny" ? 0x1p-600 : 1;
  int inner = 1;
  s.truth = relate(s.tested(s.a), s.tested(s.b), [&](const auto& event) {
    if constexpr (requires { event.inner; }) inner = event.inner;
  });
  s.inner_touch = inner == 0 && (s.truth == Relation::a_inside_b || s.truth == Relation::b_inside_a);
  return s;
}

Scene picture(const Setup& s, Focus focus) {
  Scene scene;
  const Vec3 a = s.a.center, b = s.b.center, l = b - a;
  const double d = l.norm();
  scene.items = {Ball{a, s.a.radius, Role::first}, Ball{b, s.b.radius, Role::second}};
  const bool lit = focus == Focus::line || focus == Focus::distance;
  if (d > 0) {
    const Role role = lit ? Role::highlight : Role::construction;
    const Pen pen = lit ? Pen::highlight : Pen::construction;
    scene.items.push_back(focus == Focus::line ? Item(Arrow{a, b, role, pen}) : Item(Line{a, b, role, pen}));
    const bool radii = focus == Focus::radii;
    const Vec3 e = l / d;
    if (radii) {
      scene.items.push_back(Line{a, a + s.a.radius * e, Role::first, Pen::thick});
      scene.items.push_back(Line{b, b - s.b.radius * e, Role::second, Pen::thick});
      scene.items.push_back(Label{a, "*r*_a", Role::first, a + s.a.radius * e});
      scene.items.push_back(Label{b, "*r*_b", Role::second, b - s.b.radius * e});
    } else {
      scene.items.push_back(Label{a, focus == Focus::line ? "**l**" : "*d*", Role::text, b});
    }
  }
  scene.items.push_back(Dot{a, Mark::disc, Role::first});
  scene.items.push_back(Dot{b, Mark::disc, Role::second});
  scene.items.push_back(Label{a, "**a**", Role::first});
  scene.items.push_back(Label{b, "**b**", Role::second});
  if (focus == Focus::settled) shared(scene, s);
  const Vec3 down = -upwards() / axis_length;
  scene.handles = {{"a", Handle::Kind::point, a, Vec3::Zero(), Role::first},
                   {"b", Handle::Kind::point, b, Vec3::Zero(), Role::second},
                   {"r_a", Handle::Kind::length, a + s.a.radius * down, a, Role::first},
                   {"r_b", Handle::Kind::length, b + s.b.radius * down, b, Role::second}};
  return scene;
}

}  // namespace isect::lessons::sphere_sphere_lesson
