#pragma once
// Options that several subcommands share: which lesson, preset, parameters and steps; how large a figure.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/excerpt.h"
#include "app/program.h"
#include "app/shell/option_values.h"
#include "viz/lesson.h"

namespace isect::program {

/// A file with a preset. Its name is its path below the folder that was asked for, "week-3/tangent", or the file's own
/// name if it was asked for itself; figures and baselines are named after it.
struct PresetFile {
  std::string path, name;
};

/// A selection as written on the command line. A preset is a name or a file: a word that ends in .json or has a slash.
struct Selection {
  std::vector<std::string> lessons;  ///< or presets' files
  bool all = false;
  std::string preset;                ///< empty: the lesson's first (every one with `all`)
  std::vector<std::string> presets;  ///< several, in place of one; those of a word joined by commas
  bool presets_first = false;        ///< the presets stand before the first of the lessons
  std::string scene;                 ///< a scene's file with the objects for the lesson; empty: none
  std::vector<std::string> scenes;   ///< several, in place of one; those of a word joined by commas
  std::string step;                  ///< empty: the step of the preset's file, or all where it names none
  std::vector<std::string> changes;  ///< name=value
  std::string answers;               ///< of scenes: "hidden" or "shown"; empty: as in the file
  std::string lang;                  ///< the code of a language; empty: as in the file, else English
  std::vector<PresetFile> files;     ///< in place of names
  bool every_step = false;  ///< each preset must have the steps; else one of several that lacks them is left out
  bool to_verdict = false;  ///< where no step is named: those up to the verdict, without map and card
};

/// Adds the lesson's name as a positional argument, if the program has more than one lesson.
enum class Takes { one, many };
void add_lesson(CLI::App&, const Program&, Selection&, Takes, const std::string& help);
void add_preset(CLI::App&, Selection&, Takes, const std::string& help);
void add_step(CLI::App&, Selection&, Takes, const std::string& help);
void add_set(CLI::App&, Selection&);
/// Adds the option that hides the answers of scenes.
void add_answers(CLI::App&, Selection&);
/// Adds the option for the language.
void add_language(CLI::App&, Selection&);
/// Adds the option for a scene, if the program has more than one lesson: each lesson takes certain objects only.
void add_scene_file(CLI::App&, const Program&, Selection&, Takes = Takes::one);
/// Notes in which order lessons and presets stand on the command line, once it is parsed.
void note_order(const CLI::App&, Selection&);
/// Returns the parameters with these changes, name=value each. Throws viz::BadInput.
viz::Parameters changed(const viz::Lesson&, viz::Parameters, const std::vector<std::string>& changes);
/// Refuses an empty value, mostly a shell variable that is not set.
CLI::Validator not_empty();
/// Adds an option for a file or a folder.
CLI::Option* add_path(CLI::App&, const std::string& name, std::string& to, const std::string& help,
                      const std::string& type);

/// Returns everything that is asked for. Throws viz::BadInput, or viz::FileError if a preset's file can't be read.
std::vector<Excerpt> excerpts(const Program&, const Selection&);
/// Returns the only excerpt, where just one lesson and preset make sense.
Excerpt excerpt(const Program&, const Selection&);

}  // namespace isect::program
