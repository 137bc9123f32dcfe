// All cases of a pair, in the plane of b's place across the picture and its size.

#include <cmath>

#include "lessons/relations/telling.h"
#include "lessons/shared/plane.h"
#include "lessons/shared/relation.h"

namespace isect::lessons::relations_lesson {

using namespace viz;

Pose pose(const Parameters& p) {
  return {std::get<Vec3>(p.at("b")), std::get<double>(p.at("size")), std::get<std::string>(p.at("turn"))};
}

const Kind* kind_of(const Parameters& p) {
  for (const Kind& kind : kinds)
    if (name(kind) == std::get<std::string>(p.at("kind"))) return &kind;
  return nullptr;
}

namespace {

int branch(const Parameters& p) {
  const Kind* kind = kind_of(p);
  return case_of(Pair(kind ? *kind : Kind::balls, pose(p)).truth);
}
Vec2 place_of(const Parameters& p) {
  const Pose here = pose(p);
  return {kind_of(p) ? place(here.b).x() : NAN, here.size};
}
Parameters moved(const Parameters& p, const Vec2& to) {
  const Pose here = pose(p);
  Parameters there = p;
  there["b"] = Vec3(here.b + (to.x() - place(here.b).x()) * across());
  there["size"] = to.y();
  return there;
}

}  // namespace

const CaseMap& cases() {
  static const CaseMap map = {"how far b lies to the right of a",
                              "size of b, relative to a",
                              {-3, 0.0625},
                              {3, 2},
                              relation_cases(),
                              branch,
                              place_of,
                              moved,
                              "The second set is shifted to the right and grows; the rest is fixed.\n"
                              "Where the sets can touch, that is a curve on this map. Equality is one point at most.",
                              false};
  return map;
}

}  // namespace isect::lessons::relations_lesson
