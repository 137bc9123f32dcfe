#pragma once
// The table of pairs of objects that have an exact test, and how their results are told.

#include <optional>
#include <string>
#include <vector>

#include <isect/shapes.h>

#include "app/scene/questions.h"

namespace isect::program::scene {

/// One test: which query answers it, how the two objects are written there, how its result is told. What no query asks
/// has no kind: `written` is then the result.
struct Pair {
  Type a, b;
  const char* kind;
  enum class In { both, plane, space } in;
  Json (*written)(const Setting&, const Object& a, const Object& b);
  void (*tell)(const Setting&, const Object& a, const Object& b, Answer&);

  bool fits(bool flat) const { return in == In::both || (in == In::plane) == flat; }
};

/// Those of k-DOPs, frusta, hulls, meshes and clouds.
std::vector<Pair> pairs_of_many_numbers();
/// Those of outlines, lines and segments in the plane; a point beside a line or a plane.
std::vector<Pair> pairs_in_plane();

/// Convex solids and what they are asked about; lines in space.
std::vector<Pair> pairs_of_solids();
/// Those of polygons in space, but what runs along a line.
std::vector<Pair> pairs_of_polygons();

// What the tables share.

/// As "relation".
Json as_relation(Relation);
/// The corners of an outline that goes once round a convex area, counter-clockwise, however often it names a corner or
/// a point of a side; nothing of another outline.
std::optional<Ring<double, 2>> convex_corners(const Ring<double, 2>&);

/// How two convex solids lie, or a ball or a capsule and one, as "relation".
Json relation_of_solids(const Setting&, const Object& a, const Object& b);
/// A triangle or a polygon in space as triangles. Throws NotDecided where its outline has none, or too many corners.
std::vector<Triangle<double, 3>> surface_of(const Setting&, const Object&);
/// Whether the corners of a polygon in space lie in no one plane: then it is the triangles that it is cut into.
bool is_bent(const Setting&, const Object& polygon);
/// Where a ray, line or segment first meets such a one.
Answer along_surface(const Setting&, const Object& a, const Object& polygon);
/// How a surface (A) of triangles lies to a ball or a capsule that has a volume: its own points count, not what it may
/// enclose.
Relation relate_surface(const std::vector<Triangle<double, 3>>&, const Capsule<double, 3>&);
/// What the pair's query says, of segment a with both its ends as given, where their difference is no vector of
/// floating-point numbers; nothing if there is no such test.
std::optional<Json> exact_of_segment(const Setting&, const Object& a, const Object& b);

/// Throws NotDecided: an outline that has no area, crosses or touches itself.
[[noreturn]] void refuse_outline(const Object&);

/// "relation" of a result; where it has none, whether they meet.
void relate(const Setting&, const Object& a, const Object& b, Answer&);
/// The point a and the shape b: `where` is in, on or out.
void locate(const Object& a, const Object& b, Answer&, const std::string& where);
/// Whether the point lies on what has no inside: a point, a segment, a ray, a line, a triangle in space, a cloud.
bool lies_on(const Setting&, const viz::Vec3&, const Object&);
/// A ray, line or segment a, which the core takes as a ray. Throws NotDecided for a segment that is none.
viz::Vec3 origin_of(const Setting&, const Object& a);
viz::Vec3 direction_of(const Setting&, const Object& a);
Ray<double, 3> ray_in_space(const Setting&, const Object& a);
/// The same of a segment, with both ends as given.
Segment<double, 3> segment_of(const Setting&, const Object& a);
/// Where b is reached, on a's line, by rising t. As a query writes t: infinite beyond the largest number, and null
/// where there is none.
void add_hit(const Setting&, const Object& a, Answer&, const char* name, const Json& t, viz::Mark);
/// The verdict of whatever runs along a line, after its hits.
void meets(const Object& a, const Object& b, Answer&, bool hit);
/// How many triangles of mesh a have a point in b: the result's triangles_met.
void tell_mesh(const Setting&, const Object& a, const Object& b, Answer&);
/// Whether they have a common point: the result's meet.
void tell_meeting(const Setting&, const Object& a, const Object& b, Answer&);
/// Whether point a lies on b: the result's on.
void tell_on(const Setting&, const Object& a, const Object& b, Answer&);
/// Which points of cloud a lie on b: the result's on and out.
void tell_cloud_on(const Setting&, const Object& a, const Object& b, Answer&);

}  // namespace isect::program::scene
