#pragma once
// The operations of a polynomial's text in doubles, one by one: what each of them finds, how far rounding has taken it
// from the truth, and the bound on that.
//
// The text is recorded (isect/numbers/recorded.h), and its steps run in Bounded<double> and in Exact side by side. So
// the last operation of a text of sums and products has the value and the bound of the text's first stage, bit for bit.
// That stage bounds a dot or a cross product as a whole: then its value is the same, but its bound is not.
//
// Operands are told before what is made of them, the left one first, whatever order the compiler chose.

#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include <isect/numbers/bounded.h>
#include <isect/numbers/exact.h>
#include <isect/numbers/recorded.h>

namespace isect {

/// One operation in doubles. Where something overflowed, delta, error and share are NaN.
struct Operation {
  using Kind = detail::Step::Kind;
  Kind kind;
  double x, y;    ///< for a number, x; for a difference of two numbers, both
  int a, b;       ///< for the others: which operations it uses, counted in the order in which they are told
  double value;   ///< in doubles
  double delta;   ///< value = (1 + delta) times the exact result of the operands as computed
  double error;   ///< value - truth, of all that was rounded up to here; rounded itself
  double size;    ///< the sum of the sizes of the products, as Bounded has it
  int roundings;  ///< how many each product has at most
  double bound;   ///< |error| <= bound
  double share;   ///< |error| / bound; 0 where the bound underflows
};

/// A listener that derives from this is told each Operation of a sign, before its stages.
struct HearsOperations {};
template <class Trace>
inline constexpr bool hears_operations = std::is_base_of_v<HearsOperations, std::remove_cvref_t<Trace>>;

namespace detail {

/// Tells the operations that a result needs, each once.
template <class Trace>
class ToldOperations {
 public:
  ToldOperations(const std::vector<Step>& steps, Trace& trace)
      : steps_(steps), places_(steps.size(), -1), trace_(trace) {}

  /// Tells step i after its operands; returns its place among all that was told.
  int tell(int i) {
    if (places_[i] >= 0) return places_[i];
    const Step& step = steps_[i];
    const int a = step.a < 0 ? -1 : tell(step.a), b = step.b < 0 ? -1 : tell(step.b);

    const Found found = a < 0 ? leaf(step) : result(step.kind, found_[a], found_[b]);
    const Exact once = a < 0 ? found.truth : rounded_once(step.kind, found_[a], found_[b]);
    const Operation operation = told(step, a, b, found, once);
    trace_(operation);
    found_.push_back(found);
    return places_[i] = static_cast<int>(found_.size()) - 1;
  }

 private:
  using Kind = Step::Kind;
  struct Found {
    Bounded<double> quick;
    Exact truth;
    bool known = true;  ///< nothing up to here overflowed
  };

  static Found leaf(const Step& step) {
    if (step.kind == Kind::number) return {Bounded<double>(step.x), Exact(step.x), true};
    const auto quick = isect::difference<Bounded<double>>(step.x, step.y);
    if (!std::isfinite(quick.value())) return {quick, Exact(), false};
    return {quick, isect::difference<Exact>(step.x, step.y), true};
  }
  static Found result(Kind kind, const Found& a, const Found& b) {
    const auto quick = applied(kind, a.quick, b.quick);
    if (!a.known || !b.known || !std::isfinite(quick.value())) return {quick, Exact(), false};
    return {quick, applied(kind, a.truth, b.truth), true};
  }
  /// The exact result of operands as they were computed: this operation alone rounds it.
  static Exact rounded_once(Kind kind, const Found& a, const Found& b) {
    if (!a.known || !b.known) return {};
    return applied(kind, Exact(a.quick.value()), Exact(b.quick.value()));
  }

  static Operation told(const Step& step, int a, int b, const Found& found, const Exact& once) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const Bounded<double>& x = found.quick;
    Operation operation = {step.kind, step.x,   step.y,        a,         b,  x.value(), nan,
                           nan,       x.size(), x.roundings(), x.error(), nan};
    if (!found.known) return operation;
    const Exact value(x.value()), error = value - found.truth;
    const bool bounded = x.error() > 0 && std::isfinite(x.error());
    operation.delta = once.sign() == 0 ? 0 : quotient(value - once, once);
    operation.error = error.rounded();
    operation.share = bounded ? quotient(abs(error), Exact(x.error())) : 0;
    return operation;
  }

  const std::vector<Step>& steps_;
  std::vector<int> places_;  ///< of each step, among those told; -1: not yet
  std::vector<Found> found_;
  Trace& trace_;
};

/// Tells the operations of a text in doubles.
template <class Text, class Trace>
void tell_operations(const Text& text, Trace& trace) {
  const Recording steps([&] { return std::array{text.template operator()<Recorded>()}; });
  ToldOperations<Trace>(steps.steps(), trace).tell(steps.results()[0]);
}

}  // namespace detail

}  // namespace isect
