#pragma once
// What an exercise says besides its prompt and solution. All texts are markup.

#include <string>

#include "viz/lesson.h"

namespace isect::viz {

/// Returns what the solution is called: "Solution"; where a program has a wrong line, "Correction".
std::string solution_head(const Exercise&);
/// Returns what is said of a setting that was to be found: "The program says OVERLAP, the exact test DISJOINT."; empty
/// where an exercise shows no program.
std::string found_text(const Exercise&, const Parameters&);

}  // namespace isect::viz
