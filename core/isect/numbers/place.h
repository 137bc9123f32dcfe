#pragma once
// A place on a line as the number that it is, a quotient or a root of a quadratic polynomial, so that any two can be
// put in order exactly, even where their doubles are the same, or too near to tell.
//
// The sign of n + a + b, for a whole number n and two roots a and b, needs no root: where terms have opposite signs,
// their squares are compared instead, a^2 with b^2, then (a + b)^2 = a^2 + b^2 + 2 a b with n^2, and where a b is no
// whole number that once more. Source: Devillers, Fronville, Mourrain, Teillaud, Algebraic methods and arithmetic
// filtering for exact predicates on circle arcs, Computational Geometry 22 (2002).

#include <utility>

#include <isect/numbers/exact.h>

namespace isect {

/// t = (num + side sqrt(square)) / den; den > 0, square >= 0, side is -1, 0 or 1.
struct Place {
  Exact num, den = 1.0;
  int side = 0;
  Exact square = {};
};

/// num / den, den != 0.
inline Place quotient_at(Exact num, Exact den) {
  return den.sign() < 0 ? Place{-std::move(num), -std::move(den)} : Place{std::move(num), std::move(den)};
}
inline Place place_at(double t) { return {Exact(t)}; }

namespace detail {

/// side sqrt(square)
struct SquareRoot {
  int side;
  Exact square;

  int sign() const { return side * square.sign(); }
};

/// The sign of n + a + b.
inline int sign_of_sum(const Exact& n, const SquareRoot& a, const SquareRoot& b) {
  const int roots =
      a.sign() * b.sign() >= 0 ? (a.sign() != 0 ? a.sign() : b.sign()) : a.sign() * (a.square - b.square).sign();
  if (n.sign() * roots >= 0) return roots != 0 ? roots : n.sign();

  // (a + b)^2 - n^2 = rest + 2 a b
  const Exact rest = a.square + b.square - n * n, product = a.square * b.square;
  const int mixed = a.sign() * b.sign();
  const int larger = rest.sign() * mixed >= 0 ? (rest.sign() != 0 ? rest.sign() : mixed)
                                              : rest.sign() * (rest * rest - Exact(4.0) * product).sign();
  return larger == 0 ? 0 : larger > 0 ? roots : -roots;
}

}  // namespace detail

/// The sign of x less y.
inline int compare(const Place& x, const Place& y) {
  const Exact n = x.num * y.den - y.num * x.den;
  if (x.side == 0 && y.side == 0) return n.sign();
  const auto root = [](int side, const Place& p, const Exact& times) {
    return side == 0 ? detail::SquareRoot{0, {}} : detail::SquareRoot{side, p.square * times * times};
  };
  return detail::sign_of_sum(n, root(x.side, x, y.den), root(-y.side, y, x.den));
}

/// The double nearest to a place that is a quotient, up to a relative 2^-100; infinite beyond the largest.
inline double nearest(const Place& quotient) { return near_quotient(quotient.num, quotient.den); }

}  // namespace isect
