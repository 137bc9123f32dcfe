#pragma once
// The three ways to find all pairs of boxes that overlap, and a box that moves. What the three share: a step for each
// test, and what they cost together.

#include "lessons/collision/picture.h"
#include "lessons/shared/plural.h"
#include "lessons/shared/questions.h"
#include "lessons/shared/script.h"

namespace isect::lessons::collision_lesson {

viz::Walk double_loop(const Boxes&, const Frame& = {});
viz::Walk sweep(const Boxes&, const Frame& = {});  ///< sweep and prune
viz::Walk hierarchy(const Boxes&, const Frame& = {});

/// A small box flies at a thin wall: what discrete times miss, and what a ray does not. The box is centred at `p` and
/// moves to the right at this speed, for a second and a half.
viz::Walk tunnelling(const viz::Vec3& p, double speed);

/// The text before the first step, the card after the last one, and the note's errors. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();
const std::vector<viz::Erratum>& errata();

/// The moving box and the wall of a setting: when they are in contact, and how. (tunnelling.cpp)
struct Encounter {
  std::optional<Interval<double>> contact;
  bool seen = false;    ///< at one of the discrete times
  bool grazes = false;  ///< passing the end of the wall, the box shares no more than boundary points with it
};
Encounter encounter(const viz::Vec3& p, double speed);

class Teller {
 protected:
  Teller(const Boxes&, const Frame&, const std::string& title, std::vector<std::string> lines);

  viz::Step& add(const std::string& slug, const std::string& title, int line, const std::string& caption,
                 const std::string& formula = {});
  /// A pair was tested; `yes` and `no` are the lines that say so.
  viz::Step& tested(int i, int j, bool overlap, int yes, int no);
  /// Box i was tested with several, one after the other, and meets none of them.
  viz::Step& apart(int i, const std::vector<int>& others, int no);
  void total(int line, const std::string& caption);

  const Boxes& boxes_;
  const Frame frame_;
  Script script_;
  Drawn drawn_;
  int tests_ = 0;
};

}  // namespace isect::lessons::collision_lesson
