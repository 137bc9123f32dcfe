#include "viz/window/scene_view.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

#include "viz/chart.h"
#include "viz/compose.h"
#include "viz/motion.h"
#include "viz/window/key_codes.h"
#include "viz/window/scene_lights.h"
#include "viz/window/scene_marks.h"
#include "viz/window/scene_names.h"

namespace isect::viz {
namespace {

constexpr float hit_area = 14;

Vec2 mouse() { return {ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y}; }

std::string line_of(const Session& s, const Rect& r, double scale) {
  const Camera& c = s.player.camera().now();
  const Scene* const before = s.player.scene_before();
  const double motion = before && may_move(*before, s.player.scene()) ? s.player.motion() : 1;
  return fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {} {}", static_cast<int>(s.pane), s.player.revision(),
                     motion, r.width(), r.height(), scale, name_of(s.settings.theme), c.target.x(), c.target.y(),
                     c.target.z(), c.azimuth, c.elevation, c.half_height, c.perspective, c.field_of_view);
}

/// What a chart leaves to the chips above it, where the scene's are drawn over.
double head_of(Session& s, double scene_width) {
  if (!s.player.scene().chart) return 0;
  const float verdict = verdict_height(s, static_cast<float>(scene_width));
  return (verdict > 0 ? verdict + 28 : 12) + (s.player.methods_differ() && !s.player.asked() ? 40 : 0);
}

/// The map of cases that this step shows, if any.
const Cases* map_of(const Session& s) {
  const Scene& scene = s.player.scene();
  return scene.chart && s.player.lesson().map ? std::get_if<Cases>(&scene.chart->kind) : nullptr;
}

std::string refusal(const Condition* forbids) {
  return forbids ? "That does not do; give " + forbids->allowed : std::string();
}

/// Where a handle is brought when it is to stand at a pixel: it stays in its plane where it has one.
Vec3 brought(const View& view, const Handle& handle, const Vec2& pixel) {
  if (handle.kind != Handle::Kind::plane) return view.on_facing_plane(pixel, handle.at);
  return view.on_plane(pixel, handle.at, handle.direction.cross(handle.across)).value_or(handle.at);
}

bool same_handle(const Handle& a, const Handle& b) { return a.parameter == b.parameter && a.kind == b.kind; }

}  // namespace

void SceneView::draw(Session& s, const Rect& r, const View& view) {
  behind_ = false;
  const std::string wanted = line_of(s, r, scale_);
  if (wanted == drawn_ || !drawing_) return;
  const Theme& theme = s.ui.palette.theme;
  const double head = head_of(s, view.width());
  const View own(view.camera(), view.width(), view.height() - head, {0, head});
  Drawing drawing{view.width(), view.height(), theme.background, {}};
  Scene scene = with_names(s.player);
  const std::clock_t begun = std::clock();  // the processor's time: that others use it, too, is no reason to stop
  if (const Scene* before = s.player.scene_before()) scene = between(*before, scene, s.player.motion());
  const Cases* const map = map_of(s);
  Composed composed = map ? compose_map(*map, own.corner(), own.width(), own.height(), theme)
                          : compose(scene, own, theme, s.pane != Pane::fixed);
  drawing.shapes = std::move(composed.shapes);
  labels_ = std::move(composed.labels);
  renderer_.draw(drawing, scale_);
  const PixelBox size = pixels(drawing, scale_);
  picture_.take(renderer_.texture(), size.width, size.height);
  drawn_ = wanted;
  constexpr double most_to_move = 0.060;  // seconds
  if (static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC > most_to_move) s.player.arrive(), behind_ = true;
}

std::optional<Handle> SceneView::handle_near(const Session& s, const View& view, const Vec2& pixel) const {
  std::optional<Handle> nearest;
  if (s.pane == Pane::fixed) return nearest;
  double least = hit_area;
  for (const Handle& h : s.player.scene().handles) {
    const Projected p = view.project(h.at);
    const double distance = (p.at - pixel).norm();
    if (!(p.depth > 0) || !(distance <= least)) continue;
    least = distance;
    nearest = h;
  }
  return nearest;
}

/// With Shift only as far as where the case changes, next to the pointer.
void SceneView::drag_held(Session& s, const View& view) {
  const bool snapping = ImGui::GetIO().KeyShift;
  if (mouse() == last_ && snapping == snapping_) return;
  snapping_ = snapping;
  const Vec3 to = brought(view, *held_, mouse() - grip_);
  s.attempt([&] {
    std::string told;
    if (snapping)
      told = s.player.snap_on(way_of(s.player.lesson(), s.player.parameters(), *held_, start_, to), 0, 1.25, 1);
    forbidden_ = told.empty() ? refusal(s.player.drag_handle(*held_, to)) : std::string();
    if (!told.empty()) s.say(told);
  });
  for (const Handle& h : s.player.scene().handles)
    if (same_handle(h, *held_)) {
      held_ = h;
      return;
    }
}

void SceneView::wheel(Session& s, const View& view) {
  const double turns = ImGui::GetIO().MouseWheel;
  if (turns != 0) s.player.zoom(view, mouse(), std::pow(1.15, turns));
}

/// Shift and the arrows move the handle that the keyboard holds, with Ctrl to where the case changes next; or else they
/// turn the scene. Ctrl and the arrows shift it.
void SceneView::keyboard(Session& s, const View& view) {
  const ImGuiIO& io = ImGui::GetIO();
  const Vec2 middle = view.corner() + Vec2(view.width(), view.height()) / 2;
  if (const double zoom = std::exchange(s.zoom, 1.0); zoom != 1) s.player.zoom(view, middle, zoom);
  if (!(io.KeyShift || io.KeyCtrl) || io.WantTextInput || ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup)) return;
  Vec2 way = Vec2::Zero();
  if (ImGui::IsKeyPressed(key::left, true)) way.x() -= 1;
  if (ImGui::IsKeyPressed(key::right, true)) way.x() += 1;
  if (ImGui::IsKeyPressed(key::up, true)) way.y() -= 1;
  if (ImGui::IsKeyPressed(key::down, true)) way.y() += 1;
  if (way == Vec2::Zero() || s.player.scene().chart || s.ui.focus.name() == "map setting") return;
  constexpr double step = 8, search = 600;  // px
  const std::vector<Handle>& handles = s.player.scene().handles;
  const auto held =
      std::ranges::find_if(handles, [&](const Handle& h) { return "handle " + h.parameter == s.ui.focus.name(); });
  if (io.KeyShift && held != handles.end()) {
    const Handle handle = *held;
    const auto beside = [&](double px) { return brought(view, handle, view.project(handle.at).at + px * way); };
    s.player.remember((io.KeyCtrl ? "snap " : "nudge ") + handle.parameter);
    s.attempt([&] {
      if (io.KeyCtrl) {
        const Way on = way_of(s.player.lesson(), s.player.parameters(), handle, handle.at, beside(search));
        const std::string told = s.player.snap_on(on, 1 / search, 1, 0);
        s.say(told.empty() ? "The case does not change that way" : told);
      } else if (const std::string why = refusal(s.player.drag_handle(handle, beside(step))); !why.empty()) {
        s.complain(why);
      }
    });
  } else if (io.KeyShift && io.KeyCtrl) {
    return;
  } else if (io.KeyShift && !s.player.lesson().flat) {
    s.player.orbit(2 * step * way);
  } else {
    s.player.pan(view, middle, middle - 2 * step * way);
  }
}

void SceneView::pointer(Session& s, const View& view, bool hovered, bool active) {
  const ImGuiIO& io = ImGui::GetIO();
  if (const Cases* cases = map_of(s)) {
    const Vec2 head(0, head_of(s, view.width()));
    const Theme& theme = s.ui.palette.theme;
    map_drag_.follow(s, *cases, plane_of(*cases, view.corner() + head, view.width(), view.height() - head.y(), theme),
                     hovered);
    last_ = mouse();
    return;
  }
  if (hovered) wheel(s, view);
  if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    s.player.end_action();
    held_ = handle_near(s, view, mouse());
    forbidden_.clear();
    if (held_) {
      s.player.remember("drag");
      start_ = held_->at, snapping_ = false;
      grip_ = mouse() - view.project(held_->at).at;
    } else if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
      s.player.frame_all();
    }
  }
  if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) s.player.end_action();
  if (!io.MouseDown[0]) held_.reset();

  const bool moved = mouse() != last_;
  if (held_) {
    drag_held(s, view);
  } else if (active && moved && io.MouseDown[0] && !s.player.camera().moving()) {
    if (s.player.lesson().flat)
      s.player.pan(view, last_, mouse());
    else
      s.player.orbit(mouse() - last_);
  } else if (active && moved && io.MouseDown[1]) {
    s.player.pan(view, last_, mouse());
  }
  last_ = mouse();
}

void SceneView::show(Session& s, const Rect& r) {
  Ui& ui = s.ui;
  begin_region(ui, "scene", r, ui.palette.card);
  s.player.set_aspect(r.width() / r.height());
  const Vec2 corner(r.left, r.top);
  const View before(s.player.camera().now(), r.width(), r.height(), corner);

  const bool lead = s.pane == Pane::lead;
  if (lead && !s.player.lesson().flat && !s.player.scene().chart) projection_name(s, r);
  if (lead) changed_mark(s, r);
  ImGui::SetCursorScreenPos(top_left(r));
  ImGui::InvisibleButton("picture", {r.width(), r.height()},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
  pointer(s, before, hovered, active);
  if (lead) keyboard(s, before);

  const View view(s.player.camera().now(), r.width(), r.height(), corner);
  draw(s, r, view);
  ImGui::GetWindowDrawList()->AddImage(picture_.id(), top_left(r), bottom_right(r), {0, 1}, {1, 0});

  for (const Handle& h : s.player.scene().handles) {
    if (s.pane == Pane::fixed) break;
    const Vec2 at = view.project(h.at).at;
    const float x = static_cast<float>(at.x()), y = static_cast<float>(at.y());
    const Rect grip{x - hit_area, y - hit_area, x + hit_area, y + hit_area};
    ui.rects["handle " + h.parameter] = grip;
    focused(ui, "handle " + h.parameter, grip);
  }
  const std::optional<Handle> under = held_ ? held_ : hovered ? handle_near(s, view, mouse()) : std::nullopt;
  if (hovered && !active) point_at_names(s, view, r, labels_, under);
  light_names(s, view, r, labels_);
  if (under)
    handle_under_pointer(s, view, *under, held_ ? forbidden_ : std::string());
  else if (hovered && !active && ui.sum.empty())
    item_under_pointer(s, view, mouse());

  verdict_chip(s, r);
  alarm_chip(s, r);
  const bool in_space = !s.player.scene().chart;
  if (in_space) tripod(s, view, r);
  if (lead && in_space && !s.player.lesson().flat) projection_text(s, r);
  if (lead) changed_text(s, r);
  toast(s, r);
  if (!lead) filled({r.left, r.top, r.left + 1, r.bottom}, ui.palette.rule, 0);
  ImGui::End();
}

}  // namespace isect::viz
