#pragma once
// The picture of two oriented boxes: an axis, and what the boxes' shadows on it are.

#include <optional>

#include <isect/obb_obb.h>
#include "viz/lesson.h"

namespace isect::lessons::obb_obb_lesson {

struct Setup {
  Obb<double, 3> a, b;
  viz::Vec3 a_u, b_u;  ///< as given: u before it was normalised
  double epsilon;
  Relation truth;
};
Setup setup(const viz::Parameters&);

/// The axis, not normalised, and the boxes' projections on it, as the core computes them.
obb_obb::Tested<3> projections(const Setup&, const obb_obb::Axis&);
/// "**a**_u", "**a**_u × **b**_w"
std::string name_of(const obb_obb::Axis&);

enum class Focus {
  none,
  centers,  ///< the way from centre to centre
  axis,     ///< one axis, with both projections
  edges,    ///< one pair of edges alone: their product is too short to be an axis
  settled   ///< what the boxes share
};
viz::Scene picture(const Setup&, Focus, const std::optional<obb_obb::Axis>& = {});

/// The map of distance against turn: which axis separates first. (cases.cpp)
const viz::CaseMap& cases();

/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();
/// The exercise with a program that errs. (wrong_line.cpp)
viz::Exercise wrong_line();

}  // namespace isect::lessons::obb_obb_lesson
