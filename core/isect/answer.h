#pragma once
// The answer about two shapes A and B, in one type whatever they are. isect/ask.h asks any two of them.

#include <optional>

#include <isect/interval.h>

namespace isect {

/// Each verdict is exact; the test that finds t says how near it is. A field that does not apply to the two shapes, or
/// that no test of them finds, has no value. A line may also be a ray or a segment here; t is that of the shape that is
/// a line, of A where both are.
struct Answer {
  bool meet = false;                      ///< they have a common point; for a mesh, one of its triangles has
  std::optional<Relation> relation = {};  ///< how A lies to B; for a mesh that bounds a solid, how the solid does
  std::optional<Location> location = {};  ///< where the one that is a point lies in the other
  std::optional<int> side = {};           ///< for a plane, or a line in 2D, the side of a point or of all corners: 1
                                          ///< where the normal points, or left; -1 opposite; 0 neither, or both
  std::optional<double> t = {};           ///< the first t in the other shape; infinite if too large for a number
  std::optional<Interval<double>> part = {};  ///< all t in the other shape, which is convex
  std::optional<int> triangles = {};          ///< how many triangles of a mesh have a point in the other shape
  bool one_point = false;                     ///< two lines have a point in common and no other
  bool parallel = false;  ///< a line parallel to a plane or in it; parallel planes; parallel lines that differ
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
template <class S>
Answer answer(const std::optional<Interval<S>>& part) {
  if (!part) return {};
  return {.meet = true, .t = part->lo, .part = Interval<double>{part->lo, part->hi}};
}

}  // namespace isect
