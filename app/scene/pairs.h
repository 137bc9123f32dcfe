#pragma once
// The table of pairs of objects that have an exact test.

#include <vector>

#include <isect/shapes.h>

#include "app/scene/questions.h"

namespace isect::program::scene {

/// One test: the query that asks the same, if any, and how the core is asked. `ask` returns the answer and the result;
/// and words, if those of `tell` are not enough.
struct Pair {
  Type a, b;
  const char* kind;
  enum class In { both, plane, space } in;
  void (*ask)(const Shaped& a, const Shaped& b, Told&);

  bool fits(bool flat) const { return in == In::both || (in == In::plane) == flat; }
};

/// Returns the pairs that a query can ask, too.
std::vector<Pair> pairs_of_queries();
/// Returns pairs of meshes, clouds, frusta and k-DOPs that report more than how they lie.
std::vector<Pair> pairs_of_sets();
/// Returns pairs of outlines, lines and segments in the plane; of points and corners beside a line or a plane.
std::vector<Pair> pairs_in_plane();
/// Returns pairs of convex solids with what they are asked about; of lines in space.
std::vector<Pair> pairs_of_solids();
/// Returns pairs of polygons in space, except those with a ray, a line or a segment.
std::vector<Pair> pairs_of_polygons();

// Shared by the tables.

/// Return the answer of isect/ask.h.
Answer by_core(const Shaped& a, const Shaped& b);
Answer by_core(const viz::Vec3& point, const Shaped&);
Answer by_core(const Ray<double, 3>&, const Shaped&);
Answer by_core(const Triangle<double, 3>&, const Shaped&);
// Set the answer and the result's relation, location, first t or stretch of a line.

void give(Relation, Told&);
void relate(const Shaped& a, const Shaped& b, Told&);
void locate(const Shaped& a, const Shaped& b, Told&);
void tell_first(const std::optional<double>& t, Told&);
void tell_part(const std::optional<Interval<double>>& part, Told&);
/// Whether the point lies on an object without inside: a point, a segment, a ray, a line, a triangle in space, a cloud.
bool lies_on(const viz::Vec3&, const Shaped&);
/// Tells where each point of cloud a lies: in, on or out of b, or on what is thin and out of it.
void tell_cloud(const Shaped& a, const Shaped& b, const std::vector<Location>& where, Told&);
void tell_cloud_on(const Shaped& a, const Shaped& b, const std::vector<Location>& where, Told&);
/// Tells how far the corners of a polygon in space lie off one plane, if they do.
void tell_bent(const Shaped&, Told&);
/// Throws NotDecided for an outline that has no area, crosses or touches itself.
[[noreturn]] void refuse_outline(const Object&);

/// Returns "A and B", by name.
std::string both_names(const Shaped& a, const Shaped& b);
/// Adds verdict, values and marks of an answer, and its formula.
void tell(const Shaped& a, const Shaped& b, Told&);
/// Returns the pair's query: the kind and its fields.
Json query_of(const char* kind, const Shaped& a, const Shaped& b);

/// Returns the direction of a ray, line or segment for its lesson. Throws NotDecided for a segment that is no ray.
viz::Vec3 direction_of(const NamedValues&, const Object& a);

}  // namespace isect::program::scene
