#pragma once

#include "viz/gl/renderer.h"
#include "viz/window/window_session.h"

namespace isect::viz {

/// Writes the current step, seen as it is now, to <folder>/<name>.<format>, or to the usual
/// <folder>/<usual_stem>.<format> where there is no name, in the theme and the size of the settings: 960 x 600, or the
/// given width in cm on paper, PNG at 300 dots an inch. Its alt text stands beside it, with the ending .txt. Where
/// another figure or text has that name, a number is added to it. Returns the whole path. Throws FileError; BadInput
/// where it is too narrow for its labels.
std::string save_figure(const Player&, const Settings&, Renderer&, const std::string& folder, const std::string& name);
/// Returns <lesson>/<preset>/<NN>-<slug> of the current step.
std::string usual_stem(const Player&);
/// Returns <stem>.<ending>, with a number before the ending if a file of that name has other bytes.
std::string free_path(const std::string& stem, const std::string& ending, const std::string& bytes);

/// Draws the same figure into the renderer's texture, as large as fits into this many pixels. Returns its size in them;
/// 0 if it can't be made, with the reason in `why`.
PixelBox draw_preview(const Player&, const Settings&, Renderer&, int most_width, int most_height, std::string& why);

/// Writes the setting with its step, and with the camera if the reader has moved that, as a preset file, which
/// `--preset FILE` loads: <folder>/<lesson>/<name>.json, as free_path() makes it; without a name disagreement-<N>.json
/// where methods differ, else setting-<N>.json, with the first N that is free. Returns the whole path. Throws
/// FileError.
std::string save_preset(const Player&, const std::string& folder, const std::string& name);
/// Returns whole paths of the preset files in the folder's lesson folders, then of those `others` that still exist.
std::vector<std::string> saved_presets(const std::string& folder, const std::vector<std::string>& others);

}  // namespace isect::viz
