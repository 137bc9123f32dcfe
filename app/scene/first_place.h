#pragma once
// Where a ray first meets an object, as the number itself: what orders hits that their doubles do not tell apart.

#include <optional>

#include <isect/numbers/place.h>

#include "app/scene/shapes.h"

namespace isect::program::scene {

/// The least t at which a ray, a line or a segment meets an object: nothing where it misses it, and where a whole line
/// lies in what has no end. Where it begins within, that is where its range begins.
std::optional<Place> first_place(const Shaped& along, const Shaped&);

}  // namespace isect::program::scene
