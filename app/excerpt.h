#pragma once

#include <optional>
#include <string>
#include <vector>

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
  std::string place = {};  ///< of a playlist's stop, the folder of its files: "hour/03-ray-sphere"; else empty
};

/// Draws the step of the preset's file at that file's time, as far as the setting still has one.
void draw_at_time(Excerpt&);
/// Sweeps the map of cases if one of the chosen steps shows it.
void sweep_shown_map(Excerpt&);

}  // namespace isect::program
