#pragma once
// Which edges of a ring cross the ray from a point to the right, in the machine's widest vectors; the few edges that
// comparisons don't settle are left to the text of isect/point_polygon.h.
//
// A ring's coordinates lie x, y, x, y, ... in memory, and so do the bits that tell which are greater than the point's:
// 64 of 32 vertices. Next to them stand those of the vertices before. An edge crosses the line y = p.y where its two
// bits of y differ. Then it lies on the right of p where both bits of x are set, on the left where none is; else
// orient2d has to tell. It also has to for an edge that touches the line y = p.y or x = p.x, which is rare.
//
// A difference of finite numbers has their order's sign, even if it overflows. The product of a word's differences is
// finite and not 0 unless one of them is 0 or a coordinate isn't finite; or it overflows, or underflows. Only then the
// coordinates are looked at again, one by one.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>

#include <isect/parts/instruction_set.h>
#include <isect/shapes.h>

namespace isect::point_polygon {

namespace detail {

/// Edges left to be tested one by one: the bit 2 i is that of the edge that ends at vertex `first` + i.
struct OpenEdges {
  std::size_t first;
  std::uint64_t bits;
};

/// What is known of the edges that end at some of a ring's vertices.
struct Scanned {
  static constexpr std::size_t most_words = 64;

  int crossings = 0, winding = 0;          ///< of edges that cross the ray for certain
  bool finite = true;                      ///< all coordinates are
  std::size_t words = 0;                   ///< how many of `open` are used
  std::array<OpenEdges, most_words> open;  ///< edges that may cross the ray, or hold the point
};

/// Scans the edges that end at the vertices `first`, ..., `last` - 1. Edges with a coordinate that is not finite count
/// as anything.
template <class S>
struct Scan {
  static constexpr std::size_t few = 32 / sizeof(S);               ///< so many vertices fill the widest vector
  static constexpr std::size_t word = 32;                          ///< so many vertices have 64 bits
  static constexpr std::size_t most = Scanned::most_words * word;  ///< of one scan

  const Point<S, 2>& p;
  std::span<const Point<S, 2>> vertices;  ///< of the ring, `few` at least
  const Point<S, 2>& before;              ///< the vertex before `first`
  std::size_t first, last;
  Scanned& scanned;

  template <int Bytes>
  [[gnu::always_inline]] void operator()() const {
    using Of = simd::Of<S, Bytes>;
    typename Of::Vector point;
    simd::alternate(point, p[0], p[1], std::make_index_sequence<Of::lanes>());
    const auto bits = [&](const auto& test) { return std::uint64_t{test(0)} | std::uint64_t{test(1)} << 1; };
    Word from = {bits([&](int k) { return before[k] > p[k]; }), bits([&](int k) { return before[k] == p[k]; })};

    const std::uint64_t beyond = last < word ? ~std::uint64_t{0} << 2 * last : 0;
    if (vertices.size() < word) {
      count(0, read_few<Bytes>(point), from, ~std::uint64_t{0} << 2 * first & ~beyond);
      return;
    }
    const std::size_t last_word = std::max(last, word) - word;
    for (std::size_t i = first; i < last; i += word) {
      const std::size_t start = std::min(i, last_word);  // the last word may begin with vertices known already
      const Word here = read<Bytes>(vertices.data() + start, point);
      count(start, here, from, ~std::uint64_t{0} << 2 * (i - start) & ~beyond);
      from = {here.greater >> 62, here.equal >> 62};
    }
  }

 private:
  /// Bits that tell for each coordinate whether it is greater than the point's, and whether it equals that.
  struct Word {
    std::uint64_t greater, equal;
  };

  /// Reads a word of vertices from there on; `point` has p.x and p.y by turns.
  template <int Bytes, class Vector>
  [[gnu::always_inline]] Word read(const Point<S, 2>* from, const Vector& point) const {
    using Unaligned = typename simd::Of<S, Bytes>::Unaligned;
    constexpr std::size_t lanes = simd::Of<S, Bytes>::lanes;
    constexpr std::size_t some_vectors = std::min<std::size_t>(8, simd::block / lanes);  // for want of registers
    const S* const numbers = from->data();
    const Vector zero = {};
    Vector product = zero + 1;
    Word here = {0, 0};
    for (std::size_t i = 0; i < simd::block;) {
      std::uint64_t some = 0;
      for (std::size_t k = 0; k < some_vectors; ++k, i += lanes) {
        const Vector away = *reinterpret_cast<const Unaligned*>(numbers + i) - point;
        product *= away;
        some |= simd::greater(away, zero) << k * lanes;
      }
      here.greater |= some << (i - some_vectors * lanes);
    }
    if (unequal<Bytes>(product)) [[likely]]
      return here;
    for (std::size_t i = 0; i < simd::block; i += lanes) look_again<Bytes>(numbers, i, point, here);
    return here;
  }

  /// Reads all vertices, which are less than a word. The last vector may begin with numbers known already.
  template <int Bytes, class Vector>
  [[gnu::always_inline]] Word read_few(const Vector& point) const {
    using Unaligned = typename simd::Of<S, Bytes>::Unaligned;
    constexpr std::size_t lanes = simd::Of<S, Bytes>::lanes;
    static_assert(lanes <= 2 * few);
    const S* const numbers = vertices[0].data();
    const std::size_t count = 2 * vertices.size();
    const Vector zero = {};
    Vector product = zero + 1;
    Word here = {0, 0};
    for (std::size_t i = 0; i < count; i += lanes) {
      const std::size_t start = std::min(i, count - lanes);
      const Vector away = *reinterpret_cast<const Unaligned*>(numbers + start) - point;
      product *= away;
      here.greater |= simd::greater(away, zero) << start;
    }
    if (unequal<Bytes>(product)) [[likely]]
      return here;
    for (std::size_t i = 0; i < count; i += lanes) look_again<Bytes>(numbers, std::min(i, count - lanes), point, here);
    return here;
  }

  /// Whether no difference in the product is 0 or not finite.
  template <int Bytes, class Vector>
  [[gnu::always_inline]] static bool unequal(const Vector& product) {
    constexpr std::uint64_t all = (std::uint64_t{1} << simd::Of<S, Bytes>::lanes) - 1;
    const Vector zero = {};
    return (simd::equal(product - product, zero) & ~simd::equal(product, zero)) == all;
  }

  /// Checks the coordinates themselves of the vector at number i: whether they are finite, and which equal the point's.
  template <int Bytes, class Vector>
  [[gnu::always_inline]] void look_again(const S* numbers, std::size_t i, const Vector& point, Word& here) const {
    constexpr std::uint64_t all = (std::uint64_t{1} << simd::Of<S, Bytes>::lanes) - 1;
    const Vector zero = {}, v = *reinterpret_cast<const typename simd::Of<S, Bytes>::Unaligned*>(numbers + i);
    scanned.finite &= simd::equal(v - v, zero) == all;
    here.equal |= simd::equal(v, point) << i;
  }

  /// Counts the edges to the vertices from `index` on, those of `mask`. The word before ends with `previous`.
  [[gnu::always_inline]] void count(std::size_t index, const Word& here, const Word& previous,
                                    std::uint64_t mask) const {
    const std::uint64_t from = here.greater << 2 | previous.greater, x = 0x5555555555555555 & mask;
    const std::uint64_t touched = here.equal | here.equal << 2 | previous.equal, asked = touched | touched >> 1;
    const std::uint64_t crossed = (here.greater ^ from) >> 1 & x & ~asked;
    const std::uint64_t counted = crossed & here.greater & from;
    const int all = std::popcount(counted), up = std::popcount(counted & here.greater >> 1);
    scanned.crossings += all, scanned.winding += 2 * up - all;

    scanned.open[scanned.words] = {index, (crossed & (here.greater ^ from)) | (asked & x)};
    scanned.words += scanned.open[scanned.words].bits != 0;
  }
};

}  // namespace detail

}  // namespace isect::point_polygon
