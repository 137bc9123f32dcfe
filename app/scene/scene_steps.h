#pragma once
// The steps of a scene's lesson: its objects, then a step for each question, then all answers.

#include "app/scene/file.h"
#include "app/scene/known.h"
#include "viz/lesson.h"

namespace isect::program::scene {

/// Returns the walk with these numbers. `known`: of the walk before, whose objects it had in the same order.
/// Throws viz::BadInput if the core refuses the numbers.
viz::Walk steps_of_scene(const File&, const viz::Parameters&, Known& known);

}  // namespace isect::program::scene
