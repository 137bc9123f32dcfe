#pragma once
// A k-DOP as a polytope: its vertices, and in space its faces.
//
// Slab i lies below two planes, n x <= hi and -n x <= -lo. Any N planes with independent normals meet in a point, by
// Cramer's rule a quotient of determinants; it is a vertex when it lies above none of the planes. Four or more planes
// may meet in one vertex, and then several choices of N give it: two vertices are the same iff the same planes pass
// through them. These are signs of polynomials in the numbers given. A vertex is rounded at last, and nothing is
// decided on it: not emptiness, not which vertices a face has, nor their order around it.
//
// A bounded polytope has a vertex. So one without a vertex is empty: its slabs contradict each other, even where no
// slab is empty by itself. There are (k choose N) choices, few for a k-DOP. Source: the note, N08.

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <variant>
#include <vector>

#include <isect/numbers/predicate.h>
#include <isect/numbers/quotient.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

/// Without vertices it is empty. In 2D the vertices are in counter-clockwise order. In 3D a face is a ring of indices
/// of vertices, three at least, counter-clockwise seen from outside; a flat polytope has its ring on both sides.
template <class S, int N>
struct Polytope {
  std::vector<Point<S, N>> vertices;
  std::vector<std::vector<int>> faces;  ///< none in 2D
};

namespace kdop_polytope {

/// A vertex, and the planes through it: 2 i for the upper end of slab i, 2 i + 1 for the lower.
template <class S, int N>
struct Vertex {
  Point<S, N> at;
  std::vector<int> planes;
};
template <class S, int N>
using Event = std::variant<Vertex<S, N>, Fallback>;

namespace detail {

/// The half-space normal.x <= d.
template <int N>
struct HalfSpace {
  Vector<double, N> normal;
  double d;
};

/// The point x / w, w not zero.
template <class W, int N>
struct Homogeneous {
  Components<W, N> x;
  W w;
};

template <class W>
W determinant(const std::array<W, 2>& a, const std::array<W, 2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// Returns the point where N planes meet.
template <class W>
Homogeneous<W, 2> meet(const std::array<HalfSpace<2>, 2>& planes) {
  const Components<W, 2> a = exactly<W>(planes[0].normal), b = exactly<W>(planes[1].normal);
  const W c(planes[0].d), d(planes[1].d);
  return {{c * b[1] - a[1] * d, a[0] * d - c * b[0]}, determinant(a, b)};
}
template <class W>
Homogeneous<W, 3> meet(const std::array<HalfSpace<3>, 3>& planes) {
  const Components<W, 3> a = exactly<W>(planes[0].normal), b = exactly<W>(planes[1].normal),
                         c = exactly<W>(planes[2].normal);
  const Components<W, 3> bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const W u(planes[0].d), v(planes[1].d), w(planes[2].d);
  Homogeneous<W, 3> p;
  for (int i = 0; i < 3; ++i) p.x[i] = u * bc[i] + v * ca[i] + w * ab[i];
  p.w = dot(a, bc);
  return p;
}

/// The sign of the determinant of the planes' normals. Doubles hold it exactly when the normals are integers below
/// 2^16, as those of a k-DOP mostly are: each of its products is below 2^48. Many of these signs are 0.
template <int N, class Trace>
int sign_of_normals(const std::array<HalfSpace<N>, N>& planes, Trace&& trace) {
  const auto small = [](double x) { return std::abs(x) < 0x1p16 && x == std::trunc(x); };
  const bool exact = std::all_of(planes.begin(), planes.end(), [&](const HalfSpace<N>& plane) {
    return std::all_of(plane.normal.begin(), plane.normal.end(), small);
  });
  if (!exact) return sign_of<long_text>([&]<class W>() -> W { return meet<W>(planes).w; }, trace);
  Eigen::Matrix<double, N, N> normals;
  for (int i = 0; i < N; ++i) normals.col(i) = planes[i].normal;
  const double determinant = normals.determinant();
  return (determinant > 0) - (determinant < 0);
}

/// Whether the normals span space: otherwise the k-DOP is unbounded.
template <int N, class Trace>
bool span(const std::vector<HalfSpace<N>>& planes, Trace&& trace, std::vector<int> chosen = {}) {
  if (chosen.size() == N) {
    std::array<HalfSpace<N>, N> of;
    for (int i = 0; i < N; ++i) of[i] = planes[chosen[i]];
    return sign_of_normals<N>(of, trace) != 0;
  }
  for (int i = chosen.empty() ? 0 : chosen.back() + 2; i < static_cast<int>(planes.size()); i += 2) {
    chosen.push_back(i);  // one plane of each slab
    if (span(planes, trace, chosen)) return true;
    chosen.pop_back();
  }
  return false;
}

template <int N>
struct Corner {
  std::array<HalfSpace<N>, N> planes;  ///< those that meet there first
  int w;                               ///< the sign of their determinant
  std::vector<int> through;            ///< all that pass through it, in order
};

/// The sign of the determinant of three corners' coordinates i and j: their turn in that projection.
template <int N, class Trace>
int turn(const Corner<N>& a, const Corner<N>& b, const Corner<N>& c, int i, int j, Trace&& trace) {
  const auto area = [&]<class W>() -> W {
    const Homogeneous<W, N> p = meet<W>(a.planes), q = meet<W>(b.planes), r = meet<W>(c.planes);
    return p.w * (q.x[i] * r.x[j] - q.x[j] * r.x[i]) + q.w * (r.x[i] * p.x[j] - r.x[j] * p.x[i]) +
           r.w * (p.x[i] * q.x[j] - p.x[j] * q.x[i]);
  };
  return a.w * b.w * c.w * sign_of<long_text>(area, trace);
}

template <int N, class Trace>
class Corners {
 public:
  Corners(const std::vector<HalfSpace<N>>& planes, Trace& trace) : planes_(planes), trace_(trace) { extend({}, 0, 0); }

  std::vector<Corner<N>> all;

 private:
  using Choice = std::array<int, N>;  ///< of planes, in order

  /// Tries all choices that begin with the first `count` of these and go on from `first`.
  void extend(Choice chosen, int count, int first) {
    if (count == N) return add(chosen);
    for (chosen[count] = first; chosen[count] < static_cast<int>(planes_.size()); ++chosen[count])
      extend(chosen, count + 1, chosen[count] + 1);
  }

  void add(const Choice& chosen) {
    for (const Corner<N>& known : all)
      if (std::includes(known.through.begin(), known.through.end(), chosen.begin(), chosen.end())) return;
    Corner<N> corner;
    for (int i = 0; i < N; ++i) corner.planes[i] = planes_[chosen[i]];
    corner.w = orientation(chosen, corner.planes);
    if (corner.w == 0) return;

    const Homogeneous<Bounded<double>, N> quick = meet<Bounded<double>>(corner.planes);  // settles nearly all
    const auto at = [&]<class W>() -> Homogeneous<W, N> {
      if constexpr (std::is_same_v<W, Bounded<double>>)
        return quick;
      else
        return meet<W>(corner.planes);
    };
    const auto side = [&](int i) {
      if (std::find(chosen.begin(), chosen.end(), i) != chosen.end()) return 0;
      const auto above = [&]<class W>() -> W {
        const Homogeneous<W, N> p = at.template operator()<W>();
        return dot(exactly<W>(planes_[i].normal), p.x) - W(planes_[i].d) * p.w;
      };
      return corner.w * sign_of<long_text>(above, trace_);
    };
    if (side(above_) > 0) return;
    for (int i = 0; i < static_cast<int>(planes_.size()); ++i) {
      const int s = side(i);
      if (s > 0) return void(above_ = i);
      if (s == 0) corner.through.push_back(i);
    }
    all.push_back(corner);
  }

  /// The sign of the determinant of the planes' normals: found once for slabs, as their lower planes only turn it.
  int orientation(const Choice& chosen, const std::array<HalfSpace<N>, N>& of) {
    std::size_t slabs = 0;
    int lower = 0;
    for (const int i : chosen) slabs = slabs * (planes_.size() / 2) + i / 2, lower += i % 2;
    const int turned = lower % 2 ? -1 : 1;
    std::optional<int>& known = orientations_[slabs];
    if (!known) known = turned * sign_of_normals<N>(of, trace_);
    return turned * *known;
  }

  const std::vector<HalfSpace<N>>& planes_;
  Trace& trace_;
  std::unordered_map<std::size_t, std::optional<int>> orientations_;
  int above_ = 0;  ///< the plane that the last choice's point was above: the next one's often is, too
};

/// Sorts corners of a convex polygon by their turn around the first one.
template <int N, class Trace>
void sort_around(std::vector<int>& ring, const std::vector<Corner<N>>& corners, int i, int j, Trace&& trace) {
  std::sort(ring.begin() + 1, ring.end(),
            [&](int a, int b) { return a != b && turn(corners[ring[0]], corners[a], corners[b], i, j, trace) > 0; });
}

/// The ring of corners in the plane, counter-clockwise as its normal is seen; nothing when they have no area there.
template <class Trace>
std::vector<int> face(int plane, const HalfSpace<3>& of, const std::vector<Corner<3>>& corners, Trace&& trace) {
  std::vector<int> ring;
  for (int c = 0; c < static_cast<int>(corners.size()); ++c)
    if (std::binary_search(corners[c].through.begin(), corners[c].through.end(), plane)) ring.push_back(c);
  if (ring.size() < 3 || of.normal.isZero(0)) return {};

  int axis = 0;  // along which the plane is projected: its normal is not 0 there
  of.normal.cwiseAbs().maxCoeff(&axis);
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  if (of.normal[axis] > 0)
    sort_around<3>(ring, corners, i, j, trace);
  else
    sort_around<3>(ring, corners, j, i, trace);
  return ring;
}

}  // namespace detail

}  // namespace kdop_polytope

/// The polytope of the k-DOP; exactly its vertices, each coordinate within 2 ulp. Empty slabs, slabs that contradict
/// each other, NaN and infinite numbers: no vertices. A zero normal makes no face: its slab is all of space when it
/// holds 0, and empty otherwise. Slabs given twice make one face. Throws std::invalid_argument when the normals do
/// not span space, as the k-DOP is unbounded then.
template <class S, int N, class Trace = NoTrace>
Polytope<S, N> polytope(const Kdop<S, N>& kdop, Trace&& trace = {}) {
  static_assert(N == 2 || N == 3);
  assert(kdop.normals.size() == kdop.slabs.size());
  if (empty(kdop) || !finite(kdop)) return {};
  std::vector<kdop_polytope::detail::HalfSpace<N>> planes;
  for (std::size_t i = 0; i < kdop.normals.size(); ++i) {
    const Vector<double, N> n = kdop.normals[i].template cast<double>();
    const Interval<double> slab = cast<double>(kdop.slabs[i]);
    if (n.isZero(0) && !slab.contains(0)) return {};
    planes.push_back({n, slab.hi}), planes.push_back({-n, -slab.lo});
  }
  if (!kdop_polytope::detail::span(planes, trace))
    throw std::invalid_argument("polytope: the normals do not span space, so the k-DOP is unbounded");
  kdop_polytope::detail::Corners<N, std::remove_reference_t<Trace>> corners(planes, trace);

  Polytope<S, N> result;
  std::vector<int> order;
  for (int c = 0; c < static_cast<int>(corners.all.size()); ++c) order.push_back(c);
  if (N == 2 && !order.empty()) kdop_polytope::detail::sort_around<N>(order, corners.all, 0, 1, trace);
  for (const int c : order) {
    Point<S, N> p;
    for (int i = 0; i < N; ++i)
      p[i] = value_of<S>(
          [&]<class W>() -> Ratio<W> {
            const kdop_polytope::detail::Homogeneous<W, N> x = kdop_polytope::detail::meet<W>(corners.all[c].planes);
            return {x.x[i], x.w};
          },
          trace);
    result.vertices.push_back(p);
    if constexpr (heard<Trace>) trace(kdop_polytope::Vertex<S, N>{p, corners.all[c].through});
  }
  if constexpr (N == 3)
    for (int plane = 0; plane < static_cast<int>(planes.size()); ++plane) {
      std::vector<int> ring = kdop_polytope::detail::face(plane, planes[plane], corners.all, trace);
      if (!ring.empty() && std::find(result.faces.begin(), result.faces.end(), ring) == result.faces.end())
        result.faces.push_back(std::move(ring));
    }
  return result;
}

}  // namespace isect
