#pragma once
// What a lesson's text begins with: all that a reader needs to compute along.

#include <string>
#include <vector>

#include "app/told.h"

namespace isect::program {

/// A parameter's value with all its digits.
std::string in_full(const viz::Setting&, bool flat);

/// Where the pseudocode of this walk differs from the published one, and why: plain text, one each.
std::vector<std::string> told_errata(const Excerpt&);

/// The parameters, where the objects lie, and the pseudocode with its errata.
std::string told_setting(const Excerpt&, const Telling&);

}  // namespace isect::program
