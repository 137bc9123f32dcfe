#pragma once
// Where two texts differ first.

#include <optional>
#include <string>

namespace isect::program {

struct TextDifference {
  int line = 0;                        ///< from 1; 0: the texts are equal
  std::optional<std::string> was, is;  ///< the line in both, as much as shows the difference; none: the text has ended
};
/// Compares byte by byte. Letters of UTF-8 stay whole in the excerpts, which have dots where more was left out.
TextDifference first_difference(const std::string& was, const std::string& is);
/// Returns "line 12 was “...”, is “...”"; empty if the texts are equal.
std::string in_words(const TextDifference&);

}  // namespace isect::program
