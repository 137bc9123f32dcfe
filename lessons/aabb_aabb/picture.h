#pragma once
// Two boxes, how they lie, and how they are drawn; and the lesson's walk and map.

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

/// `axis` -1: none looked at; `settled`: with what the boxes share.
viz::Scene picture(const Setup&, int axis, bool settled);

/// The second box shifted along x and y. (cases.cpp)
const viz::CaseMap& cases();
/// Whether the boxes meet, by each method. (cases.cpp)
std::vector<viz::Opinion> opinions(const viz::Parameters&);
/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();
/// The exercise with a program that errs. (wrong_line.cpp)
viz::Exercise wrong_line();
/// (telling.cpp)
viz::Walk tell(const Setup&);

}  // namespace isect::lessons::aabb_aabb_lesson
