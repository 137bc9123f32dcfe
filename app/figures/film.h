#pragma once
// The pictures of an animation: a walk's steps, and where the camera moves from one to the next, what it sees on the
// way.

#include <vector>

#include "app/excerpt.h"

namespace isect::program {

/// A step as it is seen at rest, or on the way there from the camera of another step.
struct Shot {
  int step = 0, from = 0;  ///< from 0
  double share = 1;        ///< of the way; 1: at rest
  double seconds = 0;      ///< for which it is shown
  int times = 1;           ///< so often in a row
};

std::vector<Shot> shots_of(const std::vector<int>& steps);
/// Returns an animation of these steps. A card of text stays four times as long. The camera moves where a step is seen
/// in a way of its own, always in equally many pictures; not to a card or a chart, and not among figures at one scale.
std::vector<Shot> film_of(const Excerpt&, const std::vector<int>& steps, double seconds);

}  // namespace isect::program
