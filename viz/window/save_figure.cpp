#include "viz/window/save_figure.h"
#include "viz/formats.h"

#include <filesystem>

#include "viz/alt_text.h"
#include "viz/compose.h"
#include "viz/files.h"
#include "viz/snapshot.h"

namespace isect::viz {
namespace {

constexpr int figure_width = 960, figure_height = 600;

/// Each pixel of the result is the mean of four, as where figures are made without a window.
Picture halved(const Picture& from) {
  Picture to{from.width / 2, from.height / 2, {}};
  to.rgba.reserve(static_cast<std::size_t>(4) * to.width * to.height);
  const std::size_t row = static_cast<std::size_t>(from.width) * 4;
  for (int y = 0; y < to.height; ++y)
    for (std::size_t x = 0; x < static_cast<std::size_t>(to.width); ++x)
      for (std::size_t c = 0; c < 4; ++c) {
        const std::uint8_t* in = from.rgba.data() + 2 * y * row + 8 * x + c;
        to.rgba.push_back(static_cast<std::uint8_t>((in[0] + in[4] + in[row] + in[row + 4] + 2) / 4));
      }
  return to;
}

}  // namespace

std::string save_figure(const Player& player, const Settings& settings, Renderer& renderer, const std::string& folder) {
  const Place place = player.place();
  const std::string preset = place.preset.empty() ? "changed" : place.preset;
  const std::string path = folder + "/" + place.lesson + "/" + preset + "/" + file_stem(*place.step, player.step()) +
                           "." + settings.save_format;
  const Drawing drawing =
      figure(player.step(), *place.camera, settings.save_theme, figure_width, figure_height).drawing;
  Imprint imprint;
  imprint.title = figure_title(player.lesson(), player.step());
  imprint.alt = alt_text(player.lesson(), player.parameters(), player.walk(), player.index());
  write_file(path, format_named(settings.save_format).write(drawing, metadata(place), imprint, [&](const Drawing& d) {
    renderer.draw(d, 2);
    return halved(renderer.read());
  }));
  return path;
}

std::string save_preset(const Player& player, const std::string& folder) {
  Place place = player.place();
  place.preset.clear(), place.camera.reset(), place.step.reset();
  std::string path;
  for (int i = 1; path.empty() || std::filesystem::exists(path); ++i)
    path = folder + "/" + place.lesson + "/disagreement-" + std::to_string(i) + ".json";
  write_file(path, to_json(place));
  return path;
}

}  // namespace isect::viz
