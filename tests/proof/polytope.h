#pragma once
// Convex polytopes in rationals, by their corners and by their half-spaces: how far two are apart, and whether their
// interiors meet. Nothing here is shared with the core: no filter, no determinant of half-spaces, no duality.
//
// A shape of the plane lies in z = 0.

#include <gmpxx.h>

#include <array>
#include <vector>

namespace isect::proof {

using Rational = mpq_class;
using Vec = std::array<Rational, 3>;
using Points = std::vector<Vec>;

Vec operator+(const Vec&, const Vec&);
Vec operator-(const Vec&, const Vec&);
Vec operator*(const Rational&, const Vec&);
Rational dot(const Vec&, const Vec&);
Vec cross(const Vec&, const Vec&);
bool is_zero(const Vec&);

/// normal . x <= offset; an equation where the polytope lies in that plane.
struct Face {
  Vec normal;
  Rational offset;
  bool equation = false;

  /// How far a point lies beyond the plane, in units of the normal.
  Rational beyond(const Vec& x) const { return dot(normal, x) - offset; }
  bool holds(const Vec& x) const;
};
using Faces = std::vector<Face>;

bool holds(const Faces&, const Vec&);

/// The index of the farthest point along a vector, the first one of several.
std::size_t farthest(const Points&, const Vec& along);

struct Nearest {
  Rational distance2;
  Vec point;  ///< of both, where the distance is 0
};
/// The nearest points of the hulls of two lists of points. Source: Wolfe, Finding the nearest point in a polytope,
/// Mathematical Programming 11 (1976).
Nearest nearest(const Points& a, const Points& b);

/// Whether the two have a common point that lies on no proper face of either: one interior to both, each within the
/// line, plane or space that it spans. `common`: any common point.
bool interiors_meet(const Faces& a, const Faces& b, const Vec& common);

/// The faces of the hull of points, of any dimension; in the plane its normals have no z.
Faces faces_of(const Points&, bool flat);
/// The corners of what half-spaces have in common, which is bounded.
Points corners_of(const Faces&, bool flat);

}  // namespace isect::proof
