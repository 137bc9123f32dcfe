#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/guard.h"
#include "viz/lesson.h"

namespace isect::program {

/// One setting of a lesson's parameters, walked.
struct Excerpt {
  const viz::Lesson* lesson = nullptr;
  std::string folder;  ///< the preset's id, or the name of the preset's file; with what was changed by hand
  std::string preset;  ///< empty where a parameter was changed by hand
  viz::Parameters parameters;
  viz::Walk walk;
  std::vector<int> steps;                  ///< chosen ones, from 0
  std::optional<viz::Camera> camera = {};  ///< of the preset's file
  std::optional<int> step = {};            ///< of the preset's file, from 0
  std::optional<double> time = {};         ///< at which that step is drawn in `walk`; none: as it is
  std::string several = {};                ///< for a figure of several steps, these: "2-4"; else empty
  std::string style = {};                  ///< for a figure, how it was asked for (see app/figures/style.h); else empty
  std::string path = {};                   ///< of the preset's or the scene's file; empty where there is none
  std::vector<Guard> guards = {};          ///< of the preset's or the scene's file: looks that `check` guards besides
  std::string place = {};  ///< of a playlist's stop, the folder of its files: "hour/03-ray-sphere"; else empty
  /// All settings that are drawn at one scale, this one among them at place `scaled_as`, and none with such a list of
  /// its own. Null: it has its own scale.
  std::shared_ptr<const std::vector<Excerpt>> scaled_with = {};
  std::size_t scaled_as = 0;
};
using Excerpts = std::span<const Excerpt>;

/// Walks the setting, and chooses the steps that `text` names, as --step does. Throws viz::BadInput if the walk lacks
/// one of them; not with `some`, and then none may be left.
void take_steps(Excerpt&, const std::string& text, bool some = false);
/// Draws the step of the preset's file at that file's time, as far as the setting still has one.
void draw_at_time(Excerpt&);
/// Sweeps the map of cases if one of the chosen steps shows it.
void sweep_shown_map(Excerpt&);

}  // namespace isect::program
