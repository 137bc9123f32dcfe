#pragma once
// Ordinary cases for timing: sizes and distances of the order of one, about as many hits as misses.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <isect/fit.h>
#include <isect/parts/directions.h>
#include <isect/shapes.h>
#include "bench/random.h"

namespace isect::bench {

inline constexpr int case_count = 1 << 16;

template <class A, class B>
struct Pair {
  A a;
  B b;
};
struct Triple {
  Point<double, 2> a, b, c;
};

template <class A, class B, class DrawA, class DrawB>
std::vector<Pair<A, B>> pairs(const char* name, const DrawA& draw_a, const DrawB& draw_b) {
  Random random(stream(1, name));
  std::vector<Pair<A, B>> all;
  all.reserve(case_count);
  for (int i = 0; i < case_count; ++i) {
    const A a = draw_a(random);
    all.push_back({a, draw_b(random)});
  }
  return all;
}

template <class S>
Aabb<S, 3> ordinary_box(Random& random) {
  const Point<double, 3> center = random.in_box<3>(1), half = random.in_box<3>(0.3) + Vector<double, 3>::Constant(0.4);
  return {(center - half).cast<S>(), (center + half).cast<S>()};
}
template <class S>
Sphere<S, 3> ordinary_sphere(Random& random) {
  return {random.in_box<3>(1).template cast<S>(), static_cast<S>(random.uniform(0.2, 0.8))};
}
template <class S>
Ray<S, 3> ordinary_ray(Random& random) {
  const Point<double, 3> from = 3 * random.heading<3>(), towards = random.in_box<3>(1);
  return {from.cast<S>(), (towards - from).cast<S>()};
}
template <class S>
Obb<S, 3> ordinary_obb(Random& random, double spread) {
  const Eigen::Quaterniond turn =
      Eigen::AngleAxisd(random.uniform(0, 2 * std::numbers::pi), random.heading<3>()) * Eigen::Quaterniond::Identity();
  const Vector<double, 3> half = random.in_box<3>(0.4) + Vector<double, 3>::Constant(0.6);
  return {random.in_box<3>(spread).template cast<S>(), turn.toRotationMatrix().cast<S>(), half.cast<S>()};
}

template <class S>
auto box_pairs() {
  return pairs<Aabb<S, 3>, Aabb<S, 3>>("aabb-aabb", ordinary_box<S>, ordinary_box<S>);
}
template <class S>
auto sphere_pairs() {
  return pairs<Sphere<S, 3>, Sphere<S, 3>>("sphere-sphere", ordinary_sphere<S>, ordinary_sphere<S>);
}
template <class S>
auto sphere_box_pairs() {
  return pairs<Sphere<S, 3>, Aabb<S, 3>>("sphere-aabb", ordinary_sphere<S>, ordinary_box<S>);
}
template <class S>
auto obb_pairs(double spread) {
  const auto draw = [spread](Random& random) { return ordinary_obb<S>(random, spread); };
  return pairs<Obb<S, 3>, Obb<S, 3>>("obb-obb", draw, draw);
}
template <class S>
auto ray_box_pairs() {
  return pairs<Ray<S, 3>, Aabb<S, 3>>("ray-aabb", ordinary_ray<S>, ordinary_box<S>);
}
template <class S>
Triangle<S, 3> ordinary_triangle(Random& random) {
  const auto corner = [&] { return Point<S, 3>(random.in_box<3>(1.5).template cast<S>()); };
  const Point<S, 3> a = corner(), b = corner();
  return {{a, b, corner()}};
}
template <class S>
auto ray_triangle_pairs() {
  return pairs<Ray<S, 3>, Triangle<S, 3>>("ray-triangle", ordinary_ray<S>, ordinary_triangle<S>);
}
template <class S>
auto triangle_box_pairs() {
  return pairs<Triangle<S, 3>, Aabb<S, 3>>("triangle-aabb", ordinary_triangle<S>, ordinary_box<S>);
}
template <class S>
auto ray_obb_pairs() {
  return pairs<Ray<S, 3>, Obb<S, 3>>("ray-obb", ordinary_ray<S>,
                                     [](Random& random) { return ordinary_obb<S>(random, 1); });
}
/// A star of n vertices in a plane, but for rounding.
template <class S>
auto ray_polygon_pairs(int n) {
  return pairs<Ray<S, 3>, Ring<S, 3>>("ray-polygon", ordinary_ray<S>, [n](Random& random) -> Ring<S, 3> {
    const Vector<double, 3> center = random.in_box<3>(0.5), u = random.heading<3>(),
                            v = u.cross(random.heading<3>()).normalized();
    Ring<S, 3> ring;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n, radius = random.uniform(0.4, 1.5);
      const Point<double, 3> p = center + radius * (std::cos(angle) * u + std::sin(angle) * v);
      ring.push_back(p.cast<S>());
    }
    return ring;
  });
}
/// 18-DOPs around a dozen points each.
template <class S>
auto kdop_pairs() {
  const auto normals = directions<S, 3>(18);
  const auto draw = [&](Random& random) -> Kdop<S, 3> {
    const Point<double, 3> center = random.in_box<3>(1);
    std::vector<Point<S, 3>> points;
    for (int i = 0; i < 12; ++i) points.push_back((center + random.in_box<3>(0.8)).template cast<S>());
    return fit_kdop(points, normals);
  };
  return pairs<Kdop<S, 3>, Kdop<S, 3>>("kdop-kdop", draw, draw);
}
template <class S>
auto ray_plane_pairs() {
  return pairs<Ray<S, 3>, Plane<S, 3>>("ray-plane", ordinary_ray<S>, [](Random& random) -> Plane<S, 3> {
    const Vector<S, 3> normal = random.heading<3>().template cast<S>();
    return {normal, static_cast<S>(random.uniform(-4, 4))};
  });
}

inline std::vector<Triple> point_triples() {
  Random random(stream(1, "orient2d"));
  std::vector<Triple> all;
  for (int i = 0; i < case_count; ++i) {
    const Point<double, 2> a = random.in_box<2>(1), b = random.in_box<2>(1);
    all.push_back({a, b, random.in_box<2>(1)});
  }
  return all;
}

/// A simple polygon of n vertices around the origin, its radius wandering between 0.4 and 1.
inline Ring<double, 2> star(std::size_t n) {
  Random random(stream(1, "star"));
  Ring<double, 2> ring;
  double radius = 0.7;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    radius = std::clamp(radius + random.uniform(-1, 1) * 3 / std::sqrt(static_cast<double>(n)), 0.4, 1.0);
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return ring;
}
/// A regular polygon of radius 1, its vertices rounded.
inline Ring<double, 2> regular(std::size_t n) {
  Ring<double, 2> ring;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    ring.push_back({std::cos(angle), std::sin(angle)});
  }
  return ring;
}
/// In a square of that half side.
inline Ring<double, 2> query_points(int count, double half) {
  Random random(stream(1, "query points"));
  Ring<double, 2> points;
  for (int i = 0; i < count; ++i) points.push_back(random.in_box<2>(half));
  return points;
}

}  // namespace isect::bench
