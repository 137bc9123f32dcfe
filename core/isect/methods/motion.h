#pragma once
// Moving objects tested time after time, as the note does: for lessons and comparison. `contact` in isect/many/motion.h
// is right for all input.

#include <vector>

#include <isect/many/motion.h>

namespace isect {

/// The times at which the shapes meet, of 0, duration / steps, 2 duration / steps, ... duration. Naive: what is
/// between two times is missed, and places are rounded.
template <template <class, int> class Shape, class S, int N, class Trace = NoTrace>
std::vector<S> discrete_hits(const Moving<Shape, S, N>& a, const Moving<Shape, S, N>& b, S duration, int steps,
                             Trace&& trace = {}) {
  std::vector<S> hits;
  for (int k = 0; k <= steps; ++k) {
    const S time = k == steps ? duration : duration * static_cast<S>(k) / static_cast<S>(steps);
    const Vector<S, N> way_a = a.velocity * time, way_b = b.velocity * time;
    const bool meet = intersects(motion::moved(a.shape, way_a), motion::moved(b.shape, way_b));
    trace(motion::At<S>{time, meet});
    if (meet) hits.push_back(time);
  }
  return hits;
}

}  // namespace isect
