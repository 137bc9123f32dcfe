#pragma once
// Words about a setting, the same for every way of telling a lesson.

#include <string>

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

}  // namespace isect::program
