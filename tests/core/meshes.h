#pragma once
// Meshes and rays for tests.

#include <cmath>
#include <numbers>

#include <isect/triangle_mesh.h>
#include "bench/brute_force.h"
#include "bench/random_rays.h"

namespace isect::tests {

/// A closed ball of triangles: rows of quadrilaterals, each cut in two, and fans at the poles.
template <class S>
TriangleMesh<S> ball(int rows, int columns, const Vector<double, 3>& center, double radius) {
  TriangleMesh<S> mesh;
  const auto add = [&](double u, double v) {
    const Vector<double, 3> p(std::sin(u) * std::cos(v), std::cos(u), std::sin(u) * std::sin(v));
    mesh.vertices.push_back((center + radius * p).cast<S>());
  };
  add(0, 0), add(std::numbers::pi, 0);
  for (int i = 1; i < rows; ++i)
    for (int j = 0; j < columns; ++j) add(std::numbers::pi * i / rows, 2 * std::numbers::pi * j / columns);
  const auto at = [&](int i, int j) { return i == 0 ? 0 : i == rows ? 1 : 2 + (i - 1) * columns + j % columns; };
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      if (i < rows - 1) mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
      if (i > 0) mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
    }
  return mesh;
}

/// Triangles between any vertices of a family of numbers; few vertices, so that many are shared.
template <class S>
TriangleMesh<S> soup(bench::Random& random, bench::Numbers numbers) {
  TriangleMesh<S> mesh;
  const int vertices = random.integer(3, 20), triangles = random.integer(1, 40);
  for (int i = 0; i < vertices; ++i) mesh.vertices.push_back(bench::vector<S, 3>(random, numbers));
  for (int i = 0; i < triangles; ++i)
    mesh.triangles.push_back({random.below(vertices), random.below(vertices), random.below(vertices)});
  return mesh;
}

/// A ray from anywhere, or aimed at a vertex, or at the middle of an edge or a triangle.
template <class S>
Ray<S, 3> aimed(bench::Random& random, const TriangleMesh<S>& mesh, bench::Numbers numbers) {
  Ray<S, 3> ray = bench::ray<S, 3>(random, numbers);
  if (random.one_in(4)) return ray;
  const auto [a, b, c] = triangle(mesh, random.below(static_cast<int>(mesh.triangles.size()))).vertices;
  const Point<S, 3> middle = a / 2 + b / 2, center = a / 3 + b / 3 + c / 3;
  const Point<S, 3> target = random.one_in(3) ? a : random.one_in(2) ? middle : center;
  const Vector<S, 3> d = target - ray.origin;
  if (finite(d)) ray.direction = d;
  if (random.one_in(4)) ray.range = {ray.range.lo, std::max(ray.range.lo, S(1))};
  return ray;
}

using bench::brute_force;

}  // namespace isect::tests
