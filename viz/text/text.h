#pragma once
// Text shaped by Pango and drawn by cairo: measured for layout, as pixels for OpenGL, as glyphs for vector
// files.

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "viz/drawing.h"

namespace isect::viz {

/// RGBA, 8 bits a channel, not premultiplied, rows from the top.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Returns the box that a Text covers in its drawing's units, halo excluded.
TextBox measure(const Text&);
/// Makes a long line smaller if it is wider than `most`. Returns its box then.
TextBox fit_width(Text&, double most);

/// Breaks words of markup into as few lines as fit into `room`; a word wider than that gets a line of its own. Words
/// under one mark stay on one line, and no line begins with = or another relation.
std::vector<std::string> wrapped(const std::string& markup, double size, bool bold, double room);

/// A Text as pixels at `scale` pixels per unit, with the position of its top left corner in the drawing.
/// Colours are straight alpha. Empty text gives an empty picture.
struct Rastered {
  Picture picture;
  Vec2 corner;
};
Rastered raster(const Text&, double scale);

/// Wrapped text for the window's panels: DejaVu Sans with STIX for the mathematics (18 px inline on 15 px
/// text).
struct Paragraph {
  std::string markup;      ///< '\n' separates paragraphs
  double width = 0;        ///< wrap width in px; <= 0: one line
  double size = 15;        ///< px
  double line_pitch = 23;  ///< px from baseline to baseline; 0.3 of it more between paragraphs
  bool bold = false;
  bool math = false;  ///< a formula: STIX throughout
  Colour colour;
};
/// Draws a paragraph `width` px wide (as wide as its text on one line); each line is one pitch high, with capitals in
/// the middle of it.
Picture raster(const Paragraph&, double scale = 1);
/// Returns the pixels across and down of that picture, without drawing it.
Vec2 extent(const Paragraph&, double scale = 1);

/// Where a name (viz/text/names.h) stands in a paragraph, in px from its top left corner.
struct NameBox {
  std::string key;
  TextBox box;
};
std::vector<NameBox> name_boxes(const Paragraph&);

/// Families used, found by fontconfig: {"STIXGeneral" or a named substitute, "DejaVu Sans"}.
struct Fonts {
  std::string figure, window;
  bool exact = true;
};
/// Thrown if no font is installed at all, so that nothing with letters can be drawn.
struct NoFonts : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// Returns the families; all code that sets a text calls this first. Throws NoFonts.
Fonts fonts();
/// Sets figures in this family from now on; call it before any text is measured. Throws BadInput, with the nearest
/// name, if fontconfig has none of this name.
void use_figure_font(const std::string& family);

}  // namespace isect::viz
