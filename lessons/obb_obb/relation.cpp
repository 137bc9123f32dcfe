// How two boxes lie, which the fifteen axes alone do not tell.

#include <fmt/format.h>

#include "lessons/obb_obb/telling.h"
#include "lessons/shared/relation.h"

namespace isect::lessons::obb_obb_lesson {

using namespace viz;

std::string in_words(Relation r) { return words(r, "the boxes"); }

void Teller::relation() {
  script_.settle(verdict_kind(s_.truth), in_words(s_.truth));
  if (!overlap_) script_.leave_early();
  script_.value("axes asked", asked_);
  const int line = overlap_ ? 7 : script_.walk().steps.back().line;
  Step& step = script_.add("relation", "How they lie", line, end_caption());
  step.scene = gap_ && s_.truth == Relation::disjoint ? picture(s_, Focus::axis, gap_) : picture(s_, Focus::settled);
  step.question = relation_question(s_.truth, "the two boxes", because());
}

std::string Teller::because() const {
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

std::string Teller::end_caption() const {
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
      return fmt::format("Disjoint after {} of 15 axes. To reject is cheap; to accept takes them all.", asked_);
    case Relation::touching:
      return "They share points, but none inside both. The sets are closed, so touching counts as OVERLAP.";
    case Relation::overlapping:
      return "All 15 axes had to be asked. Green is what the boxes share.";
    default:
      return "OVERLAP does not tell that one lies inside the other.\n"
             "That takes the normals again: |**l** · **t**| + *r*_a ≤ *r*_b for those of b.";
  }
}

}  // namespace isect::lessons::obb_obb_lesson
