// Drawings as SVG through cairo.

#include <cairo-svg.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "viz/files.h"
#include "viz/typeset.h"

namespace isect::viz {
namespace {

/// cairo writes glyph outlines and paths in fixed point. The surface is this much larger than the drawing, so
/// that their steps stay below 1/500 of a unit; the view box undoes it.
constexpr double oversize = 8;

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

/// Lines x + y = k gap sqrt 2 through the path's box, clipped to the path. They hang on the drawing's origin,
/// so that the hatches of neighbours go on in each other.
void hatch(cairo_t* cr, const Fill& fill) {
  double left, top, right, bottom;
  trace(cr, fill);
  cairo_path_extents(cr, &left, &top, &right, &bottom);
  if (!(right > left && bottom > top)) return;
  cairo_save(cr);
  cairo_clip(cr);
  const double step = fill.hatch_gap * std::sqrt(2.0);
  for (double k = std::ceil((left + top) / step); k * step <= right + bottom; ++k) {
    cairo_move_to(cr, left, k * step - left);
    cairo_line_to(cr, right, k * step - right);
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

void draw(cairo_t* cr, const Text& text) { TypesetLine(text).draw(cr, TypesetLine::As::glyphs); }

std::string cairo_svg(const Drawing& drawing) {
  std::string bytes;
  const auto append = [](void* out, const unsigned char* data, unsigned length) {
    static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  };
  cairo_surface_t* surface =
      cairo_svg_surface_create_for_stream(append, &bytes, drawing.width * oversize, drawing.height * oversize);
  cairo_svg_surface_restrict_to_version(surface, CAIRO_SVG_VERSION_1_1);
  cairo_t* cr = cairo_create(surface);
  cairo_scale(cr, oversize, oversize);
  set_source(cr, drawing.background);
  cairo_rectangle(cr, 0, 0, drawing.width, drawing.height);
  cairo_fill(cr);
  for (const Shape& shape : drawing.shapes) std::visit([cr](const auto& s) { draw(cr, s); }, shape);
  const cairo_status_t drawn = cairo_status(cr);
  cairo_destroy(cr);
  cairo_surface_finish(surface);
  const cairo_status_t written = cairo_surface_status(surface);
  cairo_surface_destroy(surface);
  if (drawn != CAIRO_STATUS_SUCCESS || written != CAIRO_STATUS_SUCCESS)
    throw FileError(std::string("cannot write SVG: ") + cairo_status_to_string(drawn ? drawn : written));
  return bytes;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// cairo numbers its surfaces by a counter of the whole process. Here every id is numbered anew, in the order
/// of appearance, with the references to it: same drawing, same bytes, whatever was drawn before.
std::string with_own_ids(const std::string& bytes) {
  constexpr std::pair<std::string_view, char> marks[] = {{" id=\"", '"'}, {"\"#", '"'}, {"url(#", ')'}};
  std::map<std::string, std::string> renamed;
  std::string out;
  for (std::size_t i = 0; i < bytes.size();) {
    const auto mark = std::find_if(std::begin(marks), std::end(marks),
                                   [&](const auto& m) { return bytes.compare(i, m.first.size(), m.first) == 0; });
    const std::size_t begin = mark == std::end(marks) ? bytes.npos : i + mark->first.size();
    const std::size_t end = begin == bytes.npos ? begin : bytes.find(mark->second, begin);
    if (end == bytes.npos) {
      out += bytes[i++];
      continue;
    }
    const std::string fresh = fmt::format("i{}", renamed.size());
    out += mark->first;
    out += renamed.try_emplace(bytes.substr(begin, end - begin), fresh).first->second;
    i = end;
  }
  return out;
}

/// As an attribute of the root: Inkscape, SVGO and scour keep it, whereas most that make a file small drop a <metadata>
/// element. JSON in ASCII, escaped for XML: control characters and broken UTF-8 never leave JSON's own escapes.
std::string metadata_attribute(const Metadata& metadata) {
  std::string json = nlohmann::json(metadata).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  replace_all(json, "&", "&amp;");
  replace_all(json, "<", "&lt;");
  replace_all(json, ">", "&gt;");
  replace_all(json, "'", "&apos;");
  return fmt::format("data-isect='{}'", json);
}

}  // namespace

std::string svg(const Drawing& drawing, const Metadata& metadata, Paper paper) {
  if (!(drawing.width > 0 && drawing.height > 0 && std::isfinite(drawing.width * drawing.height)))
    throw FileError(fmt::format("cannot write SVG: a drawing of {} x {}", drawing.width, drawing.height));
  std::string bytes = with_own_ids(cairo_svg(drawing));
  const std::size_t tag = bytes.find("<svg ");
  const std::size_t tag_end = bytes.find('>', tag);
  if (tag == bytes.npos || tag_end == bytes.npos) throw FileError("cannot write SVG: cairo wrote no <svg> element");

  const double scale = paper.width_pt > 0 ? paper.width_pt / drawing.width : 1;
  const char* const unit = paper.width_pt > 0 ? "pt" : "";  // without one: CSS pixels
  const std::string opening = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
      "version=\"1.1\" "
      "width=\"{:.7g}{}\" height=\"{:.7g}{}\" viewBox=\"0 0 {:.7g} {:.7g}\" {}>",
      drawing.width * scale, unit, drawing.height * scale, unit, drawing.width * oversize, drawing.height * oversize,
      metadata_attribute(metadata));
  bytes.replace(tag, tag_end + 1 - tag, opening);
  return bytes;
}

}  // namespace isect::viz
