// Filled polygons, in the plane and in space.

#include "viz/compose/canvas.h"

#include <algorithm>
#include <iterator>

namespace isect::viz {

void draw(Canvas& c, const Region& it) {
  std::vector<Path> outlines;
  for (const std::vector<Vec3>& ring : it.rings)
    if (ring.size() >= 2) outlines.push_back(polyline(c.projected(ring), true));
  if (outlines.empty()) return;
  Fill fill = area(c, outlines.front(), it.role);
  fill.more.assign(outlines.begin() + 1, outlines.end());
  const bool behind = it.hides && lies_behind({{it.rings}}, c.view, c.occluders);
  (behind ? c.ground : c.contents).emplace_back(fill);
  const auto drawn = static_cast<std::ptrdiff_t>(c.lines.size());

  for (const std::vector<Vec3>& ring : it.rings) {
    if (it.outlined) draw(c, Chain{ring, true, it.role, it.pen});
    if (!it.corners) continue;
    for (const Vec3& corner : ring)  // under the other markers, without a halo
      c.lines.emplace_back(Fill{circle(c.at(corner), 0.75 * c.sizes().disc), c.theme.ink(it.role), 0, 0, {}});
  }
  if (!behind) return;  // if behind, its outline ends at theirs and would cut into them
  std::move(c.lines.begin() + drawn, c.lines.end(), std::back_inserter(c.ground));
  c.lines.erase(c.lines.begin() + drawn, c.lines.end());
}

}  // namespace isect::viz
