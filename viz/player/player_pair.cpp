// Two players side by side: the same lesson, the same step, one camera.

#include "viz/player/player.h"

namespace isect::viz {

void Player::follow(const Player& lead, const Parameters& parameters) {
  const bool same_lesson = chosen_.lesson == lead.chosen_.lesson;
  if (!same_lesson || chosen_.version != lead.chosen_.version || parameters != chosen_.parameters) {
    all_or_nothing([&](Player& next) {
      Chosen chosen = lead.chosen_;
      chosen.parameters = parameters;
      next.show(std::move(chosen), same_lesson);
    });
  }
  chosen_.choose_step(lead.chosen_);
  if (const int at = step_in(walk(), chosen_); at != at_) {
    begin_motion();
    ask(false);
    show_step(at);
    ++revision_;
  }
  // While a question is open, neither pane shows more than it does.
  const bool asks = lead.quiz_.asked() && can_ask();
  if (asks != (quiz_.asked() != nullptr)) ask(asks), ++revision_;
  if (lead.now_)
    set_time(*lead.now_);
  else if (now_)
    leave_time();
  clock_.play(false);
  motion_.follow(lead.motion_);
  camera_.take(lead.camera_);  // it never frames a view of its own
  history_ = {};
}

void Player::take_from(const Player& other, const Parameters& shared) {
  if (other.at_ != step_in(other.walk(), chosen_)) go_to(step_in(walk(), other.chosen_));
  if (shared != chosen_.parameters) {
    remember("in the other pane");
    set_parameters(shared);
  }
  if (other.camera_.goal() == camera_.goal()) return;
  remember("turn the other pane");
  camera_.take(other.camera_);
}

void Player::accompany(const Player* other) {
  const bool anew = camera_.accompany(other ? std::shared_ptr<const Walk>(other->played_, &other->walk()) : nullptr);
  if (anew) look();
}

}  // namespace isect::viz
