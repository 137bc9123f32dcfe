// Drawings as SVG: plain paths in groups with the names of the objects, so that an editor shows which is which.

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "viz/formats/files.h"
#include "viz/formats/hatch.h"
#include "viz/formats/metadata_text.h"
#include "viz/formats/svg_path.h"
#include "viz/text/rich_text.h"
#include "viz/text/text.h"
#include "viz/text/typeset.h"

namespace isect::viz {
namespace {

/// Returns "label t₁" as "label-t1": every program understands ids in ASCII.
std::string ascii_id(const std::string& name) {
  std::string id;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto byte = static_cast<unsigned char>(name[i]);
    const auto next = [&](std::size_t n) { return i + n < name.size() ? static_cast<unsigned char>(name[i + n]) : 0; };
    if (std::isalnum(byte) && byte < 128) {
      id += name[i];
    } else if (byte == 0xE2 && next(1) == 0x82 && next(2) >= 0x80 && next(2) <= 0x89) {  // subscript digits
      id += static_cast<char>('0' + next(2) - 0x80);
    } else if (!id.empty() && id.back() != '-') {
      id += '-';
    }
  }
  while (id.ends_with('-')) id.pop_back();
  return id.empty() || !std::isalpha(static_cast<unsigned char>(id.front())) ? fmt::format("part-{}", id) : id;
}

class SvgWriter {
 public:
  SvgWriter(const Drawing& drawing, Imprint::Letters letters) : drawing_(drawing), letters_(letters) {}

  std::string write() {
    if (drawing_.background.a > 0)
      out_ +=
          fmt::format("<rect id=\"background\" width=\"{}\" height=\"{}\" style=\"{}\"/>\n", svg_number(drawing_.width),
                      svg_number(drawing_.height), svg_paint("fill", drawing_.background));
    const int objects = static_cast<int>(drawing_.objects.size());
    int open = no_object;
    for (const Shape& shape : drawing_.shapes) {
      const int own = object_of(shape), object = own < objects ? own : no_object;  // some drawings have no objects
      if (object != open) {
        if (open != no_object) out_ += "</g>\n";
        if (object != no_object) begin(object);
        open = object;
      }
      std::visit([this](const auto& s) { add(s); }, shape);
    }
    if (open != no_object) out_ += "</g>\n";
    return std::move(out_);
  }

 private:
  /// Begins a group of shapes that an object draws in a row; it may have more groups above other objects.
  void begin(int object) {
    const std::string name = full_name(drawing_.objects.at(static_cast<std::size_t>(object)));
    out_ += fmt::format("<g id=\"{}\" inkscape:label=\"{}\">\n", fresh_id(ascii_id(name)), xml_escaped(name));
  }

  std::string fresh_id(const std::string& wanted) {
    std::string id = wanted;
    for (int i = 2; !ids_.insert(id).second; ++i) id = fmt::format("{}-{}", wanted, i);
    return id;
  }

  void path(const std::string& d, const std::string& style) {
    out_ += fmt::format("<path d=\"{}\" style=\"{}\"/>\n", d, style);
  }

  void add(const Fill& fill) {
    std::string d = svg_path(fill.path);
    for (const Path& more : fill.more) d += fmt::format(" {}", svg_path(more));
    const std::string rule = fill.more.empty() ? "" : "fill-rule:evenodd;";
    path(d, svg_paint("fill", fill.colour) + rule);
    if (fill.hatch_gap > 0 && fill.hatch_line > 0) hatch(fill, d);
  }

  void hatch(const Fill& fill, const std::string& outline) {
    std::string lines;
    for (const auto& [from, to] : hatch_lines(fill))
      lines += fmt::format("{}{}", lines.empty() ? "" : " ", svg_path(polyline({from, to})));
    if (lines.empty()) return;
    const std::string clip = fresh_id("clip");
    out_ += fmt::format("<clipPath id=\"{}\"><path d=\"{}\"{}/></clipPath>\n", clip, outline,
                        fill.more.empty() ? "" : " style=\"clip-rule:evenodd;\"");
    out_ += fmt::format("<path clip-path=\"url(#{})\" d=\"{}\" style=\"fill:none;{}stroke-width:{};\"/>\n", clip, lines,
                        svg_paint("stroke", fill.hatch_colour), svg_number(fill.hatch_line));
  }

  void add(const Stroke& stroke) {
    std::string style = fmt::format("fill:none;{}stroke-width:{};stroke-linejoin:round;",
                                    svg_paint("stroke", stroke.colour), svg_number(stroke.width));
    if (stroke.round_cap) style += "stroke-linecap:round;";
    if (stroke.dash[0] > 0 && stroke.dash[1] > 0)
      style += fmt::format("stroke-dasharray:{},{};", svg_number(stroke.dash[0]), svg_number(stroke.dash[1]));
    path(svg_path(stroke.path), style);
  }

  /// The ellipse is the unit circle seen through the matrix (major, minor, center).
  void add(const Gradient& g) {
    if (!(g.major.squaredNorm() > 0 && g.minor.squaredNorm() > 0)) return;  // no area
    const Vec2 towards = g.focus - g.center;
    Vec2 focus(towards.dot(g.major) / g.major.squaredNorm(), towards.dot(g.minor) / g.minor.squaredNorm());
    if (focus.norm() > 0.99) focus *= 0.99 / focus.norm();
    const auto stop = [](int at, const Colour& c) {
      std::string style = fmt::format("stop-color:{};", hex_of(c));
      if (c.a < 1) style += fmt::format("stop-opacity:{};", svg_number(c.a));
      return fmt::format("<stop offset=\"{}\" style=\"{}\"/>", at, style);
    };
    const std::string id = fresh_id("gradient");
    out_ += fmt::format(
        "<radialGradient id=\"{}\" gradientUnits=\"userSpaceOnUse\" cx=\"0\" cy=\"0\" r=\"1\" fx=\"{}\" fy=\"{}\" "
        "gradientTransform=\"matrix({} {} {} {} {} {})\">{}{}</radialGradient>\n",
        id, svg_number(focus.x()), svg_number(focus.y()), svg_number(g.major.x()), svg_number(g.major.y()),
        svg_number(g.minor.x()), svg_number(g.minor.y()), svg_number(g.center.x()), svg_number(g.center.y()),
        stop(0, g.inner), stop(1, g.outer));
    path(svg_path(ellipse(g.center, g.major, g.minor)), fmt::format("fill:url(#{});", id));
  }

  void add(const Text& text) {
    const TypesetLine line(text);
    if (line.empty()) return;
    const std::string halo = text.halo > 0
                                 ? fmt::format("{}stroke-width:{};stroke-linejoin:round;",
                                               svg_paint("stroke", text.halo_colour), svg_number(2 * text.halo))
                                 : "";
    if (letters_ == Imprint::Letters::glyphs) {
      editable(text, line, halo);
      return;
    }
    const std::string d = svg_letters(line.outlines());
    if (!halo.empty()) path(d, fmt::format("fill:none;{}", halo));
    path(d, svg_paint("fill", text.colour));
  }

  void add(const Facets& facets) {
    for (const Shape& shape : expanded(facets)) std::visit([this](const auto& s) { add(s); }, shape);
  }

  /// Writes text that stays text. A script is moved to a line of its own height, and what follows is moved back.
  void editable(const Text& text, const TypesetLine& line, const std::string& halo) {
    const char* const anchor = text.align == 0.5 ? "middle" : text.align == 1 ? "end" : "start";
    const double x = text.align == 0.5 || text.align == 1 ? text.at.x() : line.start();
    std::string runs;
    double raised = 0;  // above the baseline
    for (const Run& run : parse_markup(text.markup)) {
      const bool base = run.script == Run::Script::base;
      const double rise = base ? 0 : (run.script == Run::Script::sub ? sub_rise : super_rise) * text.size;
      std::string style;
      if (run.italic) style += "font-style:italic;";
      if (run.bold) style += "font-weight:bold;";
      if (!base) style += fmt::format("font-size:{};", svg_number(script_size * text.size));
      const std::string shift = rise != raised ? fmt::format(" dy=\"{}\"", svg_number(raised - rise)) : "";
      raised = rise;
      runs += fmt::format("<tspan{}{}>{}</tspan>", shift, style.empty() ? "" : fmt::format(" style=\"{}\"", style),
                          xml_escaped(run.text));
    }
    const std::string under = halo.empty() ? "" : halo + "paint-order:stroke;";
    out_ += fmt::format(
        "<text x=\"{}\" y=\"{}\" xml:space=\"preserve\" text-anchor=\"{}\" style=\"font-family:'{}','STIX Two "
        "Text',STIX,serif;font-size:{};{}{}{}\">{}</text>\n",
        svg_number(x), svg_number(text.at.y()), anchor, xml_escaped(fonts().figure), svg_number(text.size),
        text.bold ? "font-weight:bold;" : "", svg_paint("fill", text.colour), under, runs);
  }

  const Drawing& drawing_;
  const Imprint::Letters letters_;
  std::string out_;
  std::set<std::string> ids_ = {"background", "title", "alt"};
};

/// Returns an attribute of the root: Inkscape, SVGO and scour keep it, whereas most that make a file small drop a
/// <metadata> element. JSON in ASCII, escaped for XML: control characters and broken UTF-8 never leave JSON's own
/// escapes.
std::string metadata_attribute(const Metadata& metadata) {
  std::string json = metadata_text(metadata);
  const auto replace_all = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = json.find(from); at != json.npos; at = json.find(from, at + to.size()))
      json.replace(at, from.size(), to);
  };
  replace_all("&", "&amp;");
  replace_all("<", "&lt;");
  replace_all(">", "&gt;");
  replace_all("'", "&apos;");
  return fmt::format("data-isect='{}'", json);
}

}  // namespace

std::string svg(const Drawing& drawing, const Metadata& metadata, const Imprint& imprint) {
  if (!(drawing.width > 0 && drawing.height > 0 && std::isfinite(drawing.width * drawing.height)))
    throw FileError(fmt::format("cannot write SVG: a drawing of {} x {}", drawing.width, drawing.height));
  const double scale = imprint.width_pt > 0 ? imprint.width_pt / drawing.width : 1;
  const char* const unit = imprint.width_pt > 0 ? "pt" : "";  // without one: CSS pixels
  std::string told, names;
  if (!imprint.title.empty()) told += fmt::format("<title id=\"title\">{}</title>\n", xml_escaped(imprint.title));
  if (!imprint.alt.empty()) told += fmt::format("<desc id=\"alt\">{}</desc>\n", xml_escaped(imprint.alt));
  if (!imprint.title.empty()) names += " role=\"img\" aria-labelledby=\"title\"";
  if (!imprint.title.empty() && !imprint.alt.empty()) names += " aria-describedby=\"alt\"";
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
      "width=\"{:.7g}{}\" height=\"{:.7g}{}\" viewBox=\"0 0 {:.7g} {:.7g}\"{} {}>\n{}{}</svg>\n",
      drawing.width * scale, unit, drawing.height * scale, unit, drawing.width, drawing.height, names,
      metadata_attribute(metadata), told, SvgWriter(drawing, imprint.letters).write());
}

}  // namespace isect::viz
