#include "viz/font/table.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <string_view>
#include <vector>

#include "viz/text/rich_text.h"
#include "viz/text/utf8.h"

namespace isect::viz {
namespace {

/// A glyph in thousandths of the font's size: the advance, and the box of the ink, upwards from the baseline.
struct GlyphBox {
  char32_t code;
  short advance, left, bottom, right, top;
};
/// A character, and the characters that are moved nearer to it, or farther away, when they follow it.
struct Kern {
  char32_t first;
  short by;
  std::u32string_view seconds;
};

#include "viz/font/table.inc"

/// Letters for which the table has one glyph: "ff", "fi", "fl", "ffi", "ffl".
constexpr std::array<std::pair<std::u32string_view, char32_t>, 5> ligatures = {
    {{U"ffi", 0xFB03}, {U"ffl", 0xFB04}, {U"ff", 0xFB00}, {U"fi", 0xFB01}, {U"fl", 0xFB02}}};

struct FaceTable {
  std::span<const GlyphBox> glyphs;
  std::span<const Kern> kerns;

  const GlyphBox* glyph(char32_t code) const {
    const auto at = std::lower_bound(glyphs.begin(), glyphs.end(), code,
                                     [](const GlyphBox& g, char32_t wanted) { return g.code < wanted; });
    return at != glyphs.end() && at->code == code ? &*at : nullptr;
  }
  double kern(char32_t first, char32_t second) const {
    auto k = std::lower_bound(kerns.begin(), kerns.end(), first,
                              [](const Kern& kern, char32_t wanted) { return kern.first < wanted; });
    for (; k != kerns.end() && k->first == first; ++k)
      if (k->seconds.find(second) != k->seconds.npos) return k->by;
    return 0;
  }
};

FaceTable face(bool italic, bool bold) {
  if (italic && bold) return {bold_italic_glyphs, bold_italic_kerns};
  if (italic) return {italic_glyphs, italic_kerns};
  if (bold) return {bold_glyphs, bold_kerns};
  return {upright_glyphs, upright_kerns};
}

/// Returns the codes of a run's glyphs; a ligature is one glyph.
std::u32string glyphs_of(const Run& run, const FaceTable& font) {
  const std::u32string all = code_points(run.text);
  std::u32string codes;
  for (std::size_t i = 0; i < all.size();) {
    const auto joined = std::ranges::find_if(ligatures, [&](const auto& l) {
      return std::u32string_view(all).substr(i, l.first.size()) == l.first && font.glyph(l.second);
    });
    codes += joined == ligatures.end() ? all[i] : joined->second;
    i += joined == ligatures.end() ? 1 : joined->first.size();
  }
  return codes;
}

}  // namespace

TextBox measured_by_table(const Text& text) {
  constexpr double unknown = 500;
  TextBox ink = {1e9, 1e9, -1e9, -1e9};  // in thousandths of the size, from the start on the baseline, downwards
  double at = 0;
  for (const Run& run : parse_markup(text.markup)) {
    const FaceTable font = face(run.italic, run.bold || text.bold);
    const bool base = run.script == Run::Script::base;
    const double size = base ? 1 : script_size;
    const double rise = base ? 0 : 1000 * (run.script == Run::Script::sub ? sub_rise : super_rise);
    char32_t before = 0;
    for (const char32_t code : glyphs_of(run, font)) {
      if (before) at += size * font.kern(before, code);
      before = code;
      const GlyphBox* const g = font.glyph(code);
      if (g && g->right > g->left) {
        ink.left = std::min(ink.left, at + size * g->left);
        ink.right = std::max(ink.right, at + size * g->right);
        ink.top = std::min(ink.top, -rise - size * g->top);
        ink.bottom = std::max(ink.bottom, -rise - size * g->bottom);
      }
      at += size * (g ? g->advance : unknown);
    }
  }
  const double scale = text.size / 1000, x = text.at.x() - text.align * scale * at, y = text.at.y();
  if (!(ink.right > ink.left && scale > 0)) return {x, y, x, y};
  return {x + scale * ink.left, y + scale * ink.top, x + scale * ink.right, y + scale * ink.bottom};
}

bool table_knows(const Text& text) {
  for (const Run& run : parse_markup(text.markup)) {
    const FaceTable font = face(run.italic, run.bold || text.bold);
    for (const char32_t code : glyphs_of(run, font))
      if (!font.glyph(code)) return false;
  }
  return true;
}

}  // namespace isect::viz
