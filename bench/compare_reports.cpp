#include "bench/compare_reports.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "bench/rows.h"

namespace isect::bench {

namespace {

constexpr double least_noise = 0.03;

bool same_call(const Row& a, const Row& b) {
  return a.test == b.test && a.method == b.method && a.library == b.library && a.scalar == b.scalar &&
         a.family == b.family;
}

const Row* in(const Report& report, const Row& row) {
  const auto found = std::ranges::find_if(report.rows, [&](const Row& r) { return same_call(r, row); });
  return found == report.rows.end() ? nullptr : &*found;
}

Changed changed(const Report& before, const Report& after, const Row& a, const Row& b) {
  Changed change = {a, b, b.ns / a.ns, a.spread + b.spread};
  const Row* s = standard_of(rows_of(before, a.test, a.scalar, a.family));
  const Row* t = standard_of(rows_of(after, b.test, b.scalar, b.family));
  if (s && t && !b.standard && same_call(*s, *t)) {
    change.ratio *= s->ns / t->ns;
    change.noise += s->spread + t->spread;
  }
  change.noise = std::max(change.noise, least_noise);
  return change;
}

std::string call_of(const Row& r) {
  return fmt::format("{} {}, {}, {}", r.test, name_of(r), r.scalar, words(r.family));
}

/// The rows for which `holds`, the greatest change first.
std::string list(const std::vector<Changed>& all, const char* title, bool (Changed::*holds)() const) {
  std::vector<const Changed*> rows;
  for (const Changed& c : all)
    if ((c.*holds)()) rows.push_back(&c);
  if (rows.empty()) return {};
  std::ranges::stable_sort(rows, std::greater(), [](const Changed* c) { return std::abs(std::log(c->ratio)); });
  std::string text = fmt::format("{}:\n", title);
  for (const Changed* c : rows)
    text += fmt::format("  {:5.2f} times (noise {:.0f} %)  {}: {:.4g} -> {:.4g} ns\n", c->ratio, 100 * c->noise,
                        call_of(c->after), c->before.ns, c->after.ns);
  return text;
}

std::string list(const std::vector<Row>& rows, const char* title) {
  std::string text;
  for (const Row& r : rows) text += fmt::format("  {}\n", call_of(r));
  return text.empty() ? text : fmt::format("{}:\n{}", title, text);
}

}  // namespace

bool Comparison::holds() const {
  return gone.empty() && std::ranges::none_of(rows, [](const Changed& c) { return c.slower() || c.more_wrong(); });
}

Comparison compare(const Report& before, const Report& after) {
  if (before.machine.build != after.machine.build || before.machine.flags != after.machine.flags)
    throw std::runtime_error(fmt::format("the builds differ, so times are not comparable: {} ({}) and {} ({})",
                                         before.machine.build, before.machine.flags, after.machine.build,
                                         after.machine.flags));
  Comparison result;
  for (const Row& row : after.rows)
    if (const Row* was = in(before, row))
      result.rows.push_back(changed(before, after, *was, row));
    else
      result.added.push_back(row);
  for (const Row& row : before.rows)
    if (!in(after, row)) result.gone.push_back(row);
  if (result.rows.empty()) throw std::runtime_error("no call is in both reports");
  return result;
}

std::string told(const Comparison& c) {
  std::string text;
  for (const Changed& row : c.rows)
    if (row.more_wrong())
      text += fmt::format("more often wrong: {}: {:.4g} -> {:.4g} in a million\n", call_of(row.after),
                          row.before.wrong_per_million(), row.after.wrong_per_million());
  text += list(c.rows, "slower", &Changed::slower) + list(c.rows, "faster", &Changed::faster);
  text += list(c.gone, "gone") + list(c.added, "new");
  const auto same = std::ranges::count_if(c.rows, [](const Changed& r) { return !r.slower() && !r.faster(); });
  return text + fmt::format("{} of {} calls take as long as before, within their noise\n", same, c.rows.size());
}

}  // namespace isect::bench
