// Who is right: the sentences on the verdicts of one test, and the table of all tests and libraries.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bench/findings.h"
#include "bench/prose.h"
#include "bench/report_sections.h"
#include "bench/rows.h"

namespace isect::bench {
namespace {

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

}  // namespace

std::string verdict_sentences(const Findings& d, const Findings& f) {
  return naive_errors(d) + exact_promise(d, f) + runner_up(d);
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

}  // namespace isect::bench
