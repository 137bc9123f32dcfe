#pragma once
// Where two objects touch, for the picture.

#include <vector>

#include <isect/answer.h>

#include "app/scene/objects.h"

namespace isect::program::scene {

/// Returns the mark of a contact, if the answer says that the objects touch: what two boxes share, a point,
/// an edge or a face; for other balls, capsules, boxes, oriented boxes, segments and points a point of it, rounded.
/// None for other types.
std::vector<viz::Item> contact(const NamedValues&, const Object& a, const Object& b, const Answer&);

}  // namespace isect::program::scene
