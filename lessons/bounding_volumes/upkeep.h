#pragma once
// What it costs to keep a volume around an object that moves, against what its tests cost: operations, counted.

#include "lessons/bounding_volumes/object.h"
#include "lessons/shared/script.h"

namespace isect::lessons::bounding_volumes_lesson {

struct Upkeep {
  std::string name;
  int turn, shift;                ///< to update the volume once the object has turned, or has been shifted
  int test;                       ///< of two such volumes that overlap
  int normals = 0, vertices = 0;  ///< what extremes are found along, and among
};
/// The centre and the axes turn; nothing is fitted again.
Upkeep upkeep(const Obb<double, 3>&, const Measured&);
/// After a turn the extremes of these vertices are found again along each normal; after a shift each slab moves.
Upkeep upkeep(const Kdop<double, 3>&, const std::vector<viz::Vec3>& vertices, const Measured&);

/// After how many tests to each update `late` has cost less than `early`, whose tests cost more; 1 at least.
int tests_to_pay(int early_update, int early_test, int late_update, int late_test);

/// Adds the step that weighs updates against tests.
void tell_upkeep(Script&, const Upkeep& obb, const Upkeep& kdop);

}  // namespace isect::lessons::bounding_volumes_lesson
