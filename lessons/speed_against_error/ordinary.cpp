// The ordinary cases: what the axes mean, how all methods do, and which of them nothing beats.

#include <fmt/format.h>

#include <algorithm>

#include "bench/prose.h"
#include "bench/rows.h"
#include "lessons/shared/plural.h"
#include "lessons/shared/questions.h"
#include "lessons/speed_against_error/telling.h"

namespace isect::lessons::speed_against_error_lesson {

using namespace viz;
using namespace bench;

void Teller::axes() {
  Plot p = plot({ordinary_});
  const std::string name = name_of(naive(ordinary_));
  const auto series = std::ranges::find_if(p.series, [&](const Series& s) { return s.name == name; });
  const int index = static_cast<int>(series - p.series.begin());
  for (Panel& panel : p.panels) {
    std::erase_if(panel.spots, [&](const Spot& s) { return s.series != index; });
    for (Spot& s : panel.spots) s.front = false;
  }
  values(ordinary_);
  show(script_.add(
           "axes", "Time across, error up", time_line,
           fmt::format(
               "One marker is one method: here {}, which takes {} ns per call. Farther right "
               "is slower. {}\nThe time is the "
               "least of several passes over {} different cases.",
               name, shown(naive(ordinary_).ns),
               by_value_
                   ? "Higher up, its value is less accurate, in ulp: units in the last place. The marker shows the "
                     "99th percentile, the bar reaches down to the median."
                   : "Higher up, more of its verdicts are wrong.",
               counted(naive(ordinary_).cases))),
       {p});
}

void Teller::methods() {
  Plot p = plot({ordinary_});
  for (Panel& panel : p.panels)
    for (Spot& s : panel.spots) s.front = false;
  const Rows rows = of(ordinary_);
  const Row* fastest = *std::ranges::min_element(rows, {}, &Row::ns);
  const auto as_fast = std::ranges::count_if(rows, [&](const Row* r) { return !differ(r->ns, fastest->ns); });
  const bool exact_alone = as_fast == 1 && fastest->exact;  // then the step has already named its time
  const std::string speed =
      as_fast == 1
          ? fmt::format("The fastest is {}, at {} ns.{}", name_of(*fastest), shown(fastest->ns), exact_alone ? "" : " ")
          : fmt::format("The least time is {} ns. Within the noise of {}, {} methods are as fast. ", shown(fastest->ns),
                        share(report_.machine.noise, 1), as_fast);
  const std::string exact_time =
      exact_alone ? "" : fmt::format("The exact call takes {} ns.", shown(exact(ordinary_).ns));
  show(script_.add("ordinary", "Ordinary cases", judge_line,
                   fmt::format("All {} methods on the same ordinary cases, judged by an exact oracle. {}{}\n{}",
                               rows.size(), speed, exact_time,
                               by_value_ ? fmt::format("Up to the 99th percentile {} errs by {}, the exact call by {}.",
                                                       name_of(naive(ordinary_)), error_text(naive(ordinary_)),
                                                       error_text(exact(ordinary_)))
                                         : fmt::format("{}: {}.", sentence(name_of(naive(ordinary_))),
                                                       error_text(naive(ordinary_))))),
       {p});
}

void Teller::front() {
  const Rows rows = of(ordinary_), front = front_of(rows, by_value_);
  Step& step = script_.add(
      "front", "What nothing beats", front_line,
      fmt::format("Steps join the methods on the Pareto front: nothing measured was both as fast and as accurate. What "
                  "lies on the tinted side is dominated.\n{} of {} methods {} on it here. Differences within the noise "
                  "of {} may put others there.",
                  front.size(), rows.size(), front.size() == 1 ? "is" : "are", share(report_.machine.noise, 1)));
  show(step, {plot({ordinary_})});

  // Whether, for times as noisy as these, some method may be dominated or not
  const auto unclear = [&](const Row* r) {
    return std::ranges::any_of(rows, [&](const Row* other) { return other != r && !differ(r->ns, other->ns); });
  };
  if (std::ranges::any_of(rows, unclear)) return;
  const double kept = static_cast<double>(front.size()), all = static_cast<double>(rows.size());
  std::vector<std::string> names;
  for (const Row* r : front) names.push_back(name_of(*r));
  step.question = which_count(
      fmt::format("A method is dominated if another is no slower and no less accurate, and better in one of both. How "
                  "many of the {} are not?",
                  rows.size()),
      kept,
      {{1, "That counts one alone. One that is slower, but more accurate, is not dominated by it."},
       {std::min(kept + 1, all), "At least one of these is dominated."},
       {all, "That counts every method, but some are dominated."}},
      sentence(listed(names)) + ".");
  keep_picture(script_.walk());
}

}  // namespace isect::lessons::speed_against_error_lesson
