// What exactness costs, pair by pair: the default calls against the naive ones, side by side in one run. It is for work
// on one loop; `isect bench` judges the answers too, and with --peers asks other libraries.
//
// 65,536 distinct cases of each question in random order, so that branch prediction learns nothing. The first row of
// a question is what the others are compared with.

#include <Eigen/Geometry>
#include <cstdlib>
#include <numbers>

#include <isect/aabb_aabb.h>
#include <isect/convex_hull.h>
#include <isect/kdop_kdop.h>
#include <isect/obb_obb.h>
#include <isect/obb_obb_methods.h>
#include <isect/orient.h>
#include <isect/point_convex_polygon.h>
#include <isect/point_polygon.h>
#include <isect/ray_aabb.h>
#include <isect/ray_obb.h>
#include <isect/ray_plane.h>
#include <isect/ray_polygon.h>
#include <isect/ray_triangle.h>
#include <isect/sphere_aabb.h>
#include <isect/sphere_sphere.h>
#include <isect/triangle_aabb.h>
#include <isect/triangle_aabb_methods.h>
#include "bench/growth_shapes.h"
#include "bench/measure.h"
#include "bench/pair_cases.h"

using namespace isect;
using namespace isect::bench;

namespace {

int passes = 15;

template <class S>
std::string titled(const char* question) {
  return std::string(question) + (sizeof(S) == 4 ? " float" : " double");
}

template <class S>
void aabb_aabb_rows() {
  using Box = Eigen::AlignedBox<S, 3>;
  struct Case {
    Box a, b;
  };
  const auto cases = box_pairs<S>();
  std::vector<Case> boxes;
  for (const auto& c : cases) boxes.push_back({Box(c.a.lo, c.a.hi), Box(c.b.lo, c.b.hi)});

  Table table(titled<S>("aabb-aabb"));
  table.row("Eigen AlignedBox", timed(boxes, passes, [](const Case& c) { return c.a.intersects(c.b); }));
  table.row("intersects", timed(cases, passes, [](const auto& c) { return intersects(c.a, c.b); }));
  table.row("by_axis (naive)", timed(cases, passes, [](const auto& c) { return aabb_aabb::by_axis(c.a, c.b); }));
  table.row("relate", timed(cases, passes, [](const auto& c) { return relate(c.a, c.b) != Relation::disjoint; }));
}

template <class S>
void sphere_sphere_rows() {
  const auto cases = sphere_pairs<S>();
  Table table(titled<S>("sphere-sphere"));
  table.row("squared_distance (naive)",
            timed(cases, passes, [](const auto& c) { return sphere_sphere::squared_distance(c.a, c.b); }));
  table.row("intersects", timed(cases, passes, [](const auto& c) { return intersects(c.a, c.b); }));
  table.row("relate", timed(cases, passes, [](const auto& c) { return relate(c.a, c.b) != Relation::disjoint; }));
}

template <class S>
void sphere_aabb_rows() {
  const auto cases = sphere_box_pairs<S>();
  Table table(titled<S>("sphere-aabb"));
  table.row("accumulate (naive)",
            timed(cases, passes, [](const auto& c) { return sphere_aabb::accumulate(c.a, c.b); }));
  table.row("intersects", timed(cases, passes, [](const auto& c) { return intersects(c.a, c.b); }));
  table.row("relate", timed(cases, passes, [](const auto& c) { return relate(c.a, c.b) != Relation::disjoint; }));
}

template <class S>
void obb_obb_rows(double spread, const char* question) {
  const auto cases = obb_pairs<S>(spread);
  Table table(titled<S>(question));
  table.row("gottschalk (naive)",
            timed(cases, passes, [](const auto& c) { return obb_obb::gottschalk(c.a, c.b, S(1e-6)); }));
  table.row("intersects", timed(cases, passes, [](const auto& c) { return intersects(c.a, c.b); }));
  table.row("relate", timed(cases, passes, [](const auto& c) { return relate(c.a, c.b) != Relation::disjoint; }));
}

template <class S>
void triangle_aabb_rows() {
  const auto cases = triangle_box_pairs<S>();
  Table table(titled<S>("triangle-aabb"));
  table.row("akenine_moller (naive)",
            timed(cases, passes, [](const auto& c) { return triangle_aabb::akenine_moller(c.a, c.b); }));
  table.row("intersects", timed(cases, passes, [](const auto& c) { return intersects(c.a, c.b); }));
}

template <class S>
void kdop_kdop_rows() {
  const auto cases = kdop_pairs<S>();
  Table table(titled<S>("18-dop pair"));
  table.row("separating_slab", timed(cases, passes, [](const auto& c) { return !separating_slab(c.a, c.b); }));
  table.row("may_intersect", timed(cases, passes, [](const auto& c) { return may_intersect(c.a, c.b); }));
}

template <class S>
void ray_rows() {
  const auto boxes = ray_box_pairs<S>();
  Table box(titled<S>("ray-aabb"));
  box.row("slabs (naive)", timed(boxes, passes, [](const auto& c) { return ray_aabb::slabs(c.a, c.b).has_value(); }));
  box.row("intersect", timed(boxes, passes, [](const auto& c) { return intersect(c.a, c.b).has_value(); }));
  box.row("may_intersect", timed(boxes, passes, [](const auto& c) { return may_intersect(c.a, c.b); }));

  const auto triangles = ray_triangle_pairs<S>();
  Table triangle(titled<S>("ray-triangle"));
  triangle.row("moller_trumbore (naive)", timed(triangles, passes, [](const auto& c) {
                 return ray_triangle::moller_trumbore(c.a, c.b).has_value();
               }));
  triangle.row("intersect", timed(triangles, passes, [](const auto& c) { return intersect(c.a, c.b).t.has_value(); }));
  triangle.row("intersects", timed(triangles, passes, [](const auto& c) { return intersects(c.a, c.b); }));

  const auto obbs = ray_obb_pairs<S>();
  Table obb(titled<S>("ray-obb"));
  obb.row("projections (naive)",
          timed(obbs, passes, [](const auto& c) { return ray_obb::projections(c.a, c.b).has_value(); }));
  obb.row("intersect", timed(obbs, passes, [](const auto& c) { return intersect(c.a, c.b).has_value(); }));
  obb.row("intersects", timed(obbs, passes, [](const auto& c) { return intersects(c.a, c.b); }));

  const auto polygons = ray_polygon_pairs<S>(6);
  Table polygon(titled<S>("ray-polygon, n = 6"));
  polygon.row("projected (naive)",
              timed(polygons, passes, [](const auto& c) { return ray_polygon::projected(c.a, c.b).has_value(); }));
  polygon.row("intersect", timed(polygons, passes, [](const auto& c) { return intersect(c.a, c.b).t.has_value(); }));

  const auto planes = ray_plane_pairs<S>();
  Table plane(titled<S>("ray-plane"));
  plane.row("textbook (naive)",
            timed(planes, passes, [](const auto& c) { return ray_plane::textbook(c.a, c.b).has_value(); }));
  plane.row("intersect", timed(planes, passes, [](const auto& c) { return intersect(c.a, c.b).t.has_value(); }));
}

void orientation_rows() {
  const auto cases = point_triples();
  Table table("orient2d double");
  table.row("difference of products (naive)", timed(cases, passes, [](const auto& t) {
              return (t.a[0] - t.c[0]) * (t.b[1] - t.c[1]) > (t.a[1] - t.c[1]) * (t.b[0] - t.c[0]);
            }));
  table.row("orient2d", timed(cases, passes, [](const auto& t) { return orient2d(t.a, t.b, t.c) > 0; }));
}

/// Fewer queries on larger polygons: about a second for each row.
int queries(std::size_t vertices) {
  return static_cast<int>(std::clamp<std::size_t>(400'000'000 / (vertices * 8), 64, 65536));
}

void polygon_rows(std::size_t vertices) {
  const Ring<double, 2> ring = star(vertices);
  const auto points = query_points(queries(vertices), 1);
  const int rounds = vertices > 1000 ? 5 : passes;
  Table table("point in polygon, n = " + std::to_string(vertices));
  table.row("crossings_naive",
            timed(points, rounds, [&](const auto& p) { return point_polygon::crossings_naive(p, ring); }));
  table.row("locate", timed(points, rounds, [&](const auto& p) { return locate(p, ring) != Location::out; }));
}

void convex_rows(std::size_t vertices) {
  const auto convex = make_convex(convex_hull(regular(vertices)));
  if (!convex) return;
  const auto points = query_points(65536, 1);
  Table table("point in convex polygon, n = " + std::to_string(convex->vertices.size()));
  table.row("wedge_naive",
            timed(points, passes, [&](const auto& p) { return point_convex_polygon::wedge_naive(p, *convex); }));
  table.row("locate", timed(points, passes, [&](const auto& p) { return locate(p, *convex) != Location::out; }));
}

void hull_rows(bool circle) {
  const std::vector<Ring<double, 2>> one = {disc(1'000'000, circle)};
  Table table(circle ? "hull of 1e6 points on a circle" : "hull of 1e6 points in a disc");
  table.row("convex_hull", timed(one, 3, [](const auto& points) { return convex_hull(points).size(); }));
}

template <class S>
void all_pairs() {
  aabb_aabb_rows<S>();
  sphere_sphere_rows<S>();
  sphere_aabb_rows<S>();
  obb_obb_rows<S>(1.5, "obb-obb, near");
  obb_obb_rows<S>(4, "obb-obb, apart");
  triangle_aabb_rows<S>();
  kdop_kdop_rows<S>();
  ray_rows<S>();
}

}  // namespace

/// pair_speed [passes], 15 by default.
int main(int argc, char** argv) {
  if (argc > 1) passes = std::atoi(argv[1]);
  if (argc > 2 || passes < 1) {
    std::fprintf(stderr, "usage: %s [passes]\n", argv[0]);
    return 2;
  }
  Table::head(ISECT_FLAGS, "65,536 of each question (fewer of large polygons), seed 1, 3D but for polygons");
  all_pairs<double>();
  all_pairs<float>();
  orientation_rows();
  for (const std::size_t n : {100, 10'000, 1'000'000}) polygon_rows(n);
  for (const std::size_t n : {64, 10'000, 1'000'000}) convex_rows(n);
  hull_rows(false);
  hull_rows(true);
}
