#pragma once
// A picture reduced to few colours, for formats with a colour table.

#include <array>
#include <vector>

#include "viz/text/text.h"

namespace isect::viz {

struct ColourTable {
  std::vector<std::array<std::uint8_t, 3>> colours;
  std::vector<std::uint8_t> places;  ///< the index of each pixel in the table
};
/// Returns the picture's own colours if there are at most `most` (1 to 256). Otherwise it halves the group with the
/// largest error where that is widest; each group is replaced by its mean or its majority colour. Opacity is ignored.
ColourTable colour_table(const Picture&, int most);

}  // namespace isect::viz
