#include "viz/formats/formats.h"

#include <fmt/format.h>

#include <algorithm>

#include "viz/formats/animation.h"
#include "viz/formats/tikz.h"
#include "viz/lesson.h"
#include "viz/text/spelling.h"

namespace isect::viz {
/// Draws the pixels. Pixels without a ground are computed from how they look on black and on white.
Picture pixels_of(const Drawing& drawing, const Rasteriser& pixels) {
  if (drawing.background.a > 0) return pixels(drawing);
  Drawing on_black = drawing, on_white = drawing;
  on_black.background = hex(0x000000), on_white.background = hex(0xFFFFFF);
  return see_through(pixels(on_black), pixels(on_white));
}

const std::vector<Format>& formats() {
  static const std::vector<Format> all = {
      {"png", true,
       [](const Drawing& drawing, const Metadata& data, const Imprint& imprint, const Rasteriser& pixels) {
         return png(pixels_of(drawing, pixels), data, imprint);
       },
       png_metadata},
      {"svg", false,
       [](const Drawing& drawing, const Metadata& data, const Imprint& imprint, const Rasteriser&) {
         return svg(drawing, data, imprint);
       },
       svg_metadata},
      {"pdf", false,
       [](const Drawing& drawing, const Metadata& data, const Imprint& imprint, const Rasteriser&) {
         return pdf(drawing, data, imprint);
       },
       pdf_metadata},
      {"tikz", false,
       [](const Drawing& drawing, const Metadata& data, const Imprint& imprint, const Rasteriser&) {
         return tikz(drawing, data, imprint);
       },
       tikz_metadata},
      {"gif", true, nullptr, gif_metadata, gif},
      {"apng", true, nullptr, png_metadata, apng},
      {"mp4", true, nullptr, mp4_metadata, mp4, can_write_mp4, "ffmpeg"},
  };
  return all;
}

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const Format& format : formats()) names.push_back(format.name);
  return names;
}

std::vector<std::string> still_format_names() {
  std::vector<std::string> names;
  for (const Format& format : formats())
    if (format.write) names.push_back(format.name);
  return names;
}

const Format& format_named(const std::string& name) {
  if (name == "eps")
    throw BadInput(
        "format: EPS knows no transparency, so shaded parts would become pixels; give pdf, which LaTeX takes");
  const auto found = std::ranges::find(formats(), name, &Format::name);
  for (const auto& [other, ours] : {std::pair{"tex", "tikz"},
                                    {"latex", "tikz"},
                                    {"pgf", "tikz"},
                                    {"jpg", "png"},
                                    {"jpeg", "png"},
                                    {"ps", "pdf"},
                                    {"webm", "mp4"}})
    if (name == other)
      throw BadInput(fmt::format("format: \"{}\" is unknown; did you mean \"{}\"? Allowed: {}", name, ours,
                                 spelling::listed(format_names())));
  if (found == formats().end()) throw unknown("format", name, format_names());
  return *found;
}

const Format* format_of(const std::string& file) {
  const auto found =
      std::ranges::find_if(formats(), [&](const Format& format) { return file.ends_with("." + format.name); });
  return found == formats().end() ? nullptr : &*found;
}

}  // namespace isect::viz
