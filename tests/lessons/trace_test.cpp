// What a trace keeps of a drawing is the same on machines that round otherwise.

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "viz/chart/case_map.h"
#include "viz/compose/compose.h"
#include "viz/snapshot/snapshot.h"

namespace trace_test {
using namespace isect::viz;
using isect::lessons::all_lessons;

namespace {

const Stamp stamp = {"llvmpipe", "STIXGeneral, DejaVu Sans", "screen", "960x600"};

/// The trace of the last steps of a walk, seen through this camera.
std::string trace(const Lesson& lesson, const Preset& preset, Walk walk, const Camera& camera) {
  constexpr std::size_t enough = 3;
  if (walk.steps.size() > enough)
    walk.steps.erase(walk.steps.begin(), walk.steps.end() - static_cast<std::ptrdiff_t>(enough));
  std::vector<Drawing> drawings;
  for (const Step& step : walk.steps) drawings.push_back(figure(step, camera, ThemeName::screen, 960, 600).drawing);
  return trace_json(lesson, preset.id, preset.parameters, walk, drawings, stamp);
}

}  // namespace

TEST_CASE("a camera that differs by rounding gives the same trace of every preset", "[trace]") {
  for (const Lesson* lesson : all_lessons())
    for (const Preset& preset : lesson->presets) {
      const Walk walk = walk_with_map(*lesson, preset.parameters);
      const Camera camera =
          frame_alike(lesson->camera, walk, {walk}, picture_aspect(walk, ThemeName::screen, 960, 600));
      Camera other = camera;
      other.azimuth *= 1 + 1e-14;
      other.elevation *= 1 - 1e-14;
      other.half_height *= 1 + 1e-14;
      other.target += 1e-14 * camera.half_height * Vec3(1, -1, 1);
      INFO(lesson->id << " " << preset.id);
      const std::vector<Change> changes =
          compare_traces(trace(*lesson, preset, walk, camera), trace(*lesson, preset, walk, other));
      CHECK((changes.empty() ? "no change" : changes.front().what) == std::string("no change"));
    }
}

}  // namespace trace_test
