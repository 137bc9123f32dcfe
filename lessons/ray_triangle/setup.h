#pragma once
// A ray and a triangle, at a seam two triangles, and what is true of them: the core decides.

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <isect/ray_triangle.h>
#include "viz/lesson.h"

namespace isect::lessons::ray_triangle_lesson {

using Ray3 = Ray<double, 3>;
using Triangle3 = Triangle<double, 3>;

/// Where the line crosses the triangle's plane, by the signs of the three weights there.
enum class Place { inside, beyond_bc, beyond_ca, beyond_ab, beyond_a, beyond_b, beyond_c, edge, vertex, none };

struct Setup {
  std::string method;
  Ray3 ray;
  Triangle3 triangle;                ///< abc
  Triangle3 neighbour;               ///< cbq, at a seam
  viz::Vec3 given;                   ///< the direction as given; at a seam the ray has a neighbour of it
  std::array<int, 2> selected = {};  ///< which one, in steps to the right and up

  RayTriangle<double> truth;
  std::array<int, 3> side = {};  ///< the signs of w_a, w_b, w_c
  int heading = 0;               ///< the sign of n . d; 0 also where there is no plane
  bool flat = false;             ///< the triangle has no area
  std::optional<double> line;    ///< t in the plane, on the whole line

  bool segment() const { return std::isfinite(ray.range.hi); }
  bool seam() const { return method == "seam"; }
  /// "ray", or "segment"
  std::string what() const { return segment() ? "segment" : "ray"; }
  const viz::Vec3& vertex(int i) const { return triangle.vertices[i]; }
  /// The sign of the weight of vertex i where the line crosses the plane.
  int weight(int i) const { return side[i] * heading; }
  Place place() const;
};

Setup setup(const viz::Parameters&);

inline constexpr const char* vertex_names[] = {"**a**", "**b**", "**c**"};
inline constexpr const char* edge_names[] = {"bc", "ca", "ab"};  ///< the one opposite each vertex

/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();
/// The exercise with a program that errs. (wrong_line.cpp)
viz::Exercise wrong_line();
/// The map of where the line crosses the plane, and the methods side by side. (cases.cpp)
const viz::CaseMap& cases();
std::vector<viz::Opinion> opinions(const viz::Parameters&);

}  // namespace isect::lessons::ray_triangle_lesson
