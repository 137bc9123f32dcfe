#pragma once
// A polynomial's text as a list of steps, to be run in any arithmetic later.
//
// A text is compiled once for each arithmetic that it runs in, and where it is long that takes the compiler a second or
// more each time. Run once in Recorded it leaves its steps behind, on the heap, and one loop runs these in all the
// others. That settles what doubles leave open where code must be small, where somebody listens, and always for long
// texts, such as those of half-spaces, polytopes and smallest balls. The results are the text's own, bit for bit.

#include <array>
#include <cstddef>
#include <initializer_list>
#include <type_traits>
#include <utility>
#include <vector>

#include <isect/numbers/bounded.h>
#include <isect/numbers/grid.h>

namespace isect {

namespace detail {
struct Step {
  enum class Kind { number, difference, plus, minus, times, opposite, size };
  Kind kind;
  double x = 0, y = 0;  // for a number, and for a difference of two
  int a = -1, b = -1;   // for the others: the steps whose results they use
};

/// The result of an operation; one with a single operand takes it as `a`.
template <class W>
W applied(Step::Kind kind, const W& a, const W& b) {
  switch (kind) {
    case Step::Kind::plus:
      return a + b;
    case Step::Kind::minus:
      return a - b;
    case Step::Kind::times:
      return a * b;
    case Step::Kind::opposite:
      return -a;
    default:
      return abs(a);
  }
}

/// The steps being recorded, if any are.
inline thread_local std::vector<Step>* recording = nullptr;
}  // namespace detail

/// A number of a text that is being recorded: the step that finds it.
class Recorded {
 public:
  Recorded() = default;
  Recorded(double x) : Recorded({.kind = Kind::number, .x = x}) {}
  static Recorded difference(double x, double y) { return Recorded({.kind = Kind::difference, .x = x, .y = y}); }

  friend Recorded operator+(const Recorded& a, const Recorded& b) { return {Kind::plus, a, b}; }
  friend Recorded operator-(const Recorded& a, const Recorded& b) { return {Kind::minus, a, b}; }
  friend Recorded operator*(const Recorded& a, const Recorded& b) { return {Kind::times, a, b}; }
  friend Recorded operator-(const Recorded& a) { return {Kind::opposite, a, a}; }
  friend Recorded abs(const Recorded& a) { return {Kind::size, a, a}; }

  int step() const { return step_; }

 private:
  using Kind = detail::Step::Kind;
  [[gnu::noinline]] explicit Recorded(const detail::Step& step) : step_(static_cast<int>(detail::recording->size())) {
    detail::recording->push_back(step);
  }
  Recorded(Kind kind, const Recorded& a, const Recorded& b)
      : Recorded(detail::Step{.kind = kind, .a = a.step_, .b = b.step_}) {}

  int step_ = 0;
};

/// The steps of a text, to be run in other arithmetics.
class Recording {
 public:
  /// `text` finds its numbers in Recorded and returns them as a list.
  template <class Text>
  explicit Recording(const Text& text) {
    {
      const Turn turn(&steps_);
      for (const Recorded& x : text()) results_.push_back(x.step());
    }
    share_places();
  }

  /// The numbers in W.
  template <class W>
  std::vector<W> run() const {
    std::vector<W> at(places_);
    for (std::size_t i = 0; i < steps_.size(); ++i) at[place_[i]] = found(steps_[i], at);
    std::vector<W> results;
    for (const int i : results_) results.push_back(at[place_[i]]);
    return results;
  }

  /// How many numbers are kept at a time.
  std::size_t places() const { return places_; }
  const std::vector<detail::Step>& steps() const { return steps_; }
  /// The steps that find the numbers.
  const std::vector<int>& results() const { return results_; }

 private:
  using Kind = detail::Step::Kind;

  /// Directs recording to `steps` as long as it lives; an exception ends it, too.
  class Turn {
   public:
    explicit Turn(std::vector<detail::Step>* steps) : outer_(std::exchange(detail::recording, steps)) {}
    ~Turn() { detail::recording = outer_; }
    Turn(const Turn&) = delete;

   private:
    std::vector<detail::Step>* const outer_;
  };

  template <class W>
  W found(const detail::Step& step, const std::vector<W>& at) const {
    if (step.kind == Kind::number) return W(step.x);
    if (step.kind == Kind::difference) return isect::difference<W>(step.x, step.y);
    return detail::applied(step.kind, at[place_[step.a]], at[place_[step.b]]);
  }

  /// Chooses where each step puts its result: a place that no later step needs, as an exact number is large.
  void share_places() {
    const std::size_t count = steps_.size();
    std::vector<std::size_t> last(count);  // the last step to need it
    for (std::size_t i = 0; i < count; ++i)
      if (steps_[i].a >= 0) last[steps_[i].a] = last[steps_[i].b] = i;
    for (const int i : results_) last[i] = count;
    std::vector<std::size_t> free;
    for (std::size_t i = 0; i < count; ++i) {
      for (const int from : {steps_[i].a, steps_[i].b})
        if (from >= 0 && last[from] == i) {
          last[from] = count;  // x x frees x once
          free.push_back(place_[from]);
        }
      if (free.empty()) free.push_back(places_++);
      place_.push_back(free.back());
      free.pop_back();
    }
  }

  std::vector<detail::Step> steps_;
  std::vector<int> results_;
  std::vector<std::size_t> place_;  // of each step
  std::size_t places_ = 0;
};

/// The steps of a polynomial's text as a text of their own.
class RecordedSum {
 public:
  template <class Text>
  explicit RecordedSum(const Text& text) : steps_([&] { return std::array{text.template operator()<Recorded>()}; }) {}
  template <class W>
  W operator()() const {
    return steps_.run<W>()[0];
  }

 private:
  Recording steps_;
};

}  // namespace isect
