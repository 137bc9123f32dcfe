#pragma once
// What two walks share: three signs, and whether two of them are opposite.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "lessons/ray_triangle/telling.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::ray_triangle_lesson {

inline std::string sign_mark(double x) { return x > 0 ? "+" : x < 0 ? "−" : "0"; }

/// Whether none of three signs is the opposite of another.
inline bool alike(double a, double b, double c) { return !(std::max({a, b, c}) > 0 && std::min({a, b, c}) < 0); }

/// Says the three signs, for whichever numbers have them.
class SignsTeller : protected Teller {
 protected:
  SignsTeller(const Setup& s, const std::string& title, const std::string& source, std::vector<std::string> pseudocode)
      : Teller(s, title, source, std::move(pseudocode)) {}

  /// Asks on `line` whether two signs are opposite.
  void signs(int line, double a, double b, double c, bool holds) {
    const bool none = a == 0 && b == 0 && c == 0, some = a == 0 || b == 0 || c == 0;
    const auto& [x, y, z] = s_.side;
    const bool exactly = holds == alike(x, y, z),
               unchanged = (a == 0) == (x == 0) && (b == 0) == (y == 0) && (c == 0) == (z == 0);
    std::string told =
        !holds       ? "Two signs are opposite, so the line does not pass all edges on the same side: it misses."
        : !unchanged ? "No two signs are opposite, as rounded. Rounding has changed at least one of them."
        : none       ? "All three are 0: the line lies in the plane, or the triangle has no area."
        : some       ? "No two are opposite. A 0 goes with both signs: the line passes through the edge of that number."
                     : "All signs are equal: the line passes all three edges on the same side, and so inside.";
    viz::Step& step = add("signs", "The three signs", line, told + unless(exactly, verdict_text(s_)));
    step.decides = true;
    if (!none)
      step.question = viz::Question{fmt::format("The signs of *w*_a, *w*_b and *w*_c are {}, {} and {}. What follows?",
                                                sign_mark(a), sign_mark(b), sign_mark(c)),
                                    {"a hit, if *t* lies in the range", "a miss", "nothing yet, as the sum decides"},
                                    holds ? 0 : 1,
                                    holds ? "No two signs are opposite, and triangles include their edges."
                                          : "Weights of an inside point have one sign, whichever it is."};
    if (holds) script_.refuse(line, {line + 1});
  }
};

}  // namespace isect::lessons::ray_triangle_lesson
