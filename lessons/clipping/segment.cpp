// A segment against a box: what comparisons tell, and what is kept in the end.

#include "lessons/clipping/segment.h"

#include <fmt/format.h>

#include <bit>

namespace isect::lessons::clipping_lesson {

using namespace viz;
using C = Counted<double>;

SegmentTeller::SegmentTeller(const Segment<double, 2>& segment, const Box& box)
    : box_(box),
      truth_(isect::clip(segment, box)),
      script_({"Note, N01; Liang and Barsky (1984)",
               alt(),
               {
                   "if p and q lie in the box: return [0, 1]",                    // 0
                   "if p and q lie beyond one side: return NONE",                 // 1
                   "[t_in, t_out] ← [0, 1]; for each side, with inner normal n",  // 2
                   "    if n · d = 0: return NONE if p lies beyond it",           // 3
                   "    t ← where the line crosses the side",                     // 4
                   "    if n · d > 0: t_in ← max(t_in, t)",                       // 5
                   "    if n · d < 0: t_out ← min(t_out, t)",                     // 6
                   "    if t_in > t_out: return NONE",                            // 7
                   "return [t_in, t_out]"                                         // 8
               },
               "a segment"}),
      known_{segment, box} {}

Walk SegmentTeller::tell() {
  script_.tell<clip_segment::LiangBarskyEvent<C>>(
      [&](auto& record) {
        found_ = clip_segment::liang_barsky(cast<C>(known_.segment), cast<C>(box_), record).has_value();
      },
      [&](const auto& event) { say(event); });
  end();
  return std::move(script_.walk());
}

std::string SegmentTeller::alt() const {
  return std::string("A segment from p to q and a box. ") +
         (!truth_                    ? "No part of the segment lies in the box."
          : truth_->lo == truth_->hi ? "They share one point."
                                     : "The part of the segment in the box is drawn thick.");
}

void SegmentTeller::say(const clip_segment::Outcodes& e) {
  const bool inside = (e.p | e.q) == 0, beyond = (e.p & e.q) != 0;
  script_.value("sides beyond, **p**", std::popcount(static_cast<unsigned>(e.p)));
  script_.value("sides beyond, **q**", std::popcount(static_cast<unsigned>(e.q)));
  if (!inside) script_.refuse(0, {});
  if (!inside && !beyond) script_.refuse(1, {});
  Step& step = script_.add(
      "trivial", "A trivial answer?", inside ? 0 : 1,
      inside   ? "Both ends lie in the box. It is convex, so it holds all between them: trivial acceptance."
      : beyond ? "Both ends lie beyond one and the same side, so all between them does: trivial rejection."
               : "The ends do not both lie in the box, nor both beyond one side. Only now is there a need to "
                 "compute.");
  step.decides = true;
  step.scene = picture(known_);
  step.question = {"Is the answer known from comparisons alone?",
                   {"yes: all is kept", "yes: nothing is kept", "no"},
                   inside   ? 0
                   : beyond ? 1
                            : 2,
                   "Each end is compared with the four sides, and nothing is computed."};
  trivial_ = inside || beyond;
  if (trivial_) script_.leave_early();
  if (trivial_) return;

  known_.started = true;
  script_.value("*t*_{in}", 0, "t");
  script_.value("*t*_{out}", 1, "t");
  Step& begin = script_.add("range", "The range of *t*", 2,
                            "The segment is **p** + *t* **d** with 0 ≤ *t* ≤ 1, where **d** = **q** − **p**.\n"
                            "Each side of the box will cut this range. What is left at the end lies in the box.",
                            "[*t*_{in}, *t*_{out}] = [0, 1]");
  begin.scene = picture(known_);
}

void SegmentTeller::end() {
  known_.settled = true, known_.left = !truth_, known_.started = true;
  known_.range = truth_.value_or(Interval<double>{0, 0});
  const bool one = truth_ && truth_->lo == truth_->hi;
  script_.settle(!truth_                                          ? Verdict::Kind::no
                 : one || runs_along_a_side(known_.segment, box_) ? Verdict::Kind::on
                                                                  : Verdict::Kind::yes,
                 !truth_ ? "nothing is kept"
                 : one   ? "one point is kept: *t* = " + shown(known_.range.lo)
                         : fmt::format("kept: *t* from {} to {}", shown(known_.range.lo), shown(known_.range.hi)));
  const int last = script_.walk().steps.back().line;
  const int line = trivial_ || !truth_ ? last : 8;
  script_
      .add("kept", truth_ ? "What is kept" : "Nothing is kept", line, end_caption(one),
           truth_ && !one
               ? fmt::format("**p** + *t* **d**,  {} ≤ *t* ≤ {}", shown(known_.range.lo), shown(known_.range.hi))
               : "")
      .scene = picture(known_);
}

std::string SegmentTeller::end_caption(bool one) const {
  if (found_ != truth_.has_value())
    return "The exact test says otherwise. At a corner the last entry is the first exit, and rounding "
           "moved them.";
  if (!truth_)
    return trivial_ ? "Most of what a renderer clips is far off. So the cheap rejection comes first."
                    : "Neither end was beyond the same side, yet the segment misses the box: it passes a "
                      "corner.";
  if (one)
    return "Last entry and first exit are the same *t*: the segment touches the box at a corner.\n"
           "The sets are closed, so touching counts, and the part kept is a point.";
  if (runs_along_a_side(known_.segment, box_))
    return "The part kept lies in a side. The sets are closed, so the boundary belongs to the box.";
  if (trivial_) return "No side was crossed, so there was nothing to divide: the segment is kept as it is.";
  return "The part kept runs from the last entry to the first exit.\n"
         "The new ends are **p** + *t* **d** with these two *t*: one formula for all cases.";
}

Walk clip_a_segment(const Segment<double, 2>& segment, const Box& box) { return SegmentTeller(segment, box).tell(); }

}  // namespace isect::lessons::clipping_lesson
