#pragma once
// What two boxes share, for the eye: computed in rounded numbers, beside the exact verdict.

#include <isect/conventions.h>
#include <isect/shapes.h>
#include "viz/scene.h"

namespace isect::lessons::obb_obb_lesson {

/// Adds the common body, or the point, segment or face where the boxes touch; `truth` is their relation.
void shared_part(viz::Scene&, const Obb<double, 3>& a, const Obb<double, 3>& b, Relation truth);

}  // namespace isect::lessons::obb_obb_lesson
