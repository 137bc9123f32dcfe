#pragma once
// Ray against plane by the note's formula, and by a point of the plane, as it is often written: for lessons and
// comparison. `intersect` in isect/ray_plane.h is right for all input.

#include <optional>
#include <variant>

#include <isect/ray_plane.h>

namespace isect::ray_plane {

// clang-format off
template <class S> struct Numerator { S value; };                         ///< n.o + D
template <class S> struct Denominator { S value; };                       ///< n.d
template <class S> struct Parallel { S denominator; bool holds; };        ///< n.d = 0
template <class S> struct Quotient { S t; };                              ///< -(n.o + D) / n.d
template <class S> struct InRange { S t; bool holds; };                   ///< t_min <= t <= t_max
// clang-format on
template <class S>
using TextbookEvent = std::variant<Numerator<S>, Denominator<S>, Parallel<S>, Quotient<S>, InRange<S>>;

/// t by the note's formula, when the range holds it; nothing for a parallel ray, even one in the plane. Naive:
/// rounding may decide, and products overflow beyond 1e154 or vanish. Source: the note, N20.
template <class S, int N, class Trace = NoTrace>
std::optional<S> textbook(const Ray<S, N>& ray, const Plane<S, N>& plane, Trace&& trace = {}) {
  const S numerator = plane.normal.dot(ray.origin) + plane.d;
  trace(Numerator<S>{numerator});

  const S denominator = plane.normal.dot(ray.direction);
  trace(Denominator<S>{denominator});

  const bool parallel = denominator == S(0);
  trace(Parallel<S>{denominator, parallel});
  if (parallel) return {};

  const S t = -numerator / denominator;
  trace(Quotient<S>{t});

  const bool holds = ray.range.contains(t);
  trace(InRange<S>{t, holds});
  if (!holds) return {};
  return t;
}

template <class S, int N>
struct ToPoint {
  Vector<S, N> w;  ///< from the origin of the ray to the point of the plane
};
template <class S, int N>
using MethodEvent = std::variant<ToPoint<S, N>, Numerator<S>, Denominator<S>, Parallel<S>, InRange<S>>;

/// t = n.(p - o) / n.d for a point p of the plane. Far from the frame's origin the difference keeps what n.o + D loses
/// by cancellation, if p is near and on the plane. A ray with |n.d| <= epsilon counts as parallel: 0 means exactly
/// parallel; a larger one, as many write against quotients that overflow, depends on the lengths of n and d and misses
/// planes at a grazing angle. Naive: rounding may decide. Source: Ericson, Real-Time Collision Detection (2005),
/// 5.3.1.
template <class S, int N, class Trace = NoTrace>
std::optional<S> towards_point(const Ray<S, N>& ray, const Vector<S, N>& normal, const Point<S, N>& point,
                               const S& epsilon, Trace&& trace = {}) {
  const Vector<S, N> w = point - ray.origin;
  trace(ToPoint<S, N>{w});

  const S numerator = normal.dot(w);
  trace(Numerator<S>{numerator});

  const S denominator = normal.dot(ray.direction);
  trace(Denominator<S>{denominator});

  const bool parallel = -epsilon <= denominator && denominator <= epsilon;
  trace(Parallel<S>{denominator, parallel});
  if (parallel) return {};

  const S t = numerator / denominator;
  const bool holds = ray.range.contains(t);
  trace(InRange<S>{t, holds});
  if (!holds) return {};
  return t;
}

}  // namespace isect::ray_plane
