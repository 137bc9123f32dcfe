#pragma once
// Clipping a segment at a box as Liang and Barsky do: for lessons and comparison. `clip` in isect/clip_segment.h is
// right for all input. Source: Liang, Barsky, ACM Trans. Graphics 3 (1984).

#include <algorithm>
#include <optional>
#include <variant>

#include <isect/clip_segment.h>

namespace isect::clip_segment {

/// The outcodes of both ends.
struct Outcodes {
  int p, q;
};
/// One side of the box, which the line enters (heading 1), leaves (-1) or runs along (0), and what is left of the
/// range; `holds`: something is left. t is where the line crosses the side; 0 if the line runs along it.
template <class S>
struct Narrowed {
  int axis;
  bool upper;
  int heading;
  S t;
  Interval<S> range;
  bool holds;
};
template <class S>
using LiangBarskyEvent = std::variant<Outcodes, Narrowed<S>>;

/// The t of [0, 1] in the box, clipped at one side after the other, after the trivial acceptance and rejection by
/// outcodes. Naive: where the last entry nearly is the first exit, at a corner, rounding may decide. Finite arguments.
template <class S, int N, class Trace = NoTrace>
std::optional<Interval<S>> liang_barsky(const Segment<S, N>& segment, const Aabb<S, N>& box, Trace&& trace = {}) {
  const Outcodes codes = {outcode(segment.p, box), outcode(segment.q, box)};
  trace(codes);
  if ((codes.p & codes.q) != 0) return {};
  if ((codes.p | codes.q) == 0) return Interval<S>{S(0), S(1)};

  Interval<S> range = {S(0), S(1)};
  for (int i = 0; i < N; ++i)
    for (const bool upper : {false, true}) {  // inside: room + t rate >= 0
      const S room = upper ? box.hi[i] - segment.p[i] : segment.p[i] - box.lo[i];
      const S rate = upper ? segment.p[i] - segment.q[i] : segment.q[i] - segment.p[i];
      const int heading = rate > S(0) ? 1 : rate < S(0) ? -1 : 0;
      const S t = heading == 0 ? S(0) : -room / rate;
      if (heading > 0) range.lo = std::max(range.lo, t);
      if (heading < 0) range.hi = std::min(range.hi, t);
      const bool holds = heading == 0 ? room >= S(0) : range.lo <= range.hi;
      trace(Narrowed<S>{i, upper, heading, t, range, holds});
      if (!holds) return {};
    }
  return range;
}

}  // namespace isect::clip_segment
