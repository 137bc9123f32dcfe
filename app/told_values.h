#pragma once
// Words about a setting that every way of telling a lesson shares.

#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::program {

/// A parameter's value with all its digits.
std::string in_full(const viz::Setting&, bool flat);
/// The same in a sentence: all digits of a number that has few, or that lies right next to one of five digits; else
/// five, as viz::shown has them.
std::string in_words(const viz::Setting&, bool flat);
/// The same with all digits.
std::string in_words_and_full(const viz::Setting&, bool flat);
/// Whether in_words leaves digits out.
bool rounded_in_words(const viz::Setting&);

/// Where the pseudocode of this walk differs from the published one, and why: plain text, one each. They name a preset
/// that shows it, by its id or its title.
std::vector<std::string> told_errata(const viz::Lesson&, const viz::Walk&, std::string viz::Preset::*name);

}  // namespace isect::program
