#pragma once
// The four walks of distances, and what they share: the steps, the verdict, and how many pairs are nearest.

#include <isect/counted.h>
#include "lessons/distance/picture.h"
#include "lessons/shared/teller.h"

namespace isect::lessons::distance_lesson {

viz::Walk point(const Setup&);     ///< a point and a segment
viz::Walk segments(const Setup&);  ///< two segments
viz::Walk boxes(const Setup&);     ///< two axis-aligned boxes
viz::Walk capsules(const Setup&);  ///< two capsules, compared with a bound

class Teller : protected PictureTeller<Setup, Known> {
 protected:
  Teller(const Setup&, const std::string& title, const std::string& source, std::vector<std::string> pseudocode);

  /// Sets the verdict: whether they meet, else how far apart they are.
  void settle();
  /// How many pairs of nearest points there are, as the core decides.
  viz::Question pairs_question() const;
};

/// How far apart they are, in words.
std::string told_distance(const Setup&);
/// "the end **p**_a", "the interior of b"
std::string feature_name(int which, Nearest);
/// Which features of two segments are nearest, and how many pairs of points; a sentence or two.
std::string told_features(const Setup&);

/// Nearly parallel segments, and b tilted as little to the other side of a parallel.
struct Tilt {
  Way before, after;           ///< from the nearest point of a to that of b
  double moved, jump, change;  ///< how far q of b and the nearest point of a move, and by how much the distance changes
};
/// Nothing unless the segments are nearly parallel, and the nearest point jumps. (nearly_parallel.cpp)
std::optional<Tilt> tilted_back(const Segment3& a, const Segment3& b);

}  // namespace isect::lessons::distance_lesson
