// isect check: do the lessons still say and show what was accepted?

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>

#include "app/checks/baselines.h"
#include "app/checks/check_choice.h"
#include "app/checks/check_report.h"
#include "app/figures/ownership.h"
#include "app/shell/environment.h"
#include "app/shell/named_file.h"
#include "app/shell/terminal.h"
#include "viz/formats/writable.h"

namespace isect::program {

namespace {

namespace fs = std::filesystem;

struct CheckOptions {
  Selection asked;
  std::string snapshots, dir, report, junit, update, accept, backend;
  bool json = false, github = false;

  /// Returns the folder of the baselines.
  std::string folder() const {
    if (!dir.empty()) return (fs::path(dir) / "snapshots").string();
    return snapshots.empty() ? "snapshots" : snapshots;
  }
};

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

/// Returns the file that GitHub takes a job's summary from; empty outside GitHub.
std::string summary_file(const CheckOptions& options) {
  const char* const file = options.github ? std::getenv("GITHUB_STEP_SUMMARY") : nullptr;
  return file ? file : "";
}

/// Appends, as other steps of the job write to the same file.
void append(const std::string& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary | std::ios::app);
  out << text << std::flush;
  if (!out) throw viz::FileError(fmt::format("cannot write '{}': {}", file, std::strerror(errno)));
}

void write_page(const Report& report, const std::string& file) {
  constexpr std::size_t all_inside = std::numeric_limits<std::size_t>::max();
  std::error_code absent;
  const bool stream = fs::exists(file, absent) && !fs::is_regular_file(file, absent);  // nothing lies beside a pipe
  write_html(stream ? to_html(report, file, all_inside) : to_html(report, file), file);
}

/// Prints the result, even if a report of it can't be written.
void tell(const Report& report, const CheckOptions& options) {
  const std::string result =
      options.json ? to_json(report) : to_text(report) + (options.github ? to_github(report) : "");
  try {
    if (!options.report.empty()) write_page(report, options.report);
    if (const std::string file = summary_file(options); !file.empty()) append(file, to_markdown(report));
    if (!options.junit.empty()) viz::write_file(options.junit, to_junit(report));
  } catch (const viz::FileError&) {
    print(result);
    throw;
  }
  print(result);
}

/// Accepts what was ticked in a report, as far as it is still what was looked at.
int accept_reviewed(const Program& program, const CheckOptions& options) {
  if (!options.asked.lessons.empty() || options.asked.preset != "all")
    throw viz::BadInput("accept: the file says which pictures are accepted; name no lesson or preset besides");
  std::optional<Acceptance> acceptance;
  try {
    acceptance.emplace(read_accept_file(read_named_file(options.accept)));
  } catch (const viz::BadInput& e) {
    throw viz::BadInput(fmt::format("{}: {}", options.accept, e.what()));
  }
  const viz::Backend backend = viz::backend_named(options.backend.empty() ? "auto" : options.backend);
  Selection asked;
  asked.preset = "all";
  if (options.dir.empty() && !program.only && !acceptance->removes())  // others need not be walked
    for (const viz::Lesson* lesson : program.lessons)
      if (acceptance->names_some_in(lesson->id)) asked.lessons.push_back(lesson->id);
  const CheckChoice choice = check_choice(program, asked, options.dir);
  for (const Failure& broken : choice.broken) say(broken.what);
  std::vector<const Excerpt*> named;
  for (const Excerpt& e : choice.presets)
    if (acceptance->names_some_in(folder_of(e))) named.push_back(&e);
  if (!named.empty() || acceptance->removes()) {
    need_environment(program);
    viz::Offscreen offscreen(backend);
    Baselines baselines(options.folder(), Update::none, false, offscreen, &*acceptance);
    Progress progress(named.size());
    for (const Excerpt* e : named) {
      baselines.check(*e);
      progress.done(folder_of(*e));
    }
    if (acceptance->removes()) baselines.orphans(choice.presets, choice.reach);
  }
  acceptance->close(options.folder());
  print(options.json ? to_json(*acceptance) : to_text(*acceptance));
  return status(*acceptance);
}

int check(const Program& program, const CheckOptions& options) {
  require_own_places(options);
  if (const std::string file = summary_file(options); !file.empty()) viz::need_writable(file);
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
  if (!options.accept.empty()) return accept_reviewed(program, options);

  Report report;
  report.asked = {called(),    options.asked.lessons, options.asked.preset == "all" ? "" : options.asked.preset,
                  options.dir, options.snapshots,     options.backend};
  report.folder = options.folder();
  const auto [chosen, broken, reach] = check_choice(program, options.asked, options.dir);
  report.failures = broken;
  for (const Excerpt& e : chosen) {
    if (report.lessons.empty() || report.lessons.back() != e.lesson->id) {
      report.lessons.push_back(e.lesson->id);
      const bool listed = std::ranges::find(program.lessons, e.lesson) != program.lessons.end();  // a scene is not
      if (listed && !program.only) report.by_name.push_back(e.lesson->id);
    }
    report.checked.push_back({e.lesson->id, e.folder});
    for (int step = 0; step < static_cast<int>(e.walk.steps.size()); ++step)
      if (has_picture(e, step)) report.pictures += 1 + e.guards.size();
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
  add_path(sub, "--accept", options->accept,
           "accept just what was ticked in a report, which saves this file;\n"
           "what is another picture by now is refused",
           "FILE.json")
      ->excludes("--update");
  add_path(sub, "--snapshots", options->snapshots, "folder of the baselines; snapshots if not given", "DIR");
  add_path(sub, "--dir", options->dir,
           "check the preset files of this folder and those below it (*.json)\n"
           "against baselines in DIR/snapshots; \"guard\": [{\"theme\": \"dark\"}] in\n"
           "one guards further looks: theme, size or width, format (png, svg, tikz)",
           "DIR")
      ->excludes("--snapshots");
  add_path(sub, "--report", options->report,
           "one page with the changes by cause; tick there what is to be\n"
           "accepted (? lists the keys)",
           "FILE.html")
      ->excludes("--accept");
  add_path(sub, "--junit", options->junit, "the result as JUnit XML, a test case a preset", "FILE.xml")
      ->excludes("--accept");
  sub.add_flag("--json", options->json, "the result for programs");
  sub.add_flag("--github", options->github,
               "annotations for GitHub Actions, an error a cause, and the job's\n"
               "summary where GITHUB_STEP_SUMMARY is set")
      ->excludes("--accept")
      ->excludes("--json");
  sub.add_option("--backend", options->backend, "auto (if not given), osmesa or egl")->type_name("NAME");
  sub.footer(
      "A file that isect did not make is never changed or removed, and no failure unless a baseline belongs "
      "there.\n"
      "Example: " +
      program.name + " check" + (program.only ? "" : " ray-sphere") + " --report check.html");
  sub.callback([&program, options] { program.chosen = [&program, options] { return check(program, *options); }; });
}

}  // namespace isect::program
