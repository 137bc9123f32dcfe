#pragma once
// What a drawing covers, and the drawing without the empty part around it.

#include <vector>

#include "viz/drawing.h"

namespace isect::viz {

/// The box of the ink within the drawing's frame; the frame itself where there is none.
TextBox ink_box(const Drawing&);
/// The part with ink, `margin` units around it; but where it is cut by the frame, no more than the frame shows.
Drawing cropped(const Drawing&, double margin);
/// The part with ink of any of them: drawings of one size, which stay so.
std::vector<Drawing> cropped(std::vector<Drawing>, double margin);
/// The drawing in the middle of a frame of this size.
Drawing centred(Drawing, double width, double height);

}  // namespace isect::viz
