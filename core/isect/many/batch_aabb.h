#pragma once
// One axis-aligned box against many: isect/aabb_aabb.h in columns. See isect/many/batch.h.

#include <limits>

#include <isect/aabb_aabb.h>
#include <isect/many/batch.h>

namespace isect {

namespace batch {

namespace detail {

/// Whether a box meets `a`, by the rule of intersects(Aabb, Aabb): the shared box is inverted on no axis. A difference
/// of finite numbers has their order's sign, even if it overflows. Infinite coordinates and NaN show in the sum of
/// the widths, unless the box is inverted, which the verdict shows itself.
template <class S, int N>
struct MeetsBox {
  Aabb<S, N> a;

  template <class V>
  [[gnu::always_inline]] void operator()(const std::array<V, 2 * N>& b, FilterSigns<V>& f) const {
    using simd::lower, simd::raise;
    V widths = b[N] - b[0];
    for (int k = 0; k < N; ++k) {
      V lo = b[k], hi = b[N + k];
      if (k > 0) widths += hi - lo;
      raise(lo, V{} + a.lo[k]), lower(hi, V{} + a.hi[k]);
      if (k == 0) f.no = lo - hi;
      raise(f.no, lo - hi);
    }
    f.sure = std::numeric_limits<S>::max() - widths;
  }
};

}  // namespace detail

}  // namespace batch

/// Bit i: intersects(box, boxes[i]). Exact; nothing meets an empty box, NaN or an infinite coordinate. `set` is one
/// that the machine has.
template <class S, int N>
Mask intersects(const Aabb<S, N>& box, const BoxBatch<S, N>& boxes, InstructionSet set = widest()) {
  if (empty(box) || !finite(box)) return Mask(boxes.size());
  return batch::detail::answers<S>(batch::detail::columns(boxes), boxes.size(), set, batch::detail::MeetsBox<S, N>{box},
                                   [&](std::size_t i) { return intersects(box, boxes[i]); });
}

}  // namespace isect
