#pragma once
// The four walks of moving bodies, and what they share: two bodies that move, then one that moves, then the verdict.

#include <isect/counted.h>
#include "lessons/moving_bodies/picture.h"
#include "lessons/shared/teller.h"

namespace isect::lessons::moving_bodies_lesson {

viz::Walk boxes(const Setup&);         ///< by the times on each axis
viz::Walk balls(const Setup&);         ///< as a ray and a sphere
viz::Walk discrete(const Setup&);      ///< two boxes, time after time
viz::Walk conservative(const Setup&);  ///< two balls, by steps that no contact outruns

/// How many conservative steps are taken at most.
inline constexpr int most_steps = 10000;

class Teller : protected PictureTeller<Setup, Known> {
 protected:
  Teller(const Setup&, const std::string& title, const std::string& source, std::vector<std::string> pseudocode);

  /// Both bodies with their velocities, then b as a sees it.
  void two_bodies(int line);
  void seen_from_a(int line);
  /// Adds the last step: what the exact test says. `told` says it in words; `found`: what the method told says.
  void end(const std::string& slug, const std::string& title, int line, bool found, const std::string& told);

  /// Why they meet, or do not, as the core decides: a sentence or two.
  std::string reason() const;
};

}  // namespace isect::lessons::moving_bodies_lesson
