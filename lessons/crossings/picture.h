#pragma once
// The picture of a point, its ray and a polygon: crossings found so far, and the edge this step is about.

#include <optional>

#include "lessons/crossings/situations.h"
#include "viz/lesson.h"

namespace isect::lessons::crossings_lesson {

struct EdgeOf {
  int ring, index;
};

struct Meeting {
  Point<double, 2> at;
  int number;  ///< of the crossing; 0: seen, not counted
};

struct Known {
  bool ray = true;
  bool raised = false;            ///< a second ray, a little higher
  std::optional<EdgeOf> edge;     ///< the one looked at
  std::vector<Meeting> meetings;  ///< on the ray
  std::vector<EdgeOf> along;      ///< edges along the ray, left out
  bool on = false;                ///< the point lies on the boundary, and that is known
};

/// The ends of an edge.
std::array<Point<double, 2>, 2> ends(const Setup&, const EdgeOf&);
/// Where an edge that straddles the height of the point meets it; its end on the line, if it has one.
Point<double, 2> meeting(const Setup&, const EdgeOf&);

viz::Scene picture(const Setup&, const Known&);
std::string alt_text(const Setup&);
/// "3 crossings: odd, IN", and what the other rule says where it differs.
std::string verdict_text(const Winding&);

}  // namespace isect::lessons::crossings_lesson
