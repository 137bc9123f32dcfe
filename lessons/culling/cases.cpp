// All cases of a box beside the frustum: its centre moved on one level, seen from above.

#include <limits>

#include "lessons/culling/picture.h"

namespace isect::lessons::culling_lesson {
namespace {

using namespace viz;

enum Case { outside, false_positive, crossing, inside };

Box box_of(const Parameters& p) {
  const Vec3& center = std::get<Vec3>(p.at("p"));
  const Vec3 half = Vec3::Constant(std::get<double>(p.at("size")));
  return {center - half, center + half};
}

int branch(const Parameters& p) {
  const Box box = box_of(p);
  const Frustum<double> view = frustum(std::get<Vec3>(p.at("eye")));
  switch (isect::cull(box, view)) {
    case Culling::outside:
      return outside;
    case Culling::inside:
      return inside;
    case Culling::crossing:
      break;
  }
  return meet(box, view) ? crossing : false_positive;
}

/// How far the box is in front of the eye and to its right; NaN unless a single box is tested.
Vec2 place(const Parameters& p) {
  if (std::get<std::string>(p.at("volume")) != "box") return Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
  const Vec3 from_eye = std::get<Vec3>(p.at("p")) - std::get<Vec3>(p.at("eye"));
  return {from_eye.x(), from_eye.z()};
}
Parameters moved(const Parameters& p, const Vec2& to) {
  const Vec3& eye = std::get<Vec3>(p.at("eye"));
  Parameters there = p;
  there["p"] = Vec3(eye.x() + to.x(), std::get<Vec3>(p.at("p")).y(), eye.z() + to.y());
  return there;
}

}  // namespace

const CaseMap& cases() {
  static const CaseMap map = {"how far the box is in front of the eye",
                              "how far to its right",
                              {-5, -5},
                              {15, 5},
                              {"outside", "false positive", "crossing", "inside"},
                              branch,
                              place,
                              moved,
                              "The box moves back and forth and sideways; its height and size are fixed.\n"
                              "False positive: no plane rejects the box, yet it misses the frustum."};
  return map;
}

}  // namespace isect::lessons::culling_lesson
