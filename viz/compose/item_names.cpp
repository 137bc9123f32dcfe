#include "viz/compose/item_names.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "viz/text/rich_text.h"

namespace isect::viz {
namespace {

/// The labels of a scene: of thousands of items they are few.
std::vector<const Label*> labels_of(const Scene& scene) {
  std::vector<const Label*> labels;
  for (const Item& item : scene.items)
    if (const Label* label = std::get_if<Label>(&item)) labels.push_back(label);
  return labels;
}

/// Returns the text of the label at this point, or of the one beside this segment, in either direction.
std::string label_at(const std::vector<const Label*>& labels, const Vec3& at, const std::optional<Vec3>& until = {}) {
  for (const Label* label : labels) {
    if (label->until.has_value() != until.has_value()) continue;
    if (label->at == at && label->until == until) return plain(label->text);
    if (until && label->at == *until && *label->until == at) return plain(label->text);
  }
  return {};
}

/// Returns the item's name, else that of the label, which takes long to find among many.
std::string given_or(const auto& item, const auto& label) { return item.name.empty() ? label() : plain(item.name); }

/// Finds the kind, name and role of an item.
struct Namer {
  const std::vector<const Label*> labels;

  Object operator()(const Ball& it) const {
    return {"ball", given_or(it, [&] { return label_at(labels, it.center); }), it.role};
  }
  Object operator()(const Line& it) const {
    return {"line", given_or(it, [&] { return label_at(labels, it.from, it.to); }), it.role};
  }
  Object operator()(const Arrow& it) const {
    return {"arrow", given_or(it, [&] { return label_at(labels, it.from, it.to); }), it.role};
  }
  Object operator()(const RightAngle&) const { return {"right angle", "", Role::construction}; }
  Object operator()(const Dot& it) const { return {"point", label_at(labels, it.at), it.role}; }
  Object operator()(const Label& it) const { return {"label", plain(it.text), it.role}; }
  Object operator()(const Chain& it) const { return {"chain", "", it.role}; }
  Object operator()(const Circle& it) const { return {"circle", label_at(labels, it.center), it.role}; }
  Object operator()(const Span& it) const { return {"interval", label_at(labels, it.from, it.to), it.role}; }
  Object operator()(const Region& it) const { return {"region", plain(it.name), it.role}; }
  Object operator()(const Solid& it) const { return {"solid", plain(it.name), it.role}; }
  Object operator()(const Mesh& it) const { return {"mesh", plain(it.name), it.role}; }
  Object operator()(const Raster&) const { return {"raster", "", Role::text}; }
  Object operator()(const Heading& it) const { return {"heading", plain(it.text), it.role}; }
};

}  // namespace

std::vector<Object> objects_of(const Scene& scene) {
  std::vector<Object> objects;
  const Namer namer{labels_of(scene)};
  std::map<std::tuple<std::string, std::string, Role>, int> met;  // numbers as add_object gives them
  for (const Item& item : scene.items) {
    Object object = std::visit(namer, item);
    object.number = ++met[{object.kind, object.name, object.name.empty() ? object.role : Role::text}];
    objects.push_back(std::move(object));
  }
  return objects;
}

bool is_page(const Scene& scene) {
  return std::ranges::any_of(scene.items, [](const Item& item) { return std::holds_alternative<Heading>(item); });
}

}  // namespace isect::viz
