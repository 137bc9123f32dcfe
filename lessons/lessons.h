#pragma once
// The list of lessons, in the order of the course; lessons/sources.cmake writes it from the folders.

#include <vector>

#include "viz/lesson.h"

namespace isect::lessons {

const std::vector<const viz::Lesson*>& all_lessons();

}  // namespace isect::lessons
