#pragma once
// A small box flies at a thin wall: what discrete times miss, and what a ray does not.

#include "viz/lesson.h"

namespace isect::lessons::collision_lesson {

/// A box centred at `p` that moves to the right at this speed, for a second and a half.
viz::Walk tunnelling(const viz::Vec3& p, double speed);

}  // namespace isect::lessons::collision_lesson
