// What a reader does in the window with a whole lesson: keeps a step under the hand, tries exercises, sees a line fail.

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/window_driver.h"
#include "viz/case_map.h"
#include "viz/closing.h"
#include "viz/place.h"

namespace practice_test {
using namespace isect;
using namespace isect::viz;

namespace {

const Lesson& spheres() { return lesson_named(lessons::all_lessons(), "sphere-sphere"); }

Place at(const std::string& preset) {
  Place place;
  place.lesson = "sphere-sphere", place.preset = preset;
  return place;
}

/// What the first exercise asks for.
void find_it(Player& player) {
  for (const auto& [name, text] : spheres().closing->exercises.front().by) {
    Parameters setting = player.parameters();
    set(spheres(), setting, name, text);
    player.edit(name, setting.at(name));
  }
}

}  // namespace

TEST_CASE("an outcome stays the outcome, whatever setting is dragged", "[player]") {
  for (const Lesson* lesson : lessons::all_lessons()) {
    Place place;
    place.lesson = lesson->id;
    Player player({lesson}, place);
    player.go_to(outcome(player.walk()));
    for (const Preset& p : lesson->presets) {
      INFO(lesson->id << " " << p.id);
      for (const auto& [name, value] : p.parameters) {
        try {
          player.edit(name, value);
        } catch (const BadInput&) {  // some are in order only together
          continue;
        }
        CHECK(player.index() == outcome(player.walk()));
      }
    }
  }
}

TEST_CASE("a step keeps its name when the setting changes, and a map that is left gives way to the outcome",
          "[player]") {
  Player player({&spheres()}, at("overlapping"));
  const auto step_named = [&](const std::string& slug) {
    return static_cast<int>(std::ranges::find(player.walk().steps, slug, &Step::slug) - player.walk().steps.begin());
  };
  player.go_to(step_named("compare"));
  player.edit("r2", 0.01);
  CHECK(player.step().slug == "compare");
  player.go_to(step_named(case_map_slug));
  player.edit("r2", 1e5);  // beyond the map
  CHECK(player.index() == outcome(player.walk()));
  player.edit("r2", 1.0);
  CHECK(player.step().slug == case_map_slug);
}

TEST_CASE("an exercise is tried from its own preset, and found when the core says so", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 1400, at("inside"));
  window.key(key::end);
  window.frames(2);
  REQUIRE(window.player().step().slug == closing_slug);
  window.click("solution 2");
  window.click("try 1");
  window.frames(2);
  CHECK(window.player().preset_id() == "overlapping");
  CHECK(window.player().index() == outcome(window.player().walk()));
  REQUIRE(window.has("exercise"));
  CHECK_FALSE(window.player().exercise_solved());
  find_it(window.ui.player());
  window.frames(2);
  CHECK(window.player().exercise_solved());
  CHECK(window.player().step().verdict.kind == Verdict::Kind::on);
  window.click("end exercise");
  window.frames(2);
  CHECK(window.player().step().slug == closing_slug);
  CHECK_FALSE(window.has("exercise"));
}

TEST_CASE("one key shows the published line fail", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 1000, at("overlapping"));
  window.ui.player().go_to(3);
  window.frames(2);
  CHECK(window.has("see it fail"));
  window.type("e");
  window.frames(2);
  CHECK(window.player().preset_id() == "touching");
  CHECK(window.player().walk().pseudocode[window.player().step().line] == spheres().errata.front().published);
  CHECK_FALSE(window.has("see it fail"));  // it does
}

}  // namespace practice_test
