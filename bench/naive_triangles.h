#pragma once
// Triangles in naive code with doubles: nearest points by regions, crossings by Möller and Trumbore.

#include <algorithm>

#include <isect/triangle_mesh.h>

namespace isect::bench::naive {

using P = Point<double, 3>;
using Vec = Vector<double, 3>;
using Three = Triangle<double, 3>;

/// The nearest point of the triangle, by the region that p lies in (Ericson, 2005, 5.1.5).
inline P nearest(const P& p, const Three& x) {
  const auto& [a, b, c] = x.vertices;
  const Vec ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d1 <= 0 && d2 <= 0) return a;
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const double whole = va + vb + vc;
  return a + vb / whole * ab + vc / whole * ac;
}
inline bool meet(const Sphere<double, 3>& ball, const Three& x) {
  return (nearest(ball.center, x) - ball.center).squaredNorm() <= ball.radius * ball.radius;
}

/// The squared distance of two segments (5.1.9).
inline double distance2(const P& p1, const P& q1, const P& p2, const P& q2) {
  const Vec d1 = q1 - p1, d2 = q2 - p2, r = p1 - p2;
  const double a = d1.squaredNorm(), e = d2.squaredNorm(), f = d2.dot(r), c = d1.dot(r), b = d1.dot(d2);
  const double determinant = a * e - b * b;
  double s = a > 0 && e > 0 && determinant != 0 ? std::clamp((b * f - c * e) / determinant, 0., 1.) : 0;
  double t = e > 0 ? (b * s + f) / e : 0;
  if (t < 0) t = 0, s = a > 0 ? std::clamp(-c / a, 0., 1.) : 0;
  if (t > 1) t = 1, s = a > 0 ? std::clamp((b - c) / a, 0., 1.) : 0;
  return (p1 + s * d1 - (p2 + t * d2)).squaredNorm();
}
/// Whether p + t d, with t from 0 to `most`, passes through the triangle.
inline bool crosses(const P& p, const Vec& d, double most, const Three& x) {
  const auto& [a, b, c] = x.vertices;
  const Vec e1 = b - a, e2 = c - a, h = d.cross(e2), f = p - a, g = f.cross(e1);
  const double determinant = e1.dot(h);
  if (determinant == 0) return false;
  const double u = f.dot(h) / determinant, v = d.dot(g) / determinant, t = e2.dot(g) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && 0 <= t && t <= most;
}
inline bool meet(const Capsule<double, 3>& s, const Three& x) {
  const auto& [a, b, c] = x.vertices;
  const double d2 = std::min({(nearest(s.p, x) - s.p).squaredNorm(), (nearest(s.q, x) - s.q).squaredNorm(),
                              distance2(s.p, s.q, a, b), distance2(s.p, s.q, b, c), distance2(s.p, s.q, c, a)});
  return d2 <= s.radius * s.radius || crosses(s.p, s.q - s.p, 1, x);
}

/// Whether a ray along x crosses an odd number of triangles.
inline bool inside(const P& p, const TriangleMesh<double>& mesh) {
  bool odd = false;
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i)
    odd ^= crosses(p, {1, 0, 0}, std::numeric_limits<double>::infinity(), triangle(mesh, i));
  return odd;
}

}  // namespace isect::bench::naive
