#include "lessons/relations/telling.h"

#include <fmt/format.h>

#include <algorithm>

#include <isect/sphere_sphere.h>

#include "lessons/relations/pages.h"
#include "lessons/shared/plane.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/relation.h"
#include "lessons/shared/script.h"

namespace isect::lessons::relations_lesson {

using namespace viz;

namespace {

enum class Focus { none, containment, settled };

/// Whether a ball that lies in the other also touches its surface; exact.
bool touches_from_inside(const Pair& pair) {
  const auto *a = std::get_if<Sphere<double, 3>>(&pair.a), *b = std::get_if<Sphere<double, 3>>(&pair.b);
  const bool inside = pair.truth == Relation::a_inside_b || pair.truth == Relation::b_inside_a;
  if (!a || !b || !inside) return false;
  Record<sphere_sphere::Event> record;
  relate(*a, *b, record);
  const auto tangent = [](const auto& event) {
    const auto* e = std::get_if<sphere_sphere::Decision>(&event);
    return e && e->inner == 0;
  };
  return std::ranges::any_of(record.events, tangent);
}

class Teller {
 public:
  Teller(Kind kind, const Pose& pose)
      : pair_(kind, pose),
        pose_(pose),
        they_(they(kind)),
        script_({"Lecture note Intersection Detection, spatial relationships",
                 fmt::format("Two {}, a and b: {}.", name(kind), relation_words(pair_.truth, they_)), note_pseudocode,
                 name(kind)}) {}

  Walk tell() {
    add("pair", fmt::format("Two {}", name(pair_.kind)), 0,
        "The lecture note *Intersection Detection* draws three answers: disjoint, partial intersection, containment.\n"
        "Touching and equality hide among them, and containment has two directions: that makes six.",
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
        if (p) scene.items.push_back(Dot{*p, Mark::ring, Role::miss});

    const Point<double, 2> flat = place(pose_.b);
    const Vec3 b = pair_.kind == Kind::polygons ? in_plane(flat.x(), flat.y()) : pose_.b;
    scene.handles = {{"b", Handle::Kind::point, b, Vec3::Zero(), Role::second},
                     {"size", Handle::Kind::along, b + pose_.size * upwards(), b, Role::second,
                      upwards() / (axis_length * axis_length)}};
    return scene;
  }

  /// Sets the verdict, which the next step shows.
  void settle() { script_.settle(verdict_kind(pair_.truth), relation_words(pair_.truth, they_)); }

  void yes_or_no() {
    Step& step = add(
        "yes-or-no", "A common point?", 0,
        pair_.meet && pair_.kind == Kind::balls && pair_.truth == Relation::touching
            ? "Yes: some point lies in both. The note's pseudocode stops here; of spheres that only touch it returns "
              "DISJOINT."
        : pair_.meet ? "Yes: some point lies in both. The note's pseudocode stops here and returns OVERLAP."
                     : "No point lies in both. Here \"no\" is enough: only one of the six relations is left.\n"
                       "The note calls it exclusion.",
        Focus::none, pair_.meet ? "a ∩ b ≠ ∅" : "a ∩ b = ∅");
    step.decides = true;
    step.question = which_count(
        "A test decides whether they have a common point. How many of the six relations remain?", alike(),
        {{1, "A common point does not mean that they overlap. They may touch, or one may contain the other."},
         {2, pair_.meet ? "Those are partial intersection and containment. Touching and equality remain, too."
                        : "Of the six relations only disjoint has no common point."},
         {5, "Those five have a common point."}},
        pair_.meet ? "They share a point, which rules out only disjoint."
                   : "They share no point, so they are disjoint.");
    if (!pair_.meet) script_.leave_early();
  }

  void what_it_loses() {
    script_.refuse(0, {});
    script_.value("pairs that meet", alike());
    Step& step =
        script_.add("what-it-loses", "What a yes loses", 0,
                    fmt::format("{} of these {} pairs have the same answer: yes. Programs need to distinguish them.\n"
                                "Culling stops at containment: all that is inside is drawn without another test. "
                                "Physics starts at touching. "
                                "Merging of duplicates needs equality.",
                                alike(), situations(pair_.kind).size()));
    step.scene = six(pair_.kind);
  }

  /// How many of the six pairs of this kind have the same answer to "a common point?".
  int alike() const {
    return static_cast<int>(std::ranges::count_if(
        situations(pair_.kind), [&](const Situation& s) { return Pair(pair_.kind, s.pose).meet == pair_.meet; }));
  }

  void containment() {
    using enum Relation;
    const Relation r = pair_.truth;
    const bool a_in_b = r == equal || r == a_inside_b, b_in_a = r == equal || r == b_inside_a;
    const int line = r == equal ? 1 : r == a_inside_b ? 2 : r == b_inside_a ? 3 : 0;
    for (int before = 1; before < (line == 0 ? 4 : line); ++before) script_.refuse(before, {});
    Step& step =
        add("containment", "One inside the other?", line == 0 ? 3 : line, contained_caption(), Focus::containment,
            fmt::format("a ⊆ b: {},  b ⊆ a: {}", a_in_b ? "yes" : "no", b_in_a ? "yes" : "no"));
    step.decides = true;
    step.question = Question{"Which set is a subset of the other?",
                             {"a lies in b", "b lies in a", "each in the other", "neither"},
                             r == equal ? 2
                             : a_in_b   ? 0
                             : b_in_a   ? 1
                                        : 3,
                             r == equal         ? "No point of one lies outside the other."
                             : a_in_b || b_in_a ? "Some point of the larger one lies outside the smaller."
                                                : "Each has a point that lies outside the other."};
  }

  std::string contained_caption() const {
    switch (pair_.truth) {
      case Relation::equal:
        return pair_.kind == Kind::obbs && pose_.turn != "none"
                   ? "Each lies in the other, so the sets are equal. Only their axes are numbered differently."
                   : "Each lies in the other, so the sets are equal.";
      case Relation::a_inside_b:
      case Relation::b_inside_a:
        return (touches_from_inside(pair_)
                    ? "They touch from inside: the surfaces share one point. It is still containment.\n"
                    : "One is a subset of the other.\n") +
               std::string("The note calls containment inclusion. A yes or no test calls it OVERLAP.");
      default:
        return "Each has a point outside the other, so neither contains the other.";
    }
  }

  void interiors() {
    const bool touch = pair_.truth == Relation::touching;
    if (!touch) script_.refuse(4, {});
    Step& step =
        add("interiors", "Do they share interior points?", touch ? 4 : 5,
            touch ? "No: what they share lies on both boundaries. Closed sets include their boundary, so they touch.\n"
                    "The note counts touching boxes as OVERLAP, but touching spheres as DISJOINT."
                  : "Yes: some point is interior to both. What they share is marked.\n"
                    "The note calls it partial intersection.",
            Focus::settled);
    step.decides = true;
    step.question = Question{
        "Which points do they share?",
        {"boundary points only", "interior points, too"},
        touch ? 0 : 1,
        pair_.kind == Kind::polygons
            ? "A point is interior if a small disc around it, in the polygon's plane, lies in the set."
            : "A point is interior if a small ball around it lies in the set. Of a flat set take a disc in its plane."};
  }

  const Pair pair_;
  const Pose pose_;
  const std::string they_;
  Script script_;
};

}  // namespace

Walk questions(Kind kind, const Pose& pose) { return Teller(kind, pose).tell(); }

}  // namespace isect::lessons::relations_lesson
