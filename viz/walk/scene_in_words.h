#pragma once
// Where the objects of a scene lie, in numbers, for readers without a picture.

#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::viz {

/// Tells what is drawn of the objects themselves, without what the parameters tell: "box: (-2, -1.25) to (2, 1.25)". If
/// there are many, they are only counted.
std::vector<std::string> scene_in_words(const Scene&, const Parameters&, bool flat);

}  // namespace isect::viz
