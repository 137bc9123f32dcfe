#include "bench/report_text.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>

#include "bench/prose.h"
#include "bench/rows.h"
#include "bench/session.h"
#include "bench/targets.h"
#include "tests/catch.h"
#include "tests/scratch.h"
#include "tests/viz/drawn.h"
#include "viz/formats/files.h"

namespace report_text_test {
using namespace isect;
using namespace isect::bench;
using isect::test::Contains;

namespace {

/// The row with all passes but the least within 1 % of their median.
Row timed(Row r, double ns) {
  r.ns = 0.8 * ns, r.median = ns, r.lo = 0.99 * ns, r.hi = 1.01 * ns;
  return r;
}
Row row(const std::string& method, double ns, const std::string& family, long wrong,
        const std::string& library = "isect") {
  Row r;
  r.test = "ray-sphere", r.method = method, r.library = library, r.scalar = "double", r.family = family;
  r.hard = family != "ordinary", r.cases = 65536, r.judged = 1000, r.false_no = wrong;
  return timed(r, ns);
}

Row with_error(Row r, double median, double p99, double most) {
  r.ulps = {median, p99, most};
  for (int i = 0; i <= 40; ++i) r.quantiles.push_back(most * i / 40);
  return r;
}

Report report(const std::string& build, double exact_ns) {
  Report r;
  r.machine = {"a machine", "a compiler", "-O3", build, 2, 0.01, 0.02, "2026-01-02", "0123abc"};
  r.seed = 7;
  for (const char* family : {"ordinary", "planet", "near-tangent"}) {
    const bool hard = std::string(family) != "ordinary";
    Row naive = with_error(row("quadratic", 10, family, hard ? 250 : 0), 1, hard ? 1e6 : 20, hard ? INFINITY : 60);
    naive.standard = true;
    Row exact = with_error(row("exact", hard ? 900 : exact_ns, family, 0), 0.2, 0.5, 0.5);
    exact.exact = true, exact.fallback = hard ? 0.5 : 0;
    r.rows.insert(r.rows.end(), {naive, with_error(row("robust", 14, family, hard ? 10 : 0), 0.6, 6, 50), exact});
    if (build == "peers") r.rows.push_back(row("do_intersect", 5, family, hard ? 3 : 0, "CGAL"));
  }
  r.growths.push_back({"all pairs", "overlapping_pairs", "isect", "all pairs", {1e3, 1e4, 1e6}, {1e5, 1e6, 1e8}, 1});
  if (build == "peers")
    r.growths.push_back({"all pairs", "rtcCollide", "Embree", "all pairs", {1e3, 1e4, 1e6}, {6e5, 6e6, 1e9}, 1.07});
  r.duties = {{"start the program", 20, "ms", 100.0}, {"window", 25, "frames/s", 30.0}, {"memory", 90, "MB", {}}};
  r.notes = {{"ray-sphere", "planet", "an eye above a planet."}};
  r.targets = {{.work = "times of rays", .test = "ray-sphere", .theirs = "naive", .at_most = 2},
               {.work = "verdicts of rays", .kind = Target::wrong, .test = "ray-sphere", .at_most = 0},
               {.work = "errors of t", .kind = Target::ulps, .test = "ray-sphere", .at_most = 4},
               {.work = "pairs",
                .kind = Target::growth,
                .test = "all pairs",
                .ours = "overlapping_pairs",
                .theirs = "Embree",
                .n = 1e6,
                .at_most = 0.2},
               {.work = "boxes", .test = "aabb-aabb", .theirs = "Eigen", .at_most = 0.4}};
  return r;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

/// The target with that `work`, which every report here has.
Target target(const std::string& work) {
  for (const Target& t : report("portable", 29).targets)
    if (t.work == work) return t;
  throw std::runtime_error("no target for " + work);
}

}  // namespace

TEST_CASE("numbers read as words of a sentence", "[report_text]") {
  CHECK(number(0.497) == "0.497");
  CHECK(number(42.68) == "42.7");
  CHECK(number(1284) == "1,280");
  CHECK(number(413200) == "413,000");
  CHECK(number(1.34e8) == "1.3e8");
  CHECK(number(INFINITY) == "∞");
  CHECK(count(65536) == "65,536");
  CHECK(count(7) == "7");
  CHECK(share(0, 1000) == "none");
  CHECK(share(3, 1000) == "0.3 %");
  CHECK(share(240, 1000) == "24 %");
  CHECK(share(1, 65536) == "15 in a million");
  CHECK(listed({"a", "b", "c"}) == "a, b and c");
  CHECK(ratio_text(2.94) == "2.9");
  CHECK(ratio_text(634) == "630");
  CHECK(with_interval(2.06, 2.05, 2.08) == "2.06 [2.05, 2.08]");
  CHECK(with_interval(2.061, 2.0601, 2.0604) == "2.06");
}

TEST_CASE("what to choose follows from the times and the verdicts", "[report_text]") {
  Measured m = {report("portable", 29)};
  CHECK(contains(test_text(m, "ray-sphere"),
                 "exact call takes 29 [28.7, 29.3] ns and quadratic 10 [9.9, 10.1] ns: a ratio of 2.9 [2.84, 2.96]."));
  CHECK(contains(
      test_text(m, "ray-sphere"),
      "Choose the exact call.** Use quadratic only if all input is like the ordinary family, and saving 19 ns"));
  CHECK(contains(test_text(m, "ray-sphere"), "right on all 3,000 cases of all families judged in double."));
  CHECK(contains(test_text(m, "ray-sphere"), "gets wrong 25 % of planet and 25 % of near tangent"));
  CHECK(contains(test_text(m, "ray-sphere"),
                 "robust errs least: its time, divided by that of quadratic, is 1.4 [1.37, 1.43], and it is wrong on 1 "
                 "% of planet"));

  m.portable = report("portable", 10.9);
  CHECK(contains(test_text(m, "ray-sphere"),
                 "**Choose the exact call.** In double nothing inexact takes clearly less time."));

  m.portable = report("portable", 29);
  for (Row& r : m.portable.rows)
    if (r.standard && !r.hard) r.false_yes = 1;
  CHECK(contains(test_text(m, "ray-sphere"), "Quadratic takes less time, but errs on ordinary input already"));

  m.portable = report("portable", 29);
  for (Row& r : m.portable.rows) r.false_no = 0;
  CHECK(contains(test_text(m, "ray-sphere"), "Choose quadratic where time matters"));

  for (Row& r : m.portable.rows)
    if (r.exact && r.hard) r.false_no = 2;
  CHECK(contains(test_text(m, "ray-sphere"), "wrong on 4 of 3,000 cases judged: a fault"));
}

TEST_CASE(
    "the matrix of libraries says who is right about the hard cases, who is wrong on how many, and who has no test",
    "[report_text]") {
  Report peers = report("peers", 29);
  Row exact = row("do_intersect, EPECK", 80, "planet", 0, "CGAL"), floats = row("rayTest", 9, "planet", 400, "Bullet");
  peers.rows.insert(peers.rows.end(), {exact, row("do_intersect, EPECK", 80, "ordinary", 0, "CGAL"), floats,
                                       row("rayTest", 9, "ordinary", 0, "Bullet")});
  Row unjudged = row("within", 9, "near-tangent", 0, "Boost");
  unjudged.judged = 0;
  peers.rows.push_back(unjudged);
  const std::string told = verdicts_text(peers);
  INFO(told);
  CHECK(contains(
      told,
      "| question | isect | CGAL | Bullet | FCL | Boost | GEOS |\n| --- | --- | --- | --- | --- | --- | --- |\n"
      "| ray-sphere | right, 2,000 | do_intersect: wrong on 0.3 %, 6 of 2,000; do_intersect, EPECK: right, "
      "1,000 (not asked: near tangent) | rayTest: wrong on 40 %, 400 of 1,000 (not asked: near tangent) |  |  |  |\n"));
  CHECK(contains(
      told,
      "isect 1, 0 and 0; CGAL 1, 0 and 0; Bullet 0, 1 and 0; FCL 0, 0 and 1; Boost 0, 0 and 1; GEOS 0, 0 and 1."));

  for (Row& r : peers.rows)
    if (r.exact && r.family == "planet") r.false_no = 3;
  CHECK(contains(verdicts_text(peers), "| ray-sphere | wrong on 0.15 %, 3 of 2,000 |"));
  std::erase_if(peers.rows, [](const Row& r) { return r.hard; });
  CHECK(verdicts_text(peers).empty());
  CHECK(contains(publication({report("portable", 29), {}, report("peers", 29)}).text, "### Right and wrong\n"));
}

TEST_CASE("targets are met, missed or not measured", "[report_text]") {
  const Report portable = report("portable", 19), slow = report("portable", 21), peers = report("peers", 19);
  const Target t = target("times of rays");
  CHECK(met(t, measured(t, portable).value()));
  CHECK_FALSE(met(t, measured(t, slow).value()));
  CHECK(measured(target("errors of t"), portable).value() == 0.5);
  CHECK(measured(target("verdicts of rays"), portable).value() == 0);

  const Target pairs = target("pairs");
  CHECK_FALSE(measured(pairs, portable).has_value());
  CHECK(measured(pairs, peers).value() == Approx(0.1));
  CHECK(met(pairs, 0.1));
  CHECK_FALSE(measured(target("boxes"), peers).has_value());

  CHECK(contains(target_text({portable}), "3 met, 0 missed"));
  CHECK(contains(target_text({portable}), "| times of rays | at most 2 × naive | 1.9 [1.86, 1.94] ✓ |"));
  CHECK(contains(target_text({slow}), "2 met, 1 missed"));
  CHECK(contains(target_text({slow, {}, peers}), "3 met, 1 missed"));
}

TEST_CASE("the report says where others are ahead", "[report_text]") {
  const std::string text = loss_text({report("portable", 21), {}, report("peers", 21)});
  CAPTURE(text);
  CHECK(contains(text,
                 "Target missed: times of rays: 2.1 [2.06, 2.14] (portable) and 2.1 [2.06, 2.14] (peers); wanted at "
                 "most 2 × naive."));
  CHECK(contains(text,
                 "CGAL: do_intersect is faster on ordinary cases, 5 ns against 21 ns; it is wrong on 0.2 % "
                 "of all cases judged."));
  CHECK(contains(text, "Ray-sphere: the exact call takes 90 times the time of quadratic on \"planet\" (900 ns)."));
}

TEST_CASE("where others are ahead as n grows, the report says at the largest size that they were asked",
          "[report_text]") {
  Measured m = {report("portable", 29), {}, report("peers", 29)};
  CHECK_FALSE(contains(loss_text(m), "n = 10^"));  // Embree takes ten times as long
  m.peers->growths.push_back({"all pairs", "sweep", "isect", "all pairs", {1e3, 1e4}, {9e4, 2e6}, 1});
  m.peers->growths.push_back({"all pairs", "btDbvt", "Bullet", "all pairs", {1e3, 1e4}, {1e6, 8e5}, 1});
  CHECK(contains(loss_text(m), "- All pairs, n = 10^4: Bullet: btDbvt takes 0.8 of the time of overlapping_pairs."));
  m.peers->growths.push_back({"all pairs", "exact", "isect", "all pairs", {1e3, 1e4}, {9e6, 4e6}, 1});
  CHECK(contains(loss_text(m), "Bullet: btDbvt takes 0.2 of the time of exact."));  // what is fast may be inexact
  m.peers->growths[3].ns[1] = 3.9e6;                                                // less than a tenth more is no loss
  CHECK_FALSE(contains(loss_text(m), "btDbvt takes"));
}

TEST_CASE("advice for double says where it is another one, and where another exact method takes less",
          "[report_text]") {
  Measured m = {report("portable", 5), report("native", 29)};
  for (Row* r : {&m.portable.rows[0], &m.portable.rows[1]}) *r = timed(*r, 10);
  const auto in_float = [](Row r, double ns) {
    r.scalar = "float";
    return timed(r, ns);
  };
  for (const Row& r : std::vector(m.portable.rows)) m.portable.rows.push_back(in_float(r, r.exact ? 29 : 10));
  Row prepared = with_error(row("prepared", 20, "ordinary", 0), 0.2, 0.5, 0.5);
  prepared.exact = true;
  m.portable.rows.push_back(prepared);
  prepared.family = "planet", prepared.hard = true;
  m.portable.rows.push_back(timed(prepared, 40));
  const std::string text = test_text(m, "ray-sphere");
  CAPTURE(text);
  CHECK(contains(text,
                 "**Choose the exact call.** In double nothing inexact takes clearly less time. In float robust "
                 "does, 10 ns against 29. Compiled for this machine quadratic does, 10 ns against 29. On \"planet\" "
                 "prepared takes 40 ns, against 900."));
}

TEST_CASE("the text names every figure once, with alt text and caption, and no figure is missing", "[report_text]") {
  const Publication p = publication({report("portable", 29), report("native", 20), report("peers", 29)});
  std::vector<std::string> named;
  const std::regex figure(R"(!\[([^\]]+)\]\(report/([^)]+)\))");
  for (std::sregex_iterator it(p.text.begin(), p.text.end(), figure), end; it != end; ++it) {
    CHECK((*it)[1].length() > 20);
    named.push_back((*it)[2]);
  }
  REQUIRE(named.size() == p.files.size());
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < named.size(); ++i) {
    CHECK(named[i] == p.files[i].first);
    CHECK(contains(p.text, "Figure " + std::to_string(i + 1) + ". "));
    bytes += p.files[i].second.size();
  }
  CHECK(bytes < 1500000);
  CHECK(named.front() == "ratios.svg");
  CHECK(contains(p.text, "rtcCollide as n^1.07"));
  CHECK(contains(p.text, "| window | 25 frames/s | at least 30 frames/s |"));
  CHECK_FALSE(std::regex_search(p.text, std::regex(R"(\bnan\b)")));
  CHECK_FALSE(std::regex_search(p.text, std::regex(R"([a-z.,]  +[A-Za-z])")));  // no gap in a sentence
}

TEST_CASE("a report without native or other libraries says that they were not measured", "[report_text]") {
  const std::string text = publication({report("portable", 29)}).text;
  CHECK(contains(text, "native build: not measured"));
  CHECK(contains(text, "beside other libraries: not measured"));
  CHECK_FALSE(contains(text, "CGAL:"));
}

TEST_CASE("a report of a noisy machine is not published", "[report_text]") {
  const std::string folder = isect::test::scratch("isect-noisy-report-test").string();
  std::filesystem::remove_all(folder);
  Measured m = {report("portable", 29), {}, report("peers", 29)};
  m.peers->machine.noise = 0.11;
  CHECK_THROWS_WITH(publish(m, folder), Contains("the peers build was measured at 11 % noise; at most 10 %"));
  CHECK_FALSE(std::filesystem::exists(folder));
  m.peers->machine.noise = 0.1;
  CHECK_NOTHROW(publish(m, folder));
  std::filesystem::remove_all(folder);
}

TEST_CASE("without hard cases nothing is advised but what costs nothing", "[report_text]") {
  Measured m = {report("portable", 29)};
  std::erase_if(m.portable.rows, &Row::hard);
  CHECK_FALSE(contains(test_text(m, "ray-sphere"), "Choose"));
  for (const double exact_ns : {10.5, 9.0}) {
    m.portable = report("portable", exact_ns);
    std::erase_if(m.portable.rows, &Row::hard);
    CHECK(contains(test_text(m, "ray-sphere"),
                   "**Choose the exact call.** In double nothing inexact takes clearly less time."));
  }
}

TEST_CASE("an exact method that is faster and says as much is chosen", "[report_text]") {
  Measured m = {report("portable", 29)};
  Row batch = with_error(row("batch", 2, "ordinary", 0), 0.2, 0.5, 0.5);
  batch.exact = true;
  m.portable.rows.push_back(batch);
  CHECK(contains(
      test_text(m, "ray-sphere"),
      "**Choose batch.** It is as exact as the exact call. In double nothing inexact takes clearly less time."));

  m.portable.rows.back() = timed(m.portable.rows.back(), 27);  // within the noise
  CHECK(contains(test_text(m, "ray-sphere"), "**Choose the exact call.** Use "));

  m.portable.rows.back() = row("yes or no", 2, "ordinary", 0);
  m.portable.rows.back().exact = true;
  CHECK(contains(test_text(m, "ray-sphere"), "**Choose the exact call.** Use "));
}

TEST_CASE("two methods that fail on few families are told apart by these", "[report_text]") {
  Measured m = {report("portable", 29)};
  for (Row& r : m.portable.rows)
    if (r.family == "planet" && !r.exact) r.false_no = 0;
  CHECK(contains(test_text(m, "ray-sphere"),
                 "**Choose the exact call,** or quadratic where no input is near tangent: it saves 19 ns a call."));
  CHECK(contains(summary_text(m), "| exact; quadratic if no input is near tangent |"));

  Row peer = row("do_intersect, EPICK", 15, "ordinary", 0, "CGAL"),
      hard = row("do_intersect, EPICK", 15, "planet", 0, "CGAL");
  peer.exact = hard.exact = true;
  m.peers = report("peers", 29);
  std::erase_if(m.peers->rows, [](const Row& r) { return r.library != "isect"; });
  m.peers->rows.insert(m.peers->rows.end(), {peer, hard});
  CHECK(contains(summary_text(m),
                 "| CGAL, EPICK (not asked: near tangent) | quadratic: 10; wrong on 25 % of near tangent, each a false "
                 "no |"));  // it takes less
  m.portable.rows[0] = timed(m.portable.rows[0], 20), m.portable.rows[1] = timed(m.portable.rows[1], 20);
  CHECK(contains(summary_text(m),
                 "| CGAL, EPICK: 15 (the exact call there: 29); never wrong in 2,000 cases | CGAL: do_intersect, EPICK "
                 "for yes or no |"));
}

TEST_CASE("the first page has a line a test", "[report_text]") {
  Measured m = {report("portable", 29), {}, report("peers", 29)};
  CHECK(contains(summary_text(m),
                 "| [ray-sphere](#ray-sphere) | 29 [28.7, 29.3] | 900, planet | none | CGAL: 5 (the exact call there: "
                 "29); wrong on 0.3 "
                 "% of planet, and on 1 more, each a false no | exact; CGAL: do_intersect for yes or no only if all "
                 "input is ordinary |"));
  for (Row& r : m.portable.rows)
    if (!r.exact) r.false_no = 0;
  for (Row& r : m.peers->rows) r.false_no = 0;
  CHECK(contains(summary_text(m),
                 "| quadratic, robust and CGAL | CGAL: 5 (the exact call there: 29); never wrong in 3,000 cases |"));
  const std::string text = publication(m).text;
  const auto at = [&](const std::string& part) { return text.find(part); };
  CHECK((at("| [ray-sphere](#ray-sphere)") < at("## Test by test") && at("## Test by test") < at("## How to read it")));
  CHECK((at("## How to read it") < at("### The hard families") &&
         at("### The hard families") < at("## How to make this report again")));
}

TEST_CASE("without hard cases the first page advises nothing but what costs nothing", "[report_text]") {
  Measured m = {report("portable", 29)};
  std::erase_if(m.portable.rows, &Row::hard);
  CHECK(contains(summary_text(m), "| 29 [28.7, 29.3] |  |  | quadratic: 10; not judged on hard input |  |"));
}

TEST_CASE("another library's method that is exact and faster is chosen", "[report_text]") {
  Measured m = {report("portable", 29), {}, report("peers", 29)};
  for (const char* family : {"ordinary", "planet"}) {
    Row peer = with_error(row("t, EPECK", 20, family, 0, "CGAL"), 0.2, 0.5, 0.5);
    peer.exact = true;
    m.peers->rows.push_back(peer);
  }
  CHECK(contains(
      test_text(m, "ray-sphere"),
      "**Choose CGAL: t, EPECK.** It is as exact as the exact call, and takes 0.69 [0.676, 0.704] of its time. "
      "CGAL: do_intersect takes less, but is for input like the ordinary family only."));
  CHECK(
      contains(summary_text(m), "| CGAL: t, EPECK; CGAL: do_intersect for yes or no only if all input is ordinary |"));
  for (Row& r : m.peers->rows)
    if (r.method == "t, EPECK") r.false_no = r.hard;
  CHECK(contains(test_text(m, "ray-sphere"), "**Choose the exact call.** Use "));  // it was wrong once
}

TEST_CASE("a test without an exact call has its least time on the first page", "[report_text]") {
  Measured m = {report("portable", 29)};
  std::erase_if(m.portable.rows, &Row::exact);
  CHECK(contains(summary_text(m),
                 "| none |  | none | quadratic: 10; wrong on 25 % of planet, and on 1 more, each a false no |  |"));
}

TEST_CASE("the first page says what is as exact and takes less where no value is wanted, or on the worst family",
          "[report_text]") {
  Measured m = {report("portable", 29)};
  for (const char* family : {"ordinary", "planet", "near-tangent"}) {
    Row yes_or_no = row("exact, yes or no", family == std::string("ordinary") ? 12 : 800, family, 0);
    Row prepared = with_error(row("prepared", 40, family, 0), 0.2, 0.5, 0.5);
    yes_or_no.exact = prepared.exact = true;
    m.portable.rows.insert(m.portable.rows.end(), {yes_or_no, prepared});
  }
  CHECK(contains(summary_text(m), "| exact, yes or no; prepared |"));
  CHECK(contains(
      summary_text(m),
      "; exact, yes or no (12) where that is enough; prepared for input like planet (40) and near tangent (40) |"));
}

TEST_CASE("a test without an exact call names what never says no wrongly", "[report_text]") {
  Measured m = {report("portable", 29)};
  std::erase_if(m.portable.rows, &Row::exact);
  for (Row& r : m.portable.rows)
    if (r.method == "robust") r.false_yes = r.false_no, r.false_no = 0;
  CHECK(contains(summary_text(m), "| robust where none may be missed |"));
}

TEST_CASE("a test without ordinary cases has a table of its families", "[report_text]") {
  Report r = report("portable", 29);
  for (Row& q : r.rows) q.test = "pairs of rays", q.family = "edge-aimed", q.hard = true;
  CHECK(contains(publication({r}).text, "### Pairs of rays\n\n| double | family | ns | wrong |"));
  CHECK(contains(test_text({r}, "pairs of rays"), "| exact | edge aimed | 29 [28.7, 29.3] | none |"));
}

TEST_CASE("each test's table has both kinds of time, and ratios to the standard and to the best other",
          "[report_text]") {
  Measured m = {report("portable", 29), {}, report("peers", 29)};
  for (Row& r : m.portable.rows) {
    if (r.method == "robust") r = timed(r, 8);
    if (!r.hard) r.latency = 3 * r.median;
  }
  const std::string text = test_text(m, "ray-sphere");
  CAPTURE(text);
  CHECK(contains(text, "Latency: the exact call 87 ns, quadratic 30 ns."));
  CHECK(contains(text, "| double, ordinary cases | ns | latency | ratio | wrong |"));
  CHECK(contains(text, "| exact | 29 [28.7, 29.3] | 87 | 2.9 [2.84, 2.96] | none | none |"));
  CHECK(contains(text,
                 "is best, at 5 [4.95, 5.05] ns: the time of the exact call, divided by that in one run, is 5.8 [5.69, "
                 "5.92]."));  // CGAL's, from its run
  CHECK(contains(text, "| CGAL: do_intersect | 5 [4.95, 5.05] |  | 5.8 [5.69, 5.92] | none | 0.3 % of planet |"));

  m.peers.reset();
  CHECK(contains(test_text(m, "ray-sphere"), "| ratio | to robust | wrong |"));
  CHECK(contains(test_text(m, "ray-sphere"), "| exact | 29 [28.7, 29.3] | 87 | 2.9 [2.84, 2.96] | 3.62 [3.55, 3.7] |"));
}

TEST_CASE("calling on and telling the wrong side stand apart in the table", "[report_text]") {
  Measured m = {report("portable", 29)};
  for (Row& r : m.portable.rows) r.sides = Sides{r.wrong() / 10, r.wrong() - r.wrong() / 10};
  const std::string text = test_text(m, "ray-sphere");
  CAPTURE(text);
  CHECK(contains(text, "| wrong, all hard cases | called on | wrong side |"));
  CHECK(contains(text, "| none | 25 % | 50 | 450 |"));
  CHECK(contains(text, "Of its wrong verdicts 50 call \"on\" what lies on a side, 450 name a wrong side."));
}

TEST_CASE("of times whose intervals overlap none is called less or more", "[report_text]") {
  for (const double exact_ns : {10.0, 10.1, 9.9, 10.15}) {
    Measured m = {report("portable", exact_ns), report("native", exact_ns), report("peers", exact_ns)};
    for (std::optional<Report>* r : {&m.native, &m.peers}) REQUIRE(r->has_value());
    for (Report* r : {&m.portable, &*m.native, &*m.peers}) {
      r->targets.clear(), r->machine.noise = 0;  // so that only the intervals tell
      for (Row& one : r->rows)
        one = timed(one, one.exact ? exact_ns : 10 + 0.01 * static_cast<double>(one.wrong() % 7));
    }
    const std::string text = summary_text(m) + test_text(m, "ray-sphere") + loss_text(m);
    CAPTURE(text);
    std::string claims = std::regex_replace(text, std::regex("(takes clearly less time|what takes less)"), "");
    CHECK_FALSE(std::regex_search(
        claims, std::regex(R"(\b(faster|fastest|slower|slowest|less time|saves|times the time|costs|is behind)\b)")));
    CHECK(contains(text, "**Choose the exact call.** In double nothing inexact takes clearly less time."));
    CHECK(contains(text, "| none; least: "));
  }
  const Row a = timed({}, 10), near = timed({}, 10.15), far = timed({}, 10.5);
  CHECK_FALSE(faster(a, near, 0));
  CHECK(faster(a, far, 0.02));
  CHECK_FALSE(faster(a, far, 0.06));  // apart, but only by what the machine adds
  CHECK_FALSE(faster(far, a, 0));
}

TEST_CASE("two sizes give no power of n", "[report_text]") {
  Measured m = {report("portable", 29)};
  Growth& g = m.portable.growths[0];
  g.n.pop_back(), g.ns.pop_back();
  const std::string text = publication(m).text;
  CHECK_FALSE(contains(text, "n^"));
  CHECK_FALSE(contains(text, "growing as n"));
  CHECK(contains(text, "All pairs: too few sizes for a power of n."));
}

TEST_CASE("growth that was not measured beside other libraries is shown from the portable build", "[report_text]") {
  Measured m = {report("portable", 29), {}, report("peers", 29)};
  m.portable.growths.push_back({"hulls", "exact", "isect", "set of points", {1e3, 1e4, 1e5}, {1e5, 1e6, 1e7}, 1});
  const std::string text = publication(m).text;
  CHECK(contains(text, "Hulls, set of points: exact as n^1.00"));
  CHECK(contains(text, "rtcCollide"));  // of what was, the curves of that run
}

TEST_CASE("a quick run, changed sources and several commits are not published", "[report_text]") {
  const std::string folder = isect::test::scratch("isect-refused-report-test").string();
  std::filesystem::remove_all(folder);
  const auto refused = [&](const std::string& native_commit, bool quick, const std::string& why) {
    Measured m = {report("portable", 29), report("native", 29)};
    m.native->machine.commit = native_commit, m.native->quick = quick;
    CHECK_THROWS_WITH(publish(m, folder), Contains(why));
    CHECK_FALSE(std::filesystem::exists(folder));
  };
  refused("0123abc", true, "the run of the native build was quick, with few passes and few cases judged: measure it");
  refused("0123abc-dirty", false, "the native build has changes that no commit has (0123abc-dirty): commit them");
  refused("4567def", false, "different commits, portable from 0123abc and native from 4567def");
  refused("", false, "different commits, portable from 0123abc and native from an unknown commit");
  refused("0123abc, 4567def", false, "the native build come from several commits (0123abc, 4567def)");
  Measured unknown = {report("portable", 29), report("native", 29)};
  unknown.portable.machine.commit = unknown.native->machine.commit = "";
  CHECK_NOTHROW(require_publishable(unknown));
}

TEST_CASE("a row of the ratios' chart is the library's fastest way, with its interval", "[report_text]") {
  Report r = report("peers", 29);
  r.rows.push_back(row("slow", 50, "ordinary", 0, "CGAL"));
  const viz::Bars bars = std::get<viz::Bars>(ratio_plot(r).chart.kind);
  REQUIRE(bars.bars.size() == 1);
  const viz::Bar& bar = bars.bars[0];
  CHECK(bar.name == "ray-sphere: CGAL");
  const viz::Figure figure = viz::chart_figure(ratio_plot(r).chart, viz::ThemeName::grey, 340);
  for (std::size_t i = 0; i < figure.labels.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(viz::meet(figure.labels[i].box, figure.labels[j].box));
  REQUIRE((bar.dots.size() == 1 && bar.interval && bar.target == 1.0));
  CHECK((bar.dots[0].first == 1 && bar.dots[0].second == Approx(5.8)));  // wrong in some case
  CHECK((bar.interval->first == Approx(28.71 / 5.05) && bar.interval->second == Approx(29.29 / 4.95)));
  CHECK((bars.x.lo < bar.interval->first && bar.interval->second < bars.x.hi));
  CHECK(std::ranges::count(plots(r), std::string("ratios"), &Plotted::name) == 1);
  CHECK(std::ranges::count(plots(report("portable", 29)), std::string("ratios"), &Plotted::name) == 0);
}

TEST_CASE("the text says of each hard family what it is made of", "[report_text]") {
  CHECK(contains(publication({report("portable", 29)}).text,
                 "### The hard families\n\nRay-sphere:\n\n- planet: an eye above a planet.\n\n"));
}

TEST_CASE("reports are sorted by their build", "[report_text]") {
  const Measured m = measured_of({report("peers", 1), report("portable", 2)});
  CHECK(m.portable.machine.build == "portable");
  CHECK(m.peers.has_value());
  CHECK_FALSE(m.native.has_value());
  CHECK_THROWS_AS(measured_of({report("native", 1)}), std::runtime_error);
  CHECK_THROWS_WITH(measured_of({report("portable", 1), report("other", 1)}), Contains("build \"other\""));
  CHECK_THROWS_AS(measured_of({report("portable", 1), report("portable", 1)}), std::runtime_error);
  CHECK_THROWS_AS(measured_of({report("portable", 1), report("peers", 1), report("peers", 1)}), std::runtime_error);
}

TEST_CASE("runs of one build that have no test in common are one report", "[report_text]") {
  Report other = report("portable", 29), native = report("native", 1);
  for (Row& r : other.rows) r.test = "orient2d";
  other.growths.clear();
  other.machine.noise = 0.07;
  const Measured m = measured_of({report("portable", 29), native, other});
  CHECK(m.portable.rows.size() == 2 * native.rows.size());
  CHECK(m.portable.machine.noise == 0.07);
  CHECK(m.native->rows.size() == native.rows.size());
  CHECK(measured_of({other, report("portable", 29)}).portable.rows[0].test == "ray-sphere");  // as suites are ordered

  other.quick = true;
  CHECK_THROWS_WITH(require_publishable(measured_of({report("portable", 29), other})), Contains("was quick"));
  other.quick = false, other.machine.commit = "4567def";
  CHECK_THROWS_WITH(require_publishable(measured_of({report("portable", 29), other})),
                    Contains("several commits (0123abc, 4567def)"));
  other.growths.push_back({"trees", "build", "isect", "build", {1, 2}, {1, 2}, 1});
  Report third = report("portable", 29);
  third.rows.clear(), third.growths = other.growths;
  CHECK_THROWS_WITH(measured_of({other, third}), "two reports of the portable build have trees");
}

TEST_CASE("a target that is missed says what takes the time", "[report_text]") {
  Report r = report("portable", 29);
  Target target = {.work = "ray-sphere", .test = "ray-sphere", .theirs = "naive", .at_most = 1.5};
  target.limit = "Two sums in place of one.";
  r.targets = {target};
  const std::string told = "wanted at most 1.5 × naive. Two sums in place of one.\n";
  CHECK(contains(publication({r}).text, told));
  CHECK(contains(publication({report_of(json(r))}).text, told));
  r.targets[0].at_most = 5;
  CHECK_FALSE(contains(publication({r}).text, "Two sums"));
}

TEST_CASE("the report names caches, and the libraries with their versions", "[report_text]") {
  Measured m = {report("portable", 29), {}, report("peers", 29)};
  CHECK(contains(machine_text(m), "Measured on a machine with 2 cores:"));
  m.portable.machine.caches = "1 MB of L2", m.peers->machine.libraries = "CGAL 5.5.1, Boost 1.74.0";
  m = {report_of(json(m.portable)), {}, report_of(json(*m.peers))};
  CHECK(contains(machine_text(m), "Measured on a machine with 2 cores, 1 MB of L2:"));
  CHECK(contains(machine_text(m), "noise 2.0 %; beside CGAL 5.5.1, Boost 1.74.0\n"));
}

TEST_CASE("a target on hard input is about the worst family, and about those that touch exactly", "[report_text]") {
  Session session(Effort(), 1);
  session.aim_on_hard_input("ray-sphere", "It climbs.");
  REQUIRE(session.found.targets.size() == 2);
  const Target worst = session.found.targets[0], touch = session.found.targets[1];
  Report r = report("portable", 29);
  r.targets = session.found.targets;
  CHECK(measured(worst, r).value() == Approx(90));
  CHECK_FALSE(met(worst, 90));
  CHECK(told(worst, r) == "90 (planet)");
  CHECK_FALSE(measured(touch, r).has_value());
  CHECK_FALSE(contains(target_text({r}), "exact touch"));
  CHECK(contains(loss_text({r}), "wanted at most 30 × naive. It climbs."));

  for (Row& row : r.rows)
    if (row.family == "planet") row.family = "decimal", row.scalar = "float";
  r.rows.push_back(row("exact", 290, "grid", 0));
  CHECK(told(touch, r) == "10 (grid)");  // floats have no ordinary family here
  CHECK(measured(touch, r).value() == Approx(10));
  r.rows.back().median = 293;
  CHECK(told(touch, r) == "10.1 (grid)");  // not 10, as it is missed
  r.rows.back().median = 290;
  CHECK(
      contains(target_text({report_of(json(r))}), "| ray-sphere, exact touch | at most 10 × ordinary | 10 (grid) ✓ |"));
}

TEST_CASE("the long proof is told with its commit, and what was wrong", "[report_text]") {
  const std::string kept =
      R"({"commit": "0123abc", "date": "2026-01-02",
          "verdicts": {"seeds": 2, "cases": 3000, "judged": 5000, "wrong": 0,
                       "tests": [{"test": "ray-sphere", "cases": 1000, "judged": 1000},
                                 {"test": "orient2d", "cases": 2000, "judged": 4000}]},
          "tests": {"run": 2790, "skipped": 2, "wrong": 0, "again": 3, "seconds": 601},
          "fuzz": [{"target": "query", "minutes": 30, "inputs": 123456, "wrong": 0},
                   {"target": "cases", "minutes": 30, "inputs": 7, "wrong": 1}]})";
  const std::string text = proof_text(proof_of(kept));
  CAPTURE(text);
  CHECK(contains(text, "on commit 0123abc, 2026-01-02"));
  CHECK(contains(text, "**3,000 cases**"));
  CHECK(contains(text, "5,000 answers of the exact calls, none wrong"));
  CHECK(contains(text, "2,790 tests in 11 minutes, 2 skipped, none failed; 3 had failed, were mended and run again."));
  CHECK(contains(text, "`query` ran for 30 minutes: 123,456 inputs, no fault"));
  CHECK(contains(text, "`cases` ran for 30 minutes: 7 inputs, a fault"));
  CHECK(contains(text, "| orient2d | 2,000 | 4,000 |"));
  CHECK_THROWS_WITH(proof_of("{}"), Contains("no long proof"));

  const std::string folder = isect::test::scratch("isect-proof-test").string();
  std::filesystem::remove_all(folder);
  publish({report("portable", 29)}, folder);
  CHECK_FALSE(contains(viz::read_file(folder + "/REPORT.md"), "long proof"));
  viz::write_file(folder + "/proof.json", kept);
  publish({report("portable", 29)}, folder);
  CHECK(contains(viz::read_file(folder + "/REPORT.md"), text));
  viz::write_file(folder + "/proof.json", "[]");
  CHECK_THROWS_WITH(publish({report("portable", 29)}, folder), Contains("no long proof"));
  CHECK(contains(viz::read_file(folder + "/REPORT.md"), text));
}

TEST_CASE("publishing writes text, figures and the lesson's rows, and clears figures of an earlier report",
          "[report_text]") {
  const std::string folder = isect::test::scratch("isect-report-test").string();
  std::filesystem::remove_all(folder);
  viz::Drawing drawing;
  drawing.width = drawing.height = 9;
  viz::write_file(folder + "/report/old.svg", viz::svg(drawing, {{"figure", "old"}}));
  viz::write_file(folder + "/report/mine.svg", viz::svg(drawing));
  viz::write_file(folder + "/report/renamed.svg", viz::svg(drawing, {{"figure", "another"}}));
  viz::write_file(folder + "/report/notes.png", "not even a picture");
  publish({report("portable", 29)}, folder);
  CHECK_FALSE(std::filesystem::exists(folder + "/report/old.svg"));
  for (const std::string mine : {"mine.svg", "renamed.svg", "notes.png"})
    CHECK(std::filesystem::exists(folder + "/report/" + mine));
  CHECK(contains(viz::read_file(folder + "/report/ray-sphere-double-error.svg"), "<svg"));
  CHECK(contains(viz::read_file(folder + "/REPORT.md"), "# Speed against error"));
  const Report kept = report_of(viz::read_file(folder + "/results.json"));
  CHECK(kept.rows.size() == 9);
  CHECK(kept.note("ray-sphere", "planet") == "an eye above a planet.");
  CHECK(kept.machine.flags == "-O3");
  std::filesystem::remove_all(folder);
}

TEST_CASE("publishing writes over what was published, and over nothing else", "[report_text]") {
  const std::string folder = isect::test::scratch("isect-report-test-own").string();
  for (const std::string name : {"REPORT.md", "results.json", "report/ray-sphere-double-error.svg"}) {
    std::filesystem::remove_all(folder);
    viz::write_file(folder + '/' + name, "{}");
    CHECK_THROWS_WITH(publish({report("portable", 29)}, folder),
                      isect::test::Contains(name + "': the file there was not published by isect"));
    CHECK(viz::read_file(folder + '/' + name) == "{}");
  }
  std::filesystem::remove_all(folder);
  publish({report("portable", 29)}, folder);
  CHECK_NOTHROW(publish({report("portable", 29)}, folder));
  std::filesystem::remove_all(folder);
}

TEST_CASE("the front of a family is what neither time nor verdicts beat", "[report_text]") {
  const Report r = report("portable", 29);
  const auto names = [](const std::vector<const Row*>& rows) {
    std::vector<std::string> all;
    for (const Row* one : rows) all.push_back(one->method);
    return all;
  };
  CHECK(names(front_of(rows_of(r, "ray-sphere", "double", "planet"), false)) ==
        std::vector<std::string>{"quadratic", "robust", "exact"});
  CHECK(names(front_of(rows_of(r, "ray-sphere", "double", "ordinary"), false)) ==
        std::vector<std::string>{"quadratic"});
  CHECK(names(front_of(rows_of(r, "ray-sphere", "double", "ordinary"), true)) ==
        std::vector<std::string>{"quadratic", "robust", "exact"});
}

}  // namespace report_text_test
