#include "viz/player/play_clock.h"

#include <algorithm>

namespace isect::viz {
namespace {

constexpr double seconds_a_step = 1.6, seconds_to_read = 3.2;

}  // namespace

void PlayClock::play(bool on) {
  playing_ = on;
  waited_ = 0;
}

void PlayClock::next_speed() { speed_ = speed_ >= 2 ? 0.5 : speed_ + 0.5; }
void PlayClock::set_speed(double speed) { speed_ = std::clamp(speed, 0.5, 2.0); }

double PlayClock::seconds_to_step() const { return (seconds_a_step - waited_) / speed_; }

bool PlayClock::advance(double seconds) {
  waited_ += seconds * speed_;
  if (waited_ < seconds_a_step) return false;
  waited_ = 0;
  return true;
}

void PlayClock::begin_answered_step() { waited_ = -seconds_to_read; }

}  // namespace isect::viz
