#include <fmt/format.h>

#include "lessons/clipping/picture.h"

namespace isect::lessons::clipping_lesson {

using namespace viz;

namespace {

void add_line(const Narrowing& k, const Side* side, const double* crossing, Scene& scene) {
  const auto line = [&](double from, double to, Role role, Pen pen) {
    if (from < to) scene.items.emplace_back(Line{flat(k.at(from)), flat(k.at(to)), role, pen});
  };
  line(0, k.left ? 1 : k.range.lo, Role::construction, Pen::construction);
  line(k.range.hi, k.left ? k.range.hi : 1, Role::construction, Pen::construction);
  if (!k.left) line(k.range.lo, k.range.hi, k.settled ? Role::hit : Role::first, k.settled ? Pen::thick : Pen::solid);
  if (side) add_side(*side, k.box, scene);
  if (crossing && -0.25 <= *crossing && *crossing <= 1.25) {
    line(*crossing, 0, Role::construction, Pen::construction);
    line(1, *crossing, Role::construction, Pen::construction);
    const bool new_end = !k.left && (*crossing == k.range.lo || *crossing == k.range.hi);
    scene.items.emplace_back(
        Dot{flat(k.at(*crossing)), new_end ? Mark::disc : Mark::uncounted, new_end ? Role::hit : Role::construction});
    scene.items.emplace_back(Label{flat(k.at(*crossing)), "*t*", Role::text});
  }
}

Axis axis(const Narrowing& k, const double* crossing) {
  Axis axis;
  axis.lo = -0.25, axis.hi = 1.25;
  if (!k.left && k.started) axis.shared = Vec2(k.range.lo, k.range.hi);
  if (!k.left && k.started) {
    axis.ticks.push_back(
        {k.range.lo, Mark::disc, Role::hit, k.range.lo == k.range.hi ? "*t*_{in} = *t*_{out}" : "*t*_{in}"});
    if (k.range.lo != k.range.hi) axis.ticks.push_back({k.range.hi, Mark::ring, Role::hit, "*t*_{out}"});
  }
  const bool apart = crossing && *crossing != k.range.lo && *crossing != k.range.hi;
  if (crossing && (apart || k.left) && axis.lo <= *crossing && *crossing <= axis.hi)
    axis.ticks.push_back({*crossing, Mark::uncounted, Role::construction, "*t*"});
  return axis;
}

}  // namespace

Scene picture(const Narrowing& k, const Side* side, const double* crossing) {
  Scene scene;
  scene.items.emplace_back(region(k.box));
  add_line(k, side, crossing, scene);
  if (k.settled && !k.left && k.range.lo == k.range.hi)
    scene.items.emplace_back(Dot{flat(k.at(k.range.lo)), Mark::diamond, Role::highlight});
  for (const auto& [point, name] : {std::pair{k.segment.p, "p"}, {k.segment.q, "q"}}) {
    scene.items.emplace_back(Dot{flat(point), Mark::disc, Role::first});
    scene.items.emplace_back(Label{flat(point), fmt::format("**{}**", name), Role::first});
    scene.handles.push_back({name, Handle::Kind::point, flat(point), Vec3::Zero(), Role::first});
  }
  add_grips(k.box, scene);
  scene.axis = axis(k, crossing);
  return scene;
}

}  // namespace isect::lessons::clipping_lesson
