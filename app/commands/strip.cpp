// isect strip: several steps side by side in one figure.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/figures/figure_folder.h"
#include "app/figures/figure_maker.h"
#include "app/shell/environment.h"
#include "app/shell/terminal.h"
#include "viz/formats/files.h"

namespace isect::program {

namespace {

/// The most steps that a reader takes in at once; a lesson may have more.
constexpr std::size_t most_steps = 26;
constexpr int usual_columns = 3;
constexpr const char* any_columns = "auto";  ///< as many as there is room for

struct StripOptions {
  Selection asked;
  StyleOptions style;
  std::string out = "figures";
};

/// Returns the excerpt without the map and the card, which are no steps of the algorithm, unless they are asked for.
Excerpt excerpt_of(const Program& program, const Selection& asked) {
  Excerpt e = excerpt(program, asked);
  if (asked.step.empty() && e.several.empty() && !e.step) e.steps.resize(verdict_of(e.walk) + 1);
  return e;
}

int strip(const Program& program, StripOptions options) {
  if (!options.style.size.empty()) throw viz::BadInput("size: a strip is for paper; give its --width, such as 16cm");
  if (!options.style.height.empty())
    throw viz::BadInput("height: that of a strip comes from its --width and --columns");
  StyleOptions& asked = options.style;
  const Excerpt e = excerpt_of(program, options.asked);
  if (!e.style.empty()) fill_in(asked, e.style), asked.size.clear(), asked.height.clear();  // of a strip drawn before
  if (asked.width.empty()) asked.width = "16cm";
  asked.no_title = true;  // the title stands below
  const int steps = static_cast<int>(e.steps.size());
  if (asked.columns == any_columns) asked.columns.clear();
  const bool fewer = asked.columns.empty();
  const int columns =
      std::clamp(asked.columns.empty() ? usual_columns : columns_of(asked.columns), 1, std::max(steps, 1));
  asked.columns = fewer ? any_columns : std::to_string(columns);
  const Style style = style_of(asked);
  for (const viz::Format* format : style.formats)
    if (format->film) throw viz::BadInput(fmt::format("format: a strip does not move; {} is for render", format->name));
  if (e.steps.size() < 2 || e.steps.size() > most_steps)
    throw viz::BadInput(
        fmt::format("step: a strip has 2 to {} steps, and here are {}; choose some with --step, such "
                    "as --step 3-6",
                    most_steps, e.steps.size()));
  need_environment(program);

  const FigureInfo info = info_of(e, "strip");
  FigureMaker maker(style, "auto");
  const auto draw = [&] { return maker.draw_strip(e, columns, fewer, options.style.captions); };
  if (options.out == "-") {
    if (style.formats.size() != 1) throw viz::BadInput("out: \"-\" takes exactly one format");
    print(maker.write(info, draw(), *style.formats.front()));
    return done;
  }
  FigureFolder figures(options.out, program);
  for (const viz::Format* format : style.formats) figures.need_ours(info, *format);
  const viz::Drawing drawing = draw();
  for (const viz::Format* format : style.formats)
    print(figures.add(e, info, format->name, maker.write(info, drawing, *format),
                      {{"theme", viz::name_of(style.theme)},
                       {"width_pt", drawing.width},
                       {"height_pt", drawing.height},
                       {"text_pt", style.paper->text_size}}));
  figures.list();
  say_widened(maker);
  figures.say_left_alone();
  return done;
}

}  // namespace

void add_strip(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("strip", "several steps side by side in one figure, each with its letter");
  const auto options = std::make_shared<StripOptions>();
  add_lesson(sub, program, options->asked, Takes::one, "a lesson's id, or a preset's file");
  add_preset(sub, options->asked, Takes::one, "a preset, or a file with one; the first if not given");
  add_step(sub, options->asked, Takes::many,
           "counted from 1: 3-6, or 3,5,7-9; -1 is the last; or by name,\nas in render. If not given, all up to the "
           "verdict: without\nmap and card");
  add_scene_file(sub, program, options->asked);
  add_set(sub, options->asked);
  add_answers(sub, options->asked);
  sub.add_option("--columns", options->style.columns, "a row; 3 if not given, fewer where texts need more room")
      ->type_name("N");
  sub.add_flag("--captions", options->style.captions, "each step's caption below it, after its title");
  add_style(sub, options->style, viz::still_format_names());
  add_path(sub, "--out", options->out, "folder (figures if not given); - is stdout", "DIR|-");
  sub.footer("The width is that of the whole strip, 16cm if not given.\nExample: " + program.name + " strip" +
             (program.only ? "" : " ray-sphere") + " --step 2-4 --format pdf");
  sub.callback([&program, options] { program.chosen = [&program, options] { return strip(program, *options); }; });
}

}  // namespace isect::program
