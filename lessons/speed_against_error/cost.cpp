// What the exact call costs, how often it needs exact numbers, and what to choose.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "bench/prose.h"
#include "bench/rows.h"
#include "lessons/speed_against_error/telling.h"
#include "viz/chart/chart.h"
#include "viz/text/rich_text.h"

namespace isect::lessons::speed_against_error_lesson {

using namespace viz;
using namespace bench;

namespace {

std::string error_share(const Row& r) {
  return share(static_cast<double>(r.wrong()), static_cast<double>(r.judged)) + " of the cases";
}

/// The number rounded to two digits, as the sentence beside it shows it.
double two_digits(double x) {
  const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
  return std::round(x / unit) * unit;
}

}  // namespace

std::pair<std::string, double> Teller::dearest() const {
  std::pair<std::string, double> most = {ordinary_, 0};
  for (const std::string& family : families_of(rows_)) {
    if (standard_of(of(family)) == nullptr || exact_of(of(family)) == nullptr) continue;
    if (const double times = exact(family).ns / naive(family).ns; times > most.second) most = {family, times};
  }
  return most;
}

std::string Teller::naive_there(const std::string& family) const {
  const Row& plain = naive(family);
  if (plain.wrong() == 0) return "There no verdict of the naive method is wrong.";
  return "There the naive method is wrong on " + error_share(plain) + (by_convention(plain) ? ", by convention." : ".");
}

std::string Teller::cost_when_hard() const {
  int hard = 0, slower = 0;
  for (const std::string& family : families_of(rows_)) {
    if (standard_of(of(family)) == nullptr || exact_of(of(family)) == nullptr || !exact(family).hard) continue;
    ++hard;
    slower += exact(family).ns > naive(family).ns && differ(exact(family).ns, naive(family).ns);
  }
  if (slower == 0) return {};
  const auto [family, times] = dearest();
  const std::string where = slower == hard ? (hard == 1 ? "the hard family" : "every hard family")
                                           : fmt::format("{} of {} hard families", slower, hard);
  return fmt::format("\nOn {} the exact call takes longer, at most {} times as long: on “{}”. {}", where,
                     ratio_text(times), words(family), naive_there(family));
}

void Teller::cost() {
  Bars bars = {{Scale::Kind::log, 0.5, 2, "time of the exact call / time of " + name_of(naive(ordinary_))},
               {{"exact", Glyph::star, Role::hit}},
               {},
               "as fast"};
  const auto [worst, most] = dearest();
  for (const std::string& family : families_of(rows_)) {
    if (standard_of(of(family)) == nullptr || exact_of(of(family)) == nullptr) continue;
    const double times = exact(family).ns / naive(family).ns;
    bars.bars.push_back({as_markup(words(family)), {{0, times}}, 1.0, ratio_text(times), Verdict::Kind::open});
    bars.x.lo = std::min(bars.x.lo, times / 1.5), bars.x.hi = std::max(bars.x.hi, 1.5 * times);
  }
  const double usual = exact(ordinary_).ns / naive(ordinary_).ns;
  values(ordinary_);
  script_.value("cost, ordinary", two_digits(usual), "times");
  script_.value("cost, most", two_digits(most), "times");
  const std::string noise = differ(exact(ordinary_).ns, naive(ordinary_).ns) ? "" : ", no difference beyond the noise";
  Step& step = script_.add("cost", "What exactness costs", cost_line,
                           fmt::format("On ordinary cases the exact call takes {} times as long as {}{}. It "
                                       "loses most on “{}”: {} times as long.\n{}",
                                       ratio_text(usual), name_of(naive(ordinary_)), noise, words(worst),
                                       ratio_text(most), naive_there(worst)));
  show(step, {bars});

  const int bucket = noise.empty() ? (usual < 1 ? 0 : usual <= 3 ? 2 : usual <= 10 ? 3 : 4) : 1;
  step.question = Question{
      "On ordinary cases, not the hard ones told last: how long does the exact call take, compared with the naive "
      "method?",
      {"clearly less long", "as long, within the noise", "longer, up to 3 times", "3 to 10 times as long",
       "more than 10 times as long"},
      bucket,
      fmt::format("It takes {} ns, the naive method {} ns.", shown(exact(ordinary_).ns), shown(naive(ordinary_).ns))};
  Scene ordinary;
  ordinary.chart = std::make_shared<const Chart>(Chart{plot({ordinary_})});
  step.question->over = ordinary;
}

void Teller::fallback() {
  if (!exact(ordinary_).fallback) return;
  Bars bars = {{Scale::Kind::linear, 0, 100, "calls that need more than floating point (%)"},
               {{"exact", Glyph::star, Role::hit}},
               {}};
  for (const std::string& family : families_of(rows_))
    if (exact_of(of(family)) != nullptr && exact(family).fallback) {
      const double part = *exact(family).fallback;
      bars.bars.push_back({as_markup(words(family)), {{0, 100 * part}}, {}, share(part, 1), Verdict::Kind::open});
    }
  Step& step =
      script_.add("fall-back", "When floating point is not enough", cost_line,
                  fmt::format("The exact call first computes in floating point, with a proved bound on the error. Only "
                              "where the bound leaves "
                              "the sign open, it computes again, exactly.\nOf the ordinary calls this happens to {}.",
                              share(*exact(ordinary_).fallback, 1)));
  show(step, {bars});
}

void Teller::choose() {
  const Row &plain = naive(ordinary_), &right = exact(ordinary_), &fast = rival();
  const std::string name = name_of(plain), faster = name_of(fast);
  long plainly_wrong = 0;
  for (const Row* r : rows_)
    if (name_of(*r) == name) plainly_wrong += r->wrong();
  std::vector<std::string> others;
  for (const Row* r : as_fast_as(fast))
    if (name_of(*r) != faster) others.push_back(name_of(*r));
  const bool saves = fast.ns < right.ns && differ(fast.ns, right.ns);
  const bool no_dearer = right.ns <= plain.ns || !differ(right.ns, plain.ns);
  const std::string errs =
      fmt::format("That is wrong on {} of the hard cases, the exact call on none.{}", share(wrong_when_hard(fast), 1),
                  others.empty() ? "" : fmt::format(" As fast, within the noise: {}.", fmt::join(others, ", ")));
  std::string text, verdict = "choose the exact call";
  if (no_dearer && !saves)
    text = fmt::format(
        "On ordinary cases the exact call costs no more than {}. No method that is right there is faster, beyond the "
        "noise.{}",
        name, cost_when_hard());
  else if (no_dearer)
    text =
        fmt::format("On ordinary cases the exact call costs no more than {}. Faster there is {}, by {} ns a call. {}{}",
                    name, faster, shown(right.ns - fast.ns), errs, cost_when_hard()),
    verdict = "choose the exact call, or " + faster + " where every input is ordinary";
  else if (plainly_wrong > 0)
    text = fmt::format(
        "With {}, an ordinary call takes {} ns less. {}\n"
        "If you need that time, be sure that every input is ordinary. Otherwise use the exact call.",
        faster, shown(right.ns - fast.ns), errs);
  else
    text = fmt::format("No case judged here broke {}. Only the exact call promises that none does.", name),
    verdict = "choose " + name + " for speed, the exact call for certainty";
  script_.settle(Verdict::Kind::yes, verdict);
  std::vector<std::string> families = {ordinary_};
  families.insert(families.end(), hard_.begin(), hard_.end());
  Step& step = script_.add("choose", "What to choose", choose_line, text);
  step.decides = true;
  show(step, {plot(families)});
}

}  // namespace isect::lessons::speed_against_error_lesson
