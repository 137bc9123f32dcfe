#pragma once
// Many against one: shapes as a structure of arrays, and the loop that asks all of them one question.
//
// Eight numbers of the same kind side by side fill a vector register; the shapes of isect/shapes.h scatter them. So a
// batch is a set of columns: all x, all y, all z, all radii. A filter in plain S computes two numbers for every
// entry,
//
//   no > 0:    the answer is no, else yes;        sure > 0:  rounding can't have changed that (false for NaN),
//
// without a branch, eight or sixteen entries at a time. The few that are not sure are handed to the exact scalar
// test, one by one. So the answers are those of the scalar test, every one, whatever the instruction set.
//
// Source: the note, N10, rule 6; the way of filters is that of isect/numbers/arithmetic.h.

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <utility>
#include <vector>

#include <isect/parts/instruction_set.h>
#include <isect/shapes.h>

namespace isect {

/// One bit for each entry.
class Mask {
 public:
  explicit Mask(std::size_t size) : size_(size), words_((size + simd::block - 1) / simd::block) {}

  std::size_t size() const { return size_; }
  bool operator[](std::size_t i) const { return words_[i / simd::block] >> i % simd::block & 1; }
  std::size_t count() const {
    std::size_t sum = 0;
    for (const std::uint64_t word : words_) sum += static_cast<std::size_t>(std::popcount(word));
    return sum;
  }
  /// Returns the indices of the entries whose bit is set, in order.
  std::vector<std::size_t> indices() const {
    std::vector<std::size_t> list;
    for (std::size_t w = 0; w < words_.size(); ++w)
      for (std::uint64_t rest = words_[w]; rest != 0; rest &= rest - 1)
        list.push_back(w * simd::block + static_cast<std::size_t>(std::countr_zero(rest)));
    return list;
  }
  /// The words, of 64 entries each, the first in the lowest bit; bits beyond the size are zero.
  std::vector<std::uint64_t>& words() { return words_; }
  const std::vector<std::uint64_t>& words() const { return words_; }

 private:
  std::size_t size_;
  std::vector<std::uint64_t> words_;
};

/// Columns of equal length, at any address; a view, which owns nothing.
template <class S, int N>
struct PointBatch {
  std::array<std::span<const S>, N> coordinates;

  std::size_t size() const { return coordinates[0].size(); }
  Point<S, N> operator[](std::size_t i) const {
    Point<S, N> p;
    for (int k = 0; k < N; ++k) p[k] = coordinates[k][i];
    return p;
  }
};
template <class S, int N>
struct SphereBatch {
  PointBatch<S, N> centers;
  std::span<const S> radii;

  std::size_t size() const { return radii.size(); }
  Sphere<S, N> operator[](std::size_t i) const { return {centers[i], radii[i]}; }
};
template <class S, int N>
struct BoxBatch {
  PointBatch<S, N> lo, hi;

  std::size_t size() const { return lo.size(); }
  Aabb<S, N> operator[](std::size_t i) const { return {lo[i], hi[i]}; }
};

namespace batch {

namespace detail {

template <class S, std::size_t K>
using Columns = std::array<const S*, K>;

template <class S, int N>
Columns<S, N + 1> columns(const SphereBatch<S, N>& spheres) {
  Columns<S, N + 1> c;
  for (int k = 0; k < N; ++k) c[k] = spheres.centers.coordinates[k].data();
  c[N] = spheres.radii.data();
  return c;
}
template <class S, int N>
Columns<S, 2 * N> columns(const BoxBatch<S, N>& boxes) {
  Columns<S, 2 * N> c;
  for (int k = 0; k < N; ++k) c[k] = boxes.lo.coordinates[k].data(), c[N + k] = boxes.hi.coordinates[k].data();
  return c;
}

/// The signs that a filter finds for several entries at once; V is a vector of S.
template <class V>
struct FilterSigns {
  V no, sure;
};
/// The bits of 64 entries.
struct Bits {
  std::uint64_t yes, sure;
};

/// Runs filter(columns..., out) on 64 entries.
template <int Bytes, class S, std::size_t K, class Filter, std::size_t... I>
[[gnu::always_inline]] inline Bits filter_block(const Columns<S, K>& at, const Filter& filter,
                                                std::index_sequence<I...>) {
  using Of = simd::Of<S, Bytes>;
  using Vector = typename Of::Vector;
  using Unaligned = typename Of::Unaligned;
  const Vector zero = {};
  Bits bits = {0, 0};
  for (std::size_t i = 0; i < simd::block; i += Of::lanes) {
    const std::array<Vector, K> entries = {Vector(*reinterpret_cast<const Unaligned*>(at[I] + i))...};
    FilterSigns<Vector> f;
    filter(entries, f);
    bits.yes |= simd::greater(f.no, zero) << i;
    bits.sure |= simd::greater(f.sure, zero) << i;
  }
  return {~bits.yes, bits.sure};
}

/// The loop over all blocks of 64, written for simd::run; finish(first, bits) is called for each in order. A last
/// block of fewer entries is filled up with copies of its last one, whose bits are zero.
template <class S, std::size_t K, class Filter, class Finish>
struct Loop {
  const Columns<S, K>& columns;
  std::size_t size;
  const Filter& filter;
  const Finish& finish;

  template <int Bytes>
  [[gnu::always_inline]] void operator()() const {
    constexpr auto all = std::make_index_sequence<K>{};
    const std::size_t rest = size % simd::block, whole = size - rest;
    Columns<S, K> at = columns;
    for (std::size_t first = 0; first < whole; first += simd::block) {
      finish(first, filter_block<Bytes, S, K>(at, filter, all));
      for (const S*& column : at) column += simd::block;
    }
    if (rest == 0) return;

    alignas(64) S copies[K][simd::block];
    for (std::size_t k = 0; k < K; ++k) {
      for (std::size_t i = 0; i < simd::block; ++i) copies[k][i] = at[k][i < rest ? i : rest - 1];
      at[k] = copies[k];
    }
    const std::uint64_t those = (std::uint64_t{1} << rest) - 1;
    const Bits bits = filter_block<Bytes, S, K>(at, filter, all);
    finish(whole, Bits{bits.yes & those, bits.sure | ~those});
  }
};

/// Runs the filter over all entries, and calls finish(first, bits) for every 64.
template <class S, std::size_t K, class Filter, class Finish>
void each_block(const Columns<S, K>& columns, std::size_t size, InstructionSet set, const Filter& filter,
                const Finish& finish) {
  simd::run(set, Loop<S, K, Filter, Finish>{columns, size, filter, finish});
}

/// The answers of the exact test `exact(i)`, which runs only where the filter is not sure.
template <class S, std::size_t K, class Filter, class Exact>
Mask answers(const Columns<S, K>& columns, std::size_t size, InstructionSet set, const Filter& filter,
             const Exact& exact) {
  Mask mask(size);
  each_block<S>(columns, size, set, filter, [&](std::size_t first, const Bits& bits) {
    std::uint64_t yes = bits.yes;
    for (std::uint64_t open = ~bits.sure; open != 0; open &= open - 1) {
      const std::uint64_t bit = open & -open;
      const bool answer = exact(first + static_cast<std::size_t>(std::countr_zero(open)));
      yes = answer ? yes | bit : yes & ~bit;
    }
    mask.words()[first / simd::block] = yes;
  });
  return mask;
}

}  // namespace detail

}  // namespace batch

}  // namespace isect
