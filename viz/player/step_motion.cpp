#include "viz/player/step_motion.h"

#include "viz/player/transition.h"

namespace isect::viz {
namespace {

constexpr double seconds_to_light = 0.120;

}  // namespace

double StepMotion::share() const { return before_ ? eased(since_step_ / seconds_to_move) : 1; }
double StepMotion::light() const { return reduced_ ? 1 : eased(since_step_ / seconds_to_light); }

void StepMotion::begin(std::shared_ptr<const Scene> from) {
  if (reduced_) return;
  before_ = std::move(from);
  since_step_ = 0;
}

void StepMotion::advance(double seconds) {
  since_step_ += seconds;
  if (since_step_ >= seconds_to_move) before_.reset();
}

void StepMotion::reduce(bool reduced) {
  reduced_ = reduced;
  if (reduced) before_.reset();
}

void StepMotion::follow(const StepMotion& lead) {
  since_step_ = lead.since_step_;
  if (!lead.before_) before_.reset();
}

}  // namespace isect::viz
