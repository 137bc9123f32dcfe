#pragma once
// A figure in words, for whoever can't see it: the text beside it, and inside it where its format has a place for one.

#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::viz {

/// Plain text, paragraphs apart by empty lines: what is drawn and from which numbers, what is said of it, and what
/// comes out. A chart is told as the chart it is. `step` from 0.
std::string alt_text(const Lesson&, const Parameters&, const Walk&, int step);
/// What is drawn and nothing else, on one line: for a picture that stands beside all that is said of it. `outcome`:
/// whether what comes out may be told.
std::string drawn_text(const Walk&, const Scene&, bool outcome);
/// A step's values as shown, in their order; in full where another one would read alike and is not equal, and −0 with
/// its sign where another one is 0.
std::vector<std::string> shown(const std::vector<Value>&);
/// The same with their names, as markup: "*s* = 1.022, *l*^2 = 1.1604".
std::string listed(const std::vector<Value>&);
/// The numbers of a comparison in plain words, in full where they would read alike: "0.5 against 2"; of a condition
/// that joins several, each with its own: "s < 0: yes, −1 against 0; ...".
std::string sides(const Comparison&, const std::string& between);
/// "Ray and sphere: Two roots"
std::string figure_title(const Lesson&, const Step&);
/// A title as a sentence: with a full stop, unless it ends with a mark of its own.
std::string as_sentence(const std::string& title);

}  // namespace isect::viz
