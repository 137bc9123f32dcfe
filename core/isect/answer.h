#pragma once
// What may be said of two shapes A and B, in one type whatever they are. isect/ask.h asks any two of them.

#include <optional>

#include <isect/conventions.h>
#include <isect/shapes.h>

namespace isect {

/// Each verdict is exact, each t as near as the test says that finds it. What does not apply to the two shapes, or is
/// told by no test of them, has no value. A line, here, is a ray or a segment, too; t is that of the one that is a
/// line, of two lines A's.
struct Answer {
  bool meet = false;                      ///< they have a common point; of a mesh, a triangle of it has
  std::optional<Relation> relation = {};  ///< how A lies to B; of a mesh that bounds a solid, how that does
  std::optional<Location> location = {};  ///< where the one that is a point lies in the other
  std::optional<int> side = {};           ///< of a plane, or a line in the plane, where a point or all corners lie: 1
                                          ///< where the normal points, or left; -1 opposite; 0 on none, or on both
  std::optional<double> t = {};           ///< the first t in the other; infinite: too large for a number
  std::optional<Interval<double>> part = {};  ///< all t in the other, which is convex
  std::optional<int> triangles = {};          ///< so many triangles of a mesh have a point in the other
  bool one_point = false;                     ///< two lines have a point in common and no other
  bool parallel = false;  ///< a line beside or in a plane, planes of one direction; lines of one, but not on one line
  bool coplanar = false;  ///< a line, or every corner, lies in the plane; one plane holds both lines
  bool tangent = false;   ///< the line as a whole touches the ball; two balls touch, from without or within

  friend bool operator==(const Answer&, const Answer&) = default;
};

/// The answer for B and A, from that for A and B; but the t of two lines stays that of A.
inline Answer reversed(Answer answer) {
  if (answer.relation) answer.relation = reversed(*answer.relation);
  return answer;
}

inline Answer answer(Relation r) { return {.meet = r != Relation::disjoint, .relation = r}; }
inline Answer answer(Location l) { return {.meet = l != Location::out, .location = l}; }

}  // namespace isect
