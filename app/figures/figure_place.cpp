#include "app/figures/figure_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/figures/cases.h"
#include "app/figures/figure_info.h"
#include "app/scene/lesson.h"
#include "app/shell/named_file.h"
#include "viz/formats/files.h"

namespace isect::program {

namespace {

/// Returns the folder of the figure's file: "tangent" of "ray-sphere/tangent/03-distance". Empty if it leads elsewhere.
std::string folder_in(const viz::Metadata& data, const std::string& lesson) {
  const auto file = data.find("file");
  if (file == data.end() || !file->second.starts_with(lesson + "/") || file->second.find('\0') != std::string::npos)
    return {};
  const std::filesystem::path folder = std::filesystem::path(file->second.substr(lesson.size() + 1)).parent_path();
  if (folder.is_absolute() || std::ranges::any_of(folder, [](const auto& part) { return part == ".." || part == "."; }))
    return {};
  return folder.string();
}

FigurePlace place_of(const viz::Metadata& data, std::vector<const viz::Lesson*>& to) {
  if (data.contains("scene"))
    to.push_back(&scene::kept_lesson_of(data.at("scene"), ""));
  else if (data.contains("lesson") && data.at("lesson") == "scene")
    throw viz::BadInput("this baseline shows a scene, but does not hold it; name the scene's file instead");
  FigurePlace place;
  place.state = viz::reader_state_from_metadata(data, to);
  place.lesson = &viz::lesson_named(to, place.state.lesson);
  place.steps = steps_of(data);
  place.folder = folder_in(data, place.state.lesson);
  place.style = data.contains("style") ? data.at("style") : "";
  return place;
}

}  // namespace

FigurePlace place_in_figure(const Program& program, const std::string& path, const viz::Format& format,
                            std::vector<const viz::Lesson*>& to) {
  const std::string bytes = read_named_file(path);
  try {
    const viz::Metadata data = format.metadata(bytes);
    if (data.empty())
      throw viz::BadInput(
          fmt::format("it carries no isect metadata: isect did not make it, or the program that saved it "
                      "last removed it. "
                      "Name its place instead: {}--preset P --step N",
                      program.only ? "" : "LESSON "));
    FigurePlace place = place_of(data, to);
    const CasesInFigure all = cases_of(data);
    for (const viz::Metadata& one : all.cases) {
      std::vector<const viz::Lesson*> lessons = program.lessons;  // each with its own scene
      place.cases.push_back(place_of(one, lessons));
    }
    place.scaled_as = all.own;
    return place;
  } catch (const viz::BadInput& e) {
    throw viz::BadInput(fmt::format("{}: {}", path, e.what()));
  } catch (const viz::FileError& e) {
    throw viz::FileError(fmt::format("{}: {}", path, e.what()));
  }
}

}  // namespace isect::program
