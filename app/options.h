#pragma once
// Options that several subcommands share: which lesson, preset, parameters and steps; how large a figure.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/excerpt.h"
#include "app/program.h"
#include "app/values.h"
#include "viz/lesson.h"

namespace isect::program {

/// A file with a preset. Its name is where it lies below the folder that was asked for, "week-3/tangent", or the file's
/// own where it was asked for itself; figures and baselines are named after it.
struct PresetFile {
  std::string path, name;
};

/// As written on the command line. A preset is a name or a file: a word that ends in .json or has a slash.
struct Selection {
  std::vector<std::string> lessons;  ///< or presets' files
  bool all = false;
  std::string preset;                ///< empty: the lesson's first (every one with `all`)
  std::vector<std::string> presets;  ///< several, in place of one; those of a word joined by commas
  std::string scene;                 ///< a scene's file, whose objects the lesson is to take; empty: none
  std::string step;                  ///< empty: the step of the preset's file, or all where it names none
  std::vector<std::string> changes;  ///< name=value
  std::vector<PresetFile> files;     ///< in place of names
};

/// The lesson's name as a positional, where the program has more than one lesson.
enum class Takes { one, many };
void add_lesson(CLI::App&, const Program&, Selection&, Takes, const std::string& help);
void add_preset(CLI::App&, Selection&, Takes, const std::string& help);
void add_step(CLI::App&, Selection&, Takes, const std::string& help);
void add_set(CLI::App&, Selection&);
/// Where the program has more than one lesson, as that of one takes some objects alone.
void add_scene_file(CLI::App&, const Program&, Selection&);
/// The parameters with these changes, name=value each. Throws viz::BadInput.
viz::Parameters changed(const viz::Lesson&, viz::Parameters, const std::vector<std::string>& changes);
/// Refuses an empty value, which is most often a shell's variable that is not set.
CLI::Validator not_empty();
/// A file or a folder.
CLI::Option* add_path(CLI::App&, const std::string& name, std::string& to, const std::string& help,
                      const std::string& type);

/// Everything that is asked for. Throws viz::BadInput, or viz::FileError where a preset's file can't be read.
std::vector<Excerpt> excerpts(const Program&, const Selection&);
/// The same where only one lesson and preset make sense.
Excerpt excerpt(const Program&, const Selection&);

}  // namespace isect::program
