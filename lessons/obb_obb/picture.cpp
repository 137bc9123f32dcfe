#include "lessons/obb_obb/picture.h"

#include <Eigen/Geometry>
#include <cmath>

#include "lessons/obb_obb/shared_part.h"
#include "lessons/shared/parameters.h"
#include "viz/solids.h"

namespace isect::lessons::obb_obb_lesson {

using namespace viz;
using Box = Obb<double, 3>;

namespace {

const char* const side_names[] = {"u", "v", "w"};

Vec3 corner(const Box& box, int i) {
  Vec3 s = box.half;
  for (int axis = 0; axis < 3; ++axis)
    if ((i >> axis & 1) == 0) s[axis] = -s[axis];
  return box.center + box.axes * s;
}

/// A box with a right-handed frame: u normalised, w orthogonal to u and v, and v made orthogonal to both.
Box box_of(const Vec3& center, const Vec3& half, const Vec3& u, const Vec3& v) {
  Box box = {center, {}, half};
  box.axes.col(0) = unit(u);
  box.axes.col(2) = unit(box.axes.col(0).cross(v));
  box.axes.col(1) = box.axes.col(2).cross(box.axes.col(0));
  return box;
}

/// The number line beside the boxes, parallel to an axis.
class Ruler {
 public:
  Ruler(const Setup& s, const Vec3& l) : s_(s), e_(l.normalized()) {
    const View view(Camera{}, 1, 1);
    away_ = beside(-view.up());
    if (away_.norm() < 0.6) away_ = beside(view.right());
    away_.normalize();
    clear_ = 0.3 + 0.6 * std::abs(e_.dot(view.forward()));  // what recedes is seen from above
    middle_ = (s.a.center + s.b.center) / 2;
    for (const Box* box : {&s.a, &s.b})
      for (int i = 0; i < 8; ++i) reach_ = std::max(reach_, (corner(*box, i) - middle_).dot(away_));
  }

  void draw(Scene& scene) const {
    const double a = s_.a.center.dot(e_), b = s_.b.center.dot(e_);
    const double r_a = radius(s_.a), r_b = radius(s_.b), to_b = a <= b ? 1 : -1;
    drop(scene, s_.a, to_b, a + to_b * r_a, 0);
    drop(scene, s_.b, -to_b, b - to_b * r_b, 1);
    span(scene, a, r_a, to_b, 0, Role::first, "*r*_a");
    span(scene, b, r_b, -to_b, 1, Role::second, "*r*_b");
    scene.items.push_back(Line{at(a, 0), at(a, 2), Role::construction, Pen::construction});
    scene.items.push_back(Line{at(b, 1), at(b, 2), Role::construction, Pen::construction});
    scene.items.push_back(Line{at(a, 2), at(b, 2), Role::highlight, Pen::highlight});
    if (std::abs(a - b) > 0.5) scene.items.push_back(Label{at(a, 2), "*d*", Role::text, at(b, 2)});
  }

 private:
  Vec3 beside(const Vec3& direction) const { return direction - direction.dot(e_) * e_; }
  Vec3 at(double t, int row) const {
    return middle_ + (t - middle_.dot(e_)) * e_ + (reach_ + clear_ + 0.36 * row) * away_;
  }
  double radius(const Box& box) const { return box.half.dot((box.axes.transpose() * e_).cwiseAbs()); }

  void span(Scene& scene, double center, double r, double towards, int row, Role role, const std::string& name) const {
    scene.items.push_back(Span{at(center - r, row), at(center + r, row), role, Pen::thick});
    scene.items.push_back(Dot{at(center, row), Mark::ring, role});
    scene.items.push_back(Label{at(center, row), name, role, at(center + towards * r, row)});
  }

  /// Draws a line from the box's corner farthest towards the other box down to the ruler.
  void drop(Scene& scene, const Box& box, double towards, double t, int row) const {
    Vec3 best = corner(box, 0);
    const auto rank = [&](const Vec3& p) { return 1e6 * towards * p.dot(e_) + p.dot(away_); };
    for (int i = 1; i < 8; ++i)
      if (rank(corner(box, i)) > rank(best)) best = corner(box, i);
    scene.items.push_back(Line{best, at(t, row), Role::construction, Pen::construction});
  }

  const Setup& s_;
  Vec3 e_, away_, middle_;
  double reach_ = 0, clear_;
};

/// Marks the face whose normal is tested, on the side of the other box.
void mark_face(Scene& scene, const Box& box, int axis, const Vec3& other) {
  const Vec3 u = box.axes.col((axis + 1) % 3) * box.half[(axis + 1) % 3],
             v = box.axes.col((axis + 2) % 3) * box.half[(axis + 2) % 3], n = box.axes.col(axis);
  const Vec3 p = box.center + (n.dot(other - box.center) < 0 ? -1 : 1) * box.half[axis] * n;
  Region face;
  face.rings = {{p - u - v, p + u - v, p + u + v, p - u + v}};
  face.role = Role::highlight, face.outlined = false;
  scene.items.push_back(face);
}

/// Marks an edge along the axis: of the four the one farthest along `towards`.
void mark_edge(Scene& scene, const Box& box, int axis, const Vec3& towards) {
  Vec3 p = box.center;
  for (int i = 0; i < 3; ++i)
    if (i != axis) p += (box.axes.col(i).dot(towards) < 0 ? -1 : 1) * box.half[i] * box.axes.col(i);
  const Vec3 along = box.half[axis] * box.axes.col(axis);
  scene.items.push_back(Line{p - along, p + along, Role::highlight, Pen::highlight});
}

void mark(Scene& scene, const Setup& s, const obb_obb::Axis& axis, const Vec3& l) {
  if (axis.kind == obb_obb::Kind::face_of_a) return mark_face(scene, s.a, axis.i, s.b.center);
  if (axis.kind == obb_obb::Kind::face_of_b) return mark_face(scene, s.b, axis.i, s.a.center);
  const Vec3 way = s.b.center - s.a.center;
  const Vec3 towards = l.norm() > 1e-9 ? Vec3(l * (l.dot(way) < 0 ? -1.0 : 1.0)) : way;
  mark_edge(scene, s.a, axis.i, towards);
  mark_edge(scene, s.b, axis.j, -towards);
}

}  // namespace

Setup setup(const Parameters& p) {
  const auto vector = [&](const char* name) { return std::get<Vec3>(p.at(name)); };
  Setup s;
  s.a_u = vector("a_u"), s.b_u = vector("b_u");
  s.a = box_of(vector("a"), vector("a_half"), s.a_u, vector("a_v"));
  s.b = box_of(vector("b"), vector("b_half"), s.b_u, vector("b_v"));
  s.epsilon = std::get<double>(p.at("epsilon"));
  s.truth = relate(s.a, s.b);
  return s;
}

obb_obb::Tested<3> projections(const Setup& s, const obb_obb::Axis& axis) {
  return obb_obb::tested(s.a, s.b, axis, std::nullopt);
}

std::string name_of(const obb_obb::Axis& axis) {
  const std::string a = std::string("**a**_") + side_names[axis.i];
  if (axis.kind == obb_obb::Kind::face_of_a) return a;
  if (axis.kind == obb_obb::Kind::face_of_b) return std::string("**b**_") + side_names[axis.i];
  return a + " × **b**_" + side_names[axis.j];
}

Scene picture(const Setup& s, Focus focus, const std::optional<obb_obb::Axis>& axis) {
  Scene scene;
  const Vec3 a = s.a.center, b = s.b.center;
  scene.items = {solid(s.a, Role::first), solid(s.b, Role::second)};
  if (focus == Focus::centers && a != b) {
    scene.items.push_back(Arrow{a, b, Role::highlight, Pen::highlight});
    scene.items.push_back(Label{a, "**l**", Role::text, b});
  }
  if (axis) {
    const Vec3 l = projections(s, *axis).l;
    mark(scene, s, *axis, l);
    if (focus == Focus::axis) Ruler(s, l).draw(scene);
  }
  if (focus == Focus::settled) shared_part(scene, s.a, s.b, s.truth);
  scene.items.push_back(Dot{a, Mark::disc, Role::first});
  scene.items.push_back(Dot{b, Mark::disc, Role::second});
  scene.items.push_back(Label{a, "**a**", Role::first});
  scene.items.push_back(Label{b, "**b**", Role::second});
  const Vec3 face_of_a = a + s.a.half.x() * unit(s.a_u), face_of_b = b + s.b.half.x() * unit(s.b_u);
  scene.handles = {{"a", Handle::Kind::point, a, Vec3::Zero(), Role::first},
                   {"a_u", Handle::Kind::vector, face_of_a, a, Role::first},
                   {"b", Handle::Kind::point, b, Vec3::Zero(), Role::second},
                   {"b_u", Handle::Kind::vector, face_of_b, b, Role::second}};
  return scene;
}

}  // namespace isect::lessons::obb_obb_lesson
