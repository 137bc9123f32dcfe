// The finer stages, one after the other, as the core ran them.

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "lessons/rounding_bound/picture.h"
#include "lessons/rounding_bound/telling.h"

namespace isect::lessons::rounding_bound_lesson {

using namespace viz;

namespace {

using Kind = Stage::Kind;

std::string title(Kind kind) {
  switch (kind) {
    case Kind::grid:
      return "Can it only be 0?";
    case Kind::compensated:
      return "A second double keeps what was lost";
    case Kind::triple_double:
      return "A third double";
    case Kind::medium_exact:
      return "255 bits, without rounding";
    case Kind::short_exact:
      return "127 bits, without rounding";
    default:
      return "As many bits as it takes";
  }
}

/// What the stage does.
std::string method(Kind kind) {
  switch (kind) {
    case Kind::compensated:
      return "Each operation keeps what rounding took from it, as a second double: about 100 bits.\n"
             "What is lost now is of second order: the bound is 50 *u*^2 · *size*.";
    case Kind::triple_double:
      return "What the second doubles lose is kept, too: about 150 bits. The bound is 1000 *u*^3 · *size*.";
    case Kind::medium_exact:
      return "A whole number of 255 bits times a power of two: nothing is rounded, so no bound is needed.";
    case Kind::short_exact:
      return "The size is out of the range of two doubles. A whole number of 127 bits times a power of two rounds "
             "nothing.";
    default:
      return "Digits of 64 bits, as many as it takes: nothing is rounded, and every sign is known.";
  }
}

std::string grid_caption(const Stage& s) {
  const std::string multiple =
      "Every double is a whole multiple of its last bit. So the truth is a whole multiple of some power of two: the "
      "step.\n";
  if (!(s.step > 0)) return multiple + "Here that step underflows, so a zero cannot be told.";
  return multiple + (s.sign ? "The truth is smaller than one step, so it is 0: **a** lies on the line."
                            : "The truth may be as large as a step, so it need not be 0.");
}

/// What came of it.
std::string outcome_of(const Stage& s, int truth) {
  if (!s.sign) return s.bound > 0 ? "The interval holds 0: the sign stays open." : "More bits would be needed here.";
  if (truth == 0 && s.bound > 0) return "Value and bound together are below one step, so the truth is 0.";
  return s.bound > 0 ? "The interval leaves 0 out: the sign is certain." : "So the sign is certain.";
}

std::string formula(const Stage& s) {
  if (s.kind == Kind::grid)
    return s.step > 0 && s.step < 1 ? "|truth| ≤ " + shown(s.bound) + ", the step is " + shown(s.step) : "";
  if (!std::isfinite(s.value)) return {};
  if (s.value == 0 && s.sign && *s.sign != 0) return "value: smaller than the least double";
  return "value " + shown(s.value) + (s.bound > 0 ? ", bound " + shown(s.bound) : "");
}

}  // namespace

void tell_stages(Script& script, const Run& run) {
  std::set<std::string> slugs;
  for (std::size_t i = 1; i < run.stages.size(); ++i) {
    const Stage& s = run.stages[i];
    const StageWords& words = words_of(s.kind);
    if (s.sign)
      script.settle(kind_of(run.truth), std::string("decided by ") + words.name + ": " + where_a_lies(run.truth));
    const std::string cost =
        fmt::format("\nA stage like this took {} times as long as plain doubles, on orient3d.", shown(words.cost));
    const bool again = !slugs.insert(words.slug).second;
    Step& step = script.add(
        words.slug + std::string(again ? "-again" : ""), title(s.kind), 7,
        (s.kind == Kind::grid ? grid_caption(s) : method(s.kind) + "\n" + outcome_of(s, run.truth)) + cost, formula(s));
    step.scene = ladder(run, i + 1);
    step.decides = s.sign.has_value();
  }
}

}  // namespace isect::lessons::rounding_bound_lesson
