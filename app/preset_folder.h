#pragma once
// A folder of a user's own presets: which of its files are presets, which should be, and which are neither.

#include <string>
#include <vector>

#include "app/shell/options.h"

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

/// Returns the presets and scenes (*.json) of the folder and of those below it, except for hidden ones, `snapshots`,
/// and what isect itself leaves there. Throws viz::FileError if the folder can't be read, viz::BadInput if no file in
/// it is meant as a preset.
PresetFolder preset_folder(const std::string& folder, const Program&);
/// Throws viz::BadInput if the file's name can't go into traces and metadata, which are UTF-8.
void require_utf8(const PresetFile&);
/// Prints one line on stderr for each foreign file, but not hundreds.
void say_passed_over(const PresetFolder&);

}  // namespace isect::program
