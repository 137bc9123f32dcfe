#pragma once
// The formats of a figure: one table. To add one, write one row.

#include <functional>
#include <string>
#include <vector>

#include "viz/drawing.h"
#include "viz/formats/animation.h"
#include "viz/formats/files.h"
#include "viz/text/text.h"

namespace isect::viz {

/// A function that draws pixels, with whichever OpenGL there is.
using Rasteriser = std::function<Picture(const Drawing&)>;

/// Draws a drawing as pixels, see-through where the drawing has no ground.
Picture pixels_of(const Drawing&, const Rasteriser&);

struct Format {
  std::string name;  ///< lower case; a file's extension too
  bool pixels;  ///< drawn by the rasteriser, so without a width on paper; otherwise by cairo, and no OpenGL is asked
  /// Writes one drawing; null where `film` is set.
  std::string (*write)(const Drawing&, const Metadata&, const Imprint&, const Rasteriser&);
  Metadata (*metadata)(const std::string& bytes);  ///< what `write` was given; empty: not isect's. Throws FileError
  /// Writes several steps into one file, in their timing.
  std::string (*film)(const std::vector<Picture>&, const Timing&, const Metadata&, const Imprint&) = nullptr;
  bool (*can_write)() = nullptr;  ///< whether the program that it needs is here; null: it needs none
  const char* program = "";       ///< its name, and that of its package
};

/// Returns all formats; the first is the default.
const std::vector<Format>& formats();
std::vector<std::string> format_names();
/// Returns the names of the formats that hold one drawing.
std::vector<std::string> still_format_names();
/// Returns the format. Throws BadInput, which names all of them.
const Format& format_named(const std::string& name);
/// Finds a format by the extension of a file's name; null for a file that is no figure.
const Format* format_of(const std::string& file);

}  // namespace isect::viz
