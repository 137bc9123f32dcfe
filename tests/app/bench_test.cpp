// `isect bench` as a user runs it: what it writes reads back, and what it can't do it says. Times are never asserted.

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "bench/report.h"
#include "tests/app/shell.h"
#include "tests/catch.h"

namespace bench_test {
using namespace isect::test;
using isect::bench::Report;
using isect::bench::Row;

namespace {

/// Copies `isect` into a folder of its own, so that nothing stands beside it.
void copy_program(const Shell& shell) { std::filesystem::copy_file(ISECT_BIN "/isect", shell.work() / "alone"); }

int lines(const std::string& text) { return static_cast<int>(std::count(text.begin(), text.end(), '\n')); }

}  // namespace

TEST_CASE("two reports are compared, and what is worse gives the status", "[bench]") {
  const Shell shell;
  const std::string results = ISECT_RESULTS;
  const Ran same = shell("isect bench --compare " + results + " " + results);
  CHECK(same.status == 0);
  CHECK_THAT(same.out, Contains("calls take as long as before, within their noise"));
  auto worse = nlohmann::json::parse(contents(results));
  for (auto& row : worse["rows"])
    if (row["method"] == "exact" && row["test"] == "sphere-sphere") row["ns"] = 3 * row["ns"].get<double>();
  write(shell.work() / "worse.json", worse.dump());
  const Ran slower = shell("isect bench --compare " + results + " worse.json");
  CHECK(slower.status == 1);
  CHECK_THAT(slower.out, Contains("slower:\n   3.00 times") && Contains("sphere-sphere exact, double, ordinary"));
  CHECK(shell("isect bench --compare " + results).status == 2);
  CHECK(shell("isect bench --compare absent.json " + results).status == 4);
}

TEST_CASE("one test is measured and judged, and its files read back", "[bench]") {
  const Shell shell;
  const Ran ran = shell("isect bench orient2d --quick --csv rows.csv --json all.json");
  INFO(ran.err);
  CHECK(ran.status == 0);
  CHECK_THAT(ran.out, Contains("orient2d, double, ordinary") && Contains("portable build") && Contains("seed 1"));

  const Report report = isect::bench::report_of(contents(shell.work() / "all.json"));
  CHECK((report.quick && report.seed == 1 && report.machine.build == "portable"));
  REQUIRE_FALSE(report.rows.empty());
  int exact = 0, naive_and_wrong = 0;
  for (const Row& r : report.rows) {
    INFO(r.method << ", " << r.scalar << ", " << r.family << ": " << r.first_wrong);
    CHECK(r.test == "orient2d");
    CHECK((r.judged > 0 && r.judged <= r.cases));
    CHECK(r.first_wrong.empty() == (r.wrong() == 0));
    if (r.exact) CHECK((r.wrong() == 0 && ++exact));
    naive_and_wrong += !r.exact && r.hard && r.wrong() > 0;
  }
  CHECK(exact > 0);
  CHECK(naive_and_wrong > 0);
  CHECK(contents(shell.work() / "rows.csv") == isect::bench::csv(report));

  const Ran again = shell("isect bench --from all.json");
  CHECK(again.status == 0);
  CHECK(lines(again.out) == lines(ran.out));
  CHECK_THAT(again.out, Contains("quick: few cases are judged"));
  const Ran csv = shell("isect bench --from all.json --csv -");
  CHECK(csv.out == contents(shell.work() / "rows.csv"));
  CHECK(shell("isect bench --from all.json --json -").out == contents(shell.work() / "all.json"));
}

TEST_CASE("a thorough run that met noise is made again, a quick one is not", "[bench]") {
  const Shell shell;
  namespace fs = std::filesystem;
  fs::create_directories(shell.work() / "bin");
  fs::copy_file(ISECT_BIN "/isect", shell.work() / "bin/isect");
  isect::bench::Report report;
  for (const double noise : {0.5, 0.01}) {
    report.machine.noise = noise;
    write(shell.work() / (noise > 0.1 ? "noisy" : "quiet"), isect::bench::json(report));
  }
  write(shell.work() / "bin/measure/ray-plane",
        "#!/bin/sh\necho >> runs\ncase $(wc -l < runs) in 3) cat quiet ;; *) cat noisy ;; esac\n");
  fs::permissions(shell.work() / "bin/measure/ray-plane", fs::perms::owner_exec, fs::perm_options::add);
  const auto noise_of = [&](const std::string& options) {
    CHECK(shell("rm -f runs; bin/isect bench ray-plane --json out.json" + options).status == 0);
    return isect::bench::report_of(contents(shell.work() / "out.json")).machine.noise;
  };
  CHECK(noise_of("") == 0.01);
  CHECK(lines(contents(shell.work() / "runs")) == 3);
  CHECK(noise_of(" --quick") == 0.5);
  CHECK(lines(contents(shell.work() / "runs")) == 1);
}

TEST_CASE("what measures is built when it is first asked for, by the cmake in PATH", "[bench]") {
  const Shell shell;
  namespace fs = std::filesystem;
  fs::create_directories(shell.work() / "build/bin");
  fs::copy_file(ISECT_BIN "/isect", shell.work() / "build/bin/isect");
  write(shell.work() / "build/CMakeCache.txt", "");
  const auto cmake = [&](const std::string& does) {
    write(shell.work() / "tools/cmake", "#!/bin/sh\necho \"$@\" > asked\n" + does + "\n");
    fs::permissions(shell.work() / "tools/cmake", fs::perms::owner_exec, fs::perm_options::add);
    return shell("PATH=\"$PWD/tools:$PATH\" build/bin/isect bench ray-plane --quick");
  };
  const Ran failed = cmake("echo no compiler >&2; exit 3");
  CHECK(failed.status == 1);
  CHECK_THAT(failed.err, Contains("building what measures ray-plane") && Contains("not built (3): no compiler"));
  CHECK_THAT(contents(shell.work() / "asked"), Contains("--build") && Contains("--target measure_ray_plane"));

  const Ran built = cmake(
      "mkdir -p build/bin/measure; printf '#!/bin/sh\\nexit 5\\n' > build/bin/measure/ray-plane; chmod +x "
      "build/bin/measure/ray-plane");
  CHECK_THAT(built.err, Contains("measure/ray-plane failed (5)"));
}

TEST_CASE("a seed that is none is refused by name", "[bench]") {
  const Shell shell;
  for (const std::string seed : {"abc", "-1", "1.5", "1 ", "18446744073709551616"}) {
    const Ran ran = shell("timeout 60 isect bench orient2d --quick --seed '" + seed + "'");
    CHECK(ran.status == 2);
    CHECK_THAT(ran.err, Contains("--seed: \"" + seed + "\" is no whole number"));
  }
}

TEST_CASE("an excerpt of a report can be published, beside what is one's own", "[bench]") {
  const Shell shell;
  write(shell.work() / "public/report/mine.svg", "<svg/>");
  Report excerpt = isect::bench::report_of(contents(ISECT_RESULTS));
  excerpt.machine.noise = 0;  // as on a machine that was idle
  write(shell.work() / "excerpt.json", isect::bench::json(excerpt));
  for (int times = 0; times < 2; ++times) {  // the second time from what the first one left
    const std::string from = times == 0 ? "excerpt.json" : "public/results.json";
    const Ran ran = shell("isect bench --publish public --from " + from);
    INFO(ran.err);
    REQUIRE(ran.status == 0);
    CHECK_THAT(contents(shell.work() / "public/REPORT.md"), Contains("# Speed against error"));
    CHECK(contents(shell.work() / "public/report/mine.svg") == "<svg/>");
  }
}

TEST_CASE("what is no report of measurements is told in words, and two results need two places", "[bench]") {
  const Shell shell;
  write(shell.work() / "other.json", "{}");
  const Ran other = shell("isect bench --from other.json");
  CHECK(other.status == 2);
  CHECK_THAT(other.err, Contains("other.json: not a report of measurements: key 'machine' not found"));
  const Ran both = shell("isect bench --from other.json --csv - --json -");
  CHECK(both.status == 2);
  CHECK_THAT(both.err, Contains("--csv: the same place as that of --json"));
}

TEST_CASE("rows and reports are written over earlier ones and over nothing else", "[bench]") {
  const Shell shell;
  const auto run = [&](const std::string& option, const std::string& file) {
    return shell(std::string("isect bench --from ") + ISECT_RESULTS + " " + option + " " + file);
  };
  for (const std::string option : {"--csv", "--json"}) {
    write(shell.work() / "thesis.tex", "\\section{Results}\n");
    const Ran refused = run(option, "thesis.tex");
    CHECK(refused.status == 4);
    CHECK_THAT(refused.err, Contains("cannot write 'thesis.tex': the file there was not written by " + option));
    CHECK(contents(shell.work() / "thesis.tex") == "\\section{Results}\n");
    for (int times = 0; times < 2; ++times) CHECK(run(option, "own" + option).status == 0);
  }
  CHECK(run("--csv", "own--json").status == 4);

  write(shell.work() / "charts/map-orientation.svg", "<svg/>");
  const Ran refused = run("--plot", "charts");
  CHECK(refused.status == 4);
  CHECK_THAT(refused.err, Contains("map-orientation.svg': the file there is no chart of isect's"));
  CHECK(contents(shell.work() / "charts/map-orientation.svg") == "<svg/>");
}

TEST_CASE("the same seed gives the same verdicts, another seed other cases", "[bench]") {
  const Shell shell;
  const auto verdicts = [&](const std::string& seed) {
    const Ran ran = shell("isect bench orient2d --quick --json - --seed " + seed);
    std::string text;
    for (const Row& r : isect::bench::report_of(ran.out).rows)
      text += r.method + std::to_string(r.false_yes) + " " + std::to_string(r.false_no) + r.first_wrong + "\n";
    return text;
  };
  const std::string one = verdicts("1");
  CHECK(one == verdicts("1"));
  CHECK(one != verdicts("2"));
}

TEST_CASE("the program tells how long it takes to start and to draw", "[bench]") {
  const Shell shell;
  const Ran ran = shell("isect bench starting --quick --json -");
  INFO(ran.err);
  CHECK(ran.status == 0);
  const Report report = isect::bench::report_of(ran.out);
  CHECK(report.rows.empty());
  const auto duty = [&](const std::string& what) {
    const auto found = std::ranges::find(report.duties, what, &isect::bench::Duty::what);
    REQUIRE(found != report.duties.end());
    CHECK(found->value > 0);
    return *found;
  };
  CHECK(duty("isect --help").unit == "ms");
  CHECK(duty("isect --help").target == 30.0);
  CHECK(duty("isect render, one figure, png").target == 400.0);
  CHECK(duty("isect render, one figure, svg").unit == "ms");
  CHECK(duty("isect --help, processor time").unit == "ms");
  CHECK(duty("isect --help, memory").unit == "MB");
  CHECK(duty("window in software, another step each frame").unit == "frames/s");
}

TEST_CASE("a wrong name or value is refused with what is allowed", "[bench]") {
  const Shell shell;
  const auto refuses = [&](const std::string& arguments, const std::string& with) {
    const Ran ran = shell("isect bench " + arguments);
    INFO(arguments);
    CHECK(ran.status == 2);
    CHECK(ran.out.empty());
    CHECK_THAT(ran.err, Contains(with));
    CHECK(lines(ran.err) == 1);
  };
  refuses("ray-spheer", "did you mean \"ray-sphere\"?");
  refuses("--seed many", "many");
  refuses("--peers --native", "--native");
  refuses("--quick --from all.json", "--from");
  write(shell.work() / "rubbish.json", "{\"rows\": 3}");
  refuses("--from rubbish.json", "rubbish.json: not a report of measurements: ");
}

TEST_CASE("files that can't be read or written are trouble with files", "[bench]") {
  const Shell shell;
  Ran ran = shell("isect bench --from missing.json");
  CHECK(ran.status == 4);
  CHECK_THAT(ran.err, Contains("missing.json"));
  ran = shell("mkdir folder; isect bench orient2d --quick --csv folder");
  CHECK(ran.status == 4);
  CHECK_THAT(ran.err, Contains("folder"));
}

TEST_CASE("what was not built is said, with the command that builds it", "[bench]") {
  const Shell shell;
  copy_program(shell);
  Ran ran = shell("./alone bench --peers orient2d");
  CHECK(ran.status == 2);
  CHECK_THAT(ran.err, Contains("measure_peers was not built") && Contains("-DISECT_PEERS=ON"));
  ran = shell("./alone bench --native orient2d");
  CHECK(ran.status == 2);
  CHECK_THAT(ran.err, Contains("measure_native was not built") && Contains("--target measure_native"));
  ran = shell("./alone bench orient2d ray-aabb");
  CHECK(ran.status == 2);
  CHECK_THAT(ran.err, Contains("measure was not built for ray-aabb, orient2d.") && Contains("--target measure"));
}

TEST_CASE("a program beside it that fails is reported, not believed", "[bench]") {
  const Shell shell;
  copy_program(shell);
  write(shell.work() / "measure_native/orient2d", "#!/bin/sh\necho 'no such instruction' >&2\nexit 3\n");
  Ran ran = shell("chmod +x measure_native/orient2d; ./alone bench --native orient2d");
  CHECK(ran.status == 1);
  CHECK_THAT(ran.err, Contains("measure_native/orient2d failed (3): no such instruction"));

  write(shell.work() / "measure_native/orient2d", "#!/bin/sh\necho rubbish\n");
  ran = shell("./alone bench --native orient2d");
  CHECK(ran.status == 1);
  CHECK_THAT(ran.err, Contains("not a report of measurements"));
}

TEST_CASE("the suites asked for are measured one after the other, as one report", "[bench]") {
  const Shell shell;
  copy_program(shell);
  Report one;
  one.machine.build = "portable", one.machine.noise = 0.02;
  one.rows.resize(1);
  for (const char* suite : {"orient2d", "ray-aabb"}) {
    one.rows[0].test = suite, one.machine.noise += 0.02;
    write(shell.work() / "measure" / suite, "#!/bin/sh\ncat <<'END'\n" + isect::bench::json(one) + "END\n");
  }
  const Ran ran = shell("chmod +x measure/*; ./alone bench orient2d ray-aabb --json -");
  INFO(ran.err);
  REQUIRE(ran.status == 0);
  const Report both = isect::bench::report_of(ran.out);
  REQUIRE(both.rows.size() == 2);
  CHECK((both.rows[0].test == "ray-aabb" && both.rows[1].test == "orient2d"));  // in the order of the report
  CHECK(both.machine.noise == 0.06);
}

TEST_CASE("a run on a noisy machine is not published", "[bench]") {
  const Shell shell;
  Report noisy;
  noisy.machine.build = "portable", noisy.machine.noise = 0.5;
  write(shell.work() / "noisy.json", isect::bench::json(noisy));
  const Ran ran = shell("isect bench --publish out --from noisy.json");
  CHECK(ran.status == 2);
  CHECK_THAT(ran.err, Contains("--publish: the portable build was measured at 50 % noise; at most 10 %"));
  CHECK_FALSE(std::filesystem::exists(shell.work() / "out"));
}

TEST_CASE("a quick run is not published, nor are changed sources", "[bench]") {
  const Shell shell;
  const Ran now = shell("isect bench --quick --publish out");
  CHECK(now.status == 2);
  CHECK_THAT(now.err, Contains("--publish: a quick run judges too few cases to be published"));
  Report report;
  report.machine.build = "portable", report.quick = true;
  write(shell.work() / "quick.json", isect::bench::json(report));
  const Ran quick = shell("isect bench --publish out --from quick.json");
  CHECK(quick.status == 2);
  CHECK_THAT(quick.err, Contains("--publish: the run of the portable build was quick"));
  report.quick = false, report.machine.commit = "0123abc-dirty";
  write(shell.work() / "dirty.json", isect::bench::json(report));
  const Ran dirty = shell("isect bench --publish out --from dirty.json");
  CHECK(dirty.status == 2);
  CHECK_THAT(dirty.err, Contains("--publish: the portable build has changes that no commit has (0123abc-dirty)"));
  CHECK_FALSE(std::filesystem::exists(shell.work() / "out"));
}

TEST_CASE("what is to be published is asked for its commit before it is measured", "[bench]") {
  const Shell shell;
  copy_program(shell);
  const auto program = [&](const std::string& build, const std::string& commit) {
    write(shell.work() / build / "orient2d",
          "#!/bin/sh\ntest \"$1\" = --commit && echo " + commit + " || echo measured >> ran\n");
  };
  program("measure", "0123abc"), program("measure_native", "4567def");
  const Ran ran = shell("chmod +x measure*/*; ./alone bench orient2d --publish out");
  CHECK(ran.status != 0);
  if (ran.err.find("% noise") == std::string::npos)
    CHECK_THAT(ran.err, Contains("different commits, portable from 0123abc and native from 4567def"));
  CHECK_FALSE(std::filesystem::exists(shell.work() / "ran"));
}

TEST_CASE("what was measured and can't be published is kept, and nothing is written over", "[bench]") {
  const Shell shell;
  copy_program(shell);
  Report noisy;
  noisy.machine.build = "portable", noisy.machine.noise = 0.5;
  noisy.rows.resize(1), noisy.rows[0].test = "orient2d";
  write(shell.work() / "measure/orient2d",
        "#!/bin/sh\ntest \"$1\" = --commit && exit\ncat <<'END'\n" + isect::bench::json(noisy) + "END\n");
  write(shell.work() / "out/measured-portable.json", "mine\n");
  const Ran ran = shell("chmod +x measure/*; ./alone bench orient2d --publish out");
  CHECK(ran.status == 1);
  if (ran.err.find("kept") == std::string::npos) {  // this machine itself is too noisy to begin
    CHECK_THAT(ran.err, Contains("% noise"));
    return;
  }
  CHECK_THAT(ran.err, Contains("the portable build was measured at 50 % noise") &&
                          Contains("--publish out --from FILE...: out/measured-portable-2.json"));
  CHECK(isect::bench::report_of(contents(shell.work() / "out/measured-portable-2.json")).rows.size() == 1);
  CHECK(contents(shell.work() / "out/measured-portable.json") == "mine\n");
}

TEST_CASE("the help lists every test", "[bench]") {
  const Shell shell;
  const Ran ran = shell("isect bench --help");
  CHECK(ran.status == 0);
  const std::size_t at = ran.out.find("Tests: ");
  REQUIRE(at != std::string::npos);
  const std::string list = ran.out.substr(at, ran.out.find('\n', at) - at);
  for (const char* test : {" ray-sphere", " orient2d", " point-polygon", " all-pairs", " starting"})
    CHECK_THAT(list, Contains(test));
}

}  // namespace bench_test
