#pragma once
// The hull of points in space by qhull.

#include <libqhull_r/qhull_ra.h>

#include <vector>

#include <isect/shapes.h>

namespace isect::bench::peers {

/// The number of its vertices; qhull moves the points' coordinates, so it gets a copy.
inline std::size_t qhull_vertices(std::vector<Point<double, 3>> points) {
  qhT state;
  qhT* qh = &state;
  qh_zero(qh, stderr);
  char command[] = "qhull";
  qh_new_qhull(qh, 3, static_cast<int>(points.size()), points[0].data(), False, command, nullptr, stderr);
  const std::size_t vertices = static_cast<std::size_t>(qh->num_vertices);
  qh_freeqhull(qh, qh_ALL);
  return vertices;
}

}  // namespace isect::bench::peers
