// Oriented boxes by separating axes (N07, N04): the classical fifteen, in three groups.

#include "core/obb_obb.h"

#include <fmt/format.h>

#include "core/obb_obb_methods.h"
#include "lessons/case_map.h"
#include "lessons/obb_obb/picture.h"
#include "lessons/relation.h"
#include "lessons/script.h"

namespace isect::lessons {

const viz::Lesson& obb_obb();

namespace {

using namespace viz;
using namespace obb_obb_lesson;
using C = Counted<double>;
using Compared = obb_obb::Compared<C>;
using obb_obb::Kind;

const std::vector<std::string> pseudocode = {
    "t ← b − a; q_ij ← |a_i · b_j| + ε",            // 0
    "for each of the 3 normals l of a",             // 1
    "    if |l · t| > r_a + r_b: return DISJOINT",  // 2
    "for each of the 3 normals l of b",             // 3
    "    if |l · t| > r_a + r_b: return DISJOINT",  // 4
    "for each of the 9 products l = a_i × b_j",     // 5
    "    if |l · t| > r_a + r_b: return DISJOINT",  // 6
    "return OVERLAP"                                // 7
};
constexpr double noise = 1e-9;  ///< a product of edges shorter than this is drawn as edges alone

struct Group {
  Kind kind;
  const char *slug, *title, *of;
  int line, size;
};
const Group groups[] = {{Kind::face_of_a, "normals-a", "The normals of a", "the normals of a", 1, 3},
                        {Kind::face_of_b, "normals-b", "The normals of b", "the normals of b", 3, 3},
                        {Kind::edges, "edges", "The products of edges", "the nine products", 5, 9}};

std::string in_words(Relation r) { return words(r, "the boxes"); }

class Telling {
 public:
  explicit Telling(const Setup& setup)
      : s_(setup),
        script_({"Note, N07; Gottschalk, Lin, Manocha (1996)",
                 "Two oriented boxes, a and b: " + in_words(s_.truth) + ".", pseudocode}) {}

  Walk walk() {
    Step& first =
        script_.add("axes", "Which axes can separate?", 0,
                    "Convex sets are disjoint exactly if some axis separates their projections.\n"
                    "For boxes 15 axes suffice: 3 normals of a, 3 of b, and 9 products of an edge of each.",
                    "|**l** · **t**| > *r*_a + *r*_b separates");
    first.scene = picture(s_, Focus::centers);
    CountingRecord<std::variant<Compared>> record;
    tally() = {};
    overlap_ = obb_obb::gottschalk(cast<C>(s_.a), cast<C>(s_.b), C(s_.epsilon), record);
    asked_ = static_cast<int>(record.events.size());
    for (const Group& group : groups) {
      std::vector<Compared> of_group;
      for (const auto& [event, counts] : record.events) {
        const Compared& e = std::get<Compared>(event);
        if (e.axis.kind != group.kind) continue;
        of_group.push_back(e);
        script_.count(counts);
      }
      if (!of_group.empty()) say(group, of_group);
    }
    relation();
    return std::move(script_.walk());
  }

 private:
  double length(const Compared& e) const { return projections(s_, e.axis).l.norm(); }

  /// The axis that separates, or else the one on which the boxes share least.
  const Compared& telling_one(const std::vector<Compared>& all) const {
    if (all.back().separates) return all.back();
    const Compared* best = &all.front();
    double least = 1e300;
    for (const Compared& e : all) {
      const double l = length(e);
      const double common = (e.radius_a.value + e.radius_b.value - e.distance.value) / l;
      if (l > noise && common < least) least = common, best = &e;
    }
    return *best;
  }

  void say(const Group& group, const std::vector<Compared>& all) {
    const Compared& e = telling_one(all);
    const double d = e.distance.value, r_a = e.radius_a.value, r_b = e.radius_b.value;
    const double l = length(e);
    script_.value("*d* = |**l** · **t**|", d, "length", Role::highlight);
    script_.value("*r*_a", r_a, "length", Role::first);
    script_.value("*r*_b", r_b, "length", Role::second);
    Step& step =
        script_.add(group.slug, group.title, group.line + (e.separates ? 1 : 0),
                    e.separates ? separated(group, e, l, static_cast<int>(all.size())) : passed(group, e),
                    fmt::format("**l** = {}: {} {} {} + {}", name_of(e.axis), shown(d),
                                e.separates ? ">" : "≤", shown(r_a), shown(r_b)));
    step.scene = picture(s_, l > noise ? Focus::axis : Focus::edges, e.axis);
    Script::decide(step, {"*d* ≤ *r*_a + *r*_b", d, r_a + r_b, !e.separates,
                          e.separates ? "the test finds a gap" : "no gap on this axis"});
    step.question = {fmt::format("Does the test find a gap on one of {}?", group.of),
                     {"yes", "no"},
                     e.separates ? 0 : 1,
                     e.separates
                         ? "It takes the centres to lie further apart than the projections reach together."
                         : "On each of them the projections overlap, or touch."};
    if (!e.separates) script_.refuse(group.line + 1, {});
    if (e.separates) gap_ = e.axis;
  }

  std::string separated(const Group& group, const Compared& e, double l, int asked) const {
    if (l <= noise)
      return fmt::format(
          "These edges are parallel, up to rounding. Their product has the length {}: it is no axis.\n"
          "Distance and radii are rounding errors, yet the test compares them and finds a gap.",
          shown(l));
    if (group.kind == Kind::edges)
      return fmt::format(
          "{} separates: the boxes pass each other edge against edge.\n"
          "No normal of a face shows that. Without the products the test would say OVERLAP.",
          name_of(e.axis));
    return fmt::format(
        "{} separates: between the two projections is a gap. One is enough.\n"
        "That was axis {} of this group; all later ones need no look.",
        name_of(e.axis), asked);
  }

  std::string passed(const Group& group, const Compared& e) const {
    const bool touch = e.distance.value == e.radius_a.value + e.radius_b.value;
    const std::string which =
        fmt::format("None of {} separates. The tightest is drawn: {}.",
                    group.kind == Kind::edges ? "the nine" : "these three", name_of(e.axis));
    if (touch) return which + "\nThe projections share exactly one number: no gap.";
    if (widened(e)) return which + "\nIts radii overlap only because ε has widened them.";
    if (group.kind == Kind::face_of_a)
      return which +
             "\nIn the frame of a its own radius is its half-length. That of b adds up three products.";
    return group.kind == Kind::edges
               ? which + "\nThe boxes' Minkowski difference has no other face normals: no axis is left."
               : which + "\nThe roles are exchanged, the numbers are reused.";
  }

  /// Whether the axis separates by the core's numbers, without epsilon.
  bool widened(const Compared& e) const {
    const obb_obb::Tested<3> exact = projections(s_, e.axis);
    return !e.separates && exact.l.norm() > noise &&
           exact.distance > (exact.radius_a + exact.radius_b) * (1 + 1e-12);
  }

  void relation() {
    script_.settle(verdict_kind(s_.truth), in_words(s_.truth));
    if (!overlap_) script_.leave_early();
    script_.value("axes asked", asked_);
    const int line = overlap_ ? 7 : script_.walk().steps.back().line;
    Step& step = script_.add("relation", "How they lie", line, end_caption());
    step.scene =
        gap_ && s_.truth == Relation::disjoint ? picture(s_, Focus::axis, gap_) : picture(s_, Focus::settled);
    step.question = relation_question(s_.truth, "the two boxes", because());
  }

  std::string because() const {
    switch (s_.truth) {
      case Relation::disjoint:
        return gap_ ? name_of(*gap_) + " separates them." : "Taken exactly, an axis separates them.";
      case Relation::touching:
        return "No axis separates them, but on one the projections share a single number.";
      case Relation::overlapping:
        return "On every axis the projections share more than a number.";
      default:
        return "On every normal of the larger box, its projection holds the other one.";
    }
  }

  std::string end_caption() const {
    const bool meets = s_.truth != Relation::disjoint;
    if (meets && !overlap_)
      return "The boxes do meet: the classical test is wrong here. That is why it adds an ε.\n"
             "Ours takes the sign of the gap exactly, so that rounding cannot make one.";
    if (!meets && overlap_)
      return fmt::format(
          "The boxes are disjoint: ε = {} has closed the gap. A small ε does so to long, thin boxes.\n"
          "Ours needs no ε. It bounds the rounding error, and computes exactly where that leaves doubt.",
          shown(s_.epsilon));
    switch (s_.truth) {
      case Relation::disjoint:
        return fmt::format("Disjoint after {} of 15 axes. To reject is cheap; to accept takes them all.",
                           asked_);
      case Relation::touching:
        return "They share points, but none inside both. The sets are closed, so touching counts as OVERLAP.";
      case Relation::overlapping:
        return "All 15 axes had to be asked. Green is what the boxes share.";
      default:
        return "OVERLAP does not tell that one lies inside the other.\n"
               "That takes the normals again: |**l** · **t**| + *r*_a ≤ *r*_b for those of b.";
    }
  }

  const Setup s_;
  Script script_;
  bool overlap_ = false;
  std::optional<obb_obb::Axis> gap_;  ///< the axis that separates
  int asked_ = 0;
};

Walk walk(const Parameters& p) {
  return with_case_map(
      Telling(setup(p)).walk(), obb_obb(), p,
      "The second box moves along the line of the centres and turns about the upright axis.\n"
      "A region tells which axis separates first, or that none does.");
}

std::vector<Opinion> opinions(const Parameters& p) {
  const Setup s = setup(p);
  const bool meets = s.truth != Relation::disjoint;
  std::vector<Opinion> all = {{"exact", in_words(s.truth), true}};
  for (const double epsilon : {0.0, 1e-6, s.epsilon}) {
    const bool overlap = obb_obb::gottschalk(s.a, s.b, epsilon);
    all.push_back({"classical, ε = " + shown(epsilon), overlap ? "OVERLAP" : "DISJOINT", overlap == meets});
  }
  return all;
}

struct Pose {
  Vec3 center, half, u, v;
};

Preset preset_of(const char* id, const char* title, const Pose& a, const Pose& b, double epsilon = 1e-9) {
  return {id,
          title,
          "",
          {{"a", a.center},
           {"a_half", a.half},
           {"a_u", a.u},
           {"a_v", a.v},
           {"b", b.center},
           {"b_half", b.half},
           {"b_u", b.u},
           {"b_v", b.v},
           {"epsilon", epsilon}}};
}

const Vec3 ex = {1, 0, 0}, ey = {0, 1, 0};
const Pose at_left = {{-1.25, 0, 0}, {1, 0.75, 0.75}, ex, ey};

std::vector<Preset> presets() {
  return {
      preset_of("normal-of-b", "a normal of b", at_left,
                {{0.875, 1.75, -0.375}, {1, 0.625, 0.5}, {0.5, -0.5, -0.5}, {-1, -0.25, -1}}),
      preset_of("normal-of-a", "a normal of a", at_left,
                {{1.25, 0.5, -0.5}, {1, 0.625, 0.5}, {0.75, -0.5, 1}, {0.25, 0.75, 0.5}}),
      preset_of("edges", "edge against edge", at_left,
                {{0.875, 1.75, -0.375}, {1, 0.625, 0.5}, {-1, 0.25, 0}, {-1, -0.75, 1}}),
      preset_of("overlapping", "overlapping", at_left,
                {{0.5, 0.375, 0.25}, {1, 0.625, 0.5}, {1, 0.5, 0.25}, {-0.5, 1, 0.25}}),
      preset_of("touching", "touching", {{-1.25, 0, 0}, {1, 0.75, 0.75}, ex, ey},
                {{0.75, 0.25, 0}, {1, 0.5, 0.5}, {3, 4, 0}, {-4, 3, 0}}),
      preset_of("parallel", "parallel edges, ε = 0",
                {{-1, 0, 0}, {1, 0.75, 0.75}, {0.75, 0.5, -0.25}, {-0.25, 0, -0.75}},
                {{0.5, -0.75, -0.625}, {0.75, 1, 0.75}, {0.75, 0.25, -0.25}, {-0.25, 0, -0.75}}, 0),
      preset_of("slender", "thin boxes, a coarse ε",
                {{-0.5, 0.0625, 0}, {2, 0.0625, 0.0625}, {1, 0.25, 0}, ey},
                {{0.5, -0.0625, 0}, {2, 0.0625, 0.0625}, {1, 0.25, 0}, ey}, 0.125),
      preset_of("b-inside-a", "b inside a", {{-0.5, 0, 0}, {1.5, 1.125, 1}, ex, ey},
                {{0, 0.375, 0.25}, {0.5, 0.375, 0.3125}, {1, 0.5, 0.25}, {-0.5, 1, 0.25}}),
  };
}

Parameter vector_of(const char* name, const char* label, const char* help, const Vec3& initial) {
  return {name, label, help, initial, -1e6, 1e6, -4, 4};
}

}  // namespace

const Lesson& obb_obb() {
  static const Lesson lesson = {
      .id = "obb-obb",
      .title = "Oriented boxes",
      .rows = "N07, N04",
      .summary = "Whether two oriented boxes meet, by separating axes: fifteen at most.",
      .parameters =
          {vector_of("a", "**a**", "Centre of the first box, in world units.", at_left.center),
           vector_of("a_half", "**h**_a", "Half-lengths of the first box, in world units.", at_left.half),
           vector_of("a_u", "**a**_u", "First side direction of a, of any length but 0.", ex),
           vector_of("a_v", "**a**_v", "Second side direction of a; made orthogonal to the first.", ey),
           vector_of("b", "**b**", "Centre of the second box, in world units.", {0.5, 0.375, 0.25}),
           vector_of("b_half", "**h**_b", "Half-lengths of the second box, in world units.", {1, 0.625, 0.5}),
           vector_of("b_u", "**b**_u", "First side direction of b, of any length but 0.", {1, 0.5, 0.25}),
           vector_of("b_v", "**b**_v", "Second side direction of b; made orthogonal to the first.",
                     {-0.5, 1, 0.25}),
           {"epsilon", "ε", "Added to every |a_i · b_j|, without a unit.", 1e-9, 0, 1, 0, 0.1}},
      .group_by = "",
      .presets = presets(),
      .camera = {},
      .walk = walk,
      .opinions = opinions,
      .map = &cases(),
  };
  return lesson;
}

}  // namespace isect::lessons
