#pragma once
// How large bounding volumes are, and how much of them is void.
//
// Volumes are polynomials of the numbers given, so they are found as all values are: rounded once, from arithmetic
// that is fine enough. That of a closed surface is the sum of the signed tetrahedra from one point to its triangles,
//
//   6 V = sum (a - o) . (b - o) x (c - o),
//
// where all that lies outside cancels. Areas of slanted triangles have square roots; each is rounded, and their sum.
// In 2D the volume is the area, and the surface the perimeter. Source: the note, N04.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <isect/convex_hull_3d.h>
#include <isect/kdop_polytope.h>
#include <isect/numbers/predicate.h>
#include <isect/numbers/quotient.h>
#include <isect/point_obb.h>
#include <isect/shapes.h>

namespace isect {

namespace detail::volume {

/// Six times the signed volume within triangles, from the first vertex on.
template <class W, class S>
W volume6(const std::vector<Point<S, 3>>& vertices, const std::vector<std::array<int, 3>>& triangles) {
  const auto from_first = [&](int i) {
    return difference<W, 3>(vertices[i].template cast<double>(), vertices[0].template cast<double>());
  };
  W sum(0.0);
  for (const auto& [a, b, c] : triangles) sum = sum + dot(from_first(a), cross(from_first(b), from_first(c)));
  return sum;
}

/// fraction 2^exponent, in a range that no product of lengths leaves.
struct Size {
  double fraction = 0;
  int exponent = 0;
};

/// Adds sizes that are not negative, at the scale of the largest: only negligible parts are lost, and only the sum can
/// overflow or underflow. If each size is within 1.9 u, the sum is within 3 ulp, of S too.
template <class S>
S sum(const std::vector<Size>& sizes) {
  int most = std::numeric_limits<int>::min();
  for (const Size& s : sizes)
    if (s.fraction > 0) most = std::max(most, s.exponent + std::ilogb(s.fraction));
  DoubleDouble sum;
  for (const Size& s : sizes)
    if (s.fraction > 0) sum = sum + DoubleDouble{std::ldexp(s.fraction, s.exponent - most), 0};
  return static_cast<S>(std::ldexp(sum.hi, most));
}

/// A power of two by which the numbers are near 1, so that few squares overflow or underflow.
template <int N>
int exponent_of(const Vector<double, N>& u, const Vector<double, N>& v) {
  const double most = std::max(u.cwiseAbs().maxCoeff(), v.cwiseAbs().maxCoeff());
  return most > 0 ? std::clamp(std::ilogb(most), -1000, 1000) : 0;
}

/// The root of a sum of squares, text<W>(k), where every length is taken k times and `degree` of them make a root.
///
/// Bound. The square is within eps / 3 and rounded once, 1.67 u, of which the root takes half, and rounds once: 1.84 u.
template <class Text>
Size root(const Text& text, int degree, int exponent) {
  const double k = std::ldexp(1.0, -exponent);
  const double square = value_of<double>([&]<class W>() -> Ratio<W> {
    return {text.template operator()<W>(k), W(1.0)};
  });
  if (0x1p-900 < square && std::isfinite(square)) return {std::sqrt(square), degree * exponent};
  const Exact size = sqrt(text.template operator()<Exact>(1.0));  // a needle, which doubles don't reach
  if (size.sign() == 0) return {};
  const int scale = ilogb(size);
  return {ldexp(size, -scale).rounded(), scale};
}

/// The area of a b c.
inline Size area(const Point<double, 3>& a, const Point<double, 3>& b, const Point<double, 3>& c) {
  const auto square = [&]<class W>(double k) -> W {
    Components<W, 3> u = difference<W, 3>(b, a), v = difference<W, 3>(c, a);
    for (int i = 0; i < 3; ++i) u[i] = u[i] * W(k), v[i] = v[i] * W(k);
    const Components<W, 3> n = cross(u, v);
    return dot(n, n);
  };
  const Vector<double, 3> ab = b / 2 - a / 2, ac = c / 2 - a / 2;  // halves: no difference overflows
  const Size twice = root(square, 2, exponent_of<3>(ab, ac));
  return {twice.fraction, twice.exponent - 1};
}

template <class S>
S area(const std::vector<Point<S, 3>>& vertices, const std::vector<std::array<int, 3>>& triangles) {
  std::vector<Size> areas;
  areas.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles)
    areas.push_back(area(vertices[a].template cast<double>(), vertices[b].template cast<double>(),
                         vertices[c].template cast<double>()));
  return sum<S>(areas);
}

/// The length of a b.
template <int N>
Size length(const Point<double, N>& a, const Point<double, N>& b) {
  const auto square = [&]<class W>(double k) -> W {
    Components<W, N> u = difference<W, N>(b, a);
    for (int i = 0; i < N; ++i) u[i] = u[i] * W(k);
    return dot(u, u);
  };
  const Vector<double, N> half = b / 2 - a / 2;
  return root(square, 1, exponent_of<N>(half, half));
}

/// Cuts the faces into triangles.
template <class S>
std::vector<std::array<int, 3>> triangles(const Polytope<S, 3>& polytope) {
  std::vector<std::array<int, 3>> all;
  for (const std::vector<int>& ring : polytope.faces)
    for (std::size_t i = 2; i < ring.size(); ++i) all.push_back({ring[0], ring[i - 1], ring[i]});
  return all;
}

}  // namespace detail::volume

/// The volume within a closed surface: triangles counter-clockwise seen from outside, two at every edge. Within 2 ulp
/// of S of the true one; negative when it is turned inside out. NaN with a NaN or an infinity.
template <class S>
S volume(const std::vector<Point<S, 3>>& vertices, const std::vector<std::array<int, 3>>& triangles) {
  if (!finite(vertices)) return std::numeric_limits<S>::quiet_NaN();
  if (triangles.empty()) return S(0);
  return value_of<S>([&]<class W>() -> Ratio<W> {
    return {detail::volume::volume6<W, S>(vertices, triangles), W(6.0)};
  });
}
/// The area of all triangles, within 3 ulp of S over the whole range; infinite beyond the largest S, or 3 ulp below.
template <class S>
S surface_area(const std::vector<Point<S, 3>>& vertices, const std::vector<std::array<int, 3>>& triangles) {
  if (!finite(vertices)) return std::numeric_limits<S>::quiet_NaN();
  return detail::volume::area(vertices, triangles);
}

// Volumes and surfaces of bounding volumes. Empty ones have 0, those with an infinite number NaN.

/// Within 2 ulp.
template <class S, int N>
S volume(const Aabb<S, N>& box) {
  if (empty(box)) return S(0);
  if (!finite(box)) return std::numeric_limits<S>::quiet_NaN();
  const Aabb<double, N> wide = cast<double>(box);
  return value_of<S>([&]<class W>() -> Ratio<W> {
    const Components<W, N> size = difference<W, N>(wide.hi, wide.lo);
    W product = size[0];
    for (int i = 1; i < N; ++i) product = product * size[i];
    return {product, W(1.0)};
  });
}
/// Within 2 ulp. Twice the sum of all sides in 2D, of the products of two sides in 3D.
template <class S, int N>
S surface_area(const Aabb<S, N>& box) {
  if (empty(box)) return S(0);
  if (!finite(box)) return std::numeric_limits<S>::quiet_NaN();
  const Aabb<double, N> wide = cast<double>(box);
  return value_of<S>([&]<class W>() -> Ratio<W> {
    const Components<W, N> size = difference<W, N>(wide.hi, wide.lo);
    if constexpr (N == 2)
      return {W(2.0) * (size[0] + size[1]), W(1.0)};
    else
      return {W(2.0) * (size[0] * size[1] + size[1] * size[2] + size[2] * size[0]), W(1.0)};
  });
}

/// Within 4 ulp.
template <class S, int N>
S volume(const Sphere<S, N>& ball) {
  if (empty(ball)) return S(0);
  if (!finite(ball)) return std::numeric_limits<S>::quiet_NaN();
  const double r = static_cast<double>(ball.radius), pi = std::numbers::pi;
  return static_cast<S>(N == 2 ? pi * r * r : 4 * pi / 3 * r * r * r);
}
/// Within 4 ulp.
template <class S, int N>
S surface_area(const Sphere<S, N>& ball) {
  if (empty(ball)) return S(0);
  if (!finite(ball)) return std::numeric_limits<S>::quiet_NaN();
  const double r = static_cast<double>(ball.radius), pi = std::numbers::pi;
  return static_cast<S>(N == 2 ? 2 * pi * r : 4 * pi * r * r);
}

/// Within 2 ulp, whatever the axes.
template <class S, int N>
S volume(const Obb<S, N>& box) {
  if (empty(box)) return S(0);
  if (!finite(box)) return std::numeric_limits<S>::quiet_NaN();
  const Obb<double, N> wide = cast<double>(box);
  return value_of<S>([&]<class W>() -> Ratio<W> {
    W product = W(N == 2 ? 4.0 : 8.0) * abs(point_obb::detail::volume<W>(wide.axes, 0));
    for (int i = 0; i < N; ++i) product = product * W(wide.half[i]);
    return {product, W(1.0)};
  });
}

/// Within 3 ulp, whatever the axes.
template <class S, int N>
S surface_area(const Obb<S, N>& box) {
  if (empty(box)) return S(0);
  if (!finite(box)) return std::numeric_limits<S>::quiet_NaN();
  const Obb<double, N> wide = cast<double>(box);
  std::vector<detail::volume::Size> faces;
  for (int i = 0; i < N; ++i) {
    const auto square = [&]<class W>(double) -> W {
      const Components<W, N> n = point_obb::detail::normal<W>(wide.axes, i);  // as long as the side across from axis i
      W product = dot(n, n);
      for (int j = 0; j < N; ++j)
        if (j != i) product = product * W(wide.half[j]) * W(wide.half[j]);
      return product;
    };
    const detail::volume::Size face = detail::volume::root(square, N - 1, 0);
    faces.push_back({face.fraction, face.exponent + N});  // 4 or 8 quarters
  }
  return detail::volume::sum<S>(faces);
}

/// The area and the perimeter of its polygon of rounded vertices, as in space below: within 2 and 3 ulp of those.
template <class S>
S volume(const Kdop<S, 2>& kdop) {
  const std::vector<Point<S, 2>> ring = polytope(kdop).vertices;
  if (ring.empty()) return S(0);
  return value_of<S>([&]<class W>() -> Ratio<W> {
    W sum(0.0);
    for (std::size_t i = 2; i < ring.size(); ++i)
      sum = sum + orient::detail::area2<W>(ring[0].template cast<double>(), ring[i - 1].template cast<double>(),
                                           ring[i].template cast<double>());
    return {sum, W(2.0)};
  });
}
template <class S>
S surface_area(const Kdop<S, 2>& kdop) {
  const std::vector<Point<S, 2>> ring = polytope(kdop).vertices;
  std::vector<detail::volume::Size> sides;
  for (std::size_t i = 0; i < ring.size(); ++i)
    sides.push_back(detail::volume::length<2>(ring[i].template cast<double>(),
                                              ring[(i + 1) % ring.size()].template cast<double>()));
  return detail::volume::sum<S>(sides);
}

/// Takes its vertices as they are; within 2 ulp.
template <class S>
S volume(const Polytope<S, 3>& solid) {
  return volume(solid.vertices, detail::volume::triangles(solid));
}
/// Within 3 ulp.
template <class S>
S surface_area(const Polytope<S, 3>& solid) {
  return surface_area(solid.vertices, detail::volume::triangles(solid));
}

/// Returns the volume of its polytope, whose vertices are within 2 ulp of the true ones; 0 where its slabs contradict
/// each other. Throws where it is unbounded.
template <class S>
S volume(const Kdop<S, 3>& kdop) {
  return volume(polytope(kdop));
}
template <class S>
S surface_area(const Kdop<S, 3>& kdop) {
  return surface_area(polytope(kdop));
}

/// Within 2 ulp; 0 for a hull in a plane.
template <class S>
S volume(const Hull3<S>& hull) {
  return volume(hull.vertices, hull.triangles);
}
/// Within 3 ulp; a hull in a plane counts on both sides.
template <class S>
S surface_area(const Hull3<S>& hull) {
  return surface_area(hull.vertices, hull.triangles);
}

/// The part of the bounding volume that the object in it does not fill: the volume of the one less that of the other,
/// each as above, so with the errors of both and a rounding. The smaller, the tighter the fit.
template <class Bounding, class S>
S void_volume(const Bounding& bounding, S object) {
  return volume(bounding) - object;
}

// How many numbers a bounding volume is kept in. Normals are not counted, as all k-DOPs of a program share them.

template <class S, int N>
constexpr std::size_t numbers_kept(const Aabb<S, N>&) {
  return 2 * N;
}
template <class S, int N>
constexpr std::size_t numbers_kept(const Sphere<S, N>&) {
  return N + 1;
}
template <class S, int N>
constexpr std::size_t numbers_kept(const Obb<S, N>&) {
  return N * (N + 2);
}
template <class S, int N>
std::size_t numbers_kept(const Kdop<S, N>& kdop) {
  return 2 * kdop.slabs.size();
}
template <class S>
std::size_t numbers_kept(const Hull3<S>& hull) {
  return 3 * hull.vertices.size();
}

}  // namespace isect
