#pragma once
// One walk a method: each turns the events of one run of the core's algorithm into steps.

#include "viz/lesson.h"

namespace isect::lessons::ray_sphere_lesson {

viz::Walk haines(const viz::Parameters&);
viz::Walk quadratic(const viz::Parameters&);
viz::Walk half_b(const viz::Parameters&);

/// Where the ray begins along itself against how far its line passes the centre.
const viz::CaseMap& cases();
/// First hits to five digits, in units of the direction as given.
std::vector<viz::Opinion> opinions(const viz::Parameters&);

}  // namespace isect::lessons::ray_sphere_lesson
