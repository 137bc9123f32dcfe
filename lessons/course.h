#pragma once
// The parts of the course, in the order of the lessons, and its terms.

#include "viz/course.h"

namespace isect::lessons {

const viz::Course& course();

}  // namespace isect::lessons
