// A program that clips a segment, with one wrong line: the last exit counts, not the first.

#include <algorithm>

#include <isect/clip_segment.h>
#include "lessons/clipping/picture.h"
#include "lessons/shared/parameters.h"
#include "lessons/shared/wrong_program.h"

namespace isect::lessons::clipping_lesson {

using namespace viz;

namespace {

std::string program(const Segment<double, 2>& s, const Box& box) {
  const Vec2 d = s.q - s.p;
  double t_in = 0, t_out = 1;
  for (const Side side : {Side{0, false}, Side{0, true}, Side{1, false}, Side{1, true}}) {
    const Plane<double, 2> half = half_plane(side, box);
    const double h = half.normal.dot(s.p) + half.d, speed = half.normal.dot(d);
    if (speed == 0 && h < 0) return "NONE";
    if (speed > 0) t_in = std::max(t_in, -h / speed);
    if (speed < 0) t_out = -h / speed;
  }
  return t_in <= t_out ? "A PART" : "NONE";
}

/// Where a segment is clipped.
TwoVerdicts verdicts(const Parameters& p) {
  if (std::get<std::string>(p.at("shape")) == "polygon") return {};
  const Segment<double, 2> s = {flat_point(p, "p"), flat_point(p, "q")};
  const Box box = box_of(p);
  return {program(s, box), isect::clip(s, box) ? "A PART" : "NONE"};
}

}  // namespace

Exercise wrong_line() {
  return wrong_program<verdicts>(
      "whether a part of a segment from p to q lies in the box",
      {"d ← q − p, t_in ← 0, t_out ← 1", "for each side, with inner normal n",
       "    if n · d = 0 and p lies beyond it: return NONE", "    t ← where the line crosses the side",
       "    if n · d > 0: t_in ← max(t_in, t)", "    if n · d < 0: t_out ← t", "return t_in ≤ t_out ? A PART : NONE"},
      {6, "if n · d < 0: t_out ← min(t_out, t)",
       "The segment has left the box when it leaves the first side. A later exit must not take the place of an earlier "
       "one."},
      "both-ends-cut", {{"p", "2.25,-2.5,0"}});
}

}  // namespace isect::lessons::clipping_lesson
