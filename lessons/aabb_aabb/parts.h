#pragma once
// What the lesson's parts share: the two boxes, their picture, and the cases there are.

#include <isect/aabb_aabb.h>
#include "viz/lesson.h"

namespace isect::lessons::aabb_aabb_lesson {

using Box = Aabb<double, 3>;

struct Setup {
  Box a, b;
  Relation truth;

  Box all() const { return {a.lo.cwiseMin(b.lo), a.hi.cwiseMax(b.hi)}; }
};

Setup setup(const viz::Parameters&);

/// "*x*", "*y*", "*z*"
inline constexpr const char* names[] = {"*x*", "*y*", "*z*"};

/// `axis` -1: none looked at; `settled`: with what the boxes share.
viz::Scene picture(const Setup&, int axis, bool settled);

/// The second box shifted along x and y. (cases.cpp)
const viz::CaseMap& cases();
/// Whether the boxes meet, by each method. (cases.cpp)
std::vector<viz::Opinion> opinions(const viz::Parameters&);

}  // namespace isect::lessons::aabb_aabb_lesson
