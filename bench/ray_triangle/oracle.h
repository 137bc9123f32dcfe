#pragma once
// Where a ray meets a triangle, in rationals.

#include <algorithm>

#include "bench/rational.h"

namespace isect::oracle {

/// What a ray and a triangle truly have in common.
struct RayTriangle {
  bool coplanar = false;
  Location location = Location::out;
  Rational t, u, v;
  bool hit = false;
};

/// Solves o + t d = a + u (b - a) + v (c - a). For finite shapes.
template <class S>
RayTriangle ray_triangle(const Ray<S, 3>& ray, const Triangle<S, 3>& triangle) {
  const auto vertex = [&](int i) { return rational<S, 3>(triangle.vertices[i]); };
  const auto o = rational<S, 3>(ray.origin), d = rational<S, 3>(ray.direction);
  const auto e = vertex(1) - vertex(0), f = vertex(2) - vertex(0), from = o - vertex(0);
  const auto det = [](const auto& x, const auto& y, const auto& z) { return dot(cross(x, y), z); };
  RayTriangle result;
  const Rational whole = det(e, f, d);
  if (whole == 0) {
    const auto n = cross(e, f);
    result.coplanar = dot(n, n) != 0 && dot(n, from) == 0;
    return result;
  }
  result.t = -det(e, f, from) / whole;
  result.u = det(from, f, d) / whole;
  result.v = det(e, from, d) / whole;
  const Rational least = std::min({result.u, result.v, Rational(1 - result.u - result.v)});
  result.location = least > 0 ? Location::in : least == 0 ? Location::on : Location::out;
  result.hit = least >= 0 && holds(ray.range, result.t);
  return result;
}

/// How far the point at t of the ray lies off the triangle's plane, relative to the sizes of what is summed; 0 for an
/// infinite t.
template <class S>
double off_plane(const Ray<S, 3>& ray, const Triangle<S, 3>& triangle, double t) {
  if (!std::isfinite(t)) return 0;
  const auto vertex = [&](int i) { return rational<S, 3>(triangle.vertices[i]); };
  const auto p = rational<S, 3>(ray.origin) + Rational(t) * rational<S, 3>(ray.direction);
  const auto n = cross(vertex(1) - vertex(0), vertex(2) - vertex(0));
  Rational size = 0;
  for (int i = 0; i < 3; ++i) size += abs(n[i]) * (abs(p[i]) + abs(vertex(0)[i]));
  return size == 0 ? 0 : std::abs(static_cast<double>(Rational(dot(n, p - vertex(0)) / size)));
}

}  // namespace isect::oracle
