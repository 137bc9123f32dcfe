#pragma once
// The extent of a drawing, and the drawing without the empty part around it.

#include <vector>

#include "viz/drawing.h"

namespace isect::viz {

/// Returns the box of the ink within the drawing's frame; the frame itself if there is no ink.
TextBox ink_box(const Drawing&);
/// Returns the part with ink and `margin` units around it; where the frame cuts the ink, only what it shows.
Drawing cropped(const Drawing&, double margin);
/// Crops all to the box in which any of them has ink: drawings of one size, which remain equal.
std::vector<Drawing> cropped(std::vector<Drawing>, double margin);
/// Puts the drawing in the middle of a frame of this size.
Drawing centred(Drawing, double width, double height);

}  // namespace isect::viz
