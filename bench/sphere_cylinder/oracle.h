#pragma once
// How a ball and a cylinder or a cone lie: by distances in the half-plane through the axis and the ball's center, in
// which the solid is a quadrilateral, with enough digits to distinguish what is not 0 from 0.
//
// How many: the inputs are whole multiples of a power of two that are at most 2^b. What a distance is compared with s
// by is, times |d| and the length of the side, a sum of two roots and a whole number, all of polynomials of degree six:
// the product of all four conjugates is a whole number, so that, unless it is 0, it is at least 2^-(9 b + 20), and the
// difference of distances 2^-(11 b + 30). (If a conjugate is 0, the sum is twice a difference of two such roots, or
// twice one, and as far from 0.) The digits are three times as many, for roots of what cancels.

#include <algorithm>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "bench/round_oracle.h"

namespace isect::oracle {

class BallAndRoundSolid {
 public:
  /// Both shapes must exist.
  template <class S>
  BallAndRoundSolid(const Sphere<S, 3>& ball, const RoundSolid& solid)
      : inside_(solid.locate(rational(ball.center)) != Location::out) {
    const Coordinates<3> c = rational(ball.center);
    const long bits = bits_of({c[0], c[1], c[2], solid.start[0], solid.start[1], solid.start[2],
                               Rational(solid.start[0] + solid.d[0]), Rational(solid.start[1] + solid.d[1]),
                               Rational(solid.start[2] + solid.d[2]), Rational(ball.radius), solid.at_end});
    digits_ = static_cast<unsigned>(0.302 * static_cast<double>(34 * bits + 300)) + 1;
    const unsigned before = Big::default_precision();
    Big::default_precision(digits_);
    compute(c, solid, Rational(ball.radius), bits);
    Big::default_precision(before);
  }

  Relation relation() const {
    if (nearest_ > 0) return Relation::disjoint;
    if (depth_ >= 0) return Relation::a_inside_b;
    if (farthest_ <= 0) return Relation::b_inside_a;
    return nearest_ == 0 ? Relation::touching : Relation::overlapping;
  }

 private:
  using Big =
      boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>, boost::multiprecision::et_off>;
  struct Place {
    Big along, beside;
  };

  /// The number of bits between the highest of all numbers and the lowest that any of them has.
  static long bits_of(std::initializer_list<Rational> numbers) {
    long top = -2000, low = 2000;
    for (const Rational& x : numbers) {
      if (x == 0) continue;
      const auto num = abs(numerator(x)), den = denominator(x);
      const long down = static_cast<long>(msb(den));
      top = std::max(top, static_cast<long>(msb(num)) - down + 2);
      low = std::min(low, static_cast<long>(lsb(num)) - down);
    }
    return std::max(2L, top - low);
  }
  static Big big(const Rational& x) {
    return Big(boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>(
               numerator(x))) /
           Big(boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>(
               denominator(x)));
  }
  static Big length(const Big& x, const Big& y) { return sqrt(x * x + y * y); }
  static Big distance(const Place& x, const Place& a, const Place& b) {
    const Big u = b.along - a.along, v = b.beside - a.beside, square = u * u + v * v;
    Big t = square == 0 ? Big(0) : ((x.along - a.along) * u + (x.beside - a.beside) * v) / square;
    t = std::clamp(t, Big(0), Big(1));
    return length(x.along - (a.along + t * u), x.beside - (a.beside + t * v));
  }

  void compute(const Coordinates<3>& c, const RoundSolid& solid, const Rational& radius, long bits) {
    const Rational dd = dot(solid.d, solid.d);
    const Big whole = sqrt(big(dd)), s = big(radius), start = big(solid.at_start), end = big(solid.at_end);
    const Place x = {big(dot(c - solid.start, solid.d)) / whole, sqrt(big(solid.from_axis2(c)))};
    const Place corners[] = {{Big(0), Big(0)}, {Big(0), start}, {whole, end}, {whole, Big(0)}};

    // The unit: the power of two of which all inputs are multiples is at most the least of them that is not 0
    const Big largest = std::max({abs(x.along), x.beside, whole, s, end});
    const Big zero = ldexp(largest, static_cast<int>(-13 * bits - 60));
    const auto sign = [&](const Big& difference) { return abs(difference) < zero ? 0 : difference > 0 ? 1 : -1; };

    Big nearest = 0, farthest = 0;
    if (!inside_) {
      nearest = distance(x, corners[0], corners[1]);
      for (int i = 1; i < 3; ++i) nearest = std::min(nearest, distance(x, corners[i], corners[i + 1]));
    }
    for (const Place& corner : corners)
      farthest = std::max(farthest, length(x.along - corner.along, x.beside + corner.beside));
    const Big across = end - start;
    const Big to_side = ((start - x.beside) * whole + across * x.along) / length(whole, across);
    const Big depth = std::min({x.along, whole - x.along, to_side});
    nearest_ = sign(nearest - s), farthest_ = sign(farthest - s), depth_ = inside_ ? sign(depth - s) : -1;
  }

  bool inside_;
  unsigned digits_ = 0;
  int nearest_ = 0, farthest_ = 0, depth_ = 0;
};

/// A shape that is empty, NaN or infinite is disjoint from all.
template <class S, Round Solid>
Relation relation(const Sphere<S, 3>& ball, const Solid& shape) {
  const RoundSolid solid = round_solid(shape);
  if (!solid.exists || !finite(ball) || empty(ball)) return Relation::disjoint;
  return BallAndRoundSolid(ball, solid).relation();
}

}  // namespace isect::oracle
