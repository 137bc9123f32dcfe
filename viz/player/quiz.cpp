#include "viz/player/quiz.h"

#include "viz/walk/question_scene.h"

namespace isect::viz {

void Quiz::ask(const Walk& walk, int step) {
  asking_step_ = std::make_shared<const Step>(viz::asking_step(walk, step));
  asked_ = &*walk.steps[step].question;
}

void Quiz::close() {
  asked_ = nullptr;
  asking_step_.reset();
}

void Quiz::show(const Walk& walk, int step) {
  answered_.reset();
  const auto found = answers_.find(step);
  if (found != answers_.end() && found->second) answered_ = {&*walk.steps[step].question, *found->second};
}

}  // namespace isect::viz
