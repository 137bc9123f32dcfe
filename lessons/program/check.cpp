// isect check: do the lessons still say and show what was accepted?

#include <memory>

#include "lessons/program/baselines.h"
#include "lessons/program/report.h"
#include "lessons/program/terminal.h"

namespace isect::program {

namespace {

struct Options {
  Selection asked;
  std::string snapshots = "snapshots", dir, report, update, backend = "auto";
  bool json = false;
};

int check(const Program& program, Options options) {
  const Update update = update_named(options.update);
  const viz::Backend backend = viz::backend_named(options.backend);
  const bool all = options.asked.lessons.empty() && !program.only;
  const bool all_presets = options.asked.preset == "all";
  const bool others = !options.dir.empty();  // presets of the user's own
  if (others) options.snapshots = options.dir, options.asked.files = preset_files(options.dir);
  options.asked.all = all && !others;
  options.asked.step = "all";
  const std::vector<Excerpt> chosen = excerpts(program, options.asked);
  for (const Excerpt& e : chosen)
    if (e.folder != e.preset && !others)
      throw viz::BadInput(
          "preset: only the lesson's own presets have baselines here; for files of yours give --dir");

  Report report{program.name, options.snapshots, others, {}, chosen.size(), 0, {}};
  viz::Offscreen offscreen(backend);
  Baselines baselines(options.snapshots, update, offscreen);
  Progress progress(chosen.size());
  for (const Excerpt& e : chosen) {
    if (report.lessons.empty() || report.lessons.back() != e.lesson->id)
      report.lessons.push_back(e.lesson->id);
    for (int step = 0; step < static_cast<int>(e.walk.steps.size()); ++step)
      report.pictures += has_picture(e, step);
    for (Failure& f : baselines.check(e)) report.failures.push_back(std::move(f));
    progress.done(e.lesson->id + " " + e.folder);
  }
  for (Failure& f : baselines.orphans(chosen, all && all_presets, all_presets))
    report.failures.push_back(std::move(f));

  if (!options.report.empty()) viz::write_file(options.report, to_html(report));
  print(options.json ? to_json(report) : to_text(report));
  return status(report);
}

}  // namespace

void add_check(CLI::App& app, Program& program) {
  CLI::App& sub =
      *app.add_subcommand("check", "compare every step of every preset with its accepted baseline");
  const auto options = std::make_shared<Options>();
  options->asked.preset = "all";
  add_lesson(sub, program, options->asked, Takes::many, "lessons by id; all if none is given");
  sub.add_option("--preset", options->asked.preset, "only this one; all if not given")->type_name("NAME");
  sub.add_flag("--update{failed}", options->update,
               "accept what this run complains of (failed, if no more is\n"
               "said), what has no baseline yet (missing), or all anew")
      ->type_name("[=MODE]");
  sub.add_option("--snapshots", options->snapshots, "folder of the baselines; snapshots if not given")
      ->type_name("DIR");
  sub.add_option("--dir", options->dir,
                 "check the preset files of this folder (*.json) against baselines beside them")
      ->type_name("DIR")
      ->excludes("--snapshots")
      ->excludes("--preset");
  sub.add_option("--report", options->report, "one page with accepted, new and difference side by side")
      ->type_name("FILE.html");
  sub.add_flag("--json", options->json, "the result for programs");
  sub.add_option("--backend", options->backend, "auto (if not given), osmesa or egl")->type_name("NAME");
  sub.footer("Example: " + program.name + " check" + (program.only ? "" : " ray-sphere") +
             " --report check.html");
  sub.callback(
      [&program, options] { program.chosen = [&program, options] { return check(program, *options); }; });
}

}  // namespace isect::program
