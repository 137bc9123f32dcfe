#include <algorithm>
#include <cmath>
#include <utility>

#include "viz/player/practice.h"
#include "viz/text/rich_text.h"
#include "viz/window/map_view.h"
#include "viz/window/panels.h"
#include "viz/window/second_pane.h"

namespace isect::viz {
namespace {

/// Returns where step i of the scrubber stands.
float place_of(const Rect& r, int i, int count) {
  const float x0 = r.left + 32, x1 = r.right - 32;
  return count < 2 ? x0 : x0 + (x1 - x0) * static_cast<float>(i) / static_cast<float>(count - 1);
}

int step_at(const Rect& r, float x, int count) {
  if (count < 2) return 0;
  const float share = (x - place_of(r, 0, count)) / (place_of(r, count - 1, count) - place_of(r, 0, count));
  return std::clamp(static_cast<int>(std::lround(share * static_cast<float>(count - 1))), 0, count - 1);
}

void scrubber(Player& player, Ui& ui, const Rect& r, float y) {
  const Palette& c = ui.palette;
  const Press p = press(ui, "scrubber", {r.left + 16, y - 12, r.right - 16, y + 12});
  const int under = step_at(r, ImGui::GetIO().MousePos.x, player.count());
  if (p.held && under != player.index()) player.go_to(under);
  if (p.hovered || p.held) {
    const std::string title = player.tells_title(under) ? "  " + plain(player.walk().steps[under].title) : "";
    tooltip(ui, std::to_string(under + 1) + title);
  }

  const float knob = place_of(r, player.index(), player.count());
  filled({r.left + 24, y - 2, r.right - 24, y + 2}, c.frame, 2);
  filled({r.left + 24, y - 2, knob, y + 2}, c.first, 2);
  float last = -1;
  for (int i = 0; i < player.count(); ++i) {
    const bool decides = player.walk().steps[i].decides;
    const float x = std::round(place_of(r, i, player.count())), half = decides ? 8.0f : 5.0f;
    if (std::exchange(last, x) == x && !decides) continue;  // with thousands of steps, many share a pixel
    const Colour& ink = i <= player.index() ? c.first : c.theme.ink(Role::construction);
    filled({x - (decides ? 1.0f : 0.5f), y - half, x + (decides ? 1.0f : 0.5f), y + half}, ink, 0);
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCircleFilled({knob, y}, p.held ? 11.0f : 9.0f, packed(c.first), 32);
  list.AddCircleFilled({knob, y}, 3.5f, packed(c.window), 16);
}

void buttons(WindowSession& s, float middle, float y) {
  Player& player = s.player;
  Ui& ui = s.ui;
  const auto at = [&](int i) {
    const float x = middle + static_cast<float>(i) * 52;
    return Rect{x - 22, y - 18, x + 22, y + 18};
  };
  const bool start = player.index() == 0 && !player.quiz().asked();
  if (icon_button(ui, "first", at(-2), Icon::first, false, !start)) player.first();
  if (icon_button(ui, "back", at(-1), Icon::back, false, may_go_back(s))) go_back(s);
  if (icon_button(ui, "play", at(0), player.running() ? Icon::pause : Icon::play, true, true)) player.toggle_play();
  if (icon_button(ui, "next", at(1), Icon::next, false, may_go_on(s))) go_on(s);
  if (ImGui::IsItemHovered() && !s.hour && leads_on(s)) tooltip(ui, "Next: " + plain(next_lesson(player)->title));
  if (icon_button(ui, "last", at(2), Icon::last, false, !player.at_end())) player.last();

  constexpr const char* speeds[] = {"0.5×", "1×", "1.5×", "2×"};
  const Rect speed{at(2).right + 12, y - 15, at(2).right + 60, y + 15};
  const Press p = press(ui, "speed", speed);
  if (p.clicked) player.clock().next_speed();
  if (p.hovered) {
    filled(speed, ui.palette.frame);
    tooltip(ui, "Speed of play");
  }
  const int i = std::clamp(static_cast<int>(std::lround(player.clock().speed() * 2)) - 1, 0, 3);
  text(ui.fonts.body, speed.middle_x(), y, packed(ui.palette.muted), speeds[i], 0.5f);

  const Rect map{speed.right + 12, y - 18, speed.right + 56, y + 18};
  if (icon_button(ui, "show map", map, Icon::map, shows_map(player, s.settings), has_map(player)))
    show_map(player, s.settings, s.toast);
  if (ImGui::IsItemHovered()) tooltip(ui, "Where this case lies: the map of cases beside the scene (W)");
  const Rect panes{map.right + 8, map.top, map.right + 52, map.bottom};
  if (icon_button(ui, "two panes", panes, Icon::panes, two_panes(player, s.settings), true))
    toggle_panes(player, s.settings, s.toast);
  if (ImGui::IsItemHovered()) tooltip(ui, "Method against method, or preset against preset (V)");
  const Rect pass{panes.right + 8, panes.top, panes.right + 52, panes.bottom};
  if (icon_button(ui, "pass questions", pass, Icon::pass, s.settings.nonstop, true))
    pass_questions(player, s.settings, s.toast);
  const bool by_key = !pages_go_on(s) && !leads_on(s);  // else N goes on
  if (ImGui::IsItemHovered()) tooltip(ui, by_key ? "Play passes over questions (N)" : "Play passes over questions");
}

void key_hints(const Ui& ui, float right, float room, float y) {
  float x = right;
  for (const char* hint : {"F1 keys", "space play", "← → step"}) {
    const float width = text_width(ui.fonts.body, hint);
    if (right - (x - width) > room) return;
    text(ui.fonts.body, x, y, packed(ui.palette.muted), hint, 1);
    x -= width + 18;
  }
}

}  // namespace

void pass_questions(Player& player, Settings& settings, Toast& toast) {
  settings.nonstop = !settings.nonstop;
  player.clock().stop_at_questions(!settings.nonstop);
  toast.say(settings.nonstop ? "Play passes over questions now" : "Play stops at questions again");
}

void transport(WindowSession& s, const Rect& r) {
  Player& player = s.player;
  Ui& ui = s.ui;
  begin_region(ui, "transport", r);
  rule(ui, r.left, r.right, r.top);
  const bool low = r.height() < 80;
  scrubber(player, ui, r, r.top + (low ? 12.0f : 20.0f));

  const float y = r.top + (low ? 43.0f : 58.0f), middle = std::round(r.middle_x());
  const std::string where = "Step " + std::to_string(player.index() + 1) + " of " + std::to_string(player.count());
  const float left = s.hour ? hour_badge(s, 24, y) + 16 : 24;
  const float end = left + text(ui.fonts.body, left, y, packed(ui.palette.text), where);
  const Paragraph title{.markup = player.step().title, .colour = ui.palette.muted};
  const float room = middle - 136 - (end + 24);
  if (ui.texts.size_of(title).x <= room)
    rich_line(ui, title, end + 24, y);
  else if (room > 60)
    text(ui.fonts.body, end + 24, y, packed(ui.palette.muted), fitted(ui.fonts.body, plain(title.markup), room));
  buttons(s, middle, y);
  key_hints(ui, r.right - 24, r.right - 24 - (middle + 354), y);
  ImGui::End();
}

}  // namespace isect::viz
