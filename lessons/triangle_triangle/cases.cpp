// All cases of two triangles as one of them is moved, and the methods side by side.

#include "lessons/shared/opinions.h"
#include "lessons/triangle_triangle/picture.h"

namespace isect::lessons::triangle_triangle_lesson {

using namespace viz;

namespace {

int branch(const Parameters& p) { return static_cast<int>(setup(p).lie()); }

/// From the corner a_0 to b_0, seen along z. A map asks so often that nothing is set up for it.
Vec2 place(const Parameters& p) { return (std::get<Vec3>(p.at("b0")) - std::get<Vec3>(p.at("a0"))).head<2>(); }
Parameters moved(const Parameters& p, const Vec2& to) {
  const Vec2 by = to - place(p);
  Parameters there = p;
  for (const char* name : {"b0", "b1", "b2"}) {
    const Vec3 at = std::get<Vec3>(p.at(name));
    there[name] = Vec3(at.x() + by.x(), at.y() + by.y(), at.z());
  }
  return there;
}

Triangle<float, 3> in_floats(const Three& x) {
  Triangle<float, 3> all;
  for (std::size_t i = 0; i < 3; ++i) all.vertices[i] = x.vertices[i].cast<float>();
  return all;
}

}  // namespace

const CaseMap& cases() {
  static const CaseMap map = {"*x* of **b**_0 − **a**_0",
                              "*y* of **b**_0 − **a**_0",
                              {-3, -4},
                              {9, 4},
                              {"beside a plane", "apart", "touching", "overlapping", "one inside the other"},
                              branch,
                              place,
                              moved,
                              "Each point of the plane is a place of b, moved along *x* and *y* without rotation.\n"
                              "The places where they meet are a plane section of the Minkowski difference of a and b."};
  return map;
}

std::vector<Opinion> opinions(const Parameters& p) {
  const Setup s = setup(p);
  Opinions all(says_meet(s.meet()));
  all.add("intervals on the line, in doubles", says_meet(triangle_triangle::by_intervals(s.a(), s.b())));
  all.add("the same in floats", says_meet(triangle_triangle::by_intervals(in_floats(s.a()), in_floats(s.b()))));
  all.add("signs of volumes", says_meet(triangle_triangle::by_signs(s.a(), s.b())));
  return all.take();
}

}  // namespace isect::lessons::triangle_triangle_lesson
