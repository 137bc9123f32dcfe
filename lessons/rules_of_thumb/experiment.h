#pragma once
// A rule of thumb as an experiment: a small scene, a count without the rule, and the count with it.

#include <array>
#include <string>
#include <vector>

#include <isect/counted.h>
#include <isect/shapes.h>
#include "lessons/shared/flat.h"
#include "viz/lesson.h"

namespace isect::lessons::rules_of_thumb_lesson {

using Flat = Point<double, 2>;

/// One of the four steps: the rule, without it, how it works, with it. Each belongs to one line of the pseudocode.
struct Part {
  std::string title, caption;
  std::vector<viz::Item> items;
  std::string formula = {};
};
struct Experiment {
  std::string title, source, alt;
  std::vector<std::string> pseudocode;  ///< four lines
  std::string unit;                     ///< what is counted: "operations"
  double before = 0, after = 0;
  std::array<Part, 4> parts = {};
  std::string saving = {};                                   ///< why the rule saves, shown with the answer if it does
  std::vector<std::pair<std::string, double>> details = {};  ///< further counts, for the last step
};

Experiment trivial(const Flat& p);       // rule 1
Experiment reuse(const Flat& p);         // rule 2
Experiment reorder(const Flat& p);       // rule 3
Experiment postpone(const Flat& p);      // rule 4
Experiment fewer_axes(const Flat& p);    // rule 5
Experiment precalculate(const Flat& p);  // rule 6
Experiment robust(const Flat& p);        // rule 8

viz::Walk tell(const Experiment&, const Flat& p);
viz::Walk measure();  // rule 7

/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();

/// All operations of a tally.
inline int total(const Tally& t) { return t.mul + t.add + t.div + t.sqrt + t.compare; }
/// The operations of `run`.
template <class Run>
Tally counted(const Run& run) {
  tally() = {};
  run();
  return tally();
}

// Pictures; all lies within x in [-3.3, 1.2], y in [-2, 2].

viz::Region region(const std::vector<Flat>& ring, viz::Role role);
viz::Chain outline(const std::vector<Flat>& ring, viz::Role role, viz::Pen pen);
viz::Circle circle(const Flat& center, double radius, viz::Role role, viz::Pen pen, bool filled = false);
viz::Line line(const Flat& from, const Flat& to, viz::Role role, viz::Pen pen);
/// Text that stands where it is put.
viz::Heading text(const Flat& at, const std::string& what, viz::Role role);
/// "1 234 operations", "1 operation"
std::string number_of(double count, const std::string& unit);

}  // namespace isect::lessons::rules_of_thumb_lesson
