#pragma once
// How figures look: the options of `render` and related commands, and the resulting style.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/shell/option_values.h"
#include "viz/compose/compose.h"
#include "viz/formats/formats.h"
#include "viz/theme.h"

namespace isect::program {

/// Options as written on the command line; empty: not given.
struct StyleOptions {
  std::string format = viz::formats().front().name;
  std::string theme;  ///< as theme_choice takes it; a figure carries the values of a theme of one's own
  std::string size, width, height, text_size, dpi, labels, font;
  bool no_title = false, crop = false, transparent = false;
  std::string columns;  ///< of a strip
  bool captions = false;
};
/// Returns the options that a figure carries inside, to be drawn again with them: {"theme":"print","width":"8cm"}.
std::string words_of(const StyleOptions&);
/// Fills in from such words what was not asked for otherwise. Throws viz::BadInput.
void fill_in(StyleOptions&, const std::string& words);
void add_style(CLI::App&, StyleOptions&, const std::vector<std::string>& formats);

/// Returns the family of letters that --font names, or the theme; empty: the usual one, and of TikZ the document's own.
/// Throws what theme_choice throws.
std::string font_of(const StyleOptions&);

/// Whether LaTeX sets all texts of the figures that are asked for, as in TikZ. Throws viz::BadInput.
bool is_set_by_tex(const StyleOptions&);

/// The style that every figure of a run shares.
struct Style {
  std::vector<const viz::Format*> formats;
  viz::ThemeChoice theme = viz::ThemeName::screen;
  Size size;                                                      ///< in pixels
  std::optional<viz::PaperSize> paper;                            ///< in place of the size
  enum class Sides { width, height, both } sides = Sides::width;  ///< sides of the paper that were given
  double dpi = 0;                                                 ///< of pixels on paper
  viz::Imprint::Letters letters = viz::Imprint::Letters::as_usual;
  bool title = true, crop = false, transparent = false;
  std::string words;  ///< to draw it again
};
/// Throws viz::BadInput, naming the option, and viz::NoBackend if a format needs a program that is missing.
Style style_of(const StyleOptions&);

}  // namespace isect::program
