#pragma once
// Baselines on disk: DIR/<lesson>/<preset>/<NN>-<slug>.png and trace.json, and beside them those of further looks that
// are guarded, <NN>-<slug>.<look>.png, .svg or .tikz. Compares them with what the lesson does now and, if asked,
// accepts that. A file that isect did not make is never changed or removed.

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/checks/accept_file.h"
#include "app/figures/ownership.h"
#include "app/shell/options.h"
#include "viz/formats/files.h"
#include "viz/gl/offscreen.h"
#include "viz/snapshot/perceived.h"
#include "viz/snapshot/snapshot.h"

namespace isect::program {

/// A failure that `check` reports.
struct Failure {
  enum class Kind { missing, trace, picture, size, blank, unreadable, orphan, preset, moved, text };
  Kind kind;
  std::string lesson, preset;
  int step = -1;                            ///< from 0; -1: not of one step
  std::string slug = {};                    ///< of that step
  std::string look = {};                    ///< of a guarded one, the end of its file: "dark.png"; empty: the usual one
  std::string what = {};                    ///< in words, the first difference first
  std::string baseline = {};                ///< the file it is about
  std::string fresh = {}, difference = {};  ///< pictures written beside it, if any
  std::string cause = {};                   ///< in words; failures of one cause have the same (see causes.h)
  int line = 0;                             ///< the first in which texts differ, from 1; 0: there is none
  viz::Difference pixels = {};
  viz::Perceived eye = {};
  std::vector<std::string> more = {};   ///< more differences, in words
  std::vector<std::string> notes = {};  ///< what could not be done about it, and why
  bool foreign = false;                 ///< the file in the baseline's place is not isect's
  bool pointer = false;                 ///< ... but a Git LFS pointer to the baseline
  bool accepted = false;                ///< by --update; an orphan is removed
  /// The pictures themselves, as files, if a report asks for them; and what `check --accept` would write or remove.
  std::string accepted_file = {}, fresh_file = {}, difference_file = {};
  std::vector<Reviewed> reviewed = {};
};
std::string name_of(Failure::Kind);

/// What --update accepts. `failed`: all failures of this run, missing baselines included.
enum class Update { none, missing, failed, all };
std::vector<std::string> update_names();
Update update_named(const std::string&);

/// Whether the preset is a user's own, from a file, whatever its name is.
bool is_own(const Excerpt&);

/// Whether a step has a picture: all steps do of the first preset of each group and of a user's own presets, but for
/// the closing card, whose texts the trace tells. Of the other presets, whose whole traces are kept, the last picture
/// is enough.
bool has_picture(const Excerpt&, int step);

struct Pictured;

class Baselines {
 public:
  /// Failures have their pictures if `keep_pictures`. `acceptance`: in place of an update, files that were reviewed;
  /// no other file is looked at or touched. It must live as long.
  Baselines(std::string folder, Update update, bool keep_pictures, viz::Offscreen&, Acceptance* acceptance = nullptr);

  /// Checks the trace first, then each picture. Returns the failures; those that were accepted are marked.
  std::vector<Failure> check(const Excerpt&);

  /// The presets that are searched for files that belong to no step.
  struct Reach {
    bool all_lessons = false, all_presets = false;  ///< also those of lessons and presets that no longer exist
    std::set<std::string> spared = {};              ///< presets whose steps are unknown
  };
  /// A preset without a baseline that says and shows what one did that no longer exists: it was probably renamed.
  struct Move {
    std::string lesson, from, to;  ///< presets' names
  };
  std::vector<Move> moves(const std::vector<Excerpt>&, const Reach&);
  /// Joins what is missing for such a preset, and left over from the other, into one failure.
  void join(const std::vector<Move>&, std::vector<Failure>&) const;
  /// Returns pictures and traces that isect made and that belong to no step of these presets.
  std::vector<Failure> orphans(const std::vector<Excerpt>&, const Reach&);

  /// Returns pictures and traces among the baselines that are not isect's.
  const std::set<std::string>& left_alone() const { return left_alone_; }

 private:
  std::string path(const Excerpt&, const std::string& file) const;
  /// Returns the path below the folder of the baselines.
  std::string below(const std::string& baseline) const;
  bool accepts(Failure::Kind) const;
  /// Whether a reviewed file is all that counts, and this is none.
  bool passes_over(const std::string& baseline) const;
  /// Returns the accepted trace of a folder as it was before this run.
  const std::optional<OwnTrace>& trace_of(const std::string& folder);
  /// Whether the file is to be replaced by the new one. Marks the failure, if there is one. `now`: the new one, where
  /// files are accepted that were reviewed.
  bool settle(const std::string& baseline, bool ours, std::optional<Failure>&, const std::string& now);
  bool settle_reviewed(const std::string& baseline, std::optional<Failure>&, const std::string& now);
  /// Returns one drawing for each step.
  std::vector<viz::Drawing> drawings_of(const Excerpt&) const;
  std::string trace_now(const Excerpt&, const std::vector<viz::Drawing>&) const;
  /// Returns what differs.
  std::vector<viz::Change> check_trace(const Excerpt&, const std::vector<viz::Drawing>&, std::vector<Failure>&);
  Pictured pictured(const Excerpt&, int step, const Guard*) const;
  /// Whether nobody would see a drawing of it. It is missing, then, unless it is passed over.
  bool need_no_drawing(const Pictured&, std::vector<Failure>&) const;
  void check_picture(const Pictured&, const viz::Drawing&, const std::vector<viz::Change>&, std::vector<Failure>&);
  void check_text(const Pictured&, const std::string& now, const std::vector<viz::Change>&, std::vector<Failure>&);
  void check_guard(const Excerpt&, const Guard&, const std::vector<viz::Change>&, std::vector<Failure>&);
  std::optional<Failure> compare_with_baseline(const viz::Picture& now, const std::string& baseline) const;
  /// Writes or reports what a comparison found. `now`: makes the new file, `difference` a picture of what differs.
  void conclude(const Pictured&, std::optional<Failure>, const std::function<std::string()>& now,
                const std::function<std::string(const Failure&)>& difference, std::vector<Failure>&);
  /// Returns the folders with baselines in reach, as lesson and preset.
  std::vector<std::pair<std::string, std::string>> in_reach(const std::vector<Excerpt>&, const Reach&) const;
  void orphans_in(const std::string& lesson, const std::string& preset, const std::set<std::filesystem::path>& wanted,
                  std::vector<Failure>& found);

  std::string folder_;
  Update update_;
  bool keep_pictures_;
  viz::Offscreen& offscreen_;
  Acceptance* acceptance_;
  viz::Stamp stamp_;
  std::map<std::string, std::optional<OwnTrace>> traces_;
  std::set<std::string> left_alone_;
};

}  // namespace isect::program
