#pragma once
// The steps of a scene's lesson: its objects, then a step for each question, then all answers.

#include "app/scene/file.h"
#include "app/scene/pair_answers.h"
#include "viz/lesson.h"

namespace isect::program::scene {

/// Returns the walk with these numbers, to which `kept` must have moved.
viz::Walk steps_of_scene(const File&, const viz::Parameters&, PairAnswers& kept);

}  // namespace isect::program::scene
