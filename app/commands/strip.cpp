// isect strip: several steps, or several settings at one scale, side by side in one figure.

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/figures/figure_folder.h"
#include "app/figures/figure_maker.h"
#include "app/figures/ownership.h"
#include "app/scene/markup.h"
#include "app/shell/environment.h"
#include "app/shell/terminal.h"
#include "viz/formats/files.h"

namespace isect::program {

namespace {

/// The most parts that have a letter of their own, and that a reader takes in at once; a lesson may have more steps.
constexpr std::size_t most_parts = 26;
constexpr int usual_columns = 3;
constexpr const char* any_columns = "auto";  ///< as many as there is room for

struct StripOptions {
  Selection asked;
  StyleOptions style;
  std::string out = "figures";
};

/// Returns the settings with their steps. If none are named, a single one goes up to its verdict, without the map and
/// the card, which are no steps of the algorithm; of several each has its verdict alone.
std::vector<Excerpt> cases_for(const Program& program, Selection asked) {
  asked.to_verdict = asked.every_step = true;
  std::vector<Excerpt> cases;
  for (Excerpt& e : excerpts(program, asked)) {
    e.scaled_with.reset();
    const auto same =
        std::ranges::find_if(cases, [&](const Excerpt& other) { return folder_of(other) == folder_of(e); });
    if (same == cases.end()) {
      cases.push_back(std::move(e));
    } else {  // steps of one setting, from several figures
      same->steps.insert(same->steps.end(), e.steps.begin(), e.steps.end());
      std::ranges::sort(same->steps);
    }
  }
  if (cases.size() > 1 && asked.step.empty())
    for (Excerpt& e : cases)
      if (e.several.empty() && !e.step) e.steps = {verdict_of(e.walk)};
  return cases;
}

std::size_t parts_in(Excerpts cases) {
  std::size_t parts = 0;
  for (const Excerpt& e : cases) parts += e.steps.size();
  return parts;
}

/// Throws viz::BadInput unless a strip has so many parts.
void require_few_parts(Excerpts cases) {
  const std::size_t parts = parts_in(cases);
  if (parts >= 2 && parts <= most_parts) return;
  const std::string here = fmt::format("{} {}", parts == 1 ? "here is" : "here are", parts);
  if (cases.size() == 1)
    throw viz::BadInput(
        fmt::format("step: a strip has 2 to {} parts, and {}; choose some steps with --step, such as "
                    "--step 3-6, or several presets, such as --preset a,b",
                    most_parts, here));
  throw viz::BadInput(
      fmt::format("preset: a strip has 2 to {} parts, and {}, of {} cases; name fewer with --preset, "
                  "or fewer steps with --step",
                  most_parts, here, cases.size()));
}

/// Fills in how a figure was drawn from which all parts come. The width is taken from a strip, not from a part.
void take_style(StyleOptions& to, Excerpts cases) {
  const std::string& drawn = cases[0].style;
  const auto alike = [&](const Excerpt& e) { return e.style == drawn; };
  if (drawn.empty() || !std::ranges::all_of(cases, alike)) return;
  const std::string asked_width = to.width;
  fill_in(to, drawn);
  to.size.clear(), to.height.clear();
  if (StyleOptions was; cases.size() > 1) {
    fill_in(was, drawn);
    if (was.columns.empty()) to.width = asked_width;
  }
}

int strip(const Program& program, StripOptions options) {
  if (!options.style.size.empty()) throw viz::BadInput("size: a strip is for paper; give its --width, such as 16cm");
  if (!options.style.height.empty())
    throw viz::BadInput("height: that of a strip comes from its --width and --columns");
  StyleOptions& asked = options.style;
  scene::set_by_tex_alone(is_set_by_tex(asked));
  const std::vector<Excerpt> cases = cases_for(program, options.asked);
  take_style(asked, cases);
  if (asked.width.empty()) asked.width = "16cm";
  asked.no_title = true;  // the title stands below
  const int parts = static_cast<int>(parts_in(cases));
  if (asked.columns == any_columns) asked.columns.clear();
  const bool fewer = asked.columns.empty();
  const int columns =
      std::clamp(asked.columns.empty() ? usual_columns : columns_of(asked.columns), 1, std::max(parts, 1));
  asked.columns = fewer ? any_columns : std::to_string(columns);
  const Style style = style_of(asked);
  for (const viz::Format* format : style.formats)
    if (format->film) throw viz::BadInput(fmt::format("format: a strip does not move; {} is for render", format->name));
  require_few_parts(cases);
  need_environment(program);

  const FigureInfo info = info_of(cases, "strip");
  FigureMaker maker(style, "auto");
  const auto draw = [&] { return maker.draw_strip(cases, columns, fewer, options.style.captions); };
  if (options.out == "-") {
    if (style.formats.size() != 1) throw viz::BadInput("out: \"-\" takes exactly one format");
    const viz::Drawing drawing = draw();
    say_faces_inside(drawing, *style.formats.front());
    print(maker.write(info, drawing, *style.formats.front()));
    return done;
  }
  FigureFolder figures(options.out, program);
  for (const viz::Format* format : style.formats) figures.need_ours(info, *format);
  const viz::Drawing drawing = draw();
  for (const viz::Format* format : style.formats)
    print(figures.add(cases, info, format->name, maker.write_for_folder(info, drawing, *format),
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
  CLI::App& sub = *app.add_subcommand("strip", "several steps or cases in one figure, each with its letter");
  const auto options = std::make_shared<StripOptions>();
  add_lesson(sub, program, options->asked, Takes::many, "lessons, by id; or files of presets, scenes or figures");
  add_preset(sub, options->asked, Takes::many,
             "presets, files with one each, or all; the first if not given.\nSeveral are joined by commas, or each has "
             "its --preset. Of several\nlessons, each takes those that it has");
  add_step(sub, options->asked, Takes::many,
           "counted from 1: 3-6, or 3,5,7-9; -1 is the last; or by name,\nas in render. If not given, the step of the "
           "file; else of one preset\nall up to the verdict: without map and card; of several the\nverdict of each");
  add_scene_file(sub, program, options->asked, Takes::many);
  add_set(sub, options->asked);
  add_answers(sub, options->asked);
  add_language(sub, options->asked);
  sub.add_option("--columns", options->style.columns, "a row; 3 if not given, fewer where texts need more room")
      ->type_name("N");
  sub.add_flag("--captions", options->style.captions, "each step's caption below it, after its title");
  add_style(sub, options->style, viz::still_format_names());
  add_path(sub, "--out", options->out, "folder (figures if not given); - is stdout", "DIR|-");
  const std::string lesson = program.only ? "" : " ray-sphere";
  sub.footer(
      "The width is that of the whole strip, 16cm if not given. A strip has 2 to 26 parts.\n"
      "Several cases, presets or scenes, stand side by side at one scale: a unit of the world has one\n"
      "length in all pictures, of the plane and of space alike, and eyes in perspective have one distance.\n"
      "Each is seen from its own direction. The camera of a preset's file keeps its direction and its\n"
      "middle, and shows at least as much as there. Maps, charts and cards of text have no scale.\n"
      "Below each part stands the title of its preset or scene, in place of the step's. `" +
      program.name +
      " strip FILE` draws\na strip again, and `render FILE` its parts one by one.\n"
      "Examples: " +
      program.name + " strip" + lesson + " --step 2-4 --format pdf\n          " + program.name + " strip" + lesson +
      " --preset two-roots,tangent,miss --step verdict" +
      (program.only ? "" : "\n          " + program.name + " strip one.json two.json --columns 2"));
  sub.callback([&program, options, &sub] {
    note_order(sub, options->asked);
    program.chosen = [&program, options] { return strip(program, *options); };
  });
}

}  // namespace isect::program
