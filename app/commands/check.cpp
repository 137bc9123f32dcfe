// isect check: do the lessons still say and show what was accepted?

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "app/checks/baselines.h"
#include "app/checks/check_report.h"
#include "app/figures/ownership.h"
#include "app/preset_folder.h"
#include "app/shell/environment.h"
#include "app/shell/terminal.h"
#include "viz/formats/writable.h"

namespace isect::program {

namespace {

namespace fs = std::filesystem;

struct CheckOptions {
  Selection asked;
  std::string snapshots, dir, report, junit, update, backend;
  bool json = false;
};

const char* const default_snapshots = "snapshots";

/// Returns the program as a shell would find it again: "isect", "./run", "build/release/bin/isect".
std::string called() {
  const char* const by_run = std::getenv("ISECT_CALLED");  // set by ./run, which is the shorter way
  return by_run ? by_run : program_invocation_name;
}

/// Tells how to move the baselines of users' own presets, which lay directly in their folder before they had one of
/// their own.
bool say_old_layout(const Program& program, const std::string& dir) {
  std::string moves;
  for (const viz::Lesson* lesson : program.lessons) {
    const std::optional<fs::path> trace = trace_below(fs::path(dir) / lesson->id);
    if (!trace) continue;
    const std::string to = (fs::path(dir) / "snapshots" / lesson->id).string();
    moves +=
        fmt::format("\n  mkdir -p {0} && mv {1}/* {0}/", quoted(to), quoted((fs::path(dir) / lesson->id).string()));
  }
  if (moves.empty()) return false;
  say(fmt::format("{}: baselines lie beside the presets of {}; they have a folder of their own now. To move them:{}",
                  program.name, dir, moves));
  return true;
}

/// Returns the name that is meant: the file's own, with or without its ending.
std::string named_as(const std::string& asked, const std::vector<std::string>& names) {
  const std::string ending = ".json";
  for (const std::string& name :
       {asked, asked.ends_with(ending) ? asked.substr(0, asked.size() - ending.size()) : asked})
    if (std::ranges::find(names, name) != names.end()) return name;
  throw viz::unknown("preset", asked, names);
}

/// Stores in `asked` the presets of a folder that are asked for. Returns the broken ones as failures.
std::vector<Failure> choose_own(const Program& program, const std::string& dir, Selection& asked) {
  PresetFolder folder = preset_folder(dir, program);
  say_passed_over(folder);
  if (asked.preset != "all") {
    std::vector<std::string> names;
    for (const PresetFile& file : folder.presets) names.push_back(file.name);
    for (const BrokenPreset& broken : folder.broken) names.push_back(broken.file.name);
    const std::string name = named_as(asked.preset, names);
    std::erase_if(folder.presets, [&](const PresetFile& file) { return file.name != name; });
    std::erase_if(folder.broken, [&](const BrokenPreset& broken) { return broken.file.name != name; });
  }
  asked.files = folder.presets;
  std::vector<Failure> failures;
  for (const BrokenPreset& broken : folder.broken) {
    Failure f{Failure::Kind::preset, {}, broken.file.name};
    f.what = broken.what;
    f.baseline = broken.file.path;
    failures.push_back(std::move(f));
  }
  return failures;
}

std::vector<Excerpt> chosen_of(const Program& program, const CheckOptions& options, const Selection& asked) {
  if (!options.dir.empty() && asked.files.empty()) return {};  // all of them are broken
  std::vector<Excerpt> chosen = excerpts(program, asked);
  for (const Excerpt& e : chosen)
    if (is_own(e) && options.dir.empty())
      throw viz::BadInput("preset: only the lesson's own presets have baselines here; for files of yours give --dir");
  return chosen;
}

/// Whether there is no baseline: neither of these presets nor of one that may have had another name.
bool nothing_there(const std::string& folder, const std::vector<Excerpt>& chosen, const Baselines::Reach& reach) {
  if (reach.all_lessons && trace_below(folder)) return false;
  return std::ranges::none_of(chosen, [&](const Excerpt& e) {
    return viz::is_there(fs::path(folder) / folder_of(e)) ||
           (reach.all_presets && trace_below(fs::path(folder) / e.lesson->id));
  });
}

/// Reports everything as missing, without looking at single steps.
void all_is_missing(const std::vector<Excerpt>& chosen, Report& report) {
  for (const Excerpt& e : chosen) {
    Failure f{Failure::Kind::missing, e.lesson->id, e.folder};
    f.what = "nothing was accepted yet";
    f.baseline = (fs::path(report.folder) / folder_of(e)).string();
    report.failures.push_back(std::move(f));
  }
}

void compare(const std::vector<Excerpt>& chosen, const Baselines::Reach& reach, Baselines& baselines, Report& report) {
  const std::vector<Baselines::Move> moves = baselines.moves(chosen, reach);
  Progress progress(chosen.size());
  for (const Excerpt& e : chosen) {
    for (Failure& f : baselines.check(e)) report.failures.push_back(std::move(f));
    progress.done(e.lesson->id + " " + e.folder);
  }
  for (Failure& f : baselines.orphans(chosen, reach)) report.failures.push_back(std::move(f));
  baselines.join(moves, report.failures);
  report.left_alone = baselines.left_alone();
}

bool begins_report(const std::string& bytes) { return begins_html_report(bytes) || begins_junit_report(bytes); }

/// Refuses to write reports over anything but earlier ones, or over one another. Whether they can be written is tried
/// before the work.
void require_own_places(const CheckOptions& options) {
  if (!options.report.empty() && options.report == options.junit)
    throw viz::BadInput(fmt::format("junit: {} is the page of --report too; give each its own", options.junit));
  for (const std::string& file : {options.report, options.junit})
    if (own_trace(file) || metadata_in(file).contains("lesson"))
      throw viz::BadInput(fmt::format("report: {} is a baseline or a figure; give the report another name", file));
  for (const std::string& file : {options.report, options.junit}) {
    if (file.empty()) continue;
    if (!may_be_replaced(file, begins_report))
      throw viz::FileError(
          fmt::format("cannot write '{}': the file there is no report of isect's; move it away, or give the report "
                      "another name",
                      file));
    viz::need_writable(file);
  }
}

/// Prints the result, even if a report of it can't be written.
void tell(const Report& report, const CheckOptions& options) {
  const std::string result = options.json ? to_json(report) : to_text(report);
  try {
    if (!options.report.empty()) viz::write_file(options.report, to_html(report));
    if (!options.junit.empty()) viz::write_file(options.junit, to_junit(report));
  } catch (const viz::FileError&) {
    print(result);
    throw;
  }
  print(result);
}

int check(const Program& program, const CheckOptions& options) {
  require_own_places(options);
  for (const std::string& name : options.asked.lessons)
    if (std::error_code absent; options.dir.empty() && fs::is_regular_file(name, absent))
      throw viz::BadInput(
          fmt::format("lesson: \"{}\" is a file; {} check --dir FOLDER compares all of a folder with "
                      "what was accepted",
                      name, program.name));
  const Update update = update_named(options.update);
  const viz::Backend backend = viz::backend_named(options.backend.empty() ? "auto" : options.backend);
  const bool own = !options.dir.empty();  // presets of the user's own
  if (own && say_old_layout(program, options.dir)) return baseline_missing;

  Report report;
  report.asked = {called(),    options.asked.lessons, options.asked.preset == "all" ? "" : options.asked.preset,
                  options.dir, options.snapshots,     options.backend};
  report.folder = own                         ? (fs::path(options.dir) / "snapshots").string()
                  : options.snapshots.empty() ? default_snapshots
                                              : options.snapshots;
  Selection asked = options.asked;
  const bool all = asked.lessons.empty() && !program.only;
  asked.all = all && !own;
  asked.step = "all";
  if (own) report.failures = choose_own(program, options.dir, asked);
  Baselines::Reach reach{all && asked.preset == "all", asked.preset == "all"};
  for (const Failure& broken : report.failures) reach.spared.insert(broken.preset);

  const std::vector<Excerpt> chosen = chosen_of(program, options, asked);
  for (const Excerpt& e : chosen) {
    if (report.lessons.empty() || report.lessons.back() != e.lesson->id) {
      report.lessons.push_back(e.lesson->id);
      const bool listed = std::ranges::find(program.lessons, e.lesson) != program.lessons.end();  // a scene is not
      if (listed && !program.only) report.by_name.push_back(e.lesson->id);
    }
    report.checked.push_back({e.lesson->id, e.folder});
    for (int step = 0; step < static_cast<int>(e.walk.steps.size()); ++step) report.pictures += has_picture(e, step);
  }
  const bool pages = !options.report.empty() || !options.junit.empty() || options.json;
  report.nothing_there = update == Update::none && !chosen.empty() && nothing_there(report.folder, chosen, reach);
  if (report.nothing_there && !pages) {
    all_is_missing(chosen, report);
  } else if (!chosen.empty()) {
    need_environment(program);
    viz::Offscreen offscreen(backend);
    Baselines baselines(report.folder, update, !options.report.empty(), offscreen);
    compare(chosen, reach, baselines, report);
  }

  tell(report, options);
  return status(report);
}

}  // namespace

void add_check(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("check", "compare every step of every preset with its accepted baseline");
  const auto options = std::make_shared<CheckOptions>();
  options->asked.preset = "all";
  add_lesson(sub, program, options->asked, Takes::many, "lessons by id; all if none is given");
  sub.add_option("--preset", options->asked.preset, "only this one; all if not given")
      ->type_name("NAME")
      ->check(not_empty());
  sub.add_flag("--update{failed}", options->update,
               "accept what this run complains of (failed, if no more is\n"
               "said), what has no baseline yet (missing), or all anew")
      ->type_name("[=MODE]");
  add_path(sub, "--snapshots", options->snapshots, "folder of the baselines; snapshots if not given", "DIR");
  add_path(sub, "--dir", options->dir,
           "check the preset files of this folder and those below it (*.json)\n"
           "against baselines in DIR/snapshots",
           "DIR")
      ->excludes("--snapshots");
  add_path(sub, "--report", options->report, "one page with accepted, new and difference side by side", "FILE.html");
  add_path(sub, "--junit", options->junit, "the result as JUnit XML, a test case a preset", "FILE.xml");
  sub.add_flag("--json", options->json, "the result for programs");
  sub.add_option("--backend", options->backend, "auto (if not given), osmesa or egl")->type_name("NAME");
  sub.footer(
      "A file that isect did not make is never changed or removed, and no failure unless a baseline belongs "
      "there.\n"
      "Example: " +
      program.name + " check" + (program.only ? "" : " ray-sphere") + " --report check.html");
  sub.callback([&program, options] { program.chosen = [&program, options] { return check(program, *options); }; });
}

}  // namespace isect::program
