#pragma once
// Where the smallest ball has its center, and how the smallest box is turned: rounded numbers, which need not be
// right.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <isect/convex_hull.h>
#include <isect/convex_hull_3d.h>
#include <isect/directions.h>
#include <isect/parts/fit_guess.h>

namespace isect::fit {

namespace detail {

/// Symmetrical objects have many fits as good as the best. Rounding must not choose among them, as sines, and the order
/// in which sums are made, differ from machine to machine: a number less by no more than this share counts as equal,
/// and the first of equals is taken.
constexpr double noise = 0x1p-40;
inline bool clearly_less(double x, double y) { return x < y * (1 - noise); }

/// The first point for which a number, not negative, is greatest.
template <int N, class Number>
int first_greatest(const std::vector<Point<double, N>>& q, const Number& number) {
  int first = 0;
  double greatest = -1;
  for (int i = 0; i < static_cast<int>(q.size()); ++i)
    if (const double x = number(q[i]); clearly_less(greatest, x)) greatest = x, first = i;
  return first;
}

template <int N>
int farthest(const std::vector<Point<double, N>>& q, const Point<double, N>& from) {
  return first_greatest<N>(q, [&](const Point<double, N>& p) { return (p - from).squaredNorm(); });
}

/// A ball around points, given by the few points on its surface whose smallest ball it is.
template <int N>
struct Support {
  std::vector<int> points;
  Point<double, N> center;
  double radius2 = std::numeric_limits<double>::infinity();
};

/// The center of the smallest sphere through the points, which are N + 1 at most. From the first it moves along e,
/// the part of the next point orthogonal to those before, to equal distance. NaN where they are dependent. Source:
/// Gaertner, Fast and robust smallest enclosing balls, ESA 1999.
template <int N>
Point<double, N> circumcenter(const std::vector<Point<double, N>>& q, const std::vector<int>& through) {
  std::vector<Vector<double, N>> basis;
  const Point<double, N>& origin = q[through[0]];
  Point<double, N> c = Point<double, N>::Zero();
  for (std::size_t k = 1; k < through.size(); ++k) {
    const Vector<double, N> p = q[through[k]] - origin;
    Vector<double, N> e = p;
    for (int twice = 0; twice < 2; ++twice)
      for (const Vector<double, N>& b : basis) e -= e.dot(b) / b.squaredNorm() * b;
    c += (p.dot(p - 2 * c) / (2 * p.dot(e))) * e;
    basis.push_back(e);
  }
  return origin + c;
}

/// The smallest ball of a few points with `fresh` on its surface: among all circumscribed ones that hold all, the one
/// of least radius.
template <int N>
Support<N> ball_of_few(const std::vector<Point<double, N>>& q, const std::vector<int>& few, int fresh) {
  Support<N> best;
  for (unsigned subset = 0; subset < 1u << few.size(); ++subset) {
    std::vector<int> through = {fresh};
    for (std::size_t k = 0; k < few.size(); ++k)
      if (subset >> k & 1) through.push_back(few[k]);
    if (through.size() > N + 1) continue;
    const Point<double, N> c = circumcenter<N>(q, through);
    double radius2 = (q[fresh] - c).squaredNorm();
    for (const int i : few) radius2 = std::max(radius2, (q[i] - c).squaredNorm());
    if (c == c && clearly_less(radius2, best.radius2)) best = {through, c, radius2};
  }
  return best;
}

/// The smallest ball: the farthest point joins its support, whose own smallest ball is larger, until none is farther.
/// Some ten rounds, each a pass over all points. Source: Welzl, Smallest enclosing disks (balls and ellipsoids),
/// 1991; Gaertner's rule for choosing the next point.
template <int N>
Support<N> smallest_ball(const std::vector<Point<double, N>>& q) {
  Support<N> now = {{0}, q[0], 0}, best = now;
  double least2 = std::numeric_limits<double>::infinity();
  for (;;) {
    const int far = farthest<N>(q, now.center);
    const double most2 = (q[far] - now.center).squaredNorm();
    if (clearly_less(most2, least2)) least2 = most2, best = now;
    if (!clearly_less(now.radius2, most2)) return best;
    const Support<N> larger = ball_of_few<N>(q, now.points, far);
    if (!(clearly_less(now.radius2, larger.radius2) && std::isfinite(larger.radius2))) return best;  // rounding is left
    now = larger;
  }
}

/// Ritter's ball: across two points far apart, grown towards each point outside. Two passes.
/// Source: Ritter, An efficient bounding sphere, Graphics Gems, 1990.
template <int N>
Point<double, N> ritter_center(const std::vector<Point<double, N>>& q) {
  const Point<double, N>&a = q[farthest<N>(q, q[0])], &b = q[farthest<N>(q, a)];
  Point<double, N> center = (a + b) / 2;
  double radius = (b - a).norm() / 2;
  for (const Point<double, N>& p : q) {
    const double distance = (p - center).norm();
    if (!(distance > radius)) continue;
    const double larger = (radius + distance) / 2;
    center += (larger - radius) / distance * (p - center);
    radius = larger;
  }
  return center;
}

/// v / |v|, or the other one where v is too small for that.
template <int N>
Vector<double, N> unit(const Vector<double, N>& v, const Vector<double, N>& other) {
  const Vector<double, N> u = v.stableNormalized();
  return std::abs(u.squaredNorm() - 1) < 0.01 ? u : other;
}

/// The convex hull up to rounding: shadows of symmetrical objects have many points that are one in truth, and to tell
/// exactly how rounding has parted them takes long.
inline Ring<double, 2> rounded_hull(Ring<double, 2> points) {
  const auto turn = [](const Point<double, 2>& a, const Point<double, 2>& b, const Point<double, 2>& c) {
    const Vector<double, 2> along = b - a, on = c - b;
    return along[0] * on[1] - along[1] * on[0] > 0 ? 1 : 0;
  };
  return convex_hull_2d::detail::chains(std::move(points), turn, NoTrace{});
}

/// The direction of an edge of the points' convex hull, such that the rectangle along it has the least area. All four
/// sides turn with it around the hull: rotating calipers. Source: Freeman, Shapira, CACM 18 (1975); Toussaint 1983.
inline Vector<double, 2> rectangle(const Ring<double, 2>& points) {
  const Ring<double, 2> hull = rounded_hull(points);
  const int n = static_cast<int>(hull.size());
  Vector<double, 2> best(1, 0);
  if (n == 2) best = unit<2>(hull[1] - hull[0], best);
  if (n < 3) return best;
  const auto at = [&](int i) -> const Point<double, 2>& { return hull[i < n ? i : i - n]; };
  double least = std::numeric_limits<double>::infinity();
  int right = 1, top = 1, left = 1;
  for (int i = 0; i < n; ++i) {
    const Vector<double, 2> u = at(i + 1) - at(i), v(-u[1], u[0]);  // of any length
    right = std::max(right, i + 1);
    while (right < i + n && u.dot(at(right + 1) - at(right)) > 0) ++right;
    top = std::max(top, right);
    while (top < i + n && v.dot(at(top + 1) - at(top)) > 0) ++top;
    left = std::max(left, top);
    while (left < i + n && u.dot(at(left + 1) - at(left)) < 0) ++left;
    const double area = u.dot(at(right) - at(left)) * v.dot(at(top) - at(i)) / u.squaredNorm();
    if (clearly_less(area, least)) least = area, best = u;
  }
  return unit<2>(best, Vector<double, 2>(1, 0));
}

template <int N>
double volume_along(const Eigen::Matrix<double, N, N>& axes, const std::vector<Point<double, N>>& q) {
  const Aabb<double, N> box = along<N>(axes, q);
  return (box.hi - box.lo).prod();
}

/// The smallest rectangle, which has a side along an edge of the hull.
inline Eigen::Matrix2d tight_axes(const std::vector<Point<double, 2>>& q) {
  const Vector<double, 2> u = rectangle(q);
  Eigen::Matrix2d axes;
  axes << u[0], -u[1], u[1], u[0];
  return axes;
}

/// The best axes with the third along `base`.
inline Eigen::Matrix3d turned_about(const Vector<double, 3>& base, const std::vector<Point<double, 3>>& q) {
  const Vector<double, 3> w = unit<3>(base, Vector<double, 3>::UnitZ()), x = w.unitOrthogonal(), y = w.cross(x);
  Ring<double, 2> flat;
  flat.reserve(q.size());
  for (const Point<double, 3>& p : q) flat.push_back({x.dot(p), y.dot(p)});
  const Vector<double, 2> u = rectangle(flat);
  Eigen::Matrix3d axes;
  axes << u[0] * x + u[1] * y, u[0] * y - u[1] * x, w;
  return axes;
}

/// The searches stop at this resolution: turning a box in its least place by this angle, or shrinking it by this share,
/// changes its volume by no more than about its own rounding, as the change there is of second order.
inline constexpr double resolution = 0x1p-26;  // the square root of a double's epsilon

/// Turns about one axis after the other, each time by the best angle, until none helps.
inline Eigen::Matrix3d descended(Eigen::Matrix3d axes, const std::vector<Point<double, 3>>& q) {
  double volume = volume_along<3>(axes, q);
  for (int since = 0, axis = 0; since < 3; axis = (axis + 1) % 3) {
    const Eigen::Matrix3d next = turned_about(axes.col(axis), q);
    const double less = volume_along<3>(next, q);
    ++since;
    if (!(less < volume * (1 - resolution))) continue;
    axes = next, volume = less, since = 1, axis = 2;  // the axis turned about is the third now
  }
  return axes;
}

/// Adds the points that the box along the axes rests on, one a face, where they are missing.
inline void add_ends(std::vector<Point<double, 3>>& ends, const Eigen::Matrix3d& axes,
                     const std::vector<Point<double, 3>>& q) {
  for (int i = 0; i < 3; ++i) {
    const auto before = [&](const auto& x, const auto& y) { return axes.col(i).dot(x) < axes.col(i).dot(y); };
    const auto [least, most] = std::minmax_element(q.begin(), q.end(), before);
    for (const auto& end : {*least, *most})
      if (std::find(ends.begin(), ends.end(), end) == ends.end()) ends.push_back(end);
  }
}

/// Turns by ever smaller angles, down to `finest` radians, about any of many directions, while that helps: the least
/// volume may be at a ridge, where no turn about a single axis of the box does. The few points that boxes have rested
/// on so far mostly make a turned one too large already, and then the others are not looked at.
inline Eigen::Matrix3d polished(Eigen::Matrix3d axes, const std::vector<Point<double, 3>>& q, double finest) {
  static const std::vector<Vector<double, 3>> about = directions<double, 3>(26);
  double volume = volume_along<3>(axes, q);
  constexpr std::size_t few = 16;  // so few are tested as quickly as chosen from
  std::vector<Point<double, 3>> ends;
  if (q.size() <= few) ends = q;
  add_ends(ends, axes, q);
  for (double angle = 0.2; angle > finest; angle /= 2)
    for (int since = 0, tries = 0; since < 26 && tries < 200; ++since, ++tries) {
      const double turn = tries % 2 ? angle : -angle;
      const Eigen::Matrix3d next = Eigen::AngleAxisd(turn, about[tries / 2 % 13].normalized()) * axes;
      if (!clearly_less(volume_along<3>(next, ends), volume)) continue;
      if (q.size() > few) add_ends(ends, next, q);
      const double less = volume_along<3>(next, q);
      if (clearly_less(less, volume)) axes = next, volume = less, since = 0;
    }
  return axes;
}

constexpr int enough = 100;        ///< vertices to search among
constexpr int enough_tries = 200;  ///< of boxes along a face or an edge, those that may be smallest first
constexpr double coarse = 0.02;    ///< radians: finer turns are for the best box alone

/// Returns the vertices of a hull that are farthest in one of `enough` directions.
inline std::vector<Point<double, 3>> few_vertices(const std::vector<Point<double, 3>>& vertices) {
  std::vector<Point<double, 3>> few;
  double size = 0;
  for (const Point<double, 3>& p : vertices) size = std::max(size, p.norm());
  constexpr double golden = 2.399963229728653;  // radians: points of a spiral, evenly on the sphere
  for (int i = 0; i < enough; ++i) {
    const double z = (2 * i + 1.0) / enough - 1, r = std::sqrt(1 - z * z);
    const Vector<double, 3> n(r * std::cos(golden * i), r * std::sin(golden * i), z);
    few.push_back(vertices[first_greatest<3>(vertices, [&](const auto& p) { return size + n.dot(p); })]);
  }
  return few;
}

/// A lower bound of the volume of every box around the hull with a side along `base`: its extent there, times the area
/// of its shadow, which its faces cover twice.
inline double least_volume(const Vector<double, 3>& base, const Hull3<double>& hull,
                           const std::vector<Vector<double, 3>>& normals) {
  const Vector<double, 3> w = unit<3>(base, Vector<double, 3>::UnitZ());
  double lo = std::numeric_limits<double>::infinity(), hi = -lo, shadow = 0;
  for (const Point<double, 3>& p : hull.vertices) lo = std::min(lo, w.dot(p)), hi = std::max(hi, w.dot(p));
  for (const Vector<double, 3>& n : normals) shadow += std::abs(n.dot(w)) / 4;  // |n|: twice a face
  return (hi - lo) * shadow;
}

/// The hull's vertices that bound its shadow along `base`, and a few more: those between faces that look up and down.
inline std::vector<Point<double, 3>> outline(const Vector<double, 3>& base, const Hull3<double>& hull,
                                             const std::vector<Vector<double, 3>>& normals, double size) {
  if (hull.dimension < 3) return hull.vertices;
  const Vector<double, 3> w = unit<3>(base, Vector<double, 3>::UnitZ());
  const double rounding = 1e-14 * size * size;  // of a normal, many times over: a thin face may look either way
  enum : unsigned char { up = 1, down = 2 };
  std::vector<unsigned char> looks(hull.vertices.size());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const double rise = normals[i].dot(w);
    for (const int v : hull.triangles[i]) looks[v] |= (rise > -rounding ? up : 0) | (rise < rounding ? down : 0);
  }
  std::vector<Point<double, 3>> points;
  for (std::size_t v = 0; v < looks.size(); ++v)
    if (looks[v] == (up | down)) points.push_back(hull.vertices[v]);
  return points;
}

/// The best boxes along the bases, the `most` smallest of different volume among those tried. Of boxes of one volume it
/// keeps the earliest base's: a symmetrical hull has many, which are all the same to a search that starts there.
inline std::vector<Eigen::Matrix3d> smallest_along(const std::vector<Vector<double, 3>>& bases,
                                                   const Hull3<double>& hull,
                                                   const std::vector<Vector<double, 3>>& normals, std::size_t most) {
  std::vector<std::pair<float, std::size_t>> hopeful;  // of so few digits that equals are equal
  for (std::size_t i = 0; i < bases.size(); ++i)
    hopeful.push_back({static_cast<float>(least_volume(bases[i], hull, normals)), i});
  std::sort(hopeful.begin(), hopeful.end());
  struct Found {
    float volume;
    std::size_t base;
    Eigen::Matrix3d axes;
  };
  const auto smaller = [](const Found& a, const Found& b) { return a.volume < b.volume; };
  double size = 0;
  for (const Point<double, 3>& p : hull.vertices) size = std::max(size, (p - hull.vertices[0]).norm());
  const double rounding = 1e-6 * size * size * size;  // of bound and volume together, many times over
  std::vector<Found> found;                           // ascending
  int tries = 0;
  for (const auto& [least, i] : hopeful) {
    if (found.size() == most && (least - rounding > found.back().volume || tries >= enough_tries)) break;
    ++tries;
    const Eigen::Matrix3d axes = turned_about(bases[i], outline(bases[i], hull, normals, size));
    const Found one = {static_cast<float>(volume_along<3>(axes, hull.vertices)), i, axes};
    const auto at = std::lower_bound(found.begin(), found.end(), one, smaller);
    if (at == found.end() || at->volume != one.volume)
      found.insert(at, one);
    else if (i < at->base)
      *at = one;
    if (found.size() > most) found.pop_back();
  }
  std::vector<Eigen::Matrix3d> axes;
  for (const Found& one : found) axes.push_back(one.axes);
  return axes;
}

/// Axes of a box of small volume. The smallest one has two adjacent faces flush with edges of the hull (O'Rourke);
/// those with a whole face flush are tried, by calipers in its plane, and those along two edges of a small hull;
/// enough_tries of them at most, those that may be the smallest first. What comes near the best is then turned about
/// its axes, coarsely and among a few vertices of a large hull; at last the best is, finely and among all. Source:
/// O'Rourke, Finding minimal enclosing boxes, 1985; Chang, Gorissen, Melchior, Fast oriented bounding box optimization
/// on the rotation group, ACM TOG 30 (2011).
inline Eigen::Matrix3d tight_axes(const Hull3<double>& whole) {
  const std::vector<Point<double, 3>>& all = whole.vertices;
  const Hull3<double> hull = all.size() > enough ? convex_hull(few_vertices(all)) : whole;
  std::vector<Vector<double, 3>> normals, edges;
  for (const auto& [a, b, c] : hull.triangles) {
    const Point<double, 3>&p = hull.vertices[a], &r = hull.vertices[b], &s = hull.vertices[c];
    normals.push_back((r - p).cross(s - p));
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      if (from < to) edges.push_back(hull.vertices[to] - hull.vertices[from]);
  }
  if (hull.dimension == 1) edges.push_back(hull.vertices[1] - hull.vertices[0]);
  std::vector<Vector<double, 3>> bases = normals;
  bases.insert(bases.end(), edges.begin(), edges.end());
  if (edges.size() <= 40)
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) bases.push_back(edges[i].cross(edges[j]));

  Eigen::Matrix3d best = Eigen::Matrix3d::Identity();
  double least = std::numeric_limits<double>::infinity();
  const auto refined = [](const Eigen::Matrix3d& axes, const std::vector<Point<double, 3>>& points, double finest) {
    return descended(polished(descended(axes, points), points, finest), points);
  };
  for (const Eigen::Matrix3d& start : smallest_along(bases, hull, normals, 4)) {
    const Eigen::Matrix3d axes = refined(start, hull.vertices, coarse);
    const double volume = volume_along<3>(axes, all);
    if (clearly_less(volume, least)) least = volume, best = axes;
  }
  return refined(best, all, resolution);
}
inline Eigen::Matrix3d tight_axes(const std::vector<Point<double, 3>>& q) { return tight_axes(convex_hull(q)); }

}  // namespace detail

}  // namespace isect::fit
