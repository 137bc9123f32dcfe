#pragma once
// A place on a line as the number that it is, so that any two can be put in order exactly: a quotient, or a root of a
// quadratic polynomial.

#include <utility>

#include <isect/numbers/exact.h>

namespace isect::program::scene {

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

/// Within 1 ulp, of one that is a quotient.
inline double nearest(const Place& quotient) { return near_quotient(quotient.num, quotient.den); }

/// The sign of x less y.
int compare(const Place& x, const Place& y);

}  // namespace isect::program::scene
