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
#include "viz/compose/small_multiples.h"
#include "viz/compose/t_axis.h"
#include "viz/player/camera_moves.h"
#include "viz/player/dragging.h"
#include "viz/player/transition.h"
#include "viz/window/edge_arrows.h"
#include "viz/window/scene_hand.h"
#include "viz/window/scene_lights.h"
#include "viz/window/scene_marks.h"
#include "viz/window/scene_names.h"
#include "viz/window/time_strip.h"

namespace isect::viz {
namespace {

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
  const std::string what =
      fmt::format("{} {} {} {} {} {} {} {} {}", static_cast<int>(s.pane), s.player.revision(), s.player.is_arranged(),
                  motion, s.player.now(), r.width(), r.height(), scale, name_of(s.ui.palette.theme.name));
  if (s.player.scene().chart) return what;  // the camera does not matter
  return what + fmt::format(" {} {} {} {} {} {} {} {}", c.target.x(), c.target.y(), c.target.z(), c.azimuth,
                            c.elevation, c.half_height, c.perspective, c.field_of_view);
}

/// Returns the theme of the axis: smaller where the scene is low.
Theme axis_look(const Theme& theme, const Rect& r) { return window_theme(theme.name, is_low(r) ? 0.7 : 0.9); }

/// Returns the height of a ray's t-axis below the scene: the same in all steps.
float axis_room(const Player& player, const Theme& theme, const Rect& r) {
  return player.played().has_axis() ? static_cast<float>(axis_height * axis_look(theme, r).sizes.axis) + 10 : 0;
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

/// Whether a drawing has so many facets, corners or shapes that it is drawn coarser while it moves.
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

Camera SceneView::arrange(Player& player) {
  constexpr double taken = 0.9;  // of the picture, as by other small multiples
  player.arrange(nullptr);
  const Scene& own = player.own_scene();
  if (!own.grid || player.camera().moved()) return player.camera().now();
  const double aspect = player.camera().aspect();
  if (own.grid != arranged_of_ || aspect != arranged_for_) {
    std::optional<Scene> best = arranged(own, player.camera().goal(), aspect);
    arranged_ = best ? std::make_shared<const Scene>(std::move(*best)) : nullptr;
    arranged_of_ = own.grid, arranged_for_ = aspect;
  }
  if (!arranged_) return player.camera().now();
  Camera camera = frame(player.camera().goal(), {arranged_.get()}, aspect, 0);
  camera.half_height /= taken;
  player.arrange(arranged_);
  return camera;
}

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
    tell_handle(s, r, view, *under);
  else if (const std::optional<Handle> ringed = handle_of_keyboard(s))
    handle_by_keyboard(s.player, s.ui, view, *ringed);
  else if (hovered && !active && s.ui.sum.empty())
    item_under_pointer(s.player, s.ui, view, mouse());
}

/// Tells of a handle at the pointer, where the words do not cover what is dragged; of one that was let go, nothing
/// until the pointer moves.
void SceneView::tell_handle(const ScenePane& s, const Rect& r, const View& view, const Handle& handle) {
  ring_handle(s.ui, view, handle);
  const bool dragged = held_ && mouse() != pressed_;
  if (dragged)
    return words_at_edge(s.ui, words_on_handle(s.player, handle, forbidden_), r, {view.project(handle.at).at, mouse()});
  if (released_ == mouse()) return;
  tooltip(s.ui, words_on_handle(s.player, handle, held_ ? forbidden_ : std::string()));
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
  const float height = r.height() - head - std::max(below, changed_room(player, s.in_file));
  const Vec2 corner(r.left, r.top + head);
  const View before(arrange(player), r.width(), height, corner);

  const bool lead = s.pane == Pane::lead, in_space = !player.scene().chart && !has_drawings(player.scene());
  if (lead && in_space && !player.lesson().flat) projection_name(player, ui, before, r, s.handles());
  if (lead) changed_mark(player, ui, s.toast, r, s.in_file);
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

  const View view(arrange(player), r.width(), height, corner);
  draw(s, r, view);
  ImGui::GetWindowDrawList()->AddImage(picture_.id(), top_left(r), bottom_right(r), {0, 1}, {1, 0});
  handles_and_names(s, r, view, hovered, active);
  chart_under_pointer(s, r, view, hovered);

  verdict_chip(player, ui, r);
  alarm_chip(player, ui, r);
  if (in_space && !(player.lesson().flat && is_low(r))) tripod(ui, view, r, labels_, s.handles());
  if (lead && in_space && !player.lesson().flat) projection_text(player, ui, r, labels_);
  if (lead) changed_text(player, ui, r, s.in_file);
  if (lead) pin_text(player, ui, r);
  if (s.pane != Pane::fixed) draw_edge_arrows(player, ui, view, r);
  toast(ui, s.toast, r, labels_, player.lesson().id + " " + player.shown().slug, message_);
  if (!lead) filled({r.left, r.top, r.left + 1, r.bottom}, ui.palette.rule, 0);
  ImGui::End();
}

}  // namespace isect::viz
