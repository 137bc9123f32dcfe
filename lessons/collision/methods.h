#pragma once
// The three ways to find all pairs of boxes that overlap, walked.

#include "lessons/collision/boxes.h"

namespace isect::lessons::collision_lesson {

viz::Walk double_loop(const Boxes&);
viz::Walk sweep(const Boxes&);  ///< sweep and prune
viz::Walk hierarchy(const Boxes&);

}  // namespace isect::lessons::collision_lesson
