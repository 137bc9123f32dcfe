#include "lessons/speed_against_error/teller.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/prose.h"
#include "bench/report_text.h"
#include "bench/rows.h"
#include "viz/chart.h"

namespace isect::lessons::speed_lesson {
namespace {

using namespace viz;
using namespace bench;

constexpr int time_line = 0, judge_line = 1, front_line = 2, hard_line = 3, wrong_line = 4, cost_line = 5,
              choose_line = 6;

const std::vector<std::string>& pseudocode() {
  static const std::vector<std::string> lines = {
      "time each method: least of several passes",
      "judge each answer by the exact oracle",
      "front = methods that no other beats in both",
      "repeat on the hard families",
      "count the wrong verdicts",
      "cost = time of exact call / time of naive one",
      "choose by the cost, and by what an error costs",
  };
  return lines;
}

Opening opening(const Report& report, const std::string& test) {
  const Machine& m = report.machine;
  return {.source = fmt::format("measured on {}, {}, {}, {}", m.cpu, m.compiler, m.flags, m.date),
          .alt = fmt::format(
              "Charts of the time of a call against its error, for every method of {} in double.", test),
          .pseudocode = pseudocode(),
          .method = test};
}

/// The only element with the greatest value, or none where two share it.
template <class List, class Value>
std::optional<std::size_t> only_greatest(const List& list, const Value& value) {
  if (list.empty()) return {};
  std::size_t best = 0;
  for (std::size_t i = 1; i < list.size(); ++i)
    if (value(*list[i]) > value(*list[best])) best = i;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (i != best && !(value(*list[i]) < value(*list[best]))) return {};
  return best;
}

}  // namespace

std::vector<std::string> tests(const Report& report) {
  std::vector<std::string> all;
  for (const std::string& test : tests_of(report)) {
    const std::vector<const Row*> rows = rows_of(report, test, "double");
    if (standard_of(rows) != nullptr && exact_of(rows) != nullptr && families_of(rows).size() > 1)
      all.push_back(test);
  }
  std::ranges::stable_partition(all, [](const std::string& test) { return test == "ray-sphere"; });  // first
  return all;
}

Teller::Teller(const Report& report, const std::string& test)
    : report_(report), test_(test), rows_(rows_of(report, test, "double")), script_(opening(report, test)) {
  by_value_ = std::ranges::any_of(rows_, [](const Row* r) { return r->ulps.has_value(); });
  for (const Row* r : rows_) {
    if (!r->standard) continue;
    if (!r->hard && ordinary_.empty()) ordinary_ = r->family;
    if (r->hard && exact_of(of(r->family)) != nullptr) hard_.push_back(r->family);
  }
  // Of rays and spheres these tell most, in this order; of other tests, what breaks the naive method worst.
  const std::vector<std::string> telling = {"near-tangent", "far-small", "planet"};
  if (std::ranges::all_of(telling,
                          [&](const std::string& f) { return std::ranges::find(hard_, f) != hard_.end(); })) {
    hard_ = telling;
    return;
  }
  std::ranges::stable_sort(hard_, std::greater{}, [&](const std::string& f) {
    return naive(f).wrong_per_million() +
           (by_value_ && naive(f).ulps ? 1e4 * bits(naive(f).ulps->median) : 0);
  });
  if (hard_.size() > 3) hard_.resize(3);
}

Teller::Rows Teller::of(const std::string& family) const { return rows_of(report_, test_, "double", family); }
const Row& Teller::naive(const std::string& family) const { return *standard_of(of(family)); }
const Row& Teller::exact(const std::string& family) const { return *exact_of(of(family)); }

double Teller::error(const Row& r) const {
  return !by_value_ ? r.wrong_per_million() : r.ulps ? r.ulps->p99 : NAN;
}

std::string Teller::error_text(const Row& r) const {
  if (by_value_) return number(error(r)) + " ulp";
  return r.wrong() == 0 ? "no wrong verdict"
                        : share(static_cast<double>(r.wrong()), static_cast<double>(r.judged)) + " wrong";
}

Plot Teller::plot(const std::vector<std::string>& families) const {
  const Plotted plotted = by_value_ ? error_plot(report_, test_, "double", families)
                                    : verdict_plot(report_, test_, "double", families);
  return std::get<Plot>(plotted.chart.kind);
}

void Teller::show(Step& step, Chart chart) const {
  step.scene.chart = std::make_shared<const Chart>(std::move(chart));
}

/// Times and errors of the naive and of the exact method, for the step that comes next.
void Teller::values(const std::string& family) {
  for (const Row* r : {&naive(family), &exact(family)}) {
    script_.value(name_of(*r) + ": time", r->ns, "ns", r->exact ? Role::hit : Role::muted);
    script_.value(name_of(*r) + (by_value_ ? ": error, ulp" : ": wrong of a million"), error(*r), "",
                  r->exact ? Role::hit : Role::muted);
  }
}

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
  show(script_.add("axes", "Time across, error up", time_line,
                   fmt::format("One marker is one method: here {}, which takes {} ns a call. Further right "
                               "is slower. {}\nThe time is the "
                               "least of several passes over {} different cases.",
                               name, number(naive(ordinary_).ns),
                               by_value_ ? "Higher up, its value is further off. The marker stands at the "
                                           "99th percentile, the bar reaches down to the median."
                                         : "Higher up, more of its verdicts are wrong.",
                               count(naive(ordinary_).cases))),
       {p});
}

void Teller::methods() {
  Plot p = plot({ordinary_});
  for (Panel& panel : p.panels)
    for (Spot& s : panel.spots) s.front = false;
  const Rows rows = of(ordinary_);
  const Row* fastest = *std::ranges::min_element(rows, {}, &Row::ns);
  show(script_.add(
           "ordinary", "Ordinary cases", judge_line,
           fmt::format("All {} methods on the same ordinary cases, judged by an exact oracle. The fastest is "
                       "{}, at {} ns. The exact call takes {} ns.\n{}",
                       rows.size(), name_of(*fastest), number(fastest->ns), number(exact(ordinary_).ns),
                       by_value_
                           ? fmt::format("Up to the 99th percentile {} errs by {}, the exact call by {}.",
                                         name_of(naive(ordinary_)), error_text(naive(ordinary_)),
                                         error_text(exact(ordinary_)))
                           : fmt::format("{}: {}.", sentence(name_of(naive(ordinary_))),
                                         error_text(naive(ordinary_))))),
       {p});
}

void Teller::front() {
  const Rows rows = of(ordinary_), front = front_of(rows, by_value_);
  std::vector<std::string> names;
  for (const Row* r : front) names.push_back(name_of(*r));
  Step& step = script_.add(
      "front", "What nothing beats", front_line,
      fmt::format(
          "Steps join the methods on the front. No other is both as fast and as accurate. What lies on the "
          "tinted side is beaten.\nOn the front here: {}.",
          listed(names)));
  show(step, {plot({ordinary_})});

  Question q = {"Which of these does no other method beat in both time and error?", {}, 0, ""};
  for (const Row* r : rows) {
    if (std::ranges::find(front, r) != front.end() || q.choices.size() > 2) continue;
    q.choices.push_back(name_of(*r));
  }
  if (q.choices.empty()) return;
  q.answer = static_cast<int>(q.choices.size() / 2);
  q.choices.insert(q.choices.begin() + q.answer, name_of(*front.front()));
  q.because =
      fmt::format("{} takes {} ns, with {}. Each of the others is beaten by some method.",
                  sentence(name_of(*front.front())), number(front.front()->ns), error_text(*front.front()));
  step.question = q;
}

void Teller::hard_family(const std::string& family, bool first) {
  values(family);
  const std::string note = family_note(test_, family);
  std::string text =
      note.empty() ? fmt::format("A family made to break naive methods: {}.", words(family)) : sentence(note);
  text += fmt::format("\n{}: {}. The exact call: {}, in {} ns.", sentence(name_of(naive(family))),
                      error_text(naive(family)), error_text(exact(family)), number(exact(family).ns));
  if (by_value_ && naive(family).wrong() > 0)
    text += fmt::format(
        " Besides, {} of the verdicts of {} are wrong.",
        share(static_cast<double>(naive(family).wrong()), static_cast<double>(naive(family).judged)),
        name_of(naive(family)));
  Plot p = plot({ordinary_, family});
  for (Panel& panel : p.panels) panel.muted = panel.title != as_markup(words(family));
  std::string slug = words(family);
  std::ranges::transform(slug, slug.begin(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) ? static_cast<char>(std::tolower(c)) : '-';
  });
  Step& step = script_.add(slug, sentence(words(family)), hard_line, text);
  show(step, {p});
  if (!first) return;

  const Rows rows = of(family);
  const auto greatest =
      only_greatest(rows, [&](const Row& r) { return by_value_ ? bits(error(r)) : error(r); });
  if (!greatest || rows.size() < 3) return;
  Question q = {fmt::format("Which method errs most on the family “{}”?", words(family)), {}, 0, ""};
  for (std::size_t i = 0; i < rows.size() && q.choices.size() < 4; ++i) {
    const bool room = q.choices.size() < 3 || i >= *greatest;
    if (i == *greatest) q.answer = static_cast<int>(q.choices.size());
    if (room) q.choices.push_back(name_of(*rows[i]));
  }
  if (q.answer >= static_cast<int>(q.choices.size()) ||
      q.choices[static_cast<std::size_t>(q.answer)] != name_of(*rows[*greatest]))
    return;
  q.because = fmt::format("{}: {}.", sentence(name_of(*rows[*greatest])), error_text(*rows[*greatest]));
  step.question = q;
}

void Teller::fall() {
  const Row* worst = nullptr;
  for (const Row* r : rows_)
    if (r->wrong() > 0 && (worst == nullptr || r->wrong_per_million() > worst->wrong_per_million()))
      worst = r;
  if (worst == nullptr) return;
  long wrong = 0, judged = 0;
  for (const Row* r : rows_)
    if (r->exact && r->library == "isect") wrong += r->wrong(), judged += r->judged;
  std::vector<std::string> families = {
      ordinary_};  // and the three on which the naive method is wrong most often
  Rows rows;
  for (const std::string& family : families_of(rows_))
    if (const Row* r = standard_of(of(family)); r != nullptr && r->hard) rows.push_back(r);
  std::ranges::stable_sort(rows, std::greater{}, &Row::wrong_per_million);
  for (const Row* r : rows)
    if (families.size() < 4) families.push_back(r->family);
  const Plotted plotted = verdict_plot(report_, test_, "double", families);
  Step& step =
      script_.add("wrong-verdicts", "Where naive methods fall", wrong_line,
                  fmt::format("A wrong verdict is worse than lost bits: yes became no. {} does worst on {}: "
                              "{} of its verdicts are wrong.\n"
                              "Exact calls were wrong {} times in {}.",
                              sentence(name_of(*worst)), words(worst->family),
                              share(static_cast<double>(worst->wrong()), static_cast<double>(worst->judged)),
                              wrong, count(judged)));
  show(step, plotted.chart);
}

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
  step.question =
      Question{"How much longer than the naive method does the exact call take on ordinary cases?",
               {"no longer", "up to 3 times as long", "3 to 10 times as long", "more than 10 times as long"},
               bucket,
               fmt::format("It takes {} ns, the naive method {} ns.", number(exact(ordinary_).ns),
                           number(naive(ordinary_).ns))};
}

void Teller::fallback() {
  if (!exact(ordinary_).fallback) return;
  Bars bars = {{Scale::Kind::linear, 0, 100, "calls that need more than floating point (%)"},
               {{"exact", Glyph::star, Role::hit}},
               {}};
  for (const std::string& family : families_of(rows_))
    if (exact_of(of(family)) != nullptr && exact(family).fallback) {
      const double part = *exact(family).fallback;
      bars.bars.push_back(
          {as_markup(words(family)), {{0, 100 * part}}, {}, share(part, 1), Verdict::Kind::open});
    }
  Step& step = script_.add(
      "fall-back", "When floating point is not enough", cost_line,
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

Walk Teller::walk() {
  axes();
  methods();
  front();
  for (const std::string& family : hard_) hard_family(family, family == hard_.front());
  fall();
  cost();
  fallback();
  choose();
  return std::move(script_.walk());
}

}  // namespace isect::lessons::speed_lesson
