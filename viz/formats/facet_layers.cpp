#include "viz/formats/facet_layers.h"

#include <algorithm>
#include <numeric>

namespace isect::viz {
namespace {

/// A facet and the box around it.
struct Placed {
  const Vec2* corners;
  Vec2 lo, hi;
};

/// Whether `other` lies beyond a side of the facet, touching it at most. A facet without area covers nothing.
bool is_beyond_a_side(const Vec2* facet, const Vec2* other) {
  for (int k = 0; k < 3; ++k) {
    const Vec2 &from = facet[k], along = facet[(k + 1) % 3] - from;
    const auto side = [&](const Vec2& p) { return along.x() * (p.y() - from.y()) - along.y() * (p.x() - from.x()); };
    const double inside = side(facet[(k + 2) % 3]);
    if (std::all_of(other, other + 3, [&](const Vec2& p) { return inside * side(p) <= 0; })) return true;
  }
  return false;
}

bool overlap(const Placed& a, const Placed& b) {
  return a.lo.x() < b.hi.x() && b.lo.x() < a.hi.x() && a.lo.y() < b.hi.y() && b.lo.y() < a.hi.y() &&
         !is_beyond_a_side(a.corners, b.corners) && !is_beyond_a_side(b.corners, a.corners);
}

}  // namespace

std::vector<int> layers(const Facets& facets) {
  const std::size_t n = facets.colours.size();
  std::vector<int> layer(n);
  if (n > most_layered) {
    std::iota(layer.begin(), layer.end(), 0);
    return layer;
  }
  std::vector<Placed> placed;
  placed.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2* const p = &facets.corners[3 * i];
    placed.push_back({p, p[0].cwiseMin(p[1]).cwiseMin(p[2]), p[0].cwiseMax(p[1]).cwiseMax(p[2])});
    for (std::size_t below = 0; below < i; ++below)
      if (layer[below] >= layer[i] && overlap(placed[below], placed[i])) layer[i] = layer[below] + 1;
  }
  return layer;
}

}  // namespace isect::viz
