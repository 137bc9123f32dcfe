#pragma once
// The two rules, walked: which edges count. What they share: the first step, the last question, and the state between
// them.

#include "lessons/crossings/picture.h"
#include "lessons/shared/script.h"

namespace isect::lessons::crossings_lesson {

/// The core's rule: a vertex at the height of the point counts as below it.
viz::Walk half_open(const Setup&);
/// Each edge with a point at that height counts, its ends included: the note's sentence, read plainly.
viz::Walk closed(const Setup&);

class Teller {
 protected:
  Teller(const Setup&, const std::string& title, const std::string& source, std::vector<std::string> lines);

  viz::Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption);
  void first_step(const std::string& rule);
  /// "edge-3", counted over all rings.
  std::string slug(const EdgeOf&) const;
  void meet(const EdgeOf&, bool counts);
  /// "Does this edge count?", asked the first time that a case needs thought.
  void ask(viz::Step&, bool counts, const std::string& because);
  viz::Question where_question() const;

  const Setup& setup_;
  Script script_;
  Known known_;
  int count_ = 0;

 private:
  bool asked_ = false;
};

}  // namespace isect::lessons::crossings_lesson
