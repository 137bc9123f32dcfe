#pragma once
// A figure in words, for readers who can't see it: beside it, and inside it where its format has a place for text.

#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::viz {

/// Returns plain text in paragraphs separated by empty lines: what is drawn and from which numbers, what is said of it,
/// and the result. A chart is described as a chart. `step` from 0.
std::string alt_text(const Lesson&, const Parameters&, const Walk&, int step);
/// Returns one line that says what is drawn and nothing else: for a picture that stands beside the full text.
/// `outcome`: whether the result may be told.
std::string drawn_text(const Walk&, const Scene&, bool outcome);
/// Returns a step's values as shown, in order; in full where another one would read alike without being equal, and −0
/// with its sign where another one is 0.
std::vector<std::string> shown(const std::vector<Value>&);
/// Returns the values with their names, as markup: "*s* = 1.022, *l*^2 = 1.1604".
std::string listed(const std::vector<Value>&);
/// "Ray and sphere: Two roots"
std::string figure_title(const Lesson&, const Step&);
/// Returns a title as a sentence: with a full stop, unless it ends with punctuation already.
std::string as_sentence(const std::string& title);

}  // namespace isect::viz
