#pragma once
// A drawing on a cairo context, for files of curves rather than pixels.

#include "viz/text/typeset.h"

namespace isect::viz {

/// Draws background and shapes; one unit of the drawing is one unit of the context.
void draw(_cairo*, const Drawing&, TypesetLine::As letters);

}  // namespace isect::viz
