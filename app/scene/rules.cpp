// What the numbers of an object must keep together, so that it is the shape that its name says.

#include <array>
#include <cmath>

#include "app/scene/objects.h"

namespace isect::program::scene {

namespace {

using viz::Vec3;

/// Axes as people write them, with six digits or more; the tests take them as they are.
constexpr double as_written = 1e-6;

bool is_box(const Setting& s, const Object& o) {
  const Vec3 lo = s.point(o, "lo"), hi = s.point(o, "hi");
  return (lo.array() <= hi.array()).all();
}

bool has_half_lengths(const Setting& s, const Object& o) { return s.point(o, "half").minCoeff() >= 0; }

bool has_axes(const Setting& s, const Object& o) {
  const std::array<Vec3, 3> axes = {s.point(o, "u"), s.point(o, "v"), s.has(o, "w") ? s.point(o, "w") : Vec3::UnitZ()};
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(axes[i].norm() - 1) <= as_written)) return false;
    if (!(std::abs(axes[i].dot(axes[(i + 1) % 3])) <= as_written)) return false;
  }
  return true;
}

bool has_range(const Setting& s, const Object& o) {
  return !s.has(o, "tmin") || !s.has(o, "tmax") || s.number(o, "tmin") <= s.number(o, "tmax");
}

}  // namespace

std::vector<ShapeRule> rules_of(Type type) {
  switch (type) {
    case Type::box:
      return {{"lo", "a lo with no coordinate above that of hi", is_box}};
    case Type::obb:
      return {{"half", "half-lengths of at least 0", has_half_lengths},
              {"u", "axes of length 1 at right angles, to six digits", has_axes}};
    case Type::ray:
      return {{"tmax", "a tmax of at least tmin", has_range}};
    default:
      return {};
  }
}

}  // namespace isect::program::scene
