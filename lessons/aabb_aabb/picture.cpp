#include <algorithm>

#include "lessons/aabb_aabb/picture.h"
#include "lessons/shared/axis_names.h"
#include "viz/solids.h"

namespace isect::lessons::aabb_aabb_lesson {

using namespace viz;

namespace {

/// The boxes' intervals on one axis, drawn in front of them like a ruler: a point of it.
Vec3 ruler(const Setup& s, int axis, double t, int row) {
  const Box all = s.all();
  const Vec3 size = all.hi - all.lo;
  const double off = (0.1 + 0.09 * row) * size.maxCoeff();
  Vec3 p = {all.lo.x() - off, all.lo.y(), all.hi.z() + off};  // y: beside the front left edge
  if (axis == 0) p = {0, all.lo.y() - 0.4 * off, all.hi.z() + off};
  if (axis == 2) p = {all.hi.x() + off, all.lo.y() - 0.4 * off, 0};
  p[axis] = t;
  return p;
}

void rulers(Scene& scene, const Setup& s, int axis) {
  const Interval<double> a = s.a.along(axis), b = s.b.along(axis);
  const auto span = [&](const Interval<double>& i, int row, Role role) {
    scene.items.push_back(Span{ruler(s, axis, i.lo, row), ruler(s, axis, i.hi, row), role, Pen::thick});
  };
  span(a, 0, Role::first);
  span(b, 1, Role::second);
  const Interval<double> common = {std::max(a.lo, b.lo), std::min(a.hi, b.hi)};
  const auto both = [&](double t) {
    return Line{ruler(s, axis, t, 0), ruler(s, axis, t, 1), Role::construction, Pen::construction};
  };
  scene.items.push_back(both(common.lo));
  scene.items.push_back(both(common.hi));
  const double beyond = 0.1 * (s.all().hi - s.all().lo).maxCoeff();  // or the name would stand between the rulers
  scene.items.push_back(Label{ruler(s, axis, std::max(a.hi, b.hi) + beyond, 1), axis_names[axis], Role::text});
}

/// What the boxes share: a box, a face, an edge or a corner.
void shared(Scene& scene, const Setup& s) {
  const Box c = aabb_aabb::common(s.a, s.b);
  if (s.truth == Relation::overlapping) scene.items.push_back(solid(c, Role::hit));
  if (s.truth != Relation::touching) return;
  std::vector<int> flat, long_axes;
  for (int axis = 0; axis < 3; ++axis) (c.lo[axis] == c.hi[axis] ? flat : long_axes).push_back(axis);
  if (flat.size() == 1) {
    Region side = face(c, flat[0], c.lo[flat[0]], Role::hit);
    side.pen = Pen::thick;
    scene.items.push_back(side);
  } else if (flat.size() == 2) {
    scene.items.push_back(Chain{{c.lo, c.hi}, false, Role::hit, Pen::thick});
  } else {
    scene.items.push_back(Dot{c.lo, Mark::disc, Role::hit});
  }
}

}  // namespace

Setup setup(const Parameters& p) {
  const auto vector = [&](const char* name) { return std::get<Vec3>(p.at(name)); };
  Setup s = {{vector("a_min"), vector("a_max")}, {vector("b_min"), vector("b_max")}, {}};
  s.truth = relate(s.a, s.b);
  return s;
}

Scene picture(const Setup& s, int axis, bool settled) {
  Scene scene;
  scene.items = {solid(s.a, Role::first), solid(s.b, Role::second)};
  if (axis >= 0) rulers(scene, s, axis);
  if (settled) shared(scene, s);
  if (s.truth != Relation::equal) {  // at corners of the silhouette: low, left and in front; high, right and behind
    scene.items.push_back(Label{{s.a.lo.x(), s.a.lo.y(), s.a.hi.z()}, "a", Role::first});
    scene.items.push_back(Label{{s.b.hi.x(), s.b.hi.y(), s.b.lo.z()}, "b", Role::second});
  } else {
    scene.items.push_back(Label{{s.a.lo.x(), s.a.lo.y(), s.a.hi.z()}, "a = b", Role::first});
  }
  scene.handles = {{"a_min", Handle::Kind::point, s.a.lo, Vec3::Zero(), Role::first},
                   {"a_max", Handle::Kind::point, s.a.hi, Vec3::Zero(), Role::first},
                   {"b_min", Handle::Kind::point, s.b.lo, Vec3::Zero(), Role::second},
                   {"b_max", Handle::Kind::point, s.b.hi, Vec3::Zero(), Role::second}};
  return scene;
}

}  // namespace isect::lessons::aabb_aabb_lesson
