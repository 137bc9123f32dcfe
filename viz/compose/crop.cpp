#include "viz/compose/crop.h"

#include <algorithm>
#include <cmath>

#include "viz/text/text.h"

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

std::vector<Drawing> cropped(std::vector<Drawing> drawings, double margin) {
  if (drawings.empty()) return drawings;
  TextBox ink = ink_box(drawings.front());
  for (const Drawing& drawing : drawings) {
    const TextBox own = ink_box(drawing);
    ink = {std::min(ink.left, own.left), std::min(ink.top, own.top), std::max(ink.right, own.right),
           std::max(ink.bottom, own.bottom)};
  }
  const double width = drawings.front().width, height = drawings.front().height;
  const double left = ink.left > 0 ? ink.left - margin : 0, right = ink.right < width ? ink.right + margin : width;
  const double top = ink.top > 0 ? ink.top - margin : 0, bottom = ink.bottom < height ? ink.bottom + margin : height;
  for (Drawing& part : drawings) {
    part.width = right - left, part.height = bottom - top;
    for (Shape& shape : part.shapes) move(shape, {-left, -top});
  }
  return drawings;
}

Drawing cropped(const Drawing& drawing, double margin) { return cropped(std::vector{drawing}, margin).front(); }

Drawing centred(Drawing drawing, double width, double height) {
  const Vec2 by((width - drawing.width) / 2, (height - drawing.height) / 2);
  if (!by.isZero(0))
    for (Shape& shape : drawing.shapes) move(shape, by);
  drawing.width = width, drawing.height = height;
  return drawing;
}

}  // namespace isect::viz
