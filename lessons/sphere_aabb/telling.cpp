#include "lessons/sphere_aabb/telling.h"

#include <fmt/format.h>

#include <isect/sphere_aabb_methods.h>
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
        script_({"Note, N15; Arvo, Graphics Gems (1990)",
                 fmt::format("A ball and an axis-aligned box: {}. The box's point nearest to the centre {}.",
                             in_words(s_.truth), places[s_.gaps()]),
                 pseudocode}) {}

  Walk tell() {
    script_.tell<sphere_aabb::Event<C>>(
        [&](auto& record) { sphere_aabb::accumulate(cast<C>(s_.ball), cast<C>(s_.box), record); },
        [&](const auto& event) { say(event); });
    if (s_.truth == Relation::disjoint && s_.in_grown) grown();
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
    Step& step = add("axis-" + letter, "How far on " + axis + "?", line, axis_caption(e.axis, line, gap, before),
                     e.axis == 0 && gap == 0 ? "*d*^2 = 0" : formula);
    step.question = {"What does " + axis + " add to the squared distance?",
                     {"nothing", "a square greater than 0"},
                     gap == 0 ? 0 : 1,
                     gap == 0 ? "The box's interval holds the coordinate of **c**."
                              : "**c** lies beside the box's interval, so the gap counts."};
    shown_.current = false;
  }

  /// `before`: the sum of the earlier axes.
  static std::string axis_caption(int number, int line, double gap, double before) {
    const std::string axis = std::string("*") + "xyz"[number] + "*";
    std::string text;
    if (number == 0) text = "The ball meets the box exactly if it holds the box's point nearest to its centre **c**.\n";
    if (line == 0)
      return text + "The box's interval on " + axis +
             " holds the coordinate of **c**. The nearest point has the same one.";
    text += fmt::format("**c** lies {} on {}. The nearest point has that end's coordinate, {} away.",
                        line == 1 ? "below the interval's lower end" : "above the interval's upper end", axis,
                        shown(std::abs(gap)));
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
        add("relation", "Nearer than the radius?", near ? 3 : 4, reach_caption(d2, near) + "\n" + end_caption(),
            "*d*^2 = " + shown(d2) + sign + shown(r2) + " = *r*^2");
    Script::decide(
        step, {"*d*^2 < *r*^2", d2, r2, near, near ? "the nearest point lies in the ball" : "the note says: disjoint"});
    step.question = relation_question(s_.truth, "the ball and the box", because());
    shown_.settled = false;
  }
  void say(const sphere_aabb::Decision&) {}  // of relate, which the lesson does not run
  void say(const Fallback&) {}

  std::string reach_caption(double d2, bool near) const {
    if (d2 == 0) return "**c** lies in the box, so its nearest point is **c** itself.";
    const char* const legs[] = {"No leg", "One leg", "Two legs", "Three legs"};
    const auto gaps = static_cast<std::size_t>(s_.gaps());
    const char* const reach = near                             ? " The ball reaches further."
                              : s_.truth == Relation::touching ? " The ball just reaches it."
                                                               : " The ball does not reach it.";
    return fmt::format("{}: the nearest point {}.", legs[gaps], places[gaps]) + reach;
  }

  std::string because() const {
    switch (s_.truth) {
      case Relation::disjoint:
        return "Even the box's nearest point lies outside the ball.";
      case Relation::touching:
        return "*d* = *r*: the nearest point is the only common one.";
      case Relation::a_inside_b:
        return "On every axis, both ends of the interval are at least *r* away from **c**.";
      case Relation::b_inside_a:
        return "Even the farthest corner lies in the ball.";
      default:
        return "*d* < *r*, but the farthest corner lies outside the ball, and some face lies nearer than "
               "*r*.";
    }
  }

  std::string end_caption() const {
    if (empty(s_.box))
      return "A box with exchanged corners has no point in it, so it meets nothing.\n"
             "The note's comparisons do not see that.";
    switch (s_.truth) {
      case Relation::touching:
        return "The note's strict < calls this DISJOINT, yet for boxes it calls touching OVERLAP.\n"
               "Ours is one rule: sets are closed, so a common point is an intersection.";
      case Relation::disjoint:
        return "Both sides are squares, so no root is needed.";
      case Relation::a_inside_b:
        return "OVERLAP does not say that the box holds the ball. That takes a second test: *r* against the "
               "distance to each face.";
      case Relation::b_inside_a:
        return "OVERLAP does not say that the ball holds the box. That takes a second test: the farthest "
               "corner instead of the nearest point.";
      default:
        return "Green is the part of the box's surface that lies in the ball.";
    }
  }

  /// The tempting shortcut, where it is wrong.
  void grown() {
    shown_.grown = true;
    add("grown", "Why not grow the box by *r*?", -1,
        "The box grown by *r* on every side (dashed) holds **c**. That shortcut says: hit.\n"
        "Near edges and corners the right set is rounded: a ball of radius *r* around the nearest point.");
  }

  const Setup s_;
  Script script_;
  Shown shown_;
  double distance2_ = 0;
};

}  // namespace

std::string in_words(Relation r) {
  if (r == Relation::a_inside_b) return "the ball lies inside the box";
  if (r == Relation::b_inside_a) return "the box lies inside the ball";
  return words(r, "the ball and the box");
}

Walk tell(const Setup& setup) { return Teller(setup).tell(); }

}  // namespace isect::lessons::sphere_aabb_lesson
