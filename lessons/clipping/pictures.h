#pragma once
// What is known of a segment or a polygon while it is clipped, as a picture.

#include "lessons/clipping/methods.h"

namespace isect::lessons::clipping_lesson {

struct Narrowing {
  Segment<double, 2> segment;
  Box box;
  Interval<double> range = {0, 1};  ///< of t, so far
  bool left = false;                ///< nothing of it is left
  bool started = false, settled = false;

  Point<double, 2> at(double t) const { return segment.p + t * (segment.q - segment.p); }
};
/// With the side in turn and the t at which the line crosses it, if any.
viz::Scene picture(const Narrowing&, const Side* = nullptr, const double* crossing = nullptr);

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
