#pragma once
// The two rules, walked: which edges count. What they share: the first step, the last question, and the state between
// them.

#include <isect/methods/point_polygon.h>
#include "lessons/crossings/picture.h"
#include "lessons/shared/script.h"

namespace isect::lessons::crossings_lesson {

/// The core's rule: a vertex at the height of the point counts as below it.
viz::Walk half_open(const Setup&);
/// Each edge with a point at that height counts, its ends included: the note's sentence, read plainly.
viz::Walk closed(const Setup&);

/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();
/// The exercise with a program that errs. (wrong_line.cpp)
viz::Exercise wrong_line();
const std::vector<viz::Erratum>& errata();

class Teller {
 protected:
  Teller(const Setup&, const std::string& title, const std::string& source, std::vector<std::string> lines);

  viz::Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
                 const std::string& formula = {});
  void first_step();
  /// Asked before any edge is looked at: `rule` in a sentence, and how many edges count by it.
  viz::Question how_many(const std::string& rule, int counted) const;
  /// "edge-3", counted over all rings.
  std::string slug(const EdgeOf&) const;
  void meet(const EdgeOf&, bool counts);
  /// "Which line settles this edge?", asked the first time that a case needs thought.
  void ask(const EdgeOf&, const std::vector<viz::WrongLine>& wrong, const std::string& because);

  const Setup& setup_;
  Script script_;
  Known known_;
  int count_ = 0;

 private:
  bool asked_ = false;
};

}  // namespace isect::lessons::crossings_lesson
