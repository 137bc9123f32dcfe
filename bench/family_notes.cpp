// What the hard families are made of, in one line each.

#include <map>

#include "bench/report_text.h"

namespace isect::bench {

std::string family_note(const std::string& test, const std::string& family) {
  static const std::map<std::pair<std::string, std::string>, std::string> own = {
      {{"ray-sphere", "far-small"},
       "a small ball far away, where the squares of the distance swallow its radius."},
      {{"ray-sphere", "planet"},
       "an eye a little above a ball as large as a planet: the nearer root is a difference of large "
       "numbers."},
      {{"ray-sphere", "near-tangent"}, "rays that pass the surface within a few ulp, on either side."},
      {{"ray-sphere", "exact-tangent"}, "rays that touch the ball in exactly one point."},
      {{"ray-sphere", "on-surface"}, "rays that start on the surface, so that t = 0 is a hit."},
      {{"ray-sphere", "direction-length"},
       "directions from 1e-300 to 1e300 long: their squares overflow or vanish."},
      {{"ray-sphere", "zero-radius"}, "balls that are points."},
      {{"sphere-sphere", "near-touch"}, "balls that touch from outside but for a few ulp."},
      {{"sphere-sphere", "inner-touch"}, "the same from inside."},
      {{"sphere-sphere", "exact-touch"},
       "integers whose distance is whole, so that the balls have one point in common."},
      {{"sphere-sphere", "decimal"},
       "radii of .1 and .2 at a distance of .3, as users type them: rounding decides what is true."},
      {{"sphere-sphere", "concentric"}, "nearly the same centre and radius."},
      {{"sphere-sphere", "scale"}, "sizes at which squares overflow or vanish."},
      {{"sphere-sphere", "invalid"}, "a NaN, an infinity or a negative radius in one ball."},
      {{"orient2d", "Kettner a"}, "neighbours of (0.5, 0.5) beside the line through (12, 12) and (24, 24)."},
      {{"orient2d", "Kettner b"}, "neighbours of a point beside a line whose slope is not quite 1."},
      {{"orient2d", "Kettner c"},
       "neighbours of (0.5, 0.5) beside the line through (8.8, 8.8) and (12.1, 12.1)."},
      {{"orient2d", "near-collinear"}, "three points on a line but for an ulp or two."},
      {{"orient2d", "small beside large"},
       "a small point within 2 ulp of the line through two opposite large ones: more digits than long double "
       "has."},
      {{"orient2d", "decimal"}, "decimal fractions on one line, which rounding has moved off it."},
      {{"orient2d", "range"}, "coordinates so large or so small that their products overflow or vanish."},
      {{"point-polygon", "near-edge"}, "points on an edge but for rounding, and up to 2 ulp beside that."},
      {{"point-polygon", "on-vertex"}, "the vertices themselves: a closed polygon has them."},
      {{"point-polygon", "horizontal"},
       "staircases of decimal fractions, and points at the height of their steps."},
      {{"point-polygon", "degenerate"},
       "repeated vertices, vertices within edges, spikes, polygons without area; points near edges."},
      {{"point-polygon", "bow-tie"}, "polygons that cross themselves all over; points near edges."},
      {{"point-polygon", "far 1e5"}, "points near edges of a polygon of size 1 at 100,000."},
      {{"point-polygon", "far 1e8"}, "the same at 100,000,000."},
      {{"convex-polygon", "near-edge"}, "points on an edge but for rounding, and up to 2 ulp beside that."},
      {{"convex-polygon", "closing edge"},
       "the same of the long edge at which the fan of wedges begins and ends."},
      {{"convex-polygon", "flat"}, "the same of an ellipse as flat as the scalar allows."},
      {{"convex-polygon", "sliver triangles"},
       "triangles a few ulp high, whose centroid may lie outside when rounded."},
      {{"point-location", "near-edge"}, "points on an edge but for rounding, and up to 2 ulp beside that."},
      {{"point-location", "on-vertex"}, "the vertices themselves: a closed polygon has them."},
      {{"point-location", "near-horizontal"},
       "a comb of long edges nearly along the slabs; points near edges."},
      {{"point-location", "near-vertical"}, "the same comb upright, nearly along the trapezoids' walls."},
      {{"point-location", "coincident"}, "two chains of edges an ulp or two apart; points near edges."},
  };
  const auto found = own.find({test, family});
  return found == own.end() ? "" : found->second;
}

}  // namespace isect::bench
