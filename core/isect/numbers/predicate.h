#pragma once
// The first of the four entrances to the numbers, sign_of: what sign does this polynomial have? isect/numbers/README.md
// tells of all four.
//
// The polynomial is a text over an arithmetic W, written once as a generic lambda:
//
//   sign_of([&]<class W>() -> W { return difference<W>(a[0], c[0]) * difference<W>(b[1], c[1]) - ...; })
//
// It runs in Bounded<double>, whose proved error bound settles nearly every sign. Where that leaves it open, the text
// runs on in finer arithmetics, one after the other, until one of them is certain. The last is Exact, which always is.
// Which ones, at what cost and in what order, is told in isect/numbers/README.md. So algorithms read like the book's,
// branch on true signs alone, and are right at any magnitude. Arguments must be finite: Exact would give NaN some
// sign, a wrong one.
//
// An algorithm that asks several signs passes its listener on to each, and is run by in_doubles_first: then all of it
// runs in Bounded<double> once, without a way out at each sign, and is run again only if one of them stayed open.

#include <limits>
#include <type_traits>

#include <isect/numbers/bounded.h>
#include <isect/numbers/components.h>
#include <isect/numbers/exact.h>
#include <isect/numbers/grid.h>
#include <isect/numbers/operations.h>
#include <isect/numbers/recorded.h>
#include <isect/numbers/stages.h>
#include <isect/trace.h>

namespace isect {

/// A text that caches its intermediate results per arithmetic, for others of its kind. It is never recorded: recorded
/// steps would find all of that anew for each sign.
template <class Text>
struct NotRecorded : Text {};
template <class Text>
NotRecorded(Text) -> NotRecorded<Text>;

namespace detail {
// Each of these functions tells what it found to a listener that hears stages; to none, if there is none.

template <class W, class Text, class... Listeners>
[[gnu::noinline]] std::optional<int> sign_in(const Text& text, Listeners&... listeners) {
  const W x = text.template operator()<W>();
  (listeners(Stage{std::is_same_v<W, ShortExact> ? Stage::Kind::short_exact : Stage::Kind::medium_exact, x.rounded(), 0,
                   0, x.sign()}),
   ...);
  return x.sign();
}
template <class Text, class... Listeners>
[[gnu::noinline, gnu::cold]] int exact_sign(const Text& text, Listeners&... listeners) {
  const Exact x = text.template operator()<Exact>();
  (listeners(Stage{Stage::Kind::exact, x.rounded(), 0, 0, x.sign()}), ...);
  return x.sign();
}
/// The sign of x, a whole multiple of `step`: 1, 0, -1, or nothing where the error could turn it.
template <class T>
std::optional<int> sign_on_grid(const Bounded<T>& x, double step) {
  const double size = std::abs(leading(x.value())), error = x.error();
  if (size - error > 0) return x.apparent_sign();
  if (size + error < step) return 0;
  return {};
}
/// The sign of a whole multiple of `step` that is `most` in size at most: 0, or nothing.
inline Stage on_grid(double most, double step) {
  return {Stage::Kind::grid, 0, most, step, most < step ? std::optional(0) : std::nullopt};
}
/// Whether a text is recorded before it runs in the arithmetics after doubles: where code is to be small, and where
/// somebody listens, which takes longer anyway.
template <class Text, class Trace>
inline constexpr bool recorded_for = small_code || heard<Trace>;
template <class Text, class Trace>
inline constexpr bool recorded_for<NotRecorded<Text>, Trace> = false;
/// The step of a text's grid.
template <class Text>
[[gnu::noinline]] double step_of(const Text& text) {
  return text.template operator()<Grid>().step();
}
ISECT_INLINE bool in_range(const Bounded<double>& x) { return 0x1p-800 < x.size() && x.size() < 0x1p900; }

/// Returns the sign of a text whose size is out of range.
template <class Text, class... Listeners>
[[gnu::noinline]] int sign_out_of_range(const Text& text, Listeners&... listeners) {
  if (const std::optional<int> s = sign_in<ShortExact>(text, listeners...)) return *s;
  return exact_sign(text, listeners...);
}
/// Returns the sign where Compensated leaves it open as well.
template <class Text, class... Listeners>
[[gnu::noinline]] int sign_after_compensated(const Text& text, const Bounded<double>& quick, double step,
                                             Listeners&... listeners) {
  if (step > 0) {  // nothing underflows
    const Bounded<TripleDouble> x(text.template operator()<TripleDouble>(), quick.size(), quick.roundings());
    const std::optional<int> s = sign_on_grid(x, step);
    (listeners(Stage{Stage::Kind::triple_double, leading(x.value()), x.error(), step, s}), ...);
    if (s) return *s;
  }
  if (quick.size() < 0x1p248 * step)
    if (const std::optional<int> s = sign_in<MediumExact>(text, listeners...)) return *s;
  return exact_sign(text, listeners...);
}
/// Returns the sign where doubles and their grid leave it open; `step` is the grid's, or 0 if it was not asked for yet.
template <class Text, class... Listeners>
[[gnu::noinline]] int sign_in_compensated(const Text& text, const Bounded<double>& quick, double step,
                                          Listeners&... listeners) {
  struct Fine {
    double value, error;
  };
  const auto [value, error] = compensated([&]<class W>() -> Fine {
    const Bounded<W> x(text.template operator()<W>(), quick.size(), quick.roundings());
    return {leading(x.value()), x.error()};
  });
  (listeners(Stage{Stage::Kind::compensated, value, error, 0,
                   std::abs(value) - error > 0 ? std::optional(value > 0 ? 1 : -1) : std::nullopt}),
   ...);
  if (std::abs(value) - error > 0) return value > 0 ? 1 : -1;
  if (step == 0) step = step_of(text);
  const double most = std::min(std::abs(quick.value()) + quick.error(), std::abs(value) + error);
  (listeners(on_grid(most, step)), ...);
  return most < step ? 0 : sign_after_compensated(text, quick, step, listeners...);
}
/// Returns the sign where doubles leave it open. Not inlined: the slow path's machine code stays out of the fast one's
/// way. `quick` is what doubles found; the stages that follow use its size and its roundings, too. The grid is asked
/// first where doubles found 0, as for shapes that touch on integers, and after two doubles otherwise.
template <class Text, class... Listeners>
[[gnu::noinline]] int sign_after_doubles(const Text& text, const Bounded<double>& quick, Listeners&... listeners) {
  double step = 0;
  if (quick.value() == 0) {
    step = step_of(text);
    (listeners(on_grid(quick.error(), step)), ...);
    if (quick.error() < step) return 0;
  }
  return in_range(quick) ? sign_in_compensated(text, quick, step, listeners...) : sign_out_of_range(text, listeners...);
}
/// Returns the sign where doubles leave it open, and tells the stages to a listener that hears them.
template <class Text, class Trace>
ISECT_INLINE int sign_after_doubles_heard(const Text& text, const Bounded<double>& quick, Trace& trace) {
  if constexpr (hears_stages<Trace>)
    return sign_after_doubles(text, quick, trace);
  else
    return sign_after_doubles(text, quick);
}
}  // namespace detail

/// Takes a listener's place when an algorithm runs in plain doubles alone: keeps whether these left a sign or a value
/// open. If so, discard the result. Values are found in W, Compensated or Fused.
template <class W>
struct DoublesOnly : NoTrace {
  using Fine = W;
  bool open = false;
};

/// Whether the algorithm runs in plain doubles alone.
template <class Trace>
inline constexpr bool doubles_only = false;
template <class W>
inline constexpr bool doubles_only<DoublesOnly<W>> = true;
template <class Trace>
inline constexpr bool doubles_only<Trace&> = doubles_only<std::remove_cv_t<Trace>>;

namespace detail {
template <class Algorithm, class W>
[[gnu::flatten]] inline auto tried(const Algorithm& algorithm, DoublesOnly<W>& first) {
  return algorithm(first);
}
template <class Algorithm, class Trace>
[[gnu::noinline, gnu::cold]] auto run_in_full(const Algorithm& algorithm, Trace& trace) {
  return algorithm(trace);
}
}  // namespace detail

/// Returns algorithm(trace), with all that sign_of and value_of can do. First it runs in plain doubles: straight code
/// without a branch for each sign, which settles all but a few cases. S is the scalar of the values that the algorithm
/// finds, if it finds any: doubles are found faster where products are fused. A listener hears the whole.
template <class S = void, class Algorithm, class Trace>
inline auto in_doubles_first(const Algorithm& algorithm, Trace& trace) {
  if constexpr (small_code || heard<Trace>) {
    return algorithm(trace);
  } else if constexpr (std::is_same_v<S, double>) {
    bool open = false;
    auto result = compensated([&]<class W>() {
      DoublesOnly<W> first;
      auto found = algorithm(first);
      open = first.open;
      return found;
    });
    if (open) [[unlikely]]
      result = detail::run_in_full(algorithm, trace);
    return result;
  } else {
    DoublesOnly<Compensated> first;
    auto result = detail::tried(algorithm, first);
    if (first.open) [[unlikely]]
      result = detail::run_in_full(algorithm, trace);
    return result;
  }
}

/// Whether a text is long: sign_of<long_text>(text) compiles it for doubles and for Recorded alone, which allocates
/// where doubles leave the sign open.
inline constexpr bool long_text = true;

/// The true sign of the polynomial: 1, 0 or -1. Reports Fallback when doubles do not settle it; its operations and
/// stages to a listener that hears them, the operations only of texts that may be recorded.
template <bool is_long = false, class Text, class Trace = NoTrace>
int sign_of(const Text& text, Trace&& trace = {}) {
  if constexpr (hears_operations<Trace> && detail::recorded_for<Text, Trace>) detail::tell_operations(text, trace);
  const Bounded<double> quick = text.template operator()<Bounded<double>>();
  if constexpr (doubles_only<Trace> && !is_long) {
    trace.open |= !quick.certain();
    return quick.apparent_sign();
  } else {
    if constexpr (hears_stages<Trace>)
      trace(Stage{Stage::Kind::doubles, quick.value(), quick.error(), 0, quick.sign()});
    if (quick.certain()) return quick.apparent_sign();
    trace(Fallback{});
    if constexpr (is_long || detail::recorded_for<Text, Trace>)
      return detail::sign_after_doubles_heard(RecordedSum(text), quick, trace);
    else
      return detail::sign_after_doubles_heard(text, quick, trace);
  }
}

}  // namespace isect
