// isect render: figures as files.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/figures/figure_folder.h"
#include "app/figures/figure_info.h"
#include "app/figures/figure_maker.h"
#include "app/figures/ownership.h"
#include "app/preset_folder.h"
#include "app/scene/markup.h"
#include "app/shell/environment.h"
#include "app/shell/options.h"
#include "app/shell/terminal.h"
#include "viz/formats/files.h"
#include "viz/player/direction.h"
#include "viz/text/rich_text.h"

namespace isect::program {

namespace {

using Json = nlohmann::ordered_json;

struct RenderOptions {
  Selection asked;
  StyleOptions style;
  std::string dir, out = "figures", backend = "auto", each, camera;
  double seconds = 2.5;  ///< per step of an animation
  bool same_scale = false;
};

/// Returns the manifest's entry for a figure, except for its step.
Json made_with(const Style& style, const viz::Format& format, const viz::Drawing& drawing,
               const std::string& renderer) {
  Json made = {{"theme", viz::name_of(style.theme)}, {"renderer", renderer}};
  if (style.paper) {
    made["width_pt"] = drawing.width;
    made["height_pt"] = drawing.height;
    made["text_pt"] = style.paper->text_size;
    made["script_pt"] = viz::script_size * style.paper->text_size;
    if (format.pixels) made["dpi"] = style.dpi;
  } else {
    made["size"] = fmt::format("{}x{}", std::ceil(drawing.width), std::ceil(drawing.height));
  }
  return made;
}

/// The figure makers of the excerpts: with the options asked for, or those of the figure from which an excerpt comes.
class FigureMakers {
 public:
  FigureMakers(const std::vector<Excerpt>& all, const RenderOptions& options) : backend_(options.backend) {
    for (const Excerpt& e : all) {
      if (made_.contains(e.style)) continue;
      StyleOptions own = options.style;
      if (!e.style.empty()) fill_in(own, e.style);
      if (!own.columns.empty()) {  // it was a strip of several
        own.width = options.style.width, own.columns.clear();
        if (own.width.empty()) own.text_size = options.style.text_size;
      }
      const std::string font = font_of(own);
      if (!made_.empty() && font != font_)
        throw viz::BadInput("font: these figures are set in several, and a run sets all in one; give --font");
      font_ = font;
      made_[e.style].style = style_of(own);
    }
  }
  const Style& style(const Excerpt& e) const { return made_.at(e.style).style; }
  FigureMaker& of(const Excerpt& e) {
    Made& made = made_.at(e.style);
    if (!made.maker) made.maker = std::make_unique<FigureMaker>(made.style, backend_);
    return *made.maker;
  }
  void say_widened() const {
    for (const auto& [words, made] : made_)
      if (made.maker) program::say_widened(*made.maker);
  }

 private:
  struct Made {
    Style style;
    std::unique_ptr<FigureMaker> maker;
  };
  std::string backend_, font_;
  std::map<std::string, Made> made_;  ///< by the words of a figure, "" for all others
};

/// A file of the run: a step, or all steps of an excerpt in one animation.
struct Job {
  const Excerpt& e;
  FigureInfo info;
  std::vector<const viz::Format*> formats;
};

std::vector<Job> jobs_of(const std::vector<Excerpt>& chosen, const FigureMakers& makers) {
  std::vector<Job> jobs;
  for (const Excerpt& e : chosen) {
    std::vector<const viz::Format*> still, moving;
    for (const viz::Format* format : makers.style(e).formats) (format->film ? moving : still).push_back(format);
    for (const int step : e.steps)
      if (!still.empty()) jobs.push_back({e, info_of(e, step), still});
    if (!moving.empty() && !e.steps.empty()) jobs.push_back({e, info_of(Excerpts(&e, 1), "steps"), moving});
  }
  return jobs;
}

/// Makes each format of a job, and passes it to `take`.
template <class Take>
void make(const Job& job, const RenderOptions& options, FigureMakers& makers, const Take& take) {
  const Style& style = makers.style(job.e);
  FigureMaker& maker = makers.of(job.e);
  const bool moves = job.formats.front()->film;  // then all do
  const std::vector<Shot> shots = moves ? film_of(job.e, job.info.steps, options.seconds) : shots_of(job.info.steps);
  const std::vector<viz::Drawing> drawings = maker.draw(job.e, shots);
  for (const viz::Format* format : job.formats) {
    Json about = made_with(style, *format, drawings.front(), maker.renderer(*format));
    if (format->film) about["seconds"] = options.seconds;
    if (format->film)
      take(*format, maker.film(job.info, shots, drawings, *format), about);
    else if (options.out == "-")
      say_faces_inside(drawings.front(), *format),
          take(*format, maker.write(job.info, drawings.front(), *format), about);
    else
      take(*format, maker.write_for_folder(job.info, drawings.front(), *format), about);
  }
}

int to_stdout(const std::vector<Job>& jobs, const RenderOptions& options, FigureMakers& makers) {
  if (jobs.size() != 1 || jobs.front().formats.size() != 1)
    throw viz::BadInput("out: \"-\" takes exactly one figure in one format; give --step N, and one preset and format");
  make(jobs.front(), options, makers,
       [](const viz::Format&, const FigureFile& made, const Json&) { print(made.bytes); });
  makers.say_widened();
  return done;
}

void draw_all(const std::vector<Job>& jobs, const RenderOptions& options, FigureMakers& makers, FigureFolder& figures) {
  Progress progress(jobs.size());
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const Job& job = jobs[i];
    make(job, options, makers, [&](const viz::Format& format, const FigureFile& made, const Json& about) {
      print(figures.add(job.e, job.info, format.name, made, about));
    });
    progress.done(job.info.stem);
    if (i + 1 < jobs.size() && &jobs[i + 1].e == &job.e) continue;  // more of this excerpt follow
    if (const std::size_t gone = figures.remove_stale(job.e); gone > 0)
      say(fmt::format("removed {} figure{} of steps that {} no longer has", gone, gone == 1 ? "" : "s",
                      folder_of(job.e)));
  }
}

/// Takes the presets of a folder instead of named ones. Returns whether all can be read; unreadable ones are reported.
bool choose_folder(const Program& program, RenderOptions& options) {
  const PresetFolder folder = preset_folder(options.dir, program);
  say_passed_over(folder);
  for (const BrokenPreset& broken : folder.broken) say(fmt::format("{}: {}", program.name, broken.what));
  options.asked.files = folder.presets;
  return folder.broken.empty();
}

/// Turns all views to this direction. A lesson of one plane is refused.
void turn(std::vector<Excerpt>& chosen, const std::string& direction) {
  double azimuth = 0, elevation = 0;
  char comma = 0, more = 0;
  std::istringstream text(direction);
  text.imbue(std::locale::classic());
  if (!(text >> azimuth >> comma >> elevation) || comma != ',' || text >> more ||
      !(std::abs(azimuth) <= 360 && std::abs(elevation) <= 90))
    throw viz::BadInput(
        fmt::format("camera: \"{}\" is not allowed; give AZIMUTH,ELEVATION in degrees, -360 to 360 and "
                    "-90 to 90, such as 70,35",
                    direction));
  for (Excerpt& e : chosen) {
    if (e.lesson->flat)
      throw viz::BadInput(fmt::format("camera: {} lies in one plane and is seen straight on", e.lesson->id));
    e.camera = viz::seen_from(*e.lesson, e.walk, azimuth, elevation);
  }
}

/// Gives all one scale, and each the list of all.
void scale_alike(std::vector<Excerpt>& chosen) {
  for (Excerpt& e : chosen) {
    e.scaled_with.reset();
    if (e.style != chosen.front().style)
      throw viz::BadInput(
          "same-scale: these figures were not drawn in one way; give their lessons and presets in their place");
  }
  const auto all = std::make_shared<const std::vector<Excerpt>>(chosen);
  for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i].scaled_with = all, chosen[i].scaled_as = i;
}

int render(const Program& program, RenderOptions options) {
  if (!options.each.empty()) options.seconds = seconds_of(options.each);
  const bool whole = options.dir.empty() || choose_folder(program, options);
  if (!whole && options.asked.files.empty()) return bad_input;
  scene::set_by_tex_alone(is_set_by_tex(options.style));
  std::vector<Excerpt> chosen = excerpts(program, options.asked);
  if (!options.camera.empty()) turn(chosen, options.camera);
  if (options.same_scale) scale_alike(chosen);
  FigureMakers makers(chosen, options);  // sets the font before any is used
  need_environment(program);
  const std::vector<Job> jobs = jobs_of(chosen, makers);
  if (options.out == "-") return to_stdout(jobs, options, makers);

  FigureFolder figures(options.out, program);
  for (const Job& job : jobs)
    for (const viz::Format* format : job.formats) figures.need_ours(job.info, *format);
  draw_all(jobs, options, makers, figures);
  figures.list();
  makers.say_widened();
  figures.say_left_alone();
  return whole ? done : bad_input;
}

}  // namespace

void add_render(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("render", "figures as files, with alt text and a manifest");
  const auto options = std::make_shared<RenderOptions>();
  add_lesson(sub, program, options->asked, Takes::many,
             "one lesson or several, by id; or files of presets, scenes or figures");
  sub.add_flag("--all", options->asked.all, "every lesson, and every preset unless --preset is given");
  add_preset(
      sub, options->asked, Takes::many,
      "presets, files with one each, or all; the first if not given.\nSeveral are joined by commas, or each has its "
      "--preset. A word\nthat ends in .json or has a slash is a file, whose step,\n"
      "time and camera (angles in degrees) are honoured");
  add_path(sub, "--dir", options->dir, "all preset files of this folder and of those below it", "DIR")
      ->excludes("--preset")
      ->excludes("--all");
  add_step(sub, options->asked, Takes::many,
           "counted from 1: 3, 3-6, 3,5,7-9 or all; -1 is the last; or by\nname: intersect; verdict is the last before "
           "map and "
           "card. If\nnot given, that of the preset's file, or all");
  add_scene_file(sub, program, options->asked, Takes::many);
  add_set(sub, options->asked);
  add_answers(sub, options->asked);
  add_language(sub, options->asked);
  sub.add_option(
         "--camera", options->camera,
         "where space is seen from, in degrees: azimuth, 0 from +z and 90\nfrom +x, and elevation, 90 from above")
      ->type_name("AZ,EL")
      ->check(not_empty());
  sub.add_flag("--same-scale", options->same_scale,
               "one size and one scale for all: a unit of the world has one length\nin all figures, and eyes in "
               "perspective have one distance");
  add_style(sub, options->style, viz::format_names());
  sub.add_option("--seconds", options->each,
                 "of each step in gif, apng and mp4; 2.5 if not given; a card of\ntext stays four times as long")
      ->type_name("N");
  add_path(sub, "--out", options->out, "folder (figures if not given); - is stdout, for one figure", "DIR|-");
  sub.add_option("--backend", options->backend, "auto (if not given), osmesa or egl")->type_name("NAME");
  sub.footer(
      "Figures go to DIR/<lesson>/<preset>/; with --set to a folder that names what was set. What isect made "
      "there of\n"
      "steps that are gone is removed, in every format; nothing else ever is. What someone has edited stays as it is.\n"
      "Example: " +
      program.name + " render" + (program.only ? "" : " ray-sphere") + " --preset tangent --format pdf --width 8cm");
  sub.callback([&program, options, &sub] {
    note_order(sub, options->asked);
    program.chosen = [&program, options] { return render(program, *options); };
  });
}

}  // namespace isect::program
