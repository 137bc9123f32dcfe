#include "viz/player/side_at.h"

#include <algorithm>

namespace isect::viz {

std::optional<PlaceOnSide> side_at(const std::vector<SceneSide>& sides, const View& view, const Vec2& pixel,
                                   double reach) {
  std::optional<PlaceOnSide> nearest;
  double least = reach;
  for (const SceneSide& side : sides) {
    const Projected from = view.project(side.from), to = view.project(side.to);
    if (!(from.depth > 0) || !(to.depth > 0)) continue;
    const Vec2 way = to.at - from.at;
    const double length2 = way.squaredNorm();
    const double seen = length2 > 0 ? std::clamp((pixel - from.at).dot(way) / length2, 0.0, 1.0) : 0;
    const double distance = (from.at + seen * way - pixel).norm();
    if (!(distance <= least)) continue;
    // In perspective the nearer half of a side takes more of its image.
    const double near = seen * from.depth, far = (1 - seen) * to.depth;
    const double share = view.camera().perspective ? near / (near + far) : seen;
    least = distance;
    nearest = {side, side.from + share * (side.to - side.from)};
  }
  return nearest;
}

}  // namespace isect::viz
