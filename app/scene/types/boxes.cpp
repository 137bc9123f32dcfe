// Boxes along the axes and oriented ones.

#include <algorithm>
#include <array>
#include <cmath>

#include "app/scene/types/rows.h"

namespace isect::program::scene {

namespace {

using viz::Vec3;

void draw_box(Drawing& d) {
  const Vec3 lo = d.at("lo"), hi = d.at("hi");
  if (d.s.flat)
    d.region({lo, {hi.x(), lo.y(), 0}, hi, {lo.x(), hi.y(), 0}});
  else
    d.items.push_back(viz::solid(Aabb<double, 3>{lo, hi}, d.role));
  d.name((lo + hi) / 2);
}

void draw_obb(Drawing& d) {
  const Vec3 c = d.at("center"), e = d.at("half"), u = e.x() * d.at("u"), v = e.y() * d.at("v");
  if (d.s.flat)
    d.region({c - u - v, c + u - v, c + u + v, c - u + v});
  else
    d.items.push_back(viz::solid(made<Obb<double, 3>>(d.s, d.o), d.role));
  d.name(c);
}

/// Adds its faces, each moved alone: no further than to the one across.
void grip_box(Grips& g) {
  const Vec3 lo = g.at("lo"), hi = g.at("hi");
  for (int i = 0; i < (g.s.flat ? 2 : 3); ++i) {
    const Vec3 along = Vec3::Unit(i);
    Vec3 low = lo / 2 + hi / 2, high = low;
    low[i] = lo[i], high[i] = hi[i];
    g.face("lo", i, low, Vec3::Zero(), along).hi = hi[i];
    g.face("hi", i, high, Vec3::Zero(), along).lo = lo[i];
  }
}

/// Adds a face along each axis, which moves as the one across, and beyond it a knob that turns the frame.
void grip_obb(Grips& g) {
  const Vec3 center = g.at("center"), half = g.at("half");
  const std::vector<std::string> axes =
      g.s.flat ? std::vector<std::string>{"u", "v"} : std::vector<std::string>{"u", "v", "w"};
  const double beyond = std::max(0.3 * half.norm(), 0.05 * g.room.reach);
  for (int i = 0; i < static_cast<int>(axes.size()); ++i) {
    const std::string& axis = axes[static_cast<std::size_t>(i)];
    const Vec3 along = g.s.point(g.o, axis);
    g.face("half", i, center + half[i] * along, center, along).lo = 0;
    std::vector<std::string> others = axes;
    std::erase(others, axis);
    g.turn(axis, others, center + (half[i] + beyond) * along, center);
  }
}

bool has_axes(const NamedValues& s, const Object& o) {
  constexpr double as_written = 1e-6;  // people write six digits or more; the tests take them as they are
  const std::array<Vec3, 3> axes = {s.point(o, "u"), s.point(o, "v"), s.has(o, "w") ? s.point(o, "w") : Vec3::UnitZ()};
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(axes[i].norm() - 1) <= as_written)) return false;
    if (!(std::abs(axes[i].dot(axes[(i + 1) % 3])) <= as_written)) return false;
  }
  return true;
}

}  // namespace

std::vector<TypeSpec> box_types() {
  TypeSpec box = row<Aabb<double, 3>>(Type::box);
  box.extent = [](const NamedValues& s, const Object& o) { return std::vector{s.point(o, "lo"), s.point(o, "hi")}; };
  box.draw = draw_box;
  box.whole = {"lo", "hi"};
  box.grips = grip_box;

  TypeSpec obb = row<Obb<double, 3>>(Type::obb);
  obb.words = obb.in_plane = "oriented box";
  for (FieldSpec& field : obb.fields)
    if (field.name == "w") field.help += "; none in the plane", field.optional = true;
  obb.rules.push_back({"u", "axes of length 1 at right angles, to six digits", has_axes});
  obb.extent = [](const NamedValues& s, const Object& o) {
    return around(s.point(o, "center"), s.point(o, "half").norm());
  };
  obb.draw = draw_obb;
  obb.grips = grip_obb;
  return {box, obb};
}

}  // namespace isect::program::scene
