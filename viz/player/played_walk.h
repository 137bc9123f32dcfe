#pragma once
// The walk that a player shows, with what is known of its parameters. Its map of cases is swept in parts, at the latest
// when its step is shown: a walk is made for every move of a drag, and few of them are followed to the map.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viz/chart/chart.h"
#include "viz/lesson.h"

namespace isect::viz {

/// One value of the parameter that groups a lesson's presets, with the title of its variant.
struct Method {
  std::string choice, title;
};

/// What is known of a lesson regardless of its parameters.
struct LessonOverview {
  std::vector<Walk> samples;  ///< one of each preset
  std::vector<Method> methods;
};

class PlayedWalk {
 public:
  /// The lesson must outlive it. Makes the overview where none is given. Throws BadInput for parameters that the lesson
  /// refuses.
  PlayedWalk(const Lesson&, Parameters, std::shared_ptr<const LessonOverview> = nullptr);

  const Lesson& lesson() const { return lesson_; }
  const Parameters& parameters() const { return parameters_; }
  const Walk& walk() const { return walk_; }
  bool has_axis() const { return has_axis_; }  ///< viz::has_axis(walk())
  bool has_time() const { return has_time_; }  ///< viz::has_time(walk())
  /// Returns the preset that has these parameters; empty if they were changed by hand.
  const std::string& preset_id() const { return preset_; }
  /// Returns what the lesson's methods say of these parameters, if it has several that should agree.
  const std::vector<Opinion>& opinions() const { return opinions_; }
  bool methods_differ() const;

  const std::vector<Method>& methods() const { return overview_->methods; }
  /// Returns what a parameter's choice is called, as plain text: a method by its title.
  std::string title_of(const Parameter&, const std::string& choice) const;
  /// Returns the value of the grouping parameter; empty if the lesson has none.
  std::string method() const;
  /// Returns the presets of that group, in order: the keys 1 to 9 load them.
  std::vector<const Preset*> group() const;
  const std::vector<Walk>& samples() const { return overview_->samples; }
  const std::shared_ptr<const LessonOverview>& overview() const { return overview_; }

  /// Reads the lesson again, which has other presets now.
  void reread();
  /// Sweeps another part of the map if this step shows it; returns false if nothing was left to do.
  bool prepare(int step);

 private:
  const Lesson& lesson_;
  Parameters parameters_;
  Walk walk_;
  bool has_axis_, has_time_;
  std::shared_ptr<const LessonOverview> overview_;
  std::vector<Opinion> opinions_;
  std::string preset_;
  std::function<std::optional<Chart>()> map_part_;  ///< null: there is no map, or it is complete
};

}  // namespace isect::viz
