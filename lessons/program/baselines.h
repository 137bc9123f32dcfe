#pragma once
// Baselines on disk: DIR/<lesson>/<preset>/<NN>-<slug>.png and trace.json. Compares them with what the lesson
// does now and, where asked, accepts what it does now.

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "lessons/program/options.h"
#include "viz/files.h"
#include "viz/offscreen.h"
#include "viz/snapshot.h"

namespace isect::program {

/// One thing `check` complains of.
struct Failure {
  enum class Kind { missing, trace, picture, size, blank, unreadable, orphan };
  Kind kind;
  std::string lesson, preset;
  int step = -1;                  ///< from 0; -1: not of one step
  std::string slug;               ///< of that step
  std::string what;               ///< in words, the first difference first
  std::string baseline;           ///< the file it is about
  std::string fresh, difference;  ///< pictures written beside it, if any
  viz::Difference pixels = {};
  std::vector<std::string> more = {};  ///< further differences, in words
  bool accepted = false;               ///< by --update
};
std::string name_of(Failure::Kind);

/// What --update accepts. `failed` is all that this run complains of, what is missing included.
enum class Update { none, missing, failed, all };
std::vector<std::string> update_names();
Update update_named(const std::string&);

/// Each step of the first preset of each group has a picture, and each step of presets of one's own. Of the other
/// presets, whose traces are kept whole, the last picture is enough.
bool has_picture(const Excerpt&, int step);

class Baselines {
 public:
  Baselines(std::string folder, Update update, viz::Offscreen&);

  /// Trace first, then each picture. The failures, those that were accepted marked so.
  std::vector<Failure> check(const Excerpt&);
  /// Pictures and traces that belong to no step of these presets. With `all_presets` also those of no preset
  /// of these lessons, with `all_lessons` also those of no lesson at all.
  std::vector<Failure> orphans(const std::vector<Excerpt>&, bool all_lessons, bool all_presets);

 private:
  std::string path(const Excerpt&, const std::string& file) const;
  bool accepts(Failure::Kind) const;
  void check_trace(const Excerpt&, std::vector<Failure>&);
  void check_picture(const Excerpt&, int step, const viz::Camera&, std::vector<Failure>&);
  void orphans_in(const std::filesystem::path& preset, const std::set<std::filesystem::path>& wanted,
                  std::vector<Failure>& found) const;
  std::optional<Failure> compare_with_baseline(const viz::Picture& now, const std::string& baseline) const;

  std::string folder_;
  Update update_;
  viz::Offscreen& offscreen_;
  viz::Stamp stamp_;
};

}  // namespace isect::program
