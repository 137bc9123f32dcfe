#pragma once
// What a viewing ray meets: by rounded arithmetic, where its errors leave no doubt.

#include <vector>

#include <isect/shapes.h>
#include "viz/compose/visibility.h"

namespace isect::viz {

/// Whether the ray runs through the solid: by rounded arithmetic, where its errors leave no doubt; else exactly, by the
/// half-spaces that rounded arithmetic does not show to be implied by others. The half-spaces have unit normals.
bool runs_through(Ray<double, 3> sight, const Shell&);

/// Whether the ray passes the ball, or leaves it behind, by more than the possible rounding.
bool misses(const Ray<double, 3>& sight, const Vec3& center, double radius);

/// Whether the ray misses the screen by more than the possible rounding: most rays pass the ball around it, or leave
/// its plane behind, as those that begin on it do. False if rounded arithmetic cannot decide.
bool misses(const Ray<double, 3>& sight, const Polygon<double, 3>& screen);

/// Returns twice the area of an outline, along its normal (Newell).
Vec3 doubled_area(const std::vector<Vec3>& points);

}  // namespace isect::viz
