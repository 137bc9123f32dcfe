#pragma once
// The names of a scene's items, so that a drawing can say what each of its shapes belongs to.

#include <vector>

#include "viz/drawing.h"

namespace isect::viz {

/// Returns one object for each item, in order: named by the label that stands at it, else by a number.
std::vector<Object> objects_of(const Scene&);

/// Whether the scene is a page of small drawings under headings: without a floor, and nothing moves between pages.
bool is_page(const Scene&);

}  // namespace isect::viz
