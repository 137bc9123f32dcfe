// All cases of a segment's far end: its near end stays.

#include <limits>

#include <isect/clip_segment.h>
#include "lessons/clipping/picture.h"

namespace isect::lessons::clipping_lesson {
namespace {

using namespace viz;

enum Case { beyond, cut, touching, whole, past };

Segment<double, 2> segment_of(const Parameters& p) {
  return {std::get<Vec3>(p.at("p")).head<2>(), std::get<Vec3>(p.at("q")).head<2>()};
}

int branch(const Parameters& p) {
  const Segment<double, 2> s = segment_of(p);
  const Box box = box_of(p);
  const int at_p = clip_segment::outcode(s.p, box), at_q = clip_segment::outcode(s.q, box);
  if ((at_p | at_q) == 0) return whole;
  if ((at_p & at_q) != 0) return beyond;
  const std::optional<Interval<double>> kept = isect::clip(s, box);
  if (!kept) return past;
  return kept->lo == kept->hi || runs_along_a_side(s, box) ? touching : cut;
}

/// The place of **q**; NaN for a polygon.
Vec2 place(const Parameters& p) {
  if (std::get<std::string>(p.at("shape")) != "segment")
    return Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
  return segment_of(p).q;
}
Parameters moved(const Parameters& p, const Vec2& to) {
  Parameters there = p;
  there["q"] = Vec3(to.x(), to.y(), std::get<Vec3>(p.at("q")).z());
  return there;
}

}  // namespace

const CaseMap& cases() {
  static const CaseMap map = {
      "*x* of **q**",
      "*y* of **q**",
      {-6, -2.5},
      {6, 2.5},
      {"beyond one side", "cut", "touching", "all kept", "past a corner"},
      branch,
      place,
      moved,
      "The endpoint **q** moves; **p** is fixed. Outcodes alone settle the regions beyond one side.\n"
      "Past a corner nothing is kept either, but only the range of *t* shows it."};
  return map;
}

}  // namespace isect::lessons::clipping_lesson
