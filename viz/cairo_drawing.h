#pragma once
// A drawing on a cairo context, for files of curves rather than pixels.

#include "viz/typeset.h"

namespace isect::viz {

/// Background and shapes, one unit of the drawing a unit of the context.
void draw(_cairo*, const Drawing&, TypesetLine::As letters);

}  // namespace isect::viz
