#pragma once
// What lessons say, in other languages. Lessons write English. When a walk has been made, each of its texts is looked
// up in lessons/<subject>/<language>.po: the whole, or line by line; with its numbers as they are, or with "{1}", "{2}"
// in their place. So no lesson needs another line of code.

#include <functional>
#include <string>
#include <vector>

#include "viz/lang/catalogue.h"
#include "viz/lesson.h"

namespace isect::viz {

/// Returns the lesson in a language, kept as long as the program runs; itself if nobody has translated it.
const Lesson& lesson_in(const Lesson&, const std::string& language);

/// Returns the walk that `steps` makes of a lesson, in the language that is spoken; in English if nobody has translated
/// the lesson, so that a walk never mixes both.
Walk spoken_walk(const std::string& lesson, const std::function<Walk()>& steps);

/// Returns a text of a lesson that stands in none of its walks, in the lesson's language.
std::string spoken_text(const Lesson&, const std::string& text);

/// Returns the texts of a lesson that a language lacks: its own, and those of its walks with these settings. Texts
/// without words, such as formulas, need none; pseudocode stays as it is.
std::vector<std::string> untranslated(const Lesson&, const std::string& language,
                                      const std::vector<Parameters>& settings);
/// Returns how many a language has, of its own and of all presets.
Coverage coverage(const Lesson&, const std::string& language);
/// Returns the keys of these texts, as a file of translations has them.
std::vector<std::string> text_keys(const Lesson&);

}  // namespace isect::viz
