#pragma once
// The last of the four entrances to the numbers, root_of: what is this root of a quadratic polynomial?
// isect/numbers/README.md tells of all four.
//
// The roots of a t^2 + 2 b t + c are (-b -+ sqrt D) / a, D = b^2 - a c. Where -b and the square root have opposite
// signs they cancel, so that root is found from the other one, as the product of both is c / a: with q = |b| + sqrt D
// they are q / a and c / q, up to signs. At (-b - sqrt D) / a the polynomial falls, at the other one it rises, also
// where a is negative; where a = 0 it has the one root c / q.
//
// Bound. Let D, a and c be within a relative e of the truth, and b within e q. Then q is within 2 e, even if the sign
// of b is unknown, so that each root is within 3 e before its last rounding, for e < 2^-20. Doubles (for a float) or
// two of them (for a double) serve where e = eps / 128, eps that of S, else Exact does, whose root is within 2^-126.
//
// Source: Press, Teukolsky, Vetterling, Flannery, Numerical Recipes, 3rd ed. (2007), 5.6.

#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include <isect/numbers/predicate.h>

namespace isect {

/// a t^2 + 2 b t + c, and b^2 - a c, for which a text may know a form in which less cancels.
template <class W>
struct Quadratic {
  W a, b, c, discriminant;
};

/// The steps of a quadratic's text as a text of their own.
class RecordedQuadratic {
 public:
  template <class Text>
  explicit RecordedQuadratic(const Text& text)
      : quick_(text.template operator()<Bounded<double>>()), steps_([&] {
          const Quadratic<Recorded> f = text.template operator()<Recorded>();
          return std::array{f.a, f.b, f.c, f.discriminant};
        }) {}
  template <class W>
  Quadratic<W> operator()() const {
    if constexpr (std::is_same_v<W, Bounded<double>>) {
      return quick_;
    } else {
      const std::vector<W> found = steps_.run<W>();
      return {found[0], found[1], found[2], found[3]};
    }
  }

 private:
  Quadratic<Bounded<double>> quick_;
  Recording steps_;
};

namespace detail {
/// Whether the sizes are such that nothing overflows, and nothing that matters underflows.
template <class V>
bool ordinary_size(const Bounded<V>& x) {
  return x.size() < 0x1p900 && (std::abs(leading(x.value())) > 0x1p-800 || x.size() == 0);
}

/// The root at which it falls (-1) or rises (1) in V by its own bounds, where it is not beyond the range of doubles.
template <class V, class Text>
[[gnu::noinline]] std::optional<double> bounded_root(const Text& text, int side, double tolerance) {
  using std::sqrt;
  const Quadratic<Bounded<V>> f = text.template operator()<Bounded<V>>();
  if (!ordinary_size(f.a) || !ordinary_size(f.discriminant) || !(f.b.size() < 0x1p900)) return {};
  if (!(leading(f.discriminant.value()) > 0)) return {};
  if (!f.discriminant.within(tolerance) || !f.a.within(tolerance)) return {};
  const bool turned = leading(f.b.value()) < 0;
  const V b = turned ? -f.b.value() : f.b.value(), q = b + sqrt(f.discriminant.value());
  if (!(f.b.error() <= tolerance * leading(q))) return {};
  const bool far = turned == (side > 0);
  if (!far && !(ordinary_size(f.c) && f.c.within(tolerance))) return {};
  const double t = far ? isect::quotient(q, f.a.value()) : -isect::quotient(f.c.value(), q);
  if (!(std::abs(t) < 0x1p990 && std::abs(t) > 0x1p-900)) return {};
  return side > 0 ? t : -t;
}

template <class Text>
[[gnu::noinline, gnu::cold]] double exact_root(const Text& text, int side) {
  const Quadratic<Exact> f = text.template operator()<Exact>();
  const bool turned = f.b.sign() < 0;
  const Exact q = abs(f.b) + sqrt(f.discriminant);
  const double t = q.sign() == 0 ? 0 : turned == (side > 0) ? near_quotient(q, f.a) : -near_quotient(f.c, q);
  return side > 0 ? t : -t;
}
}  // namespace detail

/// The root at which the polynomial falls (side -1) or rises (1), for a > 0 the lower or the upper one, in S, within
/// 0.6 ulp of its true value, and one unit of the least subnormal number more where it is subnormal; infinite beyond
/// the largest S. The text returns a Quadratic<W> that has that root: with a discriminant that is not negative, and
/// where a = 0 with a b of the sign of `side`.
template <class S, class Text, class Trace = NoTrace>
S root_of(const Text& text, int side, Trace&& trace = {}) {
  if constexpr (detail::recorded_for<Text, Trace> && !std::is_same_v<Text, RecordedQuadratic>) {
    return root_of<S>(RecordedQuadratic(text), side, trace);
  } else {
    constexpr double tolerance = std::numeric_limits<S>::epsilon() / 128;
    using V = std::conditional_t<std::is_same_v<S, float>, double, DoubleDouble>;
    const std::optional<double> t = detail::bounded_root<V>(text, side, tolerance);
    if constexpr (doubles_only<Trace>) {
      trace.open |= !t;
      return static_cast<S>(t.value_or(0));
    } else {
      if (t) return static_cast<S>(*t);
      trace(Fallback{});
      return static_cast<S>(detail::exact_root(text, side));
    }
  }
}

}  // namespace isect
