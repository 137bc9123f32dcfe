// The line of time below a scene whose shapes move.

#include <cmath>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/window_driver.h"
#include "viz/player/reader_state.h"
#include "viz/player/scene_time.h"

namespace time_strip_test {
using namespace isect;
using namespace isect::viz;

namespace {

const WindowOptions moves = {.reduced_motion = false, .draw_scene = false, .place_names = false};

/// The window at this step of two boxes that meet at 1.625 of 2.
struct Moving : WindowDriver {
  explicit Moving(const std::string& slug, const WindowOptions& options = layout_only, float width = 1280,
                  float height = 800)
      : WindowDriver(lessons::all_lessons(), width, height, place_at("moving-bodies", "boxes-meet"), {}, options) {
    for (int i = 0; i < player().count(); ++i)
      if (player().walk().steps[static_cast<std::size_t>(i)].slug == slug) player().go_to(i);
    REQUIRE(player().step().slug == slug);
    wait(1);
    frames(2);
  }
  /// Where a time stands on the line.
  float place(double t) const {
    const Rect r = rect("time line");
    return r.left + 10 + static_cast<float>(t / 2) * (r.width() - 20);
  }
  /// Lets what is prepared for the next step be done; returns whether all is at rest then.
  bool rests() {
    for (int i = 0; i < 2000 && ui.rest() == 0; ++i) frames();
    return std::isinf(ui.rest());
  }
  float middle() const { return rect("time line").middle_y(); }
};

constexpr double first = 1.625;

}  // namespace

TEST_CASE("K lets time run, slower at the contact that the core found, to the end of the motion", "[window]") {
  Moving window("contact", moves);
  Player& player = window.player();
  REQUIRE(player.time() != nullptr);
  CHECK(player.time()->contact == first);
  CHECK(window.rests());
  window.type("k");
  CHECK(player.time_runs());
  CHECK(window.ui.rest() == 0);
  const auto passed = [&](double from) {
    player.set_time(from);
    window.wait(0.1f);
    return player.now() - from;
  };
  const double usual = 0.1 * 2 / seconds_of_motion;
  CHECK(passed(0.2) == Approx(usual));
  CHECK(passed(first) == Approx(usual / slower));
  CHECK(passed(first - 0.1) == Approx(usual / slower));
  window.type("K");
  CHECK_FALSE(player.time_runs());
  CHECK(passed(0.2) == 0);
  window.click("run time");
  CHECK(player.time_runs());
  window.wait(100);
  CHECK((player.now() == 2 && !player.time_runs()));
  window.wait(1);
  CHECK(window.rests());
}

TEST_CASE("before a step has found the contact, time runs evenly and marks none", "[window]") {
  Moving window("two-bodies", moves);
  Player& player = window.player();
  CHECK_FALSE(player.time()->contact);
  window.type("k");
  player.set_time(first);
  window.wait(0.1f);
  CHECK(player.now() - first == Approx(0.1 * 2 / seconds_of_motion));
  window.type("k");
  const double now = player.now();
  window.type("j");
  CHECK(player.now() == now);
  CHECK(window.ui.message() == "No contact is found up to this step");
}

TEST_CASE("the line is dragged along, no further than the motion, and holds the contact exactly", "[window]") {
  Moving window("contact");
  Player& player = window.player();
  const float y = window.middle();
  window.drag(window.place(0), y, window.place(1), y);
  CHECK(player.now() == Approx(1).epsilon(0.01));
  window.drag(window.place(1), y, window.place(2) + 300, y);
  CHECK(player.now() == 2);
  window.drag(window.place(2), y, window.place(0) - 200, y);
  CHECK(player.now() == 0);
  window.click(window.place(first) + 3, y);
  CHECK(player.now() == first);
  window.click(window.place(first) + 9, y);
  CHECK(player.now() > first);
  const Vec3 tip = player.scene().handles.at(0).at;
  CHECK(tip == player.step().scene.handles.at(0).at);  // handles stay where the setting is
}

TEST_CASE("J leads to the contact and back to the begin, and Shift and the arrows along the line", "[window]") {
  Moving window("contact");
  Player& player = window.player();
  window.type("j");
  CHECK(player.now() == first);
  window.type("j");
  CHECK(player.now() == 0);
  for (int i = 0; i < 200 && window.ui.focus() != "time line"; ++i) window.key(key::down);
  REQUIRE(window.ui.focus() == "time line");
  const int step = player.index();
  window.key(key::right, false, true);
  CHECK(player.now() == Approx(0.05));
  window.key(key::left, false, true);
  CHECK(player.now() == 0);
  CHECK(player.index() == step);
}

TEST_CASE("with reduced motion K shows one still after the other", "[window]") {
  Moving window("contact");
  Player& player = window.player();
  for (const double still : {0.5, 1.0, 1.5, first, 2.0, 0.0}) {
    window.type("k");
    CHECK(player.now() == still);
    CHECK_FALSE(player.time_runs());
  }
}

TEST_CASE("the time's room stays in all steps, and is empty while a question is open", "[window]") {
  for (const bool lecture : {false, true}) {
    Moving window("two-bodies");
    if (lecture) window.key(key::tab);
    const Rect scene = window.rect("scene"), room = window.rect("time");
    CHECK(room.top == scene.bottom);
    CHECK(window.has("time line"));
    window.type("k");
    window.player().next();
    window.frames(2);
    REQUIRE(window.player().quiz().asked());
    CHECK_FALSE(window.has("time line"));
    CHECK_FALSE(window.player().time_is_chosen());
    for (int i = 0; i < window.player().count(); ++i) {
      window.player().go_to(i);
      window.frames(2);
      CHECK(window.rect("scene").height() == scene.height());
      CHECK(window.rect("time").top == room.top);
      CHECK(window.has("time line") == !window.player().scene().chart);
    }
  }
  WindowDriver still(lessons::all_lessons(), 1280, 800, place_at("ray-sphere", ""), {}, layout_only);
  CHECK_FALSE(still.has("time"));
  still.type("k");
  CHECK(still.ui.message() == "Nothing moves in this step");
}

TEST_CASE("the scene is drawn anew at another time", "[window]") {
  Moving window("contact", {.reduced_motion = true});
  const Picture before = window.picture();
  window.player().set_time(1);
  window.frames(2);
  const Picture at_one = window.picture();
  CHECK(at_one.rgba != before.rgba);
  window.player().go_to(window.player().index());
  window.frames(2);
  CHECK(window.picture().rgba == before.rgba);
}

TEST_CASE("the time goes with the copied state, and comes back where that is pasted", "[window]") {
  Moving window("contact");
  window.player().set_time(0.625);
  window.key(key::c, true);
  const std::string copied = ImGui::GetClipboardText();
  CHECK(reader_state_from_json(copied, lessons::all_lessons()).time == 0.625);
  window.key(key::home);
  window.frames(2);
  CHECK_FALSE(window.player().time_is_chosen());
  window.key(key::v, true);
  window.frames(2);
  CHECK((window.player().step().slug == "contact" && window.player().now() == 0.625));
  WindowDriver again(lessons::all_lessons(), 1280, 800, reader_state_from_json(copied, lessons::all_lessons()), {},
                     layout_only);
  CHECK(again.player().now() == 0.625);
}

}  // namespace time_strip_test
