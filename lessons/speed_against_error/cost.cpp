// What the exact call costs, how often it needs exact numbers, and what to choose.

#include <fmt/format.h>

#include <algorithm>

#include "bench/prose.h"
#include "bench/rows.h"
#include "lessons/speed_against_error/telling.h"
#include "viz/chart.h"

namespace isect::lessons::speed_lesson {

using namespace viz;
using namespace bench;

void Teller::cost() {
  Bars bars = {{Scale::Kind::log, 0.5, 2, "time of the exact call / time of " + name_of(naive(ordinary_))},
               {{"exact", Glyph::star, Role::hit}},
               {},
               "as fast"};
  double most = 0;
  std::string worst;
  for (const std::string& family : families_of(rows_)) {
    if (standard_of(of(family)) == nullptr || exact_of(of(family)) == nullptr) continue;
    const double times = exact(family).ns / naive(family).ns;
    bars.bars.push_back({as_markup(words(family)), {{0, times}}, 1.0, ratio(times), Verdict::Kind::open});
    bars.x.lo = std::min(bars.x.lo, times / 1.5), bars.x.hi = std::max(bars.x.hi, 1.5 * times);
    if (times > most) most = times, worst = family;
  }
  const double usual = exact(ordinary_).ns / naive(ordinary_).ns;
  script_.value("cost, ordinary", usual, "times");
  script_.value("cost, most", most, "times");
  Step& step = script_.add("cost", "What exactness costs", cost_line,
                           fmt::format("On ordinary cases the exact call takes {} times as long as {}. It "
                                       "takes longest on {}: {} times as long.\n"
                                       "There the naive method is fast, and unreliable.",
                                       ratio(usual), name_of(naive(ordinary_)), words(worst), ratio(most)));
  show(step, {bars});

  const int bucket = usual <= 1.1 ? 0 : usual <= 3 ? 1 : usual <= 10 ? 2 : 3;
  step.question = Question{
      "How much longer than the naive method does the exact call take on ordinary cases?",
      {"no longer", "up to 3 times as long", "3 to 10 times as long", "more than 10 times as long"},
      bucket,
      fmt::format("It takes {} ns, the naive method {} ns.", number(exact(ordinary_).ns), number(naive(ordinary_).ns))};
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
                  fmt::format("The exact call first computes in floating point, with a proved bound of the error. Only "
                              "where the bound leaves "
                              "the sign open, it computes again, exactly.\nOf the ordinary calls this happens to {}.",
                              share(*exact(ordinary_).fallback, 1)));
  show(step, {bars});
}

void Teller::choose() {
  long wrong = 0;
  for (const Row* r : rows_)
    if (name_of(*r) == name_of(naive(ordinary_))) wrong += r->wrong();
  const double usual = exact(ordinary_).ns / naive(ordinary_).ns;
  const std::string name = name_of(naive(ordinary_));
  std::string text, verdict = "choose the exact call";
  if (usual <= 1.1)
    text = fmt::format("The exact call costs no more than {}. There is no reason to choose another.", name);
  else if (wrong > 0)
    text = fmt::format(
        "The difference on ordinary cases is {} ns a call. Who needs it must know that all cases are "
        "ordinary.\nElse the exact call is right on every one.",
        number(exact(ordinary_).ns - naive(ordinary_).ns));
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

}  // namespace isect::lessons::speed_lesson
