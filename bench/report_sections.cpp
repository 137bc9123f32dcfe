// The sentences and tables of the report: machine, tests, targets, losses.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "bench/prose.h"
#include "bench/report_text.h"
#include "bench/rows.h"
#include "bench/targets.h"

namespace isect::bench {
namespace {

constexpr double beyond_noise = 1 + most_noise;  ///< the least ratio of times that says something

/// All rows of one method over the families of a test in one scalar, with the two that are compared.
struct Findings {
  std::vector<const Row*> rows, ordinary;
  const Row *naive = nullptr, *exact = nullptr;

  Findings(const Report& report, const std::string& test, const std::string& scalar)
      : rows(rows_of(report, test, scalar)) {
    for (const Row* r : rows)
      if (!r->hard && (ordinary.empty() || r->family == ordinary.front()->family)) ordinary.push_back(r);
    naive = standard_of(ordinary), exact = exact_of(ordinary);
  }
  std::vector<const Row*> of(const Row& method) const {
    std::vector<const Row*> all;
    for (const Row* r : rows)
      if (name_of(*r) == name_of(method)) all.push_back(r);
    return all;
  }
  const Row* same_family(const Row& r, const Row& method) const {
    const auto found = std::ranges::find_if(
        rows, [&](const Row* q) { return q->family == r.family && name_of(*q) == name_of(method); });
    return found == rows.end() ? nullptr : *found;
  }
};

long total_wrong(const std::vector<const Row*>& rows) {
  long sum = 0;
  for (const Row* r : rows) sum += r->wrong();
  return sum;
}
long total_judged(const std::vector<const Row*>& rows) {
  long sum = 0;
  for (const Row* r : rows) sum += r->judged;
  return sum;
}

/// The families on which a method is wrong, the worst first: "24 % of far small".
std::vector<std::string> wrong_on(std::vector<const Row*> rows, std::size_t most) {
  std::ranges::stable_sort(rows, std::greater{}, &Row::wrong_per_million);
  std::vector<std::string> parts;
  for (const Row* r : rows)
    if (r->hard && r->wrong() > 0 && parts.size() < most)
      parts.push_back(fmt::format("{} of {}", share(static_cast<double>(r->wrong()), static_cast<double>(r->judged)),
                                  words(r->family)));
  return parts;
}

std::string cost(const Findings& d, const Findings& f) {
  std::string text =
      fmt::format("On ordinary cases in double the exact call takes {} ns and {} {} ns: a ratio of {}. ",
                  number(d.exact->ns), name_of(*d.naive), number(d.naive->ns), ratio_text(d.exact->ns / d.naive->ns));
  if (f.exact != nullptr && f.naive != nullptr)
    text += fmt::format("In float they take {} and {} ns. ", number(f.exact->ns), number(f.naive->ns));
  std::vector<std::string> equals;
  for (const Row* r : d.ordinary)
    if (r->exact && r != d.exact && r->library == "isect")
      equals.push_back(fmt::format("{} ({} ns a case)", name_of(*r), number(r->ns)));
  if (!equals.empty()) text += fmt::format("Equally exact: {}. ", listed(equals));
  return text;
}

std::string naive_errors(const Findings& d) {
  const double wrong = static_cast<double>(d.naive->wrong()), judged = static_cast<double>(d.naive->judged);
  const std::string who = sentence(name_of(*d.naive));
  std::string text = wrong > 0
                         ? fmt::format("{} is wrong on {} of the ordinary cases. ", who, share(wrong, judged))
                         : fmt::format("{} is right on all {} ordinary cases judged. ", who, count(d.naive->judged));
  const std::vector<std::string> parts = wrong_on(d.of(*d.naive), 3);
  if (!parts.empty()) text += fmt::format("Of the hard families it gets wrong {}. ", listed(parts));
  return text;
}

std::string exact_promise(const Findings& d, const Findings& f) {
  std::vector<const Row*> rows = d.of(*d.exact);
  for (const Row* r : f.rows)
    if (name_of(*r) == name_of(*d.exact)) rows.push_back(r);
  const long wrong = total_wrong(rows);
  std::string text = wrong == 0 ? fmt::format("The exact call is right on all {} cases judged of all families. ",
                                              count(total_judged(rows)))
                                : fmt::format("The exact call is wrong on {} of {} cases judged: a fault. ",
                                              count(wrong), count(total_judged(rows)));
  double most = -1;
  for (const Row* r : rows)
    if (r->ulps) most = std::max(most, r->ulps->most);
  if (most >= 0) text += fmt::format("Its value is never further off than {} ulp. ", number(most));

  if (d.exact->fallback)
    text += fmt::format("Of the ordinary calls {} need more than floating point. ", share(*d.exact->fallback, 1));
  const Row* slowest = nullptr;
  for (const Row* r : d.of(*d.exact))
    if (r->hard && (slowest == nullptr || r->ns > slowest->ns)) slowest = r;
  if (slowest != nullptr && slowest->ns > 1.5 * d.exact->ns)
    text += fmt::format(
        "It is slowest on {}: {} ns{}. ", words(slowest->family), number(slowest->ns),
        slowest->fallback && d.exact->fallback ? fmt::format(", where {} do", share(*slowest->fallback, 1)) : "");
  return text;
}

/// The inexact method of ours that is wrong least often, if it is not the naive one.
std::string runner_up(const Findings& d) {
  const Row* best = nullptr;
  for (const Row* r : d.ordinary)
    if (r->library == "isect" && !r->exact && (best == nullptr || total_wrong(d.of(*r)) < total_wrong(d.of(*best))))
      best = r;
  if (best == nullptr || best == d.naive || total_wrong(d.of(*best)) >= total_wrong(d.of(*d.naive))) return {};
  const std::vector<std::string> parts = wrong_on(d.of(*best), 2);
  return fmt::format("Of the inexact methods {} errs least, at a ratio of {}: {}. ", name_of(*best),
                     ratio_text(best->ns / d.naive->ns),
                     parts.empty() ? "on no case judged" : "still on " + listed(parts));
}

/// The exact call, or another method that is as exact, says as much and is clearly faster.
const Row& best_exact(const Findings& d) {
  const Row* best = d.exact;
  for (const Row* r : d.ordinary)
    if (r->exact && r->library == "isect" && r->ulps.has_value() == d.exact->ulps.has_value() &&
        r->ns * beyond_noise < best->ns)
      best = r;
  return *best;
}

/// What to choose; nothing where no hard case was judged and exactness costs.
std::string choice(const Findings& d) {
  const Row& best = best_exact(d);
  const bool other = &best != d.exact;
  const double slower = best.ns / d.naive->ns;
  const std::string naive = name_of(*d.naive), exact = other ? name_of(best) : "the exact call";
  if (slower <= beyond_noise)
    return fmt::format("**Choose {}.** It costs no more than {}{}.", exact, naive,
                       other ? " and is as exact as the exact call" : "");
  if (d.naive->wrong() > 0)
    return fmt::format("**Choose {}.** {} errs on ordinary input already.", exact, sentence(naive));
  if (std::ranges::none_of(d.of(*d.naive), &Row::hard)) return {};
  if (total_wrong(d.of(*d.naive)) == 0)
    return fmt::format(
        "**Choose {} where time matters.** It takes 1/{} of the time, and no case judged here broke it; only {} "
        "promises "
        "that none does.",
        naive, ratio_text(slower), exact);
  return fmt::format(
      "**Choose {},** unless all input is like the ordinary family and {} ns a call are worth more than a wrong "
      "verdict.",
      exact, number(best.ns - d.naive->ns));
}

std::string beside_peers(const Measured& m, const std::string& test) {
  if (!m.peers) return {};
  const Findings p(*m.peers, test, "double");
  if (p.exact == nullptr) return {};
  std::vector<std::string> parts;
  for (const Row* r : p.ordinary) {
    if (r->library == "isect") continue;
    const std::vector<const Row*> all = p.of(*r);
    const std::vector<std::string> wrong = wrong_on(all, 1);
    parts.push_back(fmt::format("{} {} ns ({})", name_of(*r), number(r->ns),
                                wrong.empty() ? total_wrong(all) == 0 ? "no wrong verdict" : "wrong on ordinary cases"
                                              : "wrong on " + wrong.front()));
  }
  if (parts.empty()) return {};
  return fmt::format("Beside other libraries, in one run, where the exact call takes {} ns: {}.\n\n",
                     number(p.exact->ns), listed(parts));
}

std::string table(const Findings& d) {
  const bool values = std::ranges::any_of(d.rows, [](const Row* r) { return r->ulps.has_value(); });
  std::string text = fmt::format(
      "| double, ordinary cases | ns | ratio | wrong | wrong, all hard cases |{}\n| --- | --: | --: | --: | "
      "--: |{}\n",
      values ? " ulp, median | 99th percentile | most, hard |" : "", values ? " --: | --: | --: |" : "");
  for (const Row* r : d.ordinary) {
    std::vector<const Row*> hard;
    double most = -1;
    for (const Row* q : d.of(*r))
      if (q->hard) {
        hard.push_back(q);
        if (q->ulps) most = std::max(most, q->ulps->most);
      }
    text += fmt::format(
        "| {} | {} | {} | {} | {} |", name_of(*r), number(r->ns),
        d.naive != nullptr ? fmt::format("{:.2g}", r->ns / d.naive->ns) : "",
        share(static_cast<double>(r->wrong()), static_cast<double>(r->judged)),
        hard.empty() ? "" : share(static_cast<double>(total_wrong(hard)), static_cast<double>(total_judged(hard))));
    if (values)
      text += r->ulps ? fmt::format(" {} | {} | {} |", number(r->ulps->median), number(r->ulps->p99),
                                    most < 0 ? "" : number(most))
                      : " | | |";
    text += '\n';
  }
  return text + '\n';
}

std::vector<const Report*> all_of(const Measured& m) {
  std::vector<const Report*> all = {&m.portable};
  if (m.native) all.push_back(&*m.native);
  if (m.peers) all.push_back(&*m.peers);
  return all;
}

std::string machine_line(const Report& r) {
  const Machine& m = r.machine;
  return fmt::format("- {} build: {}, `{}`, seed {}, {}; load {}, noise {:.1f} %{}\n", m.build, m.compiler, m.flags,
                     r.seed, m.date, number(m.load), 100 * m.noise,
                     r.quick ? "; a quick run, in which fewer cases are judged" : "");
}

}  // namespace

std::string machine_text(const Measured& m) {
  std::string text = fmt::format("Measured on {} with {} cores:\n\n{}", m.portable.machine.cpu,
                                 m.portable.machine.cores, machine_line(m.portable));
  for (const std::optional<Report>* other : {&m.native, &m.peers})
    if (*other) text += machine_line(**other);
  if (!m.native) text += "- native build: not measured\n";
  if (!m.peers) text += "- beside other libraries: not measured\n";
  return text + "\nNoise is how much more than its least a fixed loop takes, at its 95th percentile.\n\n";
}

std::string test_text(const Measured& m, const std::string& test) {
  const Findings d(m.portable, test, "double"), f(m.portable, test, "float");
  std::string text;
  if (d.naive != nullptr && d.exact != nullptr && d.naive != d.exact) {
    text = cost(d, f) + naive_errors(d) + exact_promise(d, f) + runner_up(d);
    text.pop_back();
    text += "\n\n";
    if (const std::string advice = choice(d); !advice.empty()) text += advice + "\n\n";
    if (m.native) {
      const Findings n(*m.native, test, "double");
      if (n.naive != nullptr && n.exact != nullptr)
        text += fmt::format("Compiled for this machine: {} {} ns, exact {} ns.\n\n", name_of(*n.naive),
                            number(n.naive->ns), number(n.exact->ns));
    }
  }
  return text + beside_peers(m, test) + (d.ordinary.empty() ? "" : table(d));
}

std::string target_text(const Measured& m) {
  std::string text =
      "## Targets\n\nSet before the work began, as ratios within one run. Rows that name another library "
      "come from the run "
      "beside other libraries.\n\n| work | target | portable | native | beside others |\n| --- | --- | --- | "
      "--- | --- |\n";
  int reached = 0, missed = 0, open = 0;
  for (const Target& t : m.portable.targets) {
    std::string row = fmt::format("| {} | {} |", t.work, wanted(t));
    std::optional<bool> all;
    for (const Report* r : {&m.portable, m.native ? &*m.native : nullptr, m.peers ? &*m.peers : nullptr}) {
      const std::optional<double> value = r != nullptr ? measured(t, *r) : std::nullopt;
      row += value ? fmt::format(" {}{} |", number(*value),
                                 !t.at_most       ? ""
                                 : met(t, *value) ? " ✓"
                                                  : " ✗ missed")
                   : " |";
      if (value && t.at_most) all = all.value_or(true) && met(t, *value);
    }
    text += row + '\n';
    if (t.at_most) ++(!all ? open : *all ? reached : missed);
  }
  return text + fmt::format("\n{} met, {} missed, {} not measured.\n\n", reached, missed, open);
}

std::string loss_text(const Measured& m) {
  std::vector<std::string> lines;
  for (const Target& t : m.portable.targets) {
    std::vector<std::string> runs;
    for (const Report* r : all_of(m))
      if (const auto value = measured(t, *r); value && !met(t, *value))
        runs.push_back(fmt::format("{} ({})", number(*value), r->machine.build));
    if (!runs.empty())
      lines.push_back(fmt::format("Target missed: {}: {}; wanted {}.", t.work, listed(runs), wanted(t)));
  }
  for (const std::string& test : tests_of(m.portable)) {
    const Findings d(m.portable, test, "double");
    if (d.naive == nullptr || d.exact == nullptr) continue;
    const Row* worst = nullptr;
    double most = 0;
    for (const Row* r : d.of(*d.exact))
      if (const Row* naive = d.same_family(*r, *d.naive); naive != nullptr && r->ns / naive->ns > most)
        worst = r, most = r->ns / naive->ns;
    if (worst != nullptr && most > 2)
      lines.push_back(fmt::format("{}: the exact call takes up to {} times the time of {} ({}: {} ns).", sentence(test),
                                  ratio_text(most), name_of(*d.naive), words(worst->family), number(worst->ns)));
  }
  if (m.peers)
    for (const std::string& test : tests_of(*m.peers)) {
      const Findings p(*m.peers, test, "double");
      if (p.exact == nullptr) continue;
      for (const Row* r : p.ordinary)
        if (r->library != "isect" && r->ns < p.exact->ns)
          lines.push_back(fmt::format("{}: {} is faster on ordinary cases, {} ns against {} ns{}.", sentence(test),
                                      name_of(*r), number(r->ns), number(p.exact->ns),
                                      total_wrong(p.of(*r)) == 0
                                          ? ", and was never wrong"
                                          : fmt::format("; it is wrong on {} of all cases judged",
                                                        share(static_cast<double>(total_wrong(p.of(*r))),
                                                              static_cast<double>(total_judged(p.of(*r)))))));
    }
  if (lines.empty()) return {};
  std::string text = "## Where isect is behind\n\n";
  for (const std::string& line : lines) text += "- " + line + '\n';
  return text + '\n';
}

}  // namespace isect::bench
