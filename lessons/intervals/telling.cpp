#include <algorithm>

#include "lessons/intervals/picture.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/relation.h"
#include "lessons/shared/script.h"

namespace isect::lessons::intervals_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

const std::vector<std::string> pseudocode = {
    "if a_min > b_max",     // 0
    "    return DISJOINT",  // 1
    "if b_min > a_max",     // 2
    "    return DISJOINT",  // 3
    "return OVERLAP"        // 4
};

bool points(const Setup& s) { return s.a.lo == s.a.hi && s.b.lo == s.b.hi; }
std::string they(const Setup& s) { return points(s) ? "the points" : "the intervals"; }

class Teller {
 public:
  explicit Teller(const Setup& setup)
      : s_(setup),
        script_({"Note, N12 and N11", "a and b above a number line: " + words(s_.truth, they(s_)) + ".", pseudocode}) {}

  Walk tell() {
    script_.tell<interval_interval::Event<C>>(
        [&](auto& record) { interval_interval::ends(cast<C>(s_.a), cast<C>(s_.b), record); },
        [&](const auto& event) { say(event); });
    script_.settle(verdict_kind(s_.truth), words(s_.truth, they(s_)));
    if (line_ < 4) script_.leave_early();
    Step& step = script_.add("relation", "How they lie", line_, end_caption(), end_formula());
    step.scene = picture(s_, {}, true);
    step.question = relation_question(s_.truth, they(s_), words(s_.truth, they(s_)) + ".");
    return std::move(script_.walk());
  }

 private:
  void say(const interval_interval::Beyond<C>& e) {
    const bool first = asked_++ == 0;
    const double lo = e.lo.value, hi = e.hi.value;
    const std::string low = first ? "*a*_{min}" : "*b*_{min}", high = first ? "*b*_{max}" : "*a*_{max}";
    script_.value(low, lo, "length", first ? Role::first : Role::second);
    script_.value(high, hi, "length", first ? Role::second : Role::first);
    Step& step = script_.add(first ? "a-beyond-b" : "b-beyond-a",
                             first ? "Does a begin after b has ended?" : "Does b begin after a has ended?",
                             first ? 0 : 2, caption(first, e.holds, lo == hi),
                             low + " = " + digits(lo, hi) + (e.holds ? " > " : " ≤ ") + digits(hi, lo) + " = " + high);
    step.scene = picture(s_, Vec2(lo, hi), false);
    Script::decide(step, {low + " > " + high, lo, hi, e.holds, e.holds ? "a gap between them" : "no gap on this side"});
    line_ = e.holds ? (first ? 1 : 3) : 4;
    if (!e.holds) script_.refuse(first ? 0 : 2, {first ? 1 : 3});
  }
  void say(const interval_interval::Common<C>&) {}  // of relate, which the lesson does not run

  static std::string caption(bool first, bool holds, bool equal) {
    if (holds) return "Yes: a gap lies between them. The test ends with the first gap it finds.";
    if (equal) return "The ends are equal. Intervals are closed, so that number belongs to both: no gap.";
    return first ? "No. Whether they overlap is still open: the gap may lie on the other side."
                 : "No again. Without a gap on either side they must have a common number.";
  }

  std::string end_caption() const {
    if (empty(s_.a) || empty(s_.b))
      return "An interval with exchanged ends has no number in it, so it meets nothing.\n"
             "The note's comparisons do not see that: they take it for one.";
    if (points(s_) && s_.truth == Relation::equal)
      return "A point is an interval of one number. Points are equal if their coordinates are, exactly.\n"
             "With a tolerance, a may equal b and b equal c, but not a equal c.";
    if (points(s_))
      return "0.1 + 0.2 and 0.3 are different doubles, and the test says so.\n"
             "Their distance is about 5.6 · 10⁻¹⁷. Whoever wants \"near\" must say how near.";
    switch (s_.truth) {
      case Relation::disjoint:
        return "Two comparisons decide, at most. They are exact, as they only look at the given numbers.";
      case Relation::touching:
        return "They share one number, but no interior point. The note counts it as OVERLAP, and so do we.";
      case Relation::equal:
        return "Both ends agree: the intervals are the same set.";
      case Relation::overlapping:
        return "They share the numbers from the larger lower end to the smaller upper end.";
      default:
        return "OVERLAP does not say it, but one interval lies inside the other.\n"
               "What they share is that inner one itself.";
    }
  }

  std::string end_formula() const {
    const double lo = std::max(s_.a.lo, s_.b.lo), hi = std::min(s_.a.hi, s_.b.hi);
    if (lo > hi) return "gap: " + shown(lo - hi);
    return lo == hi ? "common: " + shown(lo) : "common: " + shown(lo) + " to " + shown(hi);
  }

  const Setup s_;
  Script script_;
  int asked_ = 0, line_ = 4;
};

}  // namespace

Walk tell(const Setup& setup) { return Teller(setup).tell(); }

}  // namespace isect::lessons::intervals_lesson
