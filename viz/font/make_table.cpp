// make_font_table >viz/font/table.inc: the measures of the figures' font, for viz/font/table.h.

#include <fmt/format.h>
#include <hb-ot.h>

#include <map>
#include <string>
#include <vector>

#include "viz/font/file.h"
#include "viz/text/text.h"

namespace {

/// Latin, Greek, punctuation, arrows, mathematical and geometric signs, check marks, ligatures.
constexpr std::pair<unsigned, unsigned> wanted[] = {
    {0x20, 0x7E},     {0xA0, 0xFF},     {0x131, 0x131},   {0x394, 0x3D6},   {0x2009, 0x200A},
    {0x2010, 0x2026}, {0x202F, 0x202F}, {0x2032, 0x2033}, {0x2070, 0x209C}, {0x2190, 0x21D4},
    {0x2200, 0x22C6}, {0x2308, 0x230B}, {0x25A0, 0x25E6}, {0x2713, 0x2718}, {0xFB00, 0xFB04}};
/// Characters that stand beside each other in words, numbers and formulas: their kerning is measured.
constexpr std::pair<unsigned, unsigned> neighbours[] = {
    {0x20, 0x7E}, {0x2019, 0x2019}, {0x2212, 0x2212}, {0xFB00, 0xFB04}};

/// Signs that the font lacks; Pango takes them from other fonts.
constexpr std::pair<unsigned, unsigned> lent[] = {
    {0x2009, 0x200A}, {0x202F, 0x202F}, {0x2070, 0x2070}, {0x2074, 0x208E}, {0x2713, 0x2717}};

bool is_lent(unsigned code) {
  for (const auto& [from, to] : lent)
    if (from <= code && code <= to) return true;
  return false;
}

hb_font_t* font_of(const std::string& style) {
  const std::string file = isect::viz::font_file("STIXGeneral" + style);
  hb_face_t* const face = hb_face_create(hb_blob_create_from_file(file.c_str()), 0);
  hb_font_t* const font = hb_font_create(face);
  hb_font_set_scale(font, 1000, 1000);
  return font;
}

int advance(hb_font_t* font, unsigned a, unsigned b) {
  const unsigned text[] = {a, b};
  hb_buffer_t* const buffer = hb_buffer_create();
  hb_buffer_add_utf32(buffer, text, b ? 2 : 1, 0, b ? 2 : 1);
  hb_buffer_guess_segment_properties(buffer);
  hb_feature_t no_ligature = {HB_TAG('l', 'i', 'g', 'a'), 0, HB_FEATURE_GLOBAL_START, HB_FEATURE_GLOBAL_END};
  hb_shape(font, buffer, &no_ligature, 1);
  unsigned count = 0;
  const hb_glyph_position_t* const at = hb_buffer_get_glyph_positions(buffer, &count);
  int sum = 0;
  for (unsigned i = 0; i < count; ++i) sum += at[i].x_advance;
  hb_buffer_destroy(buffer);
  return sum;
}

/// Measures a sign that Pango takes from another font: those are neither slanted nor bold in our texts.
std::string measured(unsigned code) {
  const std::string sign = {static_cast<char>(0xE0 | code >> 12), static_cast<char>(0x80 | (code >> 6 & 63)),
                            static_cast<char>(0x80 | (code & 63))};
  const auto box = [](const std::string& markup) {
    return isect::viz::measure({markup, isect::viz::Vec2::Zero(), 1000, {}});
  };
  const isect::viz::TextBox ink = box(sign);
  const double advance = box("H" + sign + "H").right - box("HH").right;
  return fmt::format("{{{:#x}, {:.0f}, {:.0f}, {:.0f}, {:.0f}, {:.0f}}},", code, advance, ink.left, -ink.bottom,
                     ink.right, -ink.top);
}

/// Writes a character for a literal between such quotes.
std::string letter(unsigned code, char quote) {
  if (code >= 0x7F) return fmt::format("\\u{:04x}", code);
  const char c = static_cast<char>(code);
  return c == quote || c == '\\' ? std::string("\\") + c : std::string(1, c);
}

void write(const char* name, hb_font_t* font) {
  std::string line = fmt::format("constexpr GlyphBox {}_glyphs[] = {{", name);
  const auto add = [&](const std::string& entry) {
    if (line.size() + entry.size() > 118) fmt::print("{}\n", line), line = "   ";
    line += " " + entry;
  };
  for (const auto& [from, to] : wanted)
    for (unsigned code = from; code <= to; ++code) {
      hb_codepoint_t glyph = 0;
      hb_glyph_extents_t box = {};
      if (!hb_font_get_nominal_glyph(font, code, &glyph)) {
        if (is_lent(code)) add(measured(code));
        continue;
      }
      hb_font_get_glyph_extents(font, glyph, &box);
      add(fmt::format("{{{:#x}, {}, {}, {}, {}, {}}},", code, hb_font_get_glyph_h_advance(font, glyph), box.x_bearing,
                      box.y_bearing + box.height, box.x_bearing + box.width, box.y_bearing));
    }
  fmt::print("{}}};\n", line);
  line = fmt::format("constexpr Kern {}_kerns[] = {{", name);
  std::vector<std::pair<unsigned, int>> all;
  for (const auto& [from, to] : neighbours)
    for (unsigned code = from; code <= to; ++code) {
      hb_codepoint_t glyph = 0;
      if (hb_font_get_nominal_glyph(font, code, &glyph)) all.emplace_back(code, advance(font, code, 0));
    }
  for (const auto& [a, width_a] : all) {
    std::map<int, std::string> seconds;
    for (const auto& [b, width_b] : all)
      if (const int by = advance(font, a, b) - width_a - width_b) seconds[by] += letter(b, '"');
    for (const auto& [by, letters] : seconds) add(fmt::format("{{U'{}', {}, U\"{}\"}},", letter(a, '\''), by, letters));
  }
  fmt::print("{}}};\n", line);
}

}  // namespace

int main() {
  fmt::print(
      "// Written by make_font_table from STIXGeneral, {{code, advance, left, bottom, right, top}} and\n// {{first, "
      "by, seconds}}.\n// clang-format "
      "off\n");
  write("upright", font_of(""));
  write("italic", font_of(":italic"));
  write("bold", font_of(":bold"));
  write("bold_italic", font_of(":bold:italic"));
  fmt::print("// clang-format on\n");
}
