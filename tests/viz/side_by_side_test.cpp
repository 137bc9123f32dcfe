// The window where a lesson has a map of cases, and methods that may differ.

#include <filesystem>
#include <fstream>
#include <sstream>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/scratch.h"
#include "tests/viz/window_driver.h"
#include "viz/chart/case_map.h"
#include "viz/chart/chart.h"
#include "viz/player/reader_state.h"
#include "viz/walk/closing.h"
#include "viz/window/palette.h"

namespace side_by_side_test {
using namespace isect;
using namespace isect::viz;

namespace {

std::string read(const std::filesystem::path& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("the setting follows the pointer on the map of cases, and one undo takes the drag back", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("sphere-sphere", "overlapping"));
  window.ui.player().go_to(outcome(window.player().walk()) + 1);
  window.frames();
  REQUIRE(window.player().step().slug == case_map_slug);
  const Parameters before = window.player().parameters();
  const auto branch = [&] { return window.player().lesson().map->branch(window.player().parameters()); };
  const int overlapping = branch();

  // Drags from the region of overlap, at a distance of 1.5, to that of disjoint balls, at 2.5 and a small radius.
  const Rect scene = window.rect("scene");
  const Cases& cases = std::get<Cases>(window.player().step().scene.chart->kind);
  const Theme look = palette(ThemeName::dark).theme;
  const Box2 plane = plane_of(cases, {scene.left, scene.top + 64}, scene.width(), scene.height() - 64, look);
  const auto x = [&](double d) {
    return static_cast<float>(plane.lo.x() + d / cases.x.hi * (plane.hi.x() - plane.lo.x()));
  };
  const auto y = [&](double r) {
    return static_cast<float>(plane.hi.y() - r / cases.y.hi * (plane.hi.y() - plane.lo.y()));
  };
  window.drag(x(1.5), y(1.5), x(2.5), y(0.5));
  CHECK(branch() != overlapping);
  const Vec2 now = window.player().lesson().map->place(window.player().parameters());
  CHECK(now.x() == Approx(2.5).margin(0.05));
  CHECK(now.y() == Approx(0.5).margin(0.05));
  CHECK(window.player().step().slug == case_map_slug);  // still on the map

  window.key(key::z, true);
  CHECK((window.player().parameters() == before));
  window.drag(scene.left + 3, scene.top + 3, x(2.5), y(0.5));  // beside the plane
  CHECK((window.player().parameters() == before));
}

TEST_CASE("the alarm shows where methods differ, and keeps the setting as a preset that loads", "[window]") {
  const std::filesystem::path folder = isect::test::scratch("isect-side-by-side");
  std::filesystem::remove_all(folder);
  WindowOptions options{.reduced_motion = true};
  options.figures = folder;
  WindowDriver window(lessons::all_lessons(), 1280, 1400, place_at("sphere-sphere", "overlapping"), {}, options);
  CHECK_FALSE(window.player().played().methods_differ());
  CHECK_FALSE(window.has("methods side by side"));  // the answer stays hidden until the outcome
  window.ui.player().go_to(outcome(window.player().walk()));
  window.frames(2);
  CHECK(window.has("methods side by side"));
  CHECK_FALSE(window.has("alarm"));
  CHECK_FALSE(window.has("save preset"));

  window.player().load(preset(window.player().lesson(), "touching"));
  window.ui.player().go_to(outcome(window.player().walk()));
  window.frames(2);
  REQUIRE(window.player().played().methods_differ());
  CHECK(window.has("alarm"));
  window.click("save preset");
  window.frames(2);
  window.click("save preset");  // another file, the first one is kept
  window.frames(2);
  const std::filesystem::path kept = folder / "sphere-sphere" / "disagreement-1.json";
  REQUIRE(std::filesystem::exists(kept));
  CHECK(std::filesystem::exists(folder / "sphere-sphere" / "disagreement-2.json"));
  const ReaderState loaded = reader_state_from_json(read(kept), lessons::all_lessons());
  CHECK(loaded.lesson == "sphere-sphere");
  CHECK((*loaded.parameters == window.player().parameters()));
  std::filesystem::remove_all(folder);
}

TEST_CASE("what methods say is held against the exact one, which comes first", "[window]") {
  int lessons_with_opinions = 0, alarms = 0;
  for (const Lesson* lesson : lessons::all_lessons()) {
    if (!lesson->opinions) continue;
    ++lessons_with_opinions;
    for (const Preset& p : lesson->presets) {
      INFO(lesson->id << " " << p.id);
      const std::vector<Opinion> said = lesson->opinions(p.parameters);
      if (said.empty()) continue;  // no method to ask of this one
      REQUIRE(said.size() >= 2);
      CHECK(said.front().method == "exact");
      CHECK(said.front().agrees);
      for (const Opinion& o : said) {
        CHECK((o.agrees || o.says != said.front().says));
        alarms += !o.agrees;
      }
    }
  }
  CHECK(lessons_with_opinions >= 5);
  CHECK(alarms > 0);
}

}  // namespace side_by_side_test
