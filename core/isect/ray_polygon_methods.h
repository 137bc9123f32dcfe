#pragma once
// Ray against polygon in space by a fan of triangles, beside the note's `projected` in isect/ray_polygon.h: for
// lessons and comparison. `intersect` there is right for all input.

#include <optional>
#include <variant>

#include <isect/ray_polygon.h>
#include <isect/ray_triangle.h>

namespace isect::ray_polygon {

/// One triangle of the fan: vertices 0, second, second + 1.
template <class S>
struct FanTriangle {
  int second;
  bool hit;
};
template <class S>
using FanEvent = std::variant<FanTriangle<S>>;

/// t in the last triangle that the ray meets, if it meets an odd number of those that vertex 0 makes with the edges:
/// so concave outlines are right by even-odd, too. Naive: Moller and Trumbore's rounding may decide, and a ray
/// through a diagonal may meet both triangles beside it or none. Source: parity as in the note, N22;
/// isect/ray_triangle.h.
template <class S, class Trace = NoTrace>
std::optional<S> fan(const Ray<S, 3>& ray, const Ring<S, 3>& ring, Trace&& trace = {}) {
  bool inside = false;
  S t = S(0);
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const auto hit = ray_triangle::moller_trumbore<S>(ray, {{ring[0], ring[i], ring[i + 1]}});
    trace(FanTriangle<S>{static_cast<int>(i), hit.has_value()});
    if (hit) inside = !inside, t = hit->t;
  }
  if (!inside) return {};
  return t;
}

}  // namespace isect::ray_polygon
