#pragma once
// Ray against oriented box by projection onto its axes, as it is taught: for comparison. `intersect` in isect/ray_obb.h
// is right for all input. Source: Akenine-Moller, Haines, Real-Time Rendering, 2nd ed. (2002), ch. 13.6.1.

#include <algorithm>
#include <optional>
#include <variant>

#include <isect/ray_obb.h>

namespace isect::ray_obb {

// clang-format off
template <class S> struct Projected { int axis; S center, rate; };        ///< u_i.(c - o) and u_i.d
template <class S> struct Beside { int axis; bool outside; };             ///< u_i.d = 0
template <class S> struct Crossing { int axis; S entry, exit; };          ///< t at the two faces, sorted
template <class S> struct Remains { S in, out; bool holds; };             ///< in <= out
// clang-format on
template <class S>
using ProjectionsEvent = std::variant<Projected<S>, Beside<S>, Crossing<S>, Remains<S>>;

/// The part of the range in a box with orthonormal axes, by projection onto them. Naive: rounding may decide, and
/// axes that are not quite orthonormal mean another box.
template <class S, int N, class Trace = NoTrace>
std::optional<Interval<S>> projections(const Ray<S, N>& ray, const Obb<S, N>& box, Trace&& trace = {}) {
  const Vector<S, N> to_center = box.center - ray.origin;
  S in = ray.range.lo, out = ray.range.hi;
  for (int i = 0; i < N; ++i) {
    const Vector<S, N> u = box.axes.col(i);
    const S center = u.dot(to_center), rate = u.dot(ray.direction), half = box.half[i];
    trace(Projected<S>{i, center, rate});
    if (rate == S(0)) {
      const bool outside = center > half || -center > half;
      trace(Beside<S>{i, outside});
      if (outside) return {};
      continue;
    }

    const S t1 = (center - half) / rate, t2 = (center + half) / rate;
    const S entry = std::min(t1, t2), exit = std::max(t1, t2);
    trace(Crossing<S>{i, entry, exit});

    in = std::max(in, entry), out = std::min(out, exit);
    const bool holds = in <= out;
    trace(Remains<S>{in, out, holds});
    if (!holds) return {};
  }
  if (!(in <= out)) return {};
  return Interval<S>{in, out};
}

}  // namespace isect::ray_obb
