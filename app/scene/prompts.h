#pragma once
// A scene's questions in words, for an exercise sheet: nothing in them depends on the answer.

#include <cstddef>
#include <string>
#include <vector>

#include "app/scene/answered.h"

namespace isect::program::scene {

struct Prompt {
  std::string slug, title, text;  ///< title and text: markup
  std::vector<std::size_t> lit;   ///< the objects that it names; if two, the first and the second. Empty: all
};

/// Returns the usual words of a question, without asking the core.
Prompt prompt(const Context&, const Asked&);
/// Returns the question which of `others` an object meets.
Prompt prompt_of_others(const Context&, std::size_t object, std::size_t others);

}  // namespace isect::program::scene
