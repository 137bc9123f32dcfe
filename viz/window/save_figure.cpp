#include "viz/window/save_figure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "viz/compose/compose.h"
#include "viz/compose/paper.h"
#include "viz/formats/files.h"
#include "viz/formats/formats.h"
#include "viz/snapshot/snapshot.h"
#include "viz/walk/alt_text.h"
#include "viz/window/save_place.h"

namespace isect::viz {
namespace {

constexpr int figure_width = 960, figure_height = 600;

/// Halves a picture: each pixel is the mean of four, as where figures are made without a window.
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

namespace {

struct Made {
  Drawing drawing;
  Imprint imprint;
  double scale;  ///< pixels per unit of the drawing
};

Made for_screen(const Player& player, const Settings& settings, const Walk& walk) {
  const Camera& camera = player.camera().goal();
  const PageLayout page = page_layout(walk, settings.save_theme, figure_width, figure_height);
  return {figure(walk.steps[static_cast<std::size_t>(player.index())], camera, page).drawing, {}, 1};
}

/// Makes the figure as seen here, and no narrower than its labels need.
Made on_paper(const Player& player, const Settings& settings, const Walk& walk) {
  constexpr double points_a_cm = 72 / 2.54, dpi = 300;
  const PaperSize size = {settings.save_width_cm * points_a_cm, 0, usual_text_size};
  std::optional<OnPaper> made = readable_figure(walk, player.index(), settings.save_theme, size, true,
                                                [&](double) { return player.camera().goal(); });
  if (!made)
    throw BadInput(
        fmt::format("At {} cm the labels of this figure meet or leave it; give more", shown(settings.save_width_cm)));
  Made result = {std::move(made->figure.drawing), {}, dpi / 72};
  result.imprint.width_pt = result.drawing.width, result.imprint.dpi = dpi;
  return result;
}

/// Makes the figure of the step on show, at the time that it is drawn at; `walk`: drawn_walk().
Made made_of(const Player& player, const Settings& settings, const Walk& walk) {
  return settings.save_width_cm > 0 ? on_paper(player, settings, walk) : for_screen(player, settings, walk);
}

}  // namespace

namespace {

bool is_free_for(const std::string& path, const std::string& bytes) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return true;
  try {
    return read_regular_file(path) == bytes;
  } catch (const FileError&) {  // some other file
    return false;
  }
}

/// A file that is to be written beside others of its name.
struct NamedFile {
  std::string ending;
  const std::string& bytes;
};

/// Returns the stem, with a number if another file has the name of one of these.
std::string free_stem(const std::string& wanted, const std::vector<NamedFile>& files) {
  const auto is_free = [&](const std::string& stem) {
    return std::ranges::all_of(
        files, [&](const NamedFile& file) { return is_free_for(stem + "." + file.ending, file.bytes); });
  };
  std::string stem = wanted;
  for (int i = 2; !is_free(stem); ++i) stem = wanted + "-" + std::to_string(i);
  return stem;
}

/// Returns <stem>-<N>.json with the first N that no file has.
std::string first_free(const std::string& stem) {
  std::error_code error;
  int number = 1;
  const auto path = [&] { return stem + "-" + std::to_string(number) + ".json"; };
  while (std::filesystem::exists(path(), error)) ++number;
  return path();
}

}  // namespace

/// Returns how it was asked for, in words that `isect render` reads again.
static std::string words_of(const Settings& settings) {
  std::vector<std::string> words;
  if (settings.save_theme != ThemeName::screen)
    words.push_back(fmt::format(R"("theme":"{}")", name_of(settings.save_theme)));
  if (settings.save_width_cm > 0) words.push_back(fmt::format(R"("width":"{}cm")", settings.save_width_cm));
  return fmt::format("{{{}}}", fmt::join(words, ","));
}

std::string usual_stem(const Player& player) {
  const std::string& preset = player.played().preset_id();
  return player.lesson().id + "/" + (preset.empty() ? "changed" : preset) + "/" +
         file_stem(player.index(), player.step());
}

std::string free_path(const std::string& stem, const std::string& ending, const std::string& bytes) {
  return free_stem(stem, {{ending, bytes}}) + "." + ending;
}

std::string save_figure(const Player& player, const Settings& settings, Renderer& renderer, const std::string& folder,
                        const std::string& name) {
  const ReaderState state = player.reader_state();
  const std::string wanted = folder + "/" + (name.empty() ? usual_stem(player) : name);
  const Walk walk = player.drawn_walk();
  Made made = made_of(player, settings, walk);
  made.imprint.title = figure_title(player.lesson(), player.step());
  made.imprint.alt = alt_text(player.lesson(), player.parameters(), walk, player.index());
  Metadata data = metadata(state);
  data["style"] = words_of(settings);
  const std::string figure =
      format_named(settings.save_format).write(made.drawing, data, made.imprint, [&](const Drawing& d) {
        renderer.draw(d, 2 * made.scale);
        return halved(renderer.read());
      });
  const std::string stem = free_stem(wanted, {{settings.save_format, figure}, {"txt", made.imprint.alt}});
  const std::string path = stem + "." + settings.save_format;
  write_file(path, figure);
  write_file(stem + ".txt", made.imprint.alt);
  return whole_path(path);
}

PixelBox draw_preview(const Player& player, const Settings& settings, Renderer& renderer, int most_width,
                      int most_height, std::string& why) {
  try {
    const Made made = made_of(player, settings, player.drawn_walk());
    const double scale = std::min(most_width / made.drawing.width, most_height / made.drawing.height);
    renderer.draw(made.drawing, scale);
    why.clear();
    return pixels(made.drawing, scale);
  } catch (const BadInput& wrong) {
    why = wrong.what();
    return {};
  }
}

std::string save_preset(const Player& player, const std::string& folder, const std::string& name) {
  ReaderState state = player.reader_state();
  state.preset.clear();
  if (!player.camera().moved()) state.camera.reset();  // then each window frames it
  const std::string text = to_json(state), place = folder + "/" + state.lesson + "/";
  const std::string kind = player.played().methods_differ() ? "disagreement" : "setting";
  const std::string path = name.empty() ? first_free(place + kind) : free_path(place + name, "json", text);
  write_file(path, text);
  return whole_path(path);
}

std::vector<std::string> saved_presets(const std::string& folder, const std::vector<std::string>& others) {
  std::vector<std::string> files;
  std::error_code error;
  for (const auto& lesson : std::filesystem::directory_iterator(whole_path(folder), error))
    for (const auto& file : std::filesystem::directory_iterator(lesson.path(), error))
      if (file.path().extension() == ".json" && file.is_regular_file(error)) files.push_back(file.path());
  std::ranges::sort(files);
  for (const std::string& file : others)
    if (std::ranges::find(files, file) == files.end() && std::filesystem::is_regular_file(file, error))
      files.push_back(file);
  return files;
}

}  // namespace isect::viz
