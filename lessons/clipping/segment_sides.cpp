// A segment against a box, one side of it: where the line crosses it, and what that leaves of the range of t.

#include <fmt/format.h>

#include <utility>

#include "lessons/clipping/segment.h"
#include "lessons/shared/axis_names.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/line_question.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::clipping_lesson {

using namespace viz;

namespace {

/// An end that doesn't change is shown at the line that computes t, so that this line is reached too.
int line_of(int heading, bool narrowed) {
  if (heading == 0) return 4;
  if (!narrowed) return 5;
  return heading > 0 ? 6 : 7;
}

std::string title(int heading, const Side& side) {
  if (heading == 0) return "Parallel to " + name_of(side);
  return (heading > 0 ? "In across " : "Out across ") + name_of(side);
}

}  // namespace

void SegmentTeller::say(const clip_segment::Narrowed<Counted<double>>& e) {
  const Side side = {e.axis, e.upper};
  const double t = e.t.value;
  const Interval<double> before = std::exchange(known_.range, {e.range.lo.value, e.range.hi.value});
  const bool narrowed = !(before == known_.range);
  known_.left = !e.holds;
  if (e.heading > 0 && narrowed) script_.value("*t*_{in}", known_.range.lo, "t", Role::hit);
  if (e.heading < 0 && narrowed) script_.value("*t*_{out}", known_.range.hi, "t", Role::hit);
  if (known_.left) script_.leave_early();
  Step& step = script_.add(
      std::string("side-") + (e.upper ? "upper-" : "lower-") + "xy"[e.axis], title(e.heading, side),
      known_.left && e.heading != 0 ? 8 : line_of(e.heading, narrowed), caption(e.heading, narrowed, side),
      e.heading == 0
          ? "**n** · **d** = 0"
          : fmt::format("*t* = {},  range [{}, {}]", shown(t), shown(known_.range.lo), shown(known_.range.hi)));
  step.scene = picture(known_, &side, e.heading == 0 ? nullptr : &t);
  Narrowing untouched = known_;
  untouched.range = before, untouched.left = false;
  const Scene over = picture(untouched, &side);
  if (e.heading != 0 && e.holds && narrowed) {
    const double d = known_.segment.q[e.axis] - known_.segment.p[e.axis];
    Script::decide(step, {e.heading > 0 ? "**n** · **d** > 0" : "**n** · **d** < 0", e.upper ? -d : d, 0, true,
                          e.heading > 0 ? "the line enters here" : "the line leaves here"});
  } else if (e.heading != 0) {
    Script::decide(step, {"*t*_{in} > *t*_{out}", known_.range.lo, known_.range.hi, !e.holds,
                          e.holds ? "something is left" : "nothing is left"});
  }
  if (e.heading != 0 && !asked_) {
    asked_ = true;
    const double p = known_.segment.p[e.axis], d = known_.segment.q[e.axis] - p;
    const double at = e.upper ? box_.hi[e.axis] : box_.lo[e.axis];
    const char* const axis = axis_names[e.axis];
    step.question =
        which_value(fmt::format("From {} = {}, **d** advances by {}. At which *t* is {} = {}?", axis, shown(p),
                                shown(d), axis, shown(at)),
                    t,
                    {{at - p, "That is the way to go, not divided by what **d** advances."},
                     {(p - at) / d, "That goes the wrong way round: the sign is the opposite."},
                     {1 - t, "That counts from the other end."}},
                    fmt::format("*t* = ({} − {}) / {}.", shown(at), p < 0 ? "(" + shown(p) + ")" : shown(p), shown(d)));
    step.question->over = over;
    give_before(script_.walk(), {"*t*_{in}", "*t*_{out}"});
    return;
  }
  if (narrowed && !known_.left && !line_asked_) {
    line_asked_ = true;
    ask_for_line(script_.walk(),
                 fmt::format("The segment runs from **p** = {} to **q** = {}. Which line cuts the range at {}?",
                             coordinates(known_.segment.p), coordinates(known_.segment.q), name_of(side)),
                 {{4, "The segment's line is not parallel to this side."},
                  {5, "That line computes *t*, and leaves the range as it is."},
                  {6, "The normal **n** points inwards, and **n** · **d** < 0: the line leaves here."},
                  {7, "The normal **n** points inwards, and **n** · **d** > 0: the line enters here."},
                  {8, "That line ends the search where nothing is left. Here something is."}},
                 because(e.heading, narrowed));
    step.question->over = over;
    give_before(script_.walk(), {"*t*_{in}", "*t*_{out}"});
    return;
  }
  step.question = {"What does " + name_of(side) + " do to the range?",
                   {"it cuts its beginning", "it cuts its end", "it leaves it as it is", "it leaves none of it"},
                   known_.left     ? 3
                   : !narrowed     ? 2
                   : e.heading > 0 ? 0
                                   : 1,
                   because(e.heading, narrowed),
                   over};
  give_before(script_.walk(), {"*t*_{in}", "*t*_{out}"});
}

std::string SegmentTeller::caption(int heading, bool narrowed, const Side& side) const {
  if (heading == 0)
    return known_.left ? "The line is parallel to this side and lies beyond it: nothing is left."
                       : "The line is parallel to this side and not beyond it. The side cuts nothing off.";
  if (known_.left)
    return "The line leaves one side before it has entered the other. No *t* satisfies both: nothing is "
           "left.";
  const std::string way = (heading > 0 ? "The line enters across " : "The line leaves across ") + name_of(side);
  if (narrowed) return way + (heading > 0 ? ": what lies before *t* is cut off." : ": what lies after *t* is cut off.");
  return way + (heading > 0 ? ", but the range begins no earlier.\nSo *t*_{in} stays: the last entry counts."
                            : ", but the range ends no later.\nSo *t*_{out} stays: the first exit counts.");
}

std::string SegmentTeller::because(int heading, bool narrowed) const {
  if (heading == 0) return known_.left ? "Every point lies beyond the side." : "No point lies beyond the side.";
  if (known_.left) return "The last entry comes after the first exit.";
  if (!narrowed) return "This crossing lies outside the range that is left.";
  return heading > 0 ? "**n** · **d** > 0: the line enters here." : "**n** · **d** < 0: the line leaves here.";
}

}  // namespace isect::lessons::clipping_lesson
