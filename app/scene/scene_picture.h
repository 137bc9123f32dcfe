#pragma once
// The picture of a scene: its objects in the colours of their roles, their names off each other, its notes.

#include <cstddef>
#include <vector>

#include "app/scene/answered.h"
#include "app/scene/object_pictures.h"
#include "viz/camera.h"
#include "viz/scene.h"

namespace isect::program::scene {

/// Returns the roles for the picture of all objects: the usual ones or, where these would all be equal, as for bodies,
/// two roles, such that objects that are asked about with each other differ.
std::vector<viz::Role> roles_of_all(const File&);

/// Draws the objects asked about, `lit`, in colour and the others as lines in grey, unless there are too many. Without
/// any, all are drawn in `roles`, those of roles_of_all. Hidden ones are left out, and
/// so are those that are not for this step, counted from 1, unless it asks about them. Names keep off each other as
/// `camera` sees them.
viz::Scene scene_picture(const Context&, ObjectPictures&, const std::vector<viz::Role>& roles,
                         const std::vector<std::size_t>& lit, int step, const viz::Camera& camera);

}  // namespace isect::program::scene
