#pragma once
// The lessons that a test of every lesson is about.

#include <cstdlib>
#include <vector>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "viz/lesson.h"

namespace isect {

/// All lessons, or the one that ISECT_LESSON names.
inline std::vector<const viz::Lesson*> those_asked_for() {
  const char* const only = std::getenv("ISECT_LESSON");
  std::vector<const viz::Lesson*> lessons = lessons::all_lessons();
  if (only) std::erase_if(lessons, [&](const viz::Lesson* lesson) { return lesson->id != only; });
  REQUIRE_FALSE(lessons.empty());
  return lessons;
}

}  // namespace isect
