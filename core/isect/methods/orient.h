#pragma once
// The orientation of three points as it is usually written, in plain floating point: what is taught and compared.
// `orient2d` in isect/orient.h is right for all input.
//
// Each returns twice the signed area of a b c, as computed: positive when they turn counter-clockwise. Naive: near a
// line rounding may decide, and products overflow or vanish beyond 1e+-150 in double; NaN is no side.

#include <cmath>
#include <variant>

#include <isect/shapes.h>
#include <isect/trace.h>

namespace isect::orient {

/// The corner that becomes the origin.
enum class Corner { a, b, c };

// Events: the values of one line.
// clang-format off
template <class S> struct Pivot { Corner corner; Vector<S, 2> first, second; };  ///< to the next two corners
template <class S> struct Products { S first, second; };
template <class S> struct Partial { int terms; S sum; };                         ///< of the expanded form so far
template <class S> struct Residue { S product, rest; };                          ///< rest: lost in rounding
template <class S> struct Area2 { S area2; };
// clang-format on
template <class S>
using NaiveEvent = std::variant<Pivot<S>, Products<S>, Partial<S>, Residue<S>, Area2<S>>;

namespace detail {

/// The two vectors from one corner to the next ones around.
template <class S, class Trace>
Pivot<S> pivot(const Point<S, 2>& a, const Point<S, 2>& b, const Point<S, 2>& c, Corner corner, Trace&& trace) {
  const Point<S, 2>& o = corner == Corner::a ? a : corner == Corner::b ? b : c;
  const Point<S, 2>& p = corner == Corner::a ? b : corner == Corner::b ? c : a;
  const Point<S, 2>& q = corner == Corner::a ? c : corner == Corner::b ? a : b;
  const Pivot<S> v = {corner, p - o, q - o};
  trace(v);
  return v;
}

}  // namespace detail

/// The cross product of the vectors from one corner. Which corner decides where it is wrong: the differences from a
/// far corner are rounded, those from a near one are not.
/// Source: Kettner, Mehlhorn, Pion, Schirra, Yap, Classroom examples of robustness problems in geometric computations,
/// Comput. Geom. 40 (2008).
template <Corner corner, class S, class Trace = NoTrace>
S pivoted(const Point<S, 2>& a, const Point<S, 2>& b, const Point<S, 2>& c, Trace&& trace = {}) {
  const Pivot<S> v = detail::pivot(a, b, c, corner, trace);
  const S first = v.first[0] * v.second[1], second = v.first[1] * v.second[0];
  trace(Products<S>{first, second});

  const S area2 = first - second;
  trace(Area2<S>{area2});
  return area2;
}

/// The determinant of the coordinates with a row of ones, multiplied out: six products. Loses what the differences
/// keep far from the origin, and may turn three equal points. Source: de Berg et al., Computational Geometry (2008),
/// exercise 1.4.
template <class S, class Trace = NoTrace>
S expanded(const Point<S, 2>& a, const Point<S, 2>& b, const Point<S, 2>& c, Trace&& trace = {}) {
  S sum = a[0] * b[1] - a[1] * b[0];
  trace(Partial<S>{2, sum});

  sum = sum + b[0] * c[1] - b[1] * c[0];
  trace(Partial<S>{4, sum});

  sum = sum + c[0] * a[1] - c[1] * a[0];
  trace(Area2<S>{sum});
  return sum;
}

/// The corner c as the pivot, and the difference of products by Kahan's method: within 1.5 ulp for the vectors to the
/// other two, where no product overflows and none comes within a factor of 1/eps of the least normal number; but those
/// vectors are rounded before. std::fma is an instruction only where the program is compiled for one. Elsewhere it is
/// a call of the C library: four times the price of `pivoted` if the machine has the instruction after all, some 400
/// times if the library must emulate it (glibc 2.36, measured by hiding it: glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2).
/// Source: Jeannerod, Louvet, Muller, Further analysis of Kahan's algorithm for the accurate computation of 2 x 2
/// determinants, Math. Comput. 82 (2013).
template <class S, class Trace = NoTrace>
S fused(const Point<S, 2>& a, const Point<S, 2>& b, const Point<S, 2>& c, Trace&& trace = {}) {
  const Pivot<S> v = detail::pivot(a, b, c, Corner::c, trace);
  const S product = v.first[1] * v.second[0];
  const S rest = std::fma(-v.first[1], v.second[0], product);
  trace(Residue<S>{product, rest});

  const S area2 = std::fma(v.first[0], v.second[1], -product) + rest;
  trace(Area2<S>{area2});
  return area2;
}

}  // namespace isect::orient
