#include "bench/targets.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/prose.h"
#include "bench/rows.h"

namespace isect::bench {
namespace {

bool is(const Target& t, const Growth& g) { return g.test == t.test && (t.unit.empty() || g.unit == t.unit); }

/// The time at n, if it was measured there; powers of two and ten count as the same size within a twentieth.
std::optional<double> at(const Growth& g, double n) {
  for (std::size_t i = 0; i < g.n.size(); ++i)
    if (std::abs(g.n[i] / n - 1) < 0.05) return g.ns[i];
  return {};
}

/// The least time at n among isect's `method`, or among all methods of another library.
std::optional<double> at(const Target& t, const Report& report, const std::string& who, bool ours) {
  std::optional<double> least;
  for (const Growth& g : report.growths) {
    const bool own = g.library == "isect";
    const bool meant = own ? g.method == who : !ours && g.library == who;
    if (!is(t, g) || !meant) continue;
    if (const auto ns = at(g, t.n); ns && (!least || *ns < *least)) least = ns;
  }
  return least;
}

std::optional<Ratio> ratio(const Target& t, const Report& report) {
  const std::vector<const Row*> rows = rows_of(report, t.test, t.scalar, "ordinary");
  const Row *ours = nullptr, *theirs = nullptr;
  for (const Row* r : rows) {
    const bool own = r->library == "isect";
    if (own && r->method == t.ours) ours = r;
    const bool meant = t.theirs == "naive" ? r->standard : (own ? r->method : r->library) == t.theirs;
    if (meant && (theirs == nullptr || r->median < theirs->median)) theirs = r;  // a library's fastest way
  }
  if (ours == nullptr || theirs == nullptr || !(theirs->median > 0)) return {};
  return ratio_of(*ours, *theirs);
}

/// The wrong verdicts or the greatest error over all families and both scalars.
std::optional<double> worst(const Target& t, const Report& report) {
  std::optional<double> sum;
  for (const Row& r : report.rows) {
    if (r.test != t.test || r.library != "isect" || r.method != t.ours || r.judged == 0) continue;
    if (t.kind == Target::wrong) sum = sum.value_or(0) + static_cast<double>(r.wrong());
    if (t.kind == Target::ulps && r.ulps) sum = std::max(sum.value_or(0), r.ulps->most);
  }
  return sum;
}

/// Whether the shapes of a family are of integers or tenths, as users type them, and touch exactly.
bool touches(const std::string& family) {
  constexpr const char* names[] = {"touching",   "exact-touch", "exact-tangent", "grid",
                                   "grid touch", "decimal",     "decimal touch"};
  return std::ranges::find(names, family) != std::end(names);
}

/// A ratio of isect's time on one family.
struct OnFamily {
  double value;
  const Row* row;
};
/// The greatest ratio over the families that the target is about, in both scalars.
std::optional<OnFamily> hardest(const Target& t, const Report& report) {
  std::optional<OnFamily> most;
  for (const Row& r : report.rows) {
    if (r.test != t.test || r.library != "isect" || r.method != t.ours || !r.hard) continue;
    if (t.kind == Target::touch && !touches(r.family)) continue;
    for (const Row* other : rows_of(report, t.test, r.scalar, t.kind == Target::touch ? "ordinary" : r.family)) {
      const bool meant = t.kind == Target::touch ? other->method == t.ours : other->standard;
      if (!meant || !(other->median > 0)) continue;
      if (const double value = r.median / other->median; !most || value > most->value) most = {value, &r};
    }
  }
  return most;
}

}  // namespace

std::optional<double> measured(const Target& t, const Report& report) {
  switch (t.kind) {
    case Target::ratio: {
      const auto found = ratio(t, report);
      return found ? std::optional<double>(found->value) : std::nullopt;
    }
    case Target::growth: {
      const auto ours = at(t, report, t.ours, true), theirs = at(t, report, t.theirs, false);
      return ours && theirs && *theirs > 0 ? std::optional<double>(*ours / *theirs) : std::nullopt;
    }
    case Target::time:
      return at(t, report, t.ours, true);
    case Target::hard:
    case Target::touch: {
      const auto found = hardest(t, report);
      return found ? std::optional<double>(found->value) : std::nullopt;
    }
    case Target::wrong:
    case Target::ulps:
      break;
  }
  return worst(t, report);
}

std::string told(const Target& t, const Report& report) {
  const std::optional<double> value = measured(t, report);
  if (!value) return {};
  if (const auto on = hardest(t, report); on && (t.kind == Target::hard || t.kind == Target::touch))
    return fmt::format("{} ({}{})", number(*value), on->row->scalar == "float" ? "float, " : "",
                       words(on->row->family));
  if (t.kind == Target::growth && t.ours != "exact") return fmt::format("{} ({})", number(*value), t.ours);
  if (t.kind != Target::ratio) return number(*value);
  const Ratio found = *ratio(t, report);
  return with_interval(found.value, found.lo, found.hi);
}

std::string wanted(const Target& t) {
  const std::string unit = t.kind == Target::time    ? " ns"
                           : t.kind == Target::ulps  ? " ulp"
                           : t.kind == Target::wrong ? ""
                                                     : " × " + t.theirs;
  if (!t.at_most) return "report only," + unit;
  return t.kind == Target::wrong ? "0" : fmt::format("at most {:g}{}", *t.at_most, unit);
}

bool met(const Target& t, double measured) { return !t.at_most || measured <= *t.at_most; }

}  // namespace isect::bench
