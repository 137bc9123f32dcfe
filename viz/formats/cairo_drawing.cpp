#include "viz/formats/cairo_drawing.h"

#include <cairo.h>

#include <cmath>

#include "viz/formats/hatch.h"

namespace isect::viz {
namespace {

void add_outline(cairo_t* cr, const Path& path) {
  cairo_move_to(cr, path.start.x(), path.start.y());
  for (const Path::Segment& segment : path.segments) {
    if (const Vec2* to = std::get_if<Vec2>(&segment)) {
      cairo_line_to(cr, to->x(), to->y());
    } else {
      const auto& [a, b, end] = std::get<Path::Cubic>(segment);
      cairo_curve_to(cr, a.x(), a.y(), b.x(), b.y(), end.x(), end.y());
    }
  }
  if (path.closed) cairo_close_path(cr);
}

void trace(cairo_t* cr, const Path& path) {
  cairo_new_path(cr);
  add_outline(cr, path);
}

void trace(cairo_t* cr, const Fill& fill) {
  trace(cr, fill.path);
  for (const Path& path : fill.more) add_outline(cr, path);
  cairo_set_fill_rule(cr, fill.more.empty() ? CAIRO_FILL_RULE_WINDING : CAIRO_FILL_RULE_EVEN_ODD);
}

void hatch(cairo_t* cr, const Fill& fill) {
  cairo_save(cr);
  trace(cr, fill);
  cairo_clip(cr);
  for (const auto& [from, to] : hatch_lines(fill)) {
    cairo_move_to(cr, from.x(), from.y());
    cairo_line_to(cr, to.x(), to.y());
  }
  cairo_set_line_width(cr, fill.hatch_line);
  cairo_set_line_cap(cr, CAIRO_LINE_CAP_BUTT);
  cairo_set_dash(cr, nullptr, 0, 0);
  set_source(cr, fill.hatch_colour);
  cairo_stroke(cr);
  cairo_restore(cr);
}

void draw(cairo_t* cr, const Fill& fill) {
  trace(cr, fill);
  set_source(cr, fill.colour);
  cairo_fill(cr);
  if (fill.hatch_gap > 0 && fill.hatch_line > 0) hatch(cr, fill);
}

void draw(cairo_t* cr, const Stroke& stroke) {
  trace(cr, stroke.path);
  cairo_set_line_width(cr, stroke.width);
  cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(cr, stroke.round_cap ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  const bool dashed = stroke.dash[0] > 0 && stroke.dash[1] > 0;
  cairo_set_dash(cr, stroke.dash.data(), dashed ? 2 : 0, 0);
  set_source(cr, stroke.colour);
  cairo_stroke(cr);
}

/// The ellipse is the unit circle seen through the matrix (major, minor, center).
void draw(cairo_t* cr, const Gradient& gradient) {
  const Vec2& major = gradient.major;
  const Vec2& minor = gradient.minor;
  if (!(major.squaredNorm() > 0 && minor.squaredNorm() > 0)) return;  // no area; cairo refuses such a matrix
  const Vec2 towards = gradient.focus - gradient.center;
  Vec2 focus(towards.dot(major) / major.squaredNorm(), towards.dot(minor) / minor.squaredNorm());
  if (focus.norm() > 0.99) focus *= 0.99 / focus.norm();

  cairo_pattern_t* pattern = cairo_pattern_create_radial(focus.x(), focus.y(), 0, 0, 0, 1);
  const auto add_stop = [pattern](double at, const Colour& c) {
    cairo_pattern_add_color_stop_rgba(pattern, at, c.r, c.g, c.b, c.a);
  };
  add_stop(0, gradient.inner);
  add_stop(1, gradient.outer);
  cairo_matrix_t matrix;
  cairo_matrix_init(&matrix, major.x(), major.y(), minor.x(), minor.y(), gradient.center.x(), gradient.center.y());
  if (cairo_matrix_invert(&matrix) == CAIRO_STATUS_SUCCESS) cairo_pattern_set_matrix(pattern, &matrix);

  trace(cr, ellipse(gradient.center, gradient.major, gradient.minor));
  cairo_set_source(cr, pattern);
  cairo_fill(cr);
  cairo_pattern_destroy(pattern);
}

void draw(cairo_t* cr, const Text& text, TypesetLine::As letters) { TypesetLine(text).draw(cr, letters); }
void draw(cairo_t* cr, const auto& shape, TypesetLine::As) { draw(cr, shape); }
void draw(cairo_t* cr, const Facets& facets, TypesetLine::As letters) {
  for (const Shape& shape : expanded(facets)) std::visit([&](const auto& s) { draw(cr, s, letters); }, shape);
}

}  // namespace

void draw(cairo_t* cr, const Drawing& drawing, TypesetLine::As letters) {
  if (drawing.background.a > 0) {
    set_source(cr, drawing.background);
    cairo_rectangle(cr, 0, 0, drawing.width, drawing.height);
    cairo_fill(cr);
  }
  for (const Shape& shape : drawing.shapes) std::visit([&](const auto& s) { draw(cr, s, letters); }, shape);
}

}  // namespace isect::viz
