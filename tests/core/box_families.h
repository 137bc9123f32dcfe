#pragma once
// Many boxes at once, laid out in the ways that trouble hierarchies.

#include <algorithm>
#include <limits>
#include <vector>

#include "bench/random_shapes.h"

namespace isect::tests {

enum class Layout {
  uniform,     ///< small boxes anywhere
  clustered,   ///< in a few heaps
  tailed,      ///< sizes and distances over many powers of two
  gridded,     ///< cells of a grid: neighbours touch
  duplicate,   ///< few different boxes, each many times
  concentric,  ///< all centers equal
  flat,        ///< in a plane, without thickness
  collinear,   ///< on a line, without thickness
  points,      ///< no extent at all
  crowded      ///< large boxes, most of which meet
};
inline constexpr Layout all_layouts[] = {Layout::uniform,   Layout::clustered,  Layout::tailed, Layout::gridded,
                                         Layout::duplicate, Layout::concentric, Layout::flat,   Layout::collinear,
                                         Layout::points,    Layout::crowded};

template <class S, int N>
Aabb<S, N> box_around(const Vector<double, N>& center, const Vector<double, N>& half) {
  return {(center - half).template cast<S>(), (center + half).template cast<S>()};
}

template <class S, int N>
Aabb<S, N> one_box(bench::Random& random, Layout layout) {
  const double most = std::is_same_v<S, float> ? 100 : 900;  // of a power of two
  Vector<double, N> center = random.in_box<N>(10), half = random.in_box<N>(0.5).cwiseAbs();
  switch (layout) {
    case Layout::clustered:
      center = center / 10 + Vector<double, N>::Constant(30 * random.below(4));
      half /= 20;
      break;
    case Layout::tailed: {
      const double size = std::exp2(random.one_in(20) ? random.uniform(-most, most) : random.uniform(-3, 3));
      center *= size, half *= size;
      break;
    }
    case Layout::gridded:
      for (int i = 0; i < N; ++i) center[i] = random.integer(-5, 5), half[i] = 0.5;
      break;
    case Layout::duplicate:
      for (int i = 0; i < N; ++i) center[i] = random.integer(0, 1), half[i] = 0.25;
      break;
    case Layout::concentric:
      center.setZero();
      break;
    case Layout::flat:
      center[N - 1] = 2, half[N - 1] = 0;
      break;
    case Layout::collinear:
      center.tail(N - 1).setConstant(1), half.tail(N - 1).setZero();
      break;
    case Layout::points:
      half.setZero();
      break;
    case Layout::crowded:
      half *= 10;
      break;
    default:
      break;
  }
  return box_around<S, N>(center, half);
}

template <class S, int N>
std::vector<Aabb<S, N>> some_boxes(bench::Random& random, Layout layout, int count) {
  std::vector<Aabb<S, N>> boxes;
  for (int i = 0; i < count; ++i) boxes.push_back(one_box<S, N>(random, layout));
  return boxes;
}

/// Boxes between any two points of a family of numbers.
template <class S, int N>
std::vector<Aabb<S, N>> some_boxes(bench::Random& random, bench::Numbers numbers, int count) {
  std::vector<Aabb<S, N>> boxes;
  for (int i = 0; i < count; ++i) {
    const Point<S, N> a = bench::vector<S, N>(random, numbers), b = bench::vector<S, N>(random, numbers);
    boxes.push_back({a.cwiseMin(b), a.cwiseMax(b)});
  }
  return boxes;
}

/// Spoils one box in `share`: inverted, or with a NaN or an infinity.
template <class S, int N>
void spoil(bench::Random& random, std::vector<Aabb<S, N>>& boxes, int share) {
  using Limits = std::numeric_limits<S>;
  for (Aabb<S, N>& box : boxes) {
    if (!random.one_in(share)) continue;
    S& end = random.one_in(2) ? box.lo[random.below(N)] : box.hi[random.below(N)];
    switch (random.below(4)) {
      case 0:
        end = Limits::quiet_NaN();
        break;
      case 1:
        end = Limits::infinity();
        break;
      case 2:
        end = -Limits::infinity();
        break;
      default:
        std::swap(box.lo, box.hi);
    }
  }
}

}  // namespace isect::tests
