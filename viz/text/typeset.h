#pragma once
// One line of markup laid out by Pango: it knows its extents and draws itself on a cairo context.
//
// Measuring, pixels and vector files all go through here, so that they agree. Lines are laid out once at a
// large size, unhinted, and scaled: extents are proportional to the size, and the same at every resolution.

#include <memory>
#include <string>

#include "viz/drawing.h"

struct _cairo;
struct _PangoLayout;

namespace isect::viz {

struct LayoutDeleter {
  void operator()(_PangoLayout*) const;
};
using Layout = std::unique_ptr<_PangoLayout, LayoutDeleter>;

/// Makes a layout of Pango markup in `family` with an em of `em` device units.
Layout make_layout(const std::string& pango_markup, const std::string& family, double em, bool bold);

/// Sets the colour of what is drawn next on a cairo context.
void set_source(_cairo*, const Colour&);

/// A line of markup at an em of `reference_em`, from its start on the baseline.
struct Extents {
  TextBox ink = {};
  double advance = 0;
};

/// Returns the box of a text's ink, as TypesetLine computes it. A line that was measured before is not laid out again.
TextBox ink_box(const Text&);

class TypesetLine {
 public:
  explicit TypesetLine(const Text&);

  bool empty() const;                      ///< no ink
  TextBox box() const;                     ///< of the ink, in the drawing's units, halo excluded
  double start() const { return start_; }  ///< x where it begins
  std::vector<Path> outlines() const;      ///< of its letters, in the drawing's units, without the halo
  enum class As { outlines, glyphs };
  /// Draws the line: `outlines` are placed exactly, `glyphs` are a font's letters for readers of the file.
  void draw(_cairo*, As) const;

 private:
  Text text_;
  Layout layout_;
  double scale_ = 1;  ///< the drawing's units per unit of the layout
  Extents extents_;
  double start_ = 0;  ///< x of the line's start in the drawing
};

}  // namespace isect::viz
