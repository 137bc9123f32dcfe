// A report of measurements as JSON, CSV and table: what is written reads back, and nothing else does.

#include "bench/report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "tests/catch.h"

namespace report_test {
using namespace isect::bench;
using isect::test::Contains;

namespace {

const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

Row full_row() {
  Row r;
  r.test = "ray-sphere", r.method = "half-B", r.library = "isect", r.scalar = "double", r.family = "near-tangent";
  r.hard = true, r.exact = false, r.standard = true;
  r.ns = 2.5, r.median = 2.75, r.lo = 2.625, r.hi = 2.875, r.spread = 0.125, r.latency = 8.5, r.cases = 65536;
  r.sides = Sides{2, 6};
  r.judged = 1024, r.false_yes = 3, r.false_no = 5, r.first_wrong = "origin (1, 2, 3) \"x\"\nradius 0.1";
  r.ulps = Errors{0.5, 12, inf}, r.conditioned = Errors{0.25, 1, 2}, r.residual = Errors{0, 1e-300, nan};
  for (int i = 0; i <= 40; ++i) r.quantiles.push_back(i);
  r.fallback = 0.0625;
  return r;
}
Row bare_row() {
  Row r;
  r.test = "orient2d", r.method = "exact", r.library = "isect", r.scalar = "float", r.family = "ordinary";
  r.exact = true;
  return r;
}
Report full_report() {
  Report report;
  report.machine = {"a cpu", "a compiler", "-O3", "portable", 2, 0.5, 0.03, "2026-01-31", "0123abc"};
  report.seed = 18446744073709551615u, report.quick = true;
  report.rows = {full_row(), bare_row()};
  report.growths = {{"all pairs", "sweep", "isect", "all pairs", {1000, 10000, 1e5}, {1.5e5, 3e6, 6e7}, 1.301}};
  report.duties = {{"isect --help", 12.5, "ms", 30.0}, {"memory", 40, "MB", {}}};
  report.notes = {{"ray-sphere", "near-tangent", "rays that all but touch."}};
  report.targets = {{.work = "pairs",
                     .kind = Target::growth,
                     .test = "all pairs",
                     .ours = "sweep",
                     .theirs = "Embree",
                     .n = 1e6,
                     .unit = "query",
                     .at_most = 0.2},
                    {.work = "verdicts", .kind = Target::wrong, .test = "orient2d"}};
  return report;
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }
bool same(const std::optional<Errors>& a, const std::optional<Errors>& b) {
  if (!a || !b) return !a && !b;
  return same(a->median, b->median) && same(a->p99, b->p99) && same(a->most, b->most);
}
void check_same(const Row& a, const Row& b) {
  CHECK((a.test == b.test && a.method == b.method && a.library == b.library));
  CHECK((a.scalar == b.scalar && a.family == b.family));
  CHECK((a.hard == b.hard && a.exact == b.exact && a.standard == b.standard));
  CHECK((a.ns == b.ns && a.median == b.median && a.spread == b.spread && a.cases == b.cases));
  CHECK((a.judged == b.judged && a.false_yes == b.false_yes && a.false_no == b.false_no));
  CHECK((a.lo == b.lo && a.hi == b.hi && a.latency == b.latency && a.sides.has_value() == b.sides.has_value()));
  if (a.sides && b.sides)
    CHECK((a.sides->called_on == b.sides->called_on && a.sides->wrong_side == b.sides->wrong_side));
  CHECK(a.first_wrong == b.first_wrong);
  CHECK((same(a.ulps, b.ulps) && same(a.conditioned, b.conditioned) && same(a.residual, b.residual)));
  CHECK((a.quantiles == b.quantiles && a.fallback == b.fallback));
}

/// The report's JSON with one thing put in place of another, which must be there.
std::string with(const std::string& old, const std::string& now) {
  std::string text = json(full_report());
  const std::size_t at = text.find(old);
  REQUIRE(at != std::string::npos);
  return text.replace(at, old.size(), now);
}

}  // namespace

TEST_CASE("notes and targets read back from a report's JSON", "[report]") {
  const Report read = report_of(json(full_report()));
  CHECK(read.note("ray-sphere", "near-tangent") == "rays that all but touch.");
  CHECK(read.note("ray-sphere", "planet").empty());
  REQUIRE(read.targets.size() == 2);
  const Target& t = read.targets[0];
  CHECK((t.work == "pairs" && t.kind == Target::growth && t.test == "all pairs" && t.ours == "sweep"));
  CHECK((t.theirs == "Embree" && t.n == 1e6 && t.unit == "query" && t.at_most == 0.2));
  CHECK((read.targets[1].kind == Target::wrong && read.targets[1].ours == "exact" && !read.targets[1].at_most));
  CHECK_THROWS_WITH(report_of(with("\"growth\"", "\"growing\"")), Contains("\"growing\" is no kind of target"));
}

TEST_CASE("reports of several suites add up, and the noisier machine counts", "[report]") {
  Report all = full_report(), other = full_report();
  other.rows.resize(1), other.machine.noise = 0.07;
  all.add(other);
  CHECK((all.rows.size() == 3 && all.growths.size() == 2 && all.duties.size() == 4));
  CHECK((all.notes.size() == 2 && all.targets.size() == 4 && all.machine.noise == 0.07));
  CHECK(commits(all.machine) == std::vector<std::string>{"0123abc"});
  other = full_report(), other.machine.commit = "4567def-dirty";
  all.add(other);
  CHECK(commits(all.machine) == std::vector<std::string>{"0123abc", "4567def-dirty"});
  CHECK(commits(Machine()).empty());
}

TEST_CASE("a report reads back from its JSON, infinities and all", "[report]") {
  const Report wrote = full_report(), read = report_of(json(wrote));
  REQUIRE(read.rows.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) check_same(read.rows[i], wrote.rows[i]);
  CHECK(read.machine.cpu == "a cpu");
  CHECK(read.machine.compiler == "a compiler");
  CHECK((read.machine.flags == "-O3" && read.machine.build == "portable" && read.machine.date == "2026-01-31"));
  CHECK(read.machine.commit == "0123abc");
  CHECK((read.machine.cores == 2 && read.machine.load == 0.5 && read.machine.noise == 0.03));
  CHECK((read.seed == wrote.seed && read.quick));
  REQUIRE(read.growths.size() == 1);
  CHECK((read.growths[0].n == wrote.growths[0].n && read.growths[0].ns == wrote.growths[0].ns));
  CHECK((read.growths[0].exponent == 1.301 && read.growths[0].method == "sweep"));
  REQUIRE(read.duties.size() == 2);
  CHECK((read.duties[0].what == "isect --help" && read.duties[0].value == 12.5));
  CHECK((read.duties[0].target == 30.0 && !read.duties[1].target));
  CHECK(json(read) == json(wrote));
}

TEST_CASE("a report of an earlier version reads, its quartiles as the interval", "[report]") {
  std::string old = json(full_report());
  for (const char* part : {",\"lo\":2.625,\"hi\":2.875", ",\"latency\":8.5", ",\"called_on\":2,\"wrong_side\":6",
                           ",\"commit\":\"0123abc\""}) {
    const std::size_t at = old.find(part);
    REQUIRE(at != std::string::npos);
    old.erase(at, std::string(part).size());
  }
  const Report read = report_of(old);
  const Row& r = read.rows[0];
  CHECK((r.lo == Approx(2.75 * (1 - 0.0625)) && r.hi == Approx(2.75 * (1 + 0.0625))));
  CHECK((!r.latency && !r.sides && read.machine.commit.empty() && r.wrong() == 8));
}

TEST_CASE("numbers keep four digits, of any size", "[report]") {
  Report report;
  report.rows = {bare_row()};
  for (const double x : {1.0 / 3, 123456.0, 4.9e-324, 2.2e-310, 1.7e308, -inf, inf, 0.0}) {
    report.rows[0].fallback = x;
    const double read = report_of(json(report)).rows.at(0).fallback.value();
    INFO(x);
    if (std::isfinite(x) && x != 0 && std::abs(x) > 1e-300)
      CHECK(std::abs(read / x - 1) < 5e-4);
    else
      CHECK((std::abs(x) < 1e-300 ? std::abs(read - x) < 1e-313 : read == x));
  }
}

TEST_CASE("what is no report is refused, with a word on what is wrong", "[report]") {
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[]"), std::string("null"), std::string("{}"),
        std::string(R"({"machine": {}, "seed": 1, "quick": true, "rows": [], "growths": [], "duties": []})"),
        with("\"seed\": 18446744073709551615", "\"seed\": \"many\""),
        with("\"ns\":2.5", "\"ns\":\"fast\""),                      // inf, -inf and nan are the only words
        with("\"ns\":2.5", "\"ns\":1e999"),                         // beyond every double
        with("\"judged\":1024", "\"judged\":true"),                 //
        with("[0.5,12.0,\"inf\"]", "[0.5,12.0]"),                   // a median, a percentile and no maximum
        with("\"quantiles\":[0.0,", "\"quantiles\":["),             // 40 of 41
        with("\"n\":[1000.0,10000.0,100000.0]", "\"n\":[1000.0]"),  // two times of one size
        with("\"rows\": [", "\"rows\": [[],"), std::string(100'000, '[')}) {
    INFO(text.substr(0, 300));
    CHECK_THROWS_WITH(report_of(text), Contains("not a report of measurements: "));
  }
}

TEST_CASE("CSV has one line a row, and quotes what needs it", "[report]") {
  Report report = full_report();
  report.rows[1].method = "CGAL, EPICK";
  const std::string text = csv(report);
  CHECK(text.substr(0, 26) == "test,method,library,scalar");
  CHECK_THAT(text, Contains(",\"origin (1, 2, 3) \"\"x\"\"\nradius 0.1\"\r\n"));
  CHECK_THAT(text, Contains("\r\norient2d,\"CGAL, EPICK\",isect,float,ordinary,0,"));
  CHECK_THAT(text, Contains(",0.5,12,inf,0.25,1,2,0,1e-300,nan,0.0625,"));

  report.rows = {bare_row()};
  report.rows[0].first_wrong = "a\rb";
  CHECK_THAT(csv(report), Contains(",\"a\rb\"\r\n"));
  const std::string header = csv(report).substr(0, csv(report).find("\r\n"));
  const std::string line = csv(report).substr(header.size() + 2);
  CHECK(std::count(header.begin(), header.end(), ',') == std::count(line.begin(), line.end(), ','));
}

TEST_CASE("the table shows each row beside its standard, growths and duties", "[report]") {
  Report report = full_report();
  Row slower = full_row();
  slower.method = "exact", slower.standard = false, slower.median = 5.5, slower.first_wrong.clear(),
  slower.fallback = {};
  Row peer = slower;
  peer.library = "CGAL", peer.method = "EPICK", peer.median = 11;
  report.rows = {slower, full_row(), peer};  // the standard need not stand first
  const std::string text = table(report);
  CHECK_THAT(text, Contains("ray-sphere, double, near-tangent"));
  const auto line = [&](const std::string& start) {
    const std::size_t at = text.find("  " + start);
    REQUIRE(at != std::string::npos);
    return text.substr(at, text.find('\n', at) - at);
  };
  CHECK_THAT(line("exact"), Contains("5.50") && Contains("2.00"));
  CHECK_THAT(line("half-B"), Contains("2.75") && Contains("2.62 to 2.88") && Contains("8.50") && Contains("1.00") &&
                                 Contains("6.25 %"));
  CHECK_THAT(line("CGAL: EPICK"), Contains("11.00") && Contains("4.00"));
  CHECK_THAT(text, Contains("first wrong: origin (1, 2, 3)"));
  CHECK_THAT(text, Contains("n^1.30") && Contains("10000: 3e+06 ns"));
  CHECK_THAT(text, Contains("isect --help") && Contains("12.5 ms  (target 30)"));
}

TEST_CASE("two sizes give no exponent", "[report]") {
  Growth g = {"all pairs", "sweep", "isect", "query", {10, 100}, {1, 9}, 0.954};
  CHECK_FALSE(g.power());
  Report report;
  report.growths = {g};
  CHECK(table(report).find("n^") == std::string::npos);
  g.n.push_back(1000), g.ns.push_back(81);
  CHECK(g.power() == 0.954);
}

TEST_CASE("the fitted exponent is the power in an exact power law, and the least squares' otherwise", "[report]") {
  const std::vector<double> n = {10, 100, 1000, 10000};
  for (const double power : {0.0, 0.5, 1.0, 2.0}) {
    std::vector<double> time;
    for (const double x : n) time.push_back(7 * std::pow(x, power));
    CHECK(fitted_exponent(n, time) == Approx(power).margin(1e-12));
  }
  // 1, 10, 10 over 1, 10, 100: the slope of (0, 0), (1, 1), (2, 1) is 1/2
  CHECK(fitted_exponent({1, 10, 100}, {1, 10, 10}) == Approx(0.5));
  CHECK(fitted_exponent({10}, {5}) == 0);
  CHECK(fitted_exponent({}, {}) == 0);
}

TEST_CASE("wrong verdicts are told a million", "[report]") {
  CHECK(full_row().wrong() == 8);
  CHECK(full_row().wrong_per_million() == 7812.5);
  CHECK(bare_row().wrong_per_million() == 0);
}

}  // namespace report_test
