// isect render: figures as files.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/gallery.h"
#include "app/options.h"
#include "app/ownership.h"
#include "app/piece.h"
#include "app/preset_folder.h"
#include "app/studio.h"
#include "app/surroundings.h"
#include "app/terminal.h"
#include "viz/files.h"

namespace isect::program {

namespace {

using Json = nlohmann::ordered_json;

struct RenderOptions {
  Selection asked;
  StyleOptions style;
  std::string dir, out = "figures", backend = "auto", each;
  double seconds = 2.5;  ///< of each step, where they move
};

/// What the manifest says of a figure besides its step.
Json made_with(const Style& style, const viz::Format& format, const viz::Drawing& drawing,
               const std::string& renderer) {
  Json made = {{"theme", viz::name_of(style.theme)}, {"renderer", renderer}};
  if (style.paper) {
    made["width_pt"] = drawing.width;
    made["height_pt"] = drawing.height;
    made["text_pt"] = style.paper->text_size;
    if (format.pixels) made["dpi"] = style.dpi;
  } else {
    made["size"] = fmt::format("{}x{}", std::ceil(drawing.width), std::ceil(drawing.height));
  }
  return made;
}

/// A file of the run: a step, or all steps of an excerpt in one that moves.
struct Job {
  const Excerpt& e;
  Piece piece;
  std::vector<const viz::Format*> formats;
};

std::vector<Job> jobs_of(const std::vector<Excerpt>& chosen, const Style& style) {
  std::vector<const viz::Format*> still, moving;
  for (const viz::Format* format : style.formats) (format->film ? moving : still).push_back(format);
  std::vector<Job> jobs;
  for (const Excerpt& e : chosen) {
    for (const int step : e.steps)
      if (!still.empty()) jobs.push_back({e, piece_of(e, step), still});
    if (!moving.empty() && !e.steps.empty()) jobs.push_back({e, piece_of(e, "steps"), moving});
  }
  return jobs;
}

/// Each format of a job, given to `take`.
template <class Take>
void make(const Job& job, const RenderOptions& options, const Style& style, Studio& studio, const Take& take) {
  const std::vector<viz::Drawing> drawings = studio.draw(job.e, job.piece.steps);
  for (const viz::Format* format : job.formats) {
    Json about = made_with(style, *format, drawings.front(), studio.renderer(*format));
    if (format->film) about["seconds"] = options.seconds;
    take(*format,
         format->film ? studio.film(job.piece, drawings, options.seconds, *format)
                      : studio.write(job.piece, drawings.front(), *format),
         about);
  }
}

int to_stdout(const std::vector<Excerpt>& chosen, const RenderOptions& options, const Style& style) {
  const std::vector<Job> jobs = jobs_of(chosen, style);
  if (jobs.size() != 1 || jobs.front().formats.size() != 1)
    throw viz::BadInput("out: \"-\" takes exactly one figure in one format; give --step N, and one preset and format");
  Studio studio(style, options.backend);
  make(jobs.front(), options, style, studio,
       [](const viz::Format&, const std::string& bytes, const Json&) { print(bytes); });
  say_widened(studio);
  return done;
}

void draw_all(const std::vector<Job>& jobs, const RenderOptions& options, const Style& style, Studio& studio,
              Gallery& gallery) {
  Progress progress(jobs.size());
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const Job& job = jobs[i];
    make(job, options, style, studio, [&](const viz::Format& format, const std::string& bytes, const Json& about) {
      print(gallery.add(job.e, job.piece, format.name, bytes, about) + "\n");
    });
    progress.done(job.piece.stem);
    if (i + 1 < jobs.size() && &jobs[i + 1].e == &job.e) continue;  // more of this excerpt follow
    if (const std::size_t gone = gallery.remove_stale(job.e); gone > 0)
      say(fmt::format("removed {} figure{} of steps that {} no longer has", gone, gone == 1 ? "" : "s",
                      folder_of(job.e)));
  }
}

/// The presets of a folder in place of those that words name. Whether all of them can be read: the others are told.
bool choose_folder(const Program& program, RenderOptions& options) {
  const PresetFolder folder = preset_folder(options.dir, program);
  say_passed_over(folder);
  for (const BrokenPreset& broken : folder.broken) say(fmt::format("{}: {}", program.name, broken.what));
  options.asked.files = folder.presets;
  return folder.broken.empty();
}

int render(const Program& program, RenderOptions options) {
  const Style style = style_of(options.style);
  if (!options.each.empty()) options.seconds = seconds_of(options.each);
  const bool whole = options.dir.empty() || choose_folder(program, options);
  if (!whole && options.asked.files.empty()) return bad_input;
  const std::vector<Excerpt> chosen = excerpts(program, options.asked);
  need_surroundings(program);
  if (options.out == "-") return to_stdout(chosen, options, style);

  const std::vector<Job> jobs = jobs_of(chosen, style);
  Gallery gallery(options.out, program);
  for (const Job& job : jobs)
    for (const viz::Format* format : job.formats) gallery.need_ours(job.piece, *format);
  Studio studio(style, options.backend);
  try {
    draw_all(jobs, options, style, studio, gallery);
  } catch (...) {
    try {
      gallery.list();  // what stands by now
    } catch (const viz::FileError&) {
      // What went wrong first is what is told.
    }
    throw;
  }
  gallery.list();
  say_widened(studio);
  for (const std::string& text : gallery.left_alone())
    say(fmt::format("left alone: {} was edited; remove it to have isect's own text again", text));
  return whole ? done : bad_input;
}

}  // namespace

void add_render(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("render", "figures as files, with alt text and a manifest");
  const auto options = std::make_shared<RenderOptions>();
  add_lesson(sub, program, options->asked, Takes::many,
             "one lesson or several, by id; or files of presets, scenes or figures");
  sub.add_flag("--all", options->asked.all, "every lesson, and every preset unless --preset is given");
  add_preset(sub, options->asked, Takes::many,
             "presets, files with one each, or all; the first if not given.\nA word that ends in .json or "
             "has a slash is a file, whose\nstep and camera are honoured");
  add_path(sub, "--dir", options->dir, "all preset files of this folder and of those below it", "DIR")
      ->excludes("--preset")
      ->excludes("--all");
  add_step(sub, options->asked, Takes::many,
           "counted from 1: 3, 3-6, 3,5,7-9 or all; if not given, that of\nthe preset's file, or all");
  add_scene_file(sub, program, options->asked);
  add_set(sub, options->asked);
  add_style(sub, options->style, viz::format_names());
  sub.add_option("--seconds", options->each, "of each step in gif, apng and mp4; 2.5 if not given")->type_name("N");
  add_path(sub, "--out", options->out, "folder (figures if not given); - is stdout, for one figure", "DIR|-");
  sub.add_option("--backend", options->backend, "auto (if not given), osmesa or egl")->type_name("NAME");
  sub.footer(
      "Figures go to DIR/<lesson>/<preset>/; with --set to a folder that names what was set. What isect made "
      "there of\n"
      "steps that are gone is removed, in every format; nothing else ever is.\n"
      "Example: " +
      program.name + " render" + (program.only ? "" : " ray-sphere") + " --preset tangent --format pdf --width 8cm");
  sub.callback([&program, options] { program.chosen = [&program, options] { return render(program, *options); }; });
}

}  // namespace isect::program
