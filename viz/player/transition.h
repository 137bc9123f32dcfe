#pragma once
// Transitions between two pictures: what has the same name in both moves, and what is new appears on the way.

#include "viz/scene.h"

namespace isect::viz {

/// Returns the scene `to` with each of its objects moved `share` of the way from its place in `from`: 0 there, 1 here.
/// Objects in only one of the two, or of different shapes in them, do not move; nor does a page of small drawings.
Scene between(const Scene& from, const Scene& to, double share);

/// Whether anything moves from one to the other in between(): charts and pages stand still.
bool may_move(const Scene& from, const Scene& to);

/// Returns the course of an animation: slow at both ends, from 0 to 1.
double eased(double share);

}  // namespace isect::viz
