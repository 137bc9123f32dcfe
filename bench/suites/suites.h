#pragma once
// One function a test of the note: it draws the families, enters the methods, and adds their rows to the session.

#include "bench/session.h"

namespace isect::bench {

void measure_point_point(Session&);
void measure_interval_interval(Session&);
void measure_aabb_aabb(Session&);
void measure_sphere_sphere(Session&);
void measure_sphere_aabb(Session&);
void measure_obb_obb(Session&);
void measure_kdop_kdop(Session&);
void measure_ray_sphere(Session&);
void measure_ray_aabb(Session&);
void measure_ray_plane(Session&);
void measure_ray_triangle(Session&);
void measure_ray_polygon(Session&);
void measure_orient(Session&);
void measure_point_polygon(Session&);
void measure_convex_polygon(Session&);
void measure_point_location(Session&);
void measure_all_pairs(Session&);
void measure_bvh(Session&);
void measure_hulls(Session&);
void measure_smallest_sphere(Session&);

}  // namespace isect::bench
