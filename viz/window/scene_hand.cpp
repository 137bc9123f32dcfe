// The part of SceneView in which a hand moves handles: the pointer takes one and drags it, keys move one, or turn the
// scene.

#include "viz/window/scene_hand.h"

#include <algorithm>
#include <ctime>
#include <string_view>
#include <utility>

#include "viz/player/camera_moves.h"
#include "viz/player/scene_time.h"
#include "viz/window/key_codes.h"

namespace isect::viz {
namespace {

constexpr const char* searching = "Looking for where the case changes …";

}  // namespace

std::optional<Handle> handle_of_keyboard(const ScenePane& s) {
  constexpr std::string_view part = "handle ";
  const std::string& name = s.ui.focus.name();
  if (s.pane != Pane::lead || !name.starts_with(part)) return {};
  for (const Handle& h : s.player.scene().handles)
    if (h.id() == std::string_view(name).substr(part.size())) return h;
  return {};
}

std::optional<Handle> handle_near(const std::vector<Handle>& handles, const View& view, const Vec2& pixel) {
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
  if (const std::optional<Handle> ringed = handle_of_keyboard(s); ringed && io.KeyShift) {
    if (way == Vec2::Zero()) return;
    const Handle& handle = *ringed;
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

/// Takes the handle at the pointer when the button is pressed, and lets it go when the button is released. Pressed
/// twice it removes a corner, or adds one to a side, or frames all; between two short drags nothing is removed.
void SceneView::take_or_release(const ScenePane& s, const View& view, bool hovered) {
  if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    s.player.end_action();
    held_ = handle_near(s.handles(), view, mouse());
    forbidden_.clear();
    end_search(s.toast);
    const bool twice = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    const bool as_before = twice && clicked_at_ == s.player.revision();
    clicked_at_ = s.player.revision();
    if (held_ && as_before && s.remove_corner && s.remove_corner(*held_)) {
      held_.reset();
    } else if (held_) {
      s.player.remember("drag");
      held_in_ = &s.player.lesson(), start_ = held_->at, snapping_ = false;
      begun_ = s.player.parameters(), pressed_ = followed_ = mouse();
      grip_ = mouse() - view.project(held_->at).at;
    } else if (twice && !(s.add_corner && s.add_corner(view, mouse()))) {
      frame_all(s.player);
    }
  }
  if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) s.player.end_action();
  if (!ImGui::GetIO().MouseDown[0] && held_) {
    const Vec2 at = view.project(held_->at).at - view.corner();
    const bool seen = at.x() >= 0 && at.x() <= view.width() && at.y() >= 0 && at.y() <= view.height();
    if (!seen) s.toast.say_here(s.player, "It is out of sight: F shows all of the scene");
    if (mouse() != pressed_) released_ = mouse();
    held_.reset();
  }
}

}  // namespace isect::viz
