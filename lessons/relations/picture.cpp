// Pictures of a pair: the shapes, and what they share.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include <isect/clip_polygon.h>
#include <isect/kdop_polytope.h>
#include <isect/point_aabb.h>
#include <isect/point_obb.h>
#include "lessons/relations/picture.h"
#include "lessons/shared/plane.h"
#include "viz/solids.h"

namespace isect::lessons::relations_lesson {

using namespace viz;

namespace {

Vec3 in_space(const Point<double, 2>& p) { return in_plane(p.x(), p.y()); }

std::vector<Vec3> in_space(const Ring<double, 2>& ring) {
  std::vector<Vec3> points;
  for (const Point<double, 2>& p : ring) points.push_back(in_space(p));
  return points;
}

// What shapes share.

using Items = std::vector<Item>;

/// A flat part: a polygon, a segment or a point.
Item flat_part(const std::vector<Vec3>& ring) {
  if (ring.size() == 1) return Dot{ring[0], Mark::disc, Role::hit};
  if (ring.size() == 2) return Chain{ring, false, Role::hit, Pen::thick};
  return Region{.rings = {ring}, .role = Role::hit, .pen = Pen::thick};
}

void add_slabs(Kdop<double, 3>& kdop, const Aabb<double, 3>& box) {
  for (int i = 0; i < 3; ++i) {
    kdop.normals.push_back(Vec3::Unit(i));
    kdop.slabs.push_back(box.along(i));
  }
}
/// Adds the box's slabs. Its axes must be at right angles, as here; the numbers are short enough to be exact.
void add_slabs(Kdop<double, 3>& kdop, const Obb<double, 3>& box) {
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = box.axes.col(i);
    const double middle = axis.dot(box.center), reach = axis.squaredNorm() * box.half[i];
    kdop.normals.push_back(axis);
    kdop.slabs.push_back({middle - reach, middle + reach});
  }
}

/// The common part of two boxes: the k-DOP with the slabs of both.
template <class Box>
Items part(const Box& a, const Box& b) {
  Kdop<double, 3> kdop;
  add_slabs(kdop, a), add_slabs(kdop, b);
  const Polytope<double, 3> common = polytope(kdop);
  if (common.vertices.empty()) return {};
  if (common.faces.size() > 2) return {Solid{common.vertices, common.faces, Role::hit}};
  std::vector<Vec3> ring;
  if (common.faces.empty()) ring = common.vertices;
  if (!common.faces.empty())
    for (const int i : common.faces[0]) ring.push_back(common.vertices[i]);
  return {flat_part(ring)};
}

/// The circle or the point that the two surfaces share, if any.
Items part(const Sphere<double, 3>& a, const Sphere<double, 3>& b) {
  const Vec3 l = b.center - a.center;
  const double d = l.norm();
  if (!(d > 0)) return {};
  const double along = (d * d + a.radius * a.radius - b.radius * b.radius) / (2 * d);
  const double rest = a.radius * a.radius - along * along;
  const Vec3 middle = a.center + along / d * l;
  if (rest > 0) return {Circle{middle, std::sqrt(rest), Role::hit, Pen::thick, true, l}};
  if (rest == 0) return {Dot{middle, Mark::disc, Role::hit}};
  return {};
}

Items part(const ConvexPolygon<double>& a, const ConvexPolygon<double>& b) {
  Ring<double, 2> ring = a.vertices;
  for (std::size_t i = 0; i < b.vertices.size(); ++i) {
    const Point<double, 2>&p = b.vertices[i], &q = b.vertices[(i + 1) % b.vertices.size()];
    const Vec2 inwards(p.y() - q.y(), q.x() - p.x());
    ring = clip(ring, Plane<double, 2>{inwards, -inwards.dot(p)});
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  }
  if (ring.empty()) return {};
  return {flat_part(in_space(ring))};
}

// A common point of two touching shapes, for when rounding leaves nothing of their common part.

Vec3 nearest(const Aabb<double, 3>& box, const Vec3& x) { return x.cwiseMax(box.lo).cwiseMin(box.hi); }
Vec3 nearest(const Obb<double, 3>& box, const Vec3& x) {
  Vec3 point = box.center;
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = box.axes.col(i);
    point += std::clamp(axis.dot(x - box.center) / axis.squaredNorm(), -box.half[i], box.half[i]) * axis;
  }
  return point;
}

/// Finds it by alternating projections onto the two boxes.
template <class Box>
Items contact(const Box& a, const Box& b) {
  Vec3 p = nearest(a, Vec3::Zero());
  for (int i = 0; i < 500; ++i) p = nearest(a, nearest(b, p));
  return {Dot{p, Mark::disc, Role::hit}};
}
Items contact(const Sphere<double, 3>& a, const Sphere<double, 3>& b) {
  const Vec3 l = b.center - a.center;
  return {Dot{l.isZero(0) ? a.center : Vec3(a.center + a.radius * l.normalized()), Mark::disc, Role::hit}};
}
Items contact(const ConvexPolygon<double>& a, const ConvexPolygon<double>& b) {
  for (const auto& [of, other] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (const Point<double, 2>& p : of->vertices)
      if (locate(p, *other) != Location::out) return {Dot{in_space(p), Mark::disc, Role::hit}};
  return {};
}

// The points that decide whether one shape lies in the other.

std::vector<Vec3> corners(const Aabb<double, 3>& box) { return solid(box, Role::first).vertices; }
std::vector<Vec3> corners(const Obb<double, 3>& box) { return solid(box, Role::first).vertices; }

/// The point in `left` farthest from the other shape's middle, preferably in front.
std::optional<Vec3> clearest(const std::vector<Vec3>& left, const Vec3& middle) {
  const Vec3 viewer = across().cross(upwards());
  if (left.empty()) return {};
  return *std::ranges::max_element(left, {}, [&](const Vec3& p) { return (p - middle).norm() + p.dot(viewer) / 2; });
}

template <class Box>
std::optional<Vec3> outside(const Box& of, const Box& other) {
  std::vector<Vec3> left = corners(of);
  std::erase_if(left, [&](const Vec3& p) { return locate(p, other) != Location::out; });
  const std::vector<Vec3> around = corners(other);
  return clearest(left, (around.front() + around.back()) / 2);
}
std::optional<Vec3> outside(const ConvexPolygon<double>& of, const ConvexPolygon<double>& other) {
  std::vector<Vec3> left;
  for (const Point<double, 2>& p : of.vertices)
    if (locate(p, other) == Location::out) left.push_back(in_space(p));
  return clearest(left, in_space(other.vertices[0]));
}
std::optional<Vec3> outside(const Sphere<double, 3>& of, const Sphere<double, 3>& other) {
  const Vec3 away = of.center - other.center;
  const Vec3 unit = away.norm() > 0 ? Vec3(away.normalized()) : Vec3(Vec3::UnitY());
  const double reach = away.norm() + of.radius;
  if (!(reach > other.radius)) return {};
  return Vec3(of.center + of.radius * unit);
}

}  // namespace

std::optional<Vec3> left_over(const Shape& of, const Shape& other) {
  return std::visit([&]<class T>(const T& x) { return outside(x, std::get<T>(other)); }, of);
}

Items drawn(const Shape& shape, Role role) {
  if (const auto* ball = std::get_if<Sphere<double, 3>>(&shape)) return {Ball{ball->center, ball->radius, role}};
  if (const auto* box = std::get_if<Aabb<double, 3>>(&shape)) return {solid(*box, role)};
  if (const auto* box = std::get_if<Obb<double, 3>>(&shape)) return {solid(*box, role)};
  return {Region{.rings = {in_space(std::get<ConvexPolygon<double>>(shape).vertices)}, .role = role}};
}

Vec3 farthest(const Shape& shape, const Vec3& direction) {
  if (const auto* ball = std::get_if<Sphere<double, 3>>(&shape))
    return ball->center + ball->radius * direction.normalized();
  std::vector<Vec3> points;
  if (const auto* box = std::get_if<Aabb<double, 3>>(&shape)) points = corners(*box);
  if (const auto* box = std::get_if<Obb<double, 3>>(&shape)) points = corners(*box);
  if (const auto* polygon = std::get_if<ConvexPolygon<double>>(&shape)) points = in_space(polygon->vertices);
  return *std::ranges::max_element(points, {}, [&](const Vec3& p) { return p.dot(direction); });
}

Items shared(const Pair& pair) {
  if (!pair.meet) return {};
  if (pair.truth != Relation::touching && pair.truth != Relation::overlapping)
    return {};  // one of the two, which is drawn already
  return std::visit(
      [&]<class T>(const T& x) {
        const T& y = std::get<T>(pair.b);
        const bool point = pair.truth == Relation::touching && std::is_same_v<T, Sphere<double, 3>>;
        const Items common = point ? Items() : part(x, y);
        return common.empty() && pair.truth == Relation::touching ? contact(x, y) : common;
      },
      pair.a);
}

Items drawn(const Pair& pair, bool with_shared) {
  Items items = drawn(pair.a, Role::first);
  for (const Item& item : drawn(pair.b, Role::second)) items.push_back(item);
  if (with_shared)
    for (const Item& item : shared(pair)) items.push_back(item);
  return items;
}

}  // namespace isect::lessons::relations_lesson
