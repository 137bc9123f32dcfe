#pragma once
// Two shapes of one kind, how they lie by the core's own test, and how they are drawn.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <isect/point_convex_polygon.h>
#include <isect/shapes.h>
#include "viz/lesson.h"

namespace isect::lessons::relations_lesson {

enum class Kind { balls, aabbs, obbs, polygons };
inline constexpr Kind kinds[] = {Kind::balls, Kind::aabbs, Kind::obbs, Kind::polygons};

/// How b differs from a, which stays at the origin: its place, its size in sizes of a, and how it is turned.
struct Pose {
  viz::Vec3 b;
  double size = 1;
  std::string turn = "none";
};
inline const std::vector<std::string> turns = {"none", "quarter", "oblique"};

using Shape = std::variant<Sphere<double, 3>, Aabb<double, 3>, Obb<double, 3>, ConvexPolygon<double>>;

/// The place of b in the polygons' plane, in units of axis_length.
Point<double, 2> place(const viz::Vec3& b);

/// Both shapes, `scale` times as large: a power of two changes nothing about how they lie.
struct Pair {
  Pair(Kind, const Pose&, double scale = 1);

  Kind kind;
  Shape a, b;
  Relation truth;  ///< by `relate`
  bool meet;       ///< by `intersects`
};

/// A relation as its preset is named and titled, and the pose that has it.
struct Situation {
  const char *id, *title;
  Relation relation;
  Pose pose;
};
/// The six relations of a kind, in the order in which they are shown.
const std::vector<Situation>& situations(Kind);

std::string they(Kind);  ///< "the balls"
std::string name(Kind);  ///< "balls", as choice and heading
std::string one(Kind);   ///< "ball"

/// A point of `of` that does not lie in `other`, if there is one: a vertex, or a ball's point farthest out.
std::optional<viz::Vec3> left_over(const Shape& of, const Shape& other);

std::vector<viz::Item> drawn(const Shape&, viz::Role);
/// What they share: a solid, a polygon, a segment or a point; for balls the circle of their surfaces.
std::vector<viz::Item> shared(const Pair&);
/// The pair, with what it shares if `with_shared`.
std::vector<viz::Item> drawn(const Pair&, bool with_shared);
/// The point of a shape that is nearly the farthest in that direction, for its name.
viz::Vec3 farthest(const Shape&, const viz::Vec3& direction);

}  // namespace isect::lessons::relations_lesson
