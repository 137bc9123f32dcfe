// All cases of a wall that moves, and of a direction that turns: the first point of the ray stays.

#include <limits>

#include "lessons/rays/picture.h"

namespace isect::lessons::rays_lesson {
namespace {

using namespace viz;

enum Case { reached, farther, behind, parallel };

/// The ranges are the lesson's own: the segment of a unit direction ends at |d|, any other segment at 1.
int branch(const Parameters& p) {
  const auto truth = [&](const char* extent) {
    Parameters as = p;
    as["extent"] = std::string(extent);
    return setup(as).truth;
  };
  const RayPlane<double> segment = truth("segment");
  if (segment.parallel) return parallel;
  if (segment.meets) return reached;
  return truth("ray").meets ? farther : behind;
}

bool moves(const Parameters& p) { return std::get<std::string>(p.at("made")) == "motion"; }

/// How far ahead the wall is, and how fast the ray comes nearer; NaN for a bullet, which has a wall of its own.
Vec2 place(const Parameters& p) {
  if (moves(p)) return Vec2::Constant(std::numeric_limits<double>::quiet_NaN());
  const Setup s = setup(p);
  return {s.wall - s.o.x(), s.made == Made::points ? s.q.x() - s.o.x() : s.d.x()};
}
Parameters moved(const Parameters& p, const Vec2& to) {
  Parameters there = p;
  const Vec3 o = std::get<Vec3>(p.at("o"));
  there["wall"] = o.x() + to.x();
  const bool points = std::get<std::string>(p.at("made")) == "points";
  std::get<Vec3>(there[points ? "q" : "d"]).x() = points ? o.x() + to.y() : to.y();
  return there;
}

}  // namespace

const CaseMap& cases() {
  static const CaseMap map = {"from **o** to the wall",
                              "*x* of **d**",
                              {-9, -4},
                              {9, 4.5},
                              {"within **d**", "beyond **d**", "behind **o**", "parallel"},
                              branch,
                              place,
                              moved,
                              "The wall moves along *x*, and **d** changes; **o** is fixed.\n"
                              "A wall within **d** counts for segments, rays and lines. Beyond **d** it counts for "
                              "rays and lines, behind **o** for lines only."};
  return map;
}

}  // namespace isect::lessons::rays_lesson
