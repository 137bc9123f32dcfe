#include "bench/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "bench/prose.h"

namespace isect::bench {

Findings::Findings(const Report& report, const std::string& test, const std::string& scalar)
    : rows(rows_of(report, test, scalar)), noise(report.machine.noise) {
  for (const Row* r : rows)
    if (!r->hard && (ordinary.empty() || r->family == ordinary.front()->family)) ordinary.push_back(r);
  naive = standard_of(ordinary), exact = exact_of(ordinary);
}

std::vector<const Row*> Findings::of(const Row& method) const {
  std::vector<const Row*> all;
  for (const Row* r : rows)
    if (name_of(*r) == name_of(method)) all.push_back(r);
  return all;
}

const Row* Findings::same_family(const Row& r, const Row& method) const {
  const auto found =
      std::ranges::find_if(rows, [&](const Row* q) { return q->family == r.family && name_of(*q) == name_of(method); });
  return found == rows.end() ? nullptr : *found;
}

bool Findings::judged_hard() const { return is_judged_on_hard(rows); }

bool is_judged_on_hard(const std::vector<const Row*>& rows) {
  return std::ranges::any_of(rows, [](const Row* r) { return r->hard && r->judged > 0; });
}

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
std::string wrong_share(const std::vector<const Row*>& rows) {
  return share(static_cast<double>(total_wrong(rows)), static_cast<double>(total_judged(rows)));
}

std::vector<const Row*> broken_by(std::vector<const Row*> rows) {
  std::erase_if(rows, [](const Row* r) { return !r->hard || r->wrong() == 0; });
  std::ranges::stable_sort(rows, std::greater{}, &Row::wrong_per_million);
  return rows;
}

std::vector<std::string> wrong_on(const std::vector<const Row*>& rows, std::size_t most) {
  std::vector<std::string> parts;
  for (const Row* r : broken_by(rows))
    if (parts.size() < most) parts.push_back(fmt::format("{} of {}", wrong_share({r}), words(r->family)));
  return parts;
}

const Row* slowest_hard(const std::vector<const Row*>& rows) {
  const Row* slowest = nullptr;
  for (const Row* r : rows)
    if (r->hard && (slowest == nullptr || r->median > slowest->median)) slowest = r;
  return slowest;
}

std::string time_of(const Row& r) { return with_interval(r.median, r.lo, r.hi); }
std::string ratio_text(const Row& a, const Row& b) {
  const Ratio r = ratio_of(a, b);
  return with_interval(r.value, r.lo, r.hi);
}

const Row& best_exact(const Findings& d) {
  const Row* best = d.exact;
  for (const Row* r : d.ordinary)
    if (r->exact && r->library == "isect" && r->ulps.has_value() == d.exact->ulps.has_value() &&
        clearly_faster(*r, *best, d.noise))
      best = r;
  return *best;
}

namespace {

std::vector<const Row*> exact_alternatives(const Findings& d, const Row& chosen) {
  std::vector<const Row*> all = d.ordinary;
  std::erase_if(all, [&](const Row* r) {
    return !r->exact || r->library != "isect" || r == &chosen || r->ulps.has_value() != chosen.ulps.has_value();
  });
  return all;
}

/// The share of all cases judged that a method gets wrong.
double wrong_of(const Findings& d, const Row& method) {
  const std::vector<const Row*> all = d.of(method);
  return static_cast<double>(total_wrong(all)) / static_cast<double>(std::max(1L, total_judged(all)));
}

}  // namespace

std::vector<Better> better_where(const Findings& d) {
  const Row& chosen = best_exact(d);
  std::vector<Better> all;
  for (const Row* there : d.of(chosen)) {
    if (!there->hard || there->median <= chosen.median) continue;
    const Row* best = nullptr;
    for (const Row* r : exact_alternatives(d, chosen))
      if (const Row* same = d.same_family(*there, *r); same != nullptr && 2 * same->median < there->median)
        if (best == nullptr || same->median < best->median) best = same;
    if (best != nullptr) all.push_back({best, there});
  }
  std::ranges::stable_sort(all, std::greater{}, [](const Better& b) { return b.chosen->median; });
  return all;
}

std::string not_asked(const Findings& d, const Row& method) {
  std::string names;
  for (const Row* asked : d.of(*d.exact))
    if (asked->judged > 0)
      if (const Row* same = d.same_family(*asked, method); same == nullptr || same->judged == 0)
        names += (names.empty() ? " (not asked: " : ", ") + words(asked->family);
  return names.empty() ? names : names + ")";
}

std::optional<Rival> rival(const Report& report, const std::string& test, const std::string& scalar, bool foreign) {
  Findings d(report, test, scalar);
  if (d.exact == nullptr) return {};
  std::vector<const Row*> others = d.ordinary;
  std::erase_if(others, [&](const Row* r) {
    const bool own = r->library == "isect";
    return own == foreign || (own && r->exact);
  });
  if (others.empty()) return {};
  const Row& least = **std::ranges::min_element(others, {}, &Row::median);
  std::erase_if(others, [&](const Row* r) { return faster(least, *r, d.noise); });
  const Row* best = *std::ranges::min_element(others, {}, [&](const Row* r) { return wrong_of(d, *r); });
  const Row* exact = &best_exact(d);
  return Rival{std::move(d), best, exact};
}

std::optional<Rival> rival(const Measured& m, const std::string& test) {
  std::optional<Rival> own = rival(m.portable, test, "double", false), foreign;
  if (m.peers) foreign = rival(*m.peers, test, "double", true);
  if (!own || !foreign) return own ? own : foreign;
  const Ratio theirs = ratio_of(*foreign->row, *foreign->exact), ours = ratio_of(*own->row, *own->exact);
  if (theirs.hi < ours.lo) return foreign;
  if (ours.hi < theirs.lo) return own;
  return wrong_of(foreign->in, *foreign->row) < wrong_of(own->in, *own->row) ? foreign : own;
}

namespace {

/// The fastest method of another library that promises and says as much as the exact call, was never wrong, and is
/// clearly faster; null if there is none.
const Row* exact_peer(const Findings& peers) {
  const Row* best = nullptr;
  if (peers.exact == nullptr || !peers.judged_hard()) return best;
  const Row& ours = best_exact(peers);
  for (const Row* r : peers.ordinary)
    if (r->library != "isect" && r->exact && r->ulps.has_value() == ours.ulps.has_value() &&
        total_wrong(peers.of(*r)) == 0 && clearly_faster(*r, ours, peers.noise) &&
        (best == nullptr || r->median < best->median))
      best = r;
  return best;
}

}  // namespace

std::optional<Choice> choice(const Measured& m, const std::string& test) {
  const Findings d(m.portable, test, "double");
  if (d.exact == nullptr) return {};
  Choice c = {Choice::nothing_faster, name_of(best_exact(d)), {}, {}};
  const std::optional<Rival> best = rival(m, test);
  if (!best || !best->is_faster()) return c;
  const Row& other = *best->row;
  if (m.peers) {
    const Findings p(*m.peers, test, "double");
    if (const Row* peer = exact_peer(p)) {
      c.exact = name_of(*peer), c.peer = peer;
      const Row* same = p.same_family(*peer, other);  // compared within that run
      if (same == nullptr || !clearly_faster(*same, *peer, p.noise)) return c;
    }
  }
  const std::vector<const Row*> all = best->in.of(other);
  c.other = name_of(other), c.no_value = best->exact->ulps && !other.ulps;
  for (const Row* r : broken_by(all)) c.families.push_back(words(r->family));
  const auto hard = std::ranges::count_if(all, [](const Row* r) { return r->hard && r->judged > 0; });
  c.all_families = 2 * static_cast<long>(c.families.size()) > hard;
  c.why = other.wrong() > 0     ? Choice::errs_on_ordinary
          : hard == 0           ? Choice::not_judged
          : !c.families.empty() ? Choice::breaks
          : other.exact         ? Choice::as_exact
                                : Choice::never_broken;
  return c;
}

}  // namespace isect::bench
