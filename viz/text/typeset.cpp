#include "viz/text/typeset.h"

#include <pango/pangocairo.h>

#include <map>
#include <utility>

#include "viz/text/rich_text.h"
#include "viz/text/text.h"

namespace isect::viz {
namespace {

/// So large that the fixed-point positions of FreeType and Pango lose nothing visible.
constexpr double reference_em = 100;

struct Unref {
  void operator()(void* object) const { g_object_unref(object); }
};
struct FreeFont {
  void operator()(PangoFontDescription* font) const { pango_font_description_free(font); }
};
struct FreeOptions {
  void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
};

/// Makes a context whose results depend on the font files alone, never on the desktop's settings.
std::unique_ptr<PangoContext, Unref> make_context() {
  std::unique_ptr<PangoContext, Unref> context(pango_font_map_create_context(pango_cairo_font_map_get_default()));
  const std::unique_ptr<cairo_font_options_t, FreeOptions> options(cairo_font_options_create());
  cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
  pango_cairo_context_set_font_options(context.get(), options.get());
  pango_cairo_context_set_resolution(context.get(), 96);
  pango_context_set_round_glyph_positions(context.get(), FALSE);
  pango_context_set_base_dir(context.get(), PANGO_DIRECTION_LTR);
  pango_context_set_language(context.get(), pango_language_from_string("en"));
  return context;
}

void set_markup(PangoLayout* layout, const std::string& markup) {
  const auto length = static_cast<int>(markup.size());
  if (g_utf8_validate(markup.data(), length, nullptr)) {
    pango_layout_set_markup(layout, markup.data(), length);
    return;
  }
  const std::unique_ptr<char, decltype(&g_free)> valid(g_utf8_make_valid(markup.data(), length), g_free);
  pango_layout_set_markup(layout, valid.get(), -1);
}

/// Lays out the line at an em of `reference_em`.
Layout laid_out(const Text& text) {
  Layout layout = make_layout(pango(text.markup, {}, 1, reference_em), fonts().figure, reference_em, text.bold);
  pango_layout_set_single_paragraph_mode(layout.get(), TRUE);
  return layout;
}

Extents extents_of(PangoLayout* line) {
  PangoRectangle ink, logical;
  pango_layout_line_get_extents(pango_layout_get_line_readonly(line, 0), &ink, &logical);
  const auto units = [](int pango_units) { return pango_units / static_cast<double>(PANGO_SCALE); };
  return {{units(ink.x), units(ink.y), units(ink.x + ink.width), units(ink.y + ink.height)}, units(logical.width)};
}

bool has_ink(const Extents& e, double scale) {
  return e.ink.right > e.ink.left && e.ink.bottom > e.ink.top && scale > 0;
}

double start_of(const Extents& e, const Text& text) {
  return text.at.x() - text.align * (text.size / reference_em) * e.advance;
}

TextBox placed(const Extents& e, const Text& text) {
  const double scale = text.size / reference_em, x = start_of(e, text), y = text.at.y();
  if (!has_ink(e, scale)) return {x, y, x, y};
  return {x + scale * e.ink.left, y + scale * e.ink.top, x + scale * e.ink.right, y + scale * e.ink.bottom};
}

}  // namespace

void set_source(cairo_t* cr, const Colour& c) { cairo_set_source_rgba(cr, c.r, c.g, c.b, c.a); }

void LayoutDeleter::operator()(_PangoLayout* layout) const { g_object_unref(layout); }

Layout make_layout(const std::string& pango_markup, const std::string& family, double em, bool bold) {
  Layout layout(pango_layout_new(make_context().get()));
  const std::unique_ptr<PangoFontDescription, FreeFont> font(pango_font_description_new());
  pango_font_description_set_family(font.get(), family.c_str());
  pango_font_description_set_absolute_size(font.get(), em * PANGO_SCALE);
  pango_font_description_set_weight(font.get(), bold ? PANGO_WEIGHT_BOLD : PANGO_WEIGHT_NORMAL);
  pango_layout_set_font_description(layout.get(), font.get());
  pango_layout_set_auto_dir(layout.get(), FALSE);
  set_markup(layout.get(), pango_markup);
  return layout;
}

TextBox ink_box(const Text& text) {
  constexpr std::size_t most = 20'000;  // all lessons have some thousands
  thread_local std::map<std::pair<std::string, bool>, Extents> known;
  const auto found = known.find({text.markup, text.bold});
  if (found != known.end()) return placed(found->second, text);
  if (known.size() >= most) known.clear();
  const Extents extents = extents_of(laid_out(text).get());
  known.emplace(std::pair(text.markup, text.bold), extents);
  return placed(extents, text);
}

TypesetLine::TypesetLine(const Text& text)
    : text_(text),
      layout_(laid_out(text)),
      scale_(text.size / reference_em),
      extents_(extents_of(layout_.get())),
      start_(start_of(extents_, text)) {}

bool TypesetLine::empty() const { return !has_ink(extents_, scale_); }
TextBox TypesetLine::box() const { return placed(extents_, text_); }

std::vector<Path> TypesetLine::outlines() const {
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> nowhere(
      cairo_recording_surface_create(CAIRO_CONTENT_ALPHA, nullptr), cairo_surface_destroy);
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cr(cairo_create(nowhere.get()), cairo_destroy);
  cairo_move_to(cr.get(), 0, 0);
  pango_cairo_layout_line_path(cr.get(), pango_layout_get_line_readonly(layout_.get(), 0));
  const std::unique_ptr<cairo_path_t, decltype(&cairo_path_destroy)> path(cairo_copy_path(cr.get()),
                                                                          cairo_path_destroy);
  const auto at = [&](const cairo_path_data_t& p) {
    return Vec2(start_ + scale_ * p.point.x, text_.at.y() + scale_ * p.point.y);
  };
  std::vector<Path> all;
  for (int i = 0; i < path->num_data; i += path->data[i].header.length) {
    const cairo_path_data_t* const data = &path->data[i];
    switch (data->header.type) {
      case CAIRO_PATH_MOVE_TO:
        if (!all.empty() && all.back().segments.empty()) all.pop_back();  // a move without a line
        all.push_back({at(data[1]), {}, false});
        break;
      case CAIRO_PATH_LINE_TO:
        all.back().segments.emplace_back(at(data[1]));
        break;
      case CAIRO_PATH_CURVE_TO:
        all.back().segments.emplace_back(Path::Cubic{at(data[1]), at(data[2]), at(data[3])});
        break;
      case CAIRO_PATH_CLOSE_PATH:
        all.back().closed = true;
        break;
    }
  }
  if (!all.empty() && all.back().segments.empty()) all.pop_back();
  return all;
}

void TypesetLine::draw(_cairo* cr, As as) const {
  if (empty()) return;
  PangoLayoutLine* line = pango_layout_get_line_readonly(layout_.get(), 0);
  cairo_save(cr);
  cairo_translate(cr, start_, text_.at.y());
  cairo_scale(cr, scale_, scale_);
  cairo_new_path(cr);

  if (text_.halo > 0) {
    cairo_move_to(cr, 0, 0);
    pango_cairo_layout_line_path(cr, line);
    cairo_set_line_width(cr, 2 * text_.halo / scale_);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
    cairo_set_dash(cr, nullptr, 0, 0);
    set_source(cr, text_.halo_colour);
    cairo_stroke(cr);
  }

  set_source(cr, text_.colour);
  cairo_move_to(cr, 0, 0);
  if (as == As::glyphs) {
    pango_cairo_show_layout_line(cr, line);
  } else {
    pango_cairo_layout_line_path(cr, line);
    cairo_fill(cr);
  }
  cairo_restore(cr);
}

}  // namespace isect::viz
