// Two players side by side: the same lesson, the same step, one camera.

#include <algorithm>

#include "viz/compose/compose.h"
#include "viz/player/player.h"

namespace isect::viz {

void Player::follow(const Player& lead, const Parameters& parameters) {
  if (state_.lesson != lead.state_.lesson || parameters != state_.parameters) {
    all_or_nothing([&](Player& next) {
      State state = lead.state_;
      state.parameters = parameters;
      next.show(std::move(state), state_.lesson == lead.state_.lesson);
    });
  }
  state_.wanted = lead.state_.wanted, state_.slug = lead.state_.slug, state_.outcome = lead.state_.outcome;
  if (const int at = step_in(walk(), state_); at != at_) {
    begin_motion();
    ask(false);
    show_step(at);
    ++revision_;
  }
  // A question covers both scenes: neither shows more than the question does.
  const bool asks = lead.asking_ && !at_end() && walk().steps[index() + 1].question;
  if (asks != asking_) ask(asks), ++revision_;
  playing_ = false;
  since_step_ = lead.since_step_;
  if (!lead.before_) before_.reset();
  camera_ = lead.camera_;
  moved_ = true;  // it never frames a view of its own
  memory_.clear();
  action_.clear();
}

void Player::take_from(const Player& other, const Parameters& shared) {
  if (other.at_ != step_in(other.walk(), state_)) go_to(step_in(walk(), other.state_));
  if (shared != state_.parameters) {
    remember("in the other pane");
    set_parameters(shared);
  }
  if (other.camera_.goal() == camera_.goal()) return;
  remember("turn the other pane");
  camera_ = other.camera_;
  moved_ = true;
}

void Player::accompany(const Player* other) {
  const bool anew = (other == nullptr) != (beside_ == nullptr);
  beside_ = other ? std::shared_ptr<const Walk>(other->walk_, &other->walk()) : nullptr;
  if (anew && !moved_) camera_.glide(opening_view());
}

}  // namespace isect::viz
