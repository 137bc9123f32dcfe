#pragma once
// The formats of a figure: one table. To add one, write one row.

#include <functional>
#include <string>
#include <vector>

#include "viz/drawing.h"
#include "viz/files.h"
#include "viz/text.h"

namespace isect::viz {

/// A drawing as pixels: by whichever OpenGL there is.
using Rasteriser = std::function<Picture(const Drawing&)>;

/// With see-through pixels where the drawing has no ground.
Picture pixels_of(const Drawing&, const Rasteriser&);

struct Format {
  std::string name;  ///< lower case; a file's extension too
  bool pixels;  ///< drawn by the rasteriser, so without a width on paper; otherwise by cairo, and no OpenGL is asked
  /// Of one drawing; none where `film` is.
  std::string (*write)(const Drawing&, const Metadata&, const Imprint&, const Rasteriser&);
  Metadata (*metadata)(const std::string& bytes);  ///< what `write` was given; empty: not isect's. Throws FileError
  /// Of several steps in one file, each shown for so many seconds.
  std::string (*film)(const std::vector<Picture>&, double seconds, const Metadata&, const Imprint&) = nullptr;
  bool (*can_write)() = nullptr;  ///< whether the program that it needs is here; null: it needs none
  const char* program = "";       ///< its name, and that of its package
};

/// All of them; the first is the default.
const std::vector<Format>& formats();
std::vector<std::string> format_names();
/// Those of one drawing.
std::vector<std::string> still_format_names();
/// Throws BadInput, which names all of them.
const Format& format_named(const std::string& name);
/// By the extension of a file's name; none for a file that is no figure.
const Format* format_of(const std::string& file);

}  // namespace isect::viz
