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

/// With more faces than this a TikZ picture takes LaTeX seconds to set, unless they are a picture of their own.
constexpr std::size_t most_tikz_faces = 1000;
/// Returns the number of faces of all meshes in a drawing.
std::size_t count_faces(const Drawing&);
/// The shapes from the first mesh to the last and its edges, as indices; from == to: there is no mesh.
struct FacesSpan {
  std::size_t from = 0, to = 0;
};
FacesSpan faces_span(const Drawing&);
/// Returns that picture as PDF, as large as the drawing and without a ground: the shapes of the span, except for its
/// texts. A TikZ picture whose imprint names its file shows it in their place, and sets the labels over it.
std::string tikz_faces(const Drawing&, const Metadata& = {}, const Imprint& = {});

}  // namespace isect::viz
