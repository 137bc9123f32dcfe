// All cases of two capsules as one of them is moved, and the methods side by side.

#include <cmath>

#include <isect/methods/capsule_capsule.h>
#include "lessons/capsule_capsule/picture.h"
#include "lessons/shared/flat.h"
#include "lessons/shared/opinions.h"

namespace isect::lessons::capsule_capsule_lesson {

using namespace viz;

namespace {

enum Case { disjoint, near_end, crossing, inside, touching };

int branch(const Parameters& p) {
  const Setup s = setup(p);
  switch (s.truth) {
    case Relation::disjoint:
      return disjoint;
    case Relation::touching:
      return touching;
    case Relation::overlapping: {
      Record<capsule_capsule::Event> record;
      intersects(s.a, s.b, record);
      for (const auto& event : record.events)
        if (const auto* e = std::get_if<capsule_capsule::Between>(&event); e && e->holds) return crossing;
      return near_end;
    }
    default:
      return inside;
  }
}

/// The way from the middle of a to the middle of b.
Vec2 place(const Parameters& p) {
  const Setup s = setup(p);
  return (s.b.p + s.b.q - s.a.p - s.a.q) / 2;
}
Parameters moved(const Parameters& p, const Vec2& to) {
  const Setup s = setup(p);
  const Vec2 middle = (s.a.p + s.a.q) / 2 + to, half = (s.b.q - s.b.p) / 2;
  Parameters there = p;
  there["p_b"] = flat(Vec2(middle - half)), there["q_b"] = flat(Vec2(middle + half));
  return there;
}

}  // namespace

const CaseMap& cases() {
  static const CaseMap map = {
      "*x* from the centre of a to that of b",
      "*y* from the centre of a to that of b",
      {-5, -2},
      {5, 2},
      {"disjoint", "an end is near", "the segments cross", "one inside the other", "touching"},
      branch,
      place,
      moved,
      "The second capsule is moved without rotation.\n"
      "The segments cross inside a parallelogram: their Minkowski difference, flat if they are parallel. "
      "The capsules meet there, and within *R* around it."};
  return map;
}

namespace {

/// A typical bug: the distance of the lines instead of the segments. All lines but parallel ones cross.
bool lines_meet(const Setup& s) {
  const Vec2 u = s.a.q - s.a.p, v = s.b.q - s.b.p, w = s.b.p - s.a.p;
  const auto cross = [](const Vec2& x, const Vec2& y) { return x.x() * y.y() - x.y() * y.x(); };
  if (cross(u, v) != 0) return true;
  const Vec2 along = u.norm() > 0 ? u : v;
  const double apart = along.norm() > 0 ? std::abs(cross(along, w)) / along.norm() : w.norm();
  return apart <= s.a.radius + s.b.radius;
}

}  // namespace

std::vector<Opinion> opinions(const Parameters& p) {
  const Setup s = setup(p);
  Opinions all(says_meet(s.truth != Relation::disjoint));
  all.add("nearest points, clamped (Ericson)", says_meet(capsule_capsule::clamped(s.a, s.b)));
  all.add("the same, small = 10⁻⁸ (Sunday)", says_meet(capsule_capsule::sunday(s.a, s.b, 1e-8)));
  all.add("the same in floats (Ericson)", says_meet(capsule_capsule::clamped(cast<float>(s.a), cast<float>(s.b))));
  all.add("nearest points of the lines, not clamped", says_meet(lines_meet(s)));
  return all.take();
}

}  // namespace isect::lessons::capsule_capsule_lesson
