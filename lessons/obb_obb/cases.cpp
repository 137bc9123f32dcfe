// All cases of two oriented boxes in the plane of distance and turn.

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "lessons/obb_obb/picture.h"

namespace isect::lessons::obb_obb_lesson {
namespace {

using namespace viz;

enum Case { edges, normal_of_a, normal_of_b, overlapping, inside, touching };

int branch(const Parameters& p) {
  const Setup s = setup(p);
  switch (s.truth) {
    case Relation::overlapping:
      return overlapping;
    case Relation::touching:
      return touching;
    case Relation::disjoint: {
      const std::optional<obb_obb::Axis> axis = separating_axis(s.a, s.b);
      if (!axis) return normal_of_a;  // directions that make no box
      return axis->kind == obb_obb::Kind::face_of_a   ? normal_of_a
             : axis->kind == obb_obb::Kind::face_of_b ? normal_of_b
                                                      : edges;
    }
    default:
      return inside;
  }
}

double degrees(const Vec3& u) { return std::atan2(-u.z(), u.x()) * 180 / std::numbers::pi; }

const Vec3& vector_of(const Parameters& p, const char* name) { return std::get<Vec3>(p.at(name)); }

/// The centres' distance, and the turn of b's first side about the vertical axis, from *x*.
Vec2 place(const Parameters& p) {
  return {(vector_of(p, "b") - vector_of(p, "a")).norm(), degrees(vector_of(p, "b_u"))};
}
/// No box is built here, as this is called for thousands of places.
Parameters moved(const Parameters& p, const Vec2& to) {
  const Vec3 &a = vector_of(p, "a"), l = vector_of(p, "b") - a;
  const Eigen::AngleAxisd turn((to.y() - degrees(vector_of(p, "b_u"))) * std::numbers::pi / 180, Vec3::UnitY());
  Parameters there = p;
  there["b"] = Vec3(a + to.x() * (l.norm() > 0 ? Vec3(l.normalized()) : Vec3(Vec3::UnitX())));
  for (const char* side : {"b_u", "b_v"}) there[side] = Vec3(turn * vector_of(p, side));
  return there;
}

}  // namespace

const CaseMap& cases() {
  static const CaseMap map = {
      "distance of the centres",
      "rotation of b about the vertical axis, in degrees",
      {1.25, -180},
      {3.25, 180},
      {"edge × edge", "a normal of a", "a normal of b", "overlapping", "one inside the other", "touching"},
      branch,
      place,
      moved,
      "The second box moves along the line of the centres and rotates about the vertical axis.\n"
      "Each region shows which kind of axis separates first, or that none does.",
      false};
  return map;
}

}  // namespace isect::lessons::obb_obb_lesson
