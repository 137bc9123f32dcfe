// Paths for shapes, and nodes for labels.

#include "viz/formats/tikz.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "viz/formats/hatch.h"
#include "viz/formats/metadata_text.h"
#include "viz/formats/svg_path.h"
#include "viz/text/tex.h"
#include "viz/text/tex_math.h"
#include "viz/text/text.h"

namespace isect::viz {
namespace {

constexpr std::string_view tikz_data = "% isect:";
constexpr double css_pixel = 0.75;  // in points

class TikzWriter {
 public:
  /// `faces`: the file with the picture of the faces; empty: they are paths.
  TikzWriter(const Drawing& drawing, double scale, const std::string& faces)
      : drawing_(drawing), scale_(scale), faces_(faces), apart_(faces.empty() ? FacesSpan() : faces_span(drawing)) {
    for (const Shape& shape : drawing.shapes)
      if (const Text* text = std::get_if<Text>(&shape)) largest_ = std::max(largest_, text->size);
  }

  std::string write() {
    std::string body;
    std::swap(body, out_);
    find_signs();
    place_labels();
    int named = no_object;
    if (drawing_.background.a > 0)
      out_ += fmt::format("\\fill[{}] (0,0) rectangle ({},{});\n", paint("", drawing_.background),
                          number(drawing_.width), number(drawing_.height));
    for (std::size_t i = 0; i < drawing_.shapes.size(); ++i) {
      const Shape& shape = drawing_.shapes[i];
      if (i == apart_.from && i < apart_.to) add_faces();
      if (i >= apart_.from && i < apart_.to && !std::holds_alternative<Text>(shape)) continue;
      const int object = object_of(shape);
      if (object != named && object != no_object && object < static_cast<int>(drawing_.objects.size())) {
        out_ += fmt::format("% {}\n", full_name(drawing_.objects.at(static_cast<std::size_t>(object))));
        named = object;
      }
      if (const auto sign = signs_.find(&shape); sign != signs_.end())
        add_sign(shape, sign->second);
      else
        std::visit([this](const auto& s) { add(s); }, shape);
    }
    std::swap(body, out_);
    out_ += "\\begin{tikzpicture}[x=1bp, y=-1bp, line join=round, inner sep=0pt]\n";
    for (const auto& [html, name] : colours_) out_ += fmt::format("\\definecolor{{{}}}{{HTML}}{{{}}}\n", name, html);
    const std::string frame = fmt::format("(0,0) rectangle ({},{})", number(drawing_.width), number(drawing_.height));
    return out_ + fmt::format("{2}\\path[use as bounding box] {0};\n\\clip {0};\n{1}\\end{{tikzpicture}}\n", frame,
                              body, labels_.empty() ? "" : fitted);
  }

 private:
  std::string number(double x) const { return svg_number(scale_ * x); }
  std::string point(const Vec2& p) const { return fmt::format("({},{})", number(p.x()), number(p.y())); }

  std::string colour(const Colour& c) {
    std::string html = hex_of(c).substr(1);
    std::ranges::transform(html, html.begin(), [](char d) { return d >= 'a' ? static_cast<char>(d - 'a' + 'A') : d; });
    const std::string fresh = fmt::format("isect{}", colours_.size() + 1);
    return colours_.try_emplace(html, fresh).first->second;
  }
  /// Returns "isect2, fill opacity=0.14".
  std::string paint(const std::string& what, const Colour& c) {
    if (!(c.a < 1)) return colour(c);
    return fmt::format("{}, {}opacity={}", colour(c), what.empty() ? "" : what + " ", svg_number(c.a));
  }

  std::string path(const Path& path) const {
    std::string d = point(path.start);
    for (const Path::Segment& segment : path.segments) {
      if (const Vec2* to = std::get_if<Vec2>(&segment)) {
        d += fmt::format(" -- {}", point(*to));
      } else {
        const auto& [a, b, end] = std::get<Path::Cubic>(segment);
        d += fmt::format(" .. controls {} and {} .. {}", point(a), point(b), point(end));
      }
    }
    return path.closed ? d + " -- cycle" : d;
  }

  void add(const Fill& fill) {
    if (fill.path.segments.empty()) return;
    std::string d = path(fill.path);
    for (const Path& more : fill.more) d += fmt::format("\n  {}", path(more));
    const char* const rule = fill.more.empty() ? "" : ", even odd rule";
    out_ += fmt::format("\\fill[{}{}] {};\n", paint("fill", fill.colour), rule, d);
    if (fill.hatch_gap > 0 && fill.hatch_line > 0) hatch(fill, d);
  }

  void hatch(const Fill& fill, const std::string& outline) {
    const auto lines = hatch_lines(fill);
    if (lines.empty()) return;
    out_ += fmt::format("\\begin{{scope}}{}\\clip {};\n\\draw[{}, line width={}bp]",
                        fill.more.empty() ? "" : "[even odd rule]", outline, paint("draw", fill.hatch_colour),
                        number(fill.hatch_line));
    for (const auto& [from, to] : lines) out_ += fmt::format("\n  {} -- {}", point(from), point(to));
    out_ += ";\n\\end{scope}\n";
  }

  void add(const Stroke& stroke) {
    if (stroke.path.segments.empty()) return;
    std::string style = fmt::format("{}, line width={}bp", paint("draw", stroke.colour), number(stroke.width));
    if (stroke.round_cap) style += ", line cap=round";
    if (stroke.dash[0] > 0 && stroke.dash[1] > 0)
      style += fmt::format(", dash pattern=on {}bp off {}bp", number(stroke.dash[0]), number(stroke.dash[1]));
    out_ += fmt::format("\\draw[{}] {};\n", style, path(stroke.path));
  }

  /// PGF's shadings are opaque: the fainter end is mixed with the ground, and the whole is as faint as the other end.
  void add(const Gradient& g) {
    const double radius = g.major.norm(), most = std::max(g.inner.a, g.outer.a);
    if (!(radius > 0 && g.minor.norm() > 0 && most > 0)) return;
    const auto mixed = [&](const Colour& c) {
      const Colour& ground = drawing_.background;
      const double share = c.a / most;
      return colour({ground.r + share * (c.r - ground.r), ground.g + share * (c.g - ground.g),
                     ground.b + share * (c.b - ground.b)});
    };
    constexpr double unit = 25;  // PGF's radius of a shading, in bp
    const Vec2 focus = unit / radius * (g.focus - g.center);
    const std::string name = fmt::format("isectball{}", ++shadings_), inner = mixed(g.inner), outer = mixed(g.outer);
    out_ += fmt::format(
        "\\pgfdeclareradialshading[{0},{1}]{{{2}}}{{\\pgfpoint{{{3}bp}}{{{4}bp}}}}"
        "{{color(0bp)=({0}); color(25bp)=({1}); color(50bp)=({1})}}\n"
        "\\path[shading={2}, fill opacity={5}] {6};\n",
        inner, outer, name, svg_number(focus.x()), svg_number(-focus.y()), svg_number(most),
        path(ellipse(g.center, g.major, g.minor)));
  }

  /// A verdict's first line and the sign before it: one centred node, whatever font the document has.
  struct Signed {
    int number = 0;  ///< of the node's name
    const Text* text = nullptr;
    double left = INFINITY;  ///< of the sign
  };

  /// Moves `left` to the leftmost point of a sign's outlines; texts are ignored.
  static void reach_left(const Shape& shape, double& left) {
    const auto look = [&](const Path& path, double by) {
      for (const Vec2& p : flatten(path)) left = std::min(left, p.x() - by);
    };
    if (const Fill* fill = std::get_if<Fill>(&shape)) look(fill->path, 0);
    if (const Stroke* stroke = std::get_if<Stroke>(&shape)) look(stroke->path, stroke->width / 2);
  }

  void find_signs() {
    std::map<int, Signed> verdicts;  // by object
    const auto is_verdict = [&](int object) {
      return object != no_object && drawing_.objects.at(static_cast<std::size_t>(object)).name == "verdict";
    };
    for (const Shape& shape : drawing_.shapes) {
      if (!is_verdict(object_of(shape))) continue;
      Signed& verdict = verdicts[object_of(shape)];
      if (const Text* text = std::get_if<Text>(&shape); text && !verdict.text) verdict.text = text;
      reach_left(shape, verdict.left);
    }
    std::erase_if(verdicts, [](const auto& v) { return !v.second.text || !std::isfinite(v.second.left); });
    for (const Shape& shape : drawing_.shapes) {
      const auto found = verdicts.find(object_of(shape));
      if (found == verdicts.end()) continue;
      if (!found->second.number) found->second.number = ++verdicts_;
      if (!std::holds_alternative<Text>(shape)) signs_.emplace(&shape, found->second);
      if (std::get_if<Text>(&shape) == found->second.text) signed_.emplace(found->second.text, found->second);
    }
  }

  /// Adds a sign, placed relative to its verdict's node.
  void add_sign(Shape shape, const Signed& verdict) {
    move(shape, {-verdict.left, -verdict.text->at.y()});
    out_ += fmt::format("\\begin{{scope}}[shift={{(isectverdict{}.base west)}}]\n", verdict.number);
    std::visit([this](const auto& s) { add(s); }, shape);
    out_ += "\\end{scope}\n";
  }

  /// A label as LaTeX will set it: its anchor, and the width it may have.
  struct Label {
    TextBox box;
    double at = 0;
    std::string anchor = {};
    double scale = 1;
    double room = 0;
    double before = 0;  ///< the space at its beginning, for a sign
  };

  /// Anchors a label at its middle: whatever font the document has, it grows equally to both sides; or at an edge of
  /// the picture that it would cross, and it grows away from that. Texts in a chart, a map or a card keep their own
  /// ends, and are small enough for their room.
  Label held(const Text& text) const {
    Label label = {measure(text)};
    if (const auto verdict = signed_.find(&text); verdict != signed_.end())
      label.before = label.box.left - verdict->second.left, label.box.left = verdict->second.left;
    const TextBox& box = label.box;
    const Object* const object =
        text.object == no_object ? nullptr : &drawing_.objects.at(static_cast<std::size_t>(text.object));
    const bool chart = object && is_of_chart(*object);
    const double middle = (box.left + box.right) / 2, reach = wider * (box.right - box.left) / 2;
    const bool west = (chart && text.align == 0) || middle - reach < 0;
    const bool east = !west && ((chart && text.align == 1) || middle + reach > drawing_.width);
    const bool by_its_end = chart && (text.align == 0 || text.align == 1);
    label.at = by_its_end ? text.at.x() : west ? box.left : east ? box.right : middle;
    label.anchor = west ? " west" : east ? " east" : "";
    if (chart || text.size < shrunk * largest_) label.scale = text.size / largest_ / wider;
    return label;
  }

  /// Places the labels: each may grow up to the edges of the picture, and nearly halfway to a label beside it.
  void place_labels() {
    std::vector<TextBox> boxes;
    for (const Shape& shape : drawing_.shapes)
      if (const Text* text = std::get_if<Text>(&shape))
        if (const TextBox box = measure(*text); box.right > box.left) boxes.push_back(box);
    for (const Shape& shape : drawing_.shapes) {
      const Text* const text = std::get_if<Text>(&shape);
      if (!text) continue;
      Label label = held(*text);
      const TextBox& box = label.box;
      double left = 0, right = drawing_.width;
      for (const TextBox& other : boxes) {
        if (!(other.top < box.bottom && box.top < other.bottom)) continue;
        const auto half = [gap = 0.2 * text->size](double space) { return std::max(space / 2 - gap, 0.0); };
        if (other.right <= box.left) left = std::max(left, box.left - half(box.left - other.right));
        if (box.right <= other.left) right = std::min(right, box.right + half(other.left - box.right));
      }
      const double before = label.at - left, behind = right - label.at;
      label.room = label.anchor.starts_with(" west") ? behind
                   : label.anchor == " east"         ? before
                                                     : 2 * std::min(before, behind);
      label.room = std::max(label.room, box.right - box.left);
      labels_.emplace(text, std::move(label));
    }
  }

  void add(const Text& text) {
    const Label& label = labels_.at(&text);
    if (!(label.box.right > label.box.left)) return;
    std::string style = fmt::format("anchor=base{}, text={}", label.anchor, colour(text.colour));
    if (text.halo > 0)
      style += fmt::format(", fill={}, fill opacity=0.8, text opacity=1, inner sep={}bp", colour(text.halo_colour),
                           number(text.halo));
    if (text.bold) style += ", font=\\bfseries\\boldmath";
    if (label.scale != 1) style += fmt::format(", scale={:.2f}", label.scale);
    const auto verdict = signed_.find(&text);
    const bool is_signed = verdict != signed_.end();
    out_ += fmt::format("\\node[{}]{} at {} {{\\isectfitted{{{}bp}}{{{}{}}}}};\n", style,
                        is_signed ? fmt::format(" (isectverdict{})", verdict->second.number) : "",
                        point({label.at, text.at.y()}), number(label.room / label.scale),
                        is_signed ? fmt::format("\\hspace*{{{}bp}}", number(label.before)) : "", tex(text.markup));
  }

  /// Adds the picture of the faces, from the folder of the file that names it: LaTeX may run in another one.
  void add_faces() {
    out_ += fmt::format(
        "\\def\\isectbeside{{\\ifdefined\\CurrentFilePath\\ifx\\CurrentFilePath\\empty\\else\\CurrentFilePath/"
        "\\fi\\fi}}\n"
        "\\node[anchor=north west, outer sep=0pt] at (0,0) {{\\includegraphics[width={}bp]{{\\isectbeside {}}}}};\n",
        number(drawing_.width), faces_);
  }

  static bool is_of_chart(const Object& object) {
    const std::string& kind = object.kind;
    return kind == "row" || kind == "chart" || kind == "panel" || kind == "map" || kind == "region";
  }

  void add(const Facets& facets) {
    for (const Shape& shape : expanded(facets)) std::visit([this](const auto& s) { add(s); }, shape);  // no texts
  }

  /// Texts smaller than this beside the largest text were made so to fit into their room: LaTeX is told.
  static constexpr double shrunk = 0.9;
  /// How much wider LaTeX's usual letters are than those for which the picture was made.
  static constexpr double wider = 1.12;
  /// A macro that makes a label smaller if it is wider in the document's font than its room.
  static constexpr const char* fitted =
      "\\def\\isectfitted#1#2{\\setbox0\\hbox{#2}\\ifdim\\wd0>#1\\resizebox{#1}{!}{\\box0}\\else\\box0\\fi}\n";

  const Drawing& drawing_;
  const double scale_;
  const std::string faces_;
  const FacesSpan apart_;  ///< the shapes that the picture of the faces has
  double largest_ = 0;
  std::map<const Text*, Label> labels_;   ///< of the drawing's texts
  std::map<const Shape*, Signed> signs_;  ///< the signs before verdicts
  std::map<const Text*, Signed> signed_;
  int verdicts_ = 0;
  std::string out_;
  std::map<std::string, std::string> colours_;
  int shadings_ = 0;
};

/// Returns the text as comments, one per line.
std::string commented(const std::string& text) {
  std::string out = "% ";
  for (const char c : text) out += c == '\n' ? std::string("\n% ") : std::string(1, c);
  while (out.ends_with("\n% ")) out.erase(out.size() - 3);
  return out + "\n";
}

}  // namespace

std::string tikz(const Drawing& drawing, const Metadata& metadata, const Imprint& imprint) {
  if (!(drawing.width > 0 && drawing.height > 0 && std::isfinite(drawing.width * drawing.height)))
    throw FileError(fmt::format("cannot write TikZ: a drawing of {} x {}", drawing.width, drawing.height));
  std::string head;
  if (!metadata.empty()) head = fmt::format("{}{}\n", tikz_data, metadata_text(metadata));
  const double scale = imprint.width_pt > 0 ? imprint.width_pt / drawing.width : css_pixel;
  const std::string body = TikzWriter(drawing, scale, imprint.faces).write(), packages = tex_packages(body);
  head += fmt::format("% \\usepackage{{tikz{}}} in the preamble, \\input where the figure belongs.\n",
                      packages.empty() ? "" : "," + packages);
  if (!imprint.title.empty()) head += commented(imprint.title);
  if (!imprint.alt.empty()) head += commented(imprint.alt);
  return head + body;
}

Metadata tikz_metadata(const std::string& bytes) {
  if (bytes.find("\\begin{tikzpicture}") == bytes.npos) throw FileError("not a TikZ picture");
  const std::size_t at = bytes.find(tikz_data);
  if (at == bytes.npos) return {};
  const std::size_t begin = at + tikz_data.size();
  return metadata_of_text(bytes.substr(begin, bytes.find('\n', begin) - begin), "TikZ");
}

}  // namespace isect::viz
