#include "lessons/rounding_bound/telling.h"

namespace isect::lessons::rounding_bound_lesson {

using namespace viz;

namespace {

const std::vector<std::string> pseudocode = {
    "round a_x − c_x, b_y − c_y, a_y − c_y and b_x − c_x",                  // 0
    "left ← (a_x − c_x) · (b_y − c_y), right ← (a_y − c_y) · (b_x − c_x)",  // 1
    "det ← left − right",                                                   // 2
    "bound ← 5 u · size, where size is |left| + |right|",                   // 3
    "if |det| ≥ factor · bound",                                            // 4
    "    the sign is that of det",                                          // 5
    "else",                                                                 // 6
    "    the sign is that of the first finer stage that is certain",        // 7
    "for each neighbour of a: find its sign in the same way"                // 8
};

}  // namespace

Walk tell(const Setup& s) {
  const Run run(s);
  Script script(
      {"Shewchuk, Adaptive precision floating-point arithmetic (1997); Higham, Accuracy and stability of "
       "numerical algorithms (2002)",
       "Three points, a, b and c, and the line through b and c: a lies " + place(run.truth) + ".", pseudocode,
       "orientation, filtered"});
  tell_derivation(script, s, run);
  tell_decision(script, s, run);
  if (!passes(run.det.value, run.bound(), s.factor)) tell_stages(script, run);
  tell_cells(script, s);
  return std::move(script.walk());
}

}  // namespace isect::lessons::rounding_bound_lesson
