#pragma once
// The parts of a question as XHTML, each on one line. Of elements there are only those that every platform keeps: p,
// br, i, b, sub, sup, img.

#include <string>

#include "app/platforms/quiz_item.h"

namespace isect::program::platforms {

/// Returns the picture as a paragraph, from this address; empty if there is none.
std::string picture_html(const QuizItem&, const std::string& address);
/// Returns what is given, the pseudocode, and the prompt.
std::string task_html(const QuizItem&);
/// Returns the tiles of an order with their letters; empty if it asks for none.
std::string tiles_html(const QuizItem&);
/// Returns what to type, as markup: "Answer with a whole number."; for an order, its letters. Empty for a choice.
std::string what_to_answer(const QuizItem&);
/// Returns markup as paragraphs.
std::string paragraphs_html(const std::string& markup);

}  // namespace isect::program::platforms
