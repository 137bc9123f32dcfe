// All cases of two moving bodies in the plane of one place, and the methods side by side.

#include "lessons/moving_bodies/picture.h"
#include "lessons/moving_bodies/telling.h"
#include "lessons/shared/opinions.h"

namespace isect::lessons::moving_bodies_lesson {

using namespace viz;

namespace {

int branch(const Parameters& p) { return static_cast<int>(setup(p).truth); }

Vec2 place(const Parameters& p) {
  const Setup s = setup(p);
  return s.b - s.a;
}
Parameters moved(const Parameters& p, const Vec2& to) {
  Parameters there = p;
  const Vec2 b = setup(p).a + to;
  there["b"] = Vec3(b.x(), b.y(), 0);
  return there;
}

std::string says(bool meet) { return meet ? "they meet" : "they do not meet"; }

}  // namespace

const CaseMap& cases() {
  static const CaseMap map = {
      "*x* of **b** − **a** at *t* = 0",
      "*y* of **b** − **a**",
      {-7, -3.5},
      {7, 3.5},
      {"no contact", "contact", "at once", "later", "between tests", "no relative motion", "graze"},
      branch,
      place,
      moved,
      "Each point of the plane is a place of **b**, seen from **a**; sizes, velocities and the duration stay.\n"
      "The region of contact is a, expanded by b and swept against **d**. “Later” is contact after the motion."};
  return map;
}

std::vector<Opinion> opinions(const Parameters& p) {
  const Setup s = setup(p);
  Opinions all(says(s.first.has_value()));
  if (s.balls())
    all.add("quadratic, rounded", says(contact_by_quadratic(s.ball_a(), s.ball_b(), s.duration).has_value()));
  else
    all.add("times on each axis, rounded", says(contact_by_axes(s.box_a(), s.box_b(), s.duration).has_value()));
  if (s.method == "discrete")
    all.add(fmt::format("tests at {} times", s.tests + 1),
            says(!discrete_hits(s.box_a(), s.box_b(), s.duration, s.tests).empty()));
  if (s.method == "conservative") {
    const auto found = advance_conservatively(s.ball_a(), s.ball_b(), s.duration, s.tolerance, s.bound, most_steps);
    const bool near = found.ending == motion::Ending::near;
    all.add("conservative steps, to within *ε*", found.ending == motion::Ending::open ? "open" : says(near));
  }
  return all.take();
}

}  // namespace isect::lessons::moving_bodies_lesson
