#pragma once
// A theme as readers see it: what its numbers are, and a figure of every role for each kind of eyes.

#include <string>

#include "viz/drawing.h"
#include "viz/theme.h"

namespace isect::program {

/// Returns the colours with their contrasts, and who sees which two roles nearest to each other: lines of text.
std::string theme_table(const viz::OwnTheme&);

/// Returns a swatch of each role, on background and panel, in a column for usual eyes, three kinds of colour-blind ones
/// and a grey print, with its contrasts; `width` in points, at least 400, and as high as it must be.
viz::Drawing theme_swatch(const viz::OwnTheme&, double width);

}  // namespace isect::program
