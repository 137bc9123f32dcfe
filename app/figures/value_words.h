#pragma once
// Words about a setting, the same for every way of telling a lesson.

#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::program {

/// Returns a parameter's value with all its digits.
std::string in_full(const viz::Setting&, bool flat);
/// Returns it for a sentence: all digits of a number that has few, or that lies right next to one of five digits; else
/// five, as viz::shown does.
std::string in_words(const viz::Setting&, bool flat);
/// Returns it for a sentence, with all digits.
std::string in_words_and_full(const viz::Setting&, bool flat);
/// Whether in_words leaves digits out.
bool rounded_in_words(const viz::Setting&);

/// Returns where the pseudocode of this walk differs from the published one, and why: plain text, one each. They name a
/// preset that shows it, by its id or its title.
std::vector<std::string> errata_text(const viz::Lesson&, const viz::Walk&, std::string viz::Preset::*name);

}  // namespace isect::program
