#pragma once
// The scalars, and intervals of them: without Eigen, so that a file which needs no more of the core compiles at once.

#include <limits>
#include <type_traits>

#include <isect/conventions.h>

namespace isect {

/// The scalars for which error bounds are proved; isect/counted.h adds those that count their operations.
template <class S>
inline constexpr bool has_bounds = std::is_same_v<S, float> || std::is_same_v<S, double>;

/// Fails to compile for a scalar S that is neither float nor double.
template <class S>
constexpr bool is_scalar() {
  static_assert(has_bounds<S>, "isect: a scalar is float or double; no error bound is proved for any other");
  return true;
}

/// The closed interval [lo, hi]; empty when lo > hi.
template <class S>
struct Interval {
  static_assert(is_scalar<S>());
  S lo, hi;

  bool contains(const S& x) const { return lo <= x && x <= hi; }
  friend bool operator==(const Interval&, const Interval&) = default;
};

/// All t >= 0.
template <class S>
inline constexpr Interval<S> semi_infinite = {S(0), std::numeric_limits<S>::infinity()};
/// Every t.
template <class S>
inline constexpr Interval<S> infinite = {-std::numeric_limits<S>::infinity(), std::numeric_limits<S>::infinity()};

}  // namespace isect
