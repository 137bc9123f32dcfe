#pragma once
// The parts of the course, in the order of the lessons, its terms, and what lessons have in common.

#include <vector>

#include "viz/course.h"
#include "viz/lesson.h"

namespace isect::lessons {

const viz::Course& course();

/// Each of the lesson's ideas, with the other lessons that name it, in the order of the course.
std::vector<viz::SharedIdea> shared_ideas(const viz::Lesson&);

}  // namespace isect::lessons
