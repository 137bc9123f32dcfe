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
       "two points near each other and one far away, or coordinates of different size."},
      {{"orient2d", "decimal"}, "decimal fractions on one line, which rounding has moved off it."},
      {{"orient2d", "range"}, "coordinates so large or so small that their products overflow or vanish."},
  };
  const auto found = own.find({test, family});
  return found == own.end() ? "" : found->second;
}

}  // namespace isect::bench
