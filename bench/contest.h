#pragma once
// Methods of one test against each other, on the same cases of one family: timed in turns, judged by one oracle.
//
//   Contest<S, Case> contest(session, family);
//   contest.enter("quadratic", [](const Case& c) { return ray_sphere::quadratic(c.ray, c.sphere); });
//   contest.enter("exact", [](const Case& c) { return intersect(c.ray, c.sphere).surface; }).exact();
//   contest.run();
//
// A method answers with bool, an int (a sign), a Location or a std::optional of a number. Its whole pass over the cases
// is compiled as one loop, so that it may be inlined; passes of all methods take turns, so that a busy moment of the
// machine meets them all alike. A second loop makes each call wait for the one before: it measures latency.

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <functional>
#include <iomanip>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include <isect/conventions.h>
#include <isect/trace.h>
#include "bench/distribution.h"
#include "bench/oracle.h"
#include "bench/random.h"
#include "bench/session.h"

namespace isect::bench {

/// The truth about one case.
struct Truth {
  int verdict = 0;                    ///< 0 no, 1 yes; or a sign, or a location as an int
  std::optional<oracle::Real> value;  ///< t or a distance
  double condition = 1;               ///< how much a relative error of the input grows in the value
  std::optional<int> side = {};       ///< where methods may answer a sign or a location: -1, 0 ("on") or 1
};
/// 1 inside, 0 on the boundary, -1 outside.
inline int side_of(Location l) { return (l == Location::in) - (l == Location::out); }
/// The truth for the question whether a closed set holds a point.
inline Truth truth_of(Location l) { return {l != Location::out, {}, 1, side_of(l)}; }
/// The truth for a question whose answer is a sign.
inline Truth truth_of_sign(int sign) { return {sign, {}, 1, sign}; }

/// A generator of cases and their oracle.
template <class Case>
struct CaseFamily {
  std::string test, scalar, name, note;  ///< name and note of NamedDraw
  bool hard = false;
  std::function<Case(Random&)> draw;
  std::function<Truth(const Case&)> truth;
  std::function<std::string(const Case&)> text;  ///< the case in full precision
  /// How far the point at `value` lies off the surface, relative to the surface's size; may be empty.
  std::function<double(const Case&, double value)> residual = {};
  /// Fewer cases suffice where each case takes many branches.
  long most_cases = std::numeric_limits<long>::max();
};

/// The answer of a method: a verdict, and a value or a side where it has one.
struct Said {
  int verdict = 0;
  std::optional<double> value = {};
  std::optional<int> side = {};
};
inline Said said(bool yes) { return {yes}; }
inline Said said(int verdict) { return {verdict, {}, verdict}; }
inline Said said(Location l) { return {l != Location::out, {}, side_of(l)}; }
template <class S>
Said said(const std::optional<S>& value) {
  return {value.has_value(), value ? std::optional<double>(static_cast<double>(*value)) : std::nullopt, {}};
}
inline Said said(const Said& s) { return s; }

/// Adds up answers so that none is dropped.
struct Sum {
  long count = 0;
  double values = 0;
  void operator+=(bool yes) { count += yes; }
  void operator+=(int verdict) { count += verdict; }
  void operator+=(Location l) { count += static_cast<int>(l); }
  void operator+=(const Said& s) {
    count += s.verdict;
    if (s.value) values += *s.value;
  }
  template <class S>
  void operator+=(const std::optional<S>& value) {
    count += value.has_value();
    if (value) values += static_cast<double>(*value);
  }
};

/// All bits of an answer.
inline std::uint64_t bits_of(bool yes) { return yes; }
inline std::uint64_t bits_of(int verdict) { return static_cast<std::uint64_t>(verdict); }
inline std::uint64_t bits_of(Location l) { return static_cast<std::uint64_t>(l); }
template <class S>
std::uint64_t bits_of(const std::optional<S>& value) {
  return value ? std::bit_cast<std::uint64_t>(static_cast<double>(*value)) : 0;
}
inline std::uint64_t bits_of(const Said& s) { return bits_of(s.verdict) ^ bits_of(s.value); }

/// Calls answer(case) for every case; the processor may overlap several calls.
template <class List, class Answer>
void ask_all(const List& cases, const Answer& answer) {
  Sum sum;
  for (const auto& c : cases) sum += answer(c);
  asm volatile("" : : "g"(sum.count), "x"(sum.values));
}

/// Calls answer(case) for every case, one after the other: the next index depends on the last answer. The processor
/// still predicts branches, as in a program that branches on the answer.
template <class List, class Answer>
void ask_in_turn(const List& cases, const Answer& answer) {
  Sum sum;
  std::uint64_t zero = 0;
  asm volatile("" : "+r"(zero));  // which the compiler can't know
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto told = answer(cases[i]);
    sum += told;
    i += bits_of(told) & zero;
  }
  asm volatile("" : : "g"(sum.count), "x"(sum.values));
}

/// A type-erased method: how to make a pass, how to ask one case.
template <class Case>
struct Entrant {
  std::string name, library;
  std::function<void()> pass;
  std::function<Said(std::size_t)> ask;
  std::function<bool(const Case&)> falls_back;
  std::function<void()> pass_in_turn;  ///< empty where all cases are answered at once
  bool is_exact = false, is_standard = false, gives_values = true;

  Entrant& exact() { return is_exact = true, *this; }
  /// The times of the other methods are shown divided by the time of this one.
  Entrant& standard() { return is_standard = true, *this; }
  /// Whether a case is beyond the floating-point part of the method.
  Entrant& fallback(std::function<bool(const Case&)> falls) { return falls_back = std::move(falls), *this; }
};

template <class S, class Case>
class Contest {
 public:
  Contest(Session& session, CaseFamily<Case> family) : session_(session), family_(std::move(family)) {
    session_.progress(family_.test + ", " + family_.scalar + ", " + family_.name);
    if (!family_.note.empty() && session_.found.note(family_.test, family_.name).empty())
      session_.found.notes.push_back({family_.test, family_.name, family_.note});
    Random random(stream(session.seed, (family_.test + family_.scalar + family_.name).c_str()));
    const long count = std::min(session.effort.cases, family_.most_cases);
    cases_.reserve(static_cast<std::size_t>(count));
    for (long i = 0; i < count; ++i) cases_.push_back(family_.draw(random));
  }
  Contest(const Contest&) = delete;
  Contest& operator=(const Contest&) = delete;

  const std::vector<Case>& cases() const { return cases_; }

  /// answer(case) -> bool, int, std::optional<number> or Said. The Entrant holds until run().
  template <class Method>
  Entrant<Case>& enter(const std::string& name, Method answer, const std::string& library = "isect") {
    Entrant<Case>& entrant = enter_pass(
        name, [this, answer] { ask_all(cases_, answer); },
        [this, answer](std::size_t i) { return said(answer(cases_[i])); }, library);
    entrant.pass_in_turn = [this, answer] { ask_in_turn(cases_, answer); };
    return entrant;
  }

  /// A method that takes all cases at once: `pass` answers them all, `ask` says what it answered for one.
  Entrant<Case>& enter_pass(const std::string& name, std::function<void()> pass, std::function<Said(std::size_t)> ask,
                            const std::string& library = "isect") {
    entrants_.push_back(
        std::make_unique<Entrant<Case>>(Entrant<Case>{name, library, std::move(pass), std::move(ask), {}, {}}));
    return *entrants_.back();
  }

  /// Times and judges every entrant, as far as the session's effort goes, and adds their rows to the session.
  void run() {
    const std::vector<std::vector<double>> times = timed();
    judge_all();
    for (std::size_t k = 0; k < entrants_.size(); ++k)
      if (session_.effort.timed() || entrants_[k]->is_exact)
        session_.found.rows.push_back(row(*entrants_[k], times[k]));
  }

 private:
  double once(const std::function<void()>& pass) const {
    const auto start = std::chrono::steady_clock::now();
    pass();
    const std::chrono::duration<double, std::nano> passed = std::chrono::steady_clock::now() - start;
    return passed.count() / static_cast<double>(cases_.size());
  }

  /// Nanoseconds per case of each pass. The first pass warms up and shows how many passes fit the time.
  std::vector<std::vector<double>> timed() const {
    const Effort& effort = session_.effort;
    std::vector<std::vector<double>> times(entrants_.size());
    std::vector<int> wanted;
    for (const auto& entrant : entrants_) {
      const double seconds = once(entrant->pass) * 1e-9 * static_cast<double>(cases_.size());
      wanted.push_back(std::clamp(static_cast<int>(effort.seconds / std::max(seconds, 1e-9)), effort.least_passes,
                                  effort.most_passes));
    }
    for (int pass = 0; pass < effort.most_passes; ++pass)
      for (std::size_t k = 0; k < entrants_.size(); ++k)
        if (pass < wanted[k]) times[k].push_back(once(entrants_[k]->pass));
    return times;
  }

  /// The median of three passes.
  double latency(const Entrant<Case>& entrant) const {
    std::vector<double> times;
    for (int pass = 0; pass < 3; ++pass) times.push_back(once(entrant.pass_in_turn));
    return Distribution(std::move(times)).quantile(0.5);
  }

  void judge_all() {
    truths_.clear();
    const std::size_t count = std::min(cases_.size(), static_cast<std::size_t>(std::max(0L, session_.effort.judged)));
    for (std::size_t i = 0; i < count; ++i) truths_.push_back(family_.truth(cases_[i]));
  }

  void clock(const Entrant<Case>& entrant, const Distribution& passes, Row& r) const {
    r.ns = passes.quantile(0), r.median = passes.quantile(0.5);
    const Range interval = median_interval(passes.sorted);
    r.lo = interval.lo, r.hi = interval.hi;
    if (!family_.hard && entrant.pass_in_turn) r.latency = latency(entrant);
    r.spread = (passes.quantile(0.75) - passes.quantile(0.25)) / r.median;
  }

  Row row(const Entrant<Case>& entrant, std::vector<double> times) const {
    Row r;
    r.test = family_.test, r.method = entrant.name, r.library = entrant.library;
    r.scalar = family_.scalar, r.family = family_.name;
    r.hard = family_.hard, r.exact = entrant.is_exact, r.standard = entrant.is_standard;
    if (!times.empty()) clock(entrant, Distribution(std::move(times)), r);
    r.cases = static_cast<long>(cases_.size()), r.judged = static_cast<long>(truths_.size());
    judge(entrant, r);
    if (entrant.falls_back) {
      const std::size_t asked = std::min(cases_.size(), std::max<std::size_t>(truths_.size(), 1 << 12));
      const long fell =
          std::count_if(cases_.begin(), cases_.begin() + static_cast<std::ptrdiff_t>(asked), entrant.falls_back);
      r.fallback = static_cast<double>(fell) / static_cast<double>(asked);
    }
    return r;
  }

  /// Infinity for NaN, which can't be sorted and counts as infinitely wrong.
  static double or_infinite(double error) {
    return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
  }

  void judge(const Entrant<Case>& entrant, Row& r) const {
    std::vector<double> ulps, conditioned, residuals;
    constexpr double u = static_cast<double>(std::numeric_limits<S>::epsilon()) / 2;
    for (std::size_t i = 0; i < truths_.size(); ++i) {
      const Truth& truth = truths_[i];
      const Said answer = entrant.ask(i);
      if (truth.side && !r.sides) r.sides = Sides();
      const bool other_side = truth.side && answer.side && *answer.side != *truth.side;
      if (answer.verdict != truth.verdict || other_side) {
        if (truth.side) ++(answer.side == 0 && *truth.side != 0 ? r.sides->called_on : r.sides->wrong_side);
        ++(truth.verdict == 0 ? r.false_yes : r.false_no);
        if (r.first_wrong.empty()) r.first_wrong = family_.text(cases_[i]);
      } else if (answer.value && truth.value) {
        const S value = static_cast<S>(*answer.value);
        const double error = oracle::ulps(value, *truth.value), size = std::abs(truth.value->nearest);
        ulps.push_back(error);
        if (size > 0) {
          const double off = std::abs((*answer.value - truth.value->nearest) - truth.value->rest) / size;
          conditioned.push_back(or_infinite(off / u / std::max(1.0, truth.condition)));
        }
        if (family_.residual) residuals.push_back(or_infinite(family_.residual(cases_[i], *answer.value) / u));
      }
    }
    if (ulps.empty()) return;
    const Distribution errors(std::move(ulps));
    r.ulps = errors.errors(), r.quantiles = errors.curve();
    if (!conditioned.empty()) r.conditioned = Distribution(std::move(conditioned)).errors();
    if (!residuals.empty()) r.residual = Distribution(std::move(residuals)).errors();
  }

  Session& session_;
  CaseFamily<Case> family_;
  std::vector<Case> cases_;
  std::vector<Truth> truths_;
  std::vector<std::unique_ptr<Entrant<Case>>> entrants_;
};

/// Whether a call reported Fallback: run(trace) makes the call.
template <class Run>
bool fell_back(const Run& run) {
  bool once = false;
  run([&once](const auto& event) {
    if (std::is_same_v<std::decay_t<decltype(event)>, Fallback>) once = true;
  });
  return once;
}

template <class S>
constexpr const char* scalar_name = std::is_same_v<S, float> ? "float" : "double";

/// Numbers and vectors in full precision, for Row::first_wrong: text("origin", v, "radius", r).
inline void write(std::ostringstream&) {}
template <class... More>
void write(std::ostringstream& out, const char* name, const auto& value, const More&... more) {
  out << (out.tellp() > 0 ? " " : "") << name << ' ';
  if constexpr (requires {
                  value.size();
                  value[0];
                }) {
    out << '(';
    for (int i = 0; i < static_cast<int>(value.size()); ++i) out << (i > 0 ? ", " : "") << value[i];
    out << ')';
  } else {
    out << value;
  }
  write(out, more...);
}
template <class... Parts>
std::string text(const char* name, const auto& value, const Parts&... more) {
  std::ostringstream out;
  out << std::setprecision(17);
  write(out, name, value, more...);
  return out.str();
}

}  // namespace isect::bench
