#pragma once
// Small counts as running text spells them.

#include <array>
#include <string>

namespace isect::viz {

/// Returns "no", "one" ... "eight"; digits for larger counts. `count` is at least 0.
inline std::string in_words(int count) {
  constexpr std::array words = {"no", "one", "two", "three", "four", "five", "six", "seven", "eight"};
  return count < static_cast<int>(words.size()) ? words.at(static_cast<std::size_t>(count)) : std::to_string(count);
}

}  // namespace isect::viz
