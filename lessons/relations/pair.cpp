#include "lessons/relations/picture.h"

#include <isect/aabb_aabb.h>
#include <isect/convex_polygons.h>
#include <isect/obb_obb.h>
#include <isect/sphere_sphere.h>
#include "lessons/shared/plane.h"

namespace isect::lessons::relations_lesson {

using namespace viz;

namespace {

// Shape a of each kind. All numbers are dyadic, so that what touches does so exactly.

constexpr double radius = axis_length;
const Vec3 aabb_half = {1, 0.75, 0.75};
const Vec3 obb_half = {1, 0.75, 1};
const Ring<double, 2> outline = {{-1.25, -0.25}, {-0.5, -1}, {1, -0.5}, {1, 0.5}, {-0.25, 1}};

/// Columns of one length: a turn about y, that and a quarter, and one about a diagonal.
Eigen::Matrix3d axes(const std::string& turn) {
  Eigen::Matrix3d m;
  if (turn == "none") m << 117, 0, 44, 0, 125, 0, -44, 0, 117;
  if (turn == "quarter") m << 44, 0, -117, 0, 125, 0, 117, 0, 44;
  if (turn == "oblique") m << 128, -64, 128, 128, 128, -64, -64, 128, 128;
  return m / 128;
}

ConvexPolygon<double> polygon(const Pose& pose, double scale) {
  Eigen::Matrix2d m;
  m << 1, 0, 0, 1;
  if (pose.turn == "quarter") m << 0, -1, 1, 0;
  if (pose.turn == "oblique") m << 0.75, -1, 1, 0.75;
  ConvexPolygon<double> result;
  const Point<double, 2> center = place(pose.b);
  for (const Point<double, 2>& v : outline) result.vertices.push_back(scale * (center + pose.size * (m * v)));
  return result;
}

Shape shape(Kind kind, const Pose& pose, double scale) {
  const Vec3 center = scale * pose.b;
  const double size = scale * pose.size;
  switch (kind) {
    case Kind::balls:
      return Sphere<double, 3>{center, size * radius};
    case Kind::aabbs:
      return Aabb<double, 3>{center - size * aabb_half, center + size * aabb_half};
    case Kind::obbs:
      return Obb<double, 3>{center, axes(pose.turn), size * obb_half};
    case Kind::polygons:
      break;
  }
  return polygon(pose, scale);
}

}  // namespace

Point<double, 2> place(const Vec3& b) {
  constexpr double unit2 = axis_length * axis_length;
  return {b.dot(across()) / unit2, b.dot(upwards()) / unit2};
}

Pair::Pair(Kind the_kind, const Pose& pose, double scale)
    : kind(the_kind), a(shape(kind, {Vec3::Zero()}, scale)), b(shape(kind, pose, scale)) {
  std::visit(
      [&]<class T>(const T& x) {
        truth = relate(x, std::get<T>(b));
        meet = intersects(x, std::get<T>(b));
      },
      a);
}

std::string name(Kind kind) {
  const char* const names[] = {"balls", "AABBs", "OBBs", "polygons"};
  return names[static_cast<int>(kind)];
}
std::string one(Kind kind) { return name(kind).substr(0, name(kind).size() - 1); }
std::string they(Kind kind) { return "the " + name(kind); }

const std::vector<Situation>& situations(Kind kind) {
  using enum Relation;
  const auto six = [](const Pose& apart, const Pose& touch, const Pose& overlap, const Pose& around, const Pose& within,
                      const Pose& same) {
    return std::vector<Situation>{{"disjoint", "disjoint", disjoint, apart},
                                  {"touching", "touching", touching, touch},
                                  {"overlapping", "overlapping", overlapping, overlap},
                                  {"a-inside-b", "a inside b", a_inside_b, around},
                                  {"b-inside-a", "b inside a", b_inside_a, within},
                                  {"equal", "equal", equal, same}};
  };
  const Vec3 nearer = {0.28125, 0.1953125, 0.375};  // towards the viewer, for a circle that is seen
  static const std::vector<Situation> balls =
      six({in_plane(2.25, 0.25), 0.75}, {in_plane(1.75, 0), 0.75}, {in_plane(1.125, 0.125) + nearer, 0.75},
          {in_plane(0.25, 0.25), 1.375}, {in_plane(-0.25, 0.25), 0.5}, {Vec3::Zero()});
  static const std::vector<Situation> aabbs =
      six({{2.5, 0.125, -0.375}, 0.75}, {{1.75, -0.125, 0.25}, 0.75}, {{1.125, 0.375, 0.25}, 0.75},
          {{0.125, 0.125, 0}, 1.375}, {{-0.25, -0.125, 0.125}, 0.5}, {Vec3::Zero()});
  // The touching one: a corner of b in the middle of a's side, where 117 x - 44 z = 266.5 to the last bit.
  static const std::vector<Situation> obbs =
      six({{2.5, 0.25, -0.75}, 0.5, "oblique"}, {{2.1015625, 0, -0.46875}, 0.5, "oblique"},
          {{1.5, 0.375, 0}, 0.5, "oblique"}, {{0.125, 0.125, 0}, 1.375}, {{0, 0, 0}, 0.25, "oblique"},
          {Vec3::Zero(), 1, "quarter"});
  static const std::vector<Situation> polygons =
      six({in_plane(2.25, 0.25), 0.75, "quarter"}, {in_plane(1.75, 0.125), 0.75, "quarter"},
          {in_plane(1.25, 0.25), 0.75, "quarter"}, {in_plane(0.125, 0.125), 1.375},
          {in_plane(-0.125, 0), 0.5, "quarter"}, {Vec3::Zero()});
  const std::vector<Situation>* const all[] = {&balls, &aabbs, &obbs, &polygons};
  return *all[static_cast<int>(kind)];
}

}  // namespace isect::lessons::relations_lesson
