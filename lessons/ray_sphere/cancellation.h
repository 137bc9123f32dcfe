#pragma once
// What is lost near the surface, where two differences cancel: f · f − r² in C, then −B and √Δ in a root. Stable
// roots avoid the second one alone.

#include <optional>
#include <string>

#include "lessons/ray_sphere/picture.h"

namespace isect::lessons::ray_sphere_lesson {

/// C as a method in doubles has it, and what it is in truth.
struct Constant {
  double computed, exact;  ///< exact: of the numbers as given, rounded once

  int digits() const;      ///< how many are right
  bool cancelled() const;  ///< digits are lost as f · f and r² are nearly equal
};
Constant constant(const Setup&, double computed);

/// The smaller root of the line by stable roots in doubles, or the larger one; nothing if they find none.
std::optional<double> stable_root(const Setup&, bool first);

/// What becomes of a root whose terms cancel, if it is found as C / (A t), t being the other root.
struct Cure {
  double root, truth;  ///< by stable roots; in truth
  double with_exact;   ///< by stable roots, of the exact C

  bool works() const;          ///< no more than a few digits are lost
  bool takes_exact_c() const;  ///< it works with the exact C, and with no other
};
/// The cure for the smaller root or the larger one; nothing unless the line has two roots, and this one is not 0.
std::optional<Cure> cure(const Setup&, bool first, const Constant&);

/// A sentence on the digits of C, if it has lost many.
std::string lost_in(const Constant&);
/// "no digit", "1 digit", "4 digits"
std::string digits_in_words(int);

}  // namespace isect::lessons::ray_sphere_lesson
