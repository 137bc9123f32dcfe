#pragma once
// The names of mathematics in a walk's texts, so that a name can be lit wherever it occurs.

#include <set>
#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::viz {

/// A name, and where it stands in a text. Letters and subscript make the key, whatever their face: "t_max", "s".
struct Name {
  std::string key;
  std::size_t begin = 0, end = 0;  ///< bytes
  bool vector = false;             ///< set in bold
};

/// Returns the names in markup, which are italic or bold; places are in the text of its runs, one after the other.
std::vector<Name> names_in(const std::string& markup);
/// Return all that may be a name in plain text or in pseudocode, also a short word. `known`: only these.
std::vector<Name> names_in_line(const std::string& text);
std::vector<Name> names_in_line(const std::string& text, const std::set<std::string>& known);
/// Returns all words of pseudocode, also long ones; but none that hyphens join.
std::vector<Name> words_in_line(const std::string& text);
/// Returns the keys of some names, each once.
std::vector<std::string> keys(const std::vector<Name>&);

/// Return all names that the lesson's knobs use, that the walk's markup and pictures use, and both.
std::set<std::string> names_of(const Lesson&);
std::set<std::string> names_of(const Walk&);
std::set<std::string> names_of(const Lesson&, const Walk&);

/// Returns "0.25", "(1, 2)" in the plane, "(1, 2, 0)" in space, or the word.
std::string value_in_words(const Setting&, bool flat);

}  // namespace isect::viz
