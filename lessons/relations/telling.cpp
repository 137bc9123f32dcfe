#include "lessons/relations/telling.h"

#include <fmt/format.h>

#include <algorithm>

#include "lessons/relations/pages.h"
#include "lessons/shared/plane.h"
#include "lessons/shared/relation.h"
#include "lessons/shared/script.h"

namespace isect::lessons::relations_lesson {

using namespace viz;

namespace {

enum class Focus { none, containment, settled };

class Teller {
 public:
  Teller(Kind kind, const Pose& pose)
      : pair_(kind, pose),
        pose_(pose),
        they_(they(kind)),
        script_({"Note, N02", fmt::format("Two {}, a and b: {}.", name(kind), words(pair_.truth, they_)), pseudocode,
                 name(kind)}) {}

  Walk tell() {
    add("pair", fmt::format("Two {}", name(pair_.kind)), 0,
        "Do the two share space? The note draws three answers: no, partly, or one within the other.\n"
        "Two more hide among these: touching, and being equal.",
        Focus::none);
    const Relation r = pair_.truth;
    if (!pair_.meet) settle();
    yes_or_no();
    if (pair_.meet) {
      what_it_loses();
      const bool apart = r == Relation::touching || r == Relation::overlapping;
      if (!apart) settle();
      containment();
      if (apart) settle();
      if (apart) interiors();
    }
    return std::move(script_.walk());
  }

 private:
  Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption, Focus focus,
            const std::string& formula = {}) {
    Step& step = script_.add(slug, title, line, caption, formula);
    step.scene = picture(focus);
    return step;
  }

  /// Polygons lie flat on the page, so their names have fixed places.
  Item name_of(const Shape& shape, const Vec3& direction, const char* name, Role role) const {
    const Vec3 at = farthest(shape, direction);
    if (pair_.kind != Kind::polygons) return Label{at, name, role};
    return viz::Heading{at + 0.2 * direction.normalized(), name, role, 0, false};
  }

  Scene picture(Focus focus) const {
    Scene scene;
    scene.items = drawn(pair_, focus == Focus::settled);
    const bool equal = pair_.truth == Relation::equal;
    const Vec3 high_left = upwards() - across(), high_right = across() + upwards();
    scene.items.push_back(name_of(pair_.a, high_left, equal ? "a = b" : "a", Role::first));
    if (!equal) scene.items.push_back(name_of(pair_.b, high_right, "b", Role::second));
    if (focus == Focus::containment)
      for (const auto& p : {left_over(pair_.a, pair_.b), left_over(pair_.b, pair_.a)})
        if (p) scene.items.push_back(Dot{*p, Mark::cross, Role::miss});

    const Point<double, 2> flat = place(pose_.b);
    const Vec3 b = pair_.kind == Kind::polygons ? in_plane(flat.x(), flat.y()) : pose_.b;
    scene.handles = {{"b", Handle::Kind::point, b, Vec3::Zero(), Role::second},
                     {"size", Handle::Kind::along, b + pose_.size * upwards(), b, Role::second,
                      upwards() / (axis_length * axis_length)}};
    return scene;
  }

  /// The next step tells how they lie.
  void settle() { script_.settle(verdict_kind(pair_.truth), words(pair_.truth, they_)); }

  void yes_or_no() {
    Step& step = add("yes-or-no", "A common point?", 0,
                     pair_.meet ? "Yes: some point lies in both. This is all that the note's pseudocode tells."
                                : "No point lies in both. Here \"no\" says it all: the sets are disjoint.\n"
                                  "Exclusion, in the note's words.",
                     Focus::none, pair_.meet ? "a ∩ b ≠ ∅" : "a ∩ b = ∅");
    step.decides = true;
    step.question = Question{"Do " + they_ + " have a common point?",
                             {"yes", "no"},
                             pair_.meet ? 0 : 1,
                             "The exact test decides; a single point is enough."};
    if (!pair_.meet) script_.leave_early();
  }

  void what_it_loses() {
    script_.refuse(0, {});
    const auto& all = situations(pair_.kind);
    const auto yes = std::ranges::count_if(all, [&](const Situation& s) { return Pair(pair_.kind, s.pose).meet; });
    script_.value("pairs that meet", static_cast<double>(yes));
    Step& step = script_.add(
        "what-it-loses", "What a yes loses", 0,
        fmt::format("{} of these {} pairs have the same answer: yes.\n"
                    "A hierarchy may stop where one contains the other, and physics starts where two touch. A "
                    "good test tells them apart.",
                    yes, all.size()));
    step.scene = six(pair_.kind);
  }

  void containment() {
    using enum Relation;
    const Relation r = pair_.truth;
    const bool a_in_b = r == equal || r == a_inside_b, b_in_a = r == equal || r == b_inside_a;
    const int line = r == equal ? 1 : r == a_inside_b ? 2 : r == b_inside_a ? 3 : 0;
    for (int before = 1; before < (line == 0 ? 4 : line); ++before) script_.refuse(before, {});
    Step& step =
        add("containment", "One within the other?", line == 0 ? 3 : line, contained_caption(), Focus::containment,
            fmt::format("a ⊆ b: {},  b ⊆ a: {}", a_in_b ? "yes" : "no", b_in_a ? "yes" : "no"));
    step.decides = true;
    step.question = Question{"Does each point of one lie in the other?",
                             {"a lies in b", "b lies in a", "each in the other", "neither"},
                             r == equal ? 2
                             : a_in_b   ? 0
                             : b_in_a   ? 1
                                        : 3,
                             "A cross marks a point of one that the other does not hold."};
  }

  std::string contained_caption() const {
    switch (pair_.truth) {
      case Relation::equal:
        return pair_.kind == Kind::obbs && pose_.turn != "none"
                   ? "Each lies in the other, so the sets are equal. Their axes are numbered differently: "
                     "sets "
                     "know nothing of that."
                   : "Each lies in the other, so the sets are equal.";
      case Relation::a_inside_b:
      case Relation::b_inside_a:
        return "The smaller one is a subset of the larger. The larger has points left over, as the cross "
               "shows.\n"
               "Containment is the note's inclusion. A yes or no test calls it OVERLAP.";
      default:
        return "Each has a point that the other does not hold: the crosses. Neither contains the other.";
    }
  }

  void interiors() {
    const bool touch = pair_.truth == Relation::touching;
    if (!touch) script_.refuse(4, {});
    Step& step =
        add("interiors", "Do they share inner points?", touch ? 4 : 5,
            touch ? "No: what they share lies on both boundaries. Our sets are closed, so it counts: they touch.\n"
                    "The note counts touching boxes as OVERLAP, but touching spheres as DISJOINT."
                  : "Yes: some point lies inside both, not just on the boundaries. Green is what they share.\n"
                    "The note's partial intersection.",
            Focus::settled);
    step.decides = true;
    step.question = Question{"Does a point lie inside both?",
                             {"yes", "no, only on the boundaries"},
                             touch ? 1 : 0,
                             "An inner point is one with room around it."};
  }

  const Pair pair_;
  const Pose pose_;
  const std::string they_;
  Script script_;
};

}  // namespace

Walk questions(Kind kind, const Pose& pose) { return Teller(kind, pose).tell(); }

}  // namespace isect::lessons::relations_lesson
