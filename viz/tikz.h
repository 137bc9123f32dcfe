#pragma once
// Drawings as TikZ pictures, for LaTeX to set.

#include "viz/drawing.h"
#include "viz/files.h"

namespace isect::viz {

/// A `tikzpicture` to be input, in ASCII but for its comments; metadata in its first line, as a comment in JSON. Labels
/// are set by LaTeX where their middles were, in the document's font and size. Same input, same bytes.
std::string tikz(const Drawing&, const Metadata& = {}, const Imprint& = {});
/// Throws FileError on anything that is no TikZ picture; empty if it carries none of ours.
Metadata tikz_metadata(const std::string& bytes);

}  // namespace isect::viz
