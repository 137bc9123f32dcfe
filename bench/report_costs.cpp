// What the calls of a test cost: the sentences, and the tables of times with the errors beside them.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "bench/findings.h"
#include "bench/prose.h"
#include "bench/report_sections.h"
#include "bench/rows.h"

namespace isect::bench {
namespace {

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

}  // namespace

std::string cost_sentences(const Measured& m, const std::string& test, const Findings& d, const Findings& f) {
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

std::string tables_text(const Measured& m, const std::string& test, const Findings& d) {
  return (d.ordinary.empty() ? families_table(d) : table(m, test, d)) + beside_peers(m, test);
}

}  // namespace isect::bench
