#include "viz/window/edge_arrows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "viz/player/camera_moves.h"
#include "viz/player/lights.h"
#include "viz/text/rich_text.h"
#include "viz/window/scene_marks.h"
#include "viz/window/scene_names.h"

namespace isect::viz {
namespace {

constexpr float from_edge = 24;          ///< px from the scene's edge to an arrow's middle
constexpr double arrows_apart = 46;      ///< px between the middles of two arrows, at least
constexpr std::size_t most_in_full = 3;  ///< names beside an arrow

TextBox box_of(const Rect& r) { return {r.left, r.top, r.right, r.bottom}; }

bool is_within(const Vec2& p, const TextBox& b) {
  return p.x() >= b.left && p.x() <= b.right && p.y() >= b.top && p.y() <= b.bottom;
}

Vec2 middle_of(const Rect& r) { return {r.middle_x(), r.middle_y()}; }

/// Whether a part of the segment a b lies in a box.
bool passes(const Vec2& a, const Vec2& b, const TextBox& box) {
  const Vec2 lo(box.left, box.top), hi(box.right, box.bottom), along = b - a;
  double from = 0, to = 1;
  for (int i = 0; i < 2; ++i) {
    if (along[i] == 0 && (a[i] < lo[i] || a[i] > hi[i])) return false;
    if (along[i] == 0) continue;
    const double enters = (lo[i] - a[i]) / along[i], leaves = (hi[i] - a[i]) / along[i];
    from = std::max(from, std::min(enters, leaves)), to = std::min(to, std::max(enters, leaves));
  }
  return from <= to;
}

/// Whether a part of a stroke can be seen.
bool is_seen(const LitStroke& stroke, const TextBox& scene) {
  const double r = stroke.radius;
  if (r > 0) return is_within(stroke.a, {scene.left - r, scene.top - r, scene.right + r, scene.bottom + r});
  return passes(stroke.a, stroke.b, scene);
}

/// Returns the part of the scene on whose rim the arrows stand: below the chips.
Rect room_of_arrows(const Player& player, Ui& ui, const Rect& scene) {
  const float top = std::min(chips_height(player, ui, scene), scene.height() / 2);
  return {scene.left + from_edge, scene.top + top + from_edge, scene.right - from_edge, scene.bottom - from_edge};
}

/// Moves a place up, out of the corners where the axes and the names of the view stand.
void keep_off_corners(Vec2& at, const Rect& room) {
  constexpr double across = 110, up = 90;
  const double least = room.bottom - up;
  const bool corner = at.x() < room.left + across || at.x() > room.right - across;
  if (corner && at.y() > least && room.height() > 2 * up) at.y() = least;
}

/// Returns markup for the key of a name (viz/text/names.h).
std::string markup_of_key(const std::string& key) {
  const std::size_t cut = key.find('_');
  if (cut == std::string::npos) return "*" + key + "*";
  return "*" + key.substr(0, cut) + "*_{" + key.substr(cut + 1) + "}";
}

std::string name_of_button(std::size_t i) { return "edge arrow " + std::to_string(i + 1); }

Rect rect_of(const EdgeArrow& arrow) {
  constexpr float half = 15;
  const float x = static_cast<float>(arrow.at.x()), y = static_cast<float>(arrow.at.y());
  return {x - half, y - half, x + half, y + half};
}

std::vector<EdgeArrow> arrows_of(const Player& player, Ui& ui, const View& view, const Rect& scene) {
  if (player.scene().chart) return {};
  const std::vector<OutOfView> things = out_of_view(player, ui, view, scene);
  return things.empty() ? std::vector<EdgeArrow>{} : edge_arrows(things, room_of_arrows(player, ui, scene));
}

void draw_arrow(Ui& ui, const EdgeArrow& arrow) {
  const Palette& c = ui.palette;
  const Rect r = rect_of(arrow);
  const Vec2 tip = arrow.at + 8 * arrow.way, side(-arrow.way.y(), arrow.way.x()), back = arrow.at - 5 * arrow.way;
  const auto screen = [](const Vec2& p) { return ImVec2{static_cast<float>(p.x()), static_cast<float>(p.y())}; };
  filled(r, arrow.lit ? c.highlight : c.window, 15);
  outlined(r, arrow.lit ? c.fresh : c.muted, 1.5f, 15);
  ImGui::GetWindowDrawList()->AddTriangleFilled(screen(tip), screen(back + 7 * side), screen(back - 7 * side),
                                                packed(arrow.lit ? c.on_highlight : c.text));
  const Paragraph words{.markup = arrow.words(), .colour = c.text};
  const ImVec2 size = ui.texts.size_of(words);
  const double reach = (std::abs(arrow.way.x()) * size.x + std::abs(arrow.way.y()) * size.y) / 2;
  const Vec2 at = arrow.at - (20 + reach) * arrow.way;
  const float x = static_cast<float>(at.x()), y = static_cast<float>(at.y());
  filled({x - size.x / 2 - 3, y - size.y / 2, x + size.x / 2 + 3, y + size.y / 2}, c.window.with_alpha(0.85), 4);
  rich_line(ui, words, x, y, 0.5f);
}

}  // namespace

std::string EdgeArrow::words() const {
  if (names.size() > most_in_full) return fmt::format("{} and {} more", names.front(), names.size() - 1);
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

/// Returns the handles that are drawn, but out of view.
static std::vector<OutOfView> handles_out_of_view(const Player& player, const Ui& ui, const View& view,
                                                  const Rect& scene) {
  const TextBox box = box_of(scene);
  std::vector<OutOfView> all;
  if (!draws_handles(player.scene())) return all;
  for (const Handle& h : player.scene().handles) {
    const Projected p = view.project(h.at);
    if (!p.at.allFinite() || (p.depth > 0 && is_within(p.at, box))) continue;
    // What lies behind the eye appears on the other side of the picture's middle.
    const Vec2 towards = p.depth > 0 ? p.at : Vec2(2 * middle_of(scene) - p.at);
    all.push_back({towards, name_of(player, h), ui.light.of(keys_of(h, player.lesson())) > 0});
  }
  return all;
}

std::vector<OutOfView> out_of_view(const Player& player, const Ui& ui, const View& view, const Rect& scene) {
  std::vector<OutOfView> all = handles_out_of_view(player, ui, view, scene);
  if (!ui.light.on()) return all;
  const TextBox box = box_of(scene);
  each_named(player.scene(), ui.names, [&](const Item& item, const std::vector<std::string>& names) {
    if (!(ui.light.of(names) > 0)) return;
    const std::optional<LitStroke> stroke = lit_stroke(item, view);
    if (!stroke || !stroke->a.allFinite() || !stroke->b.allFinite() || is_seen(*stroke, box)) return;
    all.push_back({(stroke->a + stroke->b) / 2, markup_of_key(names.front()), true});
  });
  return all;
}

std::vector<EdgeArrow> edge_arrows(const std::vector<OutOfView>& things, const Rect& room) {
  std::vector<EdgeArrow> arrows;
  const Vec2 middle = middle_of(room), half(room.width() / 2, room.height() / 2);
  if (!(half.x() > 0 && half.y() > 0)) return arrows;
  for (const OutOfView& thing : things) {
    Vec2 way = thing.towards - middle;
    if (!(way.norm() > 0)) way = Vec2(0, -1);
    double to_rim = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 2; ++i)
      if (way[i] != 0) to_rim = std::min(to_rim, half[i] / std::abs(way[i]));
    Vec2 at = middle + to_rim * way;
    keep_off_corners(at, room);
    const auto near = [&](const EdgeArrow& other) { return (other.at - at).norm() < arrows_apart; };
    auto found = std::ranges::find_if(arrows, near);
    if (found == arrows.end()) {
      arrows.push_back({at, way.normalized()});
      found = arrows.end() - 1;
    }
    const auto same = [&](const std::string& name) { return plain(name) == plain(thing.name); };
    if (std::ranges::none_of(found->names, same)) found->names.push_back(thing.name);
    found->lit = found->lit || thing.lit;
  }
  return arrows;
}

void press_edge_arrows(Player& player, Ui& ui, const View& view, const Rect& scene) {
  const std::vector<EdgeArrow> arrows = arrows_of(player, ui, view, scene);
  bool clicked = false;
  for (std::size_t i = 0; i < arrows.size(); ++i)
    clicked = press(ui, name_of_button(i), rect_of(arrows[i])).clicked || clicked;
  if (clicked) frame_shown(player);
}

void draw_edge_arrows(const Player& player, Ui& ui, const View& view, const Rect& scene) {
  const std::vector<EdgeArrow> arrows = arrows_of(player, ui, view, scene);
  for (std::size_t i = 0; i < arrows.size(); ++i) {
    const EdgeArrow& arrow = arrows[i];
    draw_arrow(ui, arrow);
    const Rect r = rect_of(arrow);
    if (arrow.lit) ui.rects["lit " + name_of_button(i)] = r;
    if (!ImGui::GetIO().MouseDown[0] && ImGui::IsMouseHoveringRect(top_left(r), bottom_right(r)))
      tooltip(ui, plain(arrow.words()) +
                      ": out of view\nHere: show all of this step. F: the whole walk. Ctrl+Z: one change back");
  }
}

}  // namespace isect::viz
