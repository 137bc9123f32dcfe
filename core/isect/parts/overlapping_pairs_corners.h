#pragma once
// Boxes as rows of numbers that compare without a branch, and the list that pairs are written to.
// isect/many/overlapping_pairs.h says what for.

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <isect/many/all_pairs.h>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace isect {

namespace detail::overlapping_pairs {

/// A box as 2 N numbers, so that boxes meet iff corners(a)[k] <= reach(b)[k] for every k.
template <class S, int N>
struct Corners {
  static constexpr int width = std::is_same_v<S, float> && N == 3 ? 8 : 2 * N;  ///< filled up with 0 <= 0
  S numbers[width];
};
/// (lo, -hi)
template <class S, int N>
Corners<S, N> corners(const Aabb<S, N>& box) {
  Corners<S, N> c = {};
  for (int i = 0; i < N; ++i) c.numbers[i] = box.lo[i], c.numbers[N + i] = -box.hi[i];
  return c;
}
/// (hi, -lo), from (lo, -hi)
template <class S, int N>
Corners<S, N> reach(const Corners<S, N>& box) {
  Corners<S, N> c = {};
  for (int i = 0; i < N; ++i) c.numbers[i] = -box.numbers[N + i], c.numbers[N + i] = -box.numbers[i];
  return c;
}
/// Whether the boxes meet; without branches, as nothing predicts the answer.
template <class S, int N>
bool meet(const Corners<S, N>& corners, const Corners<S, N>& reach) {
  bool all = true;
  for (int k = 0; k < 2 * N; ++k) all &= corners.numbers[k] <= reach.numbers[k];
  return all;
}
#ifdef __SSE2__
template <int N>
bool meet(const Corners<float, N>& corners, const Corners<float, N>& reach) {
  __m128 all = _mm_cmple_ps(_mm_loadu_ps(corners.numbers), _mm_loadu_ps(reach.numbers));
  if constexpr (N == 3)
    all = _mm_and_ps(all, _mm_cmple_ps(_mm_loadu_ps(corners.numbers + 4), _mm_loadu_ps(reach.numbers + 4)));
  return _mm_movemask_ps(all) == 15;
}
template <int N>
bool meet(const Corners<double, N>& corners, const Corners<double, N>& reach) {
  __m128d all = _mm_cmple_pd(_mm_loadu_pd(corners.numbers), _mm_loadu_pd(reach.numbers));
  for (int k = 2; k < 2 * N; k += 2)
    all = _mm_and_pd(all, _mm_cmple_pd(_mm_loadu_pd(corners.numbers + k), _mm_loadu_pd(reach.numbers + k)));
  return _mm_movemask_pd(all) == 3;
}
#endif

/// The pairs found, before they are reported. Writing is unconditional, counting is not: no branch on the answer.
template <class Report>
class Pairs {
 public:
  explicit Pairs(Report& report) : report_(report), found_(2 * block + 1) {}

  /// Tests box i against those from begin to end, by fours, beyond the end too: loops of one length are predicted.
  template <class S, int N>
  void test(int i, const Corners<S, N>& reach, const Corners<S, N>* corners, const int* index, int begin, int end) {
    test(i, reach, corners, index, begin, end, Any());
  }
  /// Tests as above, but only boxes that pass `wanted` count.
  template <class S, int N, class Wanted>
  void test(int i, const Corners<S, N>& reach, const Corners<S, N>* corners, const int* index, int begin, int end,
            const Wanted& wanted) {
    while (begin < end) {
      if (count_ > block) flush();
      const int stop = std::min(end, begin + block), before = count_;
      for (int k = begin; k < stop; k += 4)
        for (int l = k; l < k + 4; ++l) {
          found_[count_] = {i, index[l]};
          count_ += meet(corners[l], reach) & (l < stop);
        }
      begin = stop;
      if constexpr (std::is_same_v<Wanted, Any>) continue;
      const auto unwanted = [&](const IndexPair& p) { return !wanted(p.j); };
      const auto kept = std::remove_if(found_.begin() + before, found_.begin() + count_, unwanted);
      count_ = static_cast<int>(kept - found_.begin());
    }
  }
  void flush() {
    for (int k = 0; k < count_; ++k) {
      const auto [i, j] = found_[k];
      report_(std::min(i, j), std::max(i, j));
    }
    count_ = 0;
  }

 private:
  struct Any {
    bool operator()(int) const { return true; }
  };
  static constexpr int block = 2048;

  Report& report_;
  std::vector<IndexPair> found_;
  int count_ = 0;
};

}  // namespace detail::overlapping_pairs

}  // namespace isect
