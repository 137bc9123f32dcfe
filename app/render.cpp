// isect render: figures as files.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/gallery.h"
#include "app/options.h"
#include "app/ownership.h"
#include "app/preset_folder.h"
#include "app/surroundings.h"
#include "app/terminal.h"
#include "viz/compose.h"
#include "viz/files.h"
#include "viz/formats.h"
#include "viz/offscreen.h"

namespace isect::program {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
  Selection asked;
  std::string format = viz::formats().front().name, theme = "screen", size, width, dir, out = "figures",
              backend = "auto";
};

/// What every figure of this run shares.
struct Style {
  std::vector<const viz::Format*> formats;
  viz::ThemeName theme;
  Size size;
  viz::Paper paper;
};

Style style_of(const Options& options) {
  if (!options.size.empty() && !options.width.empty())
    throw viz::BadInput("size: give either --size (pixels) or --width (on paper), not both");
  Style style{formats_of(options.format),
              viz::theme_named(options.theme),
              options.size.empty() ? Size{} : size_of(options.size),
              {}};
  if (!options.width.empty()) {
    style.paper.width_pt = points_of(options.width);
    if (std::ranges::all_of(style.formats, &viz::Format::pixels))
      throw viz::BadInput("width: a picture of pixels has none on paper; give --size, or --format svg");
  }
  return style;
}

/// Draws the figures of one run. A rendering back end is started only where a format needs one.
class Studio {
 public:
  Studio(const Style& style, const std::string& backend) : style_(style) {
    const viz::Backend wanted = viz::backend_named(backend);
    if (std::ranges::any_of(style.formats, &viz::Format::pixels)) offscreen_ = std::make_unique<viz::Offscreen>(wanted);
  }

  std::string draw(const Excerpt& e, const viz::Camera& camera, int step, const viz::Format& format) {
    const viz::Drawing drawing =
        viz::figure(e.walk.steps[step], camera, style_.theme, style_.size.width, style_.size.height).drawing;
    return format.write(drawing, metadata_of(e, step), style_.paper,
                        [this](const viz::Drawing& d) { return offscreen_->render(d); });
  }

  std::string renderer(const viz::Format& format) const { return format.pixels ? offscreen_->driver() : "cairo"; }

 private:
  const Style& style_;
  std::unique_ptr<viz::Offscreen> offscreen_;
};

/// What the manifest says of a figure besides its step.
Json made_with(const Style& style, const viz::Format& format, const std::string& renderer) {
  Json made = {{"theme", viz::name_of(style.theme)}, {"renderer", renderer}};
  made["size"] = fmt::format("{}x{}", style.size.width, style.size.height);
  if (style.paper.width_pt > 0 && !format.pixels) made["width_pt"] = style.paper.width_pt;
  return made;
}

int to_stdout(const std::vector<Excerpt>& chosen, const Style& style, const std::string& backend) {
  if (chosen.size() != 1 || chosen[0].steps.size() != 1 || style.formats.size() != 1)
    throw viz::BadInput("out: \"-\" takes exactly one figure in one format; give --step N, and one preset and format");
  const Excerpt& e = chosen[0];
  Studio studio(style, backend);
  const viz::Camera camera = camera_for(e, style.theme, style.size);
  print(studio.draw(e, camera, e.steps[0], *style.formats[0]));
  return done;
}

void draw_all(const std::vector<Excerpt>& chosen, const Style& style, Studio& studio, Gallery& gallery) {
  std::size_t count = 0;
  for (const Excerpt& e : chosen) count += e.steps.size();
  Progress progress(count);
  for (const Excerpt& e : chosen) {
    const viz::Camera camera = camera_for(e, style.theme, style.size);
    for (const int step : e.steps) {
      for (const viz::Format* format : style.formats)
        print(gallery.add(e, step, format->name, studio.draw(e, camera, step, *format),
                          made_with(style, *format, studio.renderer(*format))) +
              "\n");
      progress.done(file_of(e, step));
    }
    if (const std::size_t gone = gallery.remove_stale(e); gone > 0)
      say(fmt::format("removed {} figure{} of steps that {} no longer has", gone, gone == 1 ? "" : "s", folder_of(e)));
  }
}

/// The presets of a folder in place of those that words name. Whether all of them can be read: the others are told.
bool choose_folder(const Program& program, Options& options) {
  const PresetFolder folder = preset_folder(options.dir, program);
  say_passed_over(folder);
  for (const BrokenPreset& broken : folder.broken) say(fmt::format("{}: {}", program.name, broken.what));
  options.asked.files = folder.presets;
  return folder.broken.empty();
}

int render(const Program& program, Options options) {
  const Style style = style_of(options);
  const bool whole = options.dir.empty() || choose_folder(program, options);
  if (!whole && options.asked.files.empty()) return bad_input;
  const std::vector<Excerpt> chosen = excerpts(program, options.asked);
  need_surroundings(program);
  if (options.out == "-") return to_stdout(chosen, style, options.backend);

  Gallery gallery(options.out, program, chosen, style.formats);
  Studio studio(style, options.backend);
  try {
    draw_all(chosen, style, studio, gallery);
  } catch (...) {
    try {
      gallery.list();  // what stands by now
    } catch (const viz::FileError&) {
      // What went wrong first is what is told.
    }
    throw;
  }
  gallery.list();
  for (const std::string& text : gallery.left_alone())
    say(fmt::format("left alone: {} was edited; remove it to have isect's own text again", text));
  return whole ? done : bad_input;
}

}  // namespace

void add_render(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("render", "figures as files, with alt text and a manifest");
  const auto options = std::make_shared<Options>();
  add_lesson(sub, program, options->asked, Takes::many, "one lesson or several, by id; or presets' files");
  sub.add_flag("--all", options->asked.all, "every lesson, and every preset unless --preset is given");
  add_preset(sub, options->asked, Takes::many,
             "presets, files with one each, or all; the first if not given.\nA word that ends in .json or "
             "has a slash is a file, whose\nstep and camera are honoured");
  add_path(sub, "--dir", options->dir, "all preset files of this folder and of those below it", "DIR")
      ->excludes("--preset")
      ->excludes("--all");
  add_step(sub, options->asked, Takes::many,
           "counted from 1: 3, 3-6, 3,5,7-9 or all; if not given, that of\nthe preset's file, or all");
  add_set(sub, options->asked);
  const std::vector<std::string> formats = viz::format_names();
  sub.add_option("--format", options->format,
                 fmt::format("{} (if not given), {}, or {}", formats.front(),
                             fmt::join(formats.begin() + 1, formats.end(), ", "), fmt::join(formats, ",")))
      ->type_name("FORMAT");
  sub.add_option("--theme", options->theme, "screen (if not given), print, grey or dark")->type_name("THEME");
  sub.add_option("--size", options->size, "in pixels; 960x600 if not given")->type_name("WxH");
  sub.add_option("--width", options->width, "on paper, for svg: 8cm, 80mm, 227pt, 3in")->type_name("LENGTH");
  add_path(sub, "--out", options->out, "folder (figures if not given); - is stdout, for one figure", "DIR|-");
  sub.add_option("--backend", options->backend, "auto (if not given), osmesa or egl")->type_name("NAME");
  sub.footer(
      "Figures go to DIR/<lesson>/<preset>/; with --set to a folder that names what was set. What isect made "
      "there of\n"
      "steps that are gone is removed, in every format; nothing else ever is.\n"
      "Example: " +
      program.name + " render" + (program.only ? "" : " ray-sphere") + " --preset tangent --format svg --width 8cm");
  sub.callback([&program, options] { program.chosen = [&program, options] { return render(program, *options); }; });
}

}  // namespace isect::program
