#pragma once
// Whether the condition at a line of pseudocode was true.

#include <optional>
#include <string>

#include "viz/lesson.h"

namespace isect::viz {

/// Whether the line has a condition: "if ...", "while ...", "DISJOINT if ...".
bool has_condition(const std::string& line);
/// Whether the condition at the step's line is true there: by its comparison, or else by the steps that follow. None
/// where the step has no line, its line has no condition, or the step does not decide it. The map of cases and the card
/// that end a walk stand at its last line: what it decided is told there, too.
std::optional<bool> taken(const Walk&, int step);
/// Returns that as it is told at the lit line, wherever code is shown: "yes", "no"; empty where nothing is decided.
std::string said_at_line(const std::optional<bool>& taken);

}  // namespace isect::viz
