#pragma once
// Bodies of a suite of pairs as the oracle sees them: by their planes, whatever the core makes of these.

#include "bench/half_spaces/oracle.h"
#include "bench/pair_draws.h"

namespace isect::bench {

inline oracle::Sides sides_of(const Body& body) {
  oracle::Sides all;
  for (const Plane<double, 3>& plane : body.planes)
    all.push_back({oracle::rational(plane.normal), oracle::Rational(plane.d)});
  return all;
}
/// The planes through the corners of each facet, turned so that the middle of all corners is inside.
inline oracle::Sides sides_of(const Hull3<double>& hull) {
  using oracle::operator-, oracle::operator*;
  std::vector<oracle::Place> corners;
  for (const Point<double, 3>& v : hull.vertices) corners.push_back(oracle::rational(v));
  const oracle::Place inner = oracle::middle(corners);
  oracle::Sides all;
  for (const auto& [i, j, k] : hull.triangles) {
    const oracle::Place& a = corners[i];
    oracle::Place n = oracle::cross(corners[j] - a, corners[k] - a);
    if (oracle::dot(n, inner - a) < 0) n = oracle::Rational(-1) * n;
    all.push_back({n, -oracle::dot(n, a)});
  }
  return all;
}
/// The tetrahedra between the star's center and its triangles.
inline std::vector<oracle::Sides> tetrahedra_of(const Star& star) {
  using oracle::operator-, oracle::operator*;
  std::vector<oracle::Sides> all;
  for (const auto& triangle : star.mesh.triangles) {
    std::array<oracle::Place, 4> v = {oracle::rational(star.center)};
    for (std::size_t i = 0; i < 3; ++i) v[i + 1] = oracle::rational(star.mesh.vertices[triangle[i]]);
    oracle::Sides sides;
    for (std::size_t i = 0; i < 4; ++i) {  // the plane through the three other corners, with this one inside
      const oracle::Place &a = v[(i + 1) % 4], &b = v[(i + 2) % 4], &c = v[(i + 3) % 4];
      oracle::Place n = oracle::cross(b - a, c - a);
      if (oracle::dot(n, v[i] - a) < 0) n = oracle::Rational(-1) * n;
      sides.push_back({n, -oracle::dot(n, a)});
    }
    all.push_back(sides);
  }
  return all;
}

}  // namespace isect::bench
