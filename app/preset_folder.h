#pragma once
// A folder of presets of one's own: which of its files are presets, which should be, and which are none.

#include <string>
#include <vector>

#include "app/options.h"

namespace isect::program {

/// A file meant as a preset that can't be read as one, and why: the message names the file and the field.
struct BrokenPreset {
  PresetFile file;
  std::string what;
};

struct PresetFolder {
  std::vector<PresetFile> presets;   ///< all in order of their names
  std::vector<BrokenPreset> broken;  ///< they name a lesson, so they are meant as presets
  std::vector<std::string> foreign;  ///< JSON that is something else
};

/// The presets and scenes (*.json) of the folder and of those below it, but for hidden ones, `snapshots`, and what
/// isect itself leaves there. Throws viz::FileError where the folder can't be read, viz::BadInput where no file in it
/// is meant as a preset.
PresetFolder preset_folder(const std::string& folder, const Program&);
/// Throws viz::BadInput where the file's name can't go into traces and metadata, which are UTF-8.
void require_utf8(const PresetFile&);
/// One line on stderr for each foreign file, but not for hundreds.
void say_passed_over(const PresetFolder&);

}  // namespace isect::program
