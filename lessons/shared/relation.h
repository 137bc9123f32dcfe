#pragma once
// The six ways two sets can lie (N02), in words.

#include <string>

#include <isect/conventions.h>
#include "viz/lesson.h"

namespace isect::lessons {

/// "the boxes touch": for verdicts and alt texts; `they` are the two sets.
inline std::string relation_words(Relation r, const std::string& they) {
  switch (r) {
    case Relation::disjoint:
      return they + " are disjoint";
    case Relation::equal:
      return they + " are equal";
    case Relation::a_inside_b:
      return "a lies inside b";
    case Relation::b_inside_a:
      return "b lies inside a";
    case Relation::touching:
      return they + " touch";
    case Relation::overlapping:
      break;
  }
  return they + " overlap";
}

inline viz::Verdict::Kind verdict_kind(Relation r) {
  if (r == Relation::disjoint) return viz::Verdict::Kind::no;
  return r == Relation::touching ? viz::Verdict::Kind::on : viz::Verdict::Kind::yes;
}

/// "How are the two boxes related?" `they` has its article; the answer is that of the exact test. If sets touch from
/// inside, the answer is that one is inside the other.
inline viz::Question relation_question(Relation r, const std::string& they, const std::string& because) {
  const bool inside = r == Relation::a_inside_b || r == Relation::b_inside_a;
  const int answer = r == Relation::disjoint   ? 0
                     : r == Relation::touching ? 1
                     : r == Relation::equal    ? 4
                     : inside                  ? 3
                                               : 2;
  return {"How are " + they + " related?",
          {"disjoint", "touching from outside", "overlapping", "one inside the other", "the same set"},
          answer,
          because};
}

/// The relations as branches of a map of cases.
inline std::vector<std::string> relation_cases() {
  return {"disjoint", "b inside a", "a inside b", "overlapping", "touching", "equal"};
}
inline int case_of(Relation r) {
  switch (r) {
    case Relation::disjoint:
      return 0;
    case Relation::b_inside_a:
      return 1;
    case Relation::a_inside_b:
      return 2;
    case Relation::overlapping:
      return 3;
    case Relation::touching:
      return 4;
    case Relation::equal:
      break;
  }
  return 5;
}

/// "touching"
inline std::string relation_name(Relation r) { return relation_cases()[case_of(r)]; }

}  // namespace isect::lessons
