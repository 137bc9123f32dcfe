#pragma once

#include "viz/gl/renderer.h"
#include "viz/window/window_session.h"

namespace isect::viz {

/// Saves what was asked for since the last frame, to where the save sheet says: the figure, the setting as a preset,
/// the progress, or a scene that has no file. Tells the path. Where nothing can be written, the sheet opens again and
/// says why. Draws into the renderer's texture.
void save_what_is_wanted(WindowSession&, Renderer&);

}  // namespace isect::viz
