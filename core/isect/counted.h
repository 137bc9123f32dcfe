#pragma once
// A scalar that counts what is done with it: run an algorithm on Counted<double> and read the tally. The
// algorithm's text stays as it is, so the counts are those of the code that runs.

#include <Eigen/Core>
#include <cmath>

#include <isect/shapes.h>

namespace isect {

struct Tally {
  int mul = 0, add = 0, div = 0, sqrt = 0, compare = 0;  ///< add: additions and subtractions
  friend bool operator==(const Tally&, const Tally&) = default;
};

/// The running thread's tally; set it to {} before a run.
inline Tally& tally() {
  thread_local Tally counts;
  return counts;
}

template <class S>
struct Counted {
  S value = 0;

  Counted() = default;
  Counted(S x) : value(x) {}

  friend Counted operator+(const Counted& x, const Counted& y) { return ++tally().add, Counted(x.value + y.value); }
  friend Counted operator-(const Counted& x, const Counted& y) { return ++tally().add, Counted(x.value - y.value); }
  friend Counted operator*(const Counted& x, const Counted& y) { return ++tally().mul, Counted(x.value * y.value); }
  friend Counted operator/(const Counted& x, const Counted& y) { return ++tally().div, Counted(x.value / y.value); }
  friend Counted operator-(const Counted& x) { return Counted(-x.value); }
  friend Counted abs(const Counted& x) { return Counted(std::abs(x.value)); }
  friend Counted sqrt(const Counted& x) { return ++tally().sqrt, Counted(std::sqrt(x.value)); }

  friend bool operator<(const Counted& x, const Counted& y) { return ++tally().compare, x.value < y.value; }
  friend bool operator<=(const Counted& x, const Counted& y) { return ++tally().compare, x.value <= y.value; }
  friend bool operator>(const Counted& x, const Counted& y) { return y < x; }
  friend bool operator>=(const Counted& x, const Counted& y) { return y <= x; }
  friend bool operator==(const Counted& x, const Counted& y) { return ++tally().compare, x.value == y.value; }
};

template <class S>
inline constexpr bool has_bounds<Counted<S>> = has_bounds<S>;

/// Input checks at the start of algorithms, not part of them: not counted.
template <class S, int N, int M>
bool finite(const Eigen::Matrix<Counted<S>, N, M>& x) {
  return x.unaryExpr([](const Counted<S>& c) { return c.value; }).allFinite();
}

}  // namespace isect

namespace std {
template <class S>
struct numeric_limits<isect::Counted<S>> : numeric_limits<S> {
  static constexpr S infinity() noexcept { return numeric_limits<S>::infinity(); }
};
}  // namespace std

namespace Eigen {
template <class S>
struct NumTraits<isect::Counted<S>> : NumTraits<S> {
  using Real = isect::Counted<S>;
  using NonInteger = isect::Counted<S>;
  using Nested = isect::Counted<S>;
  using Literal = isect::Counted<S>;
};
}  // namespace Eigen
