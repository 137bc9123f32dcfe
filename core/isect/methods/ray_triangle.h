#pragma once
// Ray against triangle in plain floating point, as renderers do, by Cramer's rule or by signed volumes: for lessons and
// comparison. `intersect` in isect/ray_triangle.h is right for all input.
//
// By volumes two triangles that share an edge ask for its sign with the same numbers, so that a line may not slip
// between them; but rounding may give any sign to an edge that the line passes through, and a 0 belongs to both.

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include <isect/ray_triangle.h>

namespace isect::ray_triangle {

// clang-format off
template <class S> struct Determinant { S value; };                       ///< (d x e2).e1
template <class S> struct WeightU { S value; bool holds; };               ///< 0 <= u <= 1
template <class S> struct WeightV { S value; bool holds; };               ///< 0 <= v, u + v <= 1
template <class S> struct InRange { S t; bool holds; };                   ///< t_min <= t <= t_max
// clang-format on
template <class S>
using MollerTrumboreEvent = std::variant<Determinant<S>, WeightU<S>, WeightV<S>, InRange<S>>;

/// t and the weights by Cramer's rule. Naive: rounding may decide, and a ray through an edge that two triangles share
/// may miss both. Source: Moller, Trumbore, Fast, minimum storage ray-triangle intersection, J. Graphics Tools 2
/// (1997).
template <class S, class Trace = NoTrace>
std::optional<Hit<S>> moller_trumbore(const Ray<S, 3>& ray, const Triangle<S, 3>& triangle, Trace&& trace = {}) {
  const auto& [a, b, c] = triangle.vertices;
  const Vector<S, 3> e1 = b - a, e2 = c - a, p = ray.direction.cross(e2);
  const S determinant = p.dot(e1);
  trace(Determinant<S>{determinant});
  if (determinant == S(0)) return {};

  const Vector<S, 3> from = ray.origin - a;
  const S u = from.dot(p) / determinant;
  const bool u_holds = S(0) <= u && u <= S(1);
  trace(WeightU<S>{u, u_holds});
  if (!u_holds) return {};

  const Vector<S, 3> q = from.cross(e1);
  const S v = ray.direction.dot(q) / determinant;
  const bool v_holds = S(0) <= v && u + v <= S(1);
  trace(WeightV<S>{v, v_holds});
  if (!v_holds) return {};

  const S t = e2.dot(q) / determinant;
  const bool holds = ray.range.contains(t);
  trace(InRange<S>{t, holds});
  if (!holds) return {};
  return Hit<S>{t, u, v};
}

// clang-format off
template <class S> struct SignedVolumes { S a, b, c; bool holds; };       ///< no two of opposite signs
template <class S> struct Sheared { Vector<S, 3> shear; int x, y, z; };   ///< axes; the ray is steepest along z
template <class S> struct Corner { int index; S x, y; };                  ///< relative to the origin, after the shear
// clang-format on
template <class S>
using VolumesEvent = std::variant<SignedVolumes<S>, Determinant<S>, InRange<S>, Sheared<S>, Corner<S>>;

namespace detail {

/// Turns weights that are not divided yet and t times their sum into the hit, if the range holds it.
template <class S, class Trace>
std::optional<Hit<S>> divided(S b, S c, S sum, S t_sum, const Interval<S>& range, Trace&& trace) {
  trace(Determinant<S>{sum});
  if (sum == S(0)) return {};
  const S t = t_sum / sum;
  const bool holds = range.contains(t);
  trace(InRange<S>{t, holds});
  if (!holds) return {};
  return Hit<S>{t, b / sum, c / sum};
}

/// Whether weights have no two opposite signs; NaN has none.
template <class S>
bool agree(S a, S b, S c) {
  return (a >= S(0) && b >= S(0) && c >= S(0)) || (a <= S(0) && b <= S(0) && c <= S(0));
}

}  // namespace detail

/// Uses d.(B x C), d.(C x A), d.(A x B) with A, B, C relative to the origin of the ray. Source: Ericson, Real-Time
/// Collision Detection (2005), 5.3.4; Amanatides, Choi, Ray tracing triangular meshes (1997).
template <class S, class Trace = NoTrace>
std::optional<Hit<S>> signed_volumes(const Ray<S, 3>& ray, const Triangle<S, 3>& triangle, Trace&& trace = {}) {
  const Vector<S, 3> a = triangle.vertices[0] - ray.origin, b = triangle.vertices[1] - ray.origin,
                     c = triangle.vertices[2] - ray.origin;
  const S w_a = ray.direction.dot(b.cross(c)), w_b = ray.direction.dot(c.cross(a)), w_c = ray.direction.dot(a.cross(b));
  const bool holds = detail::agree(w_a, w_b, w_c);
  trace(SignedVolumes<S>{w_a, w_b, w_c, holds});
  if (!holds) return {};

  const Vector<S, 3> n =
      (triangle.vertices[1] - triangle.vertices[0]).cross(triangle.vertices[2] - triangle.vertices[0]);
  const S heading = n.dot(ray.direction);
  trace(Determinant<S>{heading});
  if (heading == S(0)) return {};
  const S t = n.dot(a) / heading;
  const bool in_range = ray.range.contains(t);
  trace(InRange<S>{t, in_range});
  if (!in_range) return {};
  const S sum = w_a + w_b + w_c;
  return Hit<S>{t, w_b / sum, w_c / sum};
}

/// Signed volumes after a shear that turns the ray onto an axis, so that three 2D cross products remain. Source: Woop,
/// Benthin, Wald, Watertight ray/triangle intersection, J. Computer Graphics Techniques 2 (2013), without its
/// fallback to double for a product of 0.
template <class S, class Trace = NoTrace>
std::optional<Hit<S>> woop(const Ray<S, 3>& ray, const Triangle<S, 3>& triangle, Trace&& trace = {}) {
  using std::abs;
  int z = 0;  // the axis along which the ray is steepest
  for (int i = 1; i < 3; ++i)
    if (abs(ray.direction[i]) > abs(ray.direction[z])) z = i;
  const S along = ray.direction[z];
  int x = (z + 1) % 3, y = (z + 2) % 3;
  if (along < S(0)) std::swap(x, y);  // the winding stays
  const Vector<S, 3> shear(ray.direction[x] / along, ray.direction[y] / along, S(1) / along);
  trace(Sheared<S>{shear, x, y, z});

  Vector<S, 3> corner[3];
  for (int i = 0; i < 3; ++i) {
    const Vector<S, 3> p = triangle.vertices[i] - ray.origin;
    corner[i] = {p[x] - shear[0] * p[z], p[y] - shear[1] * p[z], shear[2] * p[z]};
    trace(Corner<S>{i, corner[i][0], corner[i][1]});
  }
  const auto& [a, b, c] = corner;
  const S w_a = c[0] * b[1] - c[1] * b[0], w_b = a[0] * c[1] - a[1] * c[0], w_c = b[0] * a[1] - b[1] * a[0];
  const bool holds = detail::agree(w_a, w_b, w_c);
  trace(SignedVolumes<S>{w_a, w_b, w_c, holds});
  if (!holds) return {};

  return detail::divided(w_b, w_c, w_a + w_b + w_c, w_a * a[2] + w_b * b[2] + w_c * c[2], ray.range, trace);
}

}  // namespace isect::ray_triangle
