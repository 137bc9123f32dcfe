// Time within a step whose shapes move: its scene at another time than the step's own.

#include "viz/player/player.h"
#include "viz/player/scene_time.h"

namespace isect::viz {

double Player::now() const { return now_ ? *now_ : time() ? time()->now : 0; }

void Player::set_time(double t) {
  if (!time()) return;
  const double to = time_near(*time(), t);
  if (now_ == to) return;
  const bool begins = !now_;
  auto posed = std::make_shared<Scene>(time()->at(to));
  posed->time = shown().scene.time;
  now_ = to, posed_ = std::move(posed);
  if (begins) look(seconds_to_move);
}

Walk Player::drawn_walk() const { return now_ ? at_time(walk(), index(), *now_) : walk(); }

void Player::toggle_time() {
  if (!time()) return;
  clock_.play(false);
  if (motion_.reduced()) return set_time(next_still(*time(), now()));
  if (time_runs_) {
    time_runs_ = false;
    return;
  }
  set_time(now() < time()->hi ? now() : time()->lo);
  time_runs_ = true;
}

void Player::let_time_run(double seconds) {
  if (!time_runs_ || !time()) return;
  set_time(time_after(*time(), now(), seconds));
  time_runs_ = now() < time()->hi;
}

void Player::leave_time() {
  now_.reset();
  posed_.reset();
  arranged_.reset();
  time_runs_ = false;
}

void Player::keep_time(const Player& before) {
  if (!before.now_ || !time() || step().slug != before.step().slug) return;
  set_time(*before.now_);
  time_runs_ = before.time_runs_;
}

Camera Player::framed_view() const {
  const Camera usual = camera_.opening(*played_, shown().view, shown().scene, projection());
  if (!now_ || !time()) return usual;
  const Scene begin = time()->at(time()->lo), end = time()->at(time()->hi);
  if (camera_.has_in_view(usual, begin) && camera_.has_in_view(usual, end)) return usual;
  return camera_.whole(*played_, shown().view, {&begin, &end});
}

}  // namespace isect::viz
