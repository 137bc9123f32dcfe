#pragma once
// Where a ray meets a box, in rationals.

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "bench/rational.h"

namespace isect::oracle {

/// The ends of the part of the range in the box: the least and the largest feasible t of all candidates, tried one by
/// one. NaN or an infinite coordinate: nothing.
template <class S, int N>
std::optional<std::pair<Rational, Rational>> ray_aabb(const Ray<S, N>& ray, const Aabb<S, N>& box) {
  if (!finite(ray) || !finite(box)) return {};
  const auto o = rational<S, N>(ray.origin), d = rational<S, N>(ray.direction), lo = rational<S, N>(box.lo),
             hi = rational<S, N>(box.hi);
  std::vector<Rational> candidates;
  for (int i = 0; i < N; ++i)
    if (d[i] != 0)
      for (const Rational& plane : {lo[i], hi[i]}) candidates.push_back((plane - o[i]) / d[i]);
  if (candidates.empty()) candidates.push_back(std::isinf(ray.range.lo) ? Rational(0) : Rational(ray.range.lo));
  for (const S end : {ray.range.lo, ray.range.hi})
    if (!std::isinf(end)) candidates.push_back(Rational(end));

  std::optional<std::pair<Rational, Rational>> result;
  for (const Rational& t : candidates) {
    bool inside = holds(ray.range, t) || ray.direction == Vector<S, N>::Zero();
    for (int i = 0; inside && i < N; ++i) {
      const Rational x = o[i] + t * d[i];
      inside = lo[i] <= x && x <= hi[i];
    }
    if (!inside) continue;
    if (!result) result = {t, t};
    result = {std::min(result->first, t), std::max(result->second, t)};
  }
  return result;
}

}  // namespace isect::oracle
