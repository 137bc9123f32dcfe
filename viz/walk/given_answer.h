#pragma once
// An answer that a reader gave to a question, of whatever kind: how it is read, told and judged. The kinds have headers
// of their own: typed_answer.h, pointed_line.h, given_order.h.

#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::viz {

/// An answer: a choice, or what was given instead of one.
struct GivenAnswer {
  int choice = -1;              ///< the choice that says what was given; -1: none does
  std::string typed = {};       ///< as typed; empty: it was pressed or pointed at
  double number = 0;            ///< that was typed
  int line = -1;                ///< that was pointed at, or typed; -1: none was
  std::vector<int> order = {};  ///< of the tiles; empty: none was given
};

/// Whether a question asks for more than a choice.
bool wants_more(const Question&);
/// Returns what a reader is told to do; empty where a choice is all that is asked for.
std::string how_to_answer(const Question&);
/// Returns what was typed as the answer to the question before `step`, which asks for more than a choice. Throws
/// BadInput, which says what is wrong.
GivenAnswer answer_from(const Walk&, int step, const std::string& typed);
/// Returns this line, from 0, as the answer.
GivenAnswer pointed_at(const Question&, int line);
/// Returns "You typed 3/4 = 0.75.", as markup; empty where a choice was pressed.
std::string told_of(const Question&, const GivenAnswer&);
/// Returns what is said to a wrong answer, as markup; empty: it is right, or the mistake behind it is not known.
std::string reply_to(const Walk&, int step, const GivenAnswer&);

}  // namespace isect::viz
