// Which targets were met, and everything in which isect is behind.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "bench/findings.h"
#include "bench/prose.h"
#include "bench/report_text.h"
#include "bench/rows.h"
#include "bench/targets.h"

namespace isect::bench {
namespace {

/// Isect's time at one size: of the method "exact" if there is one, else of the fastest; `of` is null without any.
struct AtSize {
  const Growth* of = nullptr;
  double ns = 0;
};
AtSize least_of_ours(const Report& report, const Growth& theirs, double n) {
  AtSize best;
  for (const Growth& g : report.growths) {
    if (g.library != "isect" || g.test != theirs.test || g.unit != theirs.unit) continue;
    const auto at = std::ranges::find(g.n, n);
    if (at == g.n.end() || (best.of != nullptr && best.of->method == "exact")) continue;
    const double ns = g.ns[static_cast<std::size_t>(at - g.n.begin())];
    if (best.of == nullptr || g.method == "exact" || ns < best.ns) best = {&g, ns};
  }
  return best;
}

/// Where another library takes less than 0.9 of isect's time, at the largest size that it was measured at.
std::vector<std::string> growth_losses(const Report& report) {
  std::vector<std::string> lines;
  for (const Growth& g : report.growths) {
    if (g.library == "isect" || g.n.empty()) continue;
    const AtSize ours = least_of_ours(report, g, g.n.back());
    if (ours.of != nullptr && g.ns.back() < 0.9 * ours.ns)
      lines.push_back(fmt::format("{}{}, n = 10^{:g}: {} takes {} of the time of {}.", sentence(g.test),
                                  g.test.find(g.unit) == g.test.npos ? ", " + g.unit : "", std::log10(g.n.back()),
                                  name_of(g), ratio_text(g.ns.back() / ours.ns), name_of(*ours.of)));
  }
  return lines;
}

std::vector<const Report*> all_of(const Measured& m) {
  std::vector<const Report*> all = {&m.portable};
  if (m.native) all.push_back(&*m.native);
  if (m.peers) all.push_back(&*m.peers);
  return all;
}

}  // namespace

std::string target_text(const Measured& m) {
  std::string text =
      "## Targets\n\nRatios are within one run. Rows that name another library come from the run beside other "
      "libraries; `-frounding-math`, which some of those need, slows some naive methods. Worst family: the exact "
      "call's "
      "time divided by the naive method's, in double or float, where that is most. Exact touch: its time on shapes of "
      "integers or tenths that touch, divided by that on ordinary cases.\n\n| work | target | portable | native | "
      "beside others |\n| --- | --- | --- | "
      "--- | --- |\n";
  int reached = 0, missed = 0, open = 0, absent = 0;
  for (const Target& t : m.portable.targets) {
    const bool on_hard_input = t.kind == Target::hard || t.kind == Target::touch;
    if (on_hard_input && !measured(t, m.portable)) {  // the test has no such family
      ++absent;
      continue;
    }
    std::string row = fmt::format("| {} | {} |", t.work, wanted(t));
    std::optional<bool> all;
    for (const Report* r : {&m.portable, m.native ? &*m.native : nullptr, m.peers ? &*m.peers : nullptr}) {
      const std::optional<double> value = r != nullptr ? measured(t, *r) : std::nullopt;
      row += value ? fmt::format(" {}{} |", told(t, *r), !t.at_most ? "" : met(t, *value) ? " ✓" : " ✗ missed") : " |";
      if (value && t.at_most) all = all.value_or(true) && met(t, *value);
    }
    text += row + '\n';
    if (t.at_most) ++(!all ? open : *all ? reached : missed);
  }
  text += fmt::format("\n{} met, {} missed, {} not measured.", reached, missed, open);
  return text + (absent > 0 ? fmt::format(" {} more are about families that their test does not have.", absent) : "") +
         "\n\n";
}

std::string loss_text(const Measured& m) {
  std::vector<std::string> lines;
  for (const Target& t : m.portable.targets) {
    std::vector<std::string> runs;
    for (const Report* r : all_of(m))
      if (const auto value = measured(t, *r); value && !met(t, *value))
        runs.push_back(fmt::format("{} ({})", told(t, *r), r->machine.build));
    if (!runs.empty())
      lines.push_back(fmt::format("Target missed: {}: {}; wanted {}.{}{}", t.work, listed(runs), wanted(t),
                                  t.limit.empty() ? "" : " ", t.limit));
  }
  for (const std::string& test : tests_of(m.portable)) {
    const Findings d(m.portable, test, "double");
    if (d.naive == nullptr || d.exact == nullptr) continue;
    const Row* worst = nullptr;
    double most = 0;
    for (const Row* r : d.of(*d.exact))
      if (const Row* naive = d.same_family(*r, *d.naive); naive != nullptr && r->median / naive->median > most)
        worst = r, most = r->median / naive->median;
    if (worst != nullptr && most > 2 && faster(*d.same_family(*worst, *d.naive), *worst, d.noise))
      lines.push_back(fmt::format("{}: the exact call takes {} times the time of {} on \"{}\" ({} ns).", sentence(test),
                                  ratio_text(most), name_of(*d.naive), words(worst->family), number(worst->median)));
  }
  if (m.peers)
    for (const std::string& test : tests_of(*m.peers)) {
      const Findings p(*m.peers, test, "double");
      if (p.exact == nullptr) continue;
      for (const Row* r : p.ordinary)
        if (r->library != "isect" && faster(*r, *p.exact, p.noise))
          lines.push_back(
              fmt::format("{}: {} is faster on ordinary cases, {} ns against {} ns{}.", sentence(test), name_of(*r),
                          number(r->median), number(p.exact->median),
                          total_wrong(p.of(*r)) == 0
                              ? is_judged_on_hard(p.of(*r)) ? ", and was never wrong" : "; it met no hard case"
                              : fmt::format("; it is wrong on {} of all cases judged",
                                            share(static_cast<double>(total_wrong(p.of(*r))),
                                                  static_cast<double>(total_judged(p.of(*r)))))));
    }
  if (m.peers)
    for (const std::string& line : growth_losses(*m.peers)) lines.push_back(line);
  if (lines.empty()) return {};
  std::string text =
      "## Where isect is behind\n\nFirst the targets that some build missed. Then, for each test, the family on which "
      "the exact call takes most beside the naive method, if it takes more than twice as long: in double, in the "
      "portable build. Then what other libraries do in less time.\n\n";
  for (const std::string& line : lines) text += "- " + line + '\n';
  return text + '\n';
}

}  // namespace isect::bench
