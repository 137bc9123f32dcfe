#include <algorithm>

#include "lessons/aabb_aabb/picture.h"
#include "lessons/shared/axis_names.h"
#include "lessons/shared/relation.h"
#include "lessons/shared/script.h"

namespace isect::lessons::aabb_aabb_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

const std::vector<std::string> pseudocode = {
    "for each axis i of x, y, z",                     // 0
    "    if a.min_i > b.max_i or b.min_i > a.max_i",  // 1
    "        return DISJOINT",                        // 2
    "return OVERLAP"                                  // 3
};

class Teller {
 public:
  explicit Teller(const Setup& setup)
      : s_(setup),
        script_({"Note, N13", "Two axis-aligned boxes, a and b: " + words(s_.truth, "the boxes") + ".", pseudocode}) {}

  Walk tell() {
    add("three-questions", "Three questions of one dimension", 0,
        "A box is a product of intervals, one an axis. Boxes share a point if their intervals do, on every "
        "axis.\n"
        "The note says \"in x or y or z\". It must be \"and\".",
        -1);
    script_.tell<aabb_aabb::Event<C, 3>>(
        [&](auto& record) { aabb_aabb::by_axis(cast<C>(s_.a), cast<C>(s_.b), record); },
        [&](const auto& event) { say(event); });
    end();
    return std::move(script_.walk());
  }

 private:
  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption, int axis,
            const std::string& formula = {}) {
    Step& step = script_.add(slug, title, line, caption, formula);
    step.scene = picture(s_, axis, false);
    return step;
  }

  void say(const aabb_aabb::Axis<C>& e) {
    const std::string axis = axis_names[e.axis];
    const double a_lo = e.a.lo.value, a_hi = e.a.hi.value, b_lo = e.b.lo.value, b_hi = e.b.hi.value;
    const bool a_first = a_hi < b_lo;
    const double left = a_first ? b_lo : std::max(a_lo, b_lo), right = a_first ? a_hi : std::min(a_hi, b_hi);
    script_.value("common " + axis, right - left, "length", e.disjoint ? Role::miss : Role::hit);
    const std::string formula = e.disjoint ? "gap on " + axis + ": " + shown(std::abs(right - left))
                                           : "common on " + axis + ": " + shown(left) + " to " + shown(right);
    Step& step = add(std::string("axis-") + "xyz"[e.axis], "Do the intervals on " + axis + " overlap?", 1,
                     axis_caption(e.axis, e.disjoint, left == right), e.axis, formula);
    Script::decide(step, {"max(min) ≤ min(max)", std::max(a_lo, b_lo), std::min(a_hi, b_hi), !e.disjoint,
                          e.disjoint ? "a gap on " + axis : "no gap on " + axis});
    step.question = {"Is there a gap between the boxes on " + axis + "?",
                     {"yes", "no"},
                     e.disjoint ? 0 : 1,
                     e.disjoint ? "One interval ends before the other begins." : "The intervals have a common number."};
    disjoint_ = e.disjoint;
  }
  void say(const aabb_aabb::Common<C, 3>&) {}  // of relate, which the lesson does not run

  static std::string axis_caption(int axis, bool disjoint, bool touch) {
    if (disjoint)
      return axis < 2 ? "One gap is enough: the boxes are disjoint, and the other axes need not be tested."
                      : "Only the last axis has a gap. One is enough: the boxes are disjoint.";
    if (touch) return "One interval ends exactly where the other begins. They share that number: no gap.";
    return axis < 2 ? "No gap here. That alone says nothing yet: the next axis may have one."
                    : "No gap on any of the three axes.";
  }

  void end() {
    if (disjoint_) script_.leave_early();
    if (!disjoint_) script_.refuse(1, {2});
    script_.settle(verdict_kind(s_.truth), words(s_.truth, "the boxes"));
    Step& step = script_.add("relation", "How they lie", disjoint_ ? 2 : 3, end_caption());
    step.scene = picture(s_, -1, true);
    step.question = relation_question(s_.truth, "the two boxes", words(s_.truth, "the boxes") + ".");
  }

  std::string end_caption() const {
    if (empty(s_.a) || empty(s_.b))
      return "A box with exchanged corners has no point in it, so it meets nothing.\n"
             "The note's comparisons do not see that: they take it for one.";
    switch (s_.truth) {
      case Relation::disjoint:
        return "Comparisons of the given numbers are exact, so this answer is too.";
      case Relation::touching:
        return "They share points, but none inside both. The sets are closed, so touching counts as OVERLAP.";
      case Relation::equal:
        return "All six numbers agree: the boxes are the same set.";
      case Relation::overlapping:
        return "Only now may OVERLAP be returned. The note's figure returns it after the first axis.\n"
               "What they share is again a box, with the common interval on each axis.";
      default:
        return "What they share is one of the two boxes itself: it lies inside the other.";
    }
  }

  const Setup s_;
  Script script_;
  bool disjoint_ = false;
};

}  // namespace

Walk tell(const Setup& setup) { return Teller(setup).tell(); }

}  // namespace isect::lessons::aabb_aabb_lesson
