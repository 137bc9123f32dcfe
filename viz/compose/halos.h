#pragma once
// Texts with too little contrast to what lies under them get a halo.

#include <vector>

#include "viz/colour/measures.h"
#include "viz/drawing.h"
#include "viz/theme.h"

namespace isect::viz {

/// Returns the least contrast of a text to the fills among the shapes before it, on this background.
double contrast_of(const std::vector<Shape>&, std::size_t text, const Colour& background);
/// Gives every text without a halo one in the background's colour where its contrast is less than least_contrast.
void add_halos(std::vector<Shape>&, const Theme&);

/// Whether a line drawn before a text runs through it, or would touch its halo.
bool stands_on_line(const std::vector<Shape>&, std::size_t text, const Theme&);
/// Gives every text without a halo one where a line before it runs through it: in the colour of the fills that lie
/// under its middle, or in the background's colour where the text would not stand out from that. If the line only
/// passes beside the text, there is no halo: it would cut into the line.
void add_halos_over_lines(std::vector<Shape>&, const Theme&);

}  // namespace isect::viz
