#pragma once
// Two triangles in space, what is true of them by the core's exact tests, and how they are drawn.

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <isect/methods/triangle_triangle.h>
#include "viz/lesson.h"

namespace isect::lessons::triangle_triangle_lesson {

/// How they lie; the order is that of the branches of the map.
enum class Lie { beside, apart, touching, overlapping, contained };

using Three = Triangle<double, 3>;

struct Setup {
  std::string method;              ///< "intervals" or "signs"
  std::array<Three, 2> triangles;  ///< a and b
  std::array<triangle_triangle::Signs, 2>
      of;  ///< exactly, on which side of the other's plane the corners of a, of b lie
  std::array<bool, 2> area = {};
  Relation truth = Relation::disjoint;

  const Three& a() const { return triangles[0]; }
  const Three& b() const { return triangles[1]; }
  const viz::Vec3& corner(int which, int i) const {
    return triangles[static_cast<std::size_t>(which)].vertices[static_cast<std::size_t>(i)];
  }
  bool meet() const { return truth != Relation::disjoint; }
  bool both_have_area() const { return area[0] && area[1]; }
  /// Whether both have an area and lie in one plane; exact.
  bool one_plane() const { return both_have_area() && of[0] == triangle_triangle::Signs{0, 0, 0}; }
  Lie lie() const;
  /// How many corners they share.
  int shared_corners() const;
  /// Whether they have more in common than corners and edges of both; exact. Both have an area.
  bool clash() const;
  /// The ends of the part of the line of both planes that lies in one of them, rounded: for pictures. Nothing if it
  /// does not reach the other's plane, or if there is no such line.
  std::optional<std::pair<viz::Vec3, viz::Vec3>> part(int which) const;
};
Setup setup(const viz::Parameters&);

/// An edge of a triangle, from a corner to another.
struct Edge {
  int of, from, to;
};

/// What a step shows.
struct Known {
  int plane = -1;                 ///< of b (1) or of a (0): its outline and its normal; -1: none
  bool heights = false;           ///< of the other's corners above that plane
  bool line = false;              ///< of both planes
  std::array<bool, 2> part = {};  ///< of that line in a, in b
  std::vector<Edge> lit = {};     ///< what the step is about
  bool settled = false;
};
viz::Scene picture(const Setup&, const Known&);
/// From where the lesson is seen at first.
viz::Camera camera();

/// Where b lies, moved along two axes. (cases.cpp)
const viz::CaseMap& cases();
/// What each method says: whether they meet. (cases.cpp)
std::vector<viz::Opinion> opinions(const viz::Parameters&);
/// The text before the first step, and the card after the last one. (closing.cpp)
const std::string& opening();
const viz::Closing& closing();
/// The exercise with a program that errs. (wrong_line.cpp)
viz::Exercise wrong_line();

}  // namespace isect::lessons::triangle_triangle_lesson
