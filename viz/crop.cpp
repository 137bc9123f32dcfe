#include "viz/crop.h"

#include <algorithm>
#include <cmath>

#include "viz/text.h"

namespace isect::viz {
namespace {

struct Ink {
  Vec2 lo = Vec2::Constant(INFINITY), hi = Vec2::Constant(-INFINITY);

  void grow(const Path& path, double by = 0) {
    for (const Vec2& p : flatten(path)) grow(p, by);
  }
  void grow(const Vec2& p, double by = 0) {
    lo = lo.cwiseMin((p.array() - by).matrix());
    hi = hi.cwiseMax((p.array() + by).matrix());
  }

  void operator()(const Fill& fill) {
    grow(fill.path);
    for (const Path& path : fill.more) grow(path);
  }
  void operator()(const Stroke& stroke) { grow(stroke.path, stroke.width / 2); }
  void operator()(const Gradient& g) { grow(ellipse(g.center, g.major, g.minor)); }
  void operator()(const Text& text) {
    const TextBox box = measure(text);
    grow({box.left, box.top}, text.halo);
    grow({box.right, box.bottom}, text.halo);
  }
  void operator()(const Facets& facets) {
    for (const Vec2& p : facets.corners) grow(p, facets.seam / 2);
  }
};

}  // namespace

TextBox ink_box(const Drawing& drawing) {
  Ink ink;
  for (const Shape& shape : drawing.shapes) std::visit(ink, shape);
  const TextBox box = {std::max(ink.lo.x(), 0.0), std::max(ink.lo.y(), 0.0), std::min(ink.hi.x(), drawing.width),
                       std::min(ink.hi.y(), drawing.height)};
  if (box.right > box.left && box.bottom > box.top) return box;
  return {0, 0, drawing.width, drawing.height};
}

Drawing cropped(const Drawing& drawing, double margin) {
  const TextBox ink = ink_box(drawing);
  const double left = std::max(ink.left - margin, 0.0), top = std::max(ink.top - margin, 0.0);
  Drawing part = drawing;
  part.width = std::min(ink.right + margin, drawing.width) - left;
  part.height = std::min(ink.bottom + margin, drawing.height) - top;
  for (Shape& shape : part.shapes) move(shape, {-left, -top});
  return part;
}

}  // namespace isect::viz
