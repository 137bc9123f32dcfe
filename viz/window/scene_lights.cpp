#include "viz/window/scene_lights.h"

#include <cmath>

#include "viz/player/lights.h"
#include "viz/text/names.h"
#include "viz/text/rich_text.h"
#include "viz/text/text.h"
#include "viz/window/measures.h"

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

/// Returns the label that was placed with these words: of an item, a handle or the t-axis.
Label label_of(const Player& player, const std::string& words) {
  const Scene& scene = player.scene();
  for (const Item& item : scene.items)
    if (const Label* label = std::get_if<Label>(&item); label && plain(label->text) == words) return *label;
  for (const Parameter& p : player.lesson().parameters)
    if (plain(p.label) == words) return {Vec3::Zero(), p.label};
  if (scene.axis)
    for (const Axis::Tick& tick : scene.axis->ticks)
      if (plain(tick.label) == words) return {Vec3::Zero(), tick.label};
  return {Vec3::Zero(), as_markup(words)};
}

/// Whether it names a point: a number of the same letter is another thing.
bool is_of_point(const Label& label) {
  const std::vector<Name> names = names_in(label.text);
  return !label.until && !names.empty() && names[0].vector;
}

bool is_straight(const Item& item) {
  return std::holds_alternative<Line>(item) || std::holds_alternative<Arrow>(item) ||
         std::holds_alternative<Span>(item);
}

/// Draws a label once more, near-black, where it stands in the picture and as large.
void label_again(Ui& ui, const PlacedLabel& label, const std::string& markup, const Rect& scene, double strength) {
  constexpr double large = 100;  // px, to measure by
  const TextBox ink = measure(Text{markup, {0, 0}, large, {}, 0, false, 0, {}});
  if (!(ink.right > ink.left)) return;
  const double scale = (label.box.right - label.box.left) / (ink.right - ink.left);
  const double size = std::round(4 * large * scale) / 4;  // the same at any place: its picture is kept
  const double pitch = std::ceil(1.6 * size);
  const Paragraph words{
      .markup = markup, .size = size, .line_pitch = pitch, .math = true, .colour = ui.palette.on_highlight};
  const ImTextureID image = ui.texts.of(words);
  if (!image) return;
  // A paragraph of one line has its baseline where its capitals stand in the middle, and its ink begins within it.
  const double left = scene.left + label.box.left - scale * std::max(ink.left, 0.0);
  const double baseline = scene.top + label.box.top - scale * ink.top;
  const double top = baseline - std::round((pitch + 0.72 * size) / 2);
  const ImVec2 extent = ui.texts.size_of(words);
  const ImVec2 from{static_cast<float>(std::round(left)), static_cast<float>(std::round(top))};
  ImGui::GetWindowDrawList()->AddImage(image, from, {from.x + extent.x, from.y + extent.y}, {0, 0}, {1, 1},
                                       packed({1, 1, 1, 1}, strength));
}

/// Draws the number of a lit name once.
void tell_measure(const Player& player, Ui& ui, const std::vector<std::string>& names, const std::string& label,
                  const Rect& at, const Rect& scene) {
  if (names.size() != 1 || ui.rects.contains("measure " + names[0])) return;
  if (const std::optional<Measure> measure = measure_of(player, names[0]))
    measure_chip(ui, names[0], words_beside(*measure, label), at, scene, ui.light.of(names));
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
    if (ui.focus.name() == "handle " + h.id())
      ui.light.hold(keys_of(h, player.lesson()), around(view.project(h.at).at, 16));
  if (!ui.light.on()) return;
  int lit = 0;
  each_named(player.scene(), ui.names, [&](const Item& item, const std::vector<std::string>& names) {
    const double light = ui.light.of(names);
    if (!(light > 0)) return;
    if (const std::optional<LitStroke> stroke = lit_stroke(item, view))
      draw(*stroke, packed(ui.palette.fresh, 0.55 * light));
    ui.rects["lit object " + std::to_string(++lit)] = scene;
  });
  for (const PlacedLabel& label : labels) {
    const std::vector<std::string> names = keys_of(label, ui.names);
    if (!(ui.light.of(names) > 0)) continue;
    const Rect r = rect_of(label, scene);
    lights(ui, names, r);
    const Label drawn = label_of(player, label.text);
    label_again(ui, label, drawn.text, scene, ui.light.of(names));
    if (!is_of_point(drawn)) tell_measure(player, ui, names, label.text, r, scene);
  }
  each_named(player.scene(), ui.names, [&](const Item& item, const std::vector<std::string>& names) {
    if (!(ui.light.of(names) > 0) || !is_straight(item)) return;
    if (const std::optional<LitStroke> stroke = lit_stroke(item, view))
      tell_measure(player, ui, names, {}, around((stroke->a + stroke->b) / 2, 6), scene);
  });
}

}  // namespace isect::viz
