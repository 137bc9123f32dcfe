#pragma once
// What a viewer sees of a ball and of a capsule: where viewing rays touch them.

#include <vector>

#include <isect/shapes.h>
#include "viz/camera.h"
#include "viz/scene.h"

namespace isect::viz {

/// A ball's outline: the circle on its surface where viewing rays touch it, as an exact ellipse on the picture.
struct Outline {
  Vec2 center, major, minor;
};
Outline outline(const Ball&, const View&);
/// Returns a capsule's outline: a closed chain of points on its surface whose picture is the outline, except for what a
/// chord of a circle of 96 corners cuts off.
std::vector<Vec3> outline(const Capsule<double, 3>&, const View&);
/// A ball's outline as a circle on its surface: two perpendicular radii around its middle.
struct Rim {
  Vec3 middle, u, v;
};
Rim rim(const Ball&, const View&);

}  // namespace isect::viz
