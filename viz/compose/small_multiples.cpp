#include "viz/compose/small_multiples.h"

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

#include "viz/compose/compose.h"

namespace isect::viz {
namespace {

/// Moves every point of an item.
struct Move {
  Vec3 by;

  void operator()(Ball& it) const { it.center += by; }
  void operator()(Circle& it) const { it.center += by; }
  void operator()(Line& it) const { it.from += by, it.to += by; }
  void operator()(Arrow& it) const { it.from += by, it.to += by; }
  void operator()(Span& it) const { it.from += by, it.to += by; }
  void operator()(RightAngle& it) const { it.at += by, it.a += by, it.b += by; }
  void operator()(Dot& it) const { it.at += by; }
  void operator()(Heading& it) const { it.at += by; }
  void operator()(Raster& it) const { it.corner += by; }
  void operator()(Chain& it) const { points(it.points); }
  void operator()(Solid& it) const {
    points(it.vertices);
    if (it.round) it.round->from += by, it.round->to += by;
  }
  void operator()(Mesh& it) const { points(it.vertices); }
  void operator()(Region& it) const {
    for (std::vector<Vec3>& ring : it.rings) points(ring);
  }
  void operator()(Label& it) const {
    it.at += by;
    if (it.until) *it.until += by;
  }

 private:
  void points(std::vector<Vec3>& all) const {
    for (Vec3& p : all) p += by;
  }
};

}  // namespace

std::vector<Item> moved(std::vector<Item> items, const Vec3& by) {
  for (Item& item : items) std::visit(Move{by}, item);
  return items;
}

std::vector<Item> small_multiples(const std::vector<Inset>& insets, int columns, const Camera& camera) {
  const View view(camera, 1, 1);  // for its axes only
  std::vector<Box2> boxes;
  Vec2 size = Vec2::Zero();
  for (const Inset& inset : insets) {
    boxes.push_back(extent(inset.items, camera));
    size = size.cwiseMax(boxes.back().hi - boxes.back().lo);
  }
  const double line = 0.2 * size.y(), gap = 0.12 * std::max(size.x(), size.y());
  const bool notes = std::ranges::any_of(insets, [](const Inset& inset) { return !inset.note.empty(); });

  std::vector<Item> all;
  double middle_y = 0;  // of the row
  for (std::size_t i = 0; i < insets.size(); ++i) {
    const int column = static_cast<int>(i) % columns;
    if (column == 0 && i > 0) {  // room for headings and notes, if any
      const std::size_t in_row = std::min(insets.size() - i, static_cast<std::size_t>(columns));
      const bool headings = std::ranges::any_of(std::span(insets).subspan(i, in_row),
                                                [](const Inset& inset) { return !inset.heading.empty(); });
      middle_y -= size.y() + 1.5 * gap + (headings ? line : 0) + (notes ? line : 0);
    }
    const Vec2 middle(column * (size.x() + gap), middle_y);
    const Vec2 by = middle - (boxes[i].lo + boxes[i].hi) / 2;
    const auto at = [&](const Vec2& p) -> Vec3 { return p.x() * view.right() + p.y() * view.up(); };
    for (const Item& item : moved(insets[i].items, at(by))) all.push_back(item);
    const double text = size.y() / 2 + 0.75 * line;
    if (!insets[i].heading.empty())
      all.push_back(Heading{at(middle + Vec2(0, text)), insets[i].heading, Role::text, size.x() + gap / 2});
    if (!insets[i].note.empty())
      all.push_back(Heading{at(middle - Vec2(0, text)), insets[i].note, insets[i].role, size.x() + gap / 2, false});
  }
  return all;
}

Scene arrangeable(const std::vector<Inset>& insets, int columns, const Camera& camera,
                  const std::function<std::vector<Item>(std::vector<Item>)>& placed) {
  const auto items = [=](int in) {
    std::vector<Item> all = small_multiples(insets, in, camera);
    return placed ? placed(std::move(all)) : all;
  };
  Scene scene;
  scene.items = items(columns);
  scene.grid = std::make_shared<const Scene::Grid>(Scene::Grid{static_cast<int>(insets.size()), columns, items});
  return scene;
}

std::optional<Scene> arranged(const Scene& scene, const Camera& camera, double aspect) {
  constexpr double larger = 1.05;
  if (!scene.grid || !scene.handles.empty()) return {};  // handles stand where the lesson's own drawings do
  const auto half_height = [&](const std::vector<Item>& items) {
    const Box2 box = extent(items, camera);
    const Vec2 size = box.hi - box.lo;
    return std::max(size.y(), size.x() / aspect) / 2;
  };
  double least = half_height(scene.items) / larger;
  std::optional<Scene> best;
  for (int columns = 1; columns <= scene.grid->count; ++columns) {
    if (columns == scene.grid->columns) continue;
    std::vector<Item> items = scene.grid->items(columns);
    const double half = half_height(items);
    if (!(half < least)) continue;
    least = half;
    best = scene;
    best->items = std::move(items);
  }
  return best;
}

}  // namespace isect::viz
