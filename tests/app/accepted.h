#pragma once
// What the tests of `isect check` share: accepted baselines in a scratch folder, and ways to make them differ.

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "lessons/lessons.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/chart/case_map.h"
#include "viz/compose/compose.h"
#include "viz/formats/files.h"
#include "viz/player/reader_state.h"
#include "viz/snapshot/snapshot.h"

namespace isect::test {

namespace fs = std::filesystem;

/// A preset with its baselines. Each of its steps has a picture.
struct Subject {
  std::string lesson, preset;

  std::string check() const { return "isect check " + lesson + " --preset " + preset; }
  std::string baselines() const { return "snapshots/" + lesson + "/" + preset; }
};
inline const Subject intervals = {"intervals", "overlapping"};  ///< quickly drawn, in four steps
inline const Subject ball = {"ray-sphere", "two-roots"};        ///< in space
inline const std::string check = intervals.check();
inline const std::string baselines = intervals.baselines();

/// A scratch folder with accepted baselines of one preset.
class Accepted : public Shell {
 public:
  explicit Accepted(Subject of = intervals) : subject(std::move(of)) {
    const Ran r = (*this)(subject.check() + " --update");
    if (r.status != 0) throw std::runtime_error("could not make baselines: " + r.out + r.err);
  }
  fs::path file(const std::string& name) const { return work() / subject.baselines() / name; }

  const Subject subject;
};

/// The picture as an earlier isect wrote it for this preset: with lesson, preset and step as its only metadata.
inline std::string as_of(const std::string& png, const Subject& subject, const std::string& name) {
  const std::string step = std::to_string(std::stoi(name));
  return viz::png(viz::read_png(png), {{"lesson", subject.lesson}, {"preset", subject.preset}, {"step", step}});
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

/// The command that accepts all changes, as a report gives it.
inline std::string accept_command(const std::string& report) {
  const std::size_t line = report.find("to accept "), begin = report.find(": ", line) + 2;
  REQUIRE(line != std::string::npos);
  return report.substr(begin, report.find('\n', begin) - begin);
}

/// The value of a parameter in the subject's preset.
inline double number(const Subject& subject, const std::string& parameter) {
  const viz::Lesson& lesson = viz::lesson_named(isect::lessons::all_lessons(), subject.lesson);
  return std::get<double>(viz::preset(lesson, subject.preset).parameters.at(parameter));
}

/// Accepts baselines that are made with another value of a parameter: trace by the library, pictures by render.
inline void accept_with(const Accepted& shell, const std::string& parameter, double value) {
  const auto& [id, preset] = shell.subject;
  const viz::Lesson& lesson = viz::lesson_named(isect::lessons::all_lessons(), id);
  viz::Parameters parameters = viz::preset(lesson, preset).parameters;
  parameters[parameter] = value;
  const auto made = nlohmann::json::parse(contents(shell.file("trace.json")))["made with"];
  const viz::Stamp stamp{made["renderer"], made["font"], made["theme"], made["size"]};
  const viz::Walk walk = viz::walk_with_map(lesson, parameters);
  std::vector<viz::Walk> walks;
  for (const viz::Preset& p : lesson.presets) walks.push_back(lesson.walk(p.parameters));
  constexpr viz::ThemeName theme = viz::ThemeName::screen;
  const viz::Camera camera =
      viz::frame_alike(viz::opening(lesson), walk, walks, viz::picture_aspect(walk, theme, 960, 600));
  std::vector<viz::Drawing> drawings;
  for (const viz::Step& step : walk.steps) drawings.push_back(viz::figure(step, camera, theme, 960, 600).drawing);
  write(shell.file("trace.json"), viz::trace_json(lesson, preset, parameters, walk, drawings, stamp));
  REQUIRE(shell("isect render " + id + " --preset " + preset + " --out other --set " + parameter + "=" +
                viz::to_text(value))
              .status == 0);
  for (const auto& folder : fs::directory_iterator(shell.work() / "other" / id))
    for (const auto& file : fs::directory_iterator(folder))
      if (file.path().extension() == ".png" && fs::exists(shell.file(file.path().filename())))
        write(shell.file(file.path().filename()), as_of(contents(file), shell.subject, file.path().filename()));
  fs::remove_all(shell.work() / "other");
}

/// Accepts a change that shows in the pictures and needs no other steps.
inline void accept_other_interval(const Accepted& shell) {
  accept_with(shell, "b_min", number(shell.subject, "b_min") - 0.25);
}

/// The file of a preset that is quickly drawn.
inline std::string scene(const std::string& preset) {
  return R"({"lesson": "intervals", "preset": ")" + preset + "\"}";
}

}  // namespace isect::test
