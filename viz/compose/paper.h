#pragma once
// Figures for a page: composed for their width, whatever it is, with texts of one size.

#include <functional>
#include <optional>

#include "viz/compose/compose.h"

namespace isect::viz {

struct OnPaper {
  Figure figure;
  PaperSize size;
};

/// Returns the step on paper of this size. Where its labels would meet or leave the figure, the paper grows, in its
/// shape, until they don't: none if eight times the width is not enough. Where headings cut through shapes or run
/// together, it grows further if they stand clear on paper up to 1.6 times as wide, and no wider than 36 text sizes.
/// `camera`: for a picture of this aspect.
std::optional<OnPaper> readable_figure(const Walk&, int step, const ThemeChoice&, const PaperSize&, bool title,
                                       const std::function<Camera(double aspect)>& camera);

/// Whether a theme is one for paper: its texts have one size and never shrink; where they have no room, the figure
/// grows.
bool has_one_size(const Theme&);
/// Whether no bold heading, but a number, stands on a line, and none so near beside another that the two read as one.
bool headings_stand_clear(const Figure&, const Theme&);

}  // namespace isect::viz
