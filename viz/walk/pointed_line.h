#pragma once
// What is said to a line of the pseudocode that a reader pointed at as the answer to a question. app/book/answers.js
// reads a typed line by the same rules: tests/typed_answers.json holds both to them.

#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::viz {

/// Returns the line, from 0, whose number was typed: "4", "line 4". Throws BadInput, which says what is wrong.
int line_from(const std::string& typed, int lines);
/// Returns what a reader is told to do.
std::string how_to_point();
/// Returns, for each line of the pseudocode, what is said to it as the answer to the question before `step`, which asks
/// for a line: the mistake behind it or, where that is not known, what the line does up to that step. The right one's
/// is empty.
std::vector<std::string> line_replies(const Walk&, int step);
/// Returns the choice that says this line; -1: none does. The question asks for a line.
int choice_of_line(const Question&, int line);

}  // namespace isect::viz
