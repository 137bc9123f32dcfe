#pragma once
// Where a line first meets a polygon in the plane, in rationals: the least of all candidate t whose point is not
// outside. Each candidate is tried.

#include <optional>
#include <vector>

#include "bench/ray_polygon/oracle.h"

namespace isect::oracle {

template <class S>
std::vector<std::vector<P2>> rational(const Polygon<S, 2>& polygon) {
  std::vector<std::vector<P2>> rings;
  for (const Ring<S, 2>& ring : polygon.rings) {
    rings.emplace_back();
    for (const Point<S, 2>& v : ring) rings.back().push_back(rational<S, 2>(v));
  }
  return rings;
}

/// Decides by the even-odd rule; the line must have a direction. The candidates: the start of the range, where each
/// edge's line is crossed, and where each corner is nearest.
inline std::optional<Rational> first_hit(const P2& o, const P2& d, const Interval<double>& range,
                                         const std::vector<std::vector<P2>>& rings) {
  std::vector<Rational> candidates;
  if (std::isfinite(range.lo)) candidates.push_back(Rational(range.lo));
  for (const std::vector<P2>& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const P2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      candidates.push_back(dot(a - o, d) / dot(d, d));
      const P2 normal = {b[1] - a[1], a[0] - b[0]};
      const Rational rate = dot(normal, d);
      if (rate != 0) candidates.push_back(dot(normal, a - o) / rate);
    }
  std::optional<Rational> first;
  for (const Rational& t : candidates)
    if (holds(range, t) && (!first || t < *first) && locate(P2(o + t * d), rings) != Location::out) first = t;
  return first;
}

}  // namespace isect::oracle
