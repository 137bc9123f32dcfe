#include "viz/window/map_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viz/chart/chart.h"
#include "viz/text/rich_text.h"
#include "viz/window/key_codes.h"

namespace isect::viz {
namespace {

constexpr std::size_t trail_kept = 240;  ///< places
constexpr float map_header = 40, map_grip = 14;

Vec2 pointer_now() { return {ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y}; }

ImVec2 screen_at(const Cases& cases, const Box2& plane, const Vec2& at) {
  const Vec2 p = pixel_of(cases, plane, at);
  return {static_cast<float>(p.x()), static_cast<float>(p.y())};
}

/// Returns where a line from a to b ends, so that it keeps off the marker.
ImVec2 short_of(const ImVec2& marker, const ImVec2& a, const ImVec2& b) {
  constexpr float radius = 9;
  const float from = std::hypot(a.x - marker.x, a.y - marker.y);
  if (std::hypot(b.x - marker.x, b.y - marker.y) >= radius) return b;
  if (from <= radius) return a;
  return {marker.x + (a.x - marker.x) * radius / from, marker.y + (a.y - marker.y) * radius / from};
}

/// Returns the theme of the map: smaller in a smaller pane.
Theme map_look(const Ui& ui, const Rect& r) {
  const double fits = std::min(r.width() / 420, r.height() / 330);
  return window_theme(ui.palette.theme.name, std::clamp(fits, 0.7, 1.0));
}

Rect below_header(const Rect& r) { return {r.left, r.top + map_header, r.right, r.bottom}; }

}  // namespace

bool has_map(const Player& player) {
  const CaseMap* const map = player.lesson().map;
  return map && map->place(player.parameters()).allFinite();
}

bool shows_map(const Player& p, const Settings& settings) {
  const bool drags = ImGui::GetIO().MouseDown[0];  // then everything stays in place
  return settings.map && p.step().slug != case_map_slug && (has_map(p) || (p.lesson().map && drags));
}

void show_map(const Player& player, Settings& settings, Toast& toast) {
  if (!player.lesson().map) return toast.say_here(player, "This lesson has no map of cases");
  if (player.step().slug == case_map_slug) return toast.say_here(player, "This step is the map of cases");
  if (!has_map(player)) return toast.say_here(player, "This setting has no place on the map of cases");
  settings.map = !settings.map;
  if (settings.map) settings.beside.reset();
}

void MapDrag::follow(Player& player, Toast& toast, const Cases& cases, const Box2& plane, bool hovered) {
  const bool moved = pointer_now() != last_;
  last_ = pointer_now();
  if (!ImGui::GetIO().MouseDown[0] || held_in_ != &player.lesson()) held_ = false;
  const bool inside = (last_.array() >= plane.lo.array()).all() && (last_.array() <= plane.hi.array()).all();
  if (hovered && inside && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    player.end_action();
    player.remember("drag");
    held_ = true, held_in_ = &player.lesson(), snapping_ = false;
    start_ = case_at(cases, plane, last_);
  } else if (!moved && snapping_ == ImGui::GetIO().KeyShift) {
    return;
  }
  snapping_ = ImGui::GetIO().KeyShift;
  if (!held_) return;
  attempt(toast, [&] {
    const Moved came = drag_on_map(player, start_, case_at(cases, plane, last_), snapping_);
    if (!came.told.empty()) toast.say_here(player, came.told);
  });
}

/// Adds to the trail. A preset begins a new trail, unless a drag leads back to the preset.
void MapView::leave_trail(const Player& player) {
  const bool preset = player.played().preset_id() != trail_from_ && !ImGui::GetIO().MouseDown[0];
  if ((preset && !player.played().preset_id().empty()) || !map_.cases().here || trail_of_ != map_.lesson())
    trail_.clear();
  trail_of_ = map_.lesson(), trail_from_ = player.played().preset_id();
  if (!map_.cases().here || (!trail_.empty() && trail_.back().at == map_.cases().here->at)) return;
  trail_.push_back(*map_.cases().here);
  if (trail_.size() > trail_kept) trail_.pop_front();
}

void MapView::draw(const Rect& r, const Theme& theme, bool named) {
  if (r.width() < 1 || r.height() < 1) return;  // a display may make a window as small as it likes
  const Vec2 here = map_.cases().here ? map_.cases().here->at : Vec2(NAN, NAN);
  const std::string wanted = fmt::format("{} {} {} {} {} {} {} {}", named, map_.found(), here.x(), here.y(), r.width(),
                                         r.height(), scale_, name_of(theme.name));
  if (wanted == drawn_ || !drawing_) return;
  Drawing drawing{r.width(), r.height(), theme.background, {}};
  Cases cases = map_.cases();
  if (!named) cases.named = Cases::Named::none;
  drawing.shapes = compose_map(cases, Vec2::Zero(), r.width(), r.height(), theme).shapes;
  renderer_.draw(drawing, scale_);
  const PixelBox size = pixels(drawing, scale_);
  picture_.take(renderer_.texture(), size.width, size.height);
  drawn_ = wanted;
}

/// Draws the trail. It fades with every further place, and has a mark where the case changed.
void MapView::draw_trail(Ui& ui, const Box2& plane) const {
  if (trail_.size() < 2) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  Rect box{1e9f, 1e9f, -1e9f, -1e9f};
  const ImVec2 here = screen_at(map_.cases(), plane, trail_.back().at);
  int crossings = 0;
  for (std::size_t i = 0; i < trail_.size(); ++i) {
    const ImVec2 p = screen_at(map_.cases(), plane, trail_[i].at);
    box = {std::min(box.left, p.x), std::min(box.top, p.y), std::max(box.right, p.x), std::max(box.bottom, p.y)};
    if (i == 0) continue;
    const ImVec2 before = screen_at(map_.cases(), plane, trail_[i - 1].at);
    const ImVec2 end = short_of(here, before, p);
    const double left = static_cast<double>(trail_.size() - i) / trail_kept;
    const ImU32 ink = packed(ui.palette.first, 0.85 * std::pow(1 - left, 2));
    if (end.x != before.x || end.y != before.y) list.AddLine(before, end, ink, 2.5f);
    if (trail_[i].branch == trail_[i - 1].branch) continue;
    const ImVec2 middle{(before.x + p.x) / 2, (before.y + p.y) / 2};
    list.AddCircleFilled(middle, 4, ink, 16);
    ui.rects[fmt::format("trail crossing {}", ++crossings)] = {middle.x - 4, middle.y - 4, middle.x + 4, middle.y + 4};
  }
  ui.rects["trail"] = box;
}

/// Moves the setting by Shift and the arrows, while the keyboard holds it.
void MapView::keyboard(Player& player, const Ui& ui, Toast& toast, const Box2& plane) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!io.KeyShift || io.KeyCtrl || ui.focus.name() != "map setting" || io.WantTextInput) return;
  Vec2 way = Vec2::Zero();
  if (ImGui::IsKeyPressed(key::left, true)) way.x() -= 1;
  if (ImGui::IsKeyPressed(key::right, true)) way.x() += 1;
  if (ImGui::IsKeyPressed(key::up, true)) way.y() -= 1;
  if (ImGui::IsKeyPressed(key::down, true)) way.y() += 1;
  if (way == Vec2::Zero()) return;
  const ImVec2 p = screen_at(map_.cases(), plane, map_.cases().here->at);
  player.remember("nudge on the map");
  attempt(toast, [&] { player.go_to_case(case_at(map_.cases(), plane, Vec2(p.x, p.y) + 8 * way)); });
}

void MapView::name_under_pointer(const Player& player, const Ui& ui, const Box2& plane) const {
  const Vec2 p = pointer_now();
  if (!(p.array() >= plane.lo.array()).all() || !(p.array() <= plane.hi.array()).all()) return;
  const CaseMap& map = *player.lesson().map;
  tooltip(ui, plain(map.branches[map.branch(map.moved(player.parameters(), case_at(map_.cases(), plane, p)))]));
}

void MapView::show(Player& player, Ui& ui, Toast& toast, const Rect& r) {
  begin_region(ui, "map", r, ui.palette.card);
  map_.find(player);
  const Theme theme = map_look(ui, r);
  const Rect within = below_header(r);
  const Box2 plane = plane_of(map_.cases(), {within.left, within.top}, within.width(), within.height(), theme);

  ImGui::SetCursorScreenPos(top_left(within));
  ImGui::InvisibleButton("map picture", {within.width(), within.height()});
  const bool hovered = ImGui::IsItemHovered();
  if (map_.cases().here) {
    drag_.follow(player, toast, map_.cases(), plane, hovered);
    keyboard(player, ui, toast, plane);
    map_.find(player);
  }
  leave_trail(player);
  const bool waits = waits_for_answer(player), placed = map_.cases().here.has_value();
  draw(within, theme, !(waits && placed));  // the setting's place in a region with a name would be the answer
  ImGui::GetWindowDrawList()->AddImage(picture_.id(), top_left(within), bottom_right(within), {0, 1}, {1, 0});
  draw_trail(ui, plane);
  if (hovered && !ImGui::GetIO().MouseDown[0] && !(waits && placed)) name_under_pointer(player, ui, plane);

  const float x = r.left + 20, y = r.top + 22;
  std::string told = "here: after your answer";
  if (!waits && placed) told = "here: " + map_.cases().branches[map_.cases().here->branch];
  if (!player.quiz().asked() && !placed) told = "beyond this map";
  const Paragraph words{.markup = told, .colour = placed && !waits ? ui.palette.text : ui.palette.muted};
  ui.rects[waits ? "map waits" : "map tells"] = {x, r.top, r.right - 8, within.top};
  ImGui::PushClipRect({x, r.top}, {r.right - 8, within.top}, true);
  rich_line(ui, words, x, y);
  ImGui::PopClipRect();
  ui.rects["map plane"] = {static_cast<float>(plane.lo.x()), static_cast<float>(plane.lo.y()),
                           static_cast<float>(plane.hi.x()), static_cast<float>(plane.hi.y())};
  if (map_.cases().here) {
    const ImVec2 p = screen_at(map_.cases(), plane, map_.cases().here->at);
    const Rect place{p.x - map_grip, p.y - map_grip, p.x + map_grip, p.y + map_grip};
    ui.rects["map setting"] = place;
    focused(ui, "map setting", place);
  }
  const bool right = r.left > 0 && ui.rects.contains("scene") && ui.rects["scene"].right <= r.left + 1;
  ImGui::GetWindowDrawList()->AddRectFilled(
      top_left(r), right ? ImVec2{r.left + 1, r.bottom} : ImVec2{r.right, r.top + 1}, packed(ui.palette.rule));
  ImGui::End();
}

}  // namespace isect::viz
