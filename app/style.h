#pragma once
// How figures look: what `render` and its relatives take as options, and what comes of it.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/values.h"
#include "viz/compose.h"
#include "viz/formats.h"
#include "viz/theme.h"

namespace isect::program {

/// As written on the command line; empty: not given.
struct StyleOptions {
  std::string format = viz::formats().front().name;
  std::string theme, size, width, height, text_size, dpi, labels, font;
  bool no_title = false, crop = false, transparent = false;
  std::string columns;  ///< of a strip
  bool captions = false;
};
/// What a figure carries inside of how it was asked for, to be drawn anew: {"theme":"print","width":"8cm"}.
std::string words_of(const StyleOptions&);
/// Takes from such words what was not asked for otherwise. Throws viz::BadInput.
void fill_in(StyleOptions&, const std::string& words);
void add_style(CLI::App&, StyleOptions&, const std::vector<std::string>& formats);

/// What every figure of a run shares.
struct Style {
  std::vector<const viz::Format*> formats;
  viz::ThemeName theme = viz::ThemeName::screen;
  Size size;                                                      ///< in pixels
  std::optional<viz::PaperSize> paper;                            ///< in place of the size
  enum class Sides { width, height, both } sides = Sides::width;  ///< of the paper, that were given
  double dpi = 0;                                                 ///< of pixels on paper
  viz::Imprint::Letters letters = viz::Imprint::Letters::as_usual;
  bool title = true, crop = false, transparent = false;
  std::string words;  ///< for whoever draws it anew
};
/// Throws viz::BadInput, naming the option, and viz::NoBackend where a format wants a program that is not here.
Style style_of(const StyleOptions&);

}  // namespace isect::program
