// A playlist in the window: where one is, on and back by keys and buttons, the list of stops, notes, a stop that can't
// be opened, and what is kept.

#include <filesystem>

#include "tests/catch.h"
#include "tests/scratch.h"
#include "tests/viz/playlists.h"
#include "tests/viz/sample_lesson.h"
#include "tests/viz/window_driver.h"

namespace hour_window_test {
using namespace isect::viz;
using sample::broken_stop, sample::stop_at;

namespace {

const Lesson disc = sample::lesson(), ball = sample::other_lesson();
const std::vector<const Lesson*> both = {&disc, &ball};

WindowOptions with(std::vector<Stop> stops) {
  WindowOptions options = layout_only;
  options.playlist = {"A short hour", "/lectures/hour.json", std::move(stops)};
  return options;
}

WindowOptions three_stops() {
  std::vector<Stop> stops = {stop_at(disc, "squared-inside"), stop_at(ball, "squared-outside", {2, 3}),
                             stop_at(disc, "distance-on", {0, 1})};
  stops[1].note = "Before the *answer*.";
  return with(std::move(stops));
}

/// Where the window is: "2 of 3: Point and ball, step 2".
std::string where(const WindowDriver& window) {
  const std::string title = window.ui.title();
  const std::size_t step = title.find(", step ");
  return title.substr(0, title.find(',')) + title.substr(step, title.find(" of ", step) - step);
}

}  // namespace

TEST_CASE("without a playlist nothing is said of one", "[hour][window]") {
  WindowDriver window(both, 1280, 800, {}, {}, layout_only);
  CHECK_FALSE(window.has("stops"));
  window.type("i");
  window.frames(2);
  CHECK_FALSE(window.has("list of stops"));
}

TEST_CASE("where one is in a playlist stands in the window, at any size, in a lecture and outside", "[hour][layout]") {
  const auto [width, height] = GENERATE(table<float, float>({{800, 500}, {1280, 800}, {2560, 1440}}));
  CAPTURE(width, height);
  WindowDriver window(both, width, height, {}, {}, three_stops());
  for (const bool lecture : {false, true}) {
    CAPTURE(lecture);
    const Rect badge = window.rect("stops"), bar = window.rect("transport");
    CHECK((badge.left >= bar.left && badge.top >= bar.top && badge.bottom <= bar.bottom));
    CHECK(badge.right < window.rect("first").left);
    CHECK(badge.width() > 60);
    CHECK(where(window) == "1 of 3: Point and disc, step 1");
    window.key(key::tab);
  }
}

TEST_CASE("N, Page Down and the arrow go on through a playlist, and Page Up back, in a lecture and outside",
          "[hour][keys]") {
  WindowDriver window(both, 1280, 800, {}, {}, three_stops());
  const int way = GENERATE(0, 1, 2, 3);
  if (GENERATE(true, false)) window.key(key::tab);
  const auto on = [&] {
    if (way == 0) window.key(key::page_down);
    if (way == 1) window.type("n");
    if (way == 2) window.key(key::right);
    if (way == 3) window.click("next");
    return where(window);
  };
  CHECK(on() == "1 of 3: Point and disc, step 2");
  on();
  CHECK(window.player().quiz().asked());
  CHECK(on() == "1 of 3: Point and disc, step 3");
  on(), on();
  CHECK(on() == "2 of 3: Point and ball, step 2");
  CHECK(window.player().quiz().asked());
  CHECK(on() == "2 of 3: Point and ball, step 3");
  on();
  CHECK(on() == "3 of 3: Point and disc, step 1");
  on();
  if (way != 3) {
    on();
    CHECK(window.ui.message() == "The playlist ends here");
  }
  CHECK(where(window) == "3 of 3: Point and disc, step 2");
  window.key(key::page_up);
  window.key(key::page_up);
  CHECK(where(window) == "2 of 3: Point and ball, step 4");
  window.click("back");
  CHECK(where(window) == "2 of 3: Point and ball, step 3");
}

TEST_CASE("a key that is held ends where the stop does", "[hour][keys]") {
  WindowDriver window(both, 1280, 800, {}, {}, three_stops());
  window.press(key::page_down, true);
  window.frames(400);
  window.press(key::page_down, false);
  window.frames();
  CHECK(where(window) == "1 of 3: Point and disc, step 5");
}

TEST_CASE("I and the badge list all stops, and one of them is gone to", "[hour][window]") {
  WindowDriver window(both, 1280, 800, {}, {}, three_stops());
  window.type("i");
  window.frames(2);
  REQUIRE(window.has("list of stops"));
  const Rect sheet = window.rect("list of stops");
  for (const char* name : {"stop 1", "stop 2", "stop 3"}) CHECK(window.rect(name).bottom <= sheet.bottom);
  window.click("stop 2");
  window.frames(2);
  CHECK_FALSE(window.has("list of stops"));
  CHECK(where(window) == "2 of 3: Point and ball, step 2");
  window.click("stops");
  window.frames(2);
  REQUIRE(window.has("list of stops"));
  window.key(key::down);
  window.key(key::enter);
  window.frames(2);
  CHECK_FALSE(window.has("list of stops"));
}

TEST_CASE("in the list of stops digits choose one, and Page Down scrolls and closes", "[hour][window]") {
  std::vector<Stop> stops(12, stop_at(disc, "squared-inside"));
  stops[1] = stops[11] = stop_at(ball, "squared-outside");
  WindowDriver window(both, 1280, 500, {}, {}, with(stops));
  const auto list = [&] {
    window.type("i");
    window.frames(2);
    REQUIRE(window.has("list of stops"));
  };
  list();
  window.type("2");  // no other stop begins so
  window.frames(2);
  CHECK_FALSE(window.has("list of stops"));
  CHECK(where(window) == "2 of 12: Point and ball, step 1");
  list();
  window.type("1");
  window.frames(2);
  REQUIRE(window.has("list of stops"));
  CHECK(window.ui.focus() == "stop 1");
  window.type("2");
  window.frames(2);
  CHECK(where(window) == "12 of 12: Point and ball, step 1");
  list();
  window.type("01");
  window.key(key::enter);
  window.frames(2);
  CHECK(where(window) == "1 of 12: Point and disc, step 1");
  list();
  const float top = window.rect("stop 1").top;
  window.key(key::page_down);
  window.frames(2);
  REQUIRE(window.has("list of stops"));
  CHECK(window.rect("stop 1").top < top);
  for (int i = 0; i < 9 && window.has("list of stops"); ++i) {
    window.key(key::page_down);
    window.frames(2);
  }
  CHECK_FALSE(window.has("list of stops"));
  CHECK(where(window) == "1 of 12: Point and disc, step 1");
}

TEST_CASE("a stop's note is told where it begins, in a lecture and outside", "[hour][window]") {
  WindowDriver window(both, 1280, 800, {}, {}, three_stops());
  if (GENERATE(true, false)) window.key(key::tab);
  CHECK_FALSE(window.has("note"));
  window.type("i");
  window.frames(2);
  window.click("stop 2");
  window.frames(2);
  CHECK(window.has("note"));  // with the question
  window.key(key::page_down);
  CHECK(window.has("note"));
  window.key(key::page_down);
  window.frames();
  CHECK_FALSE(window.has("note"));
}

TEST_CASE("a stop that can't be opened says why, and is gone past by a choice", "[hour][window]") {
  WindowDriver window(both, 1280, 800, {}, {},
                      with({stop_at(disc, "squared-inside", {0}), broken_stop(), stop_at(ball, "squared-inside")}));
  if (GENERATE(true, false)) window.key(key::tab);
  CHECK_FALSE(window.has("fault of stop"));
  window.key(key::page_down);
  window.frames();
  REQUIRE(window.has("fault of stop"));
  CHECK_FALSE(window.has("scene"));
  CHECK(window.ui.title() == "2 of 3: a stop that can't be opened – isect");
  window.click("back from stop");
  window.frames();
  CHECK(where(window) == "1 of 3: Point and disc, step 1");
  window.key(key::page_down);
  window.frames();
  window.click("go past stop");
  window.frames();
  CHECK(where(window) == "3 of 3: Point and ball, step 1");
  CHECK_FALSE(window.has("fault of stop"));
  window.type("i");
  window.frames(2);
  CHECK(window.has("stop 2"));  // it is not lost
}

TEST_CASE("another lesson is left for the playlist by the next press", "[hour][window]") {
  WindowDriver window(both, 1280, 800, {}, {}, three_stops());
  window.key(key::page_down);
  window.type("]");
  CHECK(where(window) == "1 of 3: Point and ball, step 1");
  window.key(key::page_down);
  CHECK(where(window) == "1 of 3: Point and disc, step 2");
}

TEST_CASE("a stray digit leaves the playlist for a preset, and N returns from it", "[hour][window]") {
  WindowDriver window(both, 1280, 800, {}, {}, three_stops());
  window.key(key::page_down);
  window.type("2");
  CHECK(window.player().played().preset_id() == "squared-outside");
  CHECK(where(window) == "1 of 3: Point and disc, step 1");
  window.type("n");
  CHECK(window.player().played().preset_id() == "squared-inside");
  CHECK(where(window) == "1 of 3: Point and disc, step 2");
}

TEST_CASE("a case keeps its name to itself while its stop has a question ahead", "[hour][window]") {
  const auto named = [](WindowDriver& window) { return window.ui.title().find(", inside,") != std::string::npos; };
  WindowDriver free(both, 1280, 800, {}, {}, layout_only);
  REQUIRE(named(free));
  WindowDriver window(both, 1280, 800, {}, {}, three_stops());
  CHECK_FALSE(named(window));
  CHECK(window.ui.title().find(", preset 1,") != std::string::npos);
  window.key(key::page_down);
  window.key(key::page_down);
  REQUIRE(window.player().quiz().asked());
  CHECK_FALSE(named(window));
  window.key(key::page_down);
  window.frames();
  CHECK(named(window));
}

TEST_CASE("Page Down scrolls the sheet of keys, and closes it and the list of stops at the end", "[hour][keys]") {
  const float height = GENERATE(500.0f, 800.0f);
  WindowDriver window(both, 800, height, {}, {}, three_stops());
  window.key(key::f1);
  window.frames(2);
  REQUIRE(window.has("key sheet"));
  const float top = window.rect("keys left").top;
  window.key(key::page_down);
  window.frames(2);
  if (height < 600) {
    REQUIRE(window.has("key sheet"));
    CHECK(window.rect("keys left").top < top);
    window.key(key::page_up);
    window.frames(2);
    CHECK(window.rect("keys left").top == top);
    for (int i = 0; i < 3; ++i) window.key(key::page_down);
    window.frames(2);
  }
  CHECK_FALSE(window.has("key sheet"));
  CHECK(where(window).starts_with("1 of 3: Point and disc, step "));

  window.type("i");
  window.frames(2);
  REQUIRE(window.has("list of stops"));
  window.key(key::page_down);
  window.frames(2);
  CHECK_FALSE(window.has("list of stops"));
}

TEST_CASE("digits choose from the list of stops", "[hour][keys]") {
  WindowDriver window(both, 1280, 800, {}, {}, three_stops());
  window.type("i");
  window.frames(2);
  window.type("3");
  window.frames(2);
  CHECK_FALSE(window.has("list of stops"));
  CHECK(where(window) == "3 of 3: Point and disc, step 1");
  window.type("i");
  window.frames(2);
  window.type("7");  // there is none
  window.frames(2);
  CHECK(window.has("list of stops"));
}

TEST_CASE("of two digits the first rings a stop, and Enter goes there", "[hour][keys]") {
  std::vector<Stop> stops(12, stop_at(disc, "squared-inside", {0}));
  WindowDriver window(both, 1280, 800, {}, {}, with(stops));
  const auto list = [&] {
    window.type("i");
    window.frames(2);
    REQUIRE(window.has("list of stops"));
  };
  list();
  window.type("1");
  CHECK(window.has("list of stops"));
  CHECK(window.ui.focus() == "stop 1");
  window.type("1");
  window.frames(2);
  CHECK(where(window).starts_with("11 of 12"));
  list();
  window.type("1");
  window.key(key::enter);
  window.frames(2);
  CHECK(where(window).starts_with("1 of 12"));
}

TEST_CASE("in a lecture a pointer at rest is hidden and lights nothing, until it moves", "[window][lecture]") {
  WindowDriver window(both, 1280, 800, {}, {}, layout_only);
  const bool lecture = GENERATE(true, false);
  if (lecture) window.key(key::tab);
  window.frames(2);
  const Rect next = window.rect("next");
  const auto hovers = [&] {
    window.frames(2);
    return ImGui::IsMousePosValid() && ImGui::GetMouseCursor() != ImGuiMouseCursor_None;
  };
  const auto lit = [&] {
    for (const auto& [name, rect] : window.ui.rects())
      if (name.starts_with("lit ")) return true;
    return false;
  };
  window.move(next.middle_x(), next.middle_y());
  CHECK(hovers());
  CHECK((window.ui.rest() <= 3) == lecture);
  window.wait(3.5f);
  window.frames();
  CHECK((ImGui::GetMouseCursor() == ImGuiMouseCursor_None) == lecture);
  if (lecture) CHECK_FALSE(lit());
  window.move(next.middle_x() + 1, next.middle_y());
  CHECK(hovers());
  window.wait(3.5f);
  window.click(next.middle_x() + 1, next.middle_y());  // a press counts, too
  CHECK(window.player().index() == 1);
}

TEST_CASE("on a dark screen there is no pointer", "[window][lecture]") {
  WindowDriver window(both, 1280, 800, {}, {}, layout_only);
  window.key(key::tab);
  window.move(640, 400);
  window.type("b");
  window.frames();
  CHECK(ImGui::GetMouseCursor() == ImGuiMouseCursor_None);
  window.type("b");
  window.frames(2);
  CHECK(ImGui::GetMouseCursor() != ImGuiMouseCursor_None);
}

TEST_CASE("a stop has its own second pane", "[hour][window]") {
  WindowOptions options = three_stops();
  options.playlist.stops[1].state.beside = OtherSide{"distance", ""};
  WindowDriver window(both, 1280, 800, {}, {}, options);
  CHECK_FALSE(window.ui.settings().beside);
  window.type("i");
  window.frames(2);
  window.click("stop 2");
  window.frames(2);
  CHECK(window.ui.settings().beside == Beside{"point-ball", "distance", ""});
  window.type("i");
  window.frames(2);
  window.click("stop 3");
  window.frames(2);
  CHECK_FALSE(window.ui.settings().beside);
}

TEST_CASE("a playlist opens where the window left it, as its file of settings says", "[hour][window]") {
  const std::string file = isect::test::scratch("isect-hours.json").string();
  {
    WindowDriver window(both, 1280, 800, {}, {}, three_stops());
    for (int i = 0; i < 7; ++i) window.key(key::page_down);
    REQUIRE(where(window) == "2 of 3: Point and ball, step 3");
    REQUIRE(window.ui.settings().hours == std::vector<HourPlace>{{"/lectures/hour.json", 1, 2}});
    write_settings(file, window.ui.settings());
  }
  const Settings kept = read_settings(file, both);
  CHECK(kept.hours == std::vector<HourPlace>{{"/lectures/hour.json", 1, 2}});
  {
    WindowDriver window(both, 1280, 800, {}, kept, three_stops());
    CHECK(where(window) == "2 of 3: Point and ball, step 3");
  }
  WindowOptions other = three_stops();
  other.playlist.file = "/lectures/other.json";
  WindowDriver window(both, 1280, 800, {}, kept, other);
  CHECK(where(window) == "1 of 3: Point and disc, step 1");
  const std::vector<HourPlace> now = window.ui.settings().hours;
  REQUIRE(now.size() == 2);
  CHECK((now[0].file == "/lectures/other.json" && now[1].file == "/lectures/hour.json"));
  std::filesystem::remove(file);
}

TEST_CASE("damaged places of playlists are left out", "[hour][window]") {
  const std::string file = isect::test::scratch("isect-bad-hours.json").string();
  write_file(file, R"({"hours": [7, {}, {"file": "hour.json", "stop": 2}, {"file": "/a.json", "stop": "two"},
                       {"file": "/b.json", "stop": 3, "step": 1e99}]})");
  CHECK(read_settings(file, both).hours == std::vector<HourPlace>{{"/a.json", 0, -1}, {"/b.json", 2, -1}});
  std::filesystem::remove(file);
}

}  // namespace hour_window_test
