#pragma once
// A segment and a polygon against a box in the plane: the two walks, and what their pictures share.

#include <isect/shapes.h>
#include "viz/lesson.h"

namespace isect::lessons::clipping_lesson {

using Box = Aabb<double, 2>;
inline Box box_of_lesson() { return {{-2, -1.25}, {2, 1.25}}; }
/// Whether the segment lies on the line of one of the box's sides.
bool runs_along_a_side(const Segment<double, 2>&, const Box&);
const viz::CaseMap& cases();  ///< of a segment

viz::Walk clip_a_segment(const Segment<double, 2>&, const Box&);  ///< Liang and Barsky: a range of t
viz::Walk clip_a_polygon(const Ring<double, 2>&, const Box&);     ///< Sutherland and Hodgman: side by side

/// One side of the box: the lower or the upper one on an axis.
struct Side {
  int axis = 0;
  bool upper = false;
};

/// "the left side"
std::string name_of(const Side&);
/// Its inner half-plane.
Plane<double, 2> half_plane(const Side&, const Box&);

viz::Vec3 flat(const Point<double, 2>&);
std::vector<viz::Vec3> flat(const Ring<double, 2>&);
viz::Region region(const Box&);
/// The whole line of a side with the normal that points inwards.
void add_side(const Side&, const Box&, viz::Scene&);

}  // namespace isect::lessons::clipping_lesson
