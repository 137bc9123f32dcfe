// The map of cases beside the scene: dragging either moves both, and the step keeps its role.

#include "viz/player/map_beside.h"
#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/window_driver.h"
#include "viz/chart/case_map.h"
#include "viz/walk/closing.h"

namespace map_beside_test {
using namespace isect;
using namespace isect::viz;

namespace {

bool apart(const Rect& a, const Rect& b) {
  return a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
}

int branch(WindowDriver& window) { return window.player().lesson().map->branch(window.player().parameters()); }
Vec2 place(WindowDriver& window) { return window.player().lesson().map->place(window.player().parameters()); }

}  // namespace

TEST_CASE("W and a button show the map beside the scene at any step, and hide it", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("sphere-sphere", "overlapping"));
  CHECK_FALSE(window.has("map"));
  window.type("w");
  REQUIRE(window.has("map"));
  CHECK(apart(window.rect("scene"), window.rect("map")));
  for (int i = 0; i < window.player().count(); ++i) {
    window.player().go_to(i);
    window.frames(2);
    CHECK(window.has("map") == (window.player().step().slug != case_map_slug));  // which is the map itself
  }
  window.player().go_to(0);
  window.frames(2);
  CHECK(window.ui.settings().map);
  window.click("show map");
  CHECK_FALSE(window.has("map"));
  CHECK_FALSE(window.ui.settings().map);
  window.player().open(*lessons::all_lessons().front());
  for (const Lesson* lesson : lessons::all_lessons())
    if (!lesson->map) window.player().open(*lesson);
  window.frames(2);
  window.type("w");
  CHECK_FALSE(window.has("map"));
  CHECK(window.ui.message() == "This lesson has no map of cases");
}

TEST_CASE("a setting that has no place on the map stands without it", "[window]") {
  Settings settings;
  settings.map = true;
  const std::vector<const Lesson*> all = lessons::all_lessons();
  WindowDriver window(all, 1280, 800, place_at("bounding-volumes", "tilted"), settings);
  CHECK_FALSE(window.has("map"));
  window.type("w");
  CHECK(window.ui.message() == "This setting has no place on the map of cases");
  window.player().load(preset(lesson_named(all, "bounding-volumes"), "reject"));
  window.frames(2);
  CHECK(window.has("map"));
  CHECK(window.ui.message().empty());
}

TEST_CASE("dragging over the map moves scene and setting, and the verdict stays a verdict", "[window]") {
  Settings settings;
  settings.map = true;
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("sphere-sphere", "overlapping"), settings);
  window.player().go_to(outcome(window.player().walk()));
  window.frames(2);
  const int overlapping = branch(window);
  const Parameters before = window.player().parameters();
  const Rect plane = window.rect("map plane"), marker = window.rect("map setting");
  const std::string verdict = window.player().step().verdict.text;

  // The drag goes to the lower right: far apart and small.
  window.move(marker.middle_x(), marker.middle_y());
  window.button(true);
  for (int i = 1; i <= 8; ++i) {
    const float share = static_cast<float>(i) / 8;
    window.move(marker.middle_x() + share * (plane.right - 40 - marker.middle_x()),
                marker.middle_y() + share * (plane.bottom - 30 - marker.middle_y()));
    CHECK(window.player().index() == outcome(window.player().walk()));
    CHECK(window.rect("map setting").middle_x() == Approx(ImGui::GetIO().MousePos.x).margin(1));
    CHECK(window.rect("map setting").middle_y() == Approx(ImGui::GetIO().MousePos.y).margin(1));
  }
  CHECK(branch(window) != overlapping);
  CHECK(window.player().step().verdict.text != verdict);
  CHECK(window.has("trail crossing 1"));
  const Rect trail = window.rect("trail");
  CHECK(trail.left == Approx(marker.middle_x()).margin(1));
  CHECK(trail.bottom == Approx(plane.bottom - 30).margin(1));
  window.button(false);
  CHECK(window.has("trail"));  // it stays to be looked at

  window.key(key::z, true);
  CHECK((window.player().parameters() == before));
  window.frames();
  CHECK_FALSE(window.has("trail"));
}

TEST_CASE("the marker follows a handle that is dragged, across a border, and the drag goes on", "[window]") {
  Settings settings;
  settings.map = true;
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("sphere-sphere", "overlapping"), settings);
  window.player().go_to(outcome(window.player().walk()));
  window.frames(2);
  const Handle handle = window.player().scene().handles.front();
  const int overlapping = branch(window);
  Rect before = window.rect("map setting");
  const Rect grip = window.rect("handle " + handle.id());
  int moves = 0, left = 0, back = 0;
  window.move(grip.middle_x(), grip.middle_y());
  window.button(true);
  for (int i = 1; i <= 20; ++i) {  // far to the left and back again
    window.move(grip.middle_x() - 30 * static_cast<float>(i <= 10 ? i : 20 - i), grip.middle_y());
    window.frames();
    const Rect now = window.rect("map setting");
    moves += now.middle_x() != before.middle_x() || now.middle_y() != before.middle_y();
    before = now;
    (branch(window) != overlapping ? left : back) += 1;
    CHECK(window.player().index() == outcome(window.player().walk()));
  }
  window.button(false);
  CHECK(moves == 20);
  CHECK(left > 0);
  CHECK(back > 0);
  CHECK(branch(window) == overlapping);
  CHECK(window.has("trail crossing 2"));
}

TEST_CASE("with the keyboard alone Shift and the arrows move the setting on the map", "[window]") {
  Settings settings;
  settings.map = true;
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("sphere-sphere", "overlapping"), settings);
  const Camera home = window.player().camera().goal();
  const Vec2 before = place(window);
  const Rect marker = window.rect("map setting");
  for (int i = 0; i < 200 && window.ui.focus() != "map setting"; ++i) window.key(key::down);
  REQUIRE(window.ui.focus() == "map setting");
  window.key(key::right, false, true);
  window.frames();
  CHECK(place(window).x() > before.x());
  CHECK(place(window).y() == Approx(before.y()));
  CHECK(window.rect("map setting").middle_x() == Approx(marker.middle_x() + 8).margin(0.5));
  CHECK(window.player().camera().goal().azimuth == home.azimuth);
  CHECK(window.player().camera().goal().target == home.target);
}

TEST_CASE("no name of a case meets another, in the least window either", "[window]") {
  const bool panels = GENERATE(true, false);
  WindowDriver window(lessons::all_lessons(), 800, 600, {}, {}, names_only);
  if (!panels) window.key(key::tab);
  int maps = 0;
  for (const Lesson* lesson : lessons::all_lessons()) {
    if (!lesson->map) continue;
    window.player().open(*lesson);
    window.player().go_to(outcome(window.player().walk()) + 1);
    if (window.player().step().slug != case_map_slug) continue;  // a setting beyond the map
    ++maps;
    window.frames(2);
    const std::vector<PlacedLabel>& labels = window.ui.labels();
    const std::vector<std::string>& names = lesson->map->branches;
    CHECK(labels.size() > 4);
    for (std::size_t i = 0; i < labels.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const TextBox &one = labels[i].box, &two = labels[k].box;
        if (std::ranges::count(names, labels[i].text) + std::ranges::count(names, labels[k].text) == 0) continue;
        INFO(lesson->id << ": " << labels[i].text << ", " << labels[k].text);
        CHECK_FALSE((one.left < two.right && two.left < one.right && one.top < two.bottom && two.top < one.bottom));
      }
  }
  CHECK(maps > 8);
}

TEST_CASE("regions with room for their names keep them where others have none", "[window]") {
  WindowDriver window(lessons::all_lessons(), 800, 600, place_at("intervals", "overlapping"));
  window.player().go_to(outcome(window.player().walk()) + 1);
  REQUIRE(window.player().step().slug == case_map_slug);
  window.frames(2);
  const std::vector<std::string>& names = window.player().lesson().map->branches;
  CHECK(std::ranges::count_if(window.ui.labels(),
                              [&](const PlacedLabel& l) { return std::ranges::count(names, l.text) > 0; }) > 2);
}

TEST_CASE("the map keeps a question's answer to itself", "[window]") {
  Settings settings;
  settings.map = true;
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("sphere-sphere", "overlapping"), settings);
  while (!window.player().quiz().asked()) window.key(key::right);
  CHECK(window.has("map"));
  CHECK_FALSE(window.has("map setting"));
  window.key(key::right);
  CHECK(window.has("map setting"));
}

TEST_CASE("the map does not say where the setting lies before the last question of its outcome", "[window]") {
  Settings settings;
  settings.map = true;
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("sphere-sphere", "overlapping"), settings);
  const auto left = [&] { return window.player().index() < outcome(window.player().walk()); };
  CHECK(window.has("map waits"));
  CHECK(window.has("map setting"));  // it can be moved, over regions without names
  while (!window.player().quiz().asked()) window.key(key::right);
  CHECK(window.has("map waits"));
  for (int i = 0; i < 200 && (left() || window.player().quiz().asked()); ++i) window.key(key::right);
  CHECK_FALSE(left());
  window.frames();
  CHECK(window.has("map tells"));
  CHECK_FALSE(waits_for_answer(window.player()));
}

TEST_CASE("no place of a map is told while a question up to the outcome is still to come", "[player]") {
  Player player(lessons::all_lessons());
  for (const Lesson* lesson : lessons::all_lessons()) {
    if (!lesson->map) continue;
    INFO(lesson->id);
    player.open(*lesson);
    const std::vector<Step>& steps = player.walk().steps;
    for (int i = 0; i < player.count(); ++i) {
      player.go_to(i);
      bool to_come = false;
      for (int k = i + 1; k <= outcome(player.walk()); ++k) to_come = to_come || steps[k].question;
      CHECK(waits_for_answer(player) == to_come);
    }
  }
}

TEST_CASE("a window that a display made too small for the map goes on without it", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("obb-obb", "edges"));
  window.type("w");
  REQUIRE(window.has("map"));
  for (const auto& [width, height] : {std::pair(149.0f, 627.0f), std::pair(700.0f, 40.0f), std::pair(3.0f, 3.0f)}) {
    window.resize(width, height);
    CHECK_NOTHROW(window.frames(3));
  }
  window.resize(1280, 800);
  window.frames(3);
  CHECK(window.has("map plane"));
}

}  // namespace map_beside_test
