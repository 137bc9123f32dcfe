#include "lessons/sphere_aabb/telling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <isect/methods/sphere_aabb.h>
#include "lessons/shared/digits.h"
#include "lessons/shared/line_question.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/relation.h"
#include "lessons/shared/script.h"

namespace isect::lessons::sphere_aabb_lesson {

using namespace viz;
using C = Counted<double>;

namespace {

const std::vector<std::string> pseudocode = {
    "d² ← 0; for each axis i of x, y, z",                     // 0
    "    if c_i < b.min_i: d² ← d² + (c_i − b.min_i)²",       // 1
    "    else if c_i > b.max_i: d² ← d² + (c_i − b.max_i)²",  // 2
    "if d² < r²: return OVERLAP",                             // 3
    "return DISJOINT"                                         // 4
};

const char* const places[] = {"is the centre itself", "lies in a face", "lies on an edge", "is a corner"};

class Teller {
 public:
  explicit Teller(const Setup& setup)
      : s_(setup),
        script_({"Lecture note Intersection Detection, sphere and box; Arvo, Graphics Gems (1990)",
                 fmt::format("A ball and an axis-aligned box: {}.", in_words(s_.truth)) +
                     (empty(s_.box) ? "" : fmt::format(" The box's point nearest to the centre {}.", place())),
                 pseudocode}) {}

  Walk tell() {
    script_.tell<sphere_aabb::Event<C>>(
        [&](auto& record) { sphere_aabb::accumulate_naive(cast<C>(s_.ball), cast<C>(s_.box), record); },
        [&](const auto& event) { say(event); });
    if (s_.truth == Relation::disjoint && s_.in_grown) expanded();
    return std::move(script_.walk());
  }

 private:
  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
            const std::string& formula = {}) {
    Step& step = script_.add(slug, title, line, caption, formula);
    step.scene = picture(s_, shown_);
    return step;
  }

  void say(const sphere_aabb::Axis<C>& e) {
    const std::string letter(1, "xyz"[e.axis]), axis = "*" + letter + "*";
    const double gap = e.gap.value, before = distance2_;
    distance2_ = e.distance2.value;
    shown_.legs = e.axis + 1, shown_.current = true;
    script_.value("*g*_" + letter, gap, "length");
    script_.value("*d*^2", distance2_, "area", Role::highlight);
    const std::string formula = "*d*^2 = " + (e.axis == 0 ? std::string() : shown(before) + " + ") + "(" + shown(gap) +
                                ")^2 = " + shown(distance2_);
    const int line = gap == 0 ? 0 : e.center.value < e.interval.lo.value ? 1 : 2;
    Step& step = add("axis-" + letter, "How far on " + axis + "?", line, axis_caption(e.axis, line, before),
                     e.axis == 0 && gap == 0 ? "*d*^2 = 0" : formula);
    const Interval<double> i = {e.interval.lo.value, e.interval.hi.value};
    const double c = e.center.value, middle = c - (i.lo + i.hi) / 2, far = std::max(c - i.lo, i.hi - c);
    if (e.axis == 0)
      step.question = which_value(
          fmt::format("On {0} the box reaches from {1} to {2}, and **c** has {3}. What does {0} add to *d*^2?", axis,
                      shown(i.lo), shown(i.hi), shown(c)),
          gap * gap,
          {{std::abs(gap), "That is the gap. Its square is added."},
           {middle * middle, "That measures from the middle of the box."},
           {far * far, "That measures from the farther end of the interval."}},
          gap == 0 ? "The box's interval contains the coordinate of **c**: nothing is added."
                   : "The square of the gap between **c** and the nearer end.");
    if (e.axis == 1 && gap != 0)
      ask_for_line(
          script_.walk(),
          fmt::format("On {} the box reaches from {} to {}, and **c** has {}. Which line adds the square of the gap?",
                      axis, shown(i.lo), shown(i.hi), shown(c)),
          {{0, "That line begins with 0 and goes from axis to axis."},
           {1, "**c** does not lie below the interval's lower end."},
           {2, c > i.hi ? "The condition of the line before it holds already."
                        : "**c** does not lie above the interval's upper end."},
           {3, "That line compares the sum with *r*^2, after all axes."}},
          line == 1 ? "**c** lies below the interval's lower end." : "**c** lies above the interval's upper end.");
    gaps_ += std::abs(gap), largest_ = std::max(largest_, gap * gap);
    if (e.axis == 2 && gap != 0) {  // else the sum so far is the answer
      step.question = which_value(
          fmt::format("On {} the box reaches from {} to {}, and **c** has {}. What is *d*^2 after all three axes?",
                      axis, shown(i.lo), shown(i.hi), shown(c)),
          distance2_,
          {{gaps_ * gaps_, "That squares the sum of the gaps. Square each of them, then add."},
           {largest_, "That is the largest of the squares alone."},
           {std::sqrt(distance2_), "That is the distance, and not its square."}},
          "The squares of the three gaps, added up.");
      give_before(script_.walk(), {"*d*^2"});
    }
    shown_.current = false;
  }

  /// `before`: the sum of the earlier axes.
  static std::string axis_caption(int number, int line, double before) {
    const std::string letter(1, "xyz"[number]), axis = "*" + letter + "*", gap = "*g*_" + letter;
    std::string text;
    if (number == 0)
      text =
          "The ball meets the box if and only if it contains **p**, the box's point nearest to **c**: **c** clamped to "
          "the box. So their distance *d* is compared with the radius *r*.\n";
    if (line == 0)
      return text + fmt::format(
                        "The box's interval on {} contains the coordinate of **c**. **p** has the same one: the "
                        "gap {} is 0.",
                        axis, gap);
    text += fmt::format("**c** lies {} on {}, by the gap {}. **p** has that end's coordinate.",
                        line == 1 ? "below the interval's lower end" : "above the interval's upper end", axis, gap);
    return before > 0 ? text + "\nThe legs are at right angles, so their squares add up." : text;
  }

  void say(const sphere_aabb::Compared<C>& e) {
    const double d2 = e.distance2.value, r2 = e.radius2.value;
    const bool near = d2 < r2;
    const char* const sign = near ? " < " : d2 == r2 ? " = " : " > ";
    script_.value("*r*^2", r2, "area", Role::first);
    script_.settle(verdict_kind(s_.truth), in_words(s_.truth));
    if (!near) script_.refuse(3, {});
    shown_.settled = true;
    Step& step =
        add("relation", "Nearer than the radius?", near ? 3 : 4, reach_caption(near) + "\n" + end_caption(near),
            "*d*^2 = " + digits(d2, r2) + sign + digits(r2, d2) + " = *r*^2");
    Script::decide(step,
                   {"*d*^2 < *r*^2", d2, r2, near, near ? "the note returns OVERLAP" : "the note returns DISJOINT"});
    step.question = relation_question(s_.truth, "the ball and the box", because());
    if (s_.ball.radius > 0) step.question->choices.pop_back();  // a ball is not a box
    step.question->given = {{"*d*^2", d2, "area", Role::highlight}, {"*r*^2", r2, "area", Role::first}};
    shown_.settled = false;
  }
  void say(const sphere_aabb::Decision&) {}  // of relate, which the lesson does not run
  void say(const Fallback&) {}

  const char* place() const { return places[s_.feature()]; }

  std::string reach_caption(bool near) const {
    if (empty(s_.box)) return "The box's corners are exchanged.";
    if (s_.gaps() == 0) return "**c** lies in the box, so **p** is **c** itself.";
    const char* const legs[] = {"No leg", "One leg", "Two legs", "Three legs"};
    const char* const reach = s_.truth == Relation::disjoint            ? " The ball does not reach it."
                              : s_.truth == Relation::touching && !near ? " The ball just reaches it."
                                                                        : " The ball reaches it.";
    return fmt::format("{}: the nearest point {}.", legs[s_.gaps()], place()) + reach;
  }

  std::string because() const {
    if (empty(s_.box)) return "An empty box has no point to share.";
    switch (s_.truth) {
      case Relation::disjoint:
        return "Even the box's nearest point lies outside the ball.";
      case Relation::touching:
        return (s_.box.lo.array() == s_.box.hi.array()).any() ? "They share points, but none is interior to both."
                                                              : "They share boundary points, but no interior point.";
      case Relation::a_inside_b:
        return "On every axis **c** lies in the interval, at least *r* away from both ends.";
      case Relation::b_inside_a:
        return "Even the farthest corner lies in the ball.";
      case Relation::equal:
        return "Both are one point, and the same one.";
      case Relation::overlapping:
        break;
    }
    return "*d* < *r*, but the farthest corner lies outside the ball, and some face lies nearer than *r*.";
  }

  std::string end_caption(bool near) const {
    if (empty(s_.box)) return "So it has no point in it, and meets nothing. The note's comparisons do not see that.";
    const bool meets = s_.truth != Relation::disjoint;
    if (meets && !near && s_.truth != Relation::touching)
      return "The note's strict < calls this DISJOINT. With ≤ it would say OVERLAP, unless a square has been rounded.";
    if (!meets && near) return "The note's comparison is wrong here: a square has been rounded.";
    switch (s_.truth) {
      case Relation::touching:
        return near ? "The note's comparison is wrong here: a square has been rounded."
                    : "The note's strict < calls this DISJOINT, yet for boxes it calls touching OVERLAP.\n"
                      "Closed sets include their boundary, so the comparison must be *d*^2 ≤ *r*^2.";
      case Relation::disjoint:
        return "Both sides are squares, so no square root is needed.";
      case Relation::a_inside_b:
        return "OVERLAP does not say that the box contains the ball. That takes a second test: *r* against the "
               "distance to each face.";
      case Relation::b_inside_a:
        return "OVERLAP does not say that the ball contains the box. That takes a second test: the farthest "
               "corner instead of the nearest point.";
      case Relation::equal:
        return "Both are the same point.";
      case Relation::overlapping:
        break;
    }
    return "The part of the box's surface that lies in the ball is marked.";
  }

  /// The tempting shortcut, where it is wrong.
  void expanded() {
    shown_.grown = true;
    add("grown", "Why not expand the box by *r*?", 4,
        "The box expanded by *r* on every side (dashed) contains **c**, so that shortcut says: hit.\n"
        "The right set of centres is the Minkowski sum of box and ball: all sums of a point of each. It has rounded "
        "edges and corners.");
  }

  const Setup s_;
  Script script_;
  Shown shown_;
  double distance2_ = 0, gaps_ = 0, largest_ = 0;
};

}  // namespace

std::string in_words(Relation r) {
  if (r == Relation::a_inside_b) return "the ball lies inside the box";
  if (r == Relation::b_inside_a) return "the box lies inside the ball";
  return relation_words(r, "the ball and the box");
}

Walk tell(const Setup& setup) { return Teller(setup).tell(); }

}  // namespace isect::lessons::sphere_aabb_lesson
