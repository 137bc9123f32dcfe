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

/// Above the second number of handles that have names of their own, none has its name beside it; above the first, parts
/// of objects ("A.lo") have none. The name is shown for the handle under the pointer or with the keyboard's ring.
constexpr std::size_t few_handles = 6, most_named_handles = 12;
/// A scene with more names than this shows only those of the objects it is about, or none if these are too many, too.
constexpr std::size_t most_names = 24;

/// Removes names from a scene made from a file, if there are too many.
void thin_out(Scene& scene) {
  const auto is_name = [](const Item& item) { return std::holds_alternative<Label>(item); };
  const auto too_many = [&] {
    return static_cast<std::size_t>(std::ranges::count_if(scene.items, is_name)) > most_names;
  };
  if (!too_many()) return;
  erase_if(scene.items, [&](const Item& item) { return is_name(item) && std::get<Label>(item).role == Role::muted; });
  if (too_many()) erase_if(scene.items, is_name);
}

bool stands_at(const Label& label, const Handle& h) { return (label.at - h.at).norm() <= 1e-9 * (1 + h.at.norm()); }

}  // namespace

std::string name_of(const Player& player, const Handle& h) {
  if (!h.name.empty() && !h.one_of.empty()) return h.one_of;  // its parameter is another handle's, too
  for (const Parameter& p : player.lesson().parameters)
    if (p.name == h.parameter && !p.label.empty()) return p.label;
  return h.parameter;
}

bool is_named(const Player& player, const Handle& h) {
  const auto could_be = [](const Handle& one) { return one.one_of.empty(); };  // those of faces and of wholes have none
  if (!could_be(h) || !draws_handles(player.scene())) return false;
  const auto handles = static_cast<std::size_t>(std::ranges::count_if(player.scene().handles, could_be));
  const bool part = !player.lesson().made_from.empty() && name_of(player, h).find('.') != std::string::npos;
  return handles <= most_named_handles && (!part || handles <= few_handles);
}

Scene with_names(const Player& player) {
  Scene scene = player.scene();
  if (!player.lesson().made_from.empty()) thin_out(scene);
  for (const Handle& h : scene.handles) {
    if (!is_named(player, h)) continue;
    const std::string name = name_of(player, h);
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
