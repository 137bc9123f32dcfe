// isect theme: whether a theme of one's own can be read, its numbers, and a swatch of its roles.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/figures/figure_maker.h"
#include "app/figures/ownership.h"
#include "app/figures/theme_choice.h"
#include "app/figures/theme_swatch.h"
#include "app/program.h"
#include "app/shell/environment.h"
#include "app/shell/options.h"
#include "app/shell/terminal.h"
#include "viz/formats/files.h"
#include "viz/formats/formats.h"
#include "viz/lesson.h"
#include "viz/player/reader_state.h"
#include "viz/text/spelling.h"

namespace isect::program {

namespace {

constexpr const char* swatch_width = "16cm";
constexpr const char* swatch_key = "swatch";  ///< in its metadata, by which it is known as isect's

struct ThemeOptions {
  std::string theme, out;
  bool json = false;
};

/// Returns the theme of a file, or the values of a built-in one.
ReadTheme read_named(const std::string& word) {
  if (is_theme_file(word)) return read_theme_file(word);
  return {viz::values_of(viz::theme_named(word)), {}, {}};
}

const viz::Format& format_for(const std::string& file) {
  const viz::Format* const format = viz::format_of(file);
  if (!format || format->film)
    throw viz::BadInput(fmt::format("out: \"{}\" does not end in the name of a format: {}", file,
                                    spelling::listed(viz::still_format_names())));
  return *format;
}

/// `word`: the theme as it was asked for.
void write_swatch(const Program& program, const std::string& word, const viz::OwnTheme& own, const std::string& file) {
  const viz::Format& format = format_for(file);
  if (!may_be_replaced(file, [&](const std::string&) { return metadata_in(file).contains(swatch_key); }))
    throw viz::FileError(fmt::format(
        "cannot write '{}': the file there is no swatch of isect's; move it away, or give another name", file));
  StyleOptions options;
  options.format = format.name, options.theme = word, options.width = swatch_width;
  const Style style = style_of(options);  // sets the font
  need_environment(program);
  FigureMaker maker(style, "auto");
  FigureInfo info;
  info.imprint = "Theme " + own.name;
  info.alt = theme_table(own);
  info.metadata = {{swatch_key, own.name}, {"version", viz::version()}};
  viz::write_file(file, maker.write(info, theme_swatch(own, style.paper->width), format));
  print(file + "\n");
}

int check_and_show(const Program& program, const ThemeOptions& options) {
  if (options.theme.empty())
    throw viz::BadInput("theme: none given; give a file, or one of " + spelling::listed(viz::theme_names()));
  ReadTheme read = read_named(options.theme);
  for (const std::string& fault : read.faults)
    say(fmt::format("{}: theme: {}: {}", program.name, options.theme, fault));
  if (!read.faults.empty()) return bad_input;
  for (const std::string& note : read.notes) say(note);
  if (options.json && !is_theme_file(options.theme)) read.theme.name = "my " + read.theme.name;  // none is "print"
  if (!options.out.empty())
    write_swatch(program, options.theme, read.theme, options.out);
  else
    print(options.json ? theme_text_by_lines(read.theme) : theme_table(read.theme));
  return done;
}

}  // namespace

void add_theme(CLI::App& app, Program& program) {
  CLI::App& sub = *app.add_subcommand("theme", "checks a theme of your own, and draws a swatch of it");
  const auto options = std::make_shared<ThemeOptions>();
  sub.add_option("THEME", options->theme, "its file, or screen, print, grey or dark")->type_name("");
  CLI::Option* const out = add_path(sub, "--out", options->out,
                                    "draws every role as usual, as colour-blind readers see it, and in\ngrey", "FILE");
  sub.add_flag("--json", options->json, "all its values, as a file to begin your own with")->excludes(out);
  sub.footer(
      "Whatever takes --theme takes a file in JSON: {\"based on\": \"print\", \"roles\": {\"highlight\": "
      "\"#f6a800\"}}.\n"
      "What it leaves out is as in the theme it is based on, or as in print. Roles:\n" +
      wrapped(spelling::listed(viz::colour_names()), 100, 2) +
      "It may have \"name\"; \"font\", a family; \"hatch\": true, for the second object; and \"lines\", a factor for\n"
      "all lines or widths in points on paper, {\"ray\": 1}. Of two colours, {\"colors\": [\"#00549f\", "
      "\"#f6a800\"]},\n"
      "isect makes those of first, second, hit and miss. A theme that some could not read is refused, with what to\n"
      "change: labels need a contrast of 4.5 to 1, plain text of 7, and the four roles differ for colour-blind\n"
      "readers, too. Figures carry the theme's values: render FIGURE needs no file of it.\n"
      "Example: " +
      program.name + " theme mine.json --out swatch.png");
  sub.callback(
      [&program, options] { program.chosen = [&program, options] { return check_and_show(program, *options); }; });
}

}  // namespace isect::program
