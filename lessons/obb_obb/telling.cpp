// The axes, group by group: the one that separates, or the tightest.

#include "lessons/obb_obb/telling.h"

#include <fmt/format.h>

#include <algorithm>

#include "lessons/shared/digits.h"
#include "lessons/shared/questions.h"

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
    "l ← b − a; c_ij ← |a_i · b_j| + ε",               // 0
    "for each of the 3 normals n of a",                // 1
    "    if |n · l| > r_a + r_b: return DISJOINT",     // 2
    "for each of the 3 normals n of b",                // 3
    "    if |n · l| > r_a + r_b: return DISJOINT",     // 4
    "for each of the 9 cross products n = a_i × b_j",  // 5
    "    if |n · l| > r_a + r_b: return DISJOINT",     // 6
    "return OVERLAP"                                   // 7
};
constexpr double noise = 1e-9;  ///< a cross product of edges shorter than this is drawn as edges alone

const Group groups[] = {{Kind::face_of_a, "normals-a", "The normals of a", "the normals of a", 1, 3},
                        {Kind::face_of_b, "normals-b", "The normals of b", "the normals of b", 3, 3},
                        {Kind::edges, "edges", "The cross products of edges", "the nine cross products", 5, 9}};

}  // namespace

Teller::Teller(const Setup& setup)
    : s_(setup),
      script_({"Gottschalk, Lin and Manocha, OBBTree, SIGGRAPH (1996)",
               "Two oriented boxes, a and b: " + in_words(s_.truth) + ".", pseudocode}) {}

Walk Teller::tell() {
  Step& first =
      script_.add("axes", "Which axes can separate?", 0,
                  "For boxes 15 axes suffice: 3 normals of a, 3 of b, and 9 cross products of an edge of each.\n"
                  "Box b has the half-lengths *h*_u, *h*_v, *h*_w along its unit axes **b**_u, **b**_v, **b**_w. On "
                  "**n** it reaches *r*_b to either side: each half side adds the length of its projection.\n"
                  "A gap is left where |**n** · **l**| > *r*_a + *r*_b, with **l** from centre to centre.",
                  "*r*_b = *h*_u |**b**_u · **n**| + *h*_v |**b**_v · **n**| + *h*_w |**b**_w · **n**|");
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

namespace {

/// The two terms; if their sum would read as `other` does, they are in full, with the sum.
std::string sum_of(double a, double b, double other) {
  const std::string terms = shown(a) + " + " + shown(b), sum = digits(a + b, other);
  return sum == shown(a + b) ? terms : fmt::format("{} + {} = {}", to_text(a), to_text(b), sum);
}

}  // namespace

void Teller::say(const Group& group, const std::vector<Compared>& all) {
  const Compared& e = telling_one(all);
  const double d = e.distance.value, r_a = e.radius_a.value, r_b = e.radius_b.value;
  const double l = length(e);
  script_.value("*d* = |**n** · **l**|", d, "length", Role::highlight);
  script_.value("*r*_a", r_a, "length", Role::first);
  script_.value("*r*_b", r_b, "length", Role::second);
  Step& step = script_.add(group.slug, group.title, group.line + (e.separates ? 1 : 0),
                           e.separates ? separated(group, e, l, static_cast<int>(all.size())) : passed(group, e, all),
                           fmt::format("**n** = {}: {} {} {}", name_of(e.axis), digits(d, r_a + r_b),
                                       e.separates ? ">" : "≤", sum_of(r_a, r_b, d)));
  step.scene = picture(s_, l > noise ? Focus::axis : Focus::edges, e.axis);
  Script::decide(step, {"*d* > *r*_a + *r*_b", d, r_a + r_b, e.separates,
                        e.separates ? "the test finds a gap" : "the test finds no gap"});
  step.question = question(group, e);
  if (!e.separates) script_.refuse(group.line + 1, {});
  if (e.separates) gap_ = e.axis;
}

viz::Question Teller::question(const Group& group, const Compared& e) const {
  if (group.kind != Kind::face_of_a) {
    const double d = e.distance.value, r_a = e.radius_a.value, r_b = e.radius_b.value;
    return {
        fmt::format("Of {}, **n** = {} has a gap, or comes nearest to one. What follows, once they are tested?",
                    group.of, name_of(e.axis)),
        {"DISJOINT", "OVERLAP", "nothing yet"},
        e.separates                 ? 0
        : group.kind == Kind::edges ? 1
                                    : 2,
        e.separates ? "On one axis of this group |**n** · **l**| > *r*_a + *r*_b."
                    : "On each axis of this group |**n** · **l**| ≤ *r*_a + *r*_b, as the test computes.",
        {},
        {{"*d* = |**n** · **l**|", d, "length", Role::highlight}, {"*r*_a + *r*_b", r_a + r_b, "length", Role::text}}};
  }
  const Vec3 along = s_.b.axes.transpose() * s_.a.axes.col(e.axis.i);
  const Vec3& h = s_.b.half;
  const double reach = h.dot(along.cwiseAbs());
  const bool widened = shown(reach) != shown(e.radius_b.value);
  Question question =
      which_value(fmt::format("**n** = {}: |**b**_u · **n**| = {}, |**b**_v · **n**| = {}, |**b**_w · **n**| = {}. "
                              "What is *r*_b{}?",
                              name_of(e.axis), shown(std::abs(along.x())), shown(std::abs(along.y())),
                              shown(std::abs(along.z())), widened ? ", before ε is added" : ""),
                  reach,
                  {{h.sum(), "That adds the half-lengths in full. Each counts times |**b**_j · **n**|."},
                   {h.norm(), "That is the radius of the circumscribed ball."},
                   {h.maxCoeff(), "That is the longest half-length alone."},
                   {std::abs(h.dot(along)), "That adds without the absolute values, so terms cancel."}},
                  widened ? "*r*_b = Σ *h*_j |**b**_j · **n**|. Then ε is added to each |**b**_j · **n**|."
                          : "*r*_b = Σ *h*_j |**b**_j · **n**|, where ε is added to each |**b**_j · **n**|.");
  question.given = {{"*h*_u of b", h.x(), "length", Role::second},
                    {"*h*_v of b", h.y(), "length", Role::second},
                    {"*h*_w of b", h.z(), "length", Role::second}};
  return question;
}

std::string Teller::separated(const Group& group, const Compared& e, double l, int asked) const {
  if (l <= noise)
    return fmt::format(
        "These edges are parallel, up to rounding. Their cross product has the length {}: it is no axis.\n"
        "Distance and radii are rounding errors, yet the test compares them and finds a gap.",
        shown(l));
  if (s_.truth != Relation::disjoint)
    return fmt::format("The test finds a gap on {}. Rounding has made it: the boxes do meet.", name_of(e.axis));
  const std::string gap = fmt::format("{} separates: there is a gap between the two projections.", name_of(e.axis));
  if (group.kind == Kind::edges)
    return gap + (a_normal_separates() ? "\nA normal separates, too, but ε has widened the radii there."
                                       : "\nNo normal does. Without the cross products the test would say OVERLAP.");
  return gap + fmt::format("\nIt is number {} of three in this group. ", asked) +
         (asked < group.size ? "One gap is enough: the later axes need not be tested." : "One gap is enough.");
}

bool Teller::a_normal_separates() const {
  for (int i = 0; i < 3; ++i)
    for (const Kind kind : {Kind::face_of_a, Kind::face_of_b}) {
      const obb_obb::Tested<3> exact = projections(s_, {kind, i});
      if (exact.distance > exact.radius_a + exact.radius_b) return true;
    }
  return false;
}

std::string Teller::passed(const Group& group, const Compared& e, const std::vector<Compared>& all) const {
  const std::string which = fmt::format("The test finds no gap on {}. The tightest one is drawn: {}.",
                                        group.kind == Kind::edges ? "the nine" : "these three", name_of(e.axis));
  if (widened(e)) return which + "\nThis axis separates. Only ε makes the radii overlap here.";
  if (std::ranges::any_of(all, [&](const Compared& other) { return widened(other); }))
    return which + "\nOn another of them ε has closed a gap.";
  if (group.kind == Kind::face_of_a)
    return which + "\nFor **n** = **a**_i, *r*_a is the half-length *h*_i. *r*_b adds up three products.";
  return group.kind == Kind::edges ? which +
                                         "\nAll differences of a point of a and one of b form a polytope, the "
                                         "Minkowski difference.\nIts faces have no other "
                                         "normals: no axis is left."
                                   : which + "\nThe roles are exchanged, the numbers are reused.";
}

bool Teller::widened(const Compared& e) const {
  const obb_obb::Tested<3> exact = projections(s_, e.axis);
  return !e.separates && exact.l.norm() > noise && exact.distance > (exact.radius_a + exact.radius_b) * (1 + 1e-12);
}

}  // namespace isect::lessons::obb_obb_lesson
