#pragma once
// A picture in few colours, for formats that have a table of them.

#include <array>
#include <vector>

#include "viz/text.h"

namespace isect::viz {

struct ColourTable {
  std::vector<std::array<std::uint8_t, 3>> colours;
  std::vector<std::uint8_t> places;  ///< of each pixel, in the table
};
/// The picture's own colours where there are at most `most` (1 to 256). Otherwise, by halving the group that errs most
/// where it is widest, its mean or what most of it is stand for each group. Opacity is not looked at.
ColourTable colour_table(const Picture&, int most);

}  // namespace isect::viz
