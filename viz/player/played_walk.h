#pragma once
// The walk that a player shows. Its map of cases is swept in parts, at the latest when its step is shown: a walk is
// made for every move of a drag, and few of them are followed to the map.

#include <functional>
#include <optional>

#include "viz/chart/chart.h"
#include "viz/lesson.h"

namespace isect::viz {

class PlayedWalk {
 public:
  /// The lesson must outlive it. Throws BadInput for parameters that the lesson refuses.
  PlayedWalk(const Lesson&, const Parameters&);

  const Walk& walk() const { return walk_; }
  /// Sweeps another part of the map if this step shows it; returns false if nothing was left to do.
  bool prepare(int step);

 private:
  Walk walk_;
  std::function<std::optional<Chart>()> map_part_;  ///< null: there is no map, or it is complete
};

/// Returns the lesson's walk. Throws BadInput for parameters that the lesson refuses.
Walk checked_walk(const Lesson&, const Parameters&);

}  // namespace isect::viz
