#pragma once
// Points that are computed without rounding, and what lengths and angles between them are exactly.

#include <array>
#include <optional>
#include <string>

#include <isect/numbers/exact.h>

#include "viz/scene.h"

namespace isect::program::scene {

/// The point x / w, with w > 0.
struct ExactPoint {
  std::array<Exact, 3> x;
  Exact w = Exact(1.0);
};
using ExactVector = std::array<Exact, 3>;

/// `p` must be finite, here and below.
ExactVector exact_vector(const viz::Vec3& p);
ExactPoint exact_point(const viz::Vec3& p);
/// Returns the nearest doubles; they may be infinite.
viz::Vec3 nearest_doubles(const ExactPoint&);
Exact dot(const ExactVector&, const ExactVector&);
/// Returns the vector from `a` to `b`, times the product of their w.
ExactVector from_to(const ExactPoint& a, const ExactPoint& b);

/// Returns the point of the plane n . x + d = 0 on the line from `origin` along `dir`; none if they are parallel.
std::optional<ExactPoint> meeting(const ExactVector& origin, const ExactVector& dir, const ExactVector& n,
                                  const Exact& d);
/// Returns the point of that plane that is nearest to `p`; n is not 0.
ExactPoint foot_on_plane(const ExactPoint& p, const ExactVector& n, const Exact& d);
/// Returns the point origin + t dir that is nearest to `p`, with t between the ends that there are; dir is not 0.
ExactPoint foot_on_line(const ExactPoint& p, const ExactVector& origin, const ExactVector& dir,
                        const std::optional<double>& least, const std::optional<double>& most);

/// Returns the distance as text: "5", "0.75" or "5/3" if it is exactly that, else "≈ 3.6056".
std::string length_text(const ExactPoint& a, const ExactPoint& b);
/// Whether the vectors are at a right angle; neither is 0.
bool is_right(const ExactVector& u, const ExactVector& v);
/// Returns the angle as text: "45°" if it is exactly that, else "≈ 53.13°". Neither is 0.
std::string angle_text(const ExactVector& u, const ExactVector& v);

}  // namespace isect::program::scene
