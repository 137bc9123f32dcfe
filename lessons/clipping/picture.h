#pragma once
// A segment and a polygon against a box in the plane: the two walks, and what their pictures share.

#include <isect/shapes.h>
#include "lessons/shared/flat.h"
#include "viz/lesson.h"

namespace isect::lessons::clipping_lesson {

using Box = Aabb<double, 2>;
inline Box box_of_lesson() { return {{-2, -1.25}, {2, 1.25}}; }
/// The box of a setting: the lesson's, unless b_min or b_max have moved its corners.
Box box_of(const viz::Parameters&);
/// Adds a handle to each side, and one that moves the whole box.
void add_grips(const Box&, viz::Scene&);
/// Whether the segment lies on the line of one of the box's sides.
bool runs_along_a_side(const Segment<double, 2>&, const Box&);
const viz::CaseMap& cases();  ///< of a segment
/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();
/// The exercise with a program that errs. (wrong_line.cpp)
viz::Exercise wrong_line();

viz::Walk clip_a_segment(const Segment<double, 2>&, const Box&);  ///< Liang and Barsky: a range of t
/// By slabs with reciprocals. `range_first`: the range is the first argument of min and max, and what is new the
/// second.
viz::Walk clip_by_reciprocals(const Segment<double, 2>&, const Box&, bool range_first);
viz::Walk clip_a_polygon(const Ring<double, 2>&, const Box&);  ///< Sutherland and Hodgman: side by side

/// One side of the box: the lower or the upper one on an axis.
struct Side {
  int axis = 0;
  bool upper = false;
};

/// "the left side"
std::string name_of(const Side&);
/// Its inner half-plane.
Plane<double, 2> half_plane(const Side&, const Box&);

viz::Region region(const Box&);
/// The whole line of a side with the normal that points inwards.
void add_side(const Side&, const Box&, viz::Scene&);

/// What is known of a segment while it is clipped.
struct Narrowing {
  Segment<double, 2> segment;
  Box box;
  Interval<double> range = {0, 1};  ///< of t, so far
  bool left = false;                ///< no part of it is left
  bool started = false, settled = false;

  Point<double, 2> at(double t) const { return segment.p + t * (segment.q - segment.p); }
};
/// The segment as clipped so far, with the current side and the t at which the line crosses it, if any.
viz::Scene picture(const Narrowing&, const Side* = nullptr, const double* crossing = nullptr);

/// What is known of a polygon while it is clipped.
struct Rest {
  Ring<double, 2> original;
  Box box;
  Ring<double, 2> ring;  ///< what is left of it
  bool settled = false;
};
/// The ring before a cut, what each vertex's side is, and the ring after it.
struct Cut {
  Side side;
  Ring<double, 2> before;
  std::vector<int> signs;
  Ring<double, 2> fresh;
};
viz::Scene picture(const Rest&, const Cut* = nullptr);
bool among(const Ring<double, 2>&, const Point<double, 2>&);

}  // namespace isect::lessons::clipping_lesson
