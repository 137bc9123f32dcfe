#pragma once
// How two shapes, their nearest points and the way between them are drawn.

#include <optional>

#include "lessons/distance/setup.h"

namespace isect::lessons::distance_lesson {

using Way = std::pair<viz::Vec3, viz::Vec3>;

/// What a step shows.
struct Known {
  bool regions = false;      ///< the planes across the segment's ends
  bool lines = false;        ///< the lines of both segments
  bool radii = false;        ///< of both capsules
  int axes = 0;              ///< of the boxes, whose gaps are drawn
  std::vector<Way> ways;     ///< what the step is about
  std::vector<Way> earlier;  ///< compared with it
  bool parts = false;        ///< all nearest points of both boxes
  bool settled = false;      ///< the exact answer
};
viz::Scene picture(const Setup&, const Known&);
/// From where the lesson is seen at first.
viz::Camera camera();

/// Which features are nearest as one shape is moved. (cases.cpp)
const viz::CaseMap& cases();
/// What each method says. (cases.cpp)
std::vector<viz::Opinion> opinions(const viz::Parameters&);
/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();

}  // namespace isect::lessons::distance_lesson
