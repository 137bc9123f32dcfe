// A segment against a box: what comparisons tell, and what is kept in the end.

#include "lessons/clipping/segment.h"

#include <fmt/format.h>

#include <bit>

#include <isect/methods/ray_aabb.h>
#include "lessons/shared/digits.h"
#include "lessons/shared/line_question.h"
#include "lessons/shared/order_question.h"

namespace isect::lessons::clipping_lesson {

using namespace viz;
using C = Counted<double>;

SegmentTeller::SegmentTeller(const Segment<double, 2>& segment, const Box& box)
    : box_(box),
      truth_(isect::clip(segment, box)),
      script_({"Lecture note, uses of intersection detection; Liang and Barsky, ACM Transactions on Graphics 3 (1984)",
               alt(segment),
               {
                   "if p and q lie in the box: return [0, 1]",                    // 0
                   "if p and q lie beyond one and the same side",                 // 1
                   "    return NONE",                                             // 2
                   "[t_in, t_out] ← [0, 1]; for each side, with inner normal n",  // 3
                   "    if n · d = 0: go on, as p and q are not beyond it",       // 4
                   "    t ← where the line crosses the side",                     // 5
                   "    if n · d > 0: t_in ← max(t_in, t)",                       // 6
                   "    if n · d < 0: t_out ← min(t_out, t)",                     // 7
                   "    if t_in > t_out: return NONE",                            // 8
                   "return [t_in, t_out]"                                         // 9
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

std::string SegmentTeller::alt(const Segment<double, 2>& s) const {
  return std::string("A segment from p to q and a box. ") +
         (!truth_                                  ? "No part of the segment lies in the box."
          : truth_->lo == truth_->hi || s.p == s.q ? "They share one point."
                                                   : "The part of the segment in the box is drawn thick.");
}

void SegmentTeller::say(const clip_segment::Outcodes& e) {
  const bool inside = (e.p | e.q) == 0, beyond = (e.p & e.q) != 0;
  script_.value("sides beyond, **p**", std::popcount(static_cast<unsigned>(e.p)));
  script_.value("sides beyond, **q**", std::popcount(static_cast<unsigned>(e.q)));
  if (!inside) script_.refuse(0, {});
  if (!inside && !beyond) script_.refuse(1, {2});
  Step& step = script_.add(
      "trivial", "Cohen-Sutherland outcodes",
      inside   ? 0
      : beyond ? 2
               : 1,
      std::string("One bit for each side that an end, **p** or **q**, lies beyond: top, bottom, right, left.\n") +
          (inside   ? "All bits are 0, so both ends lie in the box. The box is convex: trivial accept."
           : beyond ? "A bit is 1 in both, so the whole segment lies beyond that side: trivial reject."
                    : "Some bit is 1, but none is 1 in both. Only now is there a need to compute."),
      fmt::format("**p**: {:04b},  **q**: {:04b},  and: {:04b},  or: {:04b}", e.p, e.q, e.p & e.q, e.p | e.q));
  step.decides = true;
  step.scene = picture(known_);
  ask_for_line(
      script_.walk(),
      fmt::format("The box reaches from {} to {}, the segment from **p** = {} to **q** = {}. Lines 1 to 3 need no more "
                  "than comparisons of the ends with the sides. Which of them runs last?",
                  coordinates(box_.lo), coordinates(box_.hi), coordinates(known_.segment.p),
                  coordinates(known_.segment.q)),
      {{0, "Not both ends lie in the box, so the test goes on."},
       {1, inside ? "Both ends lie in the box: line 1 has returned."
                  : "Both ends lie beyond one side, so its condition holds. The line below it runs, too."},
       {2, inside ? "Both ends lie in the box: line 1 has returned."
                  : "No side has both ends beyond it, so nothing is returned yet."}},
      inside   ? "No end lies beyond a side, so the first line returns the whole range."
      : beyond ? "One side has both ends beyond it."
               : "The condition of line 2 is asked, and does not hold. So *t* must be computed.");
  trivial_ = inside || beyond;
  if (trivial_) script_.leave_early();
  if (trivial_) return;

  known_.started = true;
  script_.value("*t*_{in}", 0, "t");
  script_.value("*t*_{out}", 1, "t");
  Step& begin = script_.add("range", "The range of *t*", 3,
                            "The segment is **p** + *t* **d** with 0 ≤ *t* ≤ 1, where **d** = **q** − **p**.\n"
                            "Each side of the box, with its normal **n** pointing inwards, will cut this range. What "
                            "is left at the end lies in the box.\n"
                            "Cohen and Sutherland go on otherwise: they cut the segment at a side that one end lies "
                            "beyond. The new end has an outcode, too. So they loop, until they accept or reject.",
                            "[*t*_{in}, *t*_{out}] = [0, 1]");
  begin.scene = picture(known_);
  begin.question = order_of_crossings();
}

/// Asks in which order the segment's line crosses those of the four sides, if it is parallel to none.
std::optional<Question> SegmentTeller::order_of_crossings() const {
  const Point<double, 2>&p = known_.segment.p, &q = known_.segment.q;
  if (p.x() == q.x() || p.y() == q.y()) return {};
  std::vector<InOrder> sides;
  std::vector<double> backwards;
  for (const int axis : {0, 1})
    for (const bool upper : {false, true}) {
      const double at = upper ? box_.hi[axis] : box_.lo[axis];
      sides.push_back({name_of(Side{axis, upper}), (at - p[axis]) / (q[axis] - p[axis])});
      backwards.push_back(-sides.back().key);
    }
  return which_order(fmt::format("A line runs from **p** = {} to **q** = {}, and on. The sides lie at *x* = {} and {}, "
                                 "and at *y* = {} and {}. In which order does it cross these four lines?",
                                 coordinates(p), coordinates(q), shown(box_.lo.x()), shown(box_.hi.x()),
                                 shown(box_.lo.y()), shown(box_.hi.y())),
                     sides,
                     {{backwards, "That is the order from **q** towards **p**."},
                      {{0, 1, 2, 3}, "That is the order in which the method tests the sides."}},
                     "Each side has its *t*, and smaller ones come first.");
}

void SegmentTeller::end() {
  known_.settled = true, known_.left = !truth_, known_.started = true;
  known_.range = truth_.value_or(Interval<double>{0, 0});
  const bool one = truth_ && (truth_->lo == truth_->hi || is_a_point());
  const auto [lo, hi] = shown_apart(known_.range.lo, known_.range.hi);
  const bool touches = runs_along_a_side(known_.segment, box_) || (one && !is_a_point());
  script_.settle(!truth_   ? Verdict::Kind::no
                 : touches ? Verdict::Kind::on
                           : Verdict::Kind::yes,
                 !truth_        ? "nothing is kept"
                 : is_a_point() ? "the point is kept"
                 : one          ? "one point is kept: *t* = " + shown(known_.range.lo)
                                : fmt::format("kept: *t* from {} to {}", lo, hi));
  const int last = script_.walk().steps.back().line;
  const int line = trivial_ || !found_ ? last : 9;
  script_
      .add("kept", truth_ ? "What is kept" : "Nothing is kept", line, end_caption(one),
           truth_ && !one && !trivial_ ? fmt::format("**p** + *t* **d**,  {} ≤ *t* ≤ {}", lo, hi) : "")
      .scene = picture(known_);
}

std::string SegmentTeller::end_caption(bool one) const {
  if (found_ != truth_.has_value())
    return "Rounding makes this method wrong here: at a corner the last entry is the first exit, and rounding moved "
           "them.";
  if (!truth_)
    return trivial_ ? "In a large scene most segments are rejected this way. So comparisons come first."
                    : "No side has both ends beyond it, yet the segment misses the box: it passes a corner.";
  if (is_a_point())
    return std::string("**p** and **q** are equal, so the segment is a point. It lies ") +
           (runs_along_a_side(known_.segment, box_) ? "on the boundary, which belongs to the box: the sets are closed."
                                                    : "in the box.");
  if (one)
    return std::string("Last entry and first exit are the same *t*: the segment touches the box ") +
           (truth_->lo == 0   ? "with its end **p**.\n"
            : truth_->lo == 1 ? "with its end **q**.\n"
                              : "at a corner.\n") +
           "The sets are closed, so touching counts, and the part kept is a point.";
  if (runs_along_a_side(known_.segment, box_))
    return std::string("The part kept lies in a side. The sets are closed, so the boundary belongs to the box.") +
           (ray_aabb::by_min_max(isect::segment(known_.segment.p, known_.segment.q), box_)
                ? ""
                : "\nSlabs by reciprocals lose it: 0 · ∞ is not a number, and every comparison with it "
                  "fails.");
  if (trivial_) return "No side was crossed, so there was nothing to divide: the segment is kept as it is.";
  return "The part kept runs from the last entry to the first exit.\n"
         "The new ends are **p** + *t* **d** with these two *t*: one formula for all cases.";
}

Walk clip_a_segment(const Segment<double, 2>& segment, const Box& box) { return SegmentTeller(segment, box).tell(); }

}  // namespace isect::lessons::clipping_lesson
