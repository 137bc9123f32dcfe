// A walk goes on at every step: no step shows and says what the one before did.

#include "tests/catch.h"
#include "tests/lessons/asked_for.h"
#include "viz/chart/case_map.h"
#include "viz/compose/compose.h"
#include "viz/formats/files.h"

namespace runs_test {
using namespace isect;
using namespace isect::viz;

namespace {

/// All shapes of a scene but the grips of its handles.
std::string picture(const Step& step, const Camera& camera) {
  Drawing drawing = {960, 430, {}, {}, {}};
  Composed composed = compose(step.scene, View(camera, 960, 430), theme(ThemeName::screen, 960, 600));
  drawing.shapes = std::move(composed.shapes), drawing.objects = std::move(composed.objects);
  return svg(drawing);
}

/// What stands beside the picture: names and values.
std::string values(const Step& step) {
  std::string all = step.verdict.text + '\n' + step.formula + '\n';
  for (const Value& v : step.values) all += v.name + ' ' + std::to_string(v.value) + v.unit + '\n';
  return all;
}

}  // namespace

TEST_CASE("no two steps in a row have one picture, caption and values", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for())
    for (const Preset& preset : lesson->presets) {
      const Walk walk = walk_with_map(*lesson, preset.parameters);
      const Camera camera = frame_alike(lesson->camera, walk, {walk}, 960.0 / 430);
      std::string before;
      for (std::size_t i = 0; i < walk.steps.size(); ++i) {
        std::string now = picture(walk.steps[i], camera);
        INFO(lesson->id << ' ' << preset.id << ", " << walk.steps[i].slug);
        if (i > 0 && now == before) {
          const Step &a = walk.steps[i - 1], &b = walk.steps[i];
          CHECK_FALSE((a.caption == b.caption && values(a) == values(b)));
        }
        before = std::move(now);
      }
    }
}

TEST_CASE("no two steps in a row have one title", "[every lesson]") {
  for (const Lesson* lesson : those_asked_for())
    for (const Preset& preset : lesson->presets) {
      const Walk walk = lesson->walk(preset.parameters);
      for (std::size_t i = 1; i < walk.steps.size(); ++i) {
        INFO(lesson->id << ' ' << preset.id << ", " << walk.steps[i].slug);
        CHECK(walk.steps[i].title != walk.steps[i - 1].title);
      }
    }
}

}  // namespace runs_test
