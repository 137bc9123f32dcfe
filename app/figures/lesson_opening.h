#pragma once
// The beginning of a lesson's text: all that a reader needs to compute along.

#include <string>
#include <vector>

#include "app/figures/lesson_text.h"

namespace isect::program {

/// Returns lines of pseudocode, each with its number.
std::string numbered(const std::vector<std::string>& pseudocode, std::size_t columns);

/// Returns the parameters, where the objects lie, and the pseudocode with its errata.
std::string lesson_opening(const Excerpt&, const TextOptions&);

}  // namespace isect::program
