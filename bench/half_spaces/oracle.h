#pragma once
// How convex solids lie to each other and to balls, capsules, triangles and rays, in rationals: by their corners, which
// are found by division, and by clipping. All solids are bounded.

#include <algorithm>
#include <optional>
#include <vector>

#include "bench/capsule_capsule/oracle.h"
#include "bench/rational.h"

namespace isect::oracle {

using Place = Coordinates<3>;
/// normal.x + d >= 0
struct Side {
  Place normal;
  Rational d;

  Rational at(const Place& x) const { return dot(normal, x) + d; }
};
using Sides = std::vector<Side>;

inline Sides sides(const Aabb<double, 3>& box) {
  Sides all;
  for (std::size_t i = 0; i < 3; ++i) {
    Place unit = {0, 0, 0};
    unit[i] = 1;
    all.push_back({unit, -Rational(box.lo[i])});
    all.push_back({Rational(-1) * unit, Rational(box.hi[i])});
  }
  return all;
}
/// |s_i| <= half_i, where s is found from x - c = sum s_i u_i by Cramer's rule.
inline Sides sides(const Obb<double, 3>& box) {
  Sides all;
  std::array<Place, 3> u;
  for (int i = 0; i < 3; ++i) u[i] = rational<double, 3>(box.axes.col(i));
  const Place c = rational(box.center);
  const Rational determinant = dot(u[0], cross(u[1], u[2]));
  for (std::size_t i = 0; i < 3; ++i) {
    const Place n = (Rational(1) / determinant) * cross(u[(i + 1) % 3], u[(i + 2) % 3]);  // s_i = n.(x - c)
    const Rational half(box.half[i]);
    all.push_back({n, half - dot(n, c)});
    all.push_back({Rational(-1) * n, half + dot(n, c)});
  }
  return all;
}
inline Sides sides(const Kdop<double, 3>& kdop) {
  Sides all;
  for (std::size_t i = 0; i < kdop.slabs.size(); ++i) {
    const Place n = rational(kdop.normals[i]);
    all.push_back({n, -Rational(kdop.slabs[i].lo)});
    all.push_back({Rational(-1) * n, Rational(kdop.slabs[i].hi)});
  }
  return all;
}
inline Sides sides(const Frustum<double>& frustum) {
  Sides all;
  for (const Plane<double, 3>& plane : frustum.planes) all.push_back({rational(plane.normal), Rational(plane.d)});
  return all;
}
inline Sides both(Sides a, const Sides& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

inline bool holds(const Sides& solid, const Place& x) {
  return std::ranges::all_of(solid, [&](const Side& s) { return s.at(x) >= 0; });
}

inline std::optional<Place> meeting(const Side& p, const Side& q, const Side& r) {
  const Place qr = cross(q.normal, r.normal);
  const Rational determinant = dot(p.normal, qr);
  if (determinant == 0) return {};
  return Rational(-1) / determinant * (p.d * qr + q.d * cross(r.normal, p.normal) + r.d * cross(p.normal, q.normal));
}

inline std::vector<Place> corners(const Sides& solid) {
  std::vector<Place> all;
  for (std::size_t i = 0; i < solid.size(); ++i)
    for (std::size_t j = i + 1; j < solid.size(); ++j)
      for (std::size_t k = j + 1; k < solid.size(); ++k)
        if (const auto x = meeting(solid[i], solid[j], solid[k]); x && holds(solid, *x)) all.push_back(*x);
  return all;
}
/// Whether x is interior to the solid: strictly inside each face, except those faces that hold the whole solid.
inline bool holds_within(const Sides& solid, const Place& x) {
  const std::vector<Place> all = corners(solid);
  return std::ranges::all_of(solid, [&](const Side& s) {
    return s.at(x) > 0 || (s.at(x) == 0 && std::ranges::all_of(all, [&](const Place& c) { return s.at(c) == 0; }));
  });
}
/// The mean of the corners, which lies in their relative interior.
inline Place middle(const std::vector<Place>& corners) {
  Place sum = {0, 0, 0};
  for (const Place& c : corners) sum = sum + c;
  return Rational(1) / Rational(static_cast<int>(corners.size())) * sum;
}

inline Relation relation(const Sides& a, const Sides& b) {
  const std::vector<Place> common = corners(both(a, b));
  if (common.empty()) return Relation::disjoint;
  const auto inside = [](const Sides& x, const Sides& y) {
    return std::ranges::all_of(corners(x), [&](const Place& c) { return holds(y, c); });
  };
  const bool a_in_b = inside(a, b), b_in_a = inside(b, a);
  if (a_in_b) return b_in_a ? Relation::equal : Relation::a_inside_b;
  if (b_in_a) return Relation::b_inside_a;
  const Place inner = middle(common);
  return holds_within(a, inner) && holds_within(b, inner) ? Relation::overlapping : Relation::touching;
}

/// The squared distance: the least to any candidate point that the solid holds. Candidates are the feet of
/// perpendiculars on its planes and on the lines of two planes, and its corners.
inline Rational distance2(const Place& x, const Sides& solid) {
  if (holds(solid, x)) return 0;
  std::optional<Rational> least;
  const auto take = [&](const Place& foot) {
    if (!holds(solid, foot)) return;
    const Rational d2 = distance2<3>(foot, x);
    if (!least || d2 < *least) least = d2;
  };
  for (const Place& corner : corners(solid)) take(corner);
  for (std::size_t i = 0; i < solid.size(); ++i) {
    const Place& n = solid[i].normal;
    if (dot(n, n) != 0) take(x - (solid[i].at(x) / dot(n, n)) * n);
    for (std::size_t j = i + 1; j < solid.size(); ++j) {
      const Place along = cross(n, solid[j].normal);
      const Side across = {along, -dot(along, x)};
      if (const auto foot = meeting(solid[i], solid[j], across)) take(*foot);
    }
  }
  return *least;
}

/// The part of p + t (q - p), 0 <= t <= 1, that lies in the solid.
inline std::optional<std::pair<Rational, Rational>> part(const Place& p, const Place& q, const Sides& solid,
                                                         Rational lo = 0, Rational hi = 1) {
  for (const Side& side : solid) {
    const Rational start = side.at(p), rate = dot(side.normal, q - p);
    if (rate == 0 && start < 0) return {};
    if (rate > 0) lo = std::max<Rational>(lo, -start / rate);
    if (rate < 0) hi = std::min<Rational>(hi, -start / rate);
  }
  if (lo > hi) return {};
  return std::pair(lo, hi);
}

inline Rational distance2(const Stretch<3>& segment, const Sides& solid) {
  const Place p = segment.p, q = segment.at(1);
  if (part(p, q, solid)) return 0;
  Rational least = std::min(distance2(p, solid), distance2(q, solid));
  const std::vector<Place> all = corners(solid);
  for (const Place& a : all)
    for (const Place& b : all) least = std::min(least, distance2<3>(segment, Stretch<3>{a, b - a}));
  return least;
}

/// How a capsule and a solid lie; p = q makes the capsule a ball.
inline Relation relation(const Capsule<double, 3>& capsule, const Sides& solid) {
  const Rational r(capsule.radius);
  const std::vector<Place> all = corners(solid);
  if (r < 0 || all.empty()) return Relation::disjoint;
  const Stretch<3> s = stretch(capsule);
  const Rational d2 = distance2(s, solid);
  if (d2 > r * r) return Relation::disjoint;
  const bool a_in_b = std::ranges::all_of(solid, [&](const Side& side) {
    return std::ranges::all_of(std::array{s.p, s.at(1)}, [&](const Place& x) {
      return side.at(x) >= 0 && side.at(x) * side.at(x) >= r * r * dot(side.normal, side.normal);
    });
  });
  const bool b_in_a = std::ranges::all_of(all, [&](const Place& c) { return distance2<3>(c, s) <= r * r; });
  if (a_in_b) return b_in_a ? Relation::equal : Relation::a_inside_b;
  if (b_in_a) return Relation::b_inside_a;
  if (r > 0) return d2 == r * r ? Relation::touching : Relation::overlapping;
  const auto [lo, hi] = *part(s.p, s.at(1), solid);
  const Rational t = (lo + hi) / 2;
  return 0 < t && t < 1 && holds_within(solid, s.at(t)) ? Relation::overlapping : Relation::touching;
}

/// The part of the triangle that is left, clipped by one side after the other.
inline std::vector<Place> clipped(const Triangle<double, 3>& triangle, const Sides& solid) {
  std::vector<Place> left;
  for (const auto& v : triangle.vertices) left.push_back(rational(v));
  for (const Side& side : solid) {
    std::vector<Place> next;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const Place &p = left[i], &q = left[(i + 1) % left.size()];
      const Rational at_p = side.at(p), at_q = side.at(q);
      if (at_p >= 0) next.push_back(p);
      if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) next.push_back(p + (at_p / (at_p - at_q)) * (q - p));
    }
    left = next;
  }
  return left;
}
/// Its plane twice, and a side for each edge; the triangle has an area.
inline Sides sides(const Triangle<double, 3>& triangle) {
  std::array<Place, 3> v;
  for (std::size_t i = 0; i < 3; ++i) v[i] = rational(triangle.vertices[i]);
  const Place n = cross(v[1] - v[0], v[2] - v[0]);
  Sides all = {{n, -dot(n, v[0])}, {Rational(-1) * n, dot(n, v[0])}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Place inward = cross(n, v[(i + 1) % 3] - v[i]);
    all.push_back({inward, -dot(inward, v[i])});
  }
  return all;
}

/// Decides by what clipping leaves of the triangle or, if the solid has no volume, by the corners of what both have in
/// common.
inline Relation relation(const Triangle<double, 3>& triangle, const Sides& solid) {
  const std::vector<Place> all = corners(solid);
  if (all.empty()) return Relation::disjoint;
  std::array<Place, 3> v;
  for (std::size_t i = 0; i < 3; ++i) v[i] = rational(triangle.vertices[i]);
  const Place n = cross(v[1] - v[0], v[2] - v[0]);
  if (dot(n, n) == 0) {  // the segment between the corners that are farthest apart
    std::size_t from = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (distance2<3>(v[i], v[(i + 1) % 3]) > distance2<3>(v[from], v[(from + 1) % 3])) from = i;
    return relation(Capsule<double, 3>{triangle.vertices[from], triangle.vertices[(from + 1) % 3], 0}, solid);
  }
  const Place inner = middle(all);
  if (!std::ranges::all_of(solid, [&](const Side& s) { return s.at(inner) > 0; }))
    return relation(sides(triangle), solid);
  const std::vector<Place> left = clipped(triangle, solid);
  if (left.empty()) return Relation::disjoint;
  if (std::ranges::all_of(v, [&](const Place& x) { return holds(solid, x); })) return Relation::a_inside_b;
  return holds_within(solid, middle(left)) ? Relation::overlapping : Relation::touching;
}

}  // namespace isect::oracle
