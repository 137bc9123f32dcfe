#pragma once
// Several figures in one: side by side in rows, each with its letter and caption below.

#include <string>
#include <vector>

#include "viz/compose/compose.h"

namespace isect::viz {

struct Frame {
  Figure figure;
  std::string caption = {};  ///< markup, wrapped below its figure; may be empty
};

struct Strip {
  Drawing drawing;
  std::vector<PlacedLabel> labels;
};

/// Arranges the frames; the gap between columns and rows is `gap` wide. Figures of a row stand on one line, whatever
/// their heights. Letters begin with (a); a single frame has none. `columns` is at least 1.
Strip strip(const std::vector<Frame>&, int columns, const Theme&, double gap);

}  // namespace isect::viz
