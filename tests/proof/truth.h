#pragma once
// What an object of a scene is as a set of points, and how two such sets lie, in rationals.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "bench/round_oracle.h"
#include "tests/proof/polytope.h"

namespace isect::proof {

using Json = nlohmann::ordered_json;

/// The ends of a part of a line: null where it has none.
struct Range {
  std::optional<Rational> lo, hi;
};

/// An object as a set. `kind` says which members define it; the others are empty.
struct Thing {
  enum class Kind {
    body,     ///< convex and bounded: what lies within `radius` of the hull of `points`
    round,    ///< a cylinder or a cone, `solid`
    line,     ///< origin + t direction, t in `range`
    plane,    ///< normal . x + d = 0
    region,   ///< in the plane: what `rings` go round an odd number of times, with the rings
    surface,  ///< in space: triangles
    cloud     ///< points
  };
  Kind kind;
  std::string type;  ///< as files call it
  bool flat;

  Points points = {};  ///< a body's or a cloud's; of a line: origin and direction
  Rational radius = 0;
  Faces faces = {};  ///< of a body without radius
  Range range = {};
  Vec normal = {};
  Rational d = 0;
  std::vector<Points> rings = {};  ///< also the outline of a triangle or polygon in space
  std::vector<Points> triangles = {};
  bool closed = false;  ///< of a surface
  oracle::RoundSolid solid = {};

  /// `planes` are those of a frustum, to which its numbers are rounded.
  static Thing read(const Json& object, bool flat, const Faces& planes = {});
};

Rational rational(double);
Vec vec(const Json&);

/// Whether there is a test of how the two lie, and the truth is found in reasonable time. Two round solids have none,
/// nor has one with a capsule; a polytope of many faces is not judged beside one.
bool has_test(const Thing&, const Thing&);

/// Whether the test of two things in the plane says more than that they meet: it does not for a polygon with an area
/// and a solid of half-spaces without one.
bool has_relation(const Thing&, const Thing&);

/// -1 in the interior, 0 on the boundary, 1 outside. A thing without an interior consists of its boundary.
int place(const Vec&, const Thing&);
bool meet(const Thing&, const Thing&);
/// Whether some point is interior to both sets, each within the line, plane or space that it spans. They may be bodies;
/// in the plane also regions; a polygon in space and a body, or another one; a mesh and a body that has a volume.
bool interiors_meet(const Thing&, const Thing&);
/// Whether the first lies in the second, for the same sets, or in a plane.
bool lies_in(const Thing&, const Thing&);
/// How many triangles of the first have a point in the second.
int triangles_met(const Thing& surface, const Thing&);
/// On which sides of a plane a bounded thing has points: behind, on, before.
std::array<bool, 3> sides(const Thing& plane, const Thing&);

/// Two lines or parts of them.
struct Crossing {
  enum class Lines { skew, parallel, other } lines;
  enum class Common { nothing, point, stretch } common;
  bool within_both = false;  ///< the point is an end of neither
};
Crossing crossing(const Thing&, const Thing&);

/// The part of a line in another thing, by t; nothing if they have no common point. The other must not be round, nor
/// have a radius. If the other is not
/// convex, only the beginning of the part is right.
std::optional<Range> part_in(const Thing& line, const Thing&);

/// Whether a line touches a ball: the whole line, beyond its ends as well.
bool tangent(const Thing& line, const Thing& ball);
/// Whether a point lies on the outline of a triangle or a polygon in space.
bool on_outline(const Vec&, const Thing&);
/// Whether a line lies in the plane of a triangle or a polygon in space.
bool in_plane_of(const Thing& line, const Thing&);
/// The point at t.
Vec at(const Thing& line, const Rational& t);
/// 1 left of the line, -1 right of it, 0 on it, in the plane.
int side(const Vec&, const Thing& line);

}  // namespace isect::proof
