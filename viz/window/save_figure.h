#pragma once

#include "viz/renderer.h"
#include "viz/window/session.h"

namespace isect::viz {

/// Writes the current step, seen as it is now, to <folder>/<lesson>/<preset>/<NN>-<slug>.<format>, 960 x 600,
/// in the theme of the settings. Returns the path. Throws FileError.
std::string save_figure(const Player&, const Settings&, Renderer&, const std::string& folder);

/// Writes the setting as a preset file, <folder>/<lesson>/disagreement-<N>.json with the first N that is free, which
/// `--preset FILE` loads. Returns the path. Throws FileError.
std::string save_preset(const Player&, const std::string& folder);

}  // namespace isect::viz
