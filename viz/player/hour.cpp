#include "viz/player/hour.h"

#include <algorithm>
#include <utility>

namespace isect::viz {

namespace {

/// Returns the step that is on show, or that is asked about.
int step_at_hand(const Player& player) { return player.index() + (player.quiz().asked() ? 1 : 0); }

}  // namespace

Hour::Hour(Playlist list, const HourPlace& at) : list_(std::move(list)) {
  if (list_.stops.empty()) throw BadInput("the playlist has no stops");
  if (at.file != list_.file || at.stop < 0) return;
  at_ = std::min(at.stop, count() - 1);
  step_ = at_ == at.stop && at.step >= 0 ? at.step : -1;
}

std::string Hour::told() const { return std::to_string(at_ + 1) + " of " + std::to_string(count()); }

ReaderState Hour::start() const {
  const auto good = [](const Stop& s) { return s.fault.empty(); };
  const auto found = std::ranges::find_if(list_.stops, good);
  if (found == list_.stops.end()) throw BadInput(list_.stops.front().fault);
  if (!good(stop())) return found->state;
  ReaderState state = stop().state;
  if (step_ >= 0)
    state.step = step_;
  else if (stop().asks)
    state.step = stop().steps.front() - 1;
  if (state.step != stop().timed) state.time.reset();
  return state;
}

void Hour::begin(Player& player) {
  origin_ = player.origin();
  fault_seen_ = player.revision();
  if (stop().fault.empty() && stop().asks && step_ < 0) player.next();
  follow(player);
}

void Hour::follow(Player& player) {
  if (!stop().fault.empty() || away(player)) return;
  const bool asked = player.quiz().asked();
  const int before = step_;
  step_ = asked && at_first_step(player) ? -1 : player.index();
  if (!asked && step_ != before && step_ == stop().timed) player.set_time(*stop().state.time);
  const bool ends = !asked && !stop().whole && player.index() == stop().steps.back();
  if (ends && player.clock().playing()) player.clock().play(false);
}

bool Hour::away(const Player& player) const {
  return stop().fault.empty() && (&player.lesson() != stop().lesson || player.origin() != origin_);
}

bool Hour::faulty(const Player& player) const { return !stop().fault.empty() && player.revision() == fault_seen_; }

bool Hour::at_first_step(const Player& player) const {
  return stop().fault.empty() && !away(player) && step_at_hand(player) == stop().steps.front();
}

bool Hour::asks_ahead(const Player& player) const {
  if (!stop().fault.empty() || away(player)) return false;
  for (int step = player.index() + 1; step < player.count(); ++step) {
    const bool has = stop().whole || std::ranges::find(stop().steps, step) != stop().steps.end();
    if (has && player.walk().steps[step].question && !player.quiz().is_past(step)) return true;
  }
  return false;
}

/// Returns the stop's next step that is neither on show nor asked about. Of a stop with all steps it is the walk's next
/// one, whatever its parameters have become.
std::optional<int> Hour::step_after(const Player& player) const {
  const int now = step_at_hand(player), last = player.count() - 1;
  if (stop().whole) return now < last ? std::optional(now + 1) : std::nullopt;
  for (const int step : stop().steps)
    if (step > now && step <= last) return step;
  return {};
}

std::optional<int> Hour::step_before(const Player& player) const {
  const int now = step_at_hand(player);
  if (stop().whole) return now > 0 ? std::optional(now - 1) : std::nullopt;
  std::optional<int> before;
  for (const int step : stop().steps)
    if (step < now) before = step;
  return before;
}

void Hour::enter(Player& player, int number, int step, bool ask) {
  const Stop& to = stop(number);
  ReaderState state = to.state;
  const bool asks = ask && to.asks;
  state.step = asks ? step - 1 : step;
  if (state.step != to.timed) state.time.reset();
  player.go(state);
  origin_ = player.origin();
  if (asks) player.next();
  at_ = number;
  follow(player);
}

void Hour::open(Player& player, int to) {
  const Stop& next = stop(to);
  if (next.fault.empty()) return enter(player, to, next.steps.front(), true);
  player.clock().play(false);
  at_ = to, step_ = -1;
  fault_seen_ = player.revision();
}

bool Hour::leaves(const Player& player) const {
  if (!stop().fault.empty()) return true;
  return !away(player) && !player.quiz().asked() && !step_after(player);
}

bool Hour::at_start(const Player& player) const {
  if (at_ > 0 || away(player)) return false;
  return !stop().fault.empty() || !step_before(player);
}

bool Hour::on(Player& player) {
  if (at_end(player)) return false;
  if (away(player)) {
    enter(player, at_, step_ < 0 ? stop().steps.front() : step_, step_ < 0);
  } else if (leaves(player)) {
    open(player, at_ + 1);
  } else {
    const std::optional<int> to = player.quiz().asked() ? std::nullopt : step_after(player);
    if (to && *to > player.index() + 1) player.go_to(*to - 1);  // a step that this stop leaves out
    player.next();
    follow(player);
  }
  return true;
}

bool Hour::back(Player& player) {
  if (away(player)) return on(player);
  if (stop().fault.empty())
    if (const std::optional<int> to = step_before(player)) {
      if (player.quiz().asked() && *to == player.index())
        player.back();
      else
        player.go_to(*to);
      follow(player);
      return true;
    }
  if (at_ == 0) return false;
  const Stop& before = stop(at_ - 1);
  if (before.fault.empty())
    enter(player, at_ - 1, before.steps.back(), false);
  else
    open(player, at_ - 1);
  return true;
}

}  // namespace isect::viz
