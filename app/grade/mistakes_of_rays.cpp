// Wrong implementations of tests of rays, and of the point in a polygon.

#include <algorithm>
#include <array>
#include <cmath>

#include "app/grade/mistakes.h"

namespace isect::grade {

namespace {

using V = std::array<double, 3>;

V vector_at(const Numbers& x, std::size_t at) { return {x[at], x[at + 1], x[at + 2]}; }
V operator-(const V& a, const V& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const V& a, const V& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
V cross(const V& a, const V& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
const Truth no_hit = {false};
/// Returns a hit at t, or a miss where t is no number, as a comparison makes of it.
Truth hit_at(double t) { return std::isfinite(t) ? Truth{true, "", {t}} : no_hit; }

/// What may be wrong with the quadratic.
struct Quadratic {
  bool unit = false;        ///< the direction is taken to have length 1
  bool unsquared = false;   ///< the radius is not squared
  bool tangent = true;      ///< a tangent ray hits
  bool behind = false;      ///< roots behind the ray count
  bool from_inside = true;  ///< the second root is tried
  bool last = false;        ///< the second root is taken
  bool origin = true;       ///< t = 0 counts
  bool four = false;        ///< b^2 - 4ac with half of b
  bool solid = false;       ///< from inside, t = 0
};
Truth quadratic(const Numbers& x, const Quadratic& q) {
  const V to = vector_at(x, 0) - vector_at(x, 6), d = vector_at(x, 3);
  const double a = q.unit ? 1 : dot(d, d), b = dot(d, to), c = dot(to, to) - (q.unsquared ? x[9] : x[9] * x[9]);
  const double under = b * b - (q.four ? 4 : 1) * a * c;
  if (!(under >= 0) || (!q.tangent && under == 0)) return no_hit;
  const double t0 = (-b - std::sqrt(under)) / a, t1 = (-b + std::sqrt(under)) / a;
  const auto counts = [&q](double t) { return q.behind || t > 0 || (q.origin && t == 0); };
  if (q.last) return counts(t1) ? hit_at(t1) : no_hit;
  if (counts(t0)) return hit_at(t0);
  if (q.solid && t1 >= 0) return hit_at(0);
  return q.from_inside && counts(t1) ? hit_at(t1) : no_hit;
}
template <Quadratic q>
Truth of_quadratic(const Numbers& x) {
  return quadratic(x, q);
}

struct Plane {
  bool minus = false;  ///< the plane is n.x = d
  bool behind = false, within = true, tolerance = false, turned = false, origin = true;
};
template <Plane p>
Truth of_plane(const Numbers& x) {
  const V o = vector_at(x, 0), d = vector_at(x, 3), n = vector_at(x, 6);
  const double height = dot(n, o) + (p.minus ? -x[9] : x[9]), along = dot(n, d);
  if (p.tolerance ? std::abs(along) < 1e-6 : along == 0) return p.within && height == 0 ? hit_at(0) : no_hit;
  const double t = (p.turned ? height : -height) / along;
  return p.behind || t > 0 || (p.origin && t == 0) ? hit_at(t) : no_hit;
}

struct Slabs {
  bool swapped = true;   ///< ends are swapped for directions below 0
  bool clipped = true;   ///< at t = 0
  bool behind = false;   ///< boxes behind count
  bool parallel = true;  ///< directions with a 0 are tested apart
  bool open = false, exit = false;
  int axes = 3;
};
template <Slabs s>
Truth of_slabs(const Numbers& x) {
  double in = s.clipped ? 0 : -INFINITY, out = INFINITY;
  for (int i = 0; i < s.axes; ++i) {
    const double o = x[i], d = x[3 + i], lo = x[6 + i], hi = x[9 + i];
    if (s.parallel && d == 0) {
      if (o < lo || o > hi || (s.open && (o == lo || o == hi))) return no_hit;
      continue;
    }
    double t0 = (lo - o) / d, t1 = (hi - o) / d;
    if (s.swapped && t0 > t1) std::swap(t0, t1);
    in = in > t0 ? in : t0;  // no number stays no number
    out = out < t1 ? out : t1;
  }
  if (std::isnan(in) || std::isnan(out)) return no_hit;
  if (s.open ? in >= out : in > out) return no_hit;
  if (!s.behind && out < 0) return no_hit;
  return hit_at(s.exit ? out : in);
}

struct Barycentric {
  double tolerance = 0;
  bool culled = false, behind = false, open = false, sum = true, one = true, t_positive = false;
};
/// The method of Moller and Trumbore, in doubles; rays within the plane miss.
template <Barycentric m>
Truth of_triangle(const Numbers& x) {
  const V o = vector_at(x, 0), d = vector_at(x, 3), a = vector_at(x, 6);
  const V e1 = vector_at(x, 9) - a, e2 = vector_at(x, 12) - a, p = cross(d, e2), to = o - a, q = cross(to, e1);
  const double det = dot(e1, p);
  if (m.culled ? det <= m.tolerance : m.tolerance > 0 ? std::abs(det) < m.tolerance : det == 0) return no_hit;
  const double u = dot(to, p) / det, v = dot(d, q) / det, t = dot(e2, q) / det;
  const auto below = [](double n) { return m.open ? n <= 0 : n < 0; };
  if (below(u) || below(v) || (m.sum && below(1 - u - v)) || (!m.sum && m.one && (below(1 - u) || below(1 - v))))
    return no_hit;
  if (!m.behind && (m.t_positive ? t <= m.tolerance : t < 0)) return no_hit;
  return hit_at(t);
}

struct Crossing {
  bool both = false, neither = false;  ///< ends of edges that count: both, or neither; else the lower one
  bool closed = true;                  ///< the last edge counts
  bool winding = false, around = false;
};
/// Never says on.
template <Crossing c>
Truth of_crossings(const Numbers& x) {
  const int count = static_cast<int>(x[0]);
  const double px = x[x.size() - 2], py = x[x.size() - 1];
  int crossed = 0, turns = 0;
  double lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY};
  for (int i = 0; i < count; ++i) {
    const std::size_t at = 1 + 2 * static_cast<std::size_t>(i),
                      next = 1 + 2 * (static_cast<std::size_t>(i + 1) % count);
    const double ax = x[at], ay = x[at + 1], bx = x[next], by = x[next + 1];
    lo[0] = std::min(lo[0], ax), lo[1] = std::min(lo[1], ay), hi[0] = std::max(hi[0], ax), hi[1] = std::max(hi[1], ay);
    if (!c.closed && i == count - 1) break;
    const bool spans = c.both      ? std::min(ay, by) <= py && py <= std::max(ay, by) && ay != by
                       : c.neither ? std::min(ay, by) < py && py < std::max(ay, by)
                                   : (ay > py) != (by > py);
    if (spans && px < (bx - ax) * (py - ay) / (by - ay) + ax) ++crossed, turns += by > ay ? 1 : -1;
  }
  const bool in = c.around    ? lo[0] <= px && px <= hi[0] && lo[1] <= py && py <= hi[1]
                  : c.winding ? turns != 0
                              : crossed % 2 == 1;
  return {true, in ? "in" : "out"};
}

}  // namespace

std::vector<Mistake> ray_mistakes() {
  return {
      {"ray-sphere", "roots behind the ray count", of_quadratic<Quadratic{.behind = true}>},
      {"ray-sphere", "a tangent ray counts as a miss: > for >=", of_quadratic<Quadratic{.tangent = false}>},
      {"ray-sphere", "the second root is not tried: a miss from inside", of_quadratic<Quadratic{.from_inside = false}>},
      {"ray-sphere", "the wrong end: where the ray leaves", of_quadratic<Quadratic{.last = true}>},
      {"ray-sphere", "t = 0 does not count: > for >=", of_quadratic<Quadratic{.origin = false}>},
      {"ray-sphere", "the ball for the sphere: t = 0 from inside", of_quadratic<Quadratic{.solid = true}>},
      {"ray-sphere", "the direction is taken to have length 1", of_quadratic<Quadratic{.unit = true}>},
      {"ray-sphere", "the radius is not squared", of_quadratic<Quadratic{.unsquared = true}>},
      {"ray-sphere", "b b - 4 a c with half of b", of_quadratic<Quadratic{.four = true}>},
      {"ray-sphere", "the usual formula in doubles: roots cancel, squares overflow or vanish",
       of_quadratic<Quadratic{}>},
      {"ray-plane", "the sign of d", of_plane<Plane{.minus = true}>},
      {"ray-plane", "a plane behind the ray counts", of_plane<Plane{.behind = true}>},
      {"ray-plane", "a ray within the plane misses it", of_plane<Plane{.within = false}>},
      {"ray-plane", "a tolerance of 1e-6 for parallel", of_plane<Plane{.tolerance = true}>},
      {"ray-plane", "the sign of t", of_plane<Plane{.turned = true}>},
      {"ray-plane", "t = 0 does not count: > for >=", of_plane<Plane{.origin = false}>},
      {"ray-plane", "the usual formula in doubles: sums round, products overflow or vanish", of_plane<Plane{}>},
      {"ray-aabb", "ends are not swapped for directions below 0", of_slabs<Slabs{.swapped = false}>},
      {"ray-aabb", "t below 0 from inside", of_slabs<Slabs{.clipped = false}>},
      {"ray-aabb", "boxes behind the ray count", of_slabs<Slabs{.clipped = false, .behind = true}>},
      {"ray-aabb", "division by 0: 0 times infinity is no number", of_slabs<Slabs{.parallel = false}>},
      {"ray-aabb", "an open set for a closed one: < for <=", of_slabs<Slabs{.open = true}>},
      {"ray-aabb", "the wrong end: where the ray leaves", of_slabs<Slabs{.exit = true}>},
      {"ray-aabb", "the last axis is left out", of_slabs<Slabs{.axes = 2}>},
      {"ray-triangle", "one side only: triangles seen from behind are culled",
       of_triangle<Barycentric{.culled = true}>},
      {"ray-triangle", "triangles behind the ray count", of_triangle<Barycentric{.behind = true}>},
      {"ray-triangle", "an open set for a closed one: edges do not count", of_triangle<Barycentric{.open = true}>},
      {"ray-triangle", "u + v <= 1 is not tested", of_triangle<Barycentric{.sum = false}>},
      {"ray-triangle", "u and v are not held against 1", of_triangle<Barycentric{.sum = false, .one = false}>},
      {"ray-triangle", "a tolerance of 1e-6, of a number that has no fixed size",
       of_triangle<Barycentric{.tolerance = 1e-6}>},
      {"ray-triangle", "a tolerance of 1e-6, and t above it",
       of_triangle<Barycentric{.tolerance = 1e-6, .t_positive = true}>},
      {"ray-triangle", "t = 0 does not count: > for >=", of_triangle<Barycentric{.t_positive = true}>},
      {"ray-triangle", "the usual method in doubles, in which a ray within the plane misses",
       of_triangle<Barycentric{}>},
      {"crossings", "both ends of an edge count: a corner counts twice", of_crossings<Crossing{.both = true}>},
      {"crossings", "no end of an edge counts: a corner counts for nothing", of_crossings<Crossing{.neither = true}>},
      {"crossings", "the edge from the last corner to the first is left out", of_crossings<Crossing{.closed = false}>},
      {"crossings", "winding numbers for crossings", of_crossings<Crossing{.winding = true}>},
      {"crossings", "the box around the polygon", of_crossings<Crossing{.around = true}>},
      {"crossings", "crossings in doubles that never say on", of_crossings<Crossing{}>},
  };
}

}  // namespace isect::grade
