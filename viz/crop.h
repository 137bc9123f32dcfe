#pragma once
// What a drawing covers, and the drawing without the empty part around it.

#include "viz/drawing.h"

namespace isect::viz {

/// The box of the ink within the drawing's frame; the frame itself where there is none.
TextBox ink_box(const Drawing&);
/// The part with ink, `margin` units around it as far as the frame reaches.
Drawing cropped(const Drawing&, double margin);

}  // namespace isect::viz
