#include <algorithm>
#include <cmath>

#include <isect/methods/aabb_aabb.h>

#include "lessons/aabb_aabb/picture.h"
#include "lessons/shared/axis_names.h"
#include "lessons/shared/common_length.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/questions.h"
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
        script_({"Lecture note Intersection Detection, axis-aligned boxes",
                 "Two axis-aligned boxes, a and b: " + relation_words(s_.truth, "the boxes") + ".", pseudocode}) {}

  Walk tell() {
    add("three-questions", "Three one-dimensional questions", 0,
        "A box is a product of intervals, one for each axis. So boxes share a point if and only if their intervals do, "
        "on "
        "every axis.\n"
        "The lecture note *Intersection Detection* says \"in x or y or z\". It must be \"and\".",
        -1, "a_{min} ≤ a_{max} on each axis");
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
    const std::string axis = axis_names[e.axis], i = std::string("_{") + "xyz"[e.axis] + "}";
    const Interval<double> a = {e.a.lo.value, e.a.hi.value}, b = {e.b.lo.value, e.b.hi.value};
    const bool a_later = a.lo - b.hi > b.lo - a.hi;  // the comparison of the two that is nearer to a gap
    const double lo = a_later ? a.lo : b.lo, hi = a_later ? b.hi : a.hi;
    const bool one_is_empty = empty(a) || empty(b);
    const double left = std::max(a.lo, b.lo), right = std::min(a.hi, b.hi);
    if (!one_is_empty)
      script_.value((e.disjoint ? "length of the gap on " : "common length on ") + axis, std::abs(right - left),
                    "length", e.disjoint ? Role::miss : Role::hit);
    const std::string formula =
        one_is_empty    ? std::string()
        : e.disjoint    ? "gap on " + axis + ": " + digits(right, left) + " to " + digits(left, right)
        : left == right ? "common on " + axis + ": " + shown(left)
                        : "common on " + axis + ": " + digits(left, right) + " to " + digits(right, left);
    Step& step = add(std::string("axis-") + "xyz"[e.axis], "Do the intervals on " + axis + " overlap?", 1,
                     axis_caption(e.axis, e.disjoint, a, b), e.axis, formula);
    const std::string a_after_b = "a.min" + i + " > b.max" + i, b_after_a = "b.min" + i + " > a.max" + i;
    Script::decide(step, {a_later ? a_after_b : b_after_a, lo, hi, e.disjoint,
                          e.disjoint ? "a gap on " + axis
                                     : "nor " + (a_later ? b_after_a : a_after_b) + ", so no gap on " + axis});
    disjoint_ = e.disjoint;
    ++asked_;
    if (e.axis > 0 && !empty(s_.a) && !empty(s_.b)) {
      const std::string told = fmt::format("On {} a reaches from {} to {}, b from {} to {}.", axis, shown(a.lo),
                                           shown(a.hi), shown(b.lo), shown(b.hi));
      step.question = e.axis == 1 ? common_length_question(told, a, b) : volume_question(told);
      if (step.question) return;
    }
    // OVERLAP too early: that one common interval is enough, the note's slip.
    step.question = Question{fmt::format("The intervals on {} are compared. What follows?", axis),
                             {"DISJOINT", "OVERLAP", "nothing yet"},
                             e.disjoint   ? 0
                             : e.axis < 2 ? 2
                                          : 1,
                             e.disjoint   ? "One interval ends before the other begins."
                             : e.axis < 2 ? "No gap on this axis, but the next may have one."
                                          : "No gap on any axis."};
    step.question->given = {{"a.min" + i, a.lo, "length", Role::first},
                            {"a.max" + i, a.hi, "length", Role::first},
                            {"b.min" + i, b.lo, "length", Role::second},
                            {"b.max" + i, b.hi, "length", Role::second}};
  }

  /// Asks for the volume that the boxes share, after the last axis. None where the lengths, as shown, do not give it.
  std::optional<Question> volume_question(const std::string& told) const {
    double lengths[3] = {}, sum = 0, volume = 1, read = 1;
    for (const int i : {0, 1, 2}) {
      const Interval<double> a = s_.a.along(i), b = s_.b.along(i);
      lengths[i] = std::max(common_length(a, b), 0.0);
      sum += lengths[i], volume *= lengths[i];
      read *= i < 2 ? as_read(lengths[i]) : std::max(common_length_read(a, b), 0.0);
    }
    if (!std::isfinite(volume) || !read_well(read, volume)) return {};
    return which_value(told + " What is the volume of what the boxes share?", volume,
                       {{lengths[2], "That is the common length on *z* alone."},
                        {lengths[0] * lengths[1], "That leaves out *z*."},
                        {sum, "That adds the common lengths."},
                        {volume_of(s_.a), "That is the volume of a alone."},
                        {volume_of(s_.b), "That is the volume of b alone."}},
                       volume == 0 ? "On some axis they share no length, and so no volume."
                                   : "It is a box: the product of the common lengths on the three axes.");
  }
  static double volume_of(const Box& box) { return (box.hi - box.lo).prod(); }

  void say(const aabb_aabb::Common<C, 3>&) {}  // of relate, which the lesson does not run

  std::string axis_caption(int axis, bool disjoint, const Interval<double>& a, const Interval<double>& b) const {
    if (disjoint) {
      const std::string gap = empty(a) || empty(b) ? "The comparison holds, so the test ends: " : "One gap is enough: ";
      return gap + (axis == 0   ? "DISJOINT, and the other two axes need not be tested."
                    : axis == 1 ? "DISJOINT, and the last axis need not be tested."
                                : "DISJOINT, at the last axis.");
    }
    if (empty(a) || empty(b)) return "The comparisons find no gap, yet an interval here ends before it begins.";
    if (a.hi == b.lo || b.hi == a.lo)
      return "One interval ends exactly where the other begins. They share that number: no gap.";
    return axis < 2 ? "No gap here. That alone says nothing yet: the next axis may have one."
                    : "No gap on any of the three axes.";
  }

  void end() {
    if (disjoint_) script_.leave_early();
    if (!disjoint_) script_.refuse(1, {2});
    script_.settle(verdict_kind(s_.truth), relation_words(s_.truth, "the boxes"));
    Step& step = script_.add("relation", "How they lie", disjoint_ ? 2 : 3, end_caption(), end_formula());
    step.scene = picture(s_, -1, true);
    if (!disjoint_) step.question = relation_question(s_.truth, "the two boxes", because());  // else it is known
  }

  std::string because() const {
    if (empty(s_.a) || empty(s_.b)) return "An empty box has no point to share.";
    switch (s_.truth) {
      case Relation::disjoint:
        return "Some axis has a gap.";
      case Relation::touching:
        return "No axis has a gap, but on at least one they share a single number, an end of both.";
      case Relation::equal:
        return "All six numbers agree.";
      case Relation::overlapping:
        return flat(s_.a) || flat(s_.b)
                   ? "No axis has a gap, a point is interior to both, and each extends beyond the other on some axis."
                   : "On every axis they share a length, and each extends beyond the other on some axis.";
      default:
        return "On every axis one interval lies inside the other, and always that of the same box.";
    }
  }

  static bool flat(const Box& box) { return (box.lo.array() == box.hi.array()).any(); }

  std::string end_caption() const {
    if (empty(s_.a) || empty(s_.b))
      return "A box with exchanged corners has no point in it, so it meets nothing.\n"
             "The note's comparisons do not see that: they treat it as an ordinary box.";
    switch (s_.truth) {
      case Relation::disjoint:
        return asked_ == 1 ? "Disjoint after one axis. Rejecting is cheap; accepting takes all three.\n"
                             "Comparisons of given numbers are exact, so this answer is too."
                           : "The note's figure returns OVERLAP after the first axis. It would be wrong here.\n"
                             "OVERLAP may be returned only after the loop.";
      case Relation::touching:
        return std::string(flat(s_.a) || flat(s_.b) ? "They share points, but none is interior to both."
                                                    : "They share boundary points, but no interior point.") +
               " Closed sets include their boundary, so touching counts as OVERLAP.";
      case Relation::equal:
        return "All six numbers agree: the boxes are the same set.";
      case Relation::overlapping:
        return "Only now may OVERLAP be returned. The note's figure returns it after the first axis.\n"
               "What they share is again a box, with the common interval on each axis.";
      default:
        return "OVERLAP does not say that one lies inside the other. That takes two more comparisons per axis.\n"
               "What they share is the inner box itself.";
    }
  }

  std::string end_formula() const {
    if (s_.truth == Relation::b_inside_a) return "b ⊆ a: a.min_i ≤ b.min_i and b.max_i ≤ a.max_i on each axis *i*";
    if (s_.truth == Relation::a_inside_b) return "a ⊆ b: b.min_i ≤ a.min_i and a.max_i ≤ b.max_i on each axis *i*";
    return {};
  }

  const Setup s_;
  Script script_;
  bool disjoint_ = false;
  int asked_ = 0;  ///< axes
};

}  // namespace

Walk tell(const Setup& setup) { return Teller(setup).tell(); }

}  // namespace isect::lessons::aabb_aabb_lesson
