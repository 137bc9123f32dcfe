#pragma once
// One walk a method: each turns the events of one run of the core's algorithm into steps.

#include "viz/lesson.h"

namespace isect::lessons::ray_sphere_lesson {

viz::Walk haines(const viz::Parameters&);
viz::Walk quadratic(const viz::Parameters&);
viz::Walk half_b(const viz::Parameters&);

}  // namespace isect::lessons::ray_sphere_lesson
