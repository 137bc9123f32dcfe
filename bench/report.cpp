#include "bench/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace isect::bench {
namespace {

using Json = nlohmann::ordered_json;

/// Four significant digits: no timing deserves more, and the file stays readable.
double rounded(double x) { return std::isfinite(x) ? std::strtod(fmt::format("{:.4g}", x).c_str(), nullptr) : x; }

/// JSON has no infinity.
Json number(double x) {
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  return std::isnan(x) ? Json("nan") : Json(rounded(x));
}
double number(const Json& x) {
  if (!x.is_string()) return x.get<double>();
  if (x == "inf") return INFINITY;
  if (x == "-inf") return -INFINITY;
  if (x == "nan") return NAN;
  throw std::runtime_error(x.dump() + " is no number");
}

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double x : values) list.push_back(number(x));
  return list;
}
std::vector<double> numbers(const Json& list) {
  std::vector<double> values;
  for (const Json& x : list) values.push_back(number(x));
  return values;
}

Json value(const Errors& e) { return numbers(std::vector{e.median, e.p99, e.most}); }
std::optional<Errors> errors(const Json& object, const char* name) {
  if (!object.contains(name)) return {};
  const std::vector<double> x = numbers(object.at(name));
  return Errors{x.at(0), x.at(1), x.at(2)};
}

Json value(const Row& r) {
  Json o = {{"test", r.test},
            {"method", r.method},
            {"library", r.library},
            {"scalar", r.scalar},
            {"family", r.family},
            {"hard", r.hard},
            {"exact", r.exact},
            {"standard", r.standard},
            {"ns", number(r.ns)},
            {"median", number(r.median)},
            {"lo", number(r.lo)},
            {"hi", number(r.hi)},
            {"spread", number(r.spread)},
            {"cases", r.cases},
            {"judged", r.judged},
            {"false_yes", r.false_yes},
            {"false_no", r.false_no}};
  if (r.latency) o["latency"] = number(*r.latency);
  if (r.sides) o["called_on"] = r.sides->called_on, o["wrong_side"] = r.sides->wrong_side;
  if (!r.first_wrong.empty()) o["first_wrong"] = r.first_wrong;
  if (r.ulps) o["ulps"] = value(*r.ulps);
  if (r.conditioned) o["conditioned"] = value(*r.conditioned);
  if (r.residual) o["residual"] = value(*r.residual);
  if (!r.quantiles.empty()) o["quantiles"] = numbers(r.quantiles);
  if (r.fallback) o["fallback"] = number(*r.fallback);
  return o;
}

Row row(const Json& o) {
  Row r;
  r.test = o.at("test"), r.method = o.at("method"), r.library = o.at("library");
  r.scalar = o.at("scalar"), r.family = o.at("family");
  r.hard = o.at("hard"), r.exact = o.at("exact"), r.standard = o.at("standard");
  r.ns = number(o.at("ns")), r.median = number(o.at("median")), r.spread = number(o.at("spread"));
  if (o.contains("lo"))
    r.lo = number(o.at("lo")), r.hi = number(o.at("hi"));
  else  // of an earlier version: the quartiles, about
    r.lo = r.median * (1 - r.spread / 2), r.hi = r.median * (1 + r.spread / 2);
  if (o.contains("latency")) r.latency = number(o.at("latency"));
  r.cases = o.at("cases"), r.judged = o.at("judged");
  r.false_yes = o.at("false_yes"), r.false_no = o.at("false_no");
  if (o.contains("called_on")) r.sides = Sides{o.at("called_on"), o.at("wrong_side")};
  r.first_wrong = o.value("first_wrong", "");
  r.ulps = errors(o, "ulps"), r.conditioned = errors(o, "conditioned"), r.residual = errors(o, "residual");
  if (o.contains("quantiles")) r.quantiles = numbers(o.at("quantiles"));
  if (!r.quantiles.empty() && r.quantiles.size() != 41) throw std::runtime_error("quantiles are 41 numbers");
  if (o.contains("fallback")) r.fallback = number(o.at("fallback"));
  return r;
}

Json value(const Growth& g) {
  return {{"test", g.test}, {"method", g.method},  {"library", g.library},          {"unit", g.unit},
          {"n", g.n},       {"ns", numbers(g.ns)}, {"exponent", number(g.exponent)}};
}
Growth growth(const Json& o) {
  Growth g = {o.at("test"), o.at("method"),      o.at("library"),         o.at("unit"),
              o.at("n"),    numbers(o.at("ns")), number(o.at("exponent"))};
  if (g.n.size() != g.ns.size()) throw std::runtime_error("a growth has one time for each n");
  return g;
}

Json value(const Duty& d) {
  Json o = {{"what", d.what}, {"value", number(d.value)}, {"unit", d.unit}};
  if (d.target) o["target"] = *d.target;
  return o;
}
Duty duty(const Json& o) {
  Duty d = {o.at("what"), number(o.at("value")), o.at("unit"), {}};
  if (o.contains("target")) d.target = o.at("target").get<double>();
  return d;
}

Json value(const Note& n) { return {{"test", n.test}, {"family", n.family}, {"text", n.text}}; }
Note note(const Json& o) { return {o.at("test"), o.at("family"), o.at("text")}; }

constexpr const char* kinds[] = {"ratio", "growth", "time", "wrong",
                                 "ulps",  "hard",   "touch"};  // as Target::Kind counts them

Json value(const Target& t) {
  Json o = {{"work", t.work},     {"kind", kinds[t.kind]}, {"test", t.test}, {"ours", t.ours},
            {"theirs", t.theirs}, {"n", number(t.n)},      {"unit", t.unit}, {"scalar", t.scalar}};
  if (t.at_most) o["at_most"] = *t.at_most;
  if (!t.limit.empty()) o["limit"] = t.limit;
  return o;
}
Target target(const Json& o) {
  const std::string kind = o.at("kind");
  const auto found = std::ranges::find(kinds, kind);
  if (found == std::end(kinds)) throw std::runtime_error("\"" + kind + "\" is no kind of target");
  Target t = {.work = o.at("work"), .kind = static_cast<Target::Kind>(found - std::begin(kinds)), .test = o.at("test")};
  t.ours = o.at("ours"), t.theirs = o.at("theirs"), t.n = number(o.at("n")), t.unit = o.at("unit");
  t.scalar = o.value("scalar", t.scalar);
  if (o.contains("at_most")) t.at_most = number(o.at("at_most"));
  if (o.contains("limit")) t.limit = o.at("limit");
  return t;
}

Json value(const Machine& m) {
  Json o = {{"cpu", m.cpu},     {"cores", m.cores},       {"compiler", m.compiler},   {"flags", m.flags},
            {"build", m.build}, {"load", number(m.load)}, {"noise", number(m.noise)}, {"date", m.date}};
  const std::pair<const char*, const std::string&> maybe[] = {
      {"commit", m.commit}, {"caches", m.caches}, {"libraries", m.libraries}};
  for (const auto& [name, text] : maybe)
    if (!text.empty()) o[name] = text;
  return o;
}
Machine machine(const Json& o) {
  return {o.at("cpu"),           o.at("compiler"),      o.at("flags"),           o.at("build"),
          o.at("cores"),         number(o.at("load")),  number(o.at("noise")),   o.at("date"),
          o.value("commit", ""), o.value("caches", ""), o.value("libraries", "")};
}

/// Each element on a line of its own, so that two files compare line by line.
template <class List>
std::string lines(const List& list) {
  std::string text = "[";
  for (const auto& x : list) text += (text.size() > 1 ? ",\n" : "\n") + value(x).dump();
  return text + "\n]";
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string escaped;
  for (const char c : text) escaped += c == '"' ? "\"\"" : std::string(1, c);
  return '"' + escaped + '"';
}

std::string csv(const std::optional<Errors>& e) {
  return e ? fmt::format("{:.4g},{:.4g},{:.4g}", e->median, e->p99, e->most) : ",,";
}

std::string csv(const std::optional<double>& x) { return x ? fmt::format("{:.4g}", *x) : ""; }
std::string csv(const std::optional<Sides>& s) { return s ? fmt::format("{},{}", s->called_on, s->wrong_side) : ","; }

std::string percent(const std::optional<double>& share) { return share ? fmt::format("{:.2f} %", 100 * *share) : ""; }

}  // namespace

std::string Report::note(const std::string& test, const std::string& family) const {
  const auto found = std::ranges::find_if(notes, [&](const Note& n) { return n.test == test && n.family == family; });
  return found == notes.end() ? "" : found->text;
}

void Report::add(Report other) {
  quick |= other.quick;
  const auto append = [](auto& all, auto& more) { std::ranges::move(more, std::back_inserter(all)); };
  append(rows, other.rows), append(growths, other.growths), append(duties, other.duties);
  append(notes, other.notes), append(targets, other.targets);
  machine.noise = std::max(machine.noise, other.machine.noise);
  for (const std::string& commit : commits(other.machine))
    if (const auto own = commits(machine); std::ranges::find(own, commit) == own.end())
      machine.commit += (machine.commit.empty() ? "" : ", ") + commit;
}

std::vector<std::string> commits(const Machine& m) {
  std::vector<std::string> all;
  for (std::size_t at = 0; at < m.commit.size();) {
    const std::size_t end = std::min(m.commit.find(", ", at), m.commit.size());
    all.push_back(m.commit.substr(at, end - at));
    at = end + 2;
  }
  return all;
}

std::string json(const Report& report) {
  return fmt::format(R"({{"machine": {},
"seed": {},
"quick": {},
"rows": {},
"growths": {},
"duties": {},
"notes": {},
"targets": {}}}
)",
                     value(report.machine).dump(), report.seed, report.quick, lines(report.rows), lines(report.growths),
                     lines(report.duties), lines(report.notes), lines(report.targets));
}

Report report_of(const std::string& text) {
  try {
    const Json o = Json::parse(text);
    Report report = {machine(o.at("machine")), o.at("seed"), o.at("quick")};
    for (const Json& r : o.at("rows")) report.rows.push_back(row(r));
    for (const Json& g : o.at("growths")) report.growths.push_back(growth(g));
    for (const Json& d : o.at("duties")) report.duties.push_back(duty(d));
    for (const Json& n : o.at("notes")) report.notes.push_back(note(n));
    for (const Json& t : o.at("targets")) report.targets.push_back(target(t));
    return report;
  } catch (const std::exception& e) {
    throw std::runtime_error(std::string("not a report of measurements: ") + e.what());
  }
}

std::string csv(const Report& report) {
  std::string text =
      "test,method,library,scalar,family,hard,ns_least,ns_median,ns_lo,ns_hi,spread,latency,cases,judged,false_yes,"
      "false_no,"
      "called_on,wrong_side,"
      "ulps_median,ulps_p99,ulps_max,conditioned_median,conditioned_p99,conditioned_max,"
      "residual_median,residual_p99,residual_max,fallback,first_wrong\r\n";
  for (const Row& r : report.rows)
    text += fmt::format("{},{},{},{},{},{},{:.4g},{:.4g},{:.4g},{:.4g},{:.4g},{},{},{},{},{},{},{},{},{},{},{}\r\n",
                        quoted(r.test), quoted(r.method), quoted(r.library), r.scalar, quoted(r.family), r.hard ? 1 : 0,
                        r.ns, r.median, r.lo, r.hi, r.spread, csv(r.latency), r.cases, r.judged, r.false_yes,
                        r.false_no, csv(r.sides), csv(r.ulps), csv(r.conditioned), csv(r.residual), csv(r.fallback),
                        quoted(r.first_wrong));
  return text;
}

std::string table(const Report& report) {
  std::string text, block;
  double standard = 0;
  for (std::size_t i = 0; i < report.rows.size(); ++i) {
    const Row& r = report.rows[i];
    const std::string title = fmt::format("{}, {}, {}", r.test, r.scalar, r.family);
    if (title != block) {
      block = title, standard = 0;
      for (std::size_t k = i; k < report.rows.size() && report.rows[k].test == r.test &&
                              report.rows[k].scalar == r.scalar && report.rows[k].family == r.family;
           ++k)
        if (report.rows[k].standard) standard = report.rows[k].median;
      text += fmt::format("\n{:<50} {:>9} {:>17} {:>9} {:>7}  {:>9} {:>9}  {:>8} {:>8} {:>8} {:>9}\n", title, "ns",
                          "95 %", "latency", "ratio", "false yes", "false no", "ulp med", "p99", "max", "fallback");
    }
    const std::string method = r.library == "isect" ? r.method : r.library + ": " + r.method;
    text += fmt::format("  {:<48} {:>9.2f} {:>17} {:>9} {:>7}  {:>9} {:>9}  ", method, r.median,
                        fmt::format("{:.2f} to {:.2f}", r.lo, r.hi), r.latency ? fmt::format("{:.2f}", *r.latency) : "",
                        standard > 0 ? fmt::format("{:.2f}", r.median / standard) : "", r.false_yes, r.false_no);
    text += r.ulps ? fmt::format("{:>8.3g} {:>8.3g} {:>8.3g}", r.ulps->median, r.ulps->p99, r.ulps->most)
                   : fmt::format("{:>26}", "");
    text += fmt::format(" {:>9}\n", percent(r.fallback));
    if (!r.first_wrong.empty()) text += fmt::format("      first wrong: {}\n", r.first_wrong);
  }
  if (!report.growths.empty()) text += "\ngrowth\n";
  for (const Growth& g : report.growths) {
    text += fmt::format("  {:<48} {}a {}:", g.test + ", " + (g.library == "isect" ? "" : g.library + ": ") + g.method,
                        g.power() ? fmt::format("n^{:.2f} ", *g.power()) : "", g.unit);
    for (std::size_t i = 0; i < g.n.size(); ++i) text += fmt::format("  {:.0f}: {:.4g} ns", g.n[i], g.ns[i]);
    text += '\n';
  }
  if (!report.duties.empty()) text += "\nstarting and drawing\n";
  for (const Duty& d : report.duties)
    text += fmt::format("  {:<48} {:.4g} {}{}\n", d.what, d.value, d.unit,
                        d.target ? fmt::format("  (target {:.4g})", *d.target) : "");
  return text;
}

double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double u = std::log(x[i]), v = std::log(y[i]);
    sx += u, sy += v, sxx += u * u, sxy += u * v;
  }
  const double across = n * sxx - sx * sx;
  return across > 0 ? (n * sxy - sx * sy) / across : 0;
}

}  // namespace isect::bench
