#pragma once
// How far a segment, or a point, is from a triangle, in rationals.

#include <array>
#include <optional>

#include "bench/half_spaces/oracle.h"

namespace isect::oracle {

/// The least distance of two segments among all that may be it, and 0 where one passes through the triangle.
inline Rational distance2(const Stretch<3>& segment, const Triangle<double, 3>& triangle) {
  std::array<Place, 3> v;
  for (std::size_t i = 0; i < 3; ++i) v[i] = rational(triangle.vertices[i]);
  std::optional<Rational> least;
  const auto take = [&](const Rational& d2) {
    if (!least || d2 < *least) least = d2;
  };
  for (std::size_t i = 0; i < 3; ++i) take(distance2<3>(segment, Stretch<3>{v[i], v[(i + 1) % 3] - v[i]}));
  const Place n = cross(v[1] - v[0], v[2] - v[0]);
  if (dot(n, n) == 0) return *least;
  const Sides around = sides(triangle);
  if (part(segment.p, segment.at(1), around)) return 0;
  for (const Place& end : {segment.p, segment.at(1)}) {
    const Place foot = end - (around[0].at(end) / dot(n, n)) * n;
    if (holds(around, foot)) take(distance2<3>(foot, end));
  }
  return *least;
}

}  // namespace isect::oracle
