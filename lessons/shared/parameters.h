#pragma once
// The knobs that lessons have in common.

#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include <isect/shapes.h>
#include "viz/lesson.h"

namespace isect::lessons {

/// A choice among several named settings; number `initial` is the one at the start.
inline viz::Parameter choice(std::string name, std::string label, std::string help, std::vector<std::string> choices,
                             std::size_t initial = 0) {
  viz::Parameter p{std::move(name), std::move(label), std::move(help), choices.at(initial)};
  p.choices = std::move(choices);
  return p;
}

/// A point or a vector whose sliders go from -reach to reach on each axis.
inline viz::Parameter vector(std::string name, std::string label, std::string help, const viz::Vec3& initial,
                             double reach = 4) {
  return {std::move(name), std::move(label), std::move(help), initial, -1e6, 1e6, -reach, reach};
}

/// Restricts a parameter to settings in which `choice` has one of these values.
inline viz::Parameter where(const std::string& choice, std::vector<std::string> values, viz::Parameter p) {
  p.where[choice] = std::move(values);
  return p;
}

/// A point of a plane lesson: the third coordinate is not used.
inline Point<double, 2> flat_point(const viz::Parameters& values, const std::string& name) {
  return std::get<viz::Vec3>(values.at(name)).head<2>();
}

/// The direction of v as a unit vector, whatever the length of v.
inline viz::Vec3 unit(const viz::Vec3& v) {
  return std::isnormal(v.squaredNorm()) ? v.normalized() : v.stableNormalized();
}

/// Requires a vector that is not 0. `flat`: in the plane, as its third coordinate is not used. `where`: required only
/// in settings for which it holds.
inline viz::Condition not_zero(const std::string& name, bool flat = false,
                               std::function<bool(const viz::Parameters&)> where = {}) {
  return {name, flat ? "a vector that is not 0 in the plane" : "a vector of any length but 0",
          [=](const viz::Parameters& values) {
            const viz::Vec3& v = std::get<viz::Vec3>(values.at(name));
            return (where && !where(values)) || !(flat ? v.head<2>().isZero(0) : v.isZero(0));  // a norm may underflow
          }};
}

}  // namespace isect::lessons
