#pragma once
// Figures for a page: composed for their width, whatever it is, with texts of one size.

#include <functional>
#include <optional>

#include "viz/compose.h"

namespace isect::viz {

struct OnPaper {
  Figure figure;
  PaperSize size;
};

/// The step on paper of this size or, where its labels would meet, leave the figure, or as headings cut through shapes
/// or run together, of the next larger one of the same shape at which they don't. None where there is no such size up
/// to eight times as wide. `camera`: for a picture of this width to height.
std::optional<OnPaper> readable_figure(const Walk&, int step, ThemeName, const PaperSize&, bool title,
                                       const std::function<Camera(double aspect)>& camera);

/// Whether a theme is one for paper: its texts have one size and never shrink; where they have no room, the figure
/// grows.
bool has_one_size(const Theme&);
/// Whether no bold heading stands on a line, and none so near beside another that the two read as one.
bool headings_stand_clear(const Figure&, const Theme&);

}  // namespace isect::viz
