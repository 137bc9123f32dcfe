#pragma once
// Two balls, how they lie, and how they are drawn; and the lesson's walk, map and closing card.

#include <isect/sphere_sphere.h>
#include "viz/lesson.h"

namespace isect::lessons::sphere_sphere_lesson {

using Ball3 = isect::Sphere<double, 3>;

/// The balls as drawn, the same balls as tested (times `unit`), and how these lie by the exact test.
struct Setup {
  Ball3 a, b;
  double unit;
  Relation truth;
  bool inner_touch;  ///< one lies inside the other, and their surfaces touch

  Ball3 tested(const Ball3& ball) const { return {unit * ball.center, unit * ball.radius}; }
};

Setup setup(const viz::Parameters&);

enum class Focus { none, line, distance, radii, settled };

viz::Scene picture(const Setup&, Focus);

/// The map of distance against second radius, both in radii of the first. (cases.cpp)
const viz::CaseMap& cases();
/// Whether the balls meet, by each method. (cases.cpp)
std::vector<viz::Opinion> opinions(const viz::Parameters&);
/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();
/// The exercise with a program that errs. (wrong_line.cpp)
viz::Exercise wrong_line();
/// (telling.cpp)
viz::Walk tell(const Setup&);

}  // namespace isect::lessons::sphere_sphere_lesson
