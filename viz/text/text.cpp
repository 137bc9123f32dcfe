#include "viz/text/text.h"

#include <fmt/format.h>
#include <fontconfig/fontconfig.h>
#include <pango/pangocairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "viz/lesson.h"
#include "viz/text/names.h"
#include "viz/text/rich_text.h"
#include "viz/text/spelling.h"
#include "viz/text/typeset.h"

namespace isect::viz {
namespace {

/// A transparent cairo canvas that becomes a Picture.
class TextCanvas {
 public:
  TextCanvas(double width, double height) {
    constexpr double most = 32767;  // cairo's limit
    if (!(width <= most && height <= most)) throw std::invalid_argument("text larger than 32767 pixels");
    surface_ = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, static_cast<int>(width), static_cast<int>(height));
    cr_ = cairo_create(surface_);
    cairo_set_antialias(cr_, CAIRO_ANTIALIAS_GOOD);
  }
  ~TextCanvas() {
    cairo_destroy(cr_);
    cairo_surface_destroy(surface_);
  }
  TextCanvas(const TextCanvas&) = delete;
  TextCanvas& operator=(const TextCanvas&) = delete;

  cairo_t* cr() const { return cr_; }

  /// Returns what was drawn, as straight alpha. Where nothing was, the colour is `under`: a filtered texture then has
  /// no dark rim.
  Picture picture(const Colour& under) const {
    if (cairo_surface_status(surface_) != CAIRO_STATUS_SUCCESS) throw std::runtime_error("no memory for a text");
    cairo_surface_flush(surface_);
    Picture out{cairo_image_surface_get_width(surface_), cairo_image_surface_get_height(surface_), {}};
    out.rgba.resize(std::size_t{4} * out.width * out.height);
    const std::array<std::uint8_t, 4> empty = {byte(under.r), byte(under.g), byte(under.b), 0};
    const unsigned char* row = cairo_image_surface_get_data(surface_);
    std::uint8_t* to = out.rgba.data();
    for (int y = 0; y < out.height; ++y, row += cairo_image_surface_get_stride(surface_)) {
      const auto* pixels = reinterpret_cast<const std::uint32_t*>(row);
      for (int x = 0; x < out.width; ++x, to += 4) std::ranges::copy(pixels[x] >> 24 ? straight(pixels[x]) : empty, to);
    }
    return out;
  }

 private:
  static std::uint8_t byte(double channel) { return static_cast<std::uint8_t>(std::lround(255 * channel)); }

  static std::array<std::uint8_t, 4> straight(std::uint32_t premultiplied) {
    const std::uint32_t alpha = premultiplied >> 24;
    const auto channel = [&](int shift) {
      return static_cast<std::uint8_t>(
          std::min<std::uint32_t>(255, ((premultiplied >> shift & 255) * 255 + alpha / 2) / alpha));
    };
    return {channel(16), channel(8), channel(0), static_cast<std::uint8_t>(alpha)};
  }

  cairo_surface_t* surface_;
  cairo_t* cr_;
};

/// Returns the first of `candidates` that fontconfig has, or its own choice for the last one.
std::string installed_family(const std::vector<const char*>& candidates) {
  std::string substitute;
  for (const char* wanted : candidates) {
    FcPattern* pattern = FcPatternCreate();
    FcPatternAddString(pattern, FC_FAMILY, reinterpret_cast<const FcChar8*>(wanted));
    FcConfigSubstitute(nullptr, pattern, FcMatchPattern);
    FcDefaultSubstitute(pattern);
    FcResult result = FcResultNoMatch;
    FcPattern* match = FcFontMatch(nullptr, pattern, &result);
    bool found = false;
    FcChar8* family = nullptr;
    for (int i = 0; match && FcPatternGetString(match, FC_FAMILY, i, &family) == FcResultMatch; ++i) {
      if (i == 0) substitute = reinterpret_cast<const char*>(family);
      found = found || FcStrCmpIgnoreCase(family, reinterpret_cast<const FcChar8*>(wanted)) == 0;
    }
    if (match) FcPatternDestroy(match);
    FcPatternDestroy(pattern);
    if (found) return wanted;
  }
  return substitute;
}

std::vector<std::string> installed_families() {
  std::vector<std::string> all;
  FcPattern* any = FcPatternCreate();
  FcObjectSet* wanted = FcObjectSetBuild(FC_FAMILY, nullptr);
  FcFontSet* found = FcFontList(nullptr, any, wanted);
  for (int i = 0; found && i < found->nfont; ++i) {
    FcChar8* family = nullptr;  // a font may have several: "Latin Modern Roman" is "LM Roman 10", too
    for (int k = 0; FcPatternGetString(found->fonts[i], FC_FAMILY, k, &family) == FcResultMatch; ++k)
      all.emplace_back(reinterpret_cast<const char*>(family));
  }
  if (found) FcFontSetDestroy(found);
  FcObjectSetDestroy(wanted);
  FcPatternDestroy(any);
  return all;
}

/// The family that use_figure_font has set; empty: the usual one.
std::string& wanted_for_figures() {
  static std::string family;
  return family;
}

/// A paragraph's lines, each with its baseline in pixels from the top.
struct Block {
  Layout layout;
  std::vector<std::pair<PangoLayoutLine*, double>> lines;
  double left = 0, right = 0;  ///< of ink and advance together
  double height = 0;
};

/// Forbids line breaks within "50 %", "[0.25, 0.75]", after the sign of "-O3", or within a product of two names, such
/// as *t* **d**.
void keep_together(PangoLayout* layout, const std::string& markup) {
  const std::string text = pango_layout_get_text(layout);
  const std::unique_ptr<PangoAttrList, decltype(&pango_attr_list_unref)> all(
      pango_attr_list_copy(pango_layout_get_attributes(layout)), pango_attr_list_unref);
  const auto keep = [&](std::size_t from, std::size_t to) {
    PangoAttribute* whole = pango_attr_allow_breaks_new(FALSE);
    whole->start_index = static_cast<guint>(from), whole->end_index = static_cast<guint>(to);
    pango_attr_list_insert(all.get(), whole);
  };
  for (std::size_t at = text.find(" %"); at != std::string::npos; at = text.find(" %", at + 1))
    keep(at == 0 ? 0 : at - 1, at + 2);
  for (std::size_t at = text.find('-'); at != std::string::npos; at = text.find('-', at + 1))
    if (at == 0 || text[at - 1] == ' ') keep(at, std::min(text.find(' ', at), text.size()));
  constexpr std::size_t longest = 30;  // the longest interval on one line; the ends of a longer one may stand on two
  for (std::size_t at = text.find('['); at != std::string::npos; at = text.find('[', at + 1))
    if (const std::size_t end = text.find(']', at); end != std::string::npos && end - at < longest) keep(at, end + 1);
  const std::vector<Run> runs = parse_markup(markup);
  const auto is_name = [](const Run& run) {
    return (run.italic || run.bold) && run.text.find(' ') == std::string::npos;
  };
  for (std::size_t i = 0, at = 0; i < runs.size(); at += runs[i].text.size(), ++i)
    if (i > 0 && i + 1 < runs.size() && runs[i].text == " " && is_name(runs[i - 1]) && is_name(runs[i + 1]))
      keep(at - 1, at + 2);
  pango_layout_set_attributes(layout, all.get());
}

Block lay_out(const Paragraph& paragraph) {
  const Fonts families = fonts();
  constexpr double math_scale = 18.0 / 15;
  const std::string markup = paragraph.math ? pango(paragraph.markup, {}, 1, paragraph.size)
                                            : pango(paragraph.markup, families.figure, math_scale, paragraph.size);
  Block block{make_layout(markup, paragraph.math ? families.figure : families.window, paragraph.size, paragraph.bold),
              {}};
  PangoLayout* layout = block.layout.get();
  if (paragraph.width > 0) {
    pango_layout_set_width(layout, static_cast<int>(std::lround(paragraph.width * PANGO_SCALE)));
    pango_layout_set_wrap(layout, PANGO_WRAP_WORD_CHAR);
    keep_together(layout, paragraph.markup);
  }

  // Capitals, about 0.72 em high, stand in the middle of the pitch.
  const double first_baseline = std::round((paragraph.line_pitch + 0.72 * paragraph.size) / 2);
  const double paragraph_gap = std::round(0.3 * paragraph.line_pitch);
  double top = 0;
  for (GSList* at = pango_layout_get_lines_readonly(layout); at; at = at->next) {
    auto* line = static_cast<PangoLayoutLine*>(at->data);
    if (line->is_paragraph_start && !block.lines.empty()) top += paragraph_gap;
    PangoRectangle ink, logical;
    pango_layout_line_get_extents(line, &ink, &logical);
    block.left = std::min(block.left, ink.x / static_cast<double>(PANGO_SCALE));
    block.right = std::max(block.right, std::max(ink.x + ink.width, logical.width) / static_cast<double>(PANGO_SCALE));
    block.lines.emplace_back(line, top + first_baseline);
    top += paragraph.line_pitch;
  }
  block.height = top;
  return block;
}

/// Returns the pixels across and down of the picture of a paragraph that is at least `width` px wide.
Vec2 pixels(const Block& block, double width, double scale) {
  return {std::ceil(std::max(width, block.right - block.left) * scale), std::ceil(block.height * scale)};
}

}  // namespace

TextBox measure(const Text& text) { return ink_box(text); }

Rastered raster(const Text& text, double scale) {
  const TypesetLine line(text);
  const TextBox box = line.box();
  if (line.empty() || !(scale > 0)) return {{}, {box.left, box.top}};

  // Whole pixels of the drawing's own grid, with a rim for the halo and the edges' smoothing.
  const double rim = std::max(text.halo, 0.0) * scale + 1;
  const double left = std::floor(box.left * scale - rim), top = std::floor(box.top * scale - rim);
  const double right = std::ceil(box.right * scale + rim), bottom = std::ceil(box.bottom * scale + rim);
  const TextCanvas canvas(right - left, bottom - top);
  cairo_translate(canvas.cr(), -left, -top);
  cairo_scale(canvas.cr(), scale, scale);
  line.draw(canvas.cr(), TypesetLine::As::outlines);
  return {canvas.picture(text.halo > 0 ? text.halo_colour : text.colour), {left / scale, top / scale}};
}

Vec2 extent(const Paragraph& paragraph, double scale) {
  return paragraph.markup.empty() || !(scale > 0) ? Vec2(0, 0) : pixels(lay_out(paragraph), paragraph.width, scale);
}

Picture raster(const Paragraph& paragraph, double scale) {
  if (paragraph.markup.empty() || !(scale > 0)) return {};
  const Block block = lay_out(paragraph);
  const Vec2 size = pixels(block, paragraph.width, scale);
  const TextCanvas canvas(size.x(), size.y());
  cairo_t* cr = canvas.cr();
  set_source(cr, paragraph.colour);
  cairo_scale(cr, scale, scale);
  for (const auto& [line, baseline] : block.lines) {
    cairo_move_to(cr, -block.left, baseline);
    pango_cairo_layout_line_path(cr, line);
    cairo_fill(cr);
  }
  return canvas.picture(paragraph.colour);
}

std::vector<NameBox> name_boxes(const Paragraph& paragraph) {
  const std::vector<Name> names = names_in(paragraph.markup);
  if (names.empty()) return {};
  const Block block = lay_out(paragraph);
  std::vector<NameBox> boxes;
  for (const Name& name : names)
    for (const auto& [line, baseline] : block.lines) {
      const int begin = static_cast<int>(name.begin), end = static_cast<int>(name.end);
      if (begin < line->start_index || begin >= line->start_index + line->length) continue;
      int left = 0, right = 0;
      pango_layout_line_index_to_x(line, begin, false, &left);
      pango_layout_line_index_to_x(line, std::min(end, line->start_index + line->length), false, &right);
      const double unit = PANGO_SCALE;
      boxes.push_back({name.key,
                       {left / unit - block.left, baseline - 0.95 * paragraph.size, right / unit - block.left,
                        baseline + 0.35 * paragraph.size}});
    }
  return boxes;
}

void use_figure_font(const std::string& family) {
  const std::vector<std::string> all = installed_families();
  const auto same = [&](const std::string& other) { return g_ascii_strcasecmp(other.c_str(), family.c_str()) == 0; };
  const auto found = std::ranges::find_if(all, same);
  if (found == all.end()) {
    const std::string near = spelling::did_you_mean(family, all);
    throw BadInput(fmt::format("font: no family is called \"{}\"{}`fc-list : family` lists those that are installed",
                               family, near.empty() ? "; " : near + " "));
  }
  wanted_for_figures() = *found;
}

Fonts fonts() {
  static const Fonts found = [] {
    const std::vector<const char*> figure = {"STIXGeneral",      "STIX Two Text", "STIX", "TeX Gyre Termes",
                                             "Liberation Serif", "DejaVu Serif",  "serif"};
    const std::vector<const char*> window = {"DejaVu Sans", "sans-serif"};
    Fonts chosen{installed_family(figure), installed_family(window)};
    if (chosen.figure.empty() || chosen.window.empty())
      throw NoFonts(
          "fonts: fontconfig finds none, and figures need letters; on Debian: apt install fonts-stix "
          "fonts-dejavu-core");
    chosen.exact = chosen.figure == figure.front() && chosen.window == window.front();
    if (!wanted_for_figures().empty()) chosen.figure = wanted_for_figures();
    return chosen;
  }();
  return found;
}

}  // namespace isect::viz
