#include "viz/formats.h"

#include <algorithm>

#include "viz/lesson.h"

namespace isect::viz {

const std::vector<Format>& formats() {
  static const std::vector<Format> all = {
      {"png", true,
       [](const Drawing& drawing, const Metadata& data, const Paper&, const Rasteriser& pixels) {
         return png(pixels(drawing), data);
       },
       png_metadata},
      {"svg", false,
       [](const Drawing& drawing, const Metadata& data, const Paper& paper, const Rasteriser&) {
         return svg(drawing, data, paper);
       },
       svg_metadata},
  };
  return all;
}

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const Format& format : formats()) names.push_back(format.name);
  return names;
}

const Format& format_named(const std::string& name) {
  const auto found = std::ranges::find(formats(), name, &Format::name);
  if (found == formats().end()) throw unknown("format", name, format_names());
  return *found;
}

const Format* format_of(const std::string& file) {
  const auto found =
      std::ranges::find_if(formats(), [&](const Format& format) { return file.ends_with("." + format.name); });
  return found == formats().end() ? nullptr : &*found;
}

}  // namespace isect::viz
