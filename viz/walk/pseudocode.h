#pragma once
// What a walk's pseudocode says of names: which ones a line is about, and how a name is computed.

#include <set>
#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::viz {

/// Returns the names that a line of pseudocode assigns or, where it assigns nothing, all it contains.
std::vector<std::string> subject_of_line(const std::string& line, const std::set<std::string>& known);

/// Returns what is known of a name at a step, in plain words: how the pseudocode computes it, and its number: "s = l ·
/// d = 4.472"; for a knob, its value and its meaning. Empty if nothing is known.
std::string sum_of(const Lesson&, const Parameters&, const Walk&, int step, const std::string& key);

}  // namespace isect::viz
