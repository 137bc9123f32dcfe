#include "viz/window/scene_lights.h"

#include "viz/player/lights.h"

namespace isect::viz {
namespace {

ImVec2 screen(const Vec2& p) { return {static_cast<float>(p.x()), static_cast<float>(p.y())}; }

Rect rect_of(const PlacedLabel& label, const Rect& scene) {
  const auto x = [&](double at) { return scene.left + static_cast<float>(at); };
  const auto y = [&](double at) { return scene.top + static_cast<float>(at); };
  return {x(label.box.left) - 2, y(label.box.top) - 2, x(label.box.right) + 2, y(label.box.bottom) + 2};
}

void draw(const LitStroke& lit, ImU32 ink) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float width = static_cast<float>(lit.width), radius = static_cast<float>(lit.radius);
  if (lit.radius > 0)
    list.AddCircle(screen(lit.a), radius, ink, 96, width);
  else
    list.AddLine(screen(lit.a), screen(lit.b), ink, width);
}

Rect around(const Vec2& p, float half) {
  const ImVec2 at = screen(p);
  return {at.x - half, at.y - half, at.x + half, at.y + half};
}

}  // namespace

void point_at_names(const Player& player, Ui& ui, const View& view, const Rect& scene,
                    const std::vector<PlacedLabel>& labels, const std::optional<Handle>& under) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Vec2 pointer(mouse.x, mouse.y);
  for (const PlacedLabel& label : labels)
    if (const Rect r = rect_of(label, scene); r.contains(mouse.x, mouse.y))
      return ui.light.point(keys_of(label, ui.names), r);
  if (under) return ui.light.point(keys_of(*under, player.lesson()), around(pointer, 1), false);
  ui.light.point(names_near(player.scene(), view, pointer, ui.names), around(pointer, 8));
}

void light_names(const Player& player, Ui& ui, const View& view, const Rect& scene,
                 const std::vector<PlacedLabel>& labels) {
  for (const Handle& h : player.scene().handles)
    if (ui.focus.name() == "handle " + h.parameter)
      ui.light.hold(keys_of(h, player.lesson()), around(view.project(h.at).at, 16));
  if (!ui.light.on()) return;
  for (const PlacedLabel& label : labels)
    if (const std::vector<std::string> names = keys_of(label, ui.names); ui.light.of(names) > 0)
      lights(ui, names, rect_of(label, scene));
  int lit = 0;
  each_named(player.scene(), ui.names, [&](const Item& item, const std::vector<std::string>& names) {
    const double light = ui.light.of(names);
    if (!(light > 0)) return;
    if (const std::optional<LitStroke> stroke = lit_stroke(item, view))
      draw(*stroke, packed(ui.palette.fresh, 0.55 * light));
    ui.rects["lit object " + std::to_string(++lit)] = scene;
  });
}

}  // namespace isect::viz
