#pragma once
// Where two objects touch, for the picture.

#include <optional>
#include <vector>

#include <isect/answer.h>

#include "app/scene/objects.h"

namespace isect::program::scene {

/// Returns the mark of a contact, if the answer says that the objects touch: what two boxes share, a point,
/// an edge or a face; for other balls, capsules, boxes, oriented boxes, segments and points a point of it, rounded.
/// None for other types.
std::vector<viz::Item> contact(const NamedValues&, const Object& a, const Object& b, const Answer&);

/// Returns the point of a point, a ball, a segment, a capsule, a box or an oriented box that is nearest to `p`,
/// rounded: `p` itself if it lies within. None for other types.
std::optional<viz::Vec3> nearest_point(const NamedValues&, const Object&, const viz::Vec3& p);

}  // namespace isect::program::scene
