#pragma once
// What lessons say, in other languages. A text without numbers is looked up as a whole in
// lessons/<subject>/<language>.po when a walk has been made; one with numbers is a message (viz/lang/message.h) where
// the lesson writes it.

#include <functional>
#include <string>

#include "viz/lang/catalogue.h"
#include "viz/lesson.h"

namespace isect::viz {

/// Returns the lesson in a language, kept as long as the program runs; itself if nobody has translated it.
const Lesson& lesson_in(const Lesson&, const std::string& language);

/// Returns the walk that `steps` makes of a lesson, in the language that is spoken; in English if nobody has translated
/// the lesson, so that a walk never mixes both.
Walk spoken_walk(const std::string& lesson, const std::function<Walk()>& steps);

/// Returns how many of a lesson's texts a language has: of those of all presets, each text counted once. Texts without
/// words, such as formulas, don't count. Walks through all presets if the lesson has a file for the language.
Coverage coverage(const Lesson&, const std::string& language);

}  // namespace isect::viz
