#pragma once
// Texts without their numbers, so that one translation serves all settings.

#include <string>
#include <vector>

namespace isect::viz {

/// A text with "{1}", "{2}" ... in the place of its numbers.
struct Numbered {
  std::string key;
  std::vector<std::string> numbers;
};

/// Takes the numbers out of a text, as viz::shown writes them. Those in scripts, "^2", and in names, "3D", stay.
Numbered numbered(const std::string& text);
/// Puts the numbers into a text with such places. Throws std::logic_error if it names one that there is not.
std::string with_numbers(const std::string& text, const std::vector<std::string>& numbers);

}  // namespace isect::viz
