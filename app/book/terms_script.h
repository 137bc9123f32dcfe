#pragma once
// The glossary for the pages' scripts: terms tell what they mean where they stand in a text.

#include <string>
#include <vector>

#include "viz/course.h"
#include "viz/lesson.h"

namespace isect::program::book {

/// Returns a script that sets isect_terms: of each term its name, its meaning as HTML, and the title and the file of
/// the lesson that explains it, if that is among `lessons`. `alone`: the page has no others beside it, and no file is
/// named.
std::string terms_script(const viz::Course&, const std::vector<const viz::Lesson*>& lessons, bool alone);

}  // namespace isect::program::book
