#pragma once
// The parts of isect/many/ray_mesh.h: four boxes in float against a line, and two triangles in double. Both only rule
// out.
//
// Bound, with u = 2^-24. For a box that the ray meets at t, lo <= t <= end, each slab's entry is n <= t, each exit
// x >= t, where n and x are formed with the origin rounded away from the box, which only widens [n, x]. Three more
// roundings (the reciprocal, the difference, the product) make n (1 + e) and x (1 + e) of them, |e| < 4 u, and add
// 2^-150 at most. So in <= t + 4 u |t| and t - 4 u |t| <= out, hence in <= out', in <= end', where
// x' = x + 16 u |x| + 2^-147. Coordinates stay below 2^100 or are infinite on the safe side, so no difference
// overflows; a product overflows where t is beyond all floats, and there `out` is too. What becomes NaN counts as a
// hit.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <isect/numbers/arithmetic.h>
#include <isect/parts/instruction_set.h>
#include <isect/shapes.h>

namespace isect::ray_mesh {

namespace detail {

inline constexpr int width = 4;
using Four = simd::Of<float, 16>::Vector;

/// A float below x, by two roundings at most, and one above.
inline float down(double x) {
  const float near = static_cast<float>(x);
  return near - (std::numeric_limits<float>::epsilon() * std::abs(near) + std::numeric_limits<float>::denorm_min());
}
inline float up(double x) { return -down(-x); }

/// A node's children: `count` triangles from `first` on, or with count 0 the node `first`.
struct alignas(64) Node {
  Four ends[2][3] = {};  ///< the boxes' lo and hi, axis by axis
  std::array<int, width> first = {};
  std::array<std::uint8_t, width> count = {};
  std::uint8_t children = 0;
};

/// Coordinates beyond this are infinite on the outer side, and cut to it on the inner one.
inline constexpr double farthest = 0x1p100;

template <class S>
void put(Node& node, int child, const Aabb<S, 3>& box) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (int i = 0; i < 3; ++i) {
    const double lo = box.lo[i], hi = box.hi[i];
    node.ends[0][i][child] = lo < -farthest ? -infinity : down(std::min(lo, farthest));
    node.ends[1][i][child] = hi > farthest ? infinity : up(std::max(hi, -farthest));
  }
}

/// A ray as the boxes see it: for each axis the index of the end that it meets first, the origin rounded away from that
/// end and from the other one, and the reciprocal of the direction; NaN where that is useless, so that its slab is
/// left out.
struct Line {
  int first[3];
  Four origin[2][3], inverse[3];
  float start;

  template <class S>
  explicit Line(const Ray<S, 3>& ray) : start(down(ray.range.lo)) {
    for (int i = 0; i < 3; ++i) {
      const double o = ray.origin[i], d = ray.direction[i];
      const float quotient = static_cast<float>(1 / d);
      const bool usable = std::abs(o) <= farthest && (d == 0 || std::isnormal(quotient));
      first[i] = d < 0;
      origin[0][i] = Four{} + (d < 0 ? down(o) : up(o)), origin[1][i] = Four{} + (d < 0 ? up(o) : down(o));
      inverse[i] =
          Four{} + (usable ? std::abs(quotient) * (d < 0 ? -1.f : 1.f) : std::numeric_limits<float>::quiet_NaN());
    }
  }
};

/// Raises x by more than all rounding: no box that is met at x or before is entered later.
template <class V>
void delay(V& x) {
  using Limits = std::numeric_limits<float>;
  V size = x;
  simd::raise(size, -x);
  x += 8 * Limits::epsilon() * size + 4 * Limits::denorm_min();
}

/// The children of a node whose boxes the line may meet up to t = `end`, a bit each; `in` is where, nearly, and not
/// beyond a delayed `end`.
inline std::uint64_t met(const Node& node, const Line& line, float end, Four& in) {
  Four out = Four{} + end;
  in = Four{} + line.start;
  for (int i = 0; i < 3; ++i) {
    const int first = line.first[i];
    simd::raise(in, (node.ends[first][i] - line.origin[0][i]) * line.inverse[i]);
    simd::lower(out, (node.ends[!first][i] - line.origin[1][i]) * line.inverse[i]);
  }
  delay(out);
  return ~simd::greater(in, out) & ((1u << node.children) - 1);
}

/// Tells of two triangles at once how a ray's line passes them, where doubles are sure of it.
///
/// Bound. Each of the volumes of isect/ray_triangle.h sums six products d_i p_j q_k, the p and q differences of
/// vertices and origin, below M, in seven roundings: it errs by less than 2 g(7) D M^2, where D sums the |d_i|, and
/// 2^-1000 (1 + D) covers what underflows. Nothing overflows while 4 D M^2 is finite. M serves all triangles of the
/// mesh.
class Screen {
 public:
  using Two = simd::Of<double, 16>::Vector;
  /// Whether the line passes a triangle by, and if not which sign its volumes have; both 0 where that is not sure.
  struct Verdict {
    bool missed;
    int sign;
  };

  /// No vertex has a coordinate beyond `reach`.
  Screen(const Ray<double, 3>& ray, double reach) {
    double size = 0, length = 0;
    for (int i = 0; i < 3; ++i) {
      origin_[i] = Two{} + ray.origin[i], direction_[i] = Two{} + ray.direction[i];
      size = std::max(size, std::abs(ray.origin[i]) + reach), length += std::abs(ray.direction[i]);
    }
    slack_ = Two{} + (8 * unit<double> * (4 * length * (size * size)) + 0x1p-1000 * (1 + length));
  }

  template <class S>
  std::array<Verdict, 2> operator()(const Triangle<S, 3>& p, const Triangle<S, 3>& q) const {
    Two v[3][3];
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i) v[k][i] = Two{p.vertices[k][i], q.vertices[k][i]} - origin_[i];
    Two most = volume(v[1], v[2]), least = most;
    for (int k = 0; k < 2; ++k) {
      const Two w = volume(v[2 * k], v[1 - k]);
      simd::raise(most, w), simd::lower(least, w);
    }
    const std::uint64_t above = simd::greater(least, slack_), below = simd::greater(-slack_, most),
                        both = simd::greater(most, slack_) & simd::greater(-slack_, least);
    const auto verdict = [&](int lane) -> Verdict {
      return {(both >> lane & 1) != 0, static_cast<int>(above >> lane & 1) - static_cast<int>(below >> lane & 1)};
    };
    return {verdict(0), verdict(1)};
  }

 private:
  /// d.(p x q)
  Two volume(const Two (&p)[3], const Two (&q)[3]) const {
    return direction_[0] * (p[1] * q[2] - p[2] * q[1]) + direction_[1] * (p[2] * q[0] - p[0] * q[2]) +
           direction_[2] * (p[0] * q[1] - p[1] * q[0]);
  }

  Two origin_[3], direction_[3], slack_;
};

}  // namespace detail

}  // namespace isect::ray_mesh
