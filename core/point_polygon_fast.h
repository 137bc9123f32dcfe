#pragma once
// Which runs of eight edges of a ring can't count for a point, in the machine's widest vectors. The runs that are
// left are walked by core/point_polygon.h; its answers don't depend on what stands here.
//
// A ring's coordinates lie x, y, x, y, ... in memory, and so in a vector's lanes. The least and the largest of each
// lane are formed for the nine vertices of a run and compared with the point's: the run lies above it where that
// holds in all lanes of y, and so on.

#include <bit>
#include <span>

#include "core/instruction_set.h"
#include "core/shapes.h"

namespace isect::point_polygon {

/// Runs of eight edges, in order.
inline constexpr std::size_t run_length = 8;

/// Eight edges each, from the edge `first` on; the bit i * lanes is set where run i may count.
struct OpenRuns {
  std::size_t first;
  int lanes;
  std::uint64_t bits;
};

/// Of words that tell in each lane whether all vertices are greater than the point, and less. Those of x are even.
template <int lanes>
OpenRuns open_runs(std::size_t first, std::uint64_t greater, std::uint64_t less) {
  std::uint64_t lowest = 1;  // of each run
  for (int shift = lanes; shift < 64; shift *= 2) lowest |= lowest << shift;
  for (int shift = 2; shift < lanes; shift *= 2) greater &= greater >> shift, less &= less >> shift;
  const std::uint64_t left = less, beside = (greater | less) >> 1;
  return {first, lanes, ~(left | beside) & lowest};
}

/// Tells visit(OpenRuns) of all runs that fill whole words, until it returns false. Runs with a coordinate that is
/// not finite may be told of or not.
template <class S, class Visit>
struct Scan {
  const Point<S, 2>& p;
  std::span<const Point<S, 2>> vertices;
  const Visit& visit;
  std::size_t& end;  ///< the edge behind the last run
  bool& finite;      ///< the sum of all coordinates is; it may also overflow by itself

  template <int Bytes>
  [[gnu::always_inline]] void operator()() const {
    using Of = simd::Of<S, Bytes>;
    using Vector = typename Of::Vector;
    using Unaligned = typename Of::Unaligned;
    constexpr std::size_t lanes = Of::lanes, word = simd::block / lanes * run_length;
    static_assert(lanes <= 2 * run_length);

    Vector point;
    for (std::size_t k = 0; k < lanes; ++k) point[k] = p[static_cast<int>(k % 2)];
    alignas(64) S greater[simd::block], less[simd::block];
    const S* at = vertices[0].data();
    Vector sum = {};
    for (end = 0; end + word < vertices.size(); end += word) {
      for (std::size_t i = 0; i < simd::block; i += lanes, at += 2 * run_length) {
        // the last of the nine vertices, with those before it
        Vector lo = *reinterpret_cast<const Unaligned*>(at + 2 * (run_length + 1) - lanes), hi = lo;
        for (std::size_t k = 0; k < 2 * run_length; k += lanes) {
          const Vector v = *reinterpret_cast<const Unaligned*>(at + k);
          simd::lower(lo, v), simd::raise(hi, v), sum += v;
        }
        *reinterpret_cast<Unaligned*>(greater + i) = lo - point;
        *reinterpret_cast<Unaligned*>(less + i) = point - hi;
      }
      const OpenRuns open = open_runs<static_cast<int>(lanes)>(end, simd::positive<Bytes>(greater),
                                                               simd::positive<Bytes>(less));
      if (open.bits != 0 && !visit(open)) return;
    }
    S total = 0;
    for (std::size_t k = 0; k < lanes; ++k) total += sum[k];
    finite = total - total == 0;
  }
};

}  // namespace isect::point_polygon
