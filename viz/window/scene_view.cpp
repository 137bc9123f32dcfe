#include "viz/window/scene_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iterator>
#include <utility>

#include "viz/chart/chart.h"
#include "viz/chart/chart_pick.h"
#include "viz/compose/compose.h"
#include "viz/compose/t_axis.h"
#include "viz/player/camera_moves.h"
#include "viz/player/dragging.h"
#include "viz/player/scene_time.h"
#include "viz/player/transition.h"
#include "viz/window/edge_arrows.h"
#include "viz/window/key_codes.h"
#include "viz/window/scene_lights.h"
#include "viz/window/scene_marks.h"
#include "viz/window/scene_names.h"
#include "viz/window/time_strip.h"

namespace isect::viz {
namespace {

constexpr float hit_area = 14;
constexpr const char* searching = "Looking for where the case changes …";

Vec2 mouse() { return {ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y}; }

/// Whether the scene has small drawings, each with a heading.
bool has_drawings(const Scene& scene) {
  return std::ranges::count_if(scene.items, [](const Item& i) { return std::holds_alternative<Heading>(i); }) > 2;
}

/// Returns a smaller theme in a small scene of small drawings, which are too close together for their texts, or of a
/// chart, whose plane gets what its texts leave.
Theme look(const Scene& scene, const Theme& theme, const View& view) {
  const double fits = std::clamp(std::min(view.width() / 600, view.height() / 350), 0.65, 1.0);
  const bool smaller = scene.chart || has_drawings(scene);
  return smaller ? window_theme(theme.name, fits) : theme;
}

std::string line_of(const ScenePane& s, const Rect& r, double scale) {
  const Camera& c = s.player.camera().now();
  const Scene* const before = s.player.motion().before();
  const double motion = before && may_move(*before, s.player.scene()) ? s.player.motion().share() : 1;
  const std::string what = fmt::format("{} {} {} {} {} {} {} {}", static_cast<int>(s.pane), s.player.revision(), motion,
                                       s.player.now(), r.width(), r.height(), scale, name_of(s.ui.palette.theme.name));
  if (s.player.scene().chart) return what;  // the camera does not matter
  return what + fmt::format(" {} {} {} {} {} {} {} {}", c.target.x(), c.target.y(), c.target.z(), c.azimuth,
                            c.elevation, c.half_height, c.perspective, c.field_of_view);
}

/// Returns the theme of the axis: smaller where the scene is low.
Theme axis_look(const Theme& theme, const Rect& r) { return window_theme(theme.name, is_low(r) ? 0.7 : 0.9); }

/// Returns the height of a ray's t-axis below the scene: the same in all steps.
float axis_room(const Player& player, const Theme& theme, const Rect& r) {
  return has_axis(player.walk()) ? static_cast<float>(axis_height * axis_look(theme, r).sizes.axis) + 10 : 0;
}

/// Draws the axis between the tripod and the name of the projection.
Composed axis_below(const Axis& axis, float room, const Theme& theme, const Rect& r) {
  constexpr double tripod_room = 100, projection_room = 130;
  const double left = std::max(0.2 * r.width(), tripod_room),
               right = std::min(0.8 * r.width(), r.width() - projection_room);
  const double y = r.height() - room + axis_line * theme.sizes.axis;
  return compose_axis(axis, left, std::max(right, left + 40), y, r.width(), theme);
}

/// Returns the map of cases that this step shows, if any.
const Cases* map_of(const Player& player) {
  const Scene& scene = player.scene();
  return scene.chart && player.lesson().map ? std::get_if<Cases>(&scene.chart->kind) : nullptr;
}

/// Whether a drawing has so many facets or corners that it is drawn coarser while it moves.
bool has_much(const Drawing& drawing) {
  constexpr std::size_t many_facets = 10'000, many_corners = 8000, many_shapes = 3000;
  if (drawing.shapes.size() > many_shapes) return true;
  std::size_t facets = 0, corners = 0;
  for (const Shape& shape : drawing.shapes)
    if (const Facets* mesh = std::get_if<Facets>(&shape)) {
      facets += mesh->colours.size();
    } else if (const Fill* fill = std::get_if<Fill>(&shape)) {
      corners += fill->path.segments.size();
      for (const Path& more : fill->more) corners += more.segments.size();
    } else if (const Stroke* stroke = std::get_if<Stroke>(&shape)) {
      corners += stroke->path.segments.size();
    }
  return facets > many_facets || corners > many_corners;
}

}  // namespace

void SceneView::draw(const ScenePane& s, const Rect& r, const View& view) {
  behind_ = false;
  if (r.width() < 1 || r.height() < 1) return;  // a display may make a window as small as it likes
  const std::string wanted = line_of(s, r, scale_);
  const ImGuiIO& io = ImGui::GetIO();
  const bool moves = io.MouseDown[0] || io.MouseDown[1] || turning_ >= 0;
  if ((wanted == drawn_ && (moves || !sketched_)) || !placing_) return;
  const Theme ink = look(s.player.scene(), s.ui.palette.theme, view);
  const View own(view.camera(), view.width(), view.height(), {0, view.corner().y() - r.top});
  Drawing drawing{r.width(), r.height(), ink.background, {}};
  Scene scene = with_names(s.player);
  const std::clock_t begun = std::clock();  // processor time: a busy machine is no reason to stop
  if (const Scene* before = s.player.motion().before()) scene = between(*before, scene, s.player.motion().share());
  const Cases* const map = map_of(s.player);
  Composed composed = map ? compose_map(*map, own.corner(), own.width(), own.height(), ink)
                          : compose(scene, own, ink, s.pane != Pane::fixed && draws_handles(scene));
  drawing.shapes = std::move(composed.shapes);
  labels_ = std::move(composed.labels);
  if (scene.axis && !scene.chart) {
    const Composed axis =
        axis_below(*scene.axis, axis_room(s.player, s.ui.palette.theme, r), axis_look(s.ui.palette.theme, r), r);
    std::ranges::copy(axis.shapes, std::back_inserter(drawing.shapes));
    std::ranges::copy(axis.labels, std::back_inserter(labels_));
  }
  drawn_ = wanted;
  sketched_ = moves && has_much(drawing);
  if (!drawing_) return;
  if (sketched_)
    renderer_.sketch(drawing, scale_);
  else
    renderer_.draw(drawing, scale_);
  const PixelBox size = pixels(drawing, scale_);
  picture_.take(renderer_.texture(), size.width, size.height);
  constexpr double most_to_move = 0.060;  // seconds
  if (static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC > most_to_move) s.player.arrive(), behind_ = true;
}

/// Returns the handle with the keyboard's ring.
static std::optional<Handle> handle_of_keyboard(const ScenePane& s) {
  const std::string name = s.ui.focus.name();
  for (const Handle& h : s.player.scene().handles)
    if (s.pane == Pane::lead && name == "handle " + h.id()) return h;
  return {};
}

static std::optional<Handle> handle_near(const std::vector<Handle>& handles, const View& view, const Vec2& pixel) {
  std::optional<Handle> nearest;
  double least = hit_area;
  for (const Handle& h : handles) {
    const Projected p = view.project(h.at);
    const double distance = (p.at - pixel).norm();
    if (!(p.depth > 0) || !(distance <= least)) continue;
    least = distance;
    nearest = h;
  }
  return nearest;
}

/// Drags the handle, with Shift only to a change of case next to the pointer. Where it was taken, it restores all.
void SceneView::drag_held(const ScenePane& s, const View& view) {
  const bool snapping = ImGui::GetIO().KeyShift;
  if (mouse() == followed_ &&
      (snapping == snapping_ || !snapping)) {  // it stays where it has snapped until the pointer moves
    snapping_ = snapping;
    return;
  }
  if (snapping && search_) return;  // one search after another: else none would end while the pointer moves
  snapping_ = snapping, followed_ = mouse();
  end_search(s.toast);
  attempt(s.toast, [&] {
    if (mouse() == pressed_) {
      forbidden_.clear();
      s.player.set_parameters(begun_);
      return;
    }
    const Vec3 to = brought(view, *held_, mouse() - grip_);
    if (snapping) return begin_snap(s.player, snapping_drag(s.player, *held_, start_, to));
    forbidden_ = drag_to(s.player, *held_, start_, to, false).refused;
  });
}

void SceneView::begin_snap(const Player& player, Snap snap) {
  search_.emplace(Search{std::move(snap), player.revision()});
}

/// Searches for as long as a frame has time, by the processor's clock; a result is shown in a frame that has searched
/// little. It is shown, too, if the button has been released meanwhile.
void SceneView::go_on_snapping(Player& player, Toast& toast) {
  if (!search_) return;
  if (search_->revision != player.revision()) return end_search(toast);
  constexpr int long_for_a_hand = 12;  // frames
  if (++search_->frames == long_for_a_hand) toast.say(searching);
  constexpr std::clock_t most = CLOCKS_PER_SEC / 80, little = CLOCKS_PER_SEC / 400;
  const std::clock_t begun = std::clock();
  while (!search_->ended && std::clock() - begun < most) search_->ended = !search_->snap.go_on();
  if (!search_->ended || std::clock() - begun > little) return;
  attempt(toast, [&] {
    const Moved moved = search_->snap.settle(player);
    forbidden_ = moved.refused;
    end_search(toast);
    if (!moved.told.empty()) toast.say_here(player, moved.told);
  });
  search_.reset();
}

void SceneView::end_search(Toast& toast) {
  search_.reset();
  if (toast.text == searching) toast = {};
}

/// Moves the handle that the keyboard holds by Shift and the arrows, with Ctrl to where the case changes next; without
/// such a handle, turns the scene. Ctrl and the arrows shift the scene.
void SceneView::keyboard(const ScenePane& s, const View& view) {
  const ImGuiIO& io = ImGui::GetIO();
  const Vec2 middle = view.corner() + Vec2(view.width(), view.height()) / 2;
  if (const double factor = std::exchange(s.zoom, 1.0); factor != 1) zoom(s.player, view, middle, factor);
  const double held_for = std::exchange(turning_, -1);
  if (!(io.KeyShift || io.KeyCtrl) || io.WantTextInput || ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup)) return;
  const auto way_of = [](auto&& asks) {
    return Vec2(asks(key::right) - asks(key::left), asks(key::down) - asks(key::up));
  };
  const Vec2 way = way_of([](key::Code code) { return ImGui::IsKeyPressed(code, true) ? 1.0 : 0.0; });
  const Vec2 down = way_of([](key::Code code) { return ImGui::IsKeyDown(code) ? 1.0 : 0.0; });
  if (down == Vec2::Zero() || s.player.scene().chart || s.ui.focus.name() == "map setting") return;
  if (const Scene::Time* time = s.player.time(); time && io.KeyShift && s.ui.focus.name() == "time line") {
    s.player.stop_time();
    if (way.x() != 0) s.player.set_time(time_beside(*time, s.player.now(), way.x() > 0 ? 1 : -1));
    return;
  }
  const std::vector<Handle>& handles = s.player.scene().handles;
  const auto held =
      std::ranges::find_if(handles, [&](const Handle& h) { return "handle " + h.id() == s.ui.focus.name(); });
  if (io.KeyShift && held != handles.end()) {
    if (way == Vec2::Zero()) return;
    const Handle handle = *held;
    if (io.KeyCtrl) {
      if (search_) return;
      return attempt(s.toast, [&] {
        Snap snap = snapping_nudge(s.player, view, handle, way);
        s.player.remember("snap " + handle.id());
        begin_snap(s.player, std::move(snap));
      });
    }
    attempt(s.toast, [&] {
      const Moved moved = nudge(s.player, view, handle, way, false);
      if (!moved.refused.empty()) s.toast.complain(moved.refused);
    });
    return;
  }
  if (!(io.KeyShift && io.KeyCtrl)) turn_by_keys(s, view, down, held_for);
}

/// Turns or shifts the scene a little at once, then frame by frame while the key is held.
void SceneView::turn_by_keys(const ScenePane& s, const View& view, const Vec2& down, double held_for) {
  const ImGuiIO& io = ImGui::GetIO();
  const Vec2 middle = view.corner() + Vec2(view.width(), view.height()) / 2;
  constexpr double once = 6, a_second = 240, patience = 0.18;  // px, seconds
  const double passed = std::min<double>(io.DeltaTime, 0.05);
  turning_ = held_for < 0 ? 0 : held_for + passed;
  const double far = held_for < 0 ? once : turning_ > patience ? a_second * passed : 0;
  if (far == 0) return;
  if (io.KeyShift && !s.player.lesson().flat)
    orbit(s.player, far * down);
  else
    pan(s.player, view, middle, middle - far * down);
}

void SceneView::pointer(const ScenePane& s, const View& view, bool hovered, bool active) {
  const ImGuiIO& io = ImGui::GetIO();
  if (held_ && held_in_ != &s.player.lesson()) held_.reset(), end_search(s.toast);  // a key has opened another lesson
  if (const Cases* cases = map_of(s.player)) {
    const Theme ink = look(s.player.scene(), s.ui.palette.theme, view);
    map_drag_.follow(s.player, s.toast, *cases, plane_of(*cases, view.corner(), view.width(), view.height(), ink),
                     hovered);
    last_ = mouse();
    return;
  }
  if (s.player.scene().chart && !held_) {  // a chart has no camera
    last_ = mouse();
    return;
  }
  if (const double turns = io.MouseWheel; hovered && turns != 0) zoom(s.player, view, mouse(), std::pow(1.15, turns));
  take_or_release(s, view, hovered);
  const bool moved = mouse() != last_;
  if (held_) {
    drag_held(s, view);
  } else if (active && moved && io.MouseDown[0] && !s.player.camera().moving()) {
    if (s.player.lesson().flat)
      pan(s.player, view, last_, mouse());
    else
      orbit(s.player, mouse() - last_);
  } else if (active && moved && io.MouseDown[1]) {
    pan(s.player, view, last_, mouse());
  }
  last_ = mouse();
}

/// Takes the handle at the pointer when the button is pressed, and lets it go when the button is released.
void SceneView::take_or_release(const ScenePane& s, const View& view, bool hovered) {
  if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    s.player.end_action();
    held_ = handle_near(s.handles(), view, mouse());
    forbidden_.clear();
    end_search(s.toast);
    if (held_) {
      s.player.remember("drag");
      held_in_ = &s.player.lesson(), start_ = held_->at, snapping_ = false;
      begun_ = s.player.parameters(), pressed_ = followed_ = mouse();
      grip_ = mouse() - view.project(held_->at).at;
    } else if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
      frame_all(s.player);
    }
  }
  if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) s.player.end_action();
  if (!ImGui::GetIO().MouseDown[0] && held_) {
    const Vec2 at = view.project(held_->at).at - view.corner();
    const bool seen = at.x() >= 0 && at.x() <= view.width() && at.y() >= 0 && at.y() <= view.height();
    if (!seen) s.toast.say_here(s.player, "It is out of sight: F shows all of the scene");
    held_.reset();
  }
}

/// Lights the names of the handles and of what is drawn, and tells about what is at the pointer, or at the keyboard's
/// ring.
void SceneView::handles_and_names(const ScenePane& s, const Rect& r, const View& view, bool hovered, bool active) {
  for (const Handle& h : s.handles()) {
    const Vec2 at = view.project(h.at).at;
    if (!draws_handles(s.player.scene()) && !r.contains(static_cast<float>(at.x()), static_cast<float>(at.y())))
      continue;
    const float x = static_cast<float>(at.x()), y = static_cast<float>(at.y());
    const Rect grip{x - hit_area, y - hit_area, x + hit_area, y + hit_area};
    s.ui.rects["handle " + h.id()] = grip;
    focused(s.ui, "handle " + h.id(), grip);
  }
  const std::optional<Handle> under = held_ ? held_ : hovered ? handle_near(s.handles(), view, mouse()) : std::nullopt;
  if (hovered && !active) point_at_names(s.player, s.ui, view, r, labels_, under);
  light_names(s.player, s.ui, view, r, labels_);
  if (under)
    handle_under_pointer(s.player, s.ui, view, *under, held_ ? forbidden_ : std::string());
  else if (const std::optional<Handle> ringed = handle_of_keyboard(s))
    handle_by_keyboard(s.player, s.ui, view, *ringed);
  else if (hovered && !active && s.ui.sum.empty())
    item_under_pointer(s.player, s.ui, view, mouse());
}

/// Tells the numbers of the marker or the point of a curve that the pointer is at.
void SceneView::chart_under_pointer(const ScenePane& s, const Rect& r, const View& view, bool hovered) {
  const Scene& scene = s.player.scene();
  if (!scene.chart || !hovered || map_of(s.player)) return;
  const std::string now = line_of(s, r, scale_) + fmt::format(" {} {}", r.left, r.top);
  if (now != marked_) {
    const Theme ink = look(scene, s.ui.palette.theme, view);
    marks_ = marks_of(*scene.chart, view.corner(), view.width(), view.height(), ink), marked_ = now;
  }
  const std::optional<ChartMark> mark = mark_near(marks_, mouse());
  if (!mark) return;
  const float x = static_cast<float>(mark->at.x()), y = static_cast<float>(mark->at.y());
  ImGui::GetWindowDrawList()->AddCircle({x, y}, 11, packed(s.ui.palette.text), 32, 2);
  s.ui.rects["chart marker"] = {x - 11, y - 11, x + 11, y + 11};
  tooltip(s.ui, mark->words);
}

void SceneView::show(const ScenePane& s, const Rect& whole) {
  const float time = time_room(s.player, whole);
  Rect r = whole;
  r.bottom -= time;
  if (time > 0) time_strip(s.player, s.ui, {r.left, r.bottom, r.right, whole.bottom}, s.pane == Pane::lead);
  Player& player = s.player;
  Ui& ui = s.ui;
  begin_region(ui, "scene", r);
  const float steady = steady_head(player, ui, tallest_verdict_, r), axis = axis_room(player, ui.palette.theme, r);
  player.set_aspect(r.width() / (r.height() - steady - axis));
  const float head = head_of(player, ui, steady, r), below = player.scene().chart ? 0 : axis;
  const float height = r.height() - head - std::max(below, changed_room(player));
  const Vec2 corner(r.left, r.top + head);
  const View before(player.camera().now(), r.width(), height, corner);

  const bool lead = s.pane == Pane::lead, in_space = !player.scene().chart && !has_drawings(player.scene());
  if (lead && in_space && !player.lesson().flat) projection_name(player, ui, before, r, s.handles());
  if (lead) changed_mark(player, ui, s.toast, r);
  if (lead) pin_mark(player, ui, s.toast, before, r, s.handles());
  if (s.pane != Pane::fixed) press_edge_arrows(player, ui, before, r);
  ImGui::SetCursorScreenPos(top_left(r));
  ImGui::InvisibleButton("picture", {r.width(), r.height()},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
  pointer(s, before, hovered, active);
  if (lead) keyboard(s, before);
  go_on_snapping(player, s.toast);
  if (const Handle* now = held_ ? same_handle(player.scene(), *held_) : nullptr) held_ = *now;

  const View view(player.camera().now(), r.width(), height, corner);
  draw(s, r, view);
  ImGui::GetWindowDrawList()->AddImage(picture_.id(), top_left(r), bottom_right(r), {0, 1}, {1, 0});
  handles_and_names(s, r, view, hovered, active);
  chart_under_pointer(s, r, view, hovered);

  verdict_chip(player, ui, r);
  alarm_chip(player, ui, r);
  if (in_space && !(player.lesson().flat && is_low(r))) tripod(ui, view, r, labels_, s.handles());
  if (lead && in_space && !player.lesson().flat) projection_text(player, ui, r, labels_);
  if (lead) changed_text(player, ui, r);
  if (lead) pin_text(player, ui, r);
  if (s.pane != Pane::fixed) draw_edge_arrows(player, ui, view, r);
  toast(ui, s.toast, r);
  if (!lead) filled({r.left, r.top, r.left + 1, r.bottom}, ui.palette.rule, 0);
  ImGui::End();
}

}  // namespace isect::viz
