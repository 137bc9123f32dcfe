// On and back: through the stops of a playlist, or else through the steps of a lesson and to the next one.

#include <algorithm>

#include "viz/player/practice.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

/// Moves through the playlist. A stop that is come to has its own second pane, or none.
template <class Move>
void move_in_hour(WindowSession& s, Move&& move) {
  const int before = s.hour->at();
  const bool was_away = s.hour->away(s.player);
  attempt(s.toast, [&] { move(*s.hour); });
  const Stop& now = s.hour->stop();
  if ((s.hour->at() != before || was_away) && now.fault.empty()) s.settings.beside = beside_of(now.state);
}

}  // namespace

void go_on(WindowSession& s) {
  if (!s.hour) return leads_to_next_lesson(s.player) ? open_next_lesson(s.player, s.toast) : s.player.next();
  move_in_hour(s, [&](Hour& hour) {
    if (!hour.on(s.player)) s.toast.say("The playlist ends here");
  });
}

void go_back(WindowSession& s) {
  if (!s.hour) return s.player.back();
  move_in_hour(s, [&](Hour& hour) {
    if (!hour.back(s.player)) s.toast.say("The playlist begins here");
  });
}

bool leads_on(const WindowSession& s) {
  return s.hour ? s.hour->leaves(s.player) || s.hour->away(s.player) : leads_to_next_lesson(s.player);
}

bool may_go_on(const WindowSession& s) {
  return s.hour ? !s.hour->at_end(s.player) : leads_to_next_lesson(s.player) || !s.player.at_end();
}

bool may_go_back(const WindowSession& s) {
  return s.hour ? !s.hour->at_start(s.player) : s.player.index() > 0 || s.player.quiz().asked();
}

bool names_presets(const WindowSession& s) {
  return !s.player.quiz().asked() && !(s.hour && s.hour->asks_ahead(s.player));
}

bool pages_go_on(const WindowSession& s) { return !s.panels || s.hour.has_value(); }

std::optional<Hour> hour_of(const Playlist& playlist, const Settings& kept) {
  if (playlist.stops.empty()) return {};
  const auto left = std::ranges::find(kept.hours, playlist.file, &HourPlace::file);
  return Hour(playlist, left == kept.hours.end() ? HourPlace{} : *left);
}

void begin_hour(WindowSession& s) {
  if (!s.hour) return;
  s.hour->begin(s.player);
  const Stop& now = s.hour->stop();
  s.settings.beside = now.fault.empty() ? beside_of(now.state) : std::nullopt;
}

void follow_hour(WindowSession& s) {
  if (!s.hour) return;
  if (!s.review) s.hour->follow(s.player);
  const bool told = !s.review && s.hour->at_first_step(s.player);
  s.step_words.note = told ? s.hour->stop().note : std::string();
}

void open_stop(WindowSession& s, int stop) {
  move_in_hour(s, [&](Hour& hour) { hour.open(s.player, stop); });
}

void keep_hour(std::vector<HourPlace>& hours, const HourPlace& now) {
  std::erase_if(hours, [&](const HourPlace& hour) { return hour.file == now.file; });
  hours.insert(hours.begin(), now);
  if (hours.size() > hours_kept) hours.resize(hours_kept);
}

}  // namespace isect::viz
