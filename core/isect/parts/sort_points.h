#pragma once
// Points of the plane from left to right.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <isect/shapes.h>

namespace isect {

/// Whether a stands before b: further left, or below at the same x. Along any line that is the order of its points.
template <class S>
bool before(const Point<S, 2>& a, const Point<S, 2>& b) {
  return a[0] < b[0] || (a[0] == b[0] && a[1] < b[1]);
}

/// Sorts by x, then y; finite points. Many are first dealt into columns of equal width, which takes O(n) where they are
/// spread evenly, and never more than O(n log n): rounding may choose another column, but not a later one for a smaller
/// x.
template <class S>
void sort_points(Ring<S, 2>& points) {
  constexpr std::size_t many = 4096, in_column = 8;
  const auto inlined = [](const Point<S, 2>& a, const Point<S, 2>& b) { return before<S>(a, b); };
  const auto sort_part = [&](auto first, auto last) { std::sort(first, last, inlined); };
  if (points.size() < many) return sort_part(points.begin(), points.end());
  const auto [least, most] =
      std::minmax_element(points.begin(), points.end(), [](const auto& a, const auto& b) { return a[0] < b[0]; });
  const std::size_t count = points.size() / in_column;
  const S left = (*least)[0], extent = (*most)[0] - left, per_unit = static_cast<S>(count) / extent;
  if (!std::isfinite(extent) || !std::isfinite(per_unit)) return sort_part(points.begin(), points.end());

  const auto column = [&](const Point<S, 2>& p) {
    return std::min(count - 1, static_cast<std::size_t>((p[0] - left) * per_unit));
  };
  std::vector<std::size_t> ends(count);  // of each column; its beginning, once it is filled
  for (const Point<S, 2>& p : points) ++ends[column(p)];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  Ring<S, 2> dealt(points.size());
  for (const Point<S, 2>& p : points) dealt[--ends[column(p)]] = p;
  ends.push_back(dealt.size());
  const auto at = [&](std::size_t i) { return dealt.begin() + static_cast<std::ptrdiff_t>(ends[i]); };
  for (std::size_t i = 0; i < count; ++i) sort_part(at(i), at(i + 1));
  points.swap(dealt);
}

}  // namespace isect
