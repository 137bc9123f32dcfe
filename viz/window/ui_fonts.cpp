#include "viz/window/ui_fonts.h"

#include <stdexcept>
#include <string>

#include "viz/font/file.h"

namespace isect::viz {
namespace {

// Latin, Greek, spaces of all widths, punctuation, scripts, letterlike signs, arrows, mathematics, shapes, ticks and
// crosses.
constexpr ImWchar signs[] = {0x0020, 0x00FF, 0x0391, 0x03C9, 0x2000, 0x2027, 0x202F, 0x203A, 0x2070,
                             0x209C, 0x2102, 0x2124, 0x2190, 0x21FF, 0x2200, 0x22FF, 0x25A0, 0x25FF,
                             0x2713, 0x2718, 0x27E8, 0x27E9, 0xFFFD, 0xFFFD, 0};

/// DejaVu's ratio of the height from ascent to descent, by which Dear ImGui measures a font, to the em, by which
/// everybody else does.
constexpr double line_per_em = 1.164;

ImFont* load(const std::string& pattern, double size, double scale) {
  const std::string file = font_file(pattern);
  if (file.empty())
    throw std::runtime_error("no font for the window: fontconfig finds none for \"" + pattern +
                             "\"; install fonts-dejavu-core");
  const float pixels = static_cast<float>(size * line_per_em * scale);
  ImFont* font = ImGui::GetIO().Fonts->AddFontFromFileTTF(file.c_str(), pixels, nullptr, signs);
  if (!font) throw std::runtime_error("cannot read the font file " + file);
  font->Scale = static_cast<float>(1 / scale);
  return font;
}

}  // namespace

UiFonts load_fonts(double scale, double large) {
  return {.body = load("DejaVu Sans", body_size, scale),
          .bold = load("DejaVu Sans:bold", body_size, scale),
          .heading = load("DejaVu Sans:bold", heading_size, scale),
          .mono = load("DejaVu Sans Mono", body_size, scale),
          .mono_large = load("DejaVu Sans Mono", large, scale),
          .large = large};
}

}  // namespace isect::viz
