#pragma once
// Where a ray first meets an object, as the number itself: what orders hits that their doubles do not tell apart.

#include "app/scene/objects.h"
#include "app/scene/place.h"

namespace isect::program::scene {

/// The least t at which a ray, a line or a segment meets an object, which it does, other than a point, another line or
/// a cloud. Where it begins within, that is where its range begins.
Place first_place(const Setting&, const Object& along, const Object&);

}  // namespace isect::program::scene
