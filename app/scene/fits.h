#pragma once
// Constructions from a scene's objects: volumes around them, parts of them, hierarchies over them.

#include <string>
#include <vector>

#include "app/scene/objects.h"

namespace isect::program::scene {

/// Returns "sphere", "box", "obb", "kdop", "hull".
const std::vector<std::string>& volumes();
/// Whether an object is made of points, around which a volume can be fitted.
bool can_fit(Type);
/// Whether an object is bounded, so that a box can hold it.
bool has_box(Type);

}  // namespace isect::program::scene
