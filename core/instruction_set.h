#pragma once
// The machine's widest vectors, in a program built for any x86-64: one text is compiled for several instruction sets,
// and the one to run is chosen when the program runs.
//
// The text is written on vectors of `Bytes` bytes (GCC's and clang's own, with + - * and comparisons) and handed over
// as a function object whose calls are all inlined. Every set rounds alike: products are never fused with sums
// (-ffp-contract=off, see core/CMakeLists.txt). On other machines there is one set, `any`.
//
// A comparison of vectors yields a mask in the one form that only the set's own instructions turn into bits; so the
// texts store numbers whose sign is the answer, and `positive` makes bits of them.

#include <cstddef>
#include <cstdint>

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
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
      return InstructionSet::avx512;
    return __builtin_cpu_supports("avx2") ? InstructionSet::avx2 : InstructionSet::any;
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

/// How many numbers make a word of bits.
inline constexpr std::size_t block = 64;

// Bit i of the result: whether x[i] > 0. All 64 are read; x is aligned to 64 bytes.
#if ISECT_X86
[[gnu::target("avx512f,avx512dq"), gnu::noinline]] inline std::uint64_t positive_avx512(const double* x) {
  std::uint64_t word = 0;
  for (int i = 0; i < 64; i += 8)
    word |= std::uint64_t{_mm512_cmp_pd_mask(_mm512_load_pd(x + i), _mm512_setzero_pd(), _CMP_GT_OQ)} << i;
  return word;
}
[[gnu::target("avx512f,avx512dq"), gnu::noinline]] inline std::uint64_t positive_avx512(const float* x) {
  std::uint64_t word = 0;
  for (int i = 0; i < 64; i += 16)
    word |= std::uint64_t{_mm512_cmp_ps_mask(_mm512_load_ps(x + i), _mm512_setzero_ps(), _CMP_GT_OQ)} << i;
  return word;
}
[[gnu::target("avx2"), gnu::noinline]] inline std::uint64_t positive_avx2(const double* x) {
  std::uint64_t word = 0;
  for (int i = 0; i < 64; i += 4) {
    const __m256d above = _mm256_cmp_pd(_mm256_load_pd(x + i), _mm256_setzero_pd(), _CMP_GT_OQ);
    word |= static_cast<std::uint64_t>(_mm256_movemask_pd(above)) << i;
  }
  return word;
}
[[gnu::target("avx2"), gnu::noinline]] inline std::uint64_t positive_avx2(const float* x) {
  std::uint64_t word = 0;
  for (int i = 0; i < 64; i += 8) {
    const __m256 above = _mm256_cmp_ps(_mm256_load_ps(x + i), _mm256_setzero_ps(), _CMP_GT_OQ);
    word |= static_cast<std::uint64_t>(_mm256_movemask_ps(above)) << i;
  }
  return word;
}
inline std::uint64_t positive_any(const double* x) {
  std::uint64_t word = 0;
  for (int i = 0; i < 64; i += 2)
    word |= static_cast<std::uint64_t>(_mm_movemask_pd(_mm_cmpgt_pd(_mm_load_pd(x + i), _mm_setzero_pd())))
            << i;
  return word;
}
inline std::uint64_t positive_any(const float* x) {
  std::uint64_t word = 0;
  for (int i = 0; i < 64; i += 4)
    word |= static_cast<std::uint64_t>(_mm_movemask_ps(_mm_cmpgt_ps(_mm_load_ps(x + i), _mm_setzero_ps())))
            << i;
  return word;
}
#else
template <class S>
std::uint64_t positive_any(const S* x) {
  std::uint64_t word = 0;
  for (int i = 0; i < 64; ++i) word |= std::uint64_t{x[i] > 0} << i;
  return word;
}
#endif

template <int Bytes, class S>
[[gnu::always_inline]] inline std::uint64_t positive(const S* x) {
#if ISECT_X86
  if constexpr (Bytes == 64) return positive_avx512(x);
  if constexpr (Bytes == 32) return positive_avx2(x);
#endif
  return positive_any(x);
}

#if ISECT_X86
template <class Text>
[[gnu::target("avx512f,avx512dq"), gnu::noinline]] void run_avx512(const Text& text) {
  text.template operator()<64>();
}
template <class Text>
[[gnu::target("avx2"), gnu::noinline]] void run_avx2(const Text& text) {
  text.template operator()<32>();
}
#endif

/// text.operator()<Bytes>(), in the instructions of a set that this machine has.
template <class Text>
void run(InstructionSet set, const Text& text) {
#if ISECT_X86
  if (set == InstructionSet::avx512) return run_avx512(text);
  if (set == InstructionSet::avx2) return run_avx2(text);
#endif
  text.template operator()<16>();
}

}  // namespace simd

}  // namespace isect
