#pragma once
// The walk of a segment against a box: comparisons first, then a range of t that narrows side by side.

#include <isect/clip_segment.h>
#include <isect/methods/clip_segment.h>
#include "lessons/clipping/picture.h"
#include "lessons/shared/script.h"

namespace isect::lessons::clipping_lesson {

class SegmentTeller {
 public:
  SegmentTeller(const Segment<double, 2>&, const Box&);
  viz::Walk tell();

 private:
  // segment.cpp
  std::string alt(const Segment<double, 2>&) const;
  void say(const clip_segment::Outcodes&);
  std::optional<viz::Question> order_of_crossings() const;
  void end();
  std::string end_caption(bool one) const;
  bool is_a_point() const { return known_.segment.p == known_.segment.q; }

  // segment_sides.cpp
  void say(const clip_segment::Narrowed<Counted<double>>&);
  std::string caption(int heading, bool narrowed, const Side&) const;
  std::string because(int heading, bool narrowed) const;

  const Box box_;
  const std::optional<Interval<double>> truth_;
  Script script_;
  Narrowing known_;
  bool found_ = false, trivial_ = false, asked_ = false, line_asked_ = false;
};

}  // namespace isect::lessons::clipping_lesson
