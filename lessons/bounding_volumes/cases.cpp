// All cases of the cheap test first, in the plane of two coordinates of b.

#include <cmath>

#include <isect/aabb_aabb.h>
#include <isect/fit.h>
#include <isect/point_mesh.h>
#include <isect/triangle_aabb.h>
#include "lessons/bounding_volumes/cheap_first.h"

namespace isect::lessons::bounding_volumes_lesson {

using namespace viz;

namespace {

/// An object with the boxes around it and around its triangles.
struct Prepared {
  Prepared(const std::string& the_name, const Vec3& the_tip)
      : name(the_name), tip(the_tip), mesh(object(name, tip)), around(fit_aabb(mesh.vertices)), parts(boxes(mesh)) {}

  std::string name;
  Vec3 tip;
  TriangleMesh<double> mesh;
  Aabb<double, 3> around;
  std::vector<Aabb<double, 3>> parts;
};

/// The object of this setting. The last one is cached, since a map asks thousands of times.
const Prepared& prepared(const Parameters& p) {
  const std::string& name = std::get<std::string>(p.at("object"));
  const Vec3& tip = std::get<Vec3>(p.at("tip"));
  thread_local Prepared kept(name, tip);
  if (kept.name != name || kept.tip != tip) kept = Prepared(name, tip);
  return kept;
}

int branch(const Parameters& p) {
  const Prepared& a = prepared(p);
  const Vec3& q = std::get<Vec3>(p.at("q"));
  const Vec3 reach = Vec3::Constant(std::get<double>(p.at("reach")));
  const Aabb<double, 3> b = {q - reach, q + reach};
  if (!intersects(a.around, b)) return 0;
  const Relation r = relate(a.around, b);
  if (r == Relation::a_inside_b || r == Relation::equal) return 1;
  for (std::size_t i = 0; i < a.parts.size(); ++i)
    if (intersects(a.parts[i], b) && intersects(triangle(a.mesh, static_cast<int>(i)), b)) return 3;
  return locate(q, a.mesh) == Location::in ? 4 : 2;
}

/// The middle of b; NaN for the other walk, which has no place on the map.
Vec2 place(const Parameters& p) {
  if (std::get<std::string>(p.at("walk")) != "test") return Vec2::Constant(NAN);
  return std::get<Vec3>(p.at("q")).head<2>();
}
Parameters moved(const Parameters& p, const Vec2& to) {
  Parameters there = p;
  there["q"] = Vec3(to.x(), to.y(), std::get<Vec3>(p.at("q")).z());
  return there;
}

}  // namespace

const CaseMap& cases() {
  static const CaseMap map = {"*x* of the centre of b",
                              "*y* of the centre of b",
                              {-5, -2.5},
                              {5, 2.5},
                              {"trivial reject", "trivial accept", "only void", "true overlap", "b inside a"},
                              branch,
                              place,
                              moved,
                              "The box b is shifted along *x* and *y*; its size and its *z* are fixed.\n"
                              "Between a trivial reject and a true overlap lies void: the price of a loose fit."};
  return map;
}

}  // namespace isect::lessons::bounding_volumes_lesson
