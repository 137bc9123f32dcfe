#pragma once
// Drawings as TikZ pictures, for LaTeX to set.

#include "viz/drawing.h"
#include "viz/formats/files.h"

namespace isect::viz {

/// Returns a `tikzpicture` for \input, in ASCII except for its comments; metadata in its first line, as a comment in
/// JSON. LaTeX sets the labels where their middles were, in the document's font and size. Same input, same bytes.
std::string tikz(const Drawing&, const Metadata& = {}, const Imprint& = {});
/// Reads our metadata; empty if there is none. Throws FileError on anything that is no TikZ picture.
Metadata tikz_metadata(const std::string& bytes);

}  // namespace isect::viz
