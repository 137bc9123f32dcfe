// All cases of a wall that moves, and of a direction that turns: the first point of the ray stays.

#include <limits>

#include "lessons/rays/methods.h"

namespace isect::lessons::rays_lesson {
namespace {

using namespace viz;

enum Case { reached, farther, behind, parallel };

int branch(const Parameters& p) {
  const Setup s = setup(p);
  if (s.truth.parallel) return parallel;
  const auto meets = [&](double lo, double hi) {
    return intersect(Ray<double, 2>{s.ray.origin, s.ray.direction, {lo, hi}}, s.plane).meets;
  };
  const double end = s.made == Made::unit ? s.d.norm() : 1;
  if (meets(0, end)) return reached;
  return meets(0, infinite<double>.hi) ? farther : behind;
}

bool moves(const Parameters& p) { return std::get<std::string>(p.at("made")) == "motion"; }

/// How far ahead the wall is, and how fast the ray comes nearer; a bullet has a wall of its own.
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
                              {-6, -4},
                              {6, 4.5},
                              {"0 ≤ *t* ≤ 1", "*t* > 1", "*t* < 0", "parallel"},
                              branch,
                              place,
                              moved};
  return map;
}

}  // namespace isect::lessons::rays_lesson
