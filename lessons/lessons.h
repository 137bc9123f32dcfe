#pragma once
// The list of lessons, in the order of lessons/CMakeLists.txt, which writes it.

#include <vector>

#include "viz/lesson.h"

namespace isect::lessons {

const std::vector<const viz::Lesson*>& all_lessons();

}  // namespace isect::lessons
