#pragma once
// The settings that files hold: files of presets, of scenes, and figures.

#include <string>
#include <vector>

#include "app/excerpt.h"
#include "app/program.h"
#include "app/shell/options.h"

namespace isect::program {

/// Returns the files in order, each once, by their own names; if two have the same name, by where they lie.
std::vector<PresetFile> named_files(const std::vector<std::string>& paths);

/// Returns the setting of a preset's or a scene's file, not walked yet; its folder is the file's name. Of a figure: the
/// setting that it shows, in its own folder, or all settings of a strip of several. Throws viz::BadInput and
/// viz::FileError, which name the file.
std::vector<Excerpt> settings_in(const Program&, const PresetFile&);

/// Returns the lesson's walks through the objects of a scene's file. `method`: as method_for returns it.
Excerpt setting_of_scene(const viz::Lesson&, const std::string& method, const PresetFile&);
/// Returns the method for many objects that a preset beside a scene names, if the lesson has several. Throws
/// viz::BadInput if it names none.
std::string method_for(const viz::Lesson&, const std::vector<std::string>& presets);

}  // namespace isect::program
