#pragma once
// The pictures of a ray and a polygon in space, and of the polygon's three projections.

#include <isect/ray_polygon.h>
#include "viz/lesson.h"

namespace isect::lessons::ray_polygon_lesson {

struct Setup {
  Ray<double, 3> ray;
  Ring<double, 3> ring;
  viz::Vec3 across, up;                  ///< what spans the polygon's plane
  viz::Vec3 center = viz::Vec3::Zero();  ///< a point of it where its normal is drawn beside
  RayPolygon<double> truth;
};
/// Corners that were moved lie on a grid of 1/64 in the plane, so that all stay in it exactly.
Setup setup(const viz::Parameters&);
inline constexpr int corner_count = 5;

/// What a step shows.
struct Shown {
  bool normal = false;
  bool plane = false;    ///< the plane, and where the line meets it
  bool settled = false;  ///< whether that counts
};
viz::Scene picture(const Setup&, const Shown&, const viz::Vec3& normal);

/// The polygon and the point without one of their coordinates, and what the plain crossings say of them.
struct Flat {
  int dropped;
  Ring<double, 2> ring;
  Point<double, 2> point;
  bool inside;
};
Flat flattened(const Setup&, const viz::Vec3& point, int dropped);

/// The three projections side by side.
viz::Scene projections(const Setup&, const viz::Vec3& point, const viz::Vec3& normal, int chosen);

/// How an edge lies to the point, in the projection.
struct Passing {
  int edge;
  double x;      ///< where it crosses the line through the point
  bool counted;  ///< on the point's right
};
viz::Scene crossings(const Setup&, const Flat&, const std::vector<Passing>&);

}  // namespace isect::lessons::ray_polygon_lesson
