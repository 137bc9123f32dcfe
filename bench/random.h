#pragma once
// Random shapes that are the same on every machine: the standard fixes std::mt19937_64, but not its distributions.

#include <cmath>
#include <cstdint>
#include <random>

#include <isect/shapes.h>

namespace isect::bench {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t bits() { return engine_(); }
  /// An integer of [0, n), n > 0.
  int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }
  /// An integer of [lo, hi].
  int integer(int lo, int hi) {
    const std::int64_t least = lo, count = hi - least + 1;  // may exceed an int
    return static_cast<int>(least + static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(count)));
  }
  bool one_in(int n) { return below(n) == 0; }

  /// A multiple of 2^-53 in [0, 1).
  double unit() { return std::ldexp(static_cast<double>(engine_() >> 11), -53); }
  double uniform(double lo, double hi) { return lo + (hi - lo) * unit(); }
  double sign() { return one_in(2) ? -1 : 1; }
  /// Either sign, and a size whose logarithm is uniform: 10^lo to 10^hi.
  double magnitude(double lo, double hi) {
    const double side = sign();  // in a statement of its own: operands are evaluated in any order
    return side * std::pow(10, uniform(lo, hi));
  }

  template <int N>
  Vector<double, N> in_box(double half) {
    Vector<double, N> v;
    for (int i = 0; i < N; ++i) v[i] = uniform(-half, half);
    return v;
  }
  /// Uniform on the unit sphere, up to rounding.
  template <int N>
  Vector<double, N> heading() {
    for (;;) {
      const Vector<double, N> v = in_box<N>(1);
      const double length2 = v.squaredNorm();
      if (0.01 < length2 && length2 <= 1) return v / std::sqrt(length2);
    }
  }

 private:
  std::mt19937_64 engine_;
};

/// The seed of a named stream, so that each family keeps its rays when others come or go.
inline std::uint64_t stream(std::uint64_t seed, const char* name) {
  std::uint64_t hash = 14695981039346656037u ^ seed;  // FNV-1a
  for (; *name != 0; ++name) hash = (hash ^ static_cast<unsigned char>(*name)) * 1099511628211u;
  return hash;
}

}  // namespace isect::bench
