#pragma once
// Ray against axis-aligned box by slabs with divisions, and by reciprocals of the direction as it is written in
// practice: for lessons and comparison. `intersect` and `may_intersect` in isect/ray_aabb.h are right for all input.
//
// A component of 0 has an infinite reciprocal, of its sign, so that a slab beside the ray is entered at -inf and left
// at +inf, or never. But an origin on a plane of that slab makes 0 inf = NaN, and each form treats that in its own
// way: all lose rays that run along a face. Rounding decides at edges and corners: there all lose hits.

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include <isect/ray_aabb.h>

namespace isect::ray_aabb {

// clang-format off
template <class S> struct Beside { int axis; S origin; bool outside; };   ///< d_i = 0
template <class S> struct Crossing { int axis; S entry, exit; };          ///< t at the two planes, sorted
template <class S> struct Remains { S in, out; bool holds; };             ///< in <= out
// clang-format on
template <class S>
using SlabsEvent = std::variant<Beside<S>, Crossing<S>, Remains<S>>;

/// The part of the range in the box, slab by slab with divisions. Naive: rounding may decide, at edges and corners it
/// loses 1.6 % of the hits. Source: Kay, Kajiya (1986); the note's box (N06) and ray (N16).
template <class S, int N, class Trace = NoTrace>
std::optional<Interval<S>> slabs_naive(const Ray<S, N>& ray, const Aabb<S, N>& box, Trace&& trace = {}) {
  S in = ray.range.lo, out = ray.range.hi;
  for (int i = 0; i < N; ++i) {
    const S o = ray.origin[i], d = ray.direction[i];
    if (d == S(0)) {
      const bool outside = o < box.lo[i] || box.hi[i] < o;
      trace(Beside<S>{i, o, outside});
      if (outside) return {};
      continue;
    }

    const S t1 = (box.lo[i] - o) / d, t2 = (box.hi[i] - o) / d;
    const S entry = std::min(t1, t2), exit = std::max(t1, t2);
    trace(Crossing<S>{i, entry, exit});

    in = std::max(in, entry), out = std::min(out, exit);
    const bool holds = in <= out;
    if constexpr (heard<Trace>) trace(Remains<S>{in, out, holds});
    if (!holds) return {};
  }
  if (!(in <= out)) return {};
  return Interval<S>{in, out};
}

template <class S>
struct Reciprocal {
  int axis;
  S value;
};
/// t at the two planes of a slab, as computed: at its lower end and at its upper one.
template <class S>
struct Planes {
  int axis;
  S lo, hi;
};
template <class S>
using MethodEvent = std::variant<Reciprocal<S>, Planes<S>, Crossing<S>, Remains<S>>;

namespace detail {

/// The range cut by slab after slab. sort(axis, t at lo, t at hi) -> the two in order; later(in, entry) and
/// earlier(out, exit) choose one.
template <class S, int N, class Sort, class Later, class Earlier, class Trace>
std::optional<Interval<S>> by_slabs(const Ray<S, N>& ray, const Aabb<S, N>& box, const Sort& sort, const Later& later,
                                    const Earlier& earlier, Trace&& trace) {
  S in = ray.range.lo, out = ray.range.hi;
  for (int i = 0; i < N; ++i) {
    const S inverse = S(1) / ray.direction[i];
    trace(Reciprocal<S>{i, inverse});

    const S t1 = (box.lo[i] - ray.origin[i]) * inverse, t2 = (box.hi[i] - ray.origin[i]) * inverse;
    trace(Planes<S>{i, t1, t2});

    const Interval<S> crossing = sort(i, t1, t2);
    trace(Crossing<S>{i, crossing.lo, crossing.hi});

    in = later(in, crossing.lo), out = earlier(out, crossing.hi);
    if constexpr (heard<Trace>) trace(Remains<S>{in, out, in <= out});
  }
  if (!(in <= out)) return {};
  return Interval<S>{in, out};
}

}  // namespace detail

/// Uses std::min and std::max, which keep their first argument when the other is NaN. An inverted box is sorted, so
/// that it counts as the box it might have been.
template <class S, int N, class Trace = NoTrace>
std::optional<Interval<S>> by_min_max(const Ray<S, N>& ray, const Aabb<S, N>& box, Trace&& trace = {}) {
  const auto sort = [](int, S t1, S t2) -> Interval<S> { return {std::min(t1, t2), std::max(t1, t2)}; };
  const auto later = [](S in, S entry) { return std::max(in, entry); };
  const auto earlier = [](S out, S exit) { return std::min(out, exit); };
  return detail::by_slabs(ray, box, sort, later, earlier, trace);
}

/// by_min_max with the arguments of the last two exchanged: what is new comes first, and the range after it. So a NaN
/// at a lower plane becomes the range, where by_min_max passes over the slab. On the last axis the hit is lost; else
/// the next axis replaces the NaN, and what was found before it is forgotten, the ray's own range too.
template <class S, int N, class Trace = NoTrace>
std::optional<Interval<S>> by_min_max_exchanged(const Ray<S, N>& ray, const Aabb<S, N>& box, Trace&& trace = {}) {
  const auto sort = [](int, S t1, S t2) -> Interval<S> { return {std::min(t1, t2), std::max(t1, t2)}; };
  const auto later = [](S in, S entry) { return std::max(entry, in); };
  const auto earlier = [](S out, S exit) { return std::min(exit, out); };
  return detail::by_slabs(ray, box, sort, later, earlier, trace);
}

/// Uses std::fmin and std::fmax, which pass NaN over. Yet of a plane that the ray runs along they keep the other one's
/// infinity at both ends. Several times slower, where they are calls.
template <class S, int N, class Trace = NoTrace>
std::optional<Interval<S>> by_fmin_fmax(const Ray<S, N>& ray, const Aabb<S, N>& box, Trace&& trace = {}) {
  const auto sort = [](int, S t1, S t2) -> Interval<S> { return {std::fmin(t1, t2), std::fmax(t1, t2)}; };
  const auto later = [](S in, S entry) { return std::fmax(in, entry); };
  const auto earlier = [](S out, S exit) { return std::fmin(out, exit); };
  return detail::by_slabs(ray, box, sort, later, earlier, trace);
}

/// Uses the sign of the direction, which says beforehand through which plane the ray enters. A component of -0 counts
/// as 0, but has another reciprocal: such rays miss from inside. Source: Smits, Efficiency issues for ray tracing, J.
/// Graphics Tools 3 (1998); Williams et al., An efficient and robust ray-box intersection algorithm, ibid. 10 (2005),
/// which mends -0.
template <class S, int N, class Trace = NoTrace>
std::optional<Interval<S>> by_sign(const Ray<S, N>& ray, const Aabb<S, N>& box, Trace&& trace = {}) {
  const auto sort = [&ray](int i, S t1, S t2) -> Interval<S> {
    if (ray.direction[i] >= S(0)) return {t1, t2};
    return {t2, t1};
  };
  const auto later = [](S in, S entry) { return entry > in ? entry : in; };
  const auto earlier = [](S out, S exit) { return exit < out ? exit : out; };
  return detail::by_slabs(ray, box, sort, later, earlier, trace);
}

}  // namespace isect::ray_aabb
