#include "app/figure_place.h"

#include <fmt/format.h>

#include "app/piece.h"
#include "app/scene/lesson.h"
#include "viz/files.h"

namespace isect::program {

FigurePlace place_in_figure(const Program& program, const std::string& path, const viz::Format& format,
                            std::vector<const viz::Lesson*>& to) {
  const std::string bytes = viz::read_file(path);
  try {
    const viz::Metadata data = format.metadata(bytes);
    if (data.empty())
      throw viz::BadInput(
          fmt::format("it carries no isect metadata: isect did not make it, or the program that saved it "
                      "last removed it. "
                      "Name its place instead: {}--preset P --step N",
                      program.only ? "" : "LESSON "));
    if (data.contains("scene")) to.push_back(&scene::kept_lesson_of(data.at("scene"), ""));
    return {viz::place_from_metadata(data, to), steps_of(data)};
  } catch (const viz::BadInput& e) {
    throw viz::BadInput(fmt::format("{}: {}", path, e.what()));
  } catch (const viz::FileError& e) {
    throw viz::FileError(fmt::format("{}: {}", path, e.what()));
  }
}

}  // namespace isect::program
