// Whether the determinant is larger than the bound, taken times the factor, and what is said then.

#include <fmt/format.h>

#include <cmath>

#include "lessons/rounding_bound/picture.h"
#include "lessons/rounding_bound/telling.h"

namespace isect::lessons::rounding_bound_lesson {

using namespace viz;

namespace {

std::string decision_caption(bool known, bool through, bool certain) {
  if (!known) return "No comparison holds with infinities or what is not a number. The sign stays open.";
  if (!through)
    return "The interval *det* ± factor · *bound* holds 0. As far as this bound tells, the truth may have either sign, "
           "or be 0.";
  return certain ? "Even with the whole bound the interval leaves 0 out: no error can have turned the sign."
                 : "With the whole bound this sign would stay open. The weaker filter lets it through.";
}

/// Tells that the sign of the determinant is taken, and whether that is right.
void take(Script& script, const Setup& s, const Run& run) {
  const int said = sign_of_double(run.det.value);
  const bool right = said == run.truth, certain = run.stages.size() == 1;
  const std::string how = certain ? "certain in doubles" : right ? "let through, and right" : "let through, and wrong";
  script.settle(right ? kind_of(run.truth) : Verdict::Kind::no, how + ": " + where_a_lies(run.truth));
  std::string caption =
      "It says that **a** lies " + place(said) + ". In truth " + where_a_lies(run.truth) + ", as the exact stages say.";
  if (right) caption = "It is right here: " + where_a_lies(run.truth) + ". But the weaker bound does not prove it.";
  if (certain)
    caption =
        "The sign is certain after a few operations in doubles: " + where_a_lies(run.truth) + ". No finer stage runs.";
  Step& step = script.add("taken", right ? "The sign of *det* is right" : "The sign of *det* is wrong", 5, caption);
  step.scene = points(s);
}

}  // namespace

void tell_decision(Script& script, const Setup& s, const Run& run) {
  const double size = std::abs(run.det.value), bound = s.factor * run.bound();
  const bool through = passes(run.det.value, run.bound(), s.factor), certain = passes(run.det.value, run.bound(), 1);
  const bool known = std::isfinite(size) && std::isfinite(bound);
  Step& step = script.add("decision", "Does the sign get through?", 4, decision_caption(known, through, certain));
  step.scene = decision(s, run);
  step.decides = true;
  if (known)
    step.comparison = Comparison{"|*det*| ≥ factor · *bound*", size, bound, through,
                                 through ? "the sign gets through" : "the sign stays open"};
  if (known && !(through && size == 0))  // else two answers are right
    step.question =
        Question{fmt::format("|*det*| is {}, and the bound, times the factor {}, is {}. What follows?", shown(size),
                             shown(s.factor), shown(bound)),
                 {"the sign of *det* is taken", "the sign is taken for 0", "nothing yet: a finer stage runs"},
                 through ? 0 : 2,
                 through ? "|*det*| is not below what the filter asks for."
                         : "The filter asks for a larger |*det*|. A small one is no proof of 0."};
  if (through)
    take(script, s, run);
  else
    script.refuse(4, {5});
}

}  // namespace isect::lessons::rounding_bound_lesson
