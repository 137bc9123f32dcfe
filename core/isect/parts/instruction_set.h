#pragma once
// The machine's widest vectors, in a program built for any x86-64: one text is compiled for several instruction sets,
// and the one to run is chosen when the program runs.
//
// The text is written on vectors of `Bytes` bytes (GCC's and clang's own, with + - * and comparisons) and handed over
// as a function object whose calls are all inlined. Every set rounds alike, except in add_product: elsewhere products
// are never fused with sums (-ffp-contract=off, see core/CMakeLists.txt). On other machines there is one set, `any`.
//
// A comparison of vectors yields a mask in the one form that only the set's own instructions turn into bits: `greater`
// and `equal` do that.

#include <cstddef>
#include <cstdint>
#include <utility>

#if defined(__x86_64__)
#include <immintrin.h>
#define ISECT_X86 1
#else
#define ISECT_X86 0
#endif

namespace isect {

/// `any` is what the compiler was told to build for.
enum class InstructionSet { any, avx2, avx512 };

/// The widest set that this machine has.
inline InstructionSet widest() {
#if ISECT_X86
  static const InstructionSet set = [] {
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) return InstructionSet::avx512;
    const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    return avx2 ? InstructionSet::avx2 : InstructionSet::any;
  }();
  return set;
#else
  return InstructionSet::any;
#endif
}

namespace simd {

/// A vector of S, and the same at any address of an S.
template <class S, int Bytes>
struct Of {
  typedef S Vector __attribute__((vector_size(Bytes)));
  typedef S Unaligned __attribute__((vector_size(Bytes), aligned(alignof(S)), may_alias));
  static constexpr std::size_t lanes = Bytes / sizeof(S);
};

/// x becomes the smaller of the two in every lane, or the larger; a NaN in y is overlooked, one in x stays.
template <class V>
[[gnu::always_inline]] inline void lower(V& x, const V& y) {
  x = y < x ? y : x;
}
template <class V>
[[gnu::always_inline]] inline void raise(V& x, const V& y) {
  x = y > x ? y : x;
}

/// x becomes a, b, a, b, ...; I counts its lanes.
template <class V, class S, std::size_t... I>
[[gnu::always_inline]] inline void alternate(V& x, S a, S b, std::index_sequence<I...>) {
  const V zero = {}, odd = {S(I % 2)...};
  x = odd > zero ? zero + b : zero + a;
}

/// How many numbers make a word of bits.
inline constexpr std::size_t block = 64;

namespace detail {

// The bits of comparisons: inlined once the text around them is compiled for their set, which always_inline won't wait
// for.
#if ISECT_X86
#define ISECT_AVX512 "avx512f,avx512dq"
#define ISECT_AVX2 "avx2,fma"
template <int predicate>
[[gnu::target(ISECT_AVX512)]] inline unsigned compared(const __m512d& x, const __m512d& y) {
  return _mm512_cmp_pd_mask(x, y, predicate);
}
template <int predicate>
[[gnu::target(ISECT_AVX512)]] inline unsigned compared(const __m512& x, const __m512& y) {
  return _mm512_cmp_ps_mask(x, y, predicate);
}
template <int predicate>
[[gnu::target(ISECT_AVX2)]] inline unsigned compared(const __m256d& x, const __m256d& y) {
  return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(x, y, predicate)));
}
template <int predicate>
[[gnu::target(ISECT_AVX2)]] inline unsigned compared(const __m256& x, const __m256& y) {
  return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(x, y, predicate)));
}
template <int predicate>
inline unsigned compared(const __m128d& x, const __m128d& y) {
  return static_cast<unsigned>(_mm_movemask_pd(predicate == _CMP_GT_OQ ? _mm_cmpgt_pd(x, y) : _mm_cmpeq_pd(x, y)));
}
template <int predicate>
inline unsigned compared(const __m128& x, const __m128& y) {
  return static_cast<unsigned>(_mm_movemask_ps(predicate == _CMP_GT_OQ ? _mm_cmpgt_ps(x, y) : _mm_cmpeq_ps(x, y)));
}
#endif

#if ISECT_X86
[[gnu::target(ISECT_AVX512)]] inline void fuse(__m512d& x, const __m512d& a, const __m512d& b) {
  x = _mm512_fmadd_pd(a, b, x);
}
[[gnu::target(ISECT_AVX512)]] inline void fuse(__m512& x, const __m512& a, const __m512& b) {
  x = _mm512_fmadd_ps(a, b, x);
}
[[gnu::target(ISECT_AVX2)]] inline void fuse(__m256d& x, const __m256d& a, const __m256d& b) {
  x = _mm256_fmadd_pd(a, b, x);
}
[[gnu::target(ISECT_AVX2)]] inline void fuse(__m256& x, const __m256& a, const __m256& b) {
  x = _mm256_fmadd_ps(a, b, x);
}
#endif

}  // namespace detail

/// x becomes x + a b, rounded once where the set can, else twice.
template <class V>
[[gnu::always_inline]] inline void add_product(V& x, const V& a, const V& b) {
#if ISECT_X86
  if constexpr (sizeof(V) > 16) {
    detail::fuse(x, a, b);
    return;
  }
#endif
  x += a * b;
}

/// Bit k of the result: whether x[k] > y[k]; for `equal`, x[k] == y[k].
template <class V>
[[gnu::always_inline]] inline std::uint64_t greater(const V& x, const V& y) {
#if ISECT_X86
  return detail::compared<_CMP_GT_OQ>(x, y);
#else
  std::uint64_t word = 0;
  for (std::size_t k = 0; k < sizeof(V) / sizeof x[0]; ++k) word |= std::uint64_t{x[k] > y[k]} << k;
  return word;
#endif
}
template <class V>
[[gnu::always_inline]] inline std::uint64_t equal(const V& x, const V& y) {
#if ISECT_X86
  return detail::compared<_CMP_EQ_OQ>(x, y);
#else
  std::uint64_t word = 0;
  for (std::size_t k = 0; k < sizeof(V) / sizeof x[0]; ++k) word |= std::uint64_t{x[k] == y[k]} << k;
  return word;
#endif
}

namespace detail {
#if ISECT_X86
template <class Text>
[[gnu::target(ISECT_AVX512), gnu::noinline]] void run_avx512(const Text& text) {
  text.template operator()<64>();
}
template <class Text>
[[gnu::target(ISECT_AVX2), gnu::noinline]] void run_avx2(const Text& text) {
  text.template operator()<32>();
}
#endif
}  // namespace detail

/// text.operator()<Bytes>(), in the instructions of a set that this machine has.
template <class Text>
void run([[maybe_unused]] InstructionSet set, const Text& text) {
#if ISECT_X86
  if (set == InstructionSet::avx512) return detail::run_avx512(text);
  if (set == InstructionSet::avx2) return detail::run_avx2(text);
#endif
  text.template operator()<16>();
}

}  // namespace simd

}  // namespace isect
