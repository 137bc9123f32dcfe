#pragma once
// Trivial reject, trivial accept, potential overlap (N03): a cheap test of the volume first.

#include "lessons/bounding_volumes/object.h"

namespace isect::lessons::bounding_volumes_lesson {

/// The object against a box around `middle`, of half-length `reach`.
viz::Walk cheap_first(const TriangleMesh<double>&, const viz::Vec3& tip, const viz::Vec3& middle, double reach);

/// What becomes of the test as b is moved across and up.
const viz::CaseMap& cases();

}  // namespace isect::lessons::bounding_volumes_lesson
