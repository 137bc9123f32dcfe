#pragma once
// The terms of the course, each in one sentence, with the lesson that explains it.

#include <string>
#include <vector>

namespace isect::lessons {

struct Term {
  std::string name;     ///< plain text
  std::string meaning;  ///< markup
  std::string lesson;   ///< id
};

/// In alphabetical order.
const std::vector<Term>& glossary();

}  // namespace isect::lessons
