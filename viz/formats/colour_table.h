#pragma once
// A picture reduced to few colours: for formats with a colour table, and to weigh less.

#include <array>
#include <optional>
#include <vector>

#include "viz/text/text.h"

namespace isect::viz {

struct ColourTable {
  std::vector<std::array<std::uint8_t, 3>> colours;
  std::vector<std::uint8_t> places;  ///< the index of each pixel in the table
};
/// Returns the picture's own colours; nothing if there are more than 256. Opacity is ignored.
std::optional<ColourTable> own_colours(const Picture&);
/// Returns the picture's own colours if there are at most `most` (1 to 256). Otherwise it halves the group with the
/// largest error where that is widest; each group is replaced by its mean or its majority colour. Opacity is ignored.
ColourTable colour_table(const Picture&, int most);

/// Returns the picture with fewer of its colours: each gives way to the one that most pixels have of those within
/// `slack` of it in every channel. So large areas keep theirs, and no channel of any pixel is off by more than the
/// slack.
Picture with_fewer_colours(const Picture&, int slack);

}  // namespace isect::viz
