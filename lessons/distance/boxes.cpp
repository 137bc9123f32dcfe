// Two axis-aligned boxes: a gap on each axis, and the sum of the squares.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/distance/telling.h"
#include "lessons/shared/axis_names.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/questions.h"

namespace isect::lessons::distance_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

class BoxesTeller : Teller {
 public:
  explicit BoxesTeller(const Setup& s)
      : Teller(s, "two boxes", "Ericson, Real-Time Collision Detection (2005), 5.1.3",
               {"d² ← 0; for each axis",                                       // 0
                "    gap ← max(0, b.min − a.max, a.min − b.max)",              // 1
                "    d² ← d² + gap²",                                          // 2
                "nearest points: the ends at a gap, else all shared numbers",  // 3
                "return d²"}) {}                                               // 4

  Walk tell() {
    add("boxes", "Axis by axis", 0,
        "A box is an interval on each axis, and its points are all choices of three coordinates.\n"
        "The squared distance *d*^2 of two points is the sum of three squares, one for each axis.\n"
        "So each axis is minimised by itself. What is least there is the gap of two intervals.");
    script_.tell<nearest_features::BoxEvent<C>>(
        [&](auto& record) { nearest_features::distance2<C, 3>(cast<C>(s_.boxes[0]), cast<C>(s_.boxes[1]), record); },
        [&](const auto& event) { say(event); });
    features();
    known_.parts = true, known_.settled = true;
    settle();
    add("distance", "The distance", 4, end_caption(), "*d*^2 = " + shown(squared_));
    return std::move(script_.walk());
  }

 private:
  /// A number that is squared: one with a power of ten in brackets.
  static std::string base(double x) {
    const std::string text = shown(x);
    return text.find_first_not_of("0123456789.") == text.npos ? text : "(" + text + ")";
  }

  void say(const nearest_features::Gap<C>& e) {
    const std::string letter(1, "xyz"[e.axis]), axis = axis_names[e.axis];
    const Interval<double> a = {e.a.lo.value, e.a.hi.value}, b = {e.b.lo.value, e.b.hi.value};
    const double gap = e.gap.value, before = squared_;
    squared_ = e.distance2.value;
    sum_ += gap, largest_ = std::max(largest_, gap * gap);
    known_.axes = e.axis + 1;
    script_.value("gap on " + axis, gap, "length");
    script_.value("*d*^2", squared_, "area", Role::highlight);
    Step& step = add("axis-" + letter, "The gap on " + axis, gap > 0 ? 2 : 1, axis_caption(e.axis, a, b),
                     gap > 0 ? fmt::format("*d*^2 = {} + {}^2 = {}", shown(before), base(gap), shown(squared_))
                             : "*d*^2 = " + shown(squared_));
    const std::string spans = fmt::format("On {} a reaches from {} to {}, and b from {} to {}.", axis, shown(a.lo),
                                          shown(a.hi), shown(b.lo), shown(b.hi));
    const double middles = (a.lo + a.hi) / 2 - (b.lo + b.hi) / 2, far = std::max(b.hi - a.lo, a.hi - b.lo);
    if (e.axis == 0)
      step.question = which_value(spans + " What is the square of the gap?", gap * gap,
                                  {{gap, "That is the gap, and not its square."},
                                   {middles * middles, "That is measured from centre to centre."},
                                   {far * far, "That is measured between the ends that are farthest apart."}},
                                  gap > 0 ? "From the end of one interval to the beginning of the other, squared."
                                          : "Intervals that share a number have no gap.");
    if (e.axis == 2 && gap > 0 && before > 0)
      step.question = which_value(
          fmt::format("*d*^2 = {} after *x* and *y*. {} What is *d*^2 after *z*?", shown(before), spans), squared_,
          {{sum_ * sum_, "That squares the sum of the gaps. Square each of them, then add."},
           {largest_, "That is the largest of the squares alone."},
           {before + middles * middles, "On *z* that is measured from centre to centre."}},
          "The square of the gap on *z* is added.");
  }

  std::string axis_caption(int number, const Interval<double>& a, const Interval<double>& b) const {
    const std::string axis = axis_names[number];
    const Interval<double> common = s_.shared(number);
    if (common.lo > common.hi)
      return fmt::format("{} ends before {} begins, so there is a gap. Its square is added to *d*^2.\n",
                         a.hi < b.lo ? "a" : "b", a.hi < b.lo ? "b" : "a") +
             "Both nearest points have their coordinate at an end beside the gap.";
    if (common.lo == common.hi)
      return fmt::format("Both intervals share one number on {}, so the gap is 0. Both nearest points have it.", axis);
    return fmt::format(
        "Both intervals share numbers on {}, so the gap is 0. A nearest pair may have any of them, the same in both.",
        axis);
  }

  void features() {
    known_.parts = true;
    Step& step = add("features", "Which features are nearest?", 3, features_caption());
    if (!s_.meet) step.question = pairs_question(), keep_picture(script_.walk());
  }
  std::string features_caption() const {
    if (s_.meet) return "No axis has a gap, so the boxes share points. Each shared point is nearest to itself.";
    switch (s_.kind()) {
      case Kind::rectangle:
        return "On two axes the boxes share more than one number. So the nearest pairs fill a rectangle.\n"
               "On each box that is a part of a face (lit).";
      case Kind::interval:
        return std::string("On one axis the boxes share more than one number. So the nearest pairs fill an interval.") +
               (s_.flat() ? "" : "\nOn each box that is a part of an edge (lit).");
      case Kind::ends:
        return "On no axis the boxes share more than one number. So one pair alone is nearest: two corners.";
      default:
        return "On no axis the boxes share more than one number. So one pair alone is nearest.";
    }
  }

  std::string end_caption() const {
    const Vec3 between = (s_.boxes[0].lo + s_.boxes[0].hi - s_.boxes[1].lo - s_.boxes[1].hi) / 2;
    const std::string centres =
        fmt::format("\nThe centres are {} apart. That is no measure of the gap between boxes.", shown(between.norm()));
    if (s_.meet) return "*d*^2 is 0: the boxes meet, and their distance is 0." + centres;
    return fmt::format("The distance itself is √*d*^2 = {}. To compare it with a bound, square the bound.",
                       shown(std::sqrt(squared_))) +
           centres;
  }

  double squared_ = 0, sum_ = 0, largest_ = 0;
};

}  // namespace

Walk boxes(const Setup& s) { return BoxesTeller(s).tell(); }

}  // namespace isect::lessons::distance_lesson
