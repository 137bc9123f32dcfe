#pragma once
// What the condition at a line of pseudocode came to.

#include <optional>
#include <string>

#include "viz/lesson.h"

namespace isect::viz {

/// Whether the line asks: "if ...", "while ...", "DISJOINT if ...".
bool has_condition(const std::string& line);
/// Whether the condition at the step's line is true there: as it is compared, or else as the next steps tell. None
/// where the step has no line, its line asks nothing, or the step does not decide it.
std::optional<bool> taken(const Walk&, int step);

}  // namespace isect::viz
