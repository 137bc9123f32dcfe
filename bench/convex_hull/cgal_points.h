#pragma once
// Clouds of points as CGAL takes them.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

#include "bench/growth_shapes.h"

namespace isect::bench::peers {

using HullKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline auto cgal_cloud(bool ball) {
  return [ball](int n) {
    std::vector<HullKernel::Point_3> points;
    for (const Point<double, 3>& p : cloud(n, ball)) points.emplace_back(p[0], p[1], p[2]);
    return points;
  };
}

}  // namespace isect::bench::peers
