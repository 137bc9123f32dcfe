#pragma once
// What the items of a scene are called, so that a drawing can say what each of its shapes belongs to.

#include <vector>

#include "viz/drawing.h"

namespace isect::viz {

/// One object for each item, in order: named by the label that stands at it, else by a number.
std::vector<Object> objects_of(const Scene&);

/// Small drawings under headings are a page: nothing stands on a floor there, and nothing moves from one to another.
bool is_page(const Scene&);

}  // namespace isect::viz
