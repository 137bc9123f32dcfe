#pragma once
// The picture of a ball and a box: the way from the centre to the box's nearest point, one leg an axis.

#include <isect/sphere_aabb.h>
#include "viz/lesson.h"

namespace isect::lessons::sphere_aabb_lesson {

struct Setup {
  Sphere<double, 3> ball;
  Aabb<double, 3> box;
  Relation truth;
  bool in_grown;  ///< the box, grown by r on every side, holds the centre

  viz::Vec3 nearest() const { return sphere_aabb::nearest<3>(ball.center, box); }
  /// On how many axes the centre lies beside the box's interval.
  int gaps() const;
  /// Where the nearest point lies: 0 at the centre itself, 1 in a face, 2 on an edge, 3 at a corner.
  int feature() const;
};
Setup setup(const viz::Parameters&);

/// What a step shows.
struct Shown {
  int legs = 0;          ///< how many axes are done
  bool current = false;  ///< the last of them is the step's own
  bool grown = false;    ///< the box grown by r, and the set of centres that do meet
  bool settled = false;  ///< shows the straight way, and what they share
};
viz::Scene picture(const Setup&, const Shown&);

/// The map over the plane of the centre, whose *z* is kept. (cases.cpp)
const viz::CaseMap& cases();

/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();
/// The exercise with a program that errs. (wrong_line.cpp)
viz::Exercise wrong_line();

}  // namespace isect::lessons::sphere_aabb_lesson
