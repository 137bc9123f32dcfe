// The sentences and tables of the report: machine, tests, targets, losses.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "bench/findings.h"
#include "bench/prose.h"
#include "bench/report_text.h"
#include "bench/rows.h"
#include "bench/targets.h"

namespace isect::bench {
namespace {

std::string cost(const Measured& m, const std::string& test, const Findings& d, const Findings& f) {
  std::string text =
      fmt::format("On ordinary cases in double the exact call takes {} ns and {} {} ns: a ratio of {}. ",
                  time_of(*d.exact), name_of(*d.naive), time_of(*d.naive), ratio_text(*d.exact, *d.naive));
  if (const auto best = rival(m, test); best && best->row != d.naive && name_of(*best->row) != name_of(*d.naive))
    text +=
        fmt::format("Of what is inexact or not ours {} is best, at {} ns: the time of {}, divided by that{}, is {}. ",
                    name_of(*best->row), time_of(*best->row),
                    best->exact == best->in.exact ? "the exact call" : name_of(*best->exact),
                    best->row->library == "isect" ? "" : " in one run", ratio_text(*best->exact, *best->row));
  if (d.exact->latency && d.naive->latency)
    text += fmt::format("Latency: the exact call {} ns, {} {} ns. ", number(*d.exact->latency), name_of(*d.naive),
                        number(*d.naive->latency));
  if (f.exact != nullptr && f.naive != nullptr)
    text += fmt::format("In float: the exact call {} ns, {} {} ns. ", number(f.exact->median), name_of(*f.naive),
                        number(f.naive->median));
  std::vector<std::string> equals;
  for (const Row* r : d.ordinary)
    if (r->exact && r != d.exact && r->library == "isect")
      equals.push_back(fmt::format("{}, {} ns a case{}", name_of(*r), number(r->median), not_asked(d, *r)));
  if (!equals.empty()) text += fmt::format("As exact: {}. ", fmt::join(equals, "; "));
  return text;
}

/// A sentence on how many wrong verdicts are of which kind, where a test has sides.
std::string sides(const std::vector<const Row*>& rows) {
  Sides all;
  for (const Row* r : rows)
    if (r->sides) all.called_on += r->sides->called_on, all.wrong_side += r->sides->wrong_side;
  if (all.called_on == 0) return {};  // so it is for a method that can only say yes or no
  return fmt::format("Of its wrong verdicts {} call \"on\" what lies on a side, {} name a wrong side. ",
                     count(all.called_on), count(all.wrong_side));
}

std::string naive_errors(const Findings& d) {
  const double wrong = static_cast<double>(d.naive->wrong()), judged = static_cast<double>(d.naive->judged);
  const std::string who = sentence(name_of(*d.naive));
  std::string text = wrong > 0
                         ? fmt::format("{} is wrong on {} of the ordinary cases. ", who, share(wrong, judged))
                         : fmt::format("{} is right on all {} ordinary cases judged. ", who, count(d.naive->judged));
  const std::vector<std::string> parts = wrong_on(d.of(*d.naive), 3);
  if (!parts.empty()) text += fmt::format("Of the hard families it gets wrong {}. ", listed(parts));
  return text + sides(d.of(*d.naive));
}

std::string exact_promise(const Findings& d, const Findings& f) {
  std::vector<const Row*> rows = d.of(*d.exact);
  const long in_double = total_judged(rows);
  for (const Row* r : f.rows)
    if (name_of(*r) == name_of(*d.exact)) rows.push_back(r);
  const long wrong = total_wrong(rows), in_float = total_judged(rows) - in_double;
  std::string text =
      wrong == 0 ? fmt::format("The exact call is right on all {} cases of all families judged in double{}. ",
                               count(in_double), in_float > 0 ? fmt::format(", and {} in float", count(in_float)) : "")
                 : fmt::format("The exact call is wrong on {} of {} cases judged: a fault. ", count(wrong),
                               count(total_judged(rows)));
  double most = -1;
  for (const Row* r : rows)
    if (r->ulps) most = std::max(most, r->ulps->most);
  if (most >= 0) text += fmt::format("Its value is never further off than {} ulp. ", number(most));

  if (d.exact->fallback)
    text += fmt::format("Of the ordinary calls {} need more than one pass in doubles. ", share(*d.exact->fallback, 1));
  const Row* slowest = slowest_hard(d.of(*d.exact));
  if (slowest != nullptr && slowest->median > 1.5 * d.exact->median && faster(*d.exact, *slowest, d.noise))
    text += fmt::format(
        "It is slowest on \"{}\": {} ns{}. ", words(slowest->family), number(slowest->median),
        slowest->fallback && d.exact->fallback ? fmt::format(", where {} do", share(*slowest->fallback, 1)) : "");
  return text;
}

/// A sentence on isect's inexact method that is wrong least often, unless that is the naive one.
std::string runner_up(const Findings& d) {
  const Row* best = nullptr;
  for (const Row* r : d.ordinary)
    if (r->library == "isect" && !r->exact && (best == nullptr || total_wrong(d.of(*r)) < total_wrong(d.of(*best))))
      best = r;
  if (best == nullptr || best == d.naive || total_wrong(d.of(*best)) >= total_wrong(d.of(*d.naive))) return {};
  const std::vector<std::string> parts = wrong_on(d.of(*best), 2);
  return fmt::format(
      "Of the inexact methods {} errs least: its time, divided by that of {}, is {}, and it is wrong on {}. ",
      name_of(*best), name_of(*d.naive), ratio_text(*best, *d.naive), parts.empty() ? "no case judged" : listed(parts));
}

/// Sentences on where an inexact method is faster, other than in double in the portable build.
std::string elsewhere(const Measured& m, const std::string& test) {
  std::string text;
  const auto look = [&](const Report& report, const std::string& scalar, const std::string& where) {
    if (const auto best = rival(report, test, scalar, false); best && best->is_faster())
      text += fmt::format(" {} {} does, {} ns against {}.", where, name_of(*best->row), number(best->row->median),
                          number(best->exact->median));
  };
  look(m.portable, "float", "In float");
  if (m.native) look(*m.native, "double", "Compiled for this machine");
  if (m.native) look(*m.native, "float", "Compiled for this machine, in float");
  return text;
}

/// Sentences on where another method that is as exact takes much less time.
std::string exceptions(const Findings& d) {
  std::string text;
  for (const Better& b : better_where(d))
    text += fmt::format(" On \"{}\" {} takes {} ns, against {}.", words(b.row->family), name_of(*b.row),
                        number(b.row->median), number(b.chosen->median));
  return text;
}

/// What to choose; empty if the faster methods met no hard case.
std::string advice(const Measured& m, const std::string& test, const Findings& d) {
  const std::optional<Choice> c = choice(m, test);
  if (!c || c->why == Choice::not_judged) return {};
  const bool another = c->exact != name_of(*d.exact);
  const std::string exact = another ? c->exact : "the exact call";
  const std::string as_exact =
      !another             ? ""
      : c->peer == nullptr ? d.judged_hard() ? "It is as exact as the exact call. "
                                             : "It promises what the exact call does; it was judged on ordinary input. "
                           : fmt::format("It is as exact as the exact call, and takes {} of its time. ",
                                         ratio_text(*c->peer, best_exact(Findings(*m.peers, test, "double"))));
  if (c->why == Choice::nothing_faster)
    return fmt::format("**Choose {}.** {}In double nothing inexact takes clearly less time.{}{}", exact, as_exact,
                       elsewhere(m, test), exceptions(d));
  if (c->why == Choice::errs_on_ordinary)
    return fmt::format("**Choose {}.** {} takes less time, but errs on ordinary input already.", exact,
                       sentence(c->other));
  const Rival best = *rival(m, test);
  const std::string other = c->other + (c->no_value ? " (yes or no only)" : "");
  const std::string saved = number(best.exact->median - best.row->median), part = ratio_text(*best.row, *best.exact);
  if (c->why == Choice::as_exact)
    return fmt::format("**Choose {}.** It is as exact, and takes {} of the time.", other, part);
  if (c->why == Choice::never_broken)
    return fmt::format(
        "**Choose {} where time matters.** It takes {} of the time, and no case judged here broke it; only {} promises "
        "that none does.",
        other, part, exact);
  if (c->peer != nullptr)
    return fmt::format("**Choose {}.** {}{} takes less, but {}.", exact, as_exact, sentence(c->other),
                       c->all_families ? "is for input like the ordinary family only"
                                       : "not where input may be " + listed(c->families));
  if (c->all_families)
    return fmt::format(
        "**Choose {}.** Use {} only if all input is like the ordinary family, and saving {} ns a call outweighs a "
        "wrong verdict.",
        exact, other, saved);
  return fmt::format("**Choose {},** or {} where no input is {}: it saves {} ns a call.", exact, other,
                     listed(c->families), saved);
}

std::string beside_peers(const Measured& m, const std::string& test) {
  if (!m.peers) return {};
  const Findings p(*m.peers, test, "double");
  if (p.exact == nullptr || std::ranges::none_of(p.ordinary, [](const Row* r) { return r->library != "isect"; }))
    return {};
  std::string text =
      "| beside other libraries, in one run | ns | latency | exact call / it | wrong, ordinary | wrong, worst "
      "family |\n| --- | --: | --: | --: | --: | --- |\n";
  for (const Row* r : p.ordinary) {
    if (r->library == "isect" && r != p.exact) continue;
    const std::vector<std::string> worst = wrong_on(p.of(*r), 1);
    text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", name_of(*r), time_of(*r),
                        r->latency ? number(*r->latency) : "", r == p.exact ? "1" : ratio_text(*p.exact, *r),
                        wrong_share({r}), worst.empty() ? "none" : worst.front());
  }
  return text + '\n';
}

/// How often one library is wrong on the hard cases of one test.
struct Verdicts {
  std::vector<std::string> methods;  ///< "do_intersect: wrong on 24 %, 240 of 1,000"
  bool right = false;                ///< one of them always is

  Verdicts(const Findings& d, const std::string& library) {
    for (const std::string& name : methods_of(d.rows)) {
      std::vector<const Row*> all;
      for (const Row* r : d.rows)
        if (r->library == library && name_of(*r) == name && r->hard && r->judged > 0) all.push_back(r);
      if (all.empty() || (library == "isect" && name != name_of(*d.exact))) continue;
      const std::string method = library == "isect" ? "" : all.front()->method + ": ";
      right |= total_wrong(all) == 0;
      methods.push_back(method +
                        (total_wrong(all) == 0 ? fmt::format("right, {}", count(total_judged(all)))
                                               : fmt::format("wrong on {}, {} of {}", wrong_share(all),
                                                             count(total_wrong(all)), count(total_judged(all)))) +
                        not_asked(d, *all.front()));
    }
  }
};

/// The columns that the table has beside the times: those for which the test has numbers.
struct Columns {
  bool latency = false, values = false, sides = false;
  const Row* best = nullptr;  ///< isect's method to which ratios are given, beside the standard method

  explicit Columns(const Measured& m, const std::string& test, const Findings& d) {
    for (const Row* r : d.rows) {
      latency = latency || r->latency;
      values = values || r->ulps;
      sides = sides || r->sides;
    }
    const std::optional<Rival> other = rival(m, test);
    if (!other || d.naive == nullptr) return;
    for (const Row* r : d.ordinary)
      if (r != d.naive && name_of(*r) == name_of(*other->row)) best = r;
  }
  std::string head() const {
    std::string names = "| double, ordinary cases | ns |", rules = "| --- | --: |";
    const auto add = [&](bool shown, const std::string& name) {
      if (shown) names += ' ' + name + " |", rules += " --: |";
    };
    add(latency, "latency");
    add(true, "ratio");
    add(best != nullptr, best == nullptr ? "" : "to " + name_of(*best));
    add(true, "wrong"), add(true, "wrong, all hard cases");
    add(sides, "called on"), add(sides, "wrong side");
    add(values, "ulp, median"), add(values, "99th percentile"), add(values, "most, hard");
    return names + '\n' + rules + '\n';
  }
};

std::string line(const Findings& d, const Columns& columns, const Row& r) {
  std::vector<const Row*> hard;
  double most = -1;
  Sides sides;
  for (const Row* q : d.of(r)) {
    if (q->sides) sides.called_on += q->sides->called_on, sides.wrong_side += q->sides->wrong_side;
    if (!q->hard) continue;
    hard.push_back(q);
    if (q->ulps) most = std::max(most, q->ulps->most);
  }
  std::string text = fmt::format("| {} | {} |", name_of(r), time_of(r));
  const auto add = [&](bool shown, const std::string& cell) {
    if (shown) text += cell.empty() ? " |" : ' ' + cell + " |";
  };
  add(columns.latency, r.latency ? number(*r.latency) : "");
  add(true, d.naive == nullptr ? "" : &r == d.naive ? "1" : ratio_text(r, *d.naive));
  if (columns.best != nullptr) add(true, &r == columns.best ? "1" : ratio_text(r, *columns.best));
  add(true, wrong_share({&r})), add(true, hard.empty() ? "" : wrong_share(hard));
  add(columns.sides, r.sides ? count(sides.called_on) : ""), add(columns.sides, r.sides ? count(sides.wrong_side) : "");
  add(columns.values, r.ulps ? number(r.ulps->median) : ""), add(columns.values, r.ulps ? number(r.ulps->p99) : "");
  add(columns.values, r.ulps && most >= 0 ? number(most) : "");
  return text + '\n';
}

/// The table of a test without ordinary cases, with a row for each family.
std::string families_table(const Findings& d) {
  std::string text = "| double | family | ns | wrong |\n| --- | --- | --: | --: |\n";
  for (const Row* r : d.rows)
    text += fmt::format("| {} | {} | {} | {} |\n", name_of(*r), words(r->family), time_of(*r), wrong_share({r}));
  return text + '\n';
}

std::string table(const Measured& m, const std::string& test, const Findings& d) {
  const Columns columns(m, test, d);
  std::string text = columns.head();
  for (const Row* r : d.ordinary) text += line(d, columns, *r);
  return text + '\n';
}

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

std::string machine_line(const Report& r) {
  const Machine& m = r.machine;
  return fmt::format("- {} build of {}: {}, `{}`, seed {}, {}; load {}, noise {:.1f} %{}{}\n", m.build,
                     m.commit.empty() ? "an unknown commit" : "commit " + m.commit, m.compiler, m.flags, r.seed, m.date,
                     number(m.load), 100 * m.noise, r.quick ? "; a quick run, in which fewer cases are judged" : "",
                     m.libraries.empty() ? "" : "; beside " + m.libraries);
}

}  // namespace

std::string machine_text(const Measured& m) {
  const Machine& machine = m.portable.machine;
  std::string text = fmt::format("Measured on {} with {} cores{}:\n\n{}", machine.cpu, machine.cores,
                                 machine.caches.empty() ? "" : ", " + machine.caches, machine_line(m.portable));
  for (const std::optional<Report>* other : {&m.native, &m.peers})
    if (*other) text += machine_line(**other);
  if (!m.native) text += "- native build: not measured\n";
  if (!m.peers) text += "- beside other libraries: not measured\n";
  return text + '\n';
}

std::string test_text(const Measured& m, const std::string& test) {
  const Findings d(m.portable, test, "double"), f(m.portable, test, "float");
  std::string text;
  if (d.comparable()) {
    text = cost(m, test, d, f) + naive_errors(d) + exact_promise(d, f) + runner_up(d);
    text.pop_back();
    text += "\n\n";
    if (const std::string words = advice(m, test, d); !words.empty()) text += words + "\n\n";
    if (m.native) {
      const Findings n(*m.native, test, "double");
      if (n.naive != nullptr && n.exact != nullptr)
        text += fmt::format("Compiled for this machine: {} {} ns, exact {} ns.\n\n", name_of(*n.naive),
                            time_of(*n.naive), time_of(*n.exact));
    }
  }
  if (d.rows.empty()) return text;
  return text + (d.ordinary.empty() ? families_table(d) : table(m, test, d)) + beside_peers(m, test);
}

std::string verdicts_text(const Report& peers) {
  std::string text =
      "### Right and wrong\n\nThe hard families of each question, put to each library: whether its verdict is right in "
      "all cases judged, and how many there were; or on what share of them, and on how many, it is wrong. Empty: the "
      "library cannot be asked this. In brackets the families that it was not asked.\n\n"
      "| question | isect | CGAL | Bullet | FCL | Boost | GEOS |\n| --- | --- | --- | --- | --- | --- | --- |\n";
  struct Sum {
    std::string library;
    int right = 0, wrong = 0, not_asked = 0;
  };
  std::vector<Sum> sums = {{"isect"}, {"CGAL"}, {"Bullet"}, {"FCL"}, {"Boost"}, {"GEOS"}};
  int questions = 0;
  for (const std::string& test : tests_of(peers)) {
    const Findings d(peers, test, "double");
    if (d.exact == nullptr || !d.judged_hard()) continue;
    ++questions;
    text += "| " + test + " |";
    for (Sum& sum : sums) {
      const Verdicts told(d, sum.library);
      ++(told.methods.empty() ? sum.not_asked : told.right ? sum.right : sum.wrong);
      text += fmt::format(" {} |", fmt::join(told.methods, "; "));
    }
    text += '\n';
  }
  if (questions == 0) return {};
  std::vector<std::string> parts;
  for (const Sum& s : sums) parts.push_back(fmt::format("{} {}, {} and {}", s.library, s.right, s.wrong, s.not_asked));
  return text + fmt::format(
                    "\nOf {} questions a library answers so many rightly by some method, wrongly by all, and so "
                    "many it cannot be asked: {}.\n\n",
                    questions, fmt::join(parts, "; "));
}

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
