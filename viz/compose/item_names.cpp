#include "viz/compose/item_names.h"

#include <algorithm>

#include "viz/text/rich_text.h"

namespace isect::viz {
namespace {

/// Returns the text of the label at this point, or of the one beside this segment, in either direction.
std::string label_at(const Scene& scene, const Vec3& at, const std::optional<Vec3>& until = {}) {
  for (const Item& item : scene.items) {
    const Label* label = std::get_if<Label>(&item);
    if (label == nullptr || label->until.has_value() != until.has_value()) continue;
    if (label->at == at && label->until == until) return plain(label->text);
    if (until && label->at == *until && *label->until == at) return plain(label->text);
  }
  return {};
}

/// Returns the item's name, else that of the label, which takes long to find among many.
std::string given_or(const auto& item, const auto& label) { return item.name.empty() ? label() : plain(item.name); }

/// Finds the kind, name and role of an item.
struct Namer {
  const Scene& scene;

  Object operator()(const Ball& it) const {
    return {"ball", given_or(it, [&] { return label_at(scene, it.center); }), it.role};
  }
  Object operator()(const Line& it) const {
    return {"line", given_or(it, [&] { return label_at(scene, it.from, it.to); }), it.role};
  }
  Object operator()(const Arrow& it) const {
    return {"arrow", given_or(it, [&] { return label_at(scene, it.from, it.to); }), it.role};
  }
  Object operator()(const RightAngle&) const { return {"right angle", "", Role::construction}; }
  Object operator()(const Dot& it) const { return {"point", label_at(scene, it.at), it.role}; }
  Object operator()(const Label& it) const { return {"label", plain(it.text), it.role}; }
  Object operator()(const Chain& it) const { return {"chain", "", it.role}; }
  Object operator()(const Circle& it) const { return {"circle", label_at(scene, it.center), it.role}; }
  Object operator()(const Span& it) const { return {"interval", label_at(scene, it.from, it.to), it.role}; }
  Object operator()(const Region& it) const { return {"region", plain(it.name), it.role}; }
  Object operator()(const Solid& it) const { return {"solid", plain(it.name), it.role}; }
  Object operator()(const Mesh& it) const { return {"mesh", plain(it.name), it.role}; }
  Object operator()(const Raster&) const { return {"raster", "", Role::text}; }
  Object operator()(const Heading& it) const { return {"heading", plain(it.text), it.role}; }
};

}  // namespace

std::vector<Object> objects_of(const Scene& scene) {
  std::vector<Object> objects;
  for (const Item& item : scene.items) add_object(objects, std::visit(Namer{scene}, item));
  return objects;
}

bool is_page(const Scene& scene) {
  return std::ranges::any_of(scene.items, [](const Item& item) { return std::holds_alternative<Heading>(item); });
}

}  // namespace isect::viz
