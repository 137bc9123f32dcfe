#include "viz/player/quiz.h"

#include "viz/walk/question_scene.h"

namespace isect::viz {

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
  const Question& question = *walk.steps[step].question;
  answered_ = Answered{&question, given.choice, given.typed, told_of(question, given), reply_to(walk, step, given)};
}

}  // namespace isect::viz
