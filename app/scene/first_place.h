#pragma once
// The exact number at which a ray first meets an object: it orders hits that their doubles do not distinguish.

#include <optional>

#include <isect/numbers/place.h>

#include "app/scene/shapes.h"

namespace isect::program::scene {

/// Returns the least t at which a ray, a line or a segment meets an object: nothing if it misses it, or if a whole line
/// lies in an unbounded object. If it begins inside, that is the beginning of its range.
std::optional<Place> first_place(const Shaped& along, const Shaped&);

}  // namespace isect::program::scene
