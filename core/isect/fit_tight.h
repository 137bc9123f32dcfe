#pragma once
// Tighter bounding volumes than those of isect/fit.h, at more cost, and Ritter's ball for contrast.
//
// As there, a search in rounded numbers picks the center or the axes, and exact tests then find the least sizes that
// hold every point: the fits differ in how tight they are, never in what they hold. Source: the note, N04, N07.

#include <cmath>
#include <variant>
#include <vector>

#include <isect/fit.h>
#include <isect/parts/fit_tight_guess.h>
#include <isect/parts/smallest_sphere.h>

namespace isect {

namespace fit_tight {

/// The points, by their indices, whose smallest ball is that of all.
struct Supported {
  std::vector<int> points;
};
using Event = std::variant<Supported, fit::Extreme, Fallback>;

namespace detail {

/// Whether a is smaller than b, up to rounding; half-lengths are scaled, so that no volume overflows.
template <class S, int N>
bool smaller(const Obb<S, N>& a, const Obb<S, N>& b) {
  const double scale = static_cast<double>(b.half.maxCoeff());
  if (!std::isfinite(scale) || !(scale > 0)) return finite(a.half) && !finite(b.half);
  const auto volume = [&](const Obb<S, N>& x) {
    const Eigen::Matrix<double, N, N> axes = x.axes.template cast<double>();
    return (x.half.template cast<double>() / scale).prod() * std::abs(axes.determinant());
  };
  return fit::detail::clearly_less(volume(a), volume(b));
}

}  // namespace detail

}  // namespace fit_tight

/// The smallest ball that holds all points, with its center rounded to S; the radius is the least of S for that center.
/// Radius -1 for no points, or with a NaN or an infinity among them.
///
/// Bound. Let the smallest ball have the center c and the radius R. Each coordinate of the center found is the number
/// of S nearest to c's, within 0.501 ulp; so it lies within d <= 0.87 ulp of c's largest coordinate from c, and the
/// radius is at most R + d, rounded up. Any ball around x != c is larger too: c lies in the simplex of points at the
/// distance R, so one of them has (p - c).(x - c) <= 0, hence |p - x|^2 >= R^2 + |x - c|^2. As no x of S is nearer to
/// c, none has a smaller radius than sqrt(R^2 + d^2): the ball found exceeds the best one of S by d and an ulp at most,
/// and by a factor of 1.42, sqrt 2 and rounding, however small it is and however far away. Where no coordinate of c
/// exceeds R, the radius is within 2 ulp of R.
template <class S, int N, class Trace = NoTrace>
Sphere<S, N> fit_sphere_smallest(const std::vector<Point<S, N>>& points, Trace&& trace = {}) {
  if (!fit::detail::usable(points)) return {Point<S, N>::Zero(), S(-1)};
  const fit::detail::Scaled<N> scaled = fit::detail::scaled(points, fit_aabb(points));
  decltype(auto) wide = fit_tight::detail::in_doubles(points);
  const std::vector<int> support = fit_tight::detail::support(wide, scaled);
  trace(fit_tight::Supported{support});
  const Point<S, N> center = fit_tight::detail::center<S>(fit_tight::detail::through(wide, support));
  return fit::detail::least_ball(points, center, trace);
}

/// Ritter's ball, in two passes: some percent larger than the smallest, and as safe. Empty as above.
template <class S, int N, class Trace = NoTrace>
Sphere<S, N> fit_sphere_ritter(const std::vector<Point<S, N>>& points, Trace&& trace = {}) {
  if (!fit::detail::usable(points)) return {Point<S, N>::Zero(), S(-1)};
  const fit::detail::Scaled<N> scaled = fit::detail::scaled(points, fit_aabb(points));
  return fit::detail::least_ball(points, scaled.template original<S>(fit::detail::ritter_center<N>(scaled.q)), trace);
}

namespace fit_tight::detail {

/// fit_obb's box, or the one along axes(points, scaled to about 1) if it is smaller.
template <class S, int N, class Axes, class Trace>
Obb<S, N> box_along(const std::vector<Point<S, N>>& points, const Axes& axes, Trace& trace) {
  const Obb<S, N> principal = fit_obb(points, trace);
  if (empty(principal)) return principal;
  const fit::detail::Scaled<N> scaled = fit::detail::scaled(points, fit_aabb(points));
  const Obb<S, N> tight = fit::detail::least_box(points, scaled, axes(scaled.q), trace);
  return smaller(tight, principal) ? tight : principal;
}

}  // namespace fit_tight::detail

/// An oriented box that holds all points and is no larger than fit_obb's; in 2D the smallest up to rounding, in 3D the
/// smallest of many local minima. Half-lengths -1 for no points, or with a NaN or an infinity among them.
template <class S, int N, class Trace = NoTrace>
Obb<S, N> fit_obb_tight(const std::vector<Point<S, N>>& points, Trace&& trace = {}) {
  return fit_tight::detail::box_along(
      points, [](const std::vector<Point<double, N>>& q) { return fit::detail::tight_axes(q); }, trace);
}

/// Fits that box to the vertices of a hull that is known already.
template <class S, class Trace = NoTrace>
Obb<S, 3> fit_obb_tight(const Hull3<S>& hull, Trace&& trace = {}) {
  return fit_tight::detail::box_along(
      hull.vertices,
      [&](const std::vector<Point<double, 3>>& q) {
        return fit::detail::tight_axes(Hull3<double>{q, hull.triangles, hull.dimension});
      },
      trace);
}

}  // namespace isect
