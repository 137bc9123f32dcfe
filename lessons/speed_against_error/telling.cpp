// The measurements that all steps read, and the order of the steps.

#include "lessons/speed_against_error/telling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/prose.h"
#include "bench/rows.h"

namespace isect::lessons::speed_against_error_lesson {
namespace {

using namespace viz;
using namespace bench;

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

Opening head_of(const Report& report, const std::string& test) {
  const Machine& m = report.machine;
  return {.source = fmt::format("measured on {}, {}, {}, {}", m.cpu, m.compiler, m.flags, m.date),
          .alt = fmt::format("Charts of the time of a call against its error, for every method of {} in double.", test),
          .pseudocode = pseudocode(),
          .method = test};
}

}  // namespace

std::vector<std::string> tests(const Report& report) {
  std::vector<std::string> all;
  for (const std::string& test : tests_of(report)) {
    const std::vector<const Row*> rows = rows_of(report, test, "double");
    if (standard_of(rows) != nullptr && exact_of(rows) != nullptr && families_of(rows).size() > 1) all.push_back(test);
  }
  std::stable_partition(all.begin(), all.end(), [](const std::string& test) { return test == "ray-sphere"; });  // first
  return all;
}

Teller::Teller(const Report& report, const std::string& test)
    : report_(report), test_(test), rows_(rows_of(report, test, "double")), script_(head_of(report, test)) {
  by_value_ = std::ranges::any_of(rows_, [](const Row* r) { return r->ulps.has_value(); });
  for (const Row* r : rows_) {
    if (!r->standard) continue;
    if (!r->hard && ordinary_.empty()) ordinary_ = r->family;
    if (r->hard && exact_of(of(r->family)) != nullptr) hard_.push_back(r->family);
  }
  // For rays and spheres these families show most, in this order; for other tests those worst for the naive method.
  const std::vector<std::string> telling = {"near-tangent", "far-small", "planet"};
  if (std::ranges::all_of(telling, [&](const std::string& f) { return std::ranges::find(hard_, f) != hard_.end(); })) {
    hard_ = telling;
    return;
  }
  std::ranges::stable_sort(hard_, std::greater{}, [&](const std::string& f) {
    return naive(f).wrong_per_million() + (by_value_ && naive(f).ulps ? 1e4 * bits(naive(f).ulps->median) : 0);
  });
  if (hard_.size() > 3) hard_.resize(3);
}

Teller::Rows Teller::of(const std::string& family) const { return rows_of(report_, test_, "double", family); }
const Row& Teller::naive(const std::string& family) const { return *standard_of(of(family)); }
const Row& Teller::exact(const std::string& family) const { return *exact_of(of(family)); }

bool Teller::differ(double a, double b) const { return std::max(a, b) / std::min(a, b) > 1 + report_.machine.noise; }

const Row& Teller::rival() const {
  const Row* best = &naive(ordinary_);
  for (const Row* r : of(ordinary_))
    if (r->library == "isect" && !r->exact && r->wrong() == 0 && (best->wrong() > 0 || r->ns < best->ns)) best = r;
  const Row* rival = best;
  for (const Row* r : as_fast_as(*best))
    if (wrong_when_hard(*r) < wrong_when_hard(*rival)) rival = r;
  return *rival;
}

Teller::Rows Teller::as_fast_as(const Row& best) const {
  Rows all = of(ordinary_);
  std::erase_if(
      all, [&](const Row* r) { return r->library != "isect" || r->exact || r->wrong() > 0 || differ(r->ns, best.ns); });
  return all;
}

double Teller::wrong_when_hard(const Row& method) const {
  long wrong = 0, judged = 0;
  for (const Row* r : rows_)
    if (name_of(*r) == name_of(method) && r->hard) wrong += r->wrong(), judged += r->judged;
  return judged > 0 ? static_cast<double>(wrong) / static_cast<double>(judged) : 0;
}

double Teller::error(const Row& r) const { return !by_value_ ? r.wrong_per_million() : r.ulps ? r.ulps->p99 : NAN; }

std::string Teller::error_text(const Row& r) const {
  if (by_value_) return shown(error(r)) + " ulp";
  return r.wrong() == 0 ? "no wrong verdict"
                        : share(static_cast<double>(r.wrong()), static_cast<double>(r.judged)) + " wrong";
}

Plot Teller::plot(const std::vector<std::string>& families) const {
  const Plotted plotted =
      by_value_ ? error_plot(report_, test_, "double", families) : verdict_plot(report_, test_, "double", families);
  return std::get<Plot>(plotted.chart.kind);
}

void Teller::show(Step& step, Chart chart) const { step.scene.chart = std::make_shared<const Chart>(std::move(chart)); }

/// Sets the times and errors of the naive and of the exact method for the next step.
void Teller::values(const std::string& family) {
  for (const Row* r : {&naive(family), &exact(family)}) {
    script_.value(name_of(*r) + ": time", r->ns, "ns", r->exact ? Role::hit : Role::muted);
    script_.value(name_of(*r) + (by_value_ ? ": error, ulp" : ": wrong of a million"), error(*r), "",
                  r->exact ? Role::hit : Role::muted);
  }
}

Walk Teller::tell() {
  axes();
  methods();
  front();
  typical_cases();
  for (const std::string& family : hard_) hard_family(family, family == hard_.front());
  others();
  fall();
  cost();
  fallback();
  choose();
  return std::move(script_.walk());
}

}  // namespace isect::lessons::speed_against_error_lesson
