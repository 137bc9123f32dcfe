#pragma once
// The walk through the kinds of bounding volumes: what defines each, how it fits, what it costs.

#include "lessons/bounding_volumes/object.h"

namespace isect::lessons::bounding_volumes_lesson {

/// The walk through the volumes around the object of this name, with a k-DOP among them.
viz::Walk fit_and_cost(const std::string& name, const viz::Vec3& tip, int k);

}  // namespace isect::lessons::bounding_volumes_lesson
