#pragma once
// Shapes of any number of parts, for time against size.

#include <cmath>
#include <numbers>
#include <vector>

#include <isect/shapes.h>
#include <isect/triangle_mesh.h>
#include "bench/random.h"

namespace isect::bench {

enum class Outline { convex, smooth, spiky };

/// A polygon around the origin; a smooth one has five waves, a spiky one a random radius at each vertex.
inline Ring<double, 2> outline_of(Outline kind, int n) {
  Random random(stream(1, "outline"));
  Ring<double, 2> ring;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    double radius = 1;
    if (kind == Outline::smooth) radius = 0.7 + 0.3 * std::sin(5 * angle);
    if (kind == Outline::spiky) radius = random.uniform(0.1, 1);
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return ring;
}

/// Random points in the square from -1 to 1.
inline Ring<double, 2> points_in_square(int count) {
  Random random(stream(1, "anywhere"));
  Ring<double, 2> points;
  for (int i = 0; i < count; ++i) points.push_back(random.in_box<2>(1));
  return points;
}

/// Boxes of sides 0.8 to 1.2, three neighbours each on average if all were alike; heavy-tailed: one in a hundred is 20
/// times larger.
template <class S>
std::vector<Aabb<S, 3>> scattered_boxes(int n, bool heavy) {
  Random random(1);
  const double side = std::cbrt(n * 8.0 / 3);
  std::vector<Aabb<S, 3>> boxes;
  boxes.reserve(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    const Point<double, 3> center = random.in_box<3>(side / 2);
    const double scale = heavy && i % 100 == 0 ? 20 : 1;
    Vector<double, 3> half;
    for (int k = 0; k < 3; ++k) half[k] = scale * random.uniform(0.4, 0.6);
    boxes.push_back({(center - half).cast<S>(), (center + half).cast<S>()});
  }
  return boxes;
}

/// A sphere with bumps: 4 side^2 triangles of about equal size.
template <class S>
TriangleMesh<S> bumpy_sphere(int side) {
  TriangleMesh<S> mesh;
  const int rows = side, columns = 2 * side;
  for (int i = 0; i <= rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const double u = std::numbers::pi * i / rows, v = 2 * std::numbers::pi * j / columns;
      const double r = 1 + 0.1 * std::sin(7 * u) * std::sin(9 * v) + 0.02 * std::sin(41 * u) * std::cos(37 * v);
      const Point<double, 3> p(r * std::sin(u) * std::cos(v), r * std::cos(u), r * std::sin(u) * std::sin(v));
      mesh.vertices.push_back(p.cast<S>());
    }
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const int a = i * columns + j, b = i * columns + (j + 1) % columns;
      mesh.triangles.push_back({a, b, a + columns});
      mesh.triangles.push_back({b, b + columns, a + columns});
    }
  return mesh;
}
/// Distinct rays in random order from a sphere around that mesh, about three of four aimed at it.
template <class S>
std::vector<Ray<S, 3>> rays_inwards(int count) {
  Random random(1);
  std::vector<Ray<S, 3>> all;
  for (int i = 0; i < count; ++i) {
    const Point<double, 3> from = 3 * random.heading<3>();
    const Point<double, 3> to = random.in_box<3>(1);
    all.push_back({from.cast<S>(), (to - from).cast<S>()});
  }
  return all;
}

/// Random points in a ball, or on a sphere up to rounding.
inline std::vector<Point<double, 3>> cloud(int n, bool ball) {
  Random random(1);
  std::vector<Point<double, 3>> points;
  for (int i = 0; i < n; ++i) {
    const Point<double, 3> p = random.heading<3>();
    points.push_back(ball ? Point<double, 3>(p * std::cbrt(random.unit())) : p);
  }
  return points;
}
/// Random points in a disc, or on a circle up to rounding.
inline Ring<double, 2> disc(int n, bool circle) {
  Random random(stream(1, "scattered"));
  Ring<double, 2> points;
  for (int i = 0; i < n; ++i) {
    const double angle = random.uniform(0, 2 * std::numbers::pi), radius = circle ? 1 : std::sqrt(random.unit());
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return points;
}

}  // namespace isect::bench
