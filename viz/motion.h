#pragma once
// From one picture to the next: what has the same name in both moves, and what is new appears on its way.

#include "viz/scene.h"

namespace isect::viz {

/// The scene `to`, but each of its objects as far from where it stands in `from` as `share` says: 0 there, 1 here.
/// What is only in one of the two, or of another shape in them, does not move; nor does a page of small drawings.
Scene between(const Scene& from, const Scene& to, double share);

/// Whether anything moves from one to the other, as between() has it: charts and pages stand still.
bool may_move(const Scene& from, const Scene& to);

/// How an animation runs: slow at both ends, from 0 to 1.
double eased(double share);

}  // namespace isect::viz
