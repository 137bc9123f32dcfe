#include "app/figures/style.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/figures/theme_choice.h"
#include "viz/gl/offscreen.h"
#include "viz/lesson.h"

namespace isect::program {

namespace {

using Letters = viz::Imprint::Letters;

/// The ratio of width to height of a picture for the screen.
constexpr double usual_shape = 1.6;
constexpr double usual_dpi = 300;
/// LaTeX's own letters are as wide at 10 pt as ours at 11.
constexpr double usual_tex_size = 11;
/// The width of figures for paper only.
constexpr const char* usual_width = "8cm";

bool is_tikz(const viz::Format* format) { return format->name == "tikz"; }
bool is_opaque(const viz::Format* format) { return format->name == "gif" || format->name == "mp4"; }

/// Returns how labels are set; LaTeX sets those of TikZ, and no others.
Letters letters_of(const std::string& labels, const std::vector<const viz::Format*>& formats) {
  if (labels.empty()) return Letters::as_usual;
  if (labels == "tex" && std::ranges::all_of(formats, is_tikz)) return Letters::as_usual;
  if (labels == "tex") throw viz::BadInput("labels: tex is for --format tikz; svg and pdf take text or outline");
  if (labels != "text" && labels != "outline") throw viz::unknown("labels", labels, {"text", "outline", "tex"});
  if (std::ranges::any_of(formats, is_tikz))
    throw viz::BadInput(fmt::format("labels: those of tikz are set by LaTeX (tex); {} is for svg and pdf", labels));
  return labels == "text" ? Letters::glyphs : Letters::outlines;
}

/// Calls `take` for the options that make a figure look as it does, by name, whatever its format.
template <class Options, class Take>
void each_kept(Options& options, const Take& take) {
  take("theme", options.theme), take("size", options.size), take("width", options.width);
  take("height", options.height), take("text-size", options.text_size), take("font", options.font);
  take("columns", options.columns);
}
template <class Options, class Take>
void each_kept_flag(Options& options, const Take& take) {
  take("no-title", options.no_title), take("crop", options.crop), take("transparent", options.transparent);
  take("captions", options.captions);
}

viz::PaperSize paper_of(const StyleOptions& options) {
  viz::PaperSize paper;
  if (!options.width.empty()) paper.width = points_of("width", options.width);
  if (!options.height.empty()) paper.height = points_of("height", options.height);
  if (options.width.empty()) paper.width = usual_shape * paper.height;
  if (!options.text_size.empty()) paper.text_size = points_of("text-size", options.text_size, 4, 200);
  return paper;
}

}  // namespace

std::string words_of(const StyleOptions& options) {
  nlohmann::ordered_json words = nlohmann::ordered_json::object();
  each_kept(options, [&](const char* name, const std::string& value) {
    const bool is_json = name == std::string("theme") && value.starts_with('{');
    if (!value.empty()) words[name] = is_json ? nlohmann::ordered_json::parse(value) : nlohmann::ordered_json(value);
  });
  each_kept_flag(options, [&](const char* name, bool value) {
    if (value) words[name] = true;
  });
  return words.dump();
}

void fill_in(StyleOptions& options, const std::string& text) {
  const auto words = nlohmann::json::parse(text, nullptr, false);
  if (!words.is_object()) throw viz::BadInput(fmt::format("style: the figure says {}, which is no JSON object", text));
  const StyleOptions asked = options;
  const bool sized = !options.size.empty() || !options.width.empty() || !options.height.empty();
  each_kept(options, [&](const std::string& name, std::string& value) {
    const bool of_size = name == "size" || name == "width" || name == "height";
    const bool of_paper = name == "text-size" && !options.size.empty();
    if (!value.empty() || (sized && of_size) || of_paper) return;
    const auto found = words.find(name);
    if (found == words.end()) return;
    if (found->is_string()) value = *found;
    if (found->is_object() && name == "theme") value = found->dump();
  });
  each_kept_flag(options, [&](const char* name, bool& value) {
    if (const auto found = words.find(name); found != words.end()) value = value || *found == true;
  });
  const std::vector<const viz::Format*> formats = formats_of(options.format);  // some formats do not take these
  if (std::ranges::all_of(formats, is_tikz)) options.font = asked.font;
  if (std::ranges::any_of(formats, is_opaque)) options.transparent = asked.transparent;
}

bool is_set_by_tex(const StyleOptions& options) { return std::ranges::all_of(formats_of(options.format), is_tikz); }

std::string font_of(const StyleOptions& options) {
  if (!options.font.empty()) return options.font;
  if (options.theme.empty() || std::ranges::all_of(formats_of(options.format), is_tikz)) return {};
  const viz::ThemeChoice theme = theme_choice(options.theme);
  return theme.own() ? theme.own()->font : std::string();
}

Style style_of(const StyleOptions& options) {
  const bool on_paper = !options.width.empty() || !options.height.empty();
  if (!options.size.empty() && on_paper)
    throw viz::BadInput("size: give either --size (pixels) or --width and --height (on paper), not both");
  for (const auto& [name, given] : {std::pair{"text-size", &options.text_size}, std::pair{"dpi", &options.dpi}})
    if (!on_paper && !given->empty())
      throw viz::BadInput(fmt::format("{}: holds of figures on paper; give their --width, such as 8cm", name));
  Style style;
  style.formats = formats_of(options.format);
  if (!options.theme.empty()) style.theme = theme_choice(options.theme);
  if (!options.size.empty()) style.size = size_of(options.size);
  if (on_paper) style.paper = paper_of(options), style.dpi = usual_dpi;
  if (options.width.empty() && on_paper) style.sides = Style::Sides::height;
  if (!options.width.empty() && !options.height.empty()) style.sides = Style::Sides::both;
  if (!on_paper && options.size.empty() && std::ranges::all_of(style.formats, is_tikz))
    style.paper = viz::PaperSize{points_of("width", usual_width), 0}, style.dpi = usual_dpi;
  if (style.paper && options.text_size.empty() && std::ranges::all_of(style.formats, is_tikz))
    style.paper->text_size = usual_tex_size;
  if (!options.dpi.empty()) style.dpi = dpi_of(options.dpi);
  style.letters = letters_of(options.labels, style.formats);
  if (!options.font.empty() && std::ranges::all_of(style.formats, is_tikz))
    throw viz::BadInput("font: LaTeX sets the labels of tikz, in the document’s own");
  if (const std::string font = font_of(options); !font.empty()) viz::use_figure_font(font);
  for (const viz::Format* format : style.formats)
    if (format->can_write && !format->can_write())
      throw viz::NoBackend(fmt::format(
          "format: {0} is written by {1}, which is not here; apt-get install {1}, or give --format gif or apng",
          format->name, format->program));
  for (const viz::Format* format : style.formats)
    if (options.transparent && is_opaque(format))
      throw viz::BadInput(
          fmt::format("transparent: {} has no half-transparent pixels; give --format apng", format->name));
  StyleOptions kept = options;
  if (style.theme.own()) kept.theme = theme_text(*style.theme.own());
  if (style.paper && !on_paper) kept.width = usual_width;
  if (style.paper)  // the same text for every way to write it
    for (const auto& [length, points] : {std::pair{&kept.width, style.paper->width},
                                         {&kept.height, style.paper->height},
                                         {&kept.text_size, style.paper->text_size}})
      if (!length->empty()) *length = in_points(points);
  style.words = words_of(kept);
  style.title = !options.no_title, style.crop = options.crop, style.transparent = options.transparent;
  return style;
}

void add_style(CLI::App& sub, StyleOptions& options, const std::vector<std::string>& formats) {
  sub.add_option("--format", options.format,
                 fmt::format("{} (if not given), {}; several are\njoined by commas", formats.front(),
                             fmt::join(formats.begin() + 1, formats.end(), ", ")))
      ->type_name("FORMAT");
  sub.add_option("--theme", options.theme,
                 "screen (if not given), print, grey, dark, or the file of one of\nyour own: see isect theme --help")
      ->type_name("THEME");
  sub.add_option("--size", options.size, "in pixels; 960x600 if not given")->type_name("WxH");
  sub.add_option("--width", options.width, "on paper: 8cm, 80mm, 227pt, 3in; texts\nkeep their size")
      ->type_name("LENGTH");
  sub.add_option("--height", options.height, "on paper; if not given, what the figure needs")->type_name("LENGTH");
  sub.add_option("--text-size", options.text_size,
                 "of the labels on paper; 9pt if not given (in tikz, the document\nhas the say)")
      ->type_name("LENGTH");
  sub.add_option("--dpi", options.dpi, "pixels an inch of a png on paper; 300 if not given")->type_name("N");
  sub.add_option("--labels", options.labels,
                 "text (as usual in pdf), outline (as usual in svg), or tex:\nLaTeX sets them (in tikz)")
      ->type_name("KIND");
  sub.add_option("--font", options.font, "the family of all letters, as fontconfig calls it; STIXGeneral if\nnot given")
      ->type_name("NAME");
  sub.add_flag("--no-title", options.no_title, "without the step's title");
  sub.add_flag("--crop", options.crop,
               "cut off what is empty all round, but for a small margin; what is\nleft has the --width asked for");
  sub.add_flag("--transparent", options.transparent, "without a ground");
}

}  // namespace isect::program
