#pragma once
// What the tests of `isect check` share: accepted baselines in a scratch folder, and ways to make them differ.

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/program/shell.h"
#include "viz/compose.h"
#include "viz/files.h"
#include "viz/place.h"
#include "viz/snapshot.h"

namespace isect::test {

namespace fs = std::filesystem;

inline const std::string check = "isect check ray-sphere --preset two-roots";
inline const std::string baselines = "snapshots/ray-sphere/two-roots";

/// A scratch folder with accepted baselines of one preset.
class Accepted : public Shell {
 public:
  Accepted() {
    const Ran r = (*this)(check + " --update");
    if (r.status != 0) throw std::runtime_error("could not make baselines: " + r.out + r.err);
  }
  fs::path file(const std::string& name) const { return work() / baselines / name; }
};

/// The picture as an earlier isect would have written it for this preset: it said no more than lesson, preset and step.
inline std::string as_of(const std::string& png, const std::string& preset, const std::string& name) {
  const std::string step = std::to_string(std::stoi(name));
  return viz::png(viz::read_png(png), {{"lesson", "ray-sphere"}, {"preset", preset}, {"step", step}});
}

/// A picture that isect did not make.
inline std::string photo() { return viz::png({2, 1, {200, 20, 20, 255, 20, 20, 200, 255}}); }

/// All files below a folder with their bytes.
inline std::map<std::string, std::string> all_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[fs::relative(entry.path(), folder)] = contents(entry.path());
  return files;
}

/// The command that a report says accepts all.
inline std::string accept_command(const std::string& report) {
  const std::size_t line = report.find("to accept "), begin = report.find(": ", line) + 2;
  REQUIRE(line != std::string::npos);
  return report.substr(begin, report.find('\n', begin) - begin);
}

/// The baselines as they would be had the sphere another radius: trace by the library, pictures by render.
inline void accept_with_radius(const Accepted& shell, double radius) {
  const viz::Lesson& lesson = *isect::lessons::all_lessons()[0];
  viz::Parameters parameters = viz::preset(lesson, "two-roots").parameters;
  parameters["radius"] = radius;
  const auto made = nlohmann::json::parse(contents(shell.file("trace.json")))["made with"];
  const viz::Stamp stamp{made["renderer"], made["font"], made["theme"], made["size"]};
  const viz::Walk walk = lesson.walk(parameters);
  std::vector<viz::Walk> walks;
  for (const viz::Preset& p : lesson.presets) walks.push_back(lesson.walk(p.parameters));
  constexpr viz::ThemeName theme = viz::ThemeName::screen;
  const viz::Camera camera =
      viz::frame_alike(lesson.camera, walk, walks, viz::picture_aspect(walk, theme, 960, 600));
  std::vector<viz::Drawing> drawings;
  for (const viz::Step& step : walk.steps)
    drawings.push_back(viz::figure(step, camera, theme, 960, 600).drawing);
  write(shell.file("trace.json"), viz::trace_json(lesson, "two-roots", parameters, walk, drawings, stamp));
  REQUIRE(shell("isect render ray-sphere --preset two-roots --out other --set radius=" + viz::to_text(radius))
              .status == 0);
  for (const auto& folder : fs::directory_iterator(shell.work() / "other/ray-sphere"))
    for (const auto& file : fs::directory_iterator(folder))
      if (file.path().extension() == ".png")
        write(shell.file(file.path().filename()), as_of(contents(file), "two-roots", file.path().filename()));
  fs::remove_all(shell.work() / "other");
}

/// The file of a preset that is quickly drawn.
inline std::string scene(const std::string& preset) {
  return R"({"lesson": "intervals", "preset": ")" + preset + "\"}";
}

inline double radius() {
  const viz::Lesson& lesson = *isect::lessons::all_lessons()[0];
  return std::get<double>(viz::preset(lesson, "two-roots").parameters.at("radius"));
}

}  // namespace isect::test
