#pragma once
// Points in space as drawn and as tested, and the three walks: equality, nearness, and nearness of three.

#include <isect/shapes.h>
#include "viz/lesson.h"

namespace isect::lessons::points_lesson {

using Point3 = Point<double, 3>;

/// What the parameters say. The points are tested in their unit: 1, 2^600 or 2^-600.
struct Setup {
  explicit Setup(const viz::Parameters&);

  viz::Vec3 p, q, r;  ///< as drawn
  double tolerance;   ///< as drawn
  double unit;
  bool is_nan;           ///< the third coordinate of q, as tested
  Point3 tp, tq, tr;     ///< as tested
  double tested_within;  ///< the tolerance, as tested
  bool extreme() const { return unit != 1; }
};

viz::Walk equality(const Setup&);
viz::Walk nearness(const Setup&);
viz::Walk chain(const Setup&);

/// A method, and whether it says near. The exact one comes first.
struct Said {
  const char* slug;
  const char* name;  ///< markup
  bool near;
};
std::vector<Said> said(const Setup&);

/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();

extern const viz::Camera camera;

// Pictures.

void add_point(viz::Scene&, const char* parameter, const viz::Vec3& at, const std::string& label, viz::Role,
               viz::Mark = viz::Mark::disc);
/// Adds the ball of tolerance and its handle. Its label stands `above` tolerances above its centre.
void add_tolerance(viz::Scene&, const Setup&, const viz::Vec3& center, double above);
/// Adds a line of powers of two over all sizes that doubles have, with the distance and its square.
void add_range(viz::Scene&, double distance_exponent, bool squared);

}  // namespace isect::lessons::points_lesson
