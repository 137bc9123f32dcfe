#include "viz/player/quiz.h"

#include "viz/walk/question_scene.h"
#include "viz/walk/typed_answer.h"

namespace isect::viz {

std::string Answered::reply() const {
  return typed.empty() ? reply_to_choice(*question, choice) : reply_to(*question->number, number);
}

void Quiz::ask(const Walk& walk, int step) {
  asking_step_ = std::make_shared<const Step>(viz::asking_step(walk, step));
  asked_ = &*walk.steps[step].question;
  choices_shown_ = false;
}

void Quiz::close() {
  asked_ = nullptr;
  asking_step_.reset();
}

void Quiz::show(const Walk& walk, int step) {
  answered_.reset();
  const auto found = answers_.find(step);
  if (found == answers_.end() || !found->second) return;
  const GivenAnswer& given = *found->second;
  answered_ = Answered{&*walk.steps[step].question, given.choice, given.typed, given.number};
}

}  // namespace isect::viz
