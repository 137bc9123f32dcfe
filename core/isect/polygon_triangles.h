#pragma once
// A polygon in space, cut into triangles: the tests of triangles then serve it, too.
//
// The corners are seen along the axis of the normal's largest component. There an ear is a corner that turns left
// between its neighbours, and whose triangle with them holds no other corner. It may be cut off, and every outline that
// does not touch itself has two of them. Every decision is the sign of an area.
//
// Corners off one plane do no harm: then the triangles are a surface with folds, which has one point over each point of
// what is seen, so that it does not meet itself.
//
// Source: G. H. Meisters, Polygons have ears, Amer. Math. Monthly 82 (1975).

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <isect/convex_hull.h>
#include <isect/orient.h>
#include <isect/segment_polygon.h>
#include <isect/segment_segment.h>

namespace isect {

/// A polygon in space, of one outline, as triangles between its corners. Made by `triangulated`.
template <class S>
struct TriangulatedPolygon {
  static_assert(is_scalar<S>());
  Ring<S, 3> outline;
  std::vector<std::array<int, 3>> triangles;  ///< numbers of corners; each turns as the outline does
  std::vector<int> convex;  ///< for a convex polygon whose corners lie in one plane: those that it turns at, in order
};

template <class S>
bool empty(const TriangulatedPolygon<S>& x) {
  return x.triangles.empty();
}
template <class S>
Triangle<S, 3> triangle(const TriangulatedPolygon<S>& x, int index) {
  const auto at = [&](std::size_t k) {
    return x.outline[static_cast<std::size_t>(x.triangles[static_cast<std::size_t>(index)][k])];
  };
  return {{at(0), at(1), at(2)}};
}

/// Whether the edges of a ring meet only where one ends and the next begins, and only in that point. Exact, in O(n^2);
/// no for fewer than three points.
template <class S>
bool is_simple(const Ring<S, 2>& ring) {
  using segment_segment::Meeting;
  const std::size_t n = ring.size();
  if (n < 3) return false;
  const auto edge = [&](std::size_t i) { return Segment<S, 2>{ring[i], ring[(i + 1) % n]}; };
  for (std::size_t i = 0; i < n; ++i) {
    if (ring[i] == ring[(i + 1) % n]) return false;
    for (std::size_t j = i + 1; j < n; ++j) {
      const bool neighbours = j == i + 1 || (i == 0 && j == n - 1);
      if (intersect(edge(i), edge(j)).relation > (neighbours ? Meeting::touch : Meeting::disjoint)) return false;
    }
  }
  return true;
}

/// The corners of an outline that goes once round a convex area, counter-clockwise, however often it names a corner or
/// a point of a side; nothing for another outline. Exact.
inline std::optional<Ring<double, 2>> convex_corners(const Ring<double, 2>& outline) {
  // A corner named again, or a point of the side between its neighbours, changes nothing.
  const auto says_nothing = [](const Point<double, 2>& a, const Point<double, 2>& b, const Point<double, 2>& c) {
    return b == c || (orient2d(a, b, c) == 0 && (a.cwiseMin(c).array() <= b.array()).all() &&
                      (b.array() <= a.cwiseMax(c).array()).all());
  };
  Ring<double, 2> ring;
  for (const Point<double, 2>& p : outline) {
    while (ring.size() > 1 && says_nothing(ring[ring.size() - 2], ring.back(), p)) ring.pop_back();
    if (ring.empty() || ring.back() != p) ring.push_back(p);
  }
  while (ring.size() > 2 && says_nothing(ring[ring.size() - 2], ring.back(), ring.front())) ring.pop_back();
  while (ring.size() > 2 && says_nothing(ring.back(), ring.front(), ring[1])) ring.erase(ring.begin());

  const Ring<double, 2> hull = convex_hull(ring);
  if (hull.size() < 3) return {};
  for (int way = 0; way < 2; ++way) {
    const auto first = std::ranges::find(ring, hull.front());
    if (first == ring.end()) return {};
    std::rotate(ring.begin(), first, ring.end());
    if (ring == hull) return hull;
    std::ranges::reverse(ring);
  }
  return {};
}

namespace polygon_triangles::detail {

using Three = std::array<int, 3>;

/// An outline as it is seen along the axis of the normal's largest component: counter-clockwise, each corner once.
template <class S>
struct Seen {
  std::vector<int> numbers = {};  ///< which corners of the outline these are
  Ring<double, 2> corners = {};
  bool clockwise;  ///< whether the outline ran so

  explicit Seen(const Ring<S, 3>& outline) {
    const int axis = segment_polygon::detail::steepest(outline);
    clockwise = sign_of([&]<class W>() -> W {
                  return segment_polygon::detail::normal<W>(outline)[static_cast<std::size_t>(axis)];
                }) < 0;
    const auto at = [&](int i) -> const Point<S, 3>& { return outline[static_cast<std::size_t>(i)]; };
    for (int i = 0; i < static_cast<int>(outline.size()); ++i)
      if (numbers.empty() || at(numbers.back()) != at(i)) numbers.push_back(i);
    if (numbers.size() > 1 && at(numbers.front()) == at(numbers.back())) numbers.pop_back();
    if (clockwise) std::ranges::reverse(numbers);
    for (const int i : numbers) corners.emplace_back(at(i)[(axis + 1) % 3], at(i)[(axis + 2) % 3]);
  }

  /// Returns the triangles by the numbers of the outline, turning as it does.
  std::vector<Three> as_given(std::vector<Three> triangles) const {
    for (Three& three : triangles) {
      for (int& i : three) i = numbers[static_cast<std::size_t>(i)];
      if (clockwise) std::swap(three[0], three[2]);
    }
    return triangles;
  }
};

/// The corners of a counter-clockwise outline, which may touch itself, and what is left of it.
class Ears {
 public:
  explicit Ears(const Ring<double, 2>& corners) : corners_(corners) {
    for (int i = 0; i < static_cast<int>(corners_.size()); ++i) left_.push_back(i);
  }

  /// Returns triangles that cover what the outline winds around, each point as often as it does; none where no ear is
  /// found although corners are left.
  std::vector<Three> cut() {
    std::vector<Three> triangles;
    for (std::size_t at = 0, tried = 0; left_.size() > 2 && tried <= left_.size(); ++tried) {
      at %= left_.size();
      const Three three = {left(at + left_.size() - 1), left(at), left(at + 1)};
      if (!is_ear(three)) {
        ++at;
        continue;
      }
      triangles.push_back(three);
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
      tried = 0;
    }
    return left_.size() > 2 ? std::vector<Three>() : triangles;
  }

 private:
  int left(std::size_t i) const { return left_[i % left_.size()]; }
  const Point<double, 2>& corner(int i) const { return corners_[static_cast<std::size_t>(i)]; }

  /// Whether a triangle turns left, and no other corner lies in it or on its boundary, except where corners touch.
  bool is_ear(const Three& three) const {
    const Point<double, 2>&a = corner(three[0]), &b = corner(three[1]), &c = corner(three[2]);
    if (orient2d(a, b, c) <= 0) return false;
    return std::ranges::none_of(left_, [&](int i) {
      const Point<double, 2>& p = corner(i);
      return p != a && p != b && p != c && orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 && orient2d(c, a, p) >= 0;
    });
  }

  const Ring<double, 2>& corners_;
  std::vector<int> left_;
};

/// Whether no two of the triangles, all counter-clockwise, have a common interior.
inline bool all_apart(const Ring<double, 2>& corners, const std::vector<Three>& triangles) {
  const auto corner = [&](int i) -> const Point<double, 2>& { return corners[static_cast<std::size_t>(i)]; };
  const auto a_side_parts = [&](const Three& s, const Three& t) {
    for (std::size_t i = 0; i < 3; ++i)
      if (std::ranges::all_of(t, [&](int k) { return orient2d(corner(s[i]), corner(s[(i + 1) % 3]), corner(k)) <= 0; }))
        return true;
    return false;
  };
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!a_side_parts(triangles[i], triangles[j]) && !a_side_parts(triangles[j], triangles[i])) return false;
  return true;
}

/// Finds TriangulatedPolygon::convex.
template <class S>
std::vector<int> convex(const Ring<S, 3>& outline, const Seen<S>& seen) {
  const std::optional<Ring<double, 2>> corners = convex_corners(seen.corners);
  if (!corners) return {};
  std::vector<int> numbers;
  for (const Point<double, 2>& c : *corners)
    numbers.push_back(
        seen.numbers[static_cast<std::size_t>(std::ranges::find(seen.corners, c) - seen.corners.begin())]);
  const auto at = [&](std::size_t i) -> Point<double, 3> {
    return outline[static_cast<std::size_t>(numbers[i])].template cast<double>();
  };
  const bool in_one_plane = std::ranges::all_of(
      outline, [&](const Point<S, 3>& v) { return orient3d(at(0), at(1), at(2), v.template cast<double>()) == 0; });
  return in_one_plane ? numbers : std::vector<int>();
}

}  // namespace polygon_triangles::detail

/// Whether an outline in space neither crosses nor touches itself, as it is seen along that axis. Exact, in O(n^2). The
/// outline is finite; corners in the same place that follow each other count as one.
template <class S>
bool is_simple(const Ring<S, 3>& outline) {
  return is_simple(polygon_triangles::detail::Seen<S>(outline).corners);
}

/// Triangles whose union is what the outline goes round, by the numbers of its corners; they turn as it does. An
/// outline may touch itself: so programs write a face with a hole, which an edge leads to and back from. None if it has
/// no area, crosses itself or runs back over an edge with nothing around it. Exact; O(n^2), and O(n^3) where ears are
/// few. The outline is finite.
template <class S>
std::vector<std::array<int, 3>> ears(const Ring<S, 3>& outline) {
  const polygon_triangles::detail::Seen<S> seen(outline);
  std::vector<std::array<int, 3>> triangles = polygon_triangles::detail::Ears(seen.corners).cut();
  if (!is_simple(seen.corners) && !polygon_triangles::detail::all_apart(seen.corners, triangles)) return {};
  return seen.as_given(std::move(triangles));
}

/// Makes the polygon of an outline that neither crosses nor touches itself. Any other outline, and one that has no area
/// or is not finite, gives no triangles, so an empty polygon. Exact; takes as long as `ears`.
template <class S>
TriangulatedPolygon<S> triangulated(Ring<S, 3> outline) {
  TriangulatedPolygon<S> result = {std::move(outline), {}, {}};
  if (result.outline.size() < 3 || !finite(result.outline)) return result;
  const polygon_triangles::detail::Seen<S> seen(result.outline);
  if (!is_simple(seen.corners)) return result;
  result.triangles = seen.as_given(polygon_triangles::detail::Ears(seen.corners).cut());
  result.convex = polygon_triangles::detail::convex(result.outline, seen);
  return result;
}

/// The greatest distance of a corner from the plane that isect/ray_polygon.h takes for the outline's: through the first
/// corner, with Newell's normal. 0 if and only if all lie in it, exactly; else within 2 ulp of a double, or the least
/// one. The outline is finite and has an area.
template <class S>
double off_plane(const Ring<S, 3>& outline) {
  const Components<Exact, 3> n = segment_polygon::detail::normal<Exact>(outline);
  const Exact length = sqrt(dot(n, n));
  double farthest = 0;
  for (const Point<S, 3>& v : outline) {
    const Exact height =
        dot(n, difference<Exact>(v.template cast<double>().eval(), outline[0].template cast<double>().eval()));
    if (height.sign() == 0) continue;
    farthest = std::max({farthest, near_quotient(abs(height), length), std::numeric_limits<double>::denorm_min()});
  }
  return farthest;
}

}  // namespace isect
