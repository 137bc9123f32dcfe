#pragma once
// Reads the readers' own scenes, for a session.

#include "web/browser_session.h"

namespace isect::web {

/// Throws viz::BadInput, which names the line, and viz::FileError where the text refers to other files.
Scene read_scene(const std::string& text);

}  // namespace isect::web
