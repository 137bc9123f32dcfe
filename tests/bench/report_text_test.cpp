#include "bench/report_text.h"

#include <cmath>
#include <filesystem>
#include <regex>

#include "bench/prose.h"
#include "bench/rows.h"
#include "bench/targets.h"
#include "tests/catch.h"
#include "tests/scratch.h"
#include "viz/files.h"

namespace report_text_test {
using namespace isect;
using namespace isect::bench;
using isect::test::Contains;

namespace {

Row row(const std::string& method, double ns, const std::string& family, long wrong,
        const std::string& library = "isect") {
  Row r;
  r.test = "ray-sphere", r.method = method, r.library = library, r.scalar = "double", r.family = family;
  r.hard = family != "ordinary", r.ns = r.median = ns, r.cases = 65536, r.judged = 1000, r.false_no = wrong;
  return r;
}

Row with_error(Row r, double median, double p99, double most) {
  r.ulps = {median, p99, most};
  for (int i = 0; i <= 40; ++i) r.quantiles.push_back(most * i / 40);
  return r;
}

Report report(const std::string& build, double exact_ns) {
  Report r;
  r.machine = {"a machine", "a compiler", "-O3", build, 2, 0.01, 0.02, "2026-01-02"};
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
  r.growths.push_back({"all pairs", "overlapping_pairs", "isect", "all pairs", {1e3, 1e6}, {1e5, 1e8}, 1});
  if (build == "peers")
    r.growths.push_back({"all pairs", "rtcCollide", "Embree", "all pairs", {1e3, 1e6}, {6e5, 1e9}, 1.07});
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

/// The target of that work in every report here.
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
}

TEST_CASE("what to choose follows from the times and the verdicts", "[report_text]") {
  Measured m = {report("portable", 29)};
  CHECK(contains(test_text(m, "ray-sphere"), "exact call takes 29 ns and quadratic 10 ns: a ratio of 2.9."));
  CHECK(contains(test_text(m, "ray-sphere"),
                 "Choose the exact call,** unless all input is like the ordinary family and 19 ns"));
  CHECK(contains(test_text(m, "ray-sphere"), "right on all 3,000 cases judged"));
  CHECK(contains(test_text(m, "ray-sphere"), "gets wrong 25 % of planet and 25 % of near tangent"));
  CHECK(contains(test_text(m, "ray-sphere"), "robust errs least, at a ratio of 1.4: still on 1 % of planet"));

  m.portable = report("portable", 10.5);
  CHECK(contains(test_text(m, "ray-sphere"), "It costs no more than quadratic"));

  m.portable = report("portable", 29);
  for (Row& r : m.portable.rows)
    if (r.standard && !r.hard) r.false_yes = 1;
  CHECK(contains(test_text(m, "ray-sphere"), "Quadratic errs on ordinary input already"));

  m.portable = report("portable", 29);
  for (Row& r : m.portable.rows) r.false_no = 0;
  CHECK(contains(test_text(m, "ray-sphere"), "Choose quadratic where time matters"));

  for (Row& r : m.portable.rows)
    if (r.exact && r.hard) r.false_no = 2;
  CHECK(contains(test_text(m, "ray-sphere"), "wrong on 4 of 3,000 cases judged: a fault"));
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
  CHECK(contains(target_text({slow}), "2 met, 1 missed"));
  CHECK(contains(target_text({slow, {}, peers}), "3 met, 1 missed"));
}

TEST_CASE("the report says where others are ahead", "[report_text]") {
  const std::string text = loss_text({report("portable", 21), {}, report("peers", 21)});
  CAPTURE(text);
  CHECK(contains(text,
                 "Target missed: times of rays: 2.1 (portable) and 2.1 (peers); wanted at "
                 "most 2 × naive."));
  CHECK(contains(text,
                 "CGAL: do_intersect is faster on ordinary cases, 5 ns against 21 ns; it is wrong on 0.2 % "
                 "of all cases judged."));
  CHECK(contains(text, "Ray-sphere: the exact call takes up to 90 times the time of quadratic (planet: 900 ns)."));
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
  m.portable = report("portable", 10.5);
  std::erase_if(m.portable.rows, &Row::hard);
  CHECK(contains(test_text(m, "ray-sphere"), "**Choose the exact call.** It costs no more than quadratic."));
}

TEST_CASE("an exact method that is faster and says as much is chosen", "[report_text]") {
  Measured m = {report("portable", 29)};
  Row batch = with_error(row("batch", 2, "ordinary", 0), 0.2, 0.5, 0.5);
  batch.exact = true;
  m.portable.rows.push_back(batch);
  CHECK(contains(test_text(m, "ray-sphere"),
                 "**Choose batch.** It costs no more than quadratic and is as exact as the exact call."));

  m.portable.rows.back().ns = 27;  // within the noise
  CHECK(contains(test_text(m, "ray-sphere"), "**Choose the exact call,** unless"));

  m.portable.rows.back() = row("yes or no", 2, "ordinary", 0);
  m.portable.rows.back().exact = true;
  CHECK(contains(test_text(m, "ray-sphere"), "**Choose the exact call,** unless"));
}

TEST_CASE("the text says of each hard family what it is made of", "[report_text]") {
  CHECK(contains(publication({report("portable", 29)}).text,
                 "## The hard families\n\nRay-sphere:\n\n- planet: an eye above a planet.\n\n"));
}

TEST_CASE("reports are sorted by their build", "[report_text]") {
  const Measured m = measured_of({report("peers", 1), report("portable", 2)});
  CHECK(m.portable.machine.build == "portable");
  CHECK(m.peers.has_value());
  CHECK_FALSE(m.native.has_value());
  CHECK_THROWS_AS(measured_of({report("native", 1)}), std::runtime_error);
  CHECK_THROWS_AS(measured_of({report("portable", 1), report("portable", 1)}), std::runtime_error);
  CHECK_THROWS_AS(measured_of({report("portable", 1), report("peers", 1), report("peers", 1)}), std::runtime_error);
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
