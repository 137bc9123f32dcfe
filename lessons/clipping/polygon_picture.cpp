#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "lessons/clipping/picture.h"

namespace isect::lessons::clipping_lesson {

using namespace viz;

bool among(const Ring<double, 2>& ring, const Point<double, 2>& p) { return std::ranges::find(ring, p) != ring.end(); }

Scene picture(const Rest& k, const Cut* cut) {
  static constexpr const char* names[] = {"p", "q", "r", "s"};
  Scene scene;
  scene.items.emplace_back(region(k.box));
  if (cut || k.settled)
    scene.items.emplace_back(Chain{flat(cut ? cut->before : k.original), true, cut ? Role::first : Role::construction,
                                   cut ? Pen::solid : Pen::construction});
  Region rest;
  rest.rings = {flat(k.ring)}, rest.role = k.settled || cut ? Role::hit : Role::first;
  rest.pen = k.settled ? Pen::thick : Pen::solid;
  if (!k.ring.empty()) scene.items.emplace_back(rest);
  if (cut) {
    add_side(cut->side, k.box, scene);
    for (std::size_t i = 0; i < cut->before.size(); ++i)
      scene.items.emplace_back(Dot{flat(cut->before[i]), cut->signs[i] < 0 ? Mark::no : Mark::disc,
                                   cut->signs[i] < 0 ? Role::miss : Role::first});
    for (const Point<double, 2>& x : cut->fresh) scene.items.emplace_back(Dot{flat(x), Mark::ring, Role::hit});
  } else {
    for (const Point<double, 2>& x : k.ring)
      scene.items.emplace_back(Dot{flat(x), Mark::disc, k.settled && !among(k.original, x) ? Role::hit : Role::first});
  }
  for (std::size_t i = 0; i < k.original.size(); ++i) {
    if (cut && !among(cut->before, k.original[i])) continue;  // cut off before
    if (i >= std::size(names)) continue;  // the lesson's have no more; of others, letters enough are named
    scene.items.emplace_back(Label{flat(k.original[i]), fmt::format("**{}**", names[i]), Role::first});
    scene.handles.push_back({names[i], Handle::Kind::point, flat(k.original[i]), Vec3::Zero(), Role::first});
  }
  add_grips(k.box, scene);
  return scene;
}

}  // namespace isect::lessons::clipping_lesson
