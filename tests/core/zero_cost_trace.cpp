// Compiled by zero_cost_trace.cmake, with and without the core's trace lines: the calls of some headers, named by
// INTERSECT, METHODS, RELATE, CAPSULES, ROUND, RAYS, CLIPS, LINES, STRAIGHTS, OUTLINES, POINTS, SOLIDS, ROUND_SOLIDS,
// PIECES or POLYGONS. LISTEN adds a listener.

#if defined(INTERSECT)
#include <isect/ray_sphere.h>
#elif defined(METHODS)
#include <isect/methods/ray_sphere.h>
#elif defined(RELATE)
#include <isect/aabb_aabb.h>
#include <isect/aabb_frustum.h>
#include <isect/interval_interval.h>
#include <isect/kdop_kdop.h>
#include <isect/methods/aabb_aabb.h>
#include <isect/methods/sphere_aabb.h>
#include <isect/methods/triangle_triangle.h>
#include <isect/obb_obb.h>
#include <isect/plane_aabb.h>
#include <isect/plane_sphere.h>
#include <isect/point_aabb.h>
#include <isect/point_obb.h>
#include <isect/point_sphere.h>
#include <isect/sphere_aabb.h>
#include <isect/sphere_frustum.h>
#include <isect/sphere_sphere.h>
#include <isect/triangle_aabb.h>
#elif defined(CAPSULES)
#include <isect/capsule_capsule.h>
#include <isect/sphere_capsule.h>
#elif defined(ROUND)
#include <isect/plane_cone.h>
#include <isect/plane_cylinder.h>
#include <isect/point_cone.h>
#include <isect/point_cylinder.h>
#include <isect/ray_cone.h>
#include <isect/ray_cylinder.h>
#include <isect/sphere_cone.h>
#include <isect/sphere_cylinder.h>
#elif defined(RAYS)
#include <isect/methods/ray_plane.h>
#include <isect/ray_aabb.h>
#include <isect/ray_obb.h>
#include <isect/ray_plane.h>
#include <isect/ray_polygon.h>
#include <isect/ray_triangle.h>
#elif defined(CLIPS)
#include <isect/clip_polygon.h>
#include <isect/clip_segment.h>
#elif defined(LINES)
#include <isect/line_line.h>
#include <isect/ray_capsule.h>
#elif defined(STRAIGHTS)
#include <isect/ray_half_spaces.h>
#include <isect/segment_plane.h>
#include <isect/segment_sphere.h>
#elif defined(OUTLINES)
#include <isect/ray_outline.h>
#include <isect/segment_polygon.h>
#elif defined(POINTS)
#include <isect/point_capsule.h>
#include <isect/point_kdop.h>
#include <isect/point_plane.h>
#elif defined(SOLIDS)
#include <isect/capsule_half_spaces.h>
#include <isect/half_spaces.h>
#include <isect/sphere_half_spaces.h>
#elif defined(ROUND_SOLIDS)
#include <isect/cone_half_spaces.h>
#include <isect/cylinder_half_spaces.h>
#elif defined(PIECES)
#include <isect/methods/triangle_triangle.h>
#include <isect/sphere_triangle.h>
#include <isect/triangle_half_spaces.h>
#else
#include <isect/convex_hull.h>
#include <isect/convex_polygons.h>
#include <isect/methods/point_polygon.h>
#include <isect/point_convex_polygon.h>
#include <isect/point_polygon.h>
#include <isect/segment_segment.h>
#endif

using namespace isect;

#ifdef LISTEN
template <class Event>
struct Listener {
  static inline Record<Event> record;
};
#define HEAR(...) , Listener<__VA_ARGS__>::record
#else
#define HEAR(...)
#endif

#if defined(INTERSECT)
#define CALLS(S, N)                                                               \
  RaySphere<S> call_intersect(const Ray<S, N>& ray, const Sphere<S, N>& sphere) { \
    return intersect(ray, sphere HEAR(ray_sphere::Event));                        \
  }                                                                               \
  bool call_intersects(const Ray<S, N>& ray, const Sphere<S, N>& sphere) {        \
    return intersects(ray, sphere HEAR(ray_sphere::Event));                       \
  }
CALLS(float, 2)
CALLS(double, 3)

#elif defined(METHODS)
#define CALLS(S, N)                                                                   \
  std::optional<S> call_quadratic(const Ray<S, N>& ray, const Sphere<S, N>& sphere) { \
    return ray_sphere::quadratic(ray, sphere HEAR(ray_sphere::QuadraticEvent<S, N>)); \
  }                                                                                   \
  std::optional<S> call_half_b(const Ray<S, N>& ray, const Sphere<S, N>& sphere) {    \
    return ray_sphere::half_b(ray, sphere HEAR(ray_sphere::QuadraticEvent<S, N>));    \
  }                                                                                   \
  std::optional<S> call_haines(const Ray<S, N>& ray, const Sphere<S, N>& sphere) {    \
    return ray_sphere::haines(ray, sphere HEAR(ray_sphere::HainesEvent<S, N>));       \
  }
CALLS(float, 2)
CALLS(double, 3)

#else
// clang-format off
using Box = Aabb<double, 3>;
using Ball = Sphere<double, 3>;
using Line = Ray<double, 3>;
using Spot = Point<double, 2>;
#ifdef RELATE
Relation call(const Interval<double>& a, const Interval<double>& b) { return relate(a, b HEAR(interval_interval::Event<double>)); }
Relation call(const Box& a, const Box& b) { return relate(a, b HEAR(aabb_aabb::Event<double, 3>)); }
bool call_by_axis(const Box& a, const Box& b) { return aabb_aabb::by_axis(a, b HEAR(aabb_aabb::Event<double, 3>)); }
bool call_meets(const Box& a, const Box& b) { return intersects(a, b HEAR(aabb_aabb::Event<double, 3>)); }
Relation call(const Ball& a, const Ball& b) { return relate(a, b HEAR(sphere_sphere::Event)); }
bool call_meets(const Ball& a, const Ball& b) { return intersects(a, b HEAR(sphere_sphere::Event)); }
Relation call(const Ball& a, const Box& b) { return relate(a, b HEAR(sphere_aabb::Event<double>)); }
bool call_accumulate(const Ball& a, const Box& b) { return sphere_aabb::accumulate_naive(a, b HEAR(sphere_aabb::Event<double>)); }
bool call(const Kdop<double, 3>& a, const Kdop<double, 3>& b) { return may_intersect(a, b HEAR(kdop_kdop::Event<double>)); }
Relation call(const Plane<double, 3>& a, const Box& b) { return relate(a, b HEAR(plane_aabb::Event<double, 3>)); }
Relation call(const Plane<double, 3>& a, const Ball& b) { return relate(a, b HEAR(plane_sphere::Event)); }
Culling call(const Box& a, const Frustum<double>& b) { return cull(a, b HEAR(aabb_frustum::Event)); }
Culling call(const Ball& a, const Frustum<double>& b) { return cull(a, b HEAR(sphere_frustum::Event)); }
Location call(const Point<double, 3>& a, const Box& b) { return locate(a, b HEAR(point_aabb::Event<double>)); }
Location call(const Point<double, 3>& a, const Ball& b) { return locate(a, b HEAR(point_sphere::Event)); }
Location call(const Point<double, 3>& a, const Obb<double, 3>& b) { return locate(a, b HEAR(point_obb::Event)); }
bool call(const Obb<double, 3>& a, const Obb<double, 3>& b) { return intersects(a, b HEAR(obb_obb::Event<3>)); }
bool call(const Triangle<double, 3>& a, const Box& b) { return intersects(a, b HEAR(triangle_aabb::Event<3>)); }
bool call_intervals(const Triangle<double, 3>& a, const Triangle<double, 3>& b) { return triangle_triangle::by_intervals(a, b HEAR(triangle_triangle::IntervalsEvent<double>)); }
#elif defined(CAPSULES)
using Pill = Capsule<double, 3>;
Relation call(const Ball& a, const Pill& b) { return relate(a, b HEAR(sphere_capsule::Event)); }
bool call_meets(const Ball& a, const Pill& b) { return intersects(a, b HEAR(sphere_capsule::Event)); }
Relation call(const Pill& a, const Pill& b) { return relate(a, b HEAR(capsule_capsule::Event)); }
bool call_meets(const Pill& a, const Pill& b) { return intersects(a, b HEAR(capsule_capsule::Event)); }
#elif defined(ROUND)
using Drum = Cylinder<double>;
using Cap = Cone<double>;
Location call(const Point<double, 3>& a, const Drum& b) { return locate(a, b HEAR(point_cylinder::Event)); }
Location call(const Point<double, 3>& a, const Cap& b) { return locate(a, b HEAR(point_cone::Event)); }
Relation call(const Plane<double, 3>& a, const Drum& b) { return relate(a, b HEAR(plane_cylinder::Event)); }
Relation call(const Plane<double, 3>& a, const Cap& b) { return relate(a, b HEAR(plane_cone::Event)); }
Relation call(const Ball& a, const Drum& b) { return relate(a, b HEAR(sphere_cylinder::Event)); }
Relation call(const Ball& a, const Cap& b) { return relate(a, b HEAR(sphere_cone::Event)); }
std::optional<Interval<double>> call(const Line& a, const Drum& b) { return intersect(a, b HEAR(ray_cylinder::Event)); }
std::optional<Interval<double>> call(const Line& a, const Cap& b) { return intersect(a, b HEAR(ray_cone::Event)); }
#elif defined(RAYS)
std::optional<Interval<double>> call(const Line& a, const Box& b) { return intersect(a, b HEAR(ray_aabb::Event)); }
std::optional<Interval<double>> call(const Line& a, const Obb<double, 3>& b) { return intersect(a, b HEAR(ray_obb::Event)); }
RayPlane<double> call(const Line& a, const Plane<double, 3>& b) { return intersect(a, b HEAR(ray_plane::Event<double>)); }
std::optional<double> call_textbook(const Line& a, const Plane<double, 3>& b) { return ray_plane::textbook(a, b HEAR(ray_plane::TextbookEvent<double>)); }
RayTriangle<double> call(const Line& a, const Triangle<double, 3>& b) { return intersect(a, b HEAR(ray_triangle::Event<double>)); }
RayPolygon<double> call(const Line& a, const Ring<double, 3>& b) { return intersect(a, b, FillRule::even_odd HEAR(ray_polygon::Event<double>)); }
#elif defined(CLIPS)
using Range = std::optional<Interval<double>>;
using Part = Segment<double, 3>;
Ring<double, 3> call(const Ring<double, 3>& a, const Plane<double, 3>& b) { return clip(a, b HEAR(clip_polygon::Event<double, 3>)); }
Ring<double, 3> call(const Ring<double, 3>& a, const Box& b) { return clip(a, b HEAR(clip_polygon::Event<double, 3>)); }
Range call(const Line& a, const Box& b) { return clip(a, b HEAR(ray_aabb::Event)); }
Range call(const Part& a, const Box& b) { return clip(a, b HEAR(ray_aabb::Event)); }
Range call(const Line& a, const Plane<double, 3>& b) { return clip(a, b HEAR(clip_segment::Event)); }
Range call(const Part& a, const Plane<double, 3>& b) { return clip(a, b HEAR(clip_segment::Event)); }
#elif defined(LINES)
using Pill = Capsule<double, 3>;
using Part = Segment<double, 3>;
line_line::Result call(const line_line::Straight& a, const line_line::Straight& b) { return intersect(a, b HEAR(line_line::Event)); }
bool call_meets(const Line& a, const Pill& b) { return intersects(a, b HEAR(ray_capsule::Event)); }
std::optional<Interval<double>> call(const Line& a, const Pill& b) { return intersect(a, b HEAR(ray_capsule::Event)); }
std::optional<Interval<double>> call(const Part& a, const Pill& b) { return intersect(a, b HEAR(ray_capsule::Event)); }
#elif defined(STRAIGHTS)
using Part = Segment<double, 3>;
RaySphere<double> call(const Part& a, const Ball& b) { return intersect(a, b HEAR(segment_sphere::Event)); }
RayPlane<double> call(const Part& a, const Plane<double, 3>& b) { return intersect(a, b HEAR(segment_plane::Event)); }
std::optional<Interval<double>> call(const Line& a, const HalfSpaces& b) { return intersect(a, b HEAR(ray_half_spaces::Event)); }
std::optional<Interval<double>> call(const Part& a, const HalfSpaces& b) { return intersect(a, b HEAR(ray_half_spaces::Event)); }
#elif defined(OUTLINES)
std::optional<double> call(const Ray<double, 2>& a, const Polygon<double, 2>& b) { return first_hit(a, b, FillRule::even_odd HEAR(ray_outline::Event)); }
std::optional<double> call(const Segment<double, 2>& a, const Polygon<double, 2>& b) { return first_hit(a, b, FillRule::even_odd HEAR(ray_outline::Event)); }
RayPolygon<double> call(const Segment<double, 3>& a, const Ring<double, 3>& b) { return intersect(a, b, FillRule::even_odd HEAR(segment_polygon::Event)); }
#elif defined(POINTS)
Location call(const Point<double, 3>& a, const Capsule<double, 3>& b) { return locate(a, b HEAR(point_capsule::Event)); }
Location call(const Point<double, 3>& a, const Kdop<double, 3>& b) { return locate(a, b HEAR(point_kdop::Event)); }
int call(const Plane<double, 3>& a, const Point<double, 3>& b) { return side(a, b HEAR(point_plane::Event)); }
#elif defined(SOLIDS)
Relation call(const HalfSpaces& a, const HalfSpaces& b) { return relate(a, b HEAR(half_spaces::Event)); }
Relation call(const Plane<double, 3>& a, const HalfSpaces& b) { return relate(a, b HEAR(half_spaces::Event)); }
Location call(const Point<double, 3>& a, const HalfSpaces& b) { return locate(a, b HEAR(half_spaces::Event)); }
Relation call(const Ball& a, const HalfSpaces& b) { return relate(a, b HEAR(sphere_half_spaces::Event)); }
Relation call(const Capsule<double, 3>& a, const HalfSpaces& b) { return relate(a, b HEAR(capsule_half_spaces::Event)); }
#elif defined(ROUND_SOLIDS)
Relation call(const Cylinder<double>& a, const HalfSpaces& b) { return relate(a, b HEAR(cylinder_half_spaces::Event)); }
Relation call(const Cone<double>& a, const HalfSpaces& b) { return relate(a, b HEAR(cone_half_spaces::Event)); }
#elif defined(PIECES)
using Piece = Triangle<double, 3>;
Relation call(const Ball& a, const Piece& b) { return relate(a, b HEAR(sphere_triangle::Event)); }
Relation call(const Capsule<double, 3>& a, const Piece& b) { return relate(a, b HEAR(sphere_triangle::Event)); }
Relation call(const Piece& a, const HalfSpaces& b) { return relate(a, b HEAR(triangle_half_spaces::Event)); }
bool call(const Piece& a, const Piece& b) { return intersects(a, b HEAR(triangle_half_spaces::Event)); }
bool call_signs(const Piece& a, const Piece& b) { return triangle_triangle::by_signs(a, b HEAR(triangle_triangle::SignsEvent)); }
#else
Winding call(const Spot& a, const Ring<double, 2>& b) { return winding(a, b HEAR(point_polygon::Event)); }
bool call_crossings(const Spot& a, const Ring<double, 2>& b) { return point_polygon::crossings_naive(a, b HEAR(point_polygon::NaiveEvent<double>)); }
Location call(const Spot& a, const ConvexPolygon<double>& b) { return locate(a, b HEAR(point_convex_polygon::Event)); }
Ring<double, 2> call(const Ring<double, 2>& a) { return convex_hull(a HEAR(convex_hull_2d::Event<double>)); }
Relation call(const ConvexPolygon<double>& a, const ConvexPolygon<double>& b) { return relate(a, b HEAR(convex_polygons::Event)); }
SegmentSegment<double> call(const Segment<double, 2>& a, const Segment<double, 2>& b) { return intersect(a, b HEAR(segment_segment::Event)); }
#endif
// clang-format on
#endif
