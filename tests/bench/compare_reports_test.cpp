// What became slower from one report to the next, beyond noise.

#include "bench/compare_reports.h"

#include "tests/catch.h"

namespace compare_reports_test {
using namespace isect::bench;
using isect::test::Contains;

namespace {

Row row(const std::string& method, double ns, double spread = 0.01) {
  Row r;
  r.test = "ray-sphere", r.method = method, r.library = "isect", r.scalar = "double", r.family = "ordinary";
  r.standard = method == "naive", r.ns = ns, r.spread = spread, r.judged = 1000;
  return r;
}

Report report(std::vector<Row> rows) {
  Report r;
  r.machine.build = "portable", r.machine.flags = "-O3";
  r.rows = std::move(rows);
  return r;
}

}  // namespace

TEST_CASE("a call is slower by its ratio to the standard, so that a slower machine does not count", "[compare]") {
  const Report before = report({row("naive", 2), row("exact", 6), row("fast", 1)});
  const Comparison other_machine = compare(before, report({row("naive", 3), row("exact", 9), row("fast", 1.5)}));
  CHECK(other_machine.rows[1].ratio == Approx(1));
  CHECK_FALSE(other_machine.rows[1].slower());
  CHECK(other_machine.rows[0].slower());  // the standard itself, by its times

  const Comparison slower = compare(before, report({row("naive", 2), row("exact", 9), row("fast", 0.5)}));
  CHECK(slower.rows[1].ratio == Approx(1.5));
  CHECK(slower.rows[1].slower());
  CHECK(slower.rows[2].faster());
  CHECK_FALSE(slower.holds());
  const std::string text = told(slower);
  CHECK_THAT(text, Contains("slower:\n   1.50 times (noise 4 %)  ray-sphere exact, double, ordinary: 6 -> 9 ns\n"));
  CHECK_THAT(text, Contains("faster:\n   0.50 times") && Contains("1 of 3 calls take as long as before"));
}

TEST_CASE("what its spread explains is no change", "[compare]") {
  const Report before = report({row("naive", 2), row("exact", 6, 0.2)});
  CHECK(compare(before, report({row("naive", 2), row("exact", 7.2, 0.1)})).holds());        // 20 % of 32
  CHECK_FALSE(compare(before, report({row("naive", 2), row("exact", 8.1, 0.1)})).holds());  // 35 %
  CHECK(compare(before, report({row("naive", 2), row("exact", 6.1, 0)})).holds());
}

TEST_CASE("more wrong verdicts and calls that are gone are told, whatever the times", "[compare]") {
  Row wrong = row("exact", 6);
  wrong.false_no = 2;
  const Report before = report({row("naive", 2), row("exact", 6)});
  const Comparison c = compare(before, report({row("naive", 2), wrong}));
  CHECK_FALSE(c.holds());
  CHECK_THAT(told(c), Contains("more often wrong: ray-sphere exact, double, ordinary: 0 -> 2000 in a million"));

  const Comparison other = compare(before, report({row("naive", 2), row("faster", 1)}));
  CHECK_FALSE(other.holds());
  CHECK_THAT(told(other), Contains("gone:\n  ray-sphere exact") && Contains("new:\n  ray-sphere faster"));
}

TEST_CASE("reports that have nothing in common, or come from other builds, are not compared", "[compare]") {
  const Report before = report({row("naive", 2)});
  CHECK_THROWS_WITH(compare(before, report({row("other", 2)})), Contains("no call is in both"));
  Report native = before;
  native.machine.build = "native";
  CHECK_THROWS_WITH(compare(before, native), Contains("portable (-O3) and native (-O3)"));
}

}  // namespace compare_reports_test
