// Shift snaps a drag to where the case changes: found to neighbouring doubles, and exactly where a double is there.

#include <cmath>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/window_driver.h"
#include "viz/closing.h"
#include "viz/snap.h"

namespace snap_test {
using namespace isect;
using namespace isect::viz;
using isect::test::Contains;

namespace {

double number(const Player& player, const std::string& name) { return std::get<double>(player.parameters().at(name)); }

/// Takes hold of a handle and drags it with Shift held.
void drag_with_shift(WindowDriver& window, const std::string& handle, float dx, float dy) {
  const Rect r = window.rect("handle " + handle);
  window.move(r.middle_x(), r.middle_y());
  window.button(true);
  window.modifiers(false, true);
  window.move(r.middle_x() + dx / 2, r.middle_y() + dy / 2);
  window.move(r.middle_x() + dx, r.middle_y() + dy);
  window.modifiers(false, false);
  window.button(false);
}

/// The case where a number is one double less, and where it is one more.
std::pair<std::string, std::string> beside(const Player& player, const std::string& name) {
  Parameters less = player.parameters(), more = less;
  double &low = std::get<double>(less.at(name)), &high = std::get<double>(more.at(name));
  low = std::nextafter(low, -INFINITY), high = std::nextafter(high, INFINITY);
  return {case_of(player.lesson(), less), case_of(player.lesson(), more)};
}

}  // namespace

TEST_CASE("an end of an interval snaps to where the intervals touch, exactly", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("intervals", "overlapping"));
  const Rect a = window.rect("handle a_max"), b = window.rect("handle b_min");
  drag_with_shift(window, "b_min", a.middle_x() - b.middle_x() + 7, 3);  // a little beyond
  CHECK(number(window.player(), "b_min") == number(window.player(), "a_max"));
  CHECK_THAT(window.ui.message(), Contains("exactly"));
  window.drag("handle b_min", 30, 0);  // without Shift it goes on
  CHECK(number(window.player(), "b_min") > number(window.player(), "a_max"));
}

TEST_CASE("where the border is no double, a drag snaps to one of its neighbours, and that is said", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("ray-sphere", "two-roots"));
  const std::string before = case_of(window.player().lesson(), window.player().parameters());
  drag_with_shift(window, "radius", -30, -60);  // until the line passes the ball
  CHECK_THAT(window.ui.message(), Contains("Between two neighbouring doubles"));
  const auto [less, more] = beside(window.player(), "radius");
  CHECK(less != more);
  CHECK((less == before || more == before));
  CHECK(window.player().undo());
  CHECK(number(window.player(), "radius") ==
        std::get<double>(preset(window.player().lesson(), "two-roots").parameters.at("radius")));
}

TEST_CASE("what has snapped stays when Shift is let go before the button", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("intervals", "overlapping"));
  const Rect a = window.rect("handle a_max"), b = window.rect("handle b_min");
  window.move(b.middle_x(), b.middle_y());
  window.button(true);
  window.modifiers(false, true);
  window.move(a.middle_x() + 7, b.middle_y());
  window.modifiers(false, false);
  window.frames(2);
  CHECK(number(window.player(), "b_min") == number(window.player(), "a_max"));
  const Rect toast = window.rect("message");
  CHECK(toast.bottom <= window.rect("changed").top);
  window.move(a.middle_x() + 9, b.middle_y());
  CHECK(number(window.player(), "b_min") > number(window.player(), "a_max"));
  window.button(false);
}

TEST_CASE("a drag on which nothing changes goes where the pointer goes", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("intervals", "overlapping"));
  const double before = number(window.player(), "b_max");
  drag_with_shift(window, "b_max", 12, 0);
  CHECK(number(window.player(), "b_max") > before);
  CHECK(window.ui.message().empty());
}

TEST_CASE("a point snaps onto the edge that its drag crosses", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("crossings", "on-vertex"));
  Player& player = window.player();
  player.edit("p", Vec3(0.5, 0, 0));
  window.frames(2);
  CHECK(case_of(player.lesson(), player.parameters()).find("IN") != std::string::npos);
  const float pixels = window.rect("handle v2").middle_x() - window.rect("handle p").middle_x();  // 1.75
  drag_with_shift(window, "p", pixels * -2 / 1.75f, 0);  // to the vertex v0 at (-1.5, 0)
  CHECK(std::get<Vec3>(player.parameters().at("p")) == Vec3(-1.5, 0, 0));
  CHECK_THAT(window.ui.message(), Contains("exactly"));
}

TEST_CASE("Ctrl, Shift and an arrow take a held handle to where the case changes next", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("intervals", "overlapping"));
  for (int i = 0; i < 200 && window.ui.focus() != "handle b_min"; ++i) window.key(key::down);
  window.key(key::right, true, true);
  CHECK(number(window.player(), "b_min") == number(window.player(), "a_max"));
  CHECK_THAT(window.ui.message(), Contains("exactly"));
  window.key(key::up, true, true);
  CHECK_THAT(window.ui.message(), Contains("does not change"));
}

TEST_CASE("the setting snaps to a border of the map, too", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("sphere-sphere", "overlapping"));
  Player& player = window.player();
  const CaseMap& map = *player.lesson().map;
  window.type("w");
  window.frames(2);
  const Rect plane = window.rect("map plane"), from = window.rect("map setting");
  const Vec2 here = map.place(player.parameters());
  const int branch = map.branch(player.parameters());
  const auto corner = [&](double x, double y) { return Vec2(map.lo + Vec2(x, y).cwiseProduct(map.hi - map.lo)); };
  bool other = false;
  for (const auto& [x, y] : {std::pair{0.02, 0.98}, {0.98, 0.98}, {0.02, 0.02}, {0.98, 0.02}}) {
    if (map.branch(map.moved(player.parameters(), corner(x, y))) == branch) continue;
    other = true;
    window.move(from.middle_x(), from.middle_y());
    window.button(true);
    window.modifiers(false, true);
    window.move(plane.left + static_cast<float>(x) * plane.width(),
                plane.bottom - static_cast<float>(y) * plane.height());
    window.modifiers(false, false);
    window.button(false);
    break;
  }
  REQUIRE(other);
  CHECK(map.place(player.parameters()) != here);
  CHECK((window.ui.message().find("exactly") != std::string::npos ||
         window.ui.message().find("neighbouring doubles") != std::string::npos));
}

TEST_CASE("in every lesson a drag that changes the case snaps to a border between cases", "[snap]") {
  int snapped = 0;
  for (const Lesson* lesson : lessons::all_lessons()) {
    const Parameters& setting = lesson->presets.front().parameters;
    const Walk walk = lesson->walk(setting);
    for (const Handle& h : walk.steps.front().scene.handles) {
      INFO(lesson->id << " " << h.parameter);
      const Way way = way_of(*lesson, setting, h, h.at, h.at + Vec3(1.5, 0.75, 0));
      const auto found = find_border(*lesson, way, 0, 1, 1);
      if (!found) continue;
      ++snapped;
      CHECK_NOTHROW(validate(*lesson, found->setting));
      CHECK(found->exact == (found->told.find("exactly") != std::string::npos));
      if (found->exact) CHECK(case_of(*lesson, found->setting) != case_of(*lesson, setting));
    }
  }
  CHECK(snapped > 10);
}

}  // namespace snap_test
