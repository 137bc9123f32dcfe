#pragma once
// Where the save sheet puts a file: its name, and its folder.

#include <string>

#include "viz/window/window_session.h"

namespace isect::viz {

/// The name of the file of a scene that has none yet.
constexpr const char* usual_scene_name = "scene";

/// Returns the whole path of a file or a folder, without `.` and `..`.
std::string whole_path(const std::string&);
/// Returns the typed name without spaces around it and without the ending of a figure or a preset; empty: the usual
/// one.
std::string given_name(const SaveSheet&, const Settings&);
/// Returns why that is no name for a file; empty if it is one.
std::string wrong_name(const SaveSheet&, const Settings&);
/// Returns the whole path of the folder: the typed one, where ~ is the reader's own; else the one chosen last; else
/// `usual`.
std::string whole_folder(const SaveSheet&, const Settings&, const std::string& usual);

/// Draws the fields for the name and the folder below each other, and under them what will be written, or why the last
/// file was not, with other folders to choose from. `usual`: the folder; `stem`: the file's usual name.
void place_fields(Ui&, SaveSheet&, const Settings&, const std::string& usual, const std::string& stem,
                  const std::string& ending, const Rect&);

}  // namespace isect::viz
