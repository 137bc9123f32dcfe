#pragma once
// Area and normal of a polygon.
//
// With p = vertex 0, half the sum of (v_i - p) x (v_i+1 - p) over all edges is the polygon's area vector: its length
// is the area, its direction the normal, counter-clockwise seen from its tip. It needs no three vertices that span a
// plane, and a polygon not quite plane gets the plane that its edges follow on average. Newell's own sum has
// coordinates in place of differences and cancels far from the origin.
//
// Source: M. E. Newell, in I. Sutherland, R. Sproull, R. Schumacker, A characterization of ten hidden-surface
// algorithms, ACM Comput. Surv. 6 (1974); F. Tampieri, Newell's method for computing the plane equation of a polygon,
// Graphics Gems III (1992).

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

#include <isect/numbers/predicate.h>
#include <isect/numbers/quotient.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace polygon_area {

/// The area vector: the size of its largest component, and the vector divided by that.
struct AreaVector {
  std::array<double, 3> scaled;
  double largest;
};
using Event = std::variant<AreaVector, Fallback>;

namespace detail {

/// An area vector to more digits: its components divided by `unit`, the largest of which is 1 to 2 in size.
struct FineAreaVector {
  std::array<Compensated, 3> scaled;
  double unit;

  Compensated length() const { return sqrt(dot(scaled, scaled)); }  // 1 to 2 sqrt(3)
  AreaVector rounded() const {
    double largest = 0;
    for (const Compensated& x : scaled) largest = std::max(largest, std::abs(leading(x)));
    return {{leading(scaled[0]) / largest, leading(scaled[1]) / largest, leading(scaled[2]) / largest}, largest * unit};
  }
};

/// Twice the area vector; 0 for fewer than three vertices.
template <PolynomialScalar W, class S>
std::array<W, 3> newell(const Ring<S, 3>& ring) {
  std::array<W, 3> sum = {W(0.), W(0.), W(0.)};
  if (ring.empty()) return sum;
  const auto from_first = [&](const Point<S, 3>& v) {
    return difference<W>(Point<double, 3>(v.template cast<double>()),
                         Point<double, 3>(ring[0].template cast<double>()));
  };
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const std::array<W, 3> term = cross(from_first(ring[i]), from_first(ring[i + 1]));
    for (std::size_t k = 0; k < 3; ++k) sum[k] = sum[k] + term[k];
  }
  return sum;
}

/// Twice the signed area in the plane.
template <PolynomialScalar W, class S>
W area2(const Ring<S, 2>& ring) {
  W sum(0.);
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Point<double, 2> p = ring[0].template cast<double>(), a = ring[i].template cast<double>(),
                           b = ring[i + 1].template cast<double>();
    sum = sum + (difference<W>(a[0], p[0]) * difference<W>(b[1], p[1]) -
                 difference<W>(a[1], p[1]) * difference<W>(b[0], p[0]));
  }
  return sum;
}

/// The exact area vector, every number rounded once; nothing when it is zero.
template <class S>
[[gnu::noinline, gnu::cold]] std::optional<FineAreaVector> exact_area_vector(const Ring<S, 3>& ring) {
  const std::array<Exact, 3> n = newell<Exact>(ring);
  const auto smaller = [](const Exact& x, const Exact& y) { return (abs(x) - abs(y)).sign() < 0; };
  const Exact largest = abs(*std::max_element(n.begin(), n.end(), smaller));
  if (largest.sign() == 0) return {};
  return FineAreaVector{{quotient(n[0], largest), quotient(n[1], largest), quotient(n[2], largest)},
                        quotient(largest, Exact(2.))};
}

/// The area vector in W, double or Compensated or Fused, by the sizes and roundings that doubles found, divided by a
/// power of two; by 0 if it is 0. Nothing where a component may be further than eps / 8 of the largest from the truth,
/// or where that is out of range.
template <class W, class S>
std::optional<FineAreaVector> quick_area_vector(const Ring<S, 3>& ring) {
  const std::array<Bounded<double>, 3> quick = newell<Bounded<double>>(ring);
  std::array<W, 3> n;
  if constexpr (std::is_same_v<W, double>)
    n = {quick[0].value(), quick[1].value(), quick[2].value()};
  else
    n = newell<W>(ring);
  double largest = 0, error = 0;
  for (int i = 0; i < 3; ++i) {
    const double size = std::abs(leading(n[i])), off = Bounded<W>(n[i], quick[i].size(), quick[i].roundings()).error();
    if (!std::isfinite(size) || !std::isfinite(off)) return {};  // std::max passes NaN over
    largest = std::max(largest, size), error = std::max(error, off);
  }
  if (error > std::numeric_limits<S>::epsilon() / 8 * largest) return {};
  if (largest == 0) return FineAreaVector{{}, 0};
  if (!(0x1p-800 < largest && largest < 0x1p900)) return {};
  const double unit = std::ldexp(1, std::ilogb(largest));
  FineAreaVector result = {{}, unit / 2};
  for (int i = 0; i < 3; ++i) {
    if constexpr (std::is_same_v<W, double>) {
      result.scaled[i] = n[i] / unit;
    } else {
      const DoubleDouble x = two_sum(n[i].hi, n[i].lo);  // after cancellation the rest may be large
      result.scaled[i] = {x.hi / unit, x.lo / unit};
    }
  }
  return result;
}

/// The area vector; nothing when it is exactly zero.
///
/// Bound, eps that of S, u = eps / 2. Every component is taken within eps / 8 of the largest, or Exact takes over and
/// rounds each once. An error d of the vector n turns its direction by |d| / |n| at most, and changes its length by
/// as much: sqrt(3) eps / 8 there, as no component is longer than n; u here, as every |d_i| <= u |n_i|. Both are at
/// most u. What follows is rounded in Compensated, and once to S.
template <class S, class Trace>
std::optional<FineAreaVector> area_vector(const Ring<S, 3>& ring, Trace&& trace) {
  std::optional<FineAreaVector> n;
  if constexpr (std::is_same_v<S, float>)
    n = quick_area_vector<double>(ring);
  else
    n = compensated([&]<class W>() { return quick_area_vector<W>(ring); });
  if (n) return n->unit == 0 ? std::nullopt : n;
  trace(Fallback{});
  return exact_area_vector(ring);
}

}  // namespace detail

}  // namespace polygon_area

/// The area of a ring in the plane, positive when it goes counter-clockwise; each part counts as often as the ring
/// goes around it. Within 2 ulp, so its sign is the true one, unless below the least number of S. Infinite beyond the
/// largest. NaN when a coordinate is NaN or infinite.
template <class S, class Trace = NoTrace>
S area(const Ring<S, 2>& ring, Trace&& trace = {}) {
  static_assert(is_scalar<S>());
  if (!finite(ring)) return std::numeric_limits<S>::quiet_NaN();
  return value_of<S>([&]<class W>() -> Ratio<W> { return {polygon_area::detail::area2<W>(ring), W(2.)}; }, trace);
}

/// The area of a ring in space: that of its projection to the plane in which it is largest, never negative. Within 3
/// ulp. Infinite beyond the largest number. NaN when a coordinate is NaN or infinite.
template <class S, class Trace = NoTrace>
S area(const Ring<S, 3>& ring, Trace&& trace = {}) {
  static_assert(is_scalar<S>());
  if (!finite(ring)) return std::numeric_limits<S>::quiet_NaN();
  const auto n = polygon_area::detail::area_vector(ring, trace);
  return n ? static_cast<S>(n->unit * leading(n->length())) : S(0);
}

/// The unit normal of a ring in space, from whose tip it goes counter-clockwise. Every component is within eps of S
/// of the true one. Nothing when the area is exactly zero, and when a coordinate is NaN or infinite.
template <class S, class Trace = NoTrace>
std::optional<Vector<S, 3>> normal(const Ring<S, 3>& ring, Trace&& trace = {}) {
  static_assert(is_scalar<S>());
  if (!finite(ring)) return {};
  const auto n = polygon_area::detail::area_vector(ring, trace);
  if (!n) return {};
  if constexpr (heard<Trace>) trace(n->rounded());
  const Compensated length = n->length();
  const auto over_length = [&](int i) -> S { return static_cast<S>(quotient(n->scaled[i], length)); };
  return Vector<S, 3>(over_length(0), over_length(1), over_length(2));
}

}  // namespace isect
