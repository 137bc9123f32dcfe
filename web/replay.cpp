// replay SNAPSHOTS: walks every preset and says what differs from its accepted trace; replay: answers a query a line.
// A program for node, which reads the files of the machine.

#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/query/query.h"
#include "lessons/lessons.h"
#include "viz/chart/case_map.h"
#include "viz/compose/compose.h"
#include "viz/snapshot/snapshot.h"

namespace {

using namespace isect;

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Draws the steps as `isect check` does.
std::vector<viz::Drawing> drawings_of(const viz::Lesson& lesson, const viz::Walk& walk,
                                      const std::vector<viz::Walk>& all) {
  constexpr double width = 960, height = 600;
  const double aspect = viz::picture_aspect(walk, viz::ThemeName::screen, width, height);
  const viz::Camera framed = viz::frame_alike(viz::opening(lesson), walk, all, aspect);
  std::vector<viz::Drawing> drawings;
  for (const viz::Step& step : walk.steps)
    drawings.push_back(
        viz::figure(step, viz::closer(framed, step.scene, aspect), viz::ThemeName::screen, width, height).drawing);
  return drawings;
}

int replay(const std::string& snapshots) {
  int presets = 0, steps = 0, differ = 0, said = 0;
  for (const viz::Lesson* lesson : lessons::all_lessons()) {
    std::vector<viz::Walk> walks;
    for (const viz::Preset& p : lesson->presets) walks.push_back(viz::walk_with_map(*lesson, p.parameters));
    for (std::size_t i = 0; i < walks.size(); ++i) {
      const viz::Preset& p = lesson->presets[i];
      const std::string accepted = contents(snapshots + "/" + lesson->id + "/" + p.id + "/trace.json");
      const auto json = nlohmann::json::parse(accepted, nullptr, false);
      if (json.is_discarded()) {
        std::cout << lesson->id << "/" << p.id << ": no trace\n";
        ++differ;
        continue;
      }
      const auto& with = json.at("made with");
      const viz::Stamp stamp = {with.at("renderer"), with.at("font"), with.at("theme"), with.at("size")};
      const std::vector<viz::Drawing> drawings = drawings_of(*lesson, walks[i], walks);
      const auto changes =
          viz::compare_traces(accepted, viz::trace_json(*lesson, p.id, p.parameters, walks[i], drawings, stamp));
      ++presets, steps += static_cast<int>(walks[i].steps.size());
      bool in_words = false;
      for (const viz::Change& change : changes) {
        std::cout << lesson->id << "/" << p.id << ", step " << change.step + 1
                  << (change.of == viz::Change::Of::drawing ? " (drawn)" : "") << ": " << change.what << "\n";
        in_words = in_words || change.of != viz::Change::Of::drawing;
      }
      differ += !changes.empty(), said += in_words;
    }
  }
  std::cout << presets << " presets, " << steps << " steps: " << differ << " differ, " << said << " in what they say\n";
  return differ == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1) return replay(argv[1]);
  for (std::string line; std::getline(std::cin, line);)
    if (!query::blank(line)) std::cout << query::answer(line).text << "\n";
  return 0;
}
