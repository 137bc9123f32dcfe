#pragma once
// Two shapes that are some distance apart, and what is true of them by the core's exact tests.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <isect/methods/nearest_features.h>
#include <isect/nearest_features.h>
#include "viz/lesson.h"

namespace isect::lessons::distance_lesson {

using Segment3 = Segment<double, 3>;
using Capsule3 = Capsule<double, 3>;
using Box3 = Aabb<double, 3>;
using nearest_features::Nearest;
using nearest_features::Pair;

/// Which features contain the nearest points, and how many pairs there are. A point counts as an end, as a corner does.
/// The order is that of the branches of the map.
enum class Kind { ends, end_and_interior, interiors, interval, rectangle, meeting };

struct Setup {
  std::string objects;  ///< "point", "segments", "boxes" or "capsules"
  Segment3 a, b;        ///< b is the point c twice, if it is a point
  double r_a = 0, r_b = 0, clearance = 0;
  std::array<Box3, 2> boxes;
  std::vector<Pair> pairs;  ///< exactly, the features at which a and b are nearest: two for an interval of pairs
  bool meet = false;        ///< exactly, whether the shapes have a common point
  int beyond = 0;           ///< exactly, the sign of the segments' distance less r_a + r_b + clearance

  bool is(const char* name) const { return objects == name; }
  const viz::Vec3& c() const { return b.p; }
  const Segment3& segment(int which) const { return which == 0 ? a : b; }
  Capsule3 capsule(int which) const { return {segment(which).p, segment(which).q, which == 0 ? r_a : r_b}; }
  Kind kind() const;
  /// Whether the segments have one direction, or one is a point. Exact.
  bool parallel() const;
  /// The square of the distance: of a point and a segment, of two segments, of two boxes; the nearest double, of boxes
  /// rounded.
  double distance2() const;
  double distance() const;
  /// The nearest points of such a pair of features, rounded.
  std::pair<viz::Vec3, viz::Vec3> points(const Pair&) const;

  /// The numbers that both boxes have on an axis; none if lo > hi. Exact.
  Interval<double> shared(int axis) const;
  /// On how many axes the boxes share more than one number. Exact.
  int stretches() const;
  /// All points of one of the boxes that belong to a nearest pair: a box, flat on each axis with a gap. Exact.
  Box3 nearest_part(int which) const;
  /// Whether a box is flat on some axis.
  bool flat() const;
};
Setup setup(const viz::Parameters&);

/// The segment's point nearest to c, by the core's own text.
viz::Vec3 foot(const viz::Vec3& c, const Segment3&);

}  // namespace isect::lessons::distance_lesson
