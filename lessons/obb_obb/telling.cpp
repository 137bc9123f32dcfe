// The axes, group by group: the one that separates, or the tightest.

#include "lessons/obb_obb/telling.h"

#include <fmt/format.h>

namespace isect::lessons::obb_obb_lesson {

using namespace viz;
using C = Counted<double>;
using obb_obb::Kind;

struct Group {
  Kind kind;
  const char *slug, *title, *of;
  int line, size;
};

namespace {

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

const Group groups[] = {{Kind::face_of_a, "normals-a", "The normals of a", "the normals of a", 1, 3},
                        {Kind::face_of_b, "normals-b", "The normals of b", "the normals of b", 3, 3},
                        {Kind::edges, "edges", "The products of edges", "the nine products", 5, 9}};

}  // namespace

Teller::Teller(const Setup& setup)
    : s_(setup),
      script_({"Note, N07; Gottschalk, Lin, Manocha (1996)", "Two oriented boxes, a and b: " + in_words(s_.truth) + ".",
               pseudocode}) {}

Walk Teller::tell() {
  Step& first = script_.add("axes", "Which axes can separate?", 0,
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

double Teller::length(const Compared& e) const { return projections(s_, e.axis).l.norm(); }

const Teller::Compared& Teller::telling_one(const std::vector<Compared>& all) const {
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

void Teller::say(const Group& group, const std::vector<Compared>& all) {
  const Compared& e = telling_one(all);
  const double d = e.distance.value, r_a = e.radius_a.value, r_b = e.radius_b.value;
  const double l = length(e);
  script_.value("*d* = |**l** · **t**|", d, "length", Role::highlight);
  script_.value("*r*_a", r_a, "length", Role::first);
  script_.value("*r*_b", r_b, "length", Role::second);
  Step& step = script_.add(group.slug, group.title, group.line + (e.separates ? 1 : 0),
                           e.separates ? separated(group, e, l, static_cast<int>(all.size())) : passed(group, e),
                           fmt::format("**l** = {}: {} {} {} + {}", name_of(e.axis), shown(d), e.separates ? ">" : "≤",
                                       shown(r_a), shown(r_b)));
  step.scene = picture(s_, l > noise ? Focus::axis : Focus::edges, e.axis);
  Script::decide(step, {"*d* ≤ *r*_a + *r*_b", d, r_a + r_b, !e.separates,
                        e.separates ? "the test finds a gap" : "no gap on this axis"});
  step.question = {fmt::format("Does the test find a gap on one of {}?", group.of),
                   {"yes", "no"},
                   e.separates ? 0 : 1,
                   e.separates ? "It takes the centres to lie further apart than the projections reach together."
                               : "On each of them the projections overlap, or touch."};
  if (!e.separates) script_.refuse(group.line + 1, {});
  if (e.separates) gap_ = e.axis;
}

std::string Teller::separated(const Group& group, const Compared& e, double l, int asked) const {
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
      "That was axis {} of this group; the later ones need not be tested.",
      name_of(e.axis), asked);
}

std::string Teller::passed(const Group& group, const Compared& e) const {
  const bool touch = e.distance.value == e.radius_a.value + e.radius_b.value;
  const std::string which = fmt::format("None of {} separates. The tightest is drawn: {}.",
                                        group.kind == Kind::edges ? "the nine" : "these three", name_of(e.axis));
  if (touch) return which + "\nThe projections share exactly one number: no gap.";
  if (widened(e)) return which + "\nIts radii overlap only because ε has widened them.";
  if (group.kind == Kind::face_of_a)
    return which + "\nIn the frame of a its own radius is its half-length. That of b adds up three products.";
  return group.kind == Kind::edges
             ? which + "\nThe boxes' Minkowski difference has no other face normals: no axis is left."
             : which + "\nThe roles are exchanged, the numbers are reused.";
}

bool Teller::widened(const Compared& e) const {
  const obb_obb::Tested<3> exact = projections(s_, e.axis);
  return !e.separates && exact.l.norm() > noise && exact.distance > (exact.radius_a + exact.radius_b) * (1 + 1e-12);
}

}  // namespace isect::lessons::obb_obb_lesson
