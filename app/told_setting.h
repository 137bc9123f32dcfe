#pragma once
// What a lesson's text begins with: all that a reader needs to compute along.

#include <string>

#include "app/told.h"

namespace isect::program {

/// A parameter's value with all its digits.
std::string in_full(const viz::Setting&, bool flat);

/// The parameters, where the objects lie, and the pseudocode with its errata.
std::string told_setting(const Excerpt&, const Telling&);

}  // namespace isect::program
