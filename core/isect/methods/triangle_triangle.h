#pragma once
// Triangle against triangle in space as textbooks have it: by two intervals on the line of both planes, in plain
// floating point, and by the signs of volumes alone. `intersects` in isect/triangle_half_spaces.h is right for all
// input.
//
// Both look first whether one triangle lies on one side of the other's plane. Else both triangles cut the line of the
// two planes, or lie in one plane; there a side of one has the other beyond it, or they meet.

#include <array>
#include <cstddef>
#include <utility>
#include <variant>

#include <isect/orient.h>
#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect {

namespace triangle_triangle {

/// On which side of the other's plane each corner lies: 1 above, where it is seen counter-clockwise, -1 below, 0 in it.
using Signs = std::array<int, 3>;

// clang-format off
/// `of` is 0 for a, 1 for b, in all events. Beside: all corners lie strictly on one side.
template <class S> struct Heights { int of; Vector<S, 3> normal; std::array<S, 3> heights; bool beside; };
struct Sides { int of; Signs signs; bool beside; };
struct InPlane { int axis, of, side; bool apart; };                       ///< seen along the axis: a side, does it part?
template <class S> struct LineOfPlanes { Vector<S, 3> direction; int axis; };   ///< along this axis it is longest
/// Both edges at the corner that is alone cut the line: at these shares of their lengths, from the corner on.
template <class S> struct Cut { int of, alone; std::array<S, 2> shares; Interval<S> interval; };
template <class S> struct Shared { S lo, hi; bool holds; };               ///< what the intervals share: lo <= hi
struct Alone { int of, corner; bool turned; };                            ///< turned: the other one is taken clockwise
struct Ends { int number, sign; bool apart; };                            ///< does one part end before the other begins?
// clang-format on
template <class S>
using IntervalsEvent = std::variant<Heights<S>, InPlane, LineOfPlanes<S>, Cut<S>, Shared<S>>;
using SignsEvent = std::variant<Sides, InPlane, Alone, Ends>;

namespace detail {

template <class S>
Vector<S, 3> cross(const Vector<S, 3>& u, const Vector<S, 3>& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
template <class S>
Vector<S, 3> normal(const Triangle<S, 3>& x) {
  const Vector<S, 3> u = x.vertices[1] - x.vertices[0], v = x.vertices[2] - x.vertices[0];
  return cross<S>(u, v);
}
template <class S>
std::array<S, 3> heights(const Triangle<S, 3>& x, const Vector<S, 3>& n, const Point<S, 3>& foot) {
  std::array<S, 3> all;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector<S, 3> v = x.vertices[i] - foot;
    all[i] = n[0] * v[0] + n[1] * v[1] + n[2] * v[2];
  }
  return all;
}

template <class S>
int sign(const S& x) {
  return x > S(0) ? 1 : x < S(0) ? -1 : 0;
}
template <class S>
Signs signs(const std::array<S, 3>& x) {
  return {sign(x[0]), sign(x[1]), sign(x[2])};
}
inline bool beside(const Signs& s) { return s[0] != 0 && s[0] == s[1] && s[0] == s[2]; }
inline bool all_zero(const Signs& s) { return s[0] == 0 && s[1] == 0 && s[2] == 0; }

/// The corner that the plane parts from the two others, which may lie in it; that in the plane if both others lie on
/// one side. The signs are neither all alike nor all 0.
inline std::size_t alone(const Signs& s) {
  for (std::size_t i = 0; i < 3; ++i) {
    const int j = s[(i + 1) % 3], k = s[(i + 2) % 3];
    if (s[i] == 0 ? j * k > 0 : s[i] * j <= 0 && s[i] * k <= 0) return i;
  }
  return 0;
}

/// The axis along which v is longest.
template <class S>
int longest(const Vector<S, 3>& v) {
  const auto size = [](const S& x) -> S { return x < S(0) ? -x : x; };
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (size(v[i]) > size(v[axis])) axis = i;
  return axis;
}

/// p without a coordinate.
template <class S>
Point<S, 2> seen_along(int axis, const Point<S, 3>& p) {
  return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

/// Whether two triangles in one plane have a common point, as they are seen along an axis: no side of one has all
/// corners of the other beyond it. turn(p, q, r): the sign of their area.
template <class S, class Turn, class Trace>
bool meet_in_plane(const Triangle<S, 3>& a, const Triangle<S, 3>& b, int axis, const Turn& turn, Trace&& trace) {
  std::array<std::array<Point<S, 2>, 3>, 2> seen;
  for (std::size_t i = 0; i < 3; ++i) {
    seen[0][i] = seen_along<S>(axis, a.vertices[i]);
    seen[1][i] = seen_along<S>(axis, b.vertices[i]);
  }
  for (int of = 0; of < 2; ++of) {
    const auto &x = seen[static_cast<std::size_t>(of)], &y = seen[static_cast<std::size_t>(1 - of)];
    const int sense = turn(x[0], x[1], x[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto beyond = [&](const Point<S, 2>& p) { return turn(x[i], x[(i + 1) % 3], p) * sense < 0; };
      const bool apart = beyond(y[0]) && beyond(y[1]) && beyond(y[2]);
      trace(InPlane{axis, of, static_cast<int>(i), apart});
      if (apart) return false;
    }
  }
  return true;
}

/// The part of the line of both planes that lies in the triangle, as its coordinate on an axis.
template <class S, class Trace>
Interval<S> part_of_line(int of, const Triangle<S, 3>& x, const std::array<S, 3>& h, const Signs& s, int axis,
                         Trace&& trace) {
  const std::size_t i = alone(s);
  const S& from = x.vertices[i][axis];
  std::array<S, 2> shares, at;
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t j = (i + 1 + k) % 3;
    shares[k] = h[i] / (h[i] - h[j]);
    at[k] = from + shares[k] * (x.vertices[j][axis] - from);
  }
  const Interval<S> part = at[0] < at[1] ? Interval<S>{at[0], at[1]} : Interval<S>{at[1], at[0]};
  trace(Cut<S>{of, static_cast<int>(i), shares, part});
  return part;
}

/// A triangle that begins with the corner that is alone.
struct Ordered {
  std::array<Point<double, 3>, 3> at;
  bool turned;  ///< the other one has to be taken clockwise, so that this corner lies above it
};
template <class Trace>
Ordered ordered(int of, const Triangle<double, 3>& x, const Signs& s, Trace&& trace) {
  const std::size_t i = alone(s), j = (i + 1) % 3, k = (i + 2) % 3;
  const bool turned = s[i] != 0 ? s[i] < 0 : s[j] > 0;
  trace(Alone{of, static_cast<int>(i), turned});
  return {{x.vertices[i], x.vertices[j], x.vertices[k]}, turned};
}

inline Signs sides(const Triangle<double, 3>& plane, const Triangle<double, 3>& x) {
  const auto& [p, q, r] = plane.vertices;
  return {-orient3d(p, q, r, x.vertices[0]), -orient3d(p, q, r, x.vertices[1]), -orient3d(p, q, r, x.vertices[2])};
}

}  // namespace detail

/// Whether they have a common point, by the intervals in which they cut the line of both planes. Naive: rounding may
/// decide, and a triangle without an area has no plane. Source: Moller, A fast triangle-triangle intersection test, J.
/// Graphics Tools 2 (1997), without its epsilon; in one plane by sides that part them.
template <class S, class Trace = NoTrace>
bool by_intervals(const Triangle<S, 3>& a, const Triangle<S, 3>& b, Trace&& trace = {}) {
  const Vector<S, 3> n_b = detail::normal(b);
  const std::array<S, 3> of_a = detail::heights<S>(a, n_b, b.vertices[0]);
  const Signs sides_a = detail::signs(of_a);
  const bool a_beside = detail::beside(sides_a);
  if constexpr (heard<Trace>) trace(Heights<S>{0, n_b, of_a, a_beside});
  if (a_beside) return false;

  const Vector<S, 3> n_a = detail::normal(a);
  const std::array<S, 3> of_b = detail::heights<S>(b, n_a, a.vertices[0]);
  const Signs sides_b = detail::signs(of_b);
  const bool b_beside = detail::beside(sides_b);
  if constexpr (heard<Trace>) trace(Heights<S>{1, n_a, of_b, b_beside});
  if (b_beside) return false;

  if (detail::all_zero(sides_a) || detail::all_zero(sides_b)) {
    const auto turn = [](const Point<S, 2>& p, const Point<S, 2>& q, const Point<S, 2>& r) {
      return detail::sign<S>((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
    };
    return detail::meet_in_plane(a, b, detail::longest<S>(n_a), turn, trace);
  }

  const Vector<S, 3> direction = detail::cross<S>(n_a, n_b);
  const int axis = detail::longest<S>(direction);
  if constexpr (heard<Trace>) trace(LineOfPlanes<S>{direction, axis});

  const Interval<S> on_a = detail::part_of_line(0, a, of_a, sides_a, axis, trace),
                    on_b = detail::part_of_line(1, b, of_b, sides_b, axis, trace);
  const S lo = on_a.lo < on_b.lo ? on_b.lo : on_a.lo, hi = on_b.hi < on_a.hi ? on_b.hi : on_a.hi;
  const bool holds = lo <= hi;
  trace(Shared<S>{lo, hi, holds});
  return holds;
}

/// Whether they have a common point, by the signs of volumes alone: on the line of both planes two of them tell
/// whether one part ends before the other begins. Exact for triangles that have an area, as it asks isect/orient.h.
/// Source: Guigue, Devillers, Fast and robust triangle-triangle overlap test, J. Graphics Tools 8 (2003).
template <class Trace = NoTrace>
bool by_signs(const Triangle<double, 3>& a, const Triangle<double, 3>& b, Trace&& trace = {}) {
  const Signs of_a = detail::sides(b, a);
  const bool a_beside = detail::beside(of_a);
  trace(Sides{0, of_a, a_beside});
  if (a_beside) return false;

  const Signs of_b = detail::sides(a, b);
  const bool b_beside = detail::beside(of_b);
  trace(Sides{1, of_b, b_beside});
  if (b_beside) return false;

  if (detail::all_zero(of_a)) {
    const auto turn = [](const Point<double, 2>& p, const Point<double, 2>& q, const Point<double, 2>& r) {
      return orient2d(p, q, r);
    };
    const auto flat_along = [&](int axis) {
      return turn(detail::seen_along<double>(axis, a.vertices[0]), detail::seen_along<double>(axis, a.vertices[1]),
                  detail::seen_along<double>(axis, a.vertices[2])) == 0;
    };
    int axis = 0;
    while (axis < 2 && flat_along(axis)) ++axis;
    return detail::meet_in_plane(a, b, axis, turn, trace);
  }

  detail::Ordered x = detail::ordered(0, a, of_a, trace), y = detail::ordered(1, b, of_b, trace);
  if (y.turned) std::swap(x.at[1], x.at[2]);
  if (x.turned) std::swap(y.at[1], y.at[2]);

  const int first = orient3d(y.at[1], y.at[0], x.at[0], x.at[1]);
  trace(Ends{0, first, first > 0});
  if (first > 0) return false;

  const int second = orient3d(y.at[2], y.at[0], x.at[2], x.at[0]);
  trace(Ends{1, second, second > 0});
  return second <= 0;
}

}  // namespace triangle_triangle

}  // namespace isect
