#pragma once
// Where a scene is seen from, and a step of it that has a camera of its own.

#include "app/scene/source.h"
#include "viz/camera.h"

namespace isect::program::scene {

/// Reads the scene's "camera", in degrees: azimuth, elevation, perspective. Throws viz::BadInput.
viz::Camera read_camera(const Source&);

/// Reads the camera of a step at `path`: the same fields, target, half_height and field_of_view. What it leaves out is
/// the scene's. In the plane only target and half_height are allowed. Throws viz::BadInput.
viz::StepView read_step_camera(Source&, const Json& camera, const Path& path, const viz::Camera& of_scene);

}  // namespace isect::program::scene
