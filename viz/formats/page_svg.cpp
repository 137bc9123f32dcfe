#include "viz/formats/page_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "viz/formats/facet_layers.h"
#include "viz/formats/svg_path.h"
#include "viz/text/rich_text.h"
#include "viz/theme.h"

namespace isect::viz {
namespace {

constexpr std::size_t worth_sharing = 48;  ///< bytes; a reference takes about 20

bool same_path(const Path& a, const Path& b) {
  const auto same_segment = [](const Path::Segment& s, const Path::Segment& t) {
    if (s.index() != t.index()) return false;
    if (const Vec2* p = std::get_if<Vec2>(&s)) return *p == std::get<Vec2>(t);
    const auto &c = std::get<Path::Cubic>(s), &d = std::get<Path::Cubic>(t);
    return c.control1 == d.control1 && c.control2 == d.control2 && c.to == d.to;
  };
  return a.start == b.start && a.closed == b.closed && std::ranges::equal(a.segments, b.segments, same_segment);
}

/// Whether both make the same mark on the page, whatever their colours.
struct SamePlace {
  bool operator()(const Fill& a, const Fill& b) const {
    return same_path(a.path, b.path) && std::ranges::equal(a.more, b.more, same_path);
  }
  bool operator()(const Stroke& a, const Stroke& b) const {
    return a.width == b.width && a.dash == b.dash && same_path(a.path, b.path);
  }
  bool operator()(const Gradient& a, const Gradient& b) const {
    return a.center == b.center && a.major == b.major && a.minor == b.minor && a.focus == b.focus;
  }
  bool operator()(const Text& a, const Text& b) const {
    return a.markup == b.markup && a.at == b.at && a.size == b.size && a.bold == b.bold;
  }
  bool operator()(const Facets& a, const Facets& b) const {
    return a.seam == b.seam && std::ranges::equal(a.corners, b.corners);
  }
  bool operator()(const auto&, const auto&) const { return false; }
};

/// A shape in both themes; null where the theme lacks it.
struct Pair {
  const Shape *light, *dark;
  const Shape& any() const { return light ? *light : *dark; }
};

/// Pairs the shapes of both in order. A shape without a counterpart within the next few stands alone.
std::vector<Pair> paired(const std::vector<Shape>& light, const std::vector<Shape>& dark) {
  constexpr std::size_t reach = 4;
  const auto alike = [&](std::size_t i, std::size_t j) {
    return i < light.size() && j < dark.size() && (&light[i] == &dark[j] || std::visit(SamePlace{}, light[i], dark[j]));
  };
  std::vector<Pair> all;
  std::size_t i = 0, j = 0;
  while (i < light.size() || j < dark.size()) {
    std::size_t more_light = 0, more_dark = 0;
    for (std::size_t sum = 0; sum <= 2 * reach; ++sum) {
      const auto found = [&] {
        for (more_light = 0; more_light <= sum; ++more_light)
          if (more_dark = sum - more_light; alike(i + more_light, j + more_dark)) return true;
        return false;
      }();
      if (found) break;
      more_light = light.size() - i, more_dark = dark.size() - j;
    }
    for (; more_light > 0; --more_light) all.push_back({&light[i++], nullptr});
    for (; more_dark > 0; --more_dark) all.push_back({nullptr, &dark[j++]});
    if (i < light.size() && j < dark.size()) all.push_back({&light[i++], &dark[j++]});
  }
  return all;
}

/// Returns the property that a class with this prefix sets.
std::string property(const std::string& what) {
  return what == "line" ? "stroke" : what == "stop" ? "stop-color" : what;
}

/// The paint of a shape in the theme that lacks it.
constexpr Colour invisible = {0, 0, 0, 0};

}  // namespace

PageColours::PageColours() {
  const Theme light = theme(ThemeName::screen, 960, 600), dark = theme(ThemeName::dark, 960, 600);
  const auto add = [&](const std::string& name, const Colour& on_light, const Colour& on_dark) {
    all_.push_back({name, hex_of(on_light), hex_of(on_dark), {}});
  };
  for (const Role role : {Role::first, Role::second, Role::hit, Role::miss, Role::construction, Role::highlight,
                          Role::text, Role::muted, Role::grid})
    add(name_of(role), light.ink(role), dark.ink(role));
  add("background", light.background, dark.background);
  add("panel", light.panel, dark.panel);
}

std::string PageColours::of(const std::string& what, const PageColour& c) {
  const auto written = [](const Colour& colour) {
    if (!(colour.a > 0)) return std::string("transparent");
    return hex_of(colour) + (colour.a < 1 ? fmt::format("{:02x}", std::lround(255 * colour.a)) : "");
  };
  const std::string light = written(c.light), dark = written(c.dark);
  auto found = std::ranges::find_if(all_, [&](const Named& n) { return n.light == light && n.dark == dark; });
  if (found == all_.end()) found = all_.insert(all_.end(), {fmt::format("paint-{}", all_.size()), light, dark, {}});
  found->used.insert(what);
  return what + "-" + found->name;
}

std::string PageColours::variables(bool dark) const {
  std::string out;
  for (const Named& n : all_) out += fmt::format("--{}: {}; ", n.name, dark ? n.dark : n.light);
  return out;
}

std::string PageColours::rules() const {
  std::string out;
  for (const Named& n : all_)
    for (const std::string& what : n.used)
      out += fmt::format(".{0}-{1} {{ {2}: var(--{1}); }}\n", what, n.name, property(what));
  return out;
}

/// The shapes of one picture.
class PageWriter {
 public:
  PageWriter(PagePictures& page, const Drawing& light, const Drawing& dark) : page_(page), light_(light), dark_(dark) {}

  std::string write() {
    const std::vector<Pair> all = paired(light_.shapes, dark_.shapes);
    std::string out;
    for (std::size_t i = 0; i < all.size();) {
      const int object = object_of(all[i].any());
      std::size_t end = i + 1;
      while (end < all.size() && object_of(all[end].any()) == object) ++end;
      out += group({all.begin() + static_cast<std::ptrdiff_t>(i), all.begin() + static_cast<std::ptrdiff_t>(end)});
      i = end;
    }
    return out;
  }

 private:
  std::string group(const std::vector<Pair>& shapes) {
    out_.clear(), stroke_.clear(), area_ = {};
    for (const Pair& pair : shapes)
      std::visit([&](const auto& any) { add(any, part(any, pair.light), part(any, pair.dark)); }, pair.any());
    end_stroke();
    page_.last_ += out_;
    if (out_.size() < worth_sharing || !page_.colours_) return out_ + "\n";
    const auto [known, fresh] = page_.groups_.emplace(out_, fmt::format("g{}", page_.groups_.size() + 1));
    if (!fresh) return fmt::format("<use href=\"#{}\"/>\n", known->second);
    return fmt::format("<g id=\"{}\">{}</g>\n", known->second, out_);
  }

  template <class Part>
  static const Part* part(const Part&, const Shape* shape) {
    return shape ? std::get_if<Part>(shape) : nullptr;
  }

  /// Returns the class, or the colour in a picture that stands alone, and the opacity if there is any. A theme whose
  /// colour is null has no such paint; where the themes differ in opacity, the class contains it.
  std::string paint(const std::string& what, const Colour* light, const Colour* dark, const std::string& more = {}) {
    const Colour &a = light ? *light : *dark, &b = dark ? *dark : *light;
    if (!page_.colours_) return painted(what, a) + more + opacity(what, a.a);
    const bool alike = a.a == b.a;
    PageColour c = {alike ? a.with_alpha(1) : a, alike ? b.with_alpha(1) : b};
    if (!light) c.light = invisible;
    if (!dark) c.dark = invisible;
    return fmt::format("class=\"{}{}\"{}", page_.colours_->of(what, c), more, alike ? opacity(what, a.a) : "");
  }

  /// Returns `fill="#0b60c8"`.
  static std::string painted(const std::string& what, const Colour& c) {
    return fmt::format("{}=\"{}\"", property(what), hex_of(c));
  }

  static std::string opacity(const std::string& what, double alpha) {
    const std::string name = what == "line" ? "stroke" : what;  // stop-opacity
    return alpha < 1 ? fmt::format(" {}-opacity=\"{}\"", name, svg_number(alpha)) : "";
  }

  /// Returns how much of the grid's ink is in a colour between it and the background; nothing for any other colour.
  static std::optional<double> ink(const Colour& c, const Theme& in) {
    const Colour &full = in.ink(Role::grid), &ground = in.background;
    const double share = (c.g - ground.g) / (full.g - ground.g);
    const auto off = [&](double Colour::*part) { return std::abs(c.*part - between(ground, full, share).*part); };
    constexpr double seen = 1. / 255;
    if (!(share > 0 && share < 1) || off(&Colour::r) > seen || off(&Colour::b) > seen || c.a != 1) return {};
    return share;
  }
  static Colour between(const Colour& a, const Colour& b, double share) {
    return {a.r + share * (b.r - a.r), a.g + share * (b.g - a.g), a.b + share * (b.b - a.b)};
  }

  /// Returns the paint of a line that fades into the background, in one of twelve shades.
  std::optional<std::string> fading(const Colour& light, const Colour& dark) const {
    static const Theme day = theme(ThemeName::screen, 960, 600), night = theme(ThemeName::dark, 960, 600);
    const auto shade = [](double share) { return std::ceil(12 * share) / 12; };
    if (!page_.colours_) {
      for (const Theme* in : {&day, &night})
        if (const std::optional<double> share = ink(light, *in))
          return painted("line", between(in->background, in->ink(Role::grid), shade(*share)));
      return {};
    }
    const std::optional<double> s = ink(light, day), t = ink(dark, night);
    if (!s || !t || std::abs(*s - *t) > 1e-6) return {};
    return "class=\"line-grid\"" + opacity("line", shade(*s));
  }

  void add(const Fill&, const Fill* light, const Fill* dark) {
    end_stroke();
    const Fill& fill = light ? *light : *dark;
    std::string d = svg_letters({fill.path});
    for (const Path& more : fill.more) d += svg_letters({more});
    const std::string rule = fill.more.empty() ? "" : " fill-rule=\"evenodd\"";
    area_ = {out_.size(), paint("fill", colour_of(light), colour_of(dark)) + rule, d};
    write(area_.attributes, d);
  }

  void add(const Stroke&, const Stroke* light, const Stroke* dark) {
    const Stroke& stroke = light ? *light : *dark;
    const std::optional<std::string> faint = light && dark ? fading(light->colour, dark->colour) : std::nullopt;
    if (bool(faint) == grid_.empty()) end_stroke();  // a grid begins or ends
    std::string attributes = line(faint ? *faint : paint("line", colour_of(light), colour_of(dark)), stroke.width);
    if (!stroke.round_cap) attributes += " stroke-linecap=\"butt\"";
    if (stroke.dash[0] > 0 && stroke.dash[1] > 0)
      attributes += fmt::format(" stroke-dasharray=\"{} {}\"", svg_number(stroke.dash[0]), svg_number(stroke.dash[1]));
    if (faint) return grid_[attributes].push_back(stroke.path);
    if (!paths_.empty() && attributes != stroke_) end_stroke();
    stroke_ = attributes;
    paths_.push_back(stroke.path);
  }

  static std::string line(const std::string& paint, double width) {
    return paint + " stroke-width=\"" + svg_number(width) + "\"";
  }

  void write(const std::string& attributes, const std::string& letters) {
    (out_ += "<path ") += attributes, (out_ += " d=\"") += letters, out_ += "\"/>";
  }

  /// Merges the attributes of a fill and of a stroke for one element, which has one class.
  static std::string joined(const std::string& fill, const std::string& stroke) {
    const std::string_view own = "class=\"";
    if (!fill.starts_with(own) || !stroke.starts_with(own)) return fill + " " + stroke;
    const std::size_t end = fill.find('"', own.size());
    return fill.substr(0, end) + " " + stroke.substr(own.size()) + fill.substr(end + 1);
  }

  /// Writes strokes that look alike and follow each other as one path, as well as all grid lines that fade equally. A
  /// stroke around the area just filled is merged with it.
  void end_stroke() {
    for (const auto& [attributes, paths] : std::exchange(grid_, {})) write(attributes, svg_letters(paths));
    const Area area = std::exchange(area_, {});
    if (paths_.empty()) return;
    const std::string letters = svg_letters(paths_);
    if (area.letters == letters) {
      out_.resize(area.begin);
      write(joined(area.attributes, stroke_), letters);
    } else {
      write(stroke_, letters);
    }
    paths_.clear(), stroke_.clear();
  }

  void add(const Gradient&, const Gradient* light, const Gradient* dark) {
    end_stroke();
    const Gradient& g = light ? *light : *dark;
    if (!(g.major.squaredNorm() > 0 && g.minor.squaredNorm() > 0)) return;  // no area
    const Vec2 towards = g.focus - g.center;
    Vec2 focus(towards.dot(g.major) / g.major.squaredNorm(), towards.dot(g.minor) / g.minor.squaredNorm());
    if (focus.norm() > 0.99) focus *= 0.99 / focus.norm();
    const auto stop = [&](int at, Colour Gradient::*colour) {
      return fmt::format("<stop offset=\"{}\" {}/>", at,
                         paint("stop", light ? &(light->*colour) : nullptr, dark ? &(dark->*colour) : nullptr));
    };
    const std::string body = fmt::format(
        " gradientUnits=\"userSpaceOnUse\" cx=\"0\" cy=\"0\" r=\"1\" fx=\"{}\" fy=\"{}\" "
        "gradientTransform=\"matrix({} {} {} {} {} {})\">{}{}</radialGradient>",
        svg_number(focus.x()), svg_number(focus.y()), svg_number(g.major.x()), svg_number(g.major.y()),
        svg_number(g.minor.x()), svg_number(g.minor.y()), svg_number(g.center.x()), svg_number(g.center.y()),
        stop(0, &Gradient::inner), stop(1, &Gradient::outer));
    const auto [known, fresh] =
        page_.gradients_.emplace(body, fmt::format("{}gradient{}", page_.id_, page_.gradients_.size() + 1));
    if (fresh) page_.definitions_ += fmt::format("<radialGradient id=\"{}\"{}\n", known->second, body);
    out_ += fmt::format("<path fill=\"url(#{})\" d=\"{}\"/>", known->second,
                        svg_letters({ellipse(g.center, g.major, g.minor)}));
  }

  /// Writes facets; those of one layer and colour are one path.
  void add(const Facets&, const Facets* light, const Facets* dark) {
    end_stroke();
    const Facets& facets = light ? *light : *dark;
    const std::vector<int> layer = layers(facets);
    std::map<std::pair<int, std::string>, std::vector<Path>> gathered;  // by layer and attributes
    for (std::size_t i = 0; i < facets.colours.size(); ++i) {
      const Vec2* const p = &facets.corners[3 * i];
      const Colour* const on_light = light ? &light->colours[i] : nullptr;
      const Colour* const on_dark = dark ? &dark->colours[i] : nullptr;
      std::string look = paint("fill", on_light, on_dark);
      if (facets.seam > 0) look = joined(look, line(paint("line", on_light, on_dark), facets.seam));
      gathered[{layer[i], look}].push_back(polyline({p[0], p[1], p[2]}, true));
    }
    for (const auto& [place, paths] : gathered) write(place.second, svg_letters(paths));
  }

  /// Writes a text; a script is moved to a line of its own height, and what follows is moved back.
  void add(const Text&, const Text* light, const Text* dark) {
    end_stroke();
    const Text& text = light ? *light : *dark;
    std::string runs;
    double raised = 0;  // above the baseline
    const std::vector<Run> all = parse_markup(text.markup);
    for (const Run& run : all) {
      const bool base = run.script == Run::Script::base;
      const double rise = base ? 0 : (run.script == Run::Script::sub ? sub_rise : super_rise) * text.size;
      std::string how;
      if (run.italic) how += " font-style=\"italic\"";
      if (run.bold) how += " font-weight=\"bold\"";
      if (!base) how += fmt::format(" font-size=\"{}\"", svg_number(script_size * text.size));
      if (rise != raised) how += fmt::format(" dy=\"{}\"", svg_number(raised - rise));
      raised = rise;
      const std::string letters = xml_escaped(run.text);
      runs += how.empty() ? letters : fmt::format("<tspan{}>{}</tspan>", how, letters);
    }
    if (runs.empty()) return;
    const char* const anchor = text.align == 0.5 ? " text-anchor=\"middle\""
                               : text.align == 1 ? " text-anchor=\"end\""
                                                 : "";
    const Colour* const rim_light = light && light->halo > 0 ? &light->halo_colour : nullptr;
    const Colour* const rim_dark = dark && dark->halo > 0 ? &dark->halo_colour : nullptr;
    std::string rim, rim_class;
    if (rim_light || rim_dark) {
      rim = fmt::format(" stroke-width=\"{}\" paint-order=\"stroke\"",
                        svg_number(2 * std::max(rim_light ? light->halo : 0, rim_dark ? dark->halo : 0)));
      if (page_.colours_)
        rim_class =
            " " + page_.colours_->of("line", {rim_light ? *rim_light : invisible, rim_dark ? *rim_dark : invisible});
      else
        rim_class = " " + painted("line", light->halo_colour);
    }
    out_ += fmt::format("<text {} x=\"{}\" y=\"{}\" font-size=\"{}\"{}{}{}>{}</text>",
                        paint("fill", colour_of(light), colour_of(dark), rim_class), svg_number(text.at.x()),
                        svg_number(text.at.y()), svg_number(text.size), anchor,
                        text.bold ? " font-weight=\"bold\"" : "", rim, runs);
  }

  template <class Part>
  static const Colour* colour_of(const Part* part) {
    return part ? &part->colour : nullptr;
  }

  PagePictures& page_;
  const Drawing &light_, &dark_;
  std::string out_, stroke_;
  std::vector<Path> paths_;
  std::map<std::string, std::vector<Path>> grid_;  ///< strokes that fade, by their attributes
  /// The area filled last, if nothing was written since.
  struct Area {
    std::size_t begin = 0;  ///< of its element in out_
    std::string attributes, letters;
  } area_;
};

std::string PagePictures::svg(const Drawing& light, const Drawing& dark, const std::string& alt) {
  before_ = std::exchange(last_, {});
  const std::string shapes = PageWriter(*this, light, dark).write();
  return fmt::format("<svg class=\"picture\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n{}</svg>",
                     svg_number(light.width), svg_number(light.height), xml_escaped(alt), shapes);
}

std::string lone_svg(const Drawing& drawing, const std::string& alt, const std::string& id) {
  PagePictures page;
  page.id_ = id;
  const std::string svg = page.svg(drawing, drawing, alt);
  if (page.definitions_.empty()) return svg;
  const std::size_t body = svg.find(">\n") + 1;
  return svg.substr(0, body) + "<defs>\n" + page.definitions_ + "</defs>" + svg.substr(body);
}

std::string PagePictures::shared() const {
  if (definitions_.empty()) return {};
  return fmt::format(
      "<svg class=\"shared\" width=\"0\" height=\"0\" aria-hidden=\"true\" "
      "focusable=\"false\"><defs>\n{}</defs></svg>\n",
      definitions_);
}

}  // namespace isect::viz
