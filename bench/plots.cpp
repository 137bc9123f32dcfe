#include "bench/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "bench/prose.h"
#include "bench/rows.h"
#include "viz/text/rich_text.h"

namespace isect::bench {
namespace {

using viz::Glyph, viz::Role;

/// Marker, colour and dash of each method, the same in all charts of a test. Stars promise exactness.
class Legend {
 public:
  explicit Legend(const std::vector<const Row*>& rows) : names_(methods_of(rows)) {
    constexpr Glyph plain[] = {Glyph::square, Glyph::diamond,  Glyph::disc,   Glyph::triangle,
                               Glyph::down,   Glyph::pentagon, Glyph::right,  Glyph::hexagon,
                               Glyph::left,   Glyph::plus,     Glyph::saltire};
    constexpr Glyph stars[] = {Glyph::star, Glyph::star4, Glyph::star6};
    constexpr Role roles[] = {Role::second, Role::first, Role::miss, Role::construction, Role::text};
    std::size_t stars_used = 0, plain_used = 0;
    for (const std::string& name : names_) {
      const bool exact = std::ranges::any_of(rows, [&](const Row* r) { return r->exact && name_of(*r) == name; });
      const auto i = static_cast<int>(exact ? stars_used : plain_used + 1);
      if (exact && stars_used < std::size(stars))
        series_.push_back({name, stars[stars_used++], Role::hit, i});
      else
        series_.push_back({name, plain[plain_used % std::size(plain)], roles[plain_used % std::size(roles)], i}),
            ++plain_used;
    }
  }
  int index(const Row& r) const { return static_cast<int>(std::ranges::find(names_, name_of(r)) - names_.begin()); }
  /// Keeps only the series that some panel shows, and renumbers them.
  std::vector<viz::Series> shown(std::vector<viz::Panel>& panels) const {
    std::set<int> used;
    for (const viz::Panel& panel : panels) {
      for (const viz::Spot& s : panel.spots) used.insert(s.series);
      for (const viz::Curve& c : panel.curves) used.insert(c.series);
    }
    const auto rank = [&](int i) { return static_cast<int>(std::distance(used.begin(), used.find(i))); };
    for (viz::Panel& panel : panels) {
      for (viz::Spot& s : panel.spots) s.series = rank(s.series);
      for (viz::Curve& c : panel.curves) c.series = rank(c.series);
    }
    std::vector<viz::Series> series;
    for (const int i : used) {
      series.push_back(series_[i]);
      series.back().name = viz::as_markup(series.back().name);
    }
    return series;
  }

 private:
  std::vector<std::string> names_;
  std::vector<viz::Series> series_;
};

std::string lower(std::string text) {
  for (char& c : text) c = std::isalnum(static_cast<unsigned char>(c)) ? static_cast<char>(std::tolower(c)) : '-';
  std::string slug;
  for (const char c : text)
    if (c != '-' || (!slug.empty() && slug.back() != '-')) slug += c;
  return slug;
}

viz::Scale times(const std::vector<const Row*>& rows) {
  double lo = INFINITY, hi = 0;
  for (const Row* r : rows) lo = std::min(lo, r->median), hi = std::max(hi, r->median);
  return {viz::Scale::Kind::log, lo / 1.5, hi * 1.4, {}};
}

std::vector<std::string> chosen(const std::vector<const Row*>& rows, const std::vector<std::string>& wanted) {
  std::vector<std::string> families;
  for (const std::string& f : families_of(rows))
    if (wanted.empty() || std::ranges::find(wanted, f) != wanted.end()) families.push_back(f);
  return families;
}

std::vector<const Row*> of_families(const std::vector<const Row*>& rows, const std::vector<std::string>& families) {
  std::vector<const Row*> some;
  for (const Row* r : rows)
    if (std::ranges::find(families, r->family) != families.end()) some.push_back(r);
  return some;
}

/// One panel a family, one marker a row; `spot` gives height and whisker, or nothing where a row has none.
template <class SpotOf>
std::vector<viz::Panel> panels(const std::vector<const Row*>& all, const std::vector<std::string>& families,
                               const Legend& legend, bool by_value, const SpotOf& spot) {
  std::vector<viz::Panel> result;
  for (const std::string& family : families) {
    std::vector<const Row*> rows;
    for (const Row* r : all)
      if (r->family == family) rows.push_back(r);
    const std::vector<const Row*> front = front_of(rows, by_value);
    viz::Panel panel = {viz::as_markup(words(family)), rows.front()->hard ? "hard" : ""};
    for (const Row* r : rows)
      if (std::optional<viz::Spot> s = spot(*r)) {
        s->series = legend.index(*r), s->x = r->median;
        s->front = std::ranges::find(front, r) != front.end();
        panel.spots.push_back(*s);
      }
    result.push_back(std::move(panel));
  }
  return result;
}

bool any_note(const std::vector<viz::Panel>& panels) {
  return std::ranges::any_of(panels, [](const viz::Panel& p) { return !p.note.empty(); });
}

std::string front_in_words(const std::vector<const Row*>& all, const std::vector<std::string>& families,
                           bool by_value) {
  std::string text;
  for (const std::string& family : families) {
    std::vector<const Row*> rows;
    for (const Row* r : all)
      if (r->family == family) rows.push_back(r);
    std::vector<const Row*> front = front_of(rows, by_value);
    std::ranges::sort(front, {}, &Row::median);
    std::vector<std::string> names;
    for (const Row* r : front) names.push_back(name_of(*r));
    text += fmt::format("{} {}: {}", text.empty() ? " On the front, from fast to right:" : ";", words(family),
                        names.empty() ? "none" : listed(names));
  }
  text += '.';
  return text;
}

}  // namespace

Plotted error_plot(const Report& report, const std::string& test, const std::string& scalar,
                   const std::vector<std::string>& wanted) {
  const std::vector<const Row*> rows = rows_of(report, test, scalar);
  const std::vector<std::string> families = chosen(rows, wanted);
  const std::vector<const Row*> seen = of_families(rows, families);
  const Legend legend(rows);
  double most = 4;
  const double cap = scalar == "float" ? 32 : 64;  // beyond this no digit of a value is right
  for (const Row* r : seen)
    if (r->ulps) most = std::max(most, bits(r->ulps->p99));
  std::vector<viz::Panel> all = panels(rows, families, legend, true, [](const Row& r) -> std::optional<viz::Spot> {
    if (!r.ulps) return {};
    return viz::Spot{0, 0, bits(r.ulps->p99), bits(r.ulps->median)};
  });
  viz::Plot plot = {
      times(seen), {viz::Scale::Kind::linear, 0, 1.08 * most, "log_2(1 + error in ulp)"}, {}, std::move(all)};
  plot.x.title = "time per call (ns). Marker: 99th percentile; bar: down to the median";
  if (most >= cap) {
    plot.y.hi = cap;
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
      plot.y.ticks.emplace_back(share * cap, fmt::format("{}{:.0f}", share == 1 ? "≥ " : "", share * cap));
  }
  plot.series = legend.shown(plot.panels);
  return {
      lower(test + "-" + scalar + "-error"),
      fmt::format("{} in {}: the time of a call against the error of its value, where the verdict is right. The "
                  "marker stands at the 99th "
                  "percentile, the bar reaches down to the median. Steps join the methods on the front: no other is "
                  "both as fast and as accurate. The tinted side is beaten.{}",
                  test, scalar, any_note(plot.panels) ? " Families marked hard are made to break naive methods." : ""),
      fmt::format("Charts of time against error for {} in {}.{}", test, scalar, front_in_words(rows, families, true)),
      {std::move(plot)}};
}

Plotted verdict_plot(const Report& report, const std::string& test, const std::string& scalar,
                     const std::vector<std::string>& wanted) {
  const std::vector<const Row*> rows = rows_of(report, test, scalar);
  const std::vector<std::string> families = chosen(rows, wanted);
  const std::vector<const Row*> seen = of_families(rows, families);
  const Legend legend(rows);
  double least = 1e4;
  for (const Row* r : seen)
    if (r->wrong() > 0) least = std::min(least, r->wrong_per_million());
  std::vector<viz::Panel> all = panels(rows, families, legend, false, [](const Row& r) -> std::optional<viz::Spot> {
    return viz::Spot{0, 0, r.wrong_per_million()};
  });
  viz::Plot plot = {
      times(seen),
      {viz::Scale::Kind::log_zero, std::pow(10, std::floor(std::log10(least)) - 1), 1e6, "wrong verdicts per million"},
      {},
      std::move(all)};
  plot.x.title = "time per call (ns)";
  plot.series = legend.shown(plot.panels);
  return {
      lower(test + "-" + scalar + "-verdicts"),
      fmt::format("{} in {}: the time of a call against its wrong verdicts, of a million. Steps join the methods on "
                  "the front: no other is both as fast and as often right.{}",
                  test, scalar, any_note(plot.panels) ? " Families marked hard are made to break naive methods." : ""),
      fmt::format("Charts of time against wrong verdicts for {} in {}.{}", test, scalar,
                  front_in_words(rows, families, false)),
      {std::move(plot)}};
}

Plotted distribution_plot(const Report& report, const std::string& test, const std::string& scalar,
                          const std::vector<std::string>& wanted) {
  const std::vector<const Row*> rows = rows_of(report, test, scalar);
  const Legend legend(rows);
  viz::Plot plot;
  double most = 4;
  std::string alt = fmt::format("Curves of the share of values within an error for {} in {}.", test, scalar);
  for (const std::string& family : chosen(rows, wanted)) {
    viz::Panel panel = {viz::as_markup(words(family))};
    for (const Row* r : rows) {
      if (r->family != family || r->quantiles.size() < 2) continue;
      if (r->hard) panel.note = "hard";
      viz::Curve curve = {legend.index(*r), {}};
      for (std::size_t i = 0; i < r->quantiles.size(); ++i)
        curve.points.emplace_back(bits(r->quantiles[i]),
                                  static_cast<double>(i) / static_cast<double>(r->quantiles.size() - 1));
      most = std::max(most, curve.points.back().x());
      if (r->standard || r->exact)
        alt += fmt::format(" {}, {}: half within {} ulp.", words(family), name_of(*r),
                           number(r->quantiles[r->quantiles.size() / 2]));
      panel.curves.push_back(std::move(curve));
    }
    if (!panel.curves.empty()) plot.panels.push_back(std::move(panel));
  }
  plot.x = {viz::Scale::Kind::linear, 0, 1.02 * most, "log_2(1 + error in ulp)"};
  plot.y = {viz::Scale::Kind::linear,
            0,
            1,
            "share of the values with at most this error",
            {{0, "0"}, {0.5, "50 %"}, {1, "100 %"}}};
  plot.series = legend.shown(plot.panels);
  return {
      lower(test + "-" + scalar + "-distribution"),
      fmt::format("{} in {}: the share of the values whose error is at most the one below. The further left and the "
                  "steeper a line, the better.",
                  test, scalar),
      alt,
      {std::move(plot)}};
}

Plotted growth_plot(const Report& report, const std::string& test, const std::string& unit) {
  viz::Plot plot;
  viz::Panel panel;
  double n_lo = INFINITY, n_hi = 0, lo = INFINITY, hi = 0;
  std::string alt = fmt::format("Time against the number of elements for {}.", test);
  constexpr Glyph glyphs[] = {Glyph::disc, Glyph::square,   Glyph::triangle, Glyph::diamond,
                              Glyph::down, Glyph::pentagon, Glyph::right,    Glyph::hexagon};
  constexpr Role roles[] = {Role::hit, Role::first, Role::second, Role::miss, Role::construction, Role::text};
  for (const Growth& g : report.growths) {
    if (g.test != test || g.unit != unit || g.n.empty()) continue;
    const std::size_t i = plot.series.size();
    plot.series.push_back({"", glyphs[i % std::size(glyphs)], roles[i % std::size(roles)], static_cast<int>(i)});
    viz::Curve curve = {
        static_cast<int>(i),
        {},
        viz::as_markup(name_of(g)) +
            (g.power() ? fmt::format(", *n*^{{{}{:.2f}}}", *g.power() < 0 ? "−" : "", std::abs(*g.power())) : "")};
    for (std::size_t k = 0; k < g.n.size(); ++k) {
      curve.points.emplace_back(g.n[k], g.ns[k]);
      n_lo = std::min(n_lo, g.n[k]), n_hi = std::max(n_hi, g.n[k]), lo = std::min(lo, g.ns[k]),
      hi = std::max(hi, g.ns[k]);
    }
    alt +=
        fmt::format(" {}: {:.3g} ns at n = {:.0f}, {:.3g} ns at {:.0f}{}.", name_of(g), g.ns.front(), g.n.front(),
                    g.ns.back(), g.n.back(), g.power() ? fmt::format(", growing as n to the {:.2f}", *g.power()) : "");
    panel.curves.push_back(std::move(curve));
  }
  plot.panels = {panel};
  plot.x = {viz::Scale::Kind::log, n_lo / 1.1, n_hi * 1.1, "number of elements *n*"};
  plot.y = {viz::Scale::Kind::log, lo / 1.6, hi * 1.6, "time, " + unit + " (ns)"};
  return {lower(test + "-" + unit + "-growth"),
          fmt::format("{}: the time ({}) as the number of elements grows, both logarithmic. Beside a "
                      "line of three sizes or more: the power of n fitted to it.",
                      test, unit),
          alt,
          {std::move(plot)}};
}

Plotted ratio_plot(const Report& report) {
  viz::Bars bars = {{viz::Scale::Kind::log, 0.5, 2, "time of the exact call / time of the library"},
                    {{"the library was never wrong", Glyph::star, Role::hit},
                     {"it was wrong in some case judged", Glyph::disc, Role::second},
                     {"it met no hard case", Glyph::plus, Role::second}},
                    {},
                    "as fast"};
  std::string alt = "Times of the exact call on ordinary cases in double, divided by those of other libraries.";
  for (const std::string& test : tests_of(report)) {
    const std::vector<const Row*> all = rows_of(report, test, "double");
    const Row* exact = nullptr;
    std::map<std::string, const Row*> fastest;  // of each library
    std::vector<std::string> libraries;
    for (const Row* r : all) {
      if (r->hard || r->family != all.front()->family) continue;
      if (r->library == "isect") {
        if (r->exact && exact == nullptr) exact = r;
        continue;
      }
      const Row*& best = fastest[r->library];
      if (best == nullptr) libraries.push_back(r->library);
      if (best == nullptr || r->median < best->median) best = r;
    }
    if (exact == nullptr) continue;
    for (const std::string& library : libraries) {
      const Row& theirs = *fastest[library];
      const Ratio ratio = ratio_of(*exact, theirs);
      long wrong = 0;
      bool hard = false;
      for (const Row* r : all)
        if (name_of(*r) == name_of(theirs)) wrong += r->wrong(), hard = hard || (r->hard && r->judged > 0);
      bars.x.lo = std::min(bars.x.lo, ratio.lo / 1.2), bars.x.hi = std::max(bars.x.hi, ratio.hi * 1.2);
      bars.bars.push_back({viz::as_markup(test + ": " + library),
                           {{wrong > 0 ? 1u
                             : hard    ? 0u
                                       : 2u,
                             ratio.value}},
                           1.0,
                           ratio_text(ratio.value),
                           viz::Verdict::Kind::open,
                           std::pair(ratio.lo, ratio.hi)});
      alt += fmt::format(" {}, {}: {}, {}.", test, name_of(theirs), with_interval(ratio.value, ratio.lo, ratio.hi),
                         wrong > 0 ? "wrong in some case"
                         : hard    ? "never wrong"
                                   : "not judged on hard cases");
    }
  }
  return {
      "ratios",
      "The time of the exact call divided by that of each library's fastest way, on ordinary cases in double, in one "
      "run. The line through a marker is the interval of the ratio. Left of the bar the exact call is faster. A star "
      "marks a way that was right in every case judged, hard ones among them.",
      alt,
      {std::move(bars)}};
}

Plotted duty_plot(const Report& report) {
  viz::Bars bars = {{viz::Scale::Kind::log, 0.5, 2, "measured, divided by the most that is allowed"},
                    {{"measured", Glyph::disc, Role::hit}},
                    {}};
  std::string alt = "What starting and drawing take, against their targets.";
  for (const Duty& d : report.duties) {
    if (!d.target || !(d.value > 0)) continue;
    const bool at_least = d.unit == "frames/s";
    const double ratio = at_least ? *d.target / d.value : d.value / *d.target;
    bars.x.lo = std::min(bars.x.lo, ratio / 1.3), bars.x.hi = std::max(bars.x.hi, ratio * 1.3);
    bars.bars.push_back({viz::as_markup(d.what),
                         {{0, ratio}},
                         1.0,
                         fmt::format("{:.3g} {}", d.value, d.unit),
                         ratio <= 1 ? viz::Verdict::Kind::yes : viz::Verdict::Kind::no});
    alt += fmt::format(" {}: {:.3g} {}, {} {:.3g} allowed.", d.what, d.value, d.unit, at_least ? "at least" : "at most",
                       *d.target);
  }
  return {"duties",
          "Starting and drawing: what was measured, divided by the target. Left of the bar is within it.",
          alt,
          {std::move(bars)}};
}

std::vector<Plotted> plots(const Report& report) {
  std::vector<Plotted> all;
  for (const std::string& test : tests_of(report))
    for (const std::string& scalar : scalars_of(report, test)) {
      const std::vector<const Row*> rows = rows_of(report, test, scalar);
      if (std::ranges::any_of(rows, [](const Row* r) { return r->ulps.has_value(); })) {
        all.push_back(error_plot(report, test, scalar));
        all.push_back(distribution_plot(report, test, scalar));
      }
      if (std::ranges::any_of(rows, [](const Row* r) { return r->wrong() > 0; }))
        all.push_back(verdict_plot(report, test, scalar));
    }
  if (has_peers(report)) all.push_back(ratio_plot(report));
  std::set<std::pair<std::string, std::string>> grown;
  for (const Growth& g : report.growths)
    if (grown.insert({g.test, g.unit}).second) all.push_back(growth_plot(report, g.test, g.unit));
  if (std::ranges::any_of(report.duties, [](const Duty& d) { return d.target.has_value(); }))
    all.push_back(duty_plot(report));
  return all;
}

}  // namespace isect::bench
