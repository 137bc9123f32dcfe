#include "viz/window/time_strip.h"

#include <algorithm>
#include <cmath>

#include "viz/player/scene_time.h"
#include "viz/text/rich_text.h"
#include "viz/window/scene_marks.h"

namespace isect::viz {
namespace {

constexpr float reach_of_contact = 5;  ///< px
constexpr const char* nothing_moves = "Nothing moves in this step";

/// A line from `left` to `right` for the whole motion.
struct TimeLine {
  const Scene::Time& time;
  float left, right;

  float place_of(double t) const {
    return left + (right - left) * static_cast<float>((t - time.lo) / (time.hi - time.lo));
  }
  double a_pixel() const { return (time.hi - time.lo) / (right - left); }
  double at(float x) const { return time_near(time, time.lo + (x - left) * a_pixel(), reach_of_contact * a_pixel()); }
};

/// Draws the button, the line, and the words.
void time_line(Player& player, Ui& ui, const Rect& r) {
  const Scene::Time* const time = player.time();
  if (!time) return;
  const Palette& c = ui.palette;
  const float y = std::round(r.middle_y());
  const Rect button{r.left + 16, y - 14, r.left + 56, y + 14};
  if (icon_button(ui, "run time", button, player.time_runs() ? Icon::pause : Icon::play, false, true))
    player.toggle_time();
  if (ImGui::IsItemHovered()) tooltip(ui, "Let time run (K); to the contact (J)");

  const float words = std::min(0.45f * r.width(), 260.0f);
  const TimeLine line{*time, button.right + 20, r.right - words - 20};
  const Press p = press(ui, "time line", {line.left - 10, y - 13, line.right + 10, y + 13});
  if (p.held) player.stop_time(), player.set_time(line.at(ImGui::GetIO().MousePos.x));

  const float knob = line.place_of(player.now());
  filled({line.left, y - 2, line.right, y + 2}, c.frame, 2);
  filled({line.left, y - 2, knob, y + 2}, c.first, 2);
  if (time->contact) {
    const float x = std::round(line.place_of(*time->contact));
    filled({x - 1, y - 11, x + 1, y + 11}, c.hit, 0);
    diamond(x, y - 11, 9, packed(c.hit));
  }
  ImGui::GetWindowDrawList()->AddCircleFilled({knob, y}, p.held ? 9.0f : 7.5f, packed(c.first), 32);
  const std::string told = plain(time_words(*time, player.now()));
  const bool brief = text_width(ui.fonts.body, told) > words;
  text(ui.fonts.body, line.right + 20, y, packed(c.text), brief ? plain(time_words(*time, player.now(), true)) : told);
}

}  // namespace

float time_room(const Player& player, const Rect& whole) {
  if (!player.played().has_time()) return 0;
  return is_low(whole) ? 30.0f : 38.0f;
}

void time_strip(Player& player, Ui& ui, const Rect& r, bool lead) {
  begin_region(ui, "time", r);
  if (lead) time_line(player, ui, r);
  ImGui::End();
}

void run_time(Player& player, Toast& toast) {
  if (!player.time()) return toast.say(nothing_moves);
  player.toggle_time();
}

void go_to_contact(Player& player, Toast& toast) {
  const Scene::Time* const time = player.time();
  if (!time) return toast.say(nothing_moves);
  if (!time->contact) return toast.say("No contact is found up to this step");
  player.stop_time();
  player.set_time(player.now() == *time->contact ? time->lo : *time->contact);
}

}  // namespace isect::viz
