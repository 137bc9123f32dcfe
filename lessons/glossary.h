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

/// The terms in alphabetical order.
const std::vector<Term>& glossary();

/// The meaning of a letter in all lessons: bold for points and vectors, italic for numbers.
struct Letter {
  std::string name;                     ///< plain text
  std::string meaning;                  ///< markup
  std::string lesson;                   ///< id: where it is introduced
  std::vector<std::string> given = {};  ///< how algorithms may compute it, plain text; empty: in any way
};

/// The letters in alphabetical order, Greek ones last. Indices (i, j) and names of objects (a, b) are not listed.
const std::vector<Letter>& letters();

}  // namespace isect::lessons
