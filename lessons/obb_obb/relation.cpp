// How two boxes lie, which the fifteen axes alone do not tell.

#include <fmt/format.h>

#include "lessons/obb_obb/telling.h"
#include "lessons/shared/digits.h"
#include "lessons/shared/relation.h"

namespace isect::lessons::obb_obb_lesson {

using namespace viz;

namespace {

bool one_is_flat(const Setup& s) { return (s.a.half.array() == 0).any() || (s.b.half.array() == 0).any(); }

}  // namespace

std::string in_words(Relation r) { return relation_words(r, "the boxes"); }

void Teller::relation() {
  script_.settle(verdict_kind(s_.truth), in_words(s_.truth));
  if (!overlap_) script_.leave_early();
  script_.value("axes asked", asked_);
  const int line = overlap_ ? 7 : script_.walk().steps.back().line;
  Step& step = script_.add("relation", "How they relate", line, end_caption());
  step.scene = gap_ && s_.truth == Relation::disjoint ? picture(s_, Focus::axis, gap_) : picture(s_, Focus::settled);
  step.question = relation_question(s_.truth, "the two boxes", because());
}

std::string Teller::because() const {
  switch (s_.truth) {
    case Relation::disjoint:
      return gap_ ? "There is an axis on which |**n** · **l**| > *r*_a + *r*_b."
                  : "Without ε, an axis separates the boxes.";
    case Relation::touching:
      return "No axis separates them, but on at least one the projections share a single number.";
    case Relation::overlapping:
      return one_is_flat(s_) ? "No axis separates them, and a point is interior to both."
                             : "On every axis the projections share more than a number.";
    case Relation::equal:
      return "On every normal of either box both projections are the same.";
    default:
      return "On every normal of one box, its projection contains that of the other.";
  }
}

std::string Teller::end_caption() const {
  const bool meets = s_.truth != Relation::disjoint;
  if (meets && !overlap_)
    return "The boxes do meet: the classical test is wrong here. That is why it adds an ε.\n"
           "Ours takes the sign of the gap exactly, so that rounding cannot make one.";
  if (!meets && overlap_)
    return fmt::format(
        "The boxes are disjoint: ε = {} has closed the gap, so the classical test is wrong here.\n"
        "Ours needs no ε. It bounds the rounding error, and computes exactly where that leaves doubt.",
        as_power(s_.epsilon));
  switch (s_.truth) {
    case Relation::disjoint:
      return asked_ < 15
                 ? fmt::format("Disjoint after {} of 15 axes. Rejecting is cheap; accepting takes them all.", asked_)
                 : "Disjoint by the last of 15 axes.";
    case Relation::touching:
      return std::string(one_is_flat(s_) ? "They share points, but none is interior to both."
                                         : "They share boundary points, but no interior point.") +
             " Closed sets include their boundary, so touching counts as OVERLAP.";
    case Relation::overlapping:
      return "All 15 axes had to be tested. What the boxes share is marked.";
    case Relation::equal:
      return "OVERLAP does not say that the boxes are the same set.";
    case Relation::a_inside_b:
      return "OVERLAP does not say that a lies inside b.\n"
             "That takes the normals again: |**n** · **l**| + *r*_a ≤ *r*_b for those of b.";
    case Relation::b_inside_a:
      break;
  }
  return "OVERLAP does not say that b lies inside a.\n"
         "That takes the normals again: |**n** · **l**| + *r*_b ≤ *r*_a for those of a.";
}

}  // namespace isect::lessons::obb_obb_lesson
