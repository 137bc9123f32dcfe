// isect bench: speed against error, measured here and now.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "app/figures/ownership.h"
#include "app/performance.h"
#include "app/program.h"
#include "app/shell/options.h"
#include "app/shell/subprocess.h"
#include "app/shell/terminal.h"
#include "bench/compare_reports.h"
#include "bench/machine.h"
#include "bench/maps.h"
#include "bench/plots.h"
#include "bench/report_text.h"
#include "bench/suite_names.h"
#include "viz/formats/files.h"
#include "viz/formats/writable.h"
#include "viz/lesson.h"

namespace isect::program {
namespace {

struct Wanted {
  std::vector<std::string> tests;
  std::string csv, json, plot, publish;
  std::vector<std::string> from, compared;
  unsigned long long seed = 1;
  bool quick = false, peers = false, native = false;
};

/// The name of the measurements that start this program, besides the suites.
constexpr const char* starting = "starting";

std::vector<std::string> names() {
  std::vector<std::string> all = bench::suite_names();
  all.emplace_back(starting);
  return all;
}

/// Returns the suites to measure, in the order of the report.
std::vector<std::string> suites(const Wanted& wanted) {
  std::vector<std::string> all = bench::suite_names();
  if (!wanted.tests.empty())
    std::erase_if(all, [&](const std::string& s) { return std::ranges::find(wanted.tests, s) == wanted.tests.end(); });
  return all;
}

/// Returns the path of a suite's program: those of one build, one per suite, lie in a folder beside this program.
std::string program_of(const std::string& build, const std::string& suite) { return beside(build + '/' + suite); }

std::vector<std::string> not_built(const std::string& build, std::vector<std::string> suites) {
  std::erase_if(suites, [&](const std::string& s) { return std::filesystem::exists(program_of(build, s)); });
  return suites;
}

/// Builds the measurements, which `./run` omits, as they take longer to compile than the rest. Only in a folder where
/// CMake has built this program.
void build_measurements(const std::vector<std::string>& missing, Progress& progress) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(this_program()).parent_path().parent_path();
  if (missing.empty() || !fs::exists(folder / "CMakeCache.txt")) return;
  say(fmt::format("building what measures {}, once: up to a minute each", fmt::join(missing, ", ")));
  std::vector<std::string> command = {"cmake", "--build", folder.string(), "--target"};
  for (std::string suite : missing) {
    std::ranges::replace(suite, '-', '_');
    command.push_back("measure_" + suite);
  }
  std::string last;
  const CompletedProcess process =
      run_subprocess(command, [&](const std::string& line) { progress.done(last = line); });
  if (process.status != 0)
    throw std::runtime_error(fmt::format("the measurements were not built ({}): {}", process.status, last));
}

void require_built(const std::string& build, const std::vector<std::string>& suites) {
  const std::vector<std::string> missing = not_built(build, suites);
  if (missing.empty()) return;
  const bool peers = build == "measure_peers", native = build == "measure_native";
  throw viz::BadInput(
      fmt::format("{}: {} was not built for {}. {}",
                  peers    ? "--peers"
                  : native ? "--native"
                           : "bench",
                  build, fmt::join(missing, ", "),
                  peers ? "It needs other libraries (libcgal-dev libbullet-dev libfcl-dev libembree-dev "
                          "libgeos++-dev libqhull-dev): cmake --preset release -DISECT_PEERS=ON && cmake --build "
                          "--preset release --target measure_peers"
                        : "Build it: cmake --build --preset release --target " + build));
}

bench::Report measured_by(const std::string& build, const std::string& suite, const Wanted& wanted,
                          Progress& progress) {
  std::vector<std::string> command = {program_of(build, suite), "--seed", std::to_string(wanted.seed)};
  if (wanted.quick) command.emplace_back("--quick");
  std::string last;
  const CompletedProcess process =
      run_subprocess(command, [&](const std::string& line) { progress.done(last = line); });
  if (process.status != 0)
    throw std::runtime_error(fmt::format("{}/{} failed ({}): {}", build, suite, process.status, last));
  return bench::report_of(process.output);
}

/// Measures a suite. A thorough run with more noise than a report may have is repeated, up to five times, and the
/// quietest counts: a moment's disturbance would spoil one suite of two dozen.
bench::Report measured_quietly(const std::string& build, const std::string& suite, const Wanted& wanted,
                               Progress& progress) {
  bench::Report best = measured_by(build, suite, wanted, progress);
  for (int again = 0; again < 5 && !wanted.quick && best.machine.noise > bench::most_noise; ++again) {
    bench::Report next = measured_by(build, suite, wanted, progress);
    if (next.machine.noise < best.machine.noise) best = std::move(next);
  }
  return best;
}

/// Returns a report by the programs of one build.
bench::Report measured_by(const std::string& build, const Wanted& wanted, Progress& progress) {
  const std::vector<std::string> all = suites(wanted);
  if (build == "measure") build_measurements(not_built(build, all), progress);
  require_built(build, all);
  if (all.empty()) return {bench::this_machine(ISECT_FLAGS, "portable"), wanted.seed, wanted.quick};
  bench::Report report = measured_quietly(build, all[0], wanted, progress);
  for (std::size_t i = 1; i < all.size(); ++i) report.add(measured_quietly(build, all[i], wanted, progress));
  return report;
}

bench::Report read_from(const std::string& path) {
  const std::string text = viz::read_file(path);
  try {
    return bench::report_of(text);
  } catch (const std::exception& e) {
    std::string why = e.what();  // "not a report of measurements: [json.exception...] key 'machine' not found"
    if (const std::size_t at = why.find("[json."); at != why.npos) why.erase(at, why.find("] ", at) + 2 - at);
    throw viz::BadInput(fmt::format("{}: {}", path, why));
  }
}

bench::Report measured(const Program& program, const Wanted& wanted) {
  if (!wanted.from.empty()) return read_from(wanted.from.front());
  Progress progress(0);
  if (wanted.peers) return measured_by("measure_peers", wanted, progress);
  if (wanted.native) return measured_by("measure_native", wanted, progress);
  const auto told = [&](const std::string& next) { progress.done(next); };
  std::vector<bench::Duty> starts;  // measured first, while this program is small
  if (wanted.tests.empty() || std::ranges::find(wanted.tests, starting) != wanted.tests.end())
    starts = performance(program, wanted.quick, told);
  bench::Report report = measured_by("measure", wanted, progress);
  report.duties = std::move(starts);
  return report;
}

std::string heading(const bench::Report& r) {
  return fmt::format(
      "{}, {} cores, load {:.2f}\n{}, {} ({} build)\nseed {}, {}{}\nnoise: the medians of a fixed loop differ by "
      "{:.1f} %\n",
      r.machine.cpu, r.machine.cores, r.machine.load, r.machine.compiler, r.machine.flags, r.machine.build, r.seed,
      r.machine.date, r.quick ? ", quick: few cases are judged" : "", 100 * r.machine.noise);
}

/// Draws every chart for which the report has data, as SVG for print and as PNG.
void draw(const bench::Report& report, const std::string& folder) {
  std::vector<bench::Plotted> plots = bench::plots(report);
  for (bench::Plotted& map : bench::maps()) plots.push_back(std::move(map));
  for (const bench::Plotted& plot : plots)
    for (const char* ending : {".svg", ".png"})
      if (const std::string file = folder + '/' + plot.name + ending;
          !may_be_replaced(file, [&](const std::string&) { return metadata_in(file).contains("figure"); }))
        throw viz::FileError(fmt::format(
            "cannot write '{}': the file there is no chart of isect's; move it away, or give another folder", file));
  Progress progress(plots.size());
  for (const bench::Plotted& plot : plots) {
    progress.done(plot.name);
    const std::string path = folder + '/' + plot.name;
    viz::write_file(path + ".svg", bench::svg_of(plot, viz::ThemeName::print));
    viz::write_file(path + ".png", bench::png_of(plot, viz::ThemeName::print));
    viz::write_file(path + ".txt", plot.alt + '\n');
  }
}

/// Checks, before a long run, what would make its report unfit to publish.
void require_publishable(const Wanted& wanted, const std::vector<std::string>& builds) {
  bench::Machine machine = bench::this_machine(ISECT_FLAGS, "portable");
  for (int again = 0; again < 5 && machine.noise > bench::most_noise; ++again) machine.noise = bench::noise();
  bench::require_quiet(machine);
  std::vector<bench::Machine> machines;
  for (const std::string& build : builds) {
    bench::Report all;
    for (const std::string& suite : suites(wanted)) {
      const CompletedProcess process =
          run_subprocess({program_of(build, suite), "--commit"}, [](const std::string&) {});
      bench::Report one;
      one.machine.commit = process.output.substr(0, process.output.find('\n'));
      all.add(one);
    }
    all.machine.build = build == "measure" ? "portable" : build.substr(build.find('_') + 1);
    machines.push_back(all.machine);
  }
  bench::require_one_commit(machines);
}

/// Keeps measurements that can't be published, beside what is there: a run takes ten minutes and more. Returns their
/// files.
std::vector<std::string> keep(const std::vector<bench::Report>& reports, const std::string& folder) {
  std::vector<std::string> files;
  for (const bench::Report& r : reports) {
    const std::string start = folder + "/measured-" + r.machine.build;
    std::string file = start + ".json";
    for (int n = 2; viz::is_there(file); ++n) file = fmt::format("{}-{}.json", start, n);
    viz::write_file(file, bench::json(r));
    files.push_back(file);
  }
  return files;
}

/// Publishes the report as text and figures: from the given files, or measured here by every program that was built.
int publish(const Program& program, const Wanted& wanted) {
  if (wanted.quick)
    throw viz::BadInput(
        "--publish: a quick run judges too few cases to be published; leave out --quick, or keep it by --json");
  std::vector<bench::Report> reports;
  for (const std::string& path : wanted.from) reports.push_back(read_from(path));
  if (wanted.from.empty()) {
    std::vector<std::string> builds = {"measure"};
    for (const char* other : {"measure_native", "measure_peers"})
      if (std::filesystem::exists(beside(other))) builds.emplace_back(other);
    Progress progress(0);
    build_measurements(not_built("measure", suites(wanted)), progress);
    for (const std::string& build : builds) require_built(build, suites(wanted));
    require_publishable(wanted, builds);
    for (const std::string& build : builds) {
      Wanted one = wanted;
      one.native = build == "measure_native", one.peers = build == "measure_peers";
      reports.push_back(measured(program, one));
    }
  }
  try {
    bench::publish(bench::measured_of(reports), wanted.publish);
  } catch (const viz::FileError&) {
    throw;
  } catch (const std::runtime_error& e) {
    if (!wanted.from.empty()) throw viz::BadInput(fmt::format("--publish: {}", e.what()));
    throw std::runtime_error(fmt::format("{}. What was measured is kept, for --publish {} --from FILE...: {}", e.what(),
                                         wanted.publish, fmt::join(keep(reports, wanted.publish), ", ")));
  }
  return done;
}

/// Compares two reports; returns 1 if something became slower or wrong, or is gone.
int compare(const std::vector<std::string>& paths) {
  const bench::Report before = read_from(paths.at(0)), after = read_from(paths.at(1));
  try {
    const bench::Comparison comparison = bench::compare(before, after);
    print(bench::told(comparison));
    return comparison.holds() ? done : check_failed;
  } catch (const std::runtime_error& e) {
    throw viz::BadInput(fmt::format("compare: {}", e.what()));
  }
}

/// Refuses to write rows and reports over anything but earlier ones. Tries before the work whether they can be written.
void require_own_place(const std::string& option, const std::string& file, const std::string& begin) {
  if (file.empty() || file == "-") return;
  const auto ours = [&](const std::string& bytes) { return bytes.starts_with(begin); };
  if (!may_be_replaced(file, ours))
    throw viz::FileError(fmt::format(
        "cannot write '{}': the file there was not written by {}; move it away, or give another name", file, option));
  viz::need_writable(file);
}

int bench(const Program& program, const Wanted& wanted) {
  if (!wanted.compared.empty()) return compare(wanted.compared);
  for (const std::string& test : wanted.tests)
    if (const auto all = names(); std::ranges::find(all, test) == all.end()) throw viz::unknown("TEST", test, all);
  if (!wanted.publish.empty()) return publish(program, wanted);
  if (wanted.from.size() > 1) throw viz::BadInput("--from: several files make sense with --publish only");
  if (!wanted.csv.empty() && wanted.csv == wanted.json)
    throw viz::BadInput("--csv: the same place as that of --json; give each its own");
  require_own_place("--csv", wanted.csv, bench::csv({}));
  require_own_place("--json", wanted.json, bench::json({}).substr(0, 12));
  const bench::Report report = measured(program, wanted);
  if (!wanted.csv.empty() && wanted.csv != "-") viz::write_file(wanted.csv, bench::csv(report));
  if (!wanted.json.empty() && wanted.json != "-") viz::write_file(wanted.json, bench::json(report));
  if (!wanted.plot.empty()) draw(report, wanted.plot);
  if (wanted.csv == "-")
    print(bench::csv(report));
  else if (wanted.json == "-")
    print(bench::json(report));
  else
    print(heading(report) + bench::table(report));
  return done;
}

}  // namespace

void add_bench(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("bench", "speed against error: every method of every test, measured and judged");
  const auto wanted = std::make_shared<Wanted>();
  sub.add_option("TEST", wanted->tests, "only these; all if none is given");
  sub.add_option("--csv", wanted->csv, "write the rows as CSV; - for standard output");
  CLI::Option* json = sub.add_option("--json", wanted->json, "write everything as JSON; - for standard output");
  sub.add_option("--plot", wanted->plot, "draw every chart into this folder, as SVG and PNG")->type_name("DIR");
  CLI::Option* from = sub.add_option("--from", wanted->from, "read a file that --json wrote instead of measuring");
  CLI::Option* publish = sub.add_option("--publish", wanted->publish,
                                        "write REPORT.md with its figures and results.json into this folder: from "
                                        "--from's files, or from new runs of all builds that are there");
  CLI::Option* compared = sub.add_option("--compare", wanted->compared,
                                         "two files that --json wrote: what became slower, faster or wrong; exit\n"
                                         "status 1 if something is worse");
  compared->expected(2)->type_name("BEFORE AFTER")->check(not_empty());
  CLI::Option* seed = sub.add_option("--seed", wanted->seed, "of the random cases");
  seed->check([](const std::string& text) {  // CLI11 would take -1 for 2^64 - 1
    unsigned long long n = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole ? "" : fmt::format("\"{}\" is no whole number from 0 to 2^64 - 1; write --seed N", text);
  });
  CLI::Option* quick = sub.add_flag("--quick", wanted->quick, "within a minute: few passes, few cases judged");
  CLI::Option* peers = sub.add_flag("--peers", wanted->peers, "beside CGAL, Boost, Bullet, FCL, Embree, GEOS, Eigen");
  CLI::Option* native = sub.add_flag("--native", wanted->native, "compiled for this machine's instructions");
  peers->excludes(native);
  for (CLI::Option* measuring : {seed, quick, peers, native}) from->excludes(measuring), compared->excludes(measuring);
  for (CLI::Option* other :
       {from, publish, json, sub.get_option("--csv"), sub.get_option("--plot"), sub.get_option("TEST")})
    compared->excludes(other);
  for (CLI::Option* one : {peers, native, json, sub.get_option("--csv"), sub.get_option("--plot")})
    publish->excludes(one);
  for (CLI::Option* path : {sub.get_option("--csv"), json, sub.get_option("--plot"), from, publish})
    path->check(not_empty());
  publish->type_name("DIR"), json->type_name("FILE"), from->type_name("FILE"), seed->type_name("N");
  sub.get_option("--csv")->type_name("FILE");
  std::string list;
  for (const std::string& name : names()) list += " " + name;
  sub.footer("Tests:" + list +
             "\nTimes mean something on an idle machine only; the verdicts and errors are the same everywhere.\n"
             "Example: isect bench ray-sphere --quick --csv rows.csv");
  sub.callback([&program, wanted] { program.chosen = [&program, wanted] { return bench(program, *wanted); }; });
}

}  // namespace isect::program
