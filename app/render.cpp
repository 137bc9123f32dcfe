// isect render: figures as files.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/gallery.h"
#include "app/options.h"
#include "app/ownership.h"
#include "app/preset_folder.h"
#include "app/studio.h"
#include "app/surroundings.h"
#include "app/terminal.h"
#include "viz/files.h"

namespace isect::program {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
  Selection asked;
  StyleOptions style;
  std::string dir, out = "figures", backend = "auto";
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

/// Which figures could not be as narrow as was asked: honestly wider, rather than with labels that meet.
void say_widened(const Studio& studio) {
  const std::vector<std::string>& all = studio.widened();
  if (all.empty()) return;
  say(fmt::format("width: at this text size the labels of {} figure{} would meet or leave the picture, so {} wider:",
                  all.size(), all.size() == 1 ? "" : "s", all.size() == 1 ? "it is" : "they are"));
  constexpr std::size_t enough = 12;
  for (std::size_t i = 0; i < std::min(enough, all.size()); ++i) say("  " + all[i]);
  if (all.size() > enough) say(fmt::format("  and {} others; manifest.json has every width", all.size() - enough));
  say("Give a smaller --text-size to have them narrower.");
}

int to_stdout(const std::vector<Excerpt>& chosen, const Style& style, const std::string& backend) {
  if (chosen.size() != 1 || chosen[0].steps.size() != 1 || style.formats.size() != 1)
    throw viz::BadInput("out: \"-\" takes exactly one figure in one format; give --step N, and one preset and format");
  const Excerpt& e = chosen[0];
  Studio studio(style, backend);
  const viz::Drawing drawing = studio.draw(e, e.steps[0]);
  print(studio.write(e, e.steps[0], drawing, *style.formats[0]));
  say_widened(studio);
  return done;
}

void draw_all(const std::vector<Excerpt>& chosen, const Style& style, Studio& studio, Gallery& gallery) {
  std::size_t count = 0;
  for (const Excerpt& e : chosen) count += e.steps.size();
  Progress progress(count);
  for (const Excerpt& e : chosen) {
    for (const int step : e.steps) {
      const viz::Drawing drawing = studio.draw(e, step);
      for (const viz::Format* format : style.formats)
        print(gallery.add(e, step, format->name, studio.write(e, step, drawing, *format),
                          made_with(style, *format, drawing, studio.renderer(*format))) +
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
  const Style style = style_of(options.style);
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
  say_widened(studio);
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
  add_style(sub, options->style);
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
