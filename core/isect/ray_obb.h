#pragma once
// Ray against oriented box.
//
// The box is { c + sum s_i u_i, |s_i| <= e_i }. With n_i orthogonal to all axes but u_i, and n_i.u_i = +-D for every
// i (see isect/point_obb.h), the point o + t d lies between the faces of pair i iff
//
//   -e_i |D| - n_i.(o - c)  <=  t n_i.d  <=  e_i |D| - n_i.(o - c):
//
// a slab with polynomials for coefficients, whatever the axes are. Source: the note, N07, for the box; Kay, Kajiya,
// Ray tracing complex scenes, SIGGRAPH (1986), for the slabs.

#include <limits>
#include <optional>
#include <variant>

#include <isect/parts/memo.h>
#include <isect/parts/slabs.h>
#include <isect/parts/unit_of_length.h>
#include <isect/point_obb.h>

namespace isect {

namespace ray_obb {

using Event = std::variant<slabs::Outside, slabs::Stretch, Fallback>;

namespace detail {

/// The slabs of an oriented box, as lo <= n_i.d t <= hi, each n_i the way of u_i. `sign` is that of D = n_0.u_0. The
/// parts that depend on the axes alone are found once in each arithmetic that most signs are settled in.
template <int N>
class Slabs {
 public:
  Slabs(const Ray<double, N>& ray, const Obb<double, N>& box, int sign) : ray_(ray), box_(box), sign_(sign) {}

  template <PolynomialScalar W>
  W rate(int i) const {
    return turned(i, dot(normal<W>(i), exactly<W>(ray_.direction)));
  }
  template <PolynomialScalar W>
  W lo(int i) const {
    return -reach<W>(i) - along<W>(i);
  }
  template <PolynomialScalar W>
  W hi(int i) const {
    return reach<W>(i) - along<W>(i);
  }

 private:
  /// The normals, and |D|.
  template <class W>
  struct OfAxes {
    std::array<Components<W, N>, N> normals;
    W size;
  };
  template <PolynomialScalar W>
  const OfAxes<W>& of_axes() const {
    return of_axes_.template in<W>([&]() -> OfAxes<W> {
      OfAxes<W> found;
      for (int i = 0; i < N; ++i) found.normals[i] = point_obb::detail::normal<W>(box_.axes, i);
      found.size = abs(dot(found.normals[0], exactly<W, N>(box_.axes.col(0))));
      return found;
    });
  }
  template <class W>
  static constexpr bool kept = std::is_same_v<W, Bounded<double>> || std::is_same_v<W, Grid> || is_compensated<W>;
  template <PolynomialScalar W>
  std::conditional_t<kept<W>, const Components<W, N>&, Components<W, N>> normal(int i) const {
    if constexpr (!kept<W>)
      return point_obb::detail::normal<W>(box_.axes, i);
    else
      return of_axes<W>().normals[i];
  }
  template <PolynomialScalar W>
  std::conditional_t<kept<W>, const W&, W> size() const {
    if constexpr (!kept<W>)
      return abs(point_obb::detail::volume<W>(box_.axes, 0));
    else
      return of_axes<W>().size;
  }
  template <PolynomialScalar W>
  W reach(int i) const {
    return W(box_.half[i]) * size<W>();
  }
  template <PolynomialScalar W>
  W along(int i) const {
    return turned(i, dot(normal<W>(i), difference<W>(ray_.origin, box_.center)));
  }
  /// n.x for the n_i that has the way of u_i: in the plane n_1.u_1 is -D.
  template <PolynomialScalar W>
  W turned(int i, const W& along_normal) const {
    return (sign_ < 0) != (N == 2 && i == 1) ? -along_normal : along_normal;
  }

  const Ray<double, N>& ray_;
  const Obb<double, N>& box_;
  int sign_;
  Memo<OfAxes> of_axes_;
};

/// The slabs by the faces at -half_i and half_i, whichever comes first along n_i: so lo may be the larger. For a first
/// try, which asks for two of them.
template <int N>
struct Faces {
  const Ray<double, N>& ray;
  const Obb<double, N>& box;

  template <PolynomialScalar W>
  W rate(int i) const {
    return dot(point_obb::detail::normal<W>(box.axes, i), exactly<W>(ray.direction));
  }
  template <PolynomialScalar W>
  W lo(int i) const {
    return -W(box.half[i]) * point_obb::detail::volume<W>(box.axes, i) - along<W>(i);
  }
  template <PolynomialScalar W>
  W hi(int i) const {
    return W(box.half[i]) * point_obb::detail::volume<W>(box.axes, i) - along<W>(i);
  }
  template <PolynomialScalar W>
  W along(int i) const {
    return dot(point_obb::detail::normal<W>(box.axes, i), difference<W>(ray.origin, box.center));
  }
};

/// The slabs in plain doubles, divided by D, for axes that are nearly orthonormal: then u_i is nearly n_i / D.
///
/// Bound. n_i / D is row i of U^-1. Let d be the spectral norm of U^T U - 1, at most 2^-10, so that the singular values
/// p of U have |p^2 - 1| <= d. Then U^-1 and U^T, whose singular values are 1 / p and p for the same vectors, differ by
/// at most |1 / p - p| <= 1.001 d. The computed d lacks 20 u, and the rest adds 6 u (|o - c| + half_i) or 5 u |d|.
template <int N>
class QuickSlabs {
 public:
  QuickSlabs(const Ray<double, N>& ray, const Obb<double, N>& box)
      : ray_(ray), box_(box), from_(ray.origin - box.center) {
    const double skew = point_obb::detail::skew(box.axes);
    const double size = skew <= 0x1p-10 ? 1.01 / unit<double> * skew + 32 : std::numeric_limits<double>::infinity();
    size_ = size * (from_.cwiseAbs().sum() + box.half.sum()) + 0x1p-1000;
    rate_size_ = size * ray.direction.cwiseAbs().sum() + 0x1p-1000;
  }

  // clang-format off
  template <class W> W rate(int i) const { return {along(i, ray_.direction), rate_size_, 0}; }
  template <class W> W lo(int i) const { return {-box_.half[i] - along(i, from_), size_, 0}; }
  template <class W> W hi(int i) const { return {box_.half[i] - along(i, from_), size_, 0}; }
  // clang-format on

 private:
  double along(int i, const Vector<double, N>& x) const { return point_obb::detail::dot_columns(box_.axes, i, x, 0); }

  const Ray<double, N>& ray_;
  const Obb<double, N>& box_;
  Vector<double, N> from_;
  double size_, rate_size_;
};

template <class S, int N, class Trace>
std::optional<Interval<S>> meet(const Ray<S, N>& ray, const Obb<S, N>& box, Trace& trace) {
  if (empty(box)) return {};
  const Ray<double, N>& wide = in_doubles(ray);
  const Obb<double, N>& bounds = in_doubles(box);

  if constexpr (doubles_only<Trace>) {
    const slabs::detail::Estimate<N> seen = slabs::detail::estimate<S, N>(ray.range, QuickSlabs<N>(wide, bounds));
    trace.open |= seen.meets == 0;
    if (seen.meets <= 0) return {};
    return slabs::detail::stretch<S, N>(ray.range, seen, Faces<N>{wide, bounds}, trace);
  } else {
    if (!finite(ray) || !finite(box)) return {};
    const int sign = sign_of([&]<class W>() -> W { return point_obb::detail::volume<W>(bounds.axes, 0); }, trace);
    if (sign == 0) return {};
    return in_own_unit(wide, bounds, [&](const Ray<double, N>& x, const Obb<double, N>& y) {
      const Slabs<N> of_box(x, y, sign);
      if constexpr (!heard<Trace>) {
        const slabs::detail::Estimate<N> seen = slabs::detail::estimate<S, N>(ray.range, QuickSlabs<N>(x, y));
        return slabs::detail::clip<S, N>(ray.range, of_box, trace, &seen);
      } else {
        return slabs::detail::clip<S, N>(ray.range, of_box, trace);
      }
    });
  }
}

}  // namespace detail

}  // namespace ray_obb

/// The part of the ray's range inside the closed box, in units of |direction|.
///
/// Whether there is one is true for all finite input of any magnitude; a ray that grazes a face, an edge or a corner
/// meets the box. The ends lie within 2 ulp of S of the true ones, in the range, in order. The axes are taken
/// literally, need neither unit length nor right angles, but must be independent: otherwise there is no box. A zero
/// direction makes the ray a point: the whole range if it lies in the box. Some half_i = 0 makes the box flat. An
/// empty box or range, NaN or an infinite coordinate: nothing.
template <class S, int N, class Trace = NoTrace>
std::optional<Interval<S>> intersect(const Ray<S, N>& ray, const Obb<S, N>& box, Trace&& trace = {}) {
  return in_doubles_first<S>([&](auto& pass) { return ray_obb::detail::meet(ray, box, pass); }, trace);
}

/// Whether ray and box have a common point; see intersect.
template <class S, int N, class Trace = NoTrace>
bool intersects(const Ray<S, N>& ray, const Obb<S, N>& box, Trace&& trace = {}) {
  if constexpr (!heard<Trace>) {
    const slabs::detail::Estimate<N> seen =
        slabs::detail::estimate<S, N>(ray.range, ray_obb::detail::QuickSlabs<N>(in_doubles(ray), in_doubles(box)));
    if (seen.meets != 0) [[likely]]
      return seen.meets > 0 && !empty(box);
  }
  return intersect(ray, box, trace).has_value();
}

/// The least t of the range at which the ray is in the box.
template <class S, int N>
std::optional<S> first_hit(const Ray<S, N>& ray, const Obb<S, N>& box) {
  const std::optional<Interval<S>> part = intersect(ray, box);
  return part ? std::optional<S>(part->lo) : std::nullopt;
}

}  // namespace isect
