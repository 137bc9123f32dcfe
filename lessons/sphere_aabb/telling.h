#pragma once
// The walk of a ball to a box: the squared distance axis by axis, then the radius.

#include "lessons/sphere_aabb/picture.h"

namespace isect::lessons::sphere_aabb_lesson {

std::string in_words(Relation);
viz::Walk tell(const Setup&);

}  // namespace isect::lessons::sphere_aabb_lesson
