#pragma once
// Bounding volumes of points that provably hold them all.
//
// A fit first picks its position and orientation by a heuristic, in rounded numbers: that decides how tight it is,
// never what it holds. Then each size, a radius, half-length or end of a slab, is the least number of S that
// holds every point: the point farthest out is found by exact comparisons, and the number is moved by single steps
// until an exact predicate says that it holds this point and its predecessor does not. So a fit is never wrong by
// rounding, and never larger than its center and axes make it. Source: the note, N04, N06-N08.
//
// The fit of no points, or with a NaN or an infinity among them, is empty. A size beyond the largest S is infinite.

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include <isect/numbers/predicate.h>
#include <isect/numbers/quotient.h>
#include <isect/parts/fit_guess.h>
#include <isect/point_obb.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace fit {

/// The point, by its index, that decides a size: of axis or normal `slab`, on the side of hi or of lo.
struct Extreme {
  int slab, side, point;
};
using Event = std::variant<Extreme, Fallback>;

namespace detail {

template <class S, int N>
bool usable(const std::vector<Point<S, N>>& points) {
  return !points.empty() && finite(points);
}

/// The index of the point farthest out, where farther(p, q) says exactly whether p lies farther out than q.
template <class S, int N, class Farther>
std::size_t extreme(const std::vector<Point<S, N>>& points, const Farther& farther) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i] == points[best]) continue;  // which only exact arithmetic would tell
    if (farther(points[i].template cast<double>(), points[best].template cast<double>())) best = i;
  }
  return best;
}

/// Returns the least x of S with holds(x), a predicate that is true from some x near `guess` on; infinite without one.
template <class S, class Holds>
S least(S guess, const Holds& holds) {
  constexpr S most = std::numeric_limits<S>::max(), infinity = std::numeric_limits<S>::infinity();
  S x = std::clamp(guess, -most, most);
  while (!holds(x)) {
    if (x == most) return infinity;
    x = std::nextafter(x, infinity);
  }
  while (x > -most) {
    const S less = std::nextafter(x, -infinity);
    if (!holds(less)) break;
    x = less;
  }
  return x;
}

/// The ball around this center with the least radius of S that holds all points.
template <class S, int N, class Trace>
Sphere<S, N> least_ball(const std::vector<Point<S, N>>& points, const Point<S, N>& center, Trace&& trace) {
  const Point<double, N> c = center.template cast<double>();
  const auto farther = [&](const Point<double, N>& p, const Point<double, N>& q) {
    return sign_of(
               [&]<class W>() -> W {
                 const Components<W, N> f = difference<W, N>(p, c), g = difference<W, N>(q, c);
                 return dot(f, f) - dot(g, g);
               },
               trace) > 0;
  };
  const auto rounded2 = [&](const Point<S, N>& p) { return (p.template cast<double>() - c).squaredNorm(); };
  double most2 = 0;
  for (const Point<S, N>& p : points) most2 = std::max(most2, rounded2(p));
  // 5 roundings in each: a number less by 16 of them is not the farthest, unless they over- or underflowed.
  constexpr double unit = std::numeric_limits<double>::epsilon() / 2;
  const double enough2 = most2 > 0x1p-900 && std::isfinite(most2) ? most2 * (1 - 16 * unit) : 0;
  std::size_t farthest = points.size();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(rounded2(points[i]) >= enough2)) continue;
    const bool first = farthest == points.size();
    if (!first && points[i] == points[farthest]) continue;
    if (first || farther(points[i].template cast<double>(), points[farthest].template cast<double>())) farthest = i;
  }
  trace(Extreme{0, 1, static_cast<int>(farthest)});

  const Point<double, N> p = points[farthest].template cast<double>();
  const auto holds = [&](S radius) {
    const auto beyond = [&]<class W>() -> W {
      const Components<W, N> f = difference<W, N>(p, c);
      return dot(f, f) - W(radius) * W(radius);
    };
    return radius >= 0 && sign_of(beyond, trace) <= 0;
  };
  return {center, least<S>(static_cast<S>((p - c).stableNorm()), holds)};
}

/// The box along these axes, rounded, with the least half-lengths of S that hold all points.
template <class S, int N, class Trace>
Obb<S, N> least_box(const std::vector<Point<S, N>>& points, const Scaled<N>& scaled,
                    const Eigen::Matrix<double, N, N>& axes, Trace&& trace) {
  const Aabb<double, N> extent = along<N>(axes, scaled.q);
  Obb<S, N> box;
  box.axes = axes.template cast<S>();
  box.center = scaled.template original<S>(axes * ((extent.lo + extent.hi) / 2));

  const Obb<double, N> wide = {box.center.template cast<double>(), box.axes.template cast<double>(), {}};
  for (int i = 0; i < N; ++i) {
    const auto along = [&]<class W>(const Point<double, N>& p) -> W {
      return abs(dot(point_obb::detail::normal<W>(wide.axes, i), difference<W, N>(p, wide.center)));
    };
    const auto farther = [&](const Point<double, N>& p, const Point<double, N>& q) {
      const auto more = [&]<class W>() -> W {
        return along.template operator()<W>(p) - along.template operator()<W>(q);
      };
      return sign_of(more, trace) > 0;
    };
    const std::size_t farthest = extreme(points, farther);
    trace(Extreme{i, 1, static_cast<int>(farthest)});

    const Point<double, N> p = points[farthest].template cast<double>();
    const auto volume = [&]<class W>() -> W { return abs(point_obb::detail::volume<W>(wide.axes, i)); };
    const auto half = [&]<class W>() -> Ratio<W> {
      return {along.template operator()<W>(p), volume.template operator()<W>()};
    };
    const auto holds = [&](S h) {
      const auto beyond = [&]<class W>() -> W {
        return along.template operator()<W>(p) - W(h) * volume.template operator()<W>();
      };
      return sign_of(beyond, trace) <= 0;
    };
    box.half[i] = least<S>(value_of<S>(half, trace), holds);
  }
  return box;
}

}  // namespace detail

}  // namespace fit

/// The smallest axis-aligned box. Exact: nothing is rounded.
template <class S, int N>
Aabb<S, N> fit_aabb(const std::vector<Point<S, N>>& points) {
  constexpr S infinity = std::numeric_limits<S>::infinity();
  Aabb<S, N> box = {Point<S, N>::Constant(infinity), Point<S, N>::Constant(-infinity)};
  if (!fit::detail::usable(points)) return box;
  for (const Point<S, N>& p : points) box = {box.lo.cwiseMin(p), box.hi.cwiseMax(p)};
  return box;
}

/// A ball that holds all points, with the least radius of S for its center. The center is near that of the smallest
/// ball; radius -1 for no points.
template <class S, int N, class Trace = NoTrace>
Sphere<S, N> fit_sphere(const std::vector<Point<S, N>>& points, Trace&& trace = {}) {
  if (!fit::detail::usable(points)) return {Point<S, N>::Zero(), S(-1)};
  const fit::detail::Scaled<N> scaled = fit::detail::scaled(points, fit_aabb(points));
  return fit::detail::least_ball(points, scaled.template original<S>(fit::detail::ball_center<N>(scaled.q)), trace);
}

/// An oriented box that holds all points, with the least half-lengths of S for its center and axes; they are -1 for no
/// points. The axes are the principal ones, as rounded, or those of the frame where their box is no larger. Points that
/// lie nearly in a plane have a box nearly as thin. Source: Gottschalk, Lin, Manocha, OBBTree, SIGGRAPH 1996.
template <class S, int N, class Trace = NoTrace>
Obb<S, N> fit_obb(const std::vector<Point<S, N>>& points, Trace&& trace = {}) {
  if (!fit::detail::usable(points))
    return {Point<S, N>::Zero(), Eigen::Matrix<S, N, N>::Identity(), Vector<S, N>::Constant(-1)};
  const fit::detail::Scaled<N> scaled = fit::detail::scaled(points, fit_aabb(points));
  const Eigen::Matrix<double, N, N> frame = Eigen::Matrix<double, N, N>::Identity();
  const Eigen::Matrix<double, N, N> principal = fit::detail::principal_axes<N>(scaled.q);
  const Aabb<double, N> straight = fit::detail::along<N>(frame, scaled.q),
                        turned = fit::detail::along<N>(principal, scaled.q);
  const bool turn = (turned.hi - turned.lo).prod() < (straight.hi - straight.lo).prod();
  return fit::detail::least_box(points, scaled, turn ? principal : frame, trace);
}

/// The k-DOP of these normals that holds all points, each end the tightest of S: lo is the largest number that no n.x
/// lies below, hi the least that none lies above. Inverted slabs for no points; all of space without normals.
template <class S, int N, class Trace = NoTrace>
Kdop<S, N> fit_kdop(const std::vector<Point<S, N>>& points, const std::vector<Vector<S, N>>& normals,
                    Trace&& trace = {}) {
  constexpr S infinity = std::numeric_limits<S>::infinity();
  Kdop<S, N> kdop = {normals, std::vector<Interval<S>>(normals.size(), {infinity, -infinity})};
  if (!fit::detail::usable(points) || !finite(normals)) return kdop;

  for (std::size_t i = 0; i < normals.size(); ++i) {
    const auto end = [&](int side) {  // the least x that no side n.x lies above
      const Vector<double, N> n = side * normals[i].template cast<double>();
      const auto farther = [&](const Point<double, N>& p, const Point<double, N>& q) {
        return sign_of([&]<class W>() -> W { return dot(exactly<W>(n), difference<W, N>(p, q)); }, trace) > 0;
      };
      const std::size_t farthest = fit::detail::extreme(points, farther);
      trace(fit::Extreme{static_cast<int>(i), side, static_cast<int>(farthest)});

      const Point<double, N> p = points[farthest].template cast<double>();
      const auto along = [&]<class W>() -> Ratio<W> { return {dot(exactly<W>(n), exactly<W>(p)), W(1)}; };
      const auto holds = [&](S x) {
        return sign_of([&]<class W>() -> W { return dot(exactly<W>(n), exactly<W>(p)) - W(x); }, trace) <= 0;
      };
      return fit::detail::least<S>(value_of<S>(along, trace), holds);
    };
    kdop.slabs[i] = {-end(-1), end(1)};
  }
  return kdop;
}

}  // namespace isect
