// The faces of a TikZ picture, as a picture of their own: LaTeX places it in no time, and thousands of paths in
// seconds.

#include "viz/formats/tikz.h"

namespace isect::viz {

std::size_t count_faces(const Drawing& drawing) {
  std::size_t faces = 0;
  for (const Shape& shape : drawing.shapes)
    if (const Facets* mesh = std::get_if<Facets>(&shape)) faces += mesh->colours.size();
  return faces;
}

FacesSpan faces_span(const Drawing& drawing) {
  FacesSpan span;
  for (std::size_t i = 0; i < drawing.shapes.size(); ++i) {
    if (!std::holds_alternative<Facets>(drawing.shapes[i])) continue;
    if (span.to == 0) span.from = i;
    span.to = i + 1;
  }
  // A mesh's sharp edges may be as many as its faces.
  const auto is_of_mesh = [&](const Shape& shape) {
    return object_of(shape) != no_object && object_of(shape) == object_of(drawing.shapes[span.to - 1]);
  };
  while (span.to > 0 && span.to < drawing.shapes.size() && is_of_mesh(drawing.shapes[span.to])) ++span.to;
  return span;
}

std::string tikz_faces(const Drawing& drawing, const Metadata& metadata, const Imprint& imprint) {
  const FacesSpan span = faces_span(drawing);
  Drawing faces = {drawing.width, drawing.height, drawing.background.with_alpha(0), {}, drawing.objects};
  for (std::size_t i = span.from; i < span.to; ++i)
    if (!std::holds_alternative<Text>(drawing.shapes[i])) faces.shapes.push_back(drawing.shapes[i]);
  return pdf(faces, metadata, imprint);
}

}  // namespace isect::viz
