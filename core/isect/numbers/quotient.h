#pragma once
// Two of the four entrances to the numbers: value_of, what is this quotient of two polynomials; and signs_of, what
// signs have its two parts. isect/numbers/README.md tells of all four.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include <isect/numbers/predicate.h>

namespace isect {

/// A quotient of two polynomials, not divided yet; den is not zero.
template <class W>
struct Ratio {
  W num, den;

  friend std::array<const W*, 2> terms(const Ratio& r) { return {&r.num, &r.den}; }
};

/// The steps of a quotient's text as a text of their own.
class RecordedRatio {
 public:
  template <class Text>
  explicit RecordedRatio(const Text& text)
      : quick_(text.template operator()<Bounded<double>>()), steps_([&] {
          const Ratio<Recorded> r = text.template operator()<Recorded>();
          return std::array{r.num, r.den};
        }) {}
  template <class W>
  Ratio<W> operator()() const {
    if constexpr (std::is_same_v<W, Bounded<double>>) {
      return quick_;
    } else {
      const std::vector<W> found = steps_.run<W>();
      return {found[0], found[1]};
    }
  }

 private:
  Ratio<Bounded<double>> quick_;
  Recording steps_;
};

namespace detail {
/// Returns the quotient by what doubles found, where S is float.
template <class Text>
std::optional<double> rough_quotient(const Text& text, double tolerance) {
  const auto [num, den] = text.template operator()<Bounded<double>>();
  if (!num.within(tolerance) || !den.within(tolerance)) return {};
  return num.value() / den.value();
}

/// A quotient in W of this size or more is left to whole numbers: beyond 2^996 the steps overflow without fused
/// products, and all machines shall find the same bits.
inline constexpr double most_quotient = 0x1p990;

/// Num and den in W, Compensated or Fused. Safe: neither loses more than 14 bits by cancellation, so that |lo| <= 2^-32
/// |hi| in both, and both are within a relative 2^-76; or num is 0. By the sizes and roundings that doubles found.
struct FineRatio {
  double num, num_rest, den, den_rest;
  bool safe;
};
/// Whether x loses no more than 14 bits by cancellation.
template <class W>
ISECT_INLINE bool ordinary(const Bounded<double>& quick, const W& fine) {
  const double size = std::abs(fine.hi);
  return (size >= 0x1p-14 * quick.size()) & (size >= 0x1p-800) & (quick.roundings() <= 64);
}
template <class W, class Text>
ISECT_INLINE FineRatio fine_ratio(const Text& text) {
  const Ratio<Bounded<double>> quick = text.template operator()<Bounded<double>>();
  const Ratio<W> r = text.template operator()<W>();
  const bool safe = (ordinary(quick.num, r.num) | (quick.num.size() == 0)) & ordinary(quick.den, r.den);
  return {r.num.hi, r.num.lo, r.den.hi, r.den.lo, safe};
}
template <class W, class Text>
ISECT_INLINE std::optional<double> fine_quotient(const Text& text) {
  const FineRatio r = fine_ratio<W>(text);
  const double q = quotient(W(r.num, r.num_rest), W(r.den, r.den_rest));
  const bool good = r.safe & (std::abs(q) < most_quotient);
  return good ? std::optional(q) : std::nullopt;
}

/// What is known of K quotients with one denominator.
template <std::size_t K>
struct KnownQuotients {
  std::array<std::optional<int>, K + 1> signs = {};  ///< those of the numerators and that of the denominator
  std::array<std::optional<double>, K> values = {};  ///< where the denominator is not 0

  bool all() const {
    for (std::size_t i = 0; i < K; ++i)
      if (signs[K] == 0 ? !signs[i] : !values[i]) return false;
    return signs[K].has_value();
  }
};

/// The K numerators and the denominator of a text, in W.
template <std::size_t K, class W>
using Terms = std::array<const W*, K + 1>;

/// Learns what is known of K quotients from their terms in one arithmetic after the other. Each call keeps what those
/// before it found, and returns whether all is known. The text is not among its types, so that several share the code.
template <class S, std::size_t K>
class QuotientStages {
 public:
  QuotientStages(const Terms<K, Bounded<double>>& quick, const KnownQuotients<K>& known)
      : quick_(quick), known_(known) {}

  const KnownQuotients<K>& known() const { return known_; }
  /// Whether doubles found 0 for a number whose sign is not known.
  bool seems_zero() const {
    bool any = false;
    for (std::size_t i = 0; i <= K; ++i) any |= !known_.signs[i] && quick_[i]->value() == 0;
    return any;
  }
  /// Whether the steps of the grids are known, and nothing underflows.
  bool on_grid() const {
    bool all = true;
    for (const double step : steps_) all &= step > 0;
    return all;
  }

  [[gnu::noinline]] bool learn() {
    return learn([&](std::size_t i) { return quick_[i]->sign(); },
                 [&](std::size_t i) -> Value {
                   if (!quick_[i]->within(tolerance) || !quick_[K]->within(tolerance)) return {};
                   return quick_[i]->value() / quick_[K]->value();
                 });
  }
  /// Values alone, where little cancels.
  [[gnu::noinline]] bool learn_ordinary(const std::array<Compensated, K + 1>& x) {
    return learn([](std::size_t) { return std::optional<int>(); },
                 [&](std::size_t i) -> Value {
                   if (!ordinary(*quick_[i], x[i]) || !ordinary(*quick_[K], x[K])) return {};
                   return in_reach(quotient(x[i], x[K]));
                 });
  }
  [[gnu::noinline]] bool learn(const std::array<double, K + 1>& steps) {
    steps_ = steps;
    return learn([&](std::size_t i) { return sign_on_grid(*quick_[i], steps_[i]); },
                 [&](std::size_t i) -> Value {
                   if (!(quick_[i]->error() < steps_[i] && quick_[K]->error() < steps_[K])) return {};
                   const double q = quick_[i]->value() / quick_[K]->value();
                   return std::isfinite(q) ? Value(q) : std::nullopt;
                 });
  }
  /// T is Compensated or TripleDouble.
  template <class T>
  [[gnu::noinline]] bool learn(const std::array<T, K + 1>& x) {
    const auto bounded = [&](std::size_t i) { return Bounded<T>(x[i], quick_[i]->size(), quick_[i]->roundings()); };
    return learn(
        [&](std::size_t i) { return in_range(*quick_[i]) ? sign_on_grid(bounded(i), steps_[i]) : std::nullopt; },
        [&](std::size_t i) -> Value {
          if (!in_range(*quick_[i]) || !in_range(*quick_[K])) return {};
          if (!bounded(i).within(tolerance) || !bounded(K).within(tolerance)) return {};
          return in_reach(quotient(in_two(x[i]), in_two(x[K])));
        });
  }
  [[gnu::noinline]] bool learn(const Terms<K, MediumExact>& x) {
    return learn([&](std::size_t i) { return x[i]->sign(); },
                 [&](std::size_t i) -> Value {
                   const double q = quotient(*x[i], *x[K]);
                   return std::isnan(q) ? std::nullopt : Value(q);
                 });
  }
  [[gnu::noinline]] bool learn(const Terms<K, Exact>& x) {
    return learn([&](std::size_t i) { return x[i]->sign(); },
                 [&](std::size_t i) { return Value(near_quotient(*x[i], *x[K])); });
  }

 private:
  using Value = std::optional<double>;
  static constexpr double tolerance = std::numeric_limits<S>::epsilon() / 3;

  static Value in_reach(double q) { return std::abs(q) < most_quotient ? Value(q) : std::nullopt; }

  /// Looks for what is not known yet: sign(i) of number i, and value(i), its quotient, may find nothing.
  template <class Sign, class Find>
  bool learn(const Sign& sign, const Find& value) {
    auto& [signs, values] = known_;
    for (std::size_t i = 0; i <= K; ++i)
      if (!signs[i]) signs[i] = sign(i);
    for (std::size_t i = 0; i < K; ++i)
      if (!values[i] && signs[K] && signs[K] != 0) values[i] = signs[i] == 0 ? 0 : value(i);
    return known_.all();
  }

  Terms<K, Bounded<double>> quick_;
  KnownQuotients<K> known_;
  std::array<double, K + 1> steps_ = {};  // of the grids: 0 until they are asked
};

/// What `make` makes of the K + 1 terms of a text in W.
template <class W, std::size_t K, class Text, class Make>
ISECT_INLINE auto made_of_terms(const Text& text, const Make& make) {
  const auto ratios = text.template operator()<W>();
  const Terms<K, W> x = terms(ratios);
  std::array<decltype(make(*x[0])), K + 1> made;
  for (std::size_t i = 0; i <= K; ++i) made[i] = make(*x[i]);
  return made;
}

/// Finds all of it. Each stage keeps what those before it found: doubles; two of them, about 100 bits, where what is
/// known to be a whole multiple of a step is 0 or not; three of them, about 150; then whole numbers. The steps are
/// asked for first where doubles found 0, as for shapes that touch on integers, and after two doubles otherwise.
template <class S, std::size_t K, class Text>
[[gnu::noinline]] KnownQuotients<K> quotients_by_stages(const Text& text, const KnownQuotients<K>& known = {}) {
  const auto by_doubles = text.template operator()<Bounded<double>>();
  QuotientStages<S, K> stages(terms(by_doubles), known);
  if (stages.learn()) return stages.known();

  const auto fine = compensated(
      [&]<class W>() { return made_of_terms<W, K>(text, [](const W& x) { return Compensated(x.hi, x.lo); }); });
  if (std::is_same_v<S, double> && stages.learn_ordinary(fine)) return stages.known();
  const bool grid_first = stages.seems_zero();
  if (!grid_first && stages.learn(fine)) return stages.known();
  if (stages.learn(made_of_terms<Grid, K>(text, [](const Grid& x) { return x.step(); })) || stages.learn(fine))
    return stages.known();

  if (stages.on_grid() && stages.learn(made_of_terms<TripleDouble, K>(text, [](const TripleDouble& x) { return x; })))
    return stages.known();
  const auto in_bits = text.template operator()<MediumExact>();
  if (!stages.learn(terms(in_bits))) stages.learn(terms(text.template operator()<Exact>()));
  return stages.known();
}
}  // namespace detail

/// The quotient in S, within 2 ulp of S of its true value; infinite beyond the largest S. The text returns a
/// Ratio<W> whose den is not zero.
///
/// Bound. Each of num and den is within a relative eps / 3 of the truth, eps that of S, or a finer arithmetic takes
/// over; so the quotient is within 2/3 eps (1 + eps), at most 1.34 ulp, rounded once to S: within 1.85 ulp in all.
/// Subnormal results lose what S loses there: half a unit of the least subnormal more. In double most are within 0.51
/// ulp.
template <class S, class Text, class Trace = NoTrace>
S value_of(const Text& text, Trace&& trace = {}) {
  constexpr double tolerance = std::numeric_limits<S>::epsilon() / 3;
  if constexpr (detail::recorded_for<Text, Trace> && !std::is_same_v<Text, RecordedRatio>) {
    return value_of<S>(RecordedRatio(text), trace);
  } else if constexpr (doubles_only<Trace>) {
    std::optional<double> q;
    if constexpr (std::is_same_v<S, float>)
      q = detail::rough_quotient(text, tolerance);
    else
      q = detail::fine_quotient<typename std::remove_cvref_t<Trace>::Fine>(text);
    trace.open |= !q;
    return static_cast<S>(q.value_or(0));
  } else {
    std::optional<double> q;
    if constexpr (std::is_same_v<S, float>)
      q = detail::rough_quotient(text, tolerance);
    else
      q = compensated([&]<class W>() { return detail::fine_quotient<W>(text); });
    if (q) return static_cast<S>(*q);
    trace(Fallback{});
    return static_cast<S>(*detail::quotients_by_stages<S, 1>(text).values[0]);
  }
}

/// The signs of num and den; and the quotient, as value_of finds it, if it was found on the way.
template <class S>
struct SignsAndValue {
  int num, den;
  std::optional<S> value = {};
};
template <class S, class Text, class Trace = NoTrace>
ISECT_INLINE SignsAndValue<S> signs_of(const Text& text, Trace&& trace = {}) {
  if constexpr (doubles_only<Trace> && std::is_same_v<S, double>) {  // the signs of what value_of finds, too
    const detail::FineRatio r = detail::fine_ratio<typename std::remove_cvref_t<Trace>::Fine>(text);
    trace.open |= !r.safe;
    return {(r.num > 0) - (r.num < 0), (r.den > 0) - (r.den < 0)};
  } else if constexpr (doubles_only<Trace> || detail::recorded_for<Text, Trace>) {
    const int den = sign_of([&]<class W>() -> W { return text.template operator()<W>().den; }, trace);
    return {sign_of([&]<class W>() -> W { return text.template operator()<W>().num; }, trace), den};
  } else {
    const detail::KnownQuotients<1> known = detail::quotients_by_stages<S, 1>(text);
    SignsAndValue<S> found = {*known.signs[0], *known.signs[1]};
    if (found.den != 0) found.value = static_cast<S>(*known.values[0]);
    return found;
  }
}

/// n.x / n.y, each of which is a vector of doubles or of W.
template <PolynomialScalar W, int N, class X, class Y, class Z>
ISECT_INLINE Ratio<W> ratio_of_dots(const X& n, const Y& x, const Z& y) {
  if constexpr (is_compensated<W>) {
    const auto both = two_dots<std::is_same_v<W, Fused>, N>(n, x, y);
    return {W(both.x.hi, both.x.lo), W(both.y.hi, both.y.lo)};
  } else {
    return {dot(in<W, N>(n), in<W, N>(x)), dot(in<W, N>(n), in<W, N>(y))};
  }
}

}  // namespace isect
