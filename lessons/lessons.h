#pragma once
// The list of lessons, in the order of the course; lessons/sources.cmake writes it from the folders.

#include <vector>

namespace isect::viz {
struct Lesson;
}

namespace isect::lessons {

const std::vector<const viz::Lesson*>& all_lessons();

}  // namespace isect::lessons
