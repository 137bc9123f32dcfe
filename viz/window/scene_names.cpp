#include "viz/window/scene_names.h"

#include <algorithm>

namespace isect::viz {
namespace {

bool is_tip(const Scene& scene, const Vec3& at) {
  return std::ranges::any_of(scene.items, [&](const Item& item) {
    const Arrow* arrow = std::get_if<Arrow>(&item);
    return arrow && arrow->to == at;
  });
}

bool stands_at(const Label& label, const Handle& h) { return (label.at - h.at).norm() <= 1e-9 * (1 + h.at.norm()); }

}  // namespace

Scene with_names(const Player& player) {
  Scene scene = player.scene();
  for (const Handle& h : scene.handles) {
    if (!h.one_of.empty()) continue;  // so many names would hide the rest: the pointer asks for one
    std::string name = h.parameter;
    for (const Parameter& p : player.lesson().parameters)
      if (p.name == h.parameter && !p.label.empty()) name = p.label;
    const auto names = [&](const Item& item) {
      const Label* label = std::get_if<Label>(&item);
      if (!label || label->text.find(name) == std::string::npos) return false;
      return stands_at(*label, h) || (label->text == name && !is_tip(player.scene(), label->at));
    };
    if (std::ranges::any_of(scene.items, names)) continue;
    std::erase_if(scene.items, [&](const Item& item) {
      const Label* label = std::get_if<Label>(&item);
      return label && label->text == name;
    });
    scene.items.emplace_back(Label{h.at, name, h.role});
  }
  for (Item& item : scene.items)
    if (Label* label = std::get_if<Label>(&item); label && !label->until)
      label->at_handle = std::ranges::any_of(scene.handles, [&](const Handle& h) { return stands_at(*label, h); });
  return scene;
}

}  // namespace isect::viz
