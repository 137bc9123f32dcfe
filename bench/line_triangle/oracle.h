#pragma once
// Where a line first meets a triangle in space, in rationals: the least of all candidate t whose point lies in the
// triangle, by its weights, or on an edge. Each candidate is tried.

#include <optional>
#include <vector>

#include "bench/rational.h"

namespace isect::oracle {

using Corners = std::array<Coordinates<3>, 3>;

inline bool on_segment(const Coordinates<3>& x, const Coordinates<3>& a, const Coordinates<3>& b) {
  const Coordinates<3> f = x - a, d = b - a, off = cross(f, d);
  return dot(off, off) == 0 && dot(f, d) >= 0 && dot(f, d) <= dot(d, d) && (dot(d, d) != 0 || dot(f, f) == 0);
}
inline bool in_triangle(const Coordinates<3>& x, const Corners& v) {
  for (std::size_t i = 0; i < 3; ++i)
    if (on_segment(x, v[i], v[(i + 1) % 3])) return true;
  const Coordinates<3> n = cross(v[1] - v[0], v[2] - v[0]);
  const Rational nn = dot(n, n);
  if (nn == 0 || dot(n, x - v[0]) != 0) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if (dot(cross(v[(i + 1) % 3] - v[i], x - v[i]), n) / nn < 0) return false;
  return true;
}

/// The line must have a direction.
inline std::optional<Rational> first_hit(const Coordinates<3>& o, const Coordinates<3>& d,
                                         const Interval<double>& range, const Corners& v) {
  std::vector<Rational> candidates;
  if (std::isfinite(range.lo)) candidates.push_back(Rational(range.lo));
  const Coordinates<3> n = cross(v[1] - v[0], v[2] - v[0]);
  if (dot(n, d) != 0) candidates.push_back(dot(n, v[0] - o) / dot(n, d));
  for (std::size_t i = 0; i < 3; ++i) {
    const Coordinates<3> w = v[i] - o, e = v[(i + 1) % 3] - v[i];
    candidates.push_back(dot(w, d) / dot(d, d));
    const Rational dd = dot(d, d), de = dot(d, e), ee = dot(e, e), determinant = dd * ee - de * de;
    if (determinant != 0) candidates.push_back((dot(w, d) * ee - de * dot(w, e)) / determinant);
  }
  std::optional<Rational> first;
  for (const Rational& t : candidates)
    if (holds(range, t) && (!first || t < *first) && in_triangle(o + t * d, v)) first = t;
  return first;
}

template <class S>
Corners corners(const Triangle<S, 3>& x) {
  return {rational<S, 3>(x.vertices[0]), rational<S, 3>(x.vertices[1]), rational<S, 3>(x.vertices[2])};
}

}  // namespace isect::oracle
