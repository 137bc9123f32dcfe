#pragma once
// Whether the condition at a line of pseudocode was true.

#include <optional>
#include <string>

#include "viz/lesson.h"

namespace isect::viz {

/// Whether the line has a condition: "if ...", "while ...", "DISJOINT if ...".
bool has_condition(const std::string& line);
/// Whether the condition at the step's line is true there: by its comparison, or else by the steps that follow. None
/// where the step has no line, its line has no condition, or the step does not decide it.
std::optional<bool> taken(const Walk&, int step);

}  // namespace isect::viz
