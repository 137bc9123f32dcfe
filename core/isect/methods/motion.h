#pragma once
// Moving objects as the note and others test them, for lessons and comparison: time after time, by the times on each
// axis, by a quadratic, by steps too short for a contact. `contact` and `first_contact` in isect/many/motion.h are
// right for all input.
//
// All count touching. Rounding may decide where objects touch in passing; squares overflow or vanish beyond 1e+-150 in
// double. Empty shapes, NaN and infinite coordinates are not looked for.

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>
#include <vector>

#include <isect/many/motion.h>

namespace isect {

/// The times at which the shapes meet, of 0, duration / steps, 2 duration / steps, ... duration. Naive: what is
/// between two times is missed, and places are rounded.
template <template <class, int> class Shape, class S, int N, class Trace = NoTrace>
std::vector<S> discrete_hits(const Moving<Shape, S, N>& a, const Moving<Shape, S, N>& b, S duration, int steps,
                             Trace&& trace = {}) {
  std::vector<S> hits;
  for (int k = 0; k <= steps; ++k) {
    const S time = k == steps ? duration : duration * static_cast<S>(k) / static_cast<S>(steps);
    const Vector<S, N> way_a = a.velocity * time, way_b = b.velocity * time;
    const bool meet = intersects(motion::moved(a.shape, way_a), motion::moved(b.shape, way_b));
    trace(motion::At<S>{time, meet});
    if (meet) hits.push_back(time);
  }
  return hits;
}

namespace motion {

// clang-format off
template <class S, int N> struct Relative { Vector<S, N> d; };    ///< the velocity of b, seen from a
struct Level { int axis; bool apart; };                           ///< d_i = 0, and whether the extents are apart
template <class S> struct AxisTimes { int axis; S begin, end; };  ///< when the extents on this axis share points
template <class S> struct Left { S begin, end; bool holds; };     ///< the times left so far; whether there are any
// clang-format on
template <class S, int N>
using AxesEvent = std::variant<Relative<S, N>, Level, AxisTimes<S>, Left<S>>;

}  // namespace motion

/// The times from 0 to duration at which the boxes meet: those that all axes share. Naive: rounding may decide.
/// Source: Ericson, Real-Time Collision Detection (2005), 5.5.8.
template <class S, int N, class Trace = NoTrace>
std::optional<Interval<S>> contact_by_axes(const Moving<Aabb, S, N>& a, const Moving<Aabb, S, N>& b, S duration,
                                           Trace&& trace = {}) {
  const Vector<S, N> d = b.velocity - a.velocity;
  trace(motion::Relative<S, N>{d});

  S begin = S(0), end = duration;
  for (int i = 0; i < N; ++i) {
    const S lo = a.shape.lo[i] - b.shape.hi[i], hi = a.shape.hi[i] - b.shape.lo[i];
    if (d[i] == S(0)) {
      const bool apart = lo > S(0) || hi < S(0);
      trace(motion::Level{i, apart});
      if (apart) return {};
      continue;
    }

    const S at_lo = lo / d[i], at_hi = hi / d[i];
    const S first = std::min(at_lo, at_hi), last = std::max(at_lo, at_hi);
    trace(motion::AxisTimes<S>{i, first, last});

    begin = std::max(begin, first), end = std::min(end, last);
    const bool holds = begin <= end;
    trace(motion::Left<S>{begin, end, holds});
    if (!holds) return {};
  }
  if (!(begin <= end)) return {};
  return Interval<S>{begin, end};
}

namespace motion {

// clang-format off
template <class S, int N> struct Offset { Vector<S, N> f; S reach, c; };  ///< f = b - a, R = r + s, C = f.f - R^2
template <class S> struct Receding { S b; };                              ///< B = f.d
template <class S> struct Passing { S a, discriminant; };                 ///< A = d.d, B^2 - A C
template <class S> struct Entry { S t; bool late; };                      ///< the smaller root; whether it is too late
// clang-format on
template <class S, int N>
using QuadraticEvent = std::variant<Relative<S, N>, Offset<S, N>, Receding<S>, Passing<S>, Entry<S>>;

}  // namespace motion

/// The first time from 0 to duration at which the balls meet: a ray against a sphere. Naive: rounding may decide, and
/// the root cancels near contact. Source: Ericson, Real-Time Collision Detection (2005), 5.5.5.
template <class S, int N, class Trace = NoTrace>
std::optional<S> contact_by_quadratic(const Moving<Sphere, S, N>& a, const Moving<Sphere, S, N>& b, S duration,
                                      Trace&& trace = {}) {
  const Vector<S, N> d = b.velocity - a.velocity;
  trace(motion::Relative<S, N>{d});

  const Vector<S, N> f = b.shape.center - a.shape.center;
  const S reach = a.shape.radius + b.shape.radius, c = f.dot(f) - reach * reach;
  trace(motion::Offset<S, N>{f, reach, c});
  if (c <= S(0)) return S(0);

  const S half_b = f.dot(d);
  trace(motion::Receding<S>{half_b});
  if (!(half_b < S(0))) return {};

  const S square = d.dot(d), discriminant = half_b * half_b - square * c;
  trace(motion::Passing<S>{square, discriminant});
  if (!(discriminant >= S(0))) return {};

  using std::sqrt;
  const S t = (-half_b - sqrt(discriminant)) / square;
  const bool late = !(t <= duration);
  trace(motion::Entry<S>{t, late});
  if (late) return {};
  return t;
}

namespace motion {

/// By how much the distance of two balls falls at most in a unit of time: by the relative speed, or by its part along
/// the line of centers alone. Measured along the direction of that line, the gap closes at this rate for all time.
enum class Bound { speed, along_centers };

// clang-format off
template <class S> struct Gap { S time, distance; bool near; };  ///< whether it is within the tolerance
template <class S> struct Pace { S speed; };                     ///< by which the distance falls at most
template <class S> struct Advance { S time; bool late; };        ///< before this time there is no contact
// clang-format on
template <class S>
using AdvancementEvent = std::variant<Gap<S>, Pace<S>, Advance<S>>;

/// How conservative advancement ends: at a time at which the balls are within the tolerance, not touching perhaps; with
/// no such time by the duration; or open, after as many steps as are allowed.
enum class Ending { near, none, open };
template <class S>
struct Advanced {
  Ending ending;
  S time;
  int steps;
};

}  // namespace motion

/// Steps in time, each as long as the distance takes to close at the bound: but for rounding none leads past a contact.
/// Source: Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems (1996).
template <class S, int N, class Trace = NoTrace>
motion::Advanced<S> advance_conservatively(const Moving<Sphere, S, N>& a, const Moving<Sphere, S, N>& b, S duration,
                                           S tolerance, motion::Bound bound, int most, Trace&& trace = {}) {
  using motion::Ending;
  using std::sqrt;
  const Vector<S, N> f = b.shape.center - a.shape.center, d = b.velocity - a.velocity;
  const S reach = a.shape.radius + b.shape.radius;
  S t = S(0);
  for (int k = 0; k < most; ++k) {
    const Vector<S, N> way = f + t * d;
    const S length = sqrt(way.dot(way)), distance = length - reach;
    const bool near = distance <= tolerance;
    trace(motion::Gap<S>{t, distance, near});
    if (near) return {Ending::near, t, k};

    const S speed = bound == motion::Bound::speed ? sqrt(d.dot(d)) : -way.dot(d) / length;
    trace(motion::Pace<S>{speed});
    if (!(speed > S(0))) return {Ending::none, t, k};

    t = t + distance / speed;
    const bool late = !(t <= duration);
    trace(motion::Advance<S>{t, late});
    if (late) return {Ending::none, t, k + 1};
  }
  return {Ending::open, t, most};
}

}  // namespace isect
