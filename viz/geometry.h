#pragma once
// Where the objects of a scene lie, in numbers, for whoever has no picture.

#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::viz {

/// What is drawn of the objects themselves, but for what the parameters tell: "box: (-2, -1.25) to (2, 1.25)". Many
/// are counted only.
std::vector<std::string> geometry(const Scene&, const Parameters&, bool flat);

}  // namespace isect::viz
