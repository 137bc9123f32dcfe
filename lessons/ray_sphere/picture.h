#pragma once
// The picture of a ray and a ball: what is known so far is drawn, no more.

#include <isect/ray_sphere.h>
#include "viz/lesson.h"

namespace isect::lessons::ray_sphere_lesson {

/// The scene's shapes, and what is true of them by the exact test.
struct Setup {
  Ray<double, 3> ray;
  Sphere<double, 3> sphere;
  RaySphere<double> truth;

  bool lengths = false;  ///< t is a length: the direction is a unit vector
  double given = 1;      ///< length of the direction as given, in lengths of the ray's

  double foot() const;   ///< t of the line's point nearest to the center
  bool segment() const;  ///< the range is finite
  bool is_a_point() const { return sphere.radius == 0; }
};

/// Reads the parameters. `unit_direction`: the direction is normalised and the range's end measured in
/// lengths.
Setup setup(const viz::Parameters&, bool unit_direction);

/// The one thing a step is about, drawn in the highlight colour.
enum class Focus { none, center_line, direction, along, passing, half_chord, radius, first_root, second_root };

/// What the steps so far have found.
struct Known {
  bool center_line = false;  ///< l or f
  bool from_center = false;  ///< ... drawn from c to o, and called f
  bool foot = false, passing = false, half_chord = false;
  int roots = 0;  ///< how many of t1, t2
  bool settled = false;
  Focus focus = Focus::none;
};

viz::Scene picture(const Setup&, const Known&);

/// "*t* = 3.3884 (a length)" or "*t* = 1.6552, in lengths of **d**".
std::string told(const Setup&, double t);

/// One plain sentence for those who cannot see the picture.
std::string alt_text(const Setup&);

/// The map of where the ray begins along itself against how far its line passes the centre. (cases.cpp)
const viz::CaseMap& cases();
/// First hits to five digits, in the walk's own unit: lengths, or lengths of the direction as given. (cases.cpp)
std::vector<viz::Opinion> opinions(const viz::Parameters&);
/// The text before the first step, the card after the last one, and the note's errors. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();
/// The exercise with a program that errs. (wrong_line.cpp)
viz::Exercise wrong_line();
const std::vector<viz::Erratum>& errata();

}  // namespace isect::lessons::ray_sphere_lesson
