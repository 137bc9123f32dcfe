#pragma once
// The pictures of a ray and a triangle in space, of the triangle after the shear, and of a seam's cells.

#include <array>
#include <string>
#include <vector>

#include "lessons/ray_triangle/setup.h"

namespace isect::lessons::ray_triangle_lesson {

/// A line of points of one weight is drawn if the weight is smaller in size.
inline constexpr double largest_weight = 3;

/// What a step shows.
struct Known {
  bool edges = false;                    ///< from a to b and to c
  std::optional<double> u = {}, v = {};  ///< the lines of points that have this weight of b, of c
  int edge = -1;                         ///< the plane through the origin and the edge opposite this vertex
  bool neighbour = false;                ///< the triangle c, b, q
  bool crossing = false;                 ///< where the line meets the plane
  bool settled = false;                  ///< whether that counts
};
viz::Scene picture(const Setup&, const Known&);

/// The triangle's corners as the ray sees them, the ray at (0, 0); `filled`: with its edges.
viz::Scene sheared(const Setup&, const std::array<viz::Vec2, 3>& corners, bool filled);

/// The cells of a microscope, turned towards the camera.
viz::Scene cells(const Setup&, std::vector<viz::Cell>, const std::vector<std::pair<viz::Role, std::string>>& keys);

}  // namespace isect::lessons::ray_triangle_lesson
