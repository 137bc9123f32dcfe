#pragma once
// Reads the readers' own scenes, for a session.

#include "web/browser_session.h"

namespace isect::web {

/// Throws viz::BadInput, which names the line, and viz::FileError where the text refers to other files.
Scene read_scene(const std::string& text);

/// See TakeFile: a mesh comes with a ray that asks about it, a polygon with a point, points with volumes around them.
std::string take_file(const std::string& name, const std::string& bytes);

}  // namespace isect::web
