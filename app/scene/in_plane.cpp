#include "app/scene/in_plane.h"

#include <algorithm>
#include <limits>

#include <isect/segment_polygon.h>

namespace isect::program::scene {

Projection projection(const Ring<double, 3>& outline) {
  const int axis = segment_polygon::detail::steepest(outline);
  const auto along = [&]<class W>() -> W {
    return segment_polygon::detail::normal<W>(outline)[static_cast<std::size_t>(axis)];
  };
  return {(axis + 1) % 3, (axis + 2) % 3, sign_of(along) < 0};
}

double off_plane(const Ring<double, 3>& outline) {
  const Components<Exact, 3> n = segment_polygon::detail::normal<Exact>(outline);
  const Exact length = sqrt(dot(n, n));
  double farthest = 0;
  for (const Point<double, 3>& v : outline) {
    const Exact height = dot(n, difference<Exact>(v, outline[0]));
    if (height.sign() == 0) continue;
    farthest = std::max({farthest, near_quotient(abs(height), length), std::numeric_limits<double>::denorm_min()});
  }
  return farthest;
}

}  // namespace isect::program::scene
