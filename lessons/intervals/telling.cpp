#include <fmt/format.h>

#include <algorithm>

#include "lessons/intervals/picture.h"
#include "lessons/shared/common_length.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/questions.h"
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
bool one_is_empty(const Setup& s) { return empty(s.a) || empty(s.b); }
std::string they(const Setup& s) { return points(s) ? "the points" : "the intervals"; }

std::string alt(const Setup& s) {
  if (points(s))
    return "Two points on a number line, a at " + digits(s.a.lo, s.b.lo) + " and b at " + digits(s.b.lo, s.a.lo) +
           ": " + relation_words(s.truth, they(s)) + ".";
  const auto end = [&](double x) {
    for (const double other : {s.a.lo, s.a.hi, s.b.lo, s.b.hi})
      if (digits(x, other) != shown(x)) return digits(x, other);
    return shown(x);
  };
  const auto ends = [&](const Interval<double>& i) { return " from " + end(i.lo) + " to " + end(i.hi); };
  return "Two intervals above a number line, a" + ends(s.a) + " and b" + ends(s.b) + ": " +
         relation_words(s.truth, they(s)) + ".";
}

class Teller {
 public:
  explicit Teller(const Setup& setup)
      : s_(setup), script_({"Lecture note Intersection Detection, intervals", alt(setup), pseudocode}) {}

  Walk tell() {
    script_.tell<interval_interval::Event<C>>(
        [&](auto& record) { interval_interval::ends(cast<C>(s_.a), cast<C>(s_.b), record); },
        [&](const auto& event) { say(event); });
    script_.settle(verdict_kind(s_.truth), relation_words(s_.truth, they(s_)));
    if (line_ < 4) script_.leave_early();
    Step& step = script_.add("relation", "How they relate", line_, end_caption(), end_formula());
    step.scene = picture(s_, {}, true);
    if (line_ == 4 && !points(s_))
      step.question = relation_question(s_.truth, they(s_), because());  // else the answer is known
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
    Script::decide(step, {low + " > " + high, lo, hi, e.holds, e.holds ? "DISJOINT" : "no gap on this side"});
    line_ = e.holds ? (first ? 1 : 3) : 4;
    if (!e.holds) script_.refuse(first ? 0 : 2, {first ? 1 : 3});
    if (!first && !one_is_empty(s_) && !points(s_)) {
      step.question = common_length_question(fmt::format("a reaches from {} to {}, b from {} to {}.", shown(s_.a.lo),
                                                         shown(s_.a.hi), shown(s_.b.lo), shown(s_.b.hi)),
                                             s_.a, s_.b);
      if (step.question) return;
    }
    // OVERLAP after one comparison: that one side decides all.
    step.question = Question{fmt::format("{} is compared with {}. What does the note's test conclude?", low, high),
                             {"DISJOINT", "OVERLAP", "nothing yet"},
                             e.holds ? 0
                             : first ? 2
                                     : 1,
                             e.holds ? "One begins after the other has ended. Nothing else need be tested."
                             : first ? "a does not begin after b has ended. The other side is still open."
                                     : "Neither begins after the other has ended."};
    step.question->given = {{low, lo, "length", first ? Role::first : Role::second},
                            {high, hi, "length", first ? Role::second : Role::first}};
  }
  void say(const interval_interval::Common<C>&) {}  // of relate, which the lesson does not run

  std::string caption(bool first, bool holds, bool equal) const {
    if (holds && one_is_empty(s_)) return "Yes, and the test ends here. " + reversed();
    if (holds) return "Yes: a gap lies between them. The test ends with the first gap it finds.";
    if (!first && one_is_empty(s_)) return "No again, so the note's test concludes that they overlap.\n" + reversed();
    if (equal && first) return "The ends are equal. Closed intervals include their ends, so no gap lies on this side.";
    if (first) return "No. Whether they overlap is still open: the gap may lie on the other side.";
    return "No again. Not (*a*_{min} > *b*_{max} or *b*_{min} > *a*_{max}) means *a*_{min} ≤ *b*_{max} and "
           "*b*_{min} ≤ *a*_{max}.\n"
           "Neither interval is empty. So the larger lower end is at most the smaller upper end: a common number.";
  }

  /// A sentence on which of the intervals has its ends exchanged.
  std::string reversed() const {
    if (empty(s_.a) && empty(s_.b)) return "Both intervals end before they begin: they are empty.";
    return fmt::format("Yet {} ends before it begins: it is empty.", empty(s_.a) ? "a" : "b");
  }

  std::string because() const {
    if (one_is_empty(s_)) return "An empty interval has no number to share.";
    switch (s_.truth) {
      case Relation::disjoint:
        return "One ends before the other begins.";
      case Relation::touching:
        return "They share one number, an end of both.";
      case Relation::equal:
        return "Both ends agree.";
      case Relation::overlapping:
        return "They share more than one number, and each has some that the other lacks.";
      default:
        return "Both ends of one lie in the other.";
    }
  }

  std::string end_caption() const {
    if (one_is_empty(s_))
      return "An interval with exchanged ends has no number in it, so it meets nothing.\n"
             "The note's comparisons do not see that: they treat it as an ordinary interval.\n"
             "Best stored as [∞, −∞], an empty one has a gap to each bounded one. The union with it changes nothing.";
    if (points(s_) && s_.truth == Relation::equal)
      return "A point is an interval of one number. Points are equal if their coordinates are, exactly.";
    if (points(s_) && s_.a.lo == 0.1 + 0.2 && s_.b.lo == 0.3)
      return "0.1 + 0.2 and 0.3 are different doubles, about 5.6 · 10^{−17} apart.\n"
             "For computed numbers, the caller chooses a tolerance.";
    switch (s_.truth) {
      case Relation::disjoint:
        return "At most two comparisons decide. They are exact, as they only look at the given numbers.";
      case Relation::touching:
        return "They share one number, but no interior point. The note counts it as OVERLAP, and so do we.";
      case Relation::equal:
        return "Both ends agree: the intervals are the same set.";
      case Relation::overlapping:
        return "They share the numbers from the larger lower end to the smaller upper end.";
      default:
        return "OVERLAP does not say it, but one interval lies inside the other.\n"
               "They share exactly the inner one.";
    }
  }

  std::string end_formula() const {
    if (one_is_empty(s_)) return {};
    const double lo = std::max(s_.a.lo, s_.b.lo), hi = std::min(s_.a.hi, s_.b.hi);
    if (lo > hi) return "gap: " + digits(hi, lo) + " to " + digits(lo, hi) + ", length " + shown(lo - hi);
    return lo == hi ? "common: " + shown(lo) : "common: " + digits(lo, hi) + " to " + digits(hi, lo);
  }

  const Setup s_;
  Script script_;
  int asked_ = 0, line_ = 4;
};

}  // namespace

Walk tell(const Setup& setup) { return Teller(setup).tell(); }

}  // namespace isect::lessons::intervals_lesson
