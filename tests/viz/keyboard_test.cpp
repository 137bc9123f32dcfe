// The window by keyboard alone.

#include <set>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/sample_lesson.h"
#include "tests/viz/window_driver.h"

namespace keyboard_test {
using namespace isect;
using namespace isect::viz;

namespace {

const Lesson disc = sample::lesson(), ball = sample::other_lesson();
const std::vector<const Lesson*> both = {&disc, &ball};

Settings with_parameters() {
  Settings settings;
  settings.parameters_open = true;
  return settings;
}

/// Goes on with Down until the keyboard holds the widget.
void hold(WindowDriver& window, const std::string& name) {
  for (int i = 0; i < 200 && window.ui.focus() != name; ++i) window.key(key::down);
  REQUIRE(window.ui.focus() == name);
}

/// Types into a field, which Ctrl+click opens.
void type_into(WindowDriver& window, const std::string& field, const std::string& text) {
  const Rect r = window.rect(field);
  window.move(r.middle_x(), r.middle_y());
  window.control(true);
  window.button(true);
  window.button(false);
  window.control(false);
  window.frames(2);
  window.type(text);
}

double radius(WindowDriver& window) { return std::get<double>(window.player().parameters().at("r")); }

}  // namespace

TEST_CASE("a typed number counts on Enter or on leaving the field, and not before", "[window]") {
  WindowDriver window(both, 1280, 800, {}, with_parameters());
  const double before = radius(window);
  type_into(window, "parameter r", "2,75");
  CHECK(radius(window) == before);
  window.key(key::enter);
  CHECK(radius(window) == 2.75);
  window.key(key::z, true);
  CHECK(radius(window) == before);  // one step back takes the whole number

  type_into(window, "parameter r", "1/4");
  const Rect scene = window.rect("scene");
  window.click(scene.left + 30, scene.bottom - 130);
  CHECK(radius(window) == 0.25);

  type_into(window, "parameter r", "3");
  window.key(key::escape);
  window.frames(2);
  CHECK(radius(window) == 0.25);
}

TEST_CASE("a refused number leaves the old one, and the reason stands below the field", "[window]") {
  WindowDriver window(both, 1280, 800, {}, with_parameters());
  const double before = radius(window);
  for (const char* wrong : {"1e400", "-4", "two"}) {
    INFO(wrong);
    type_into(window, "parameter r", wrong);
    window.key(key::enter);
    window.frames(2);
    CHECK(radius(window) == before);
    REQUIRE(window.has("refused parameter r"));
    CHECK(window.rect("refused parameter r").top >= window.rect("parameter r").bottom);
    CHECK_FALSE(window.ui.message().empty());
  }
  type_into(window, "parameter r", "1");
  window.key(key::enter);
  window.frames(2);
  CHECK_FALSE(window.has("refused parameter r"));
}

TEST_CASE("a number out of range is refused in few words, of a vector that number alone", "[window]") {
  ReaderState state;
  state.lesson = "ray-sphere";
  WindowDriver window(lessons::all_lessons(), 1280, 1000, state, with_parameters());
  window.frames(2);
  const Setting before = window.player().parameters().at("origin");
  type_into(window, "parameter origin.x", "1e308");
  window.key(key::enter);
  window.frames(2);
  CHECK(window.player().parameters().at("origin") == before);
  REQUIRE(window.has("refused parameter origin.x"));
  const Rect told = window.rect("refused parameter origin.x");
  CHECK(told.bottom - told.top < 60);  // in full it took six lines, and its end was cut
}

TEST_CASE("what changes nothing in this setting is pale, and says when it would", "[window]") {
  WindowDriver window(isect::lessons::all_lessons(), 1280, 800, place_at("bounding-volumes", "tilted"),
                      with_parameters());
  CHECK((window.has("without effect q") && window.has("without effect reach")));
  CHECK((!window.has("without effect k") && !window.has("without effect tip")));
  const Picture fit = window.picture();
  const Rect field = window.rect("parameter reach");
  window.player().load(preset(window.player().lesson(), "overlap"));
  window.frames(2);
  CHECK((window.has("without effect k") && !window.has("without effect reach")));
  const Picture test = window.picture();
  const auto contrast = [&](const Picture& p) {
    int least = 255, most = 0;
    for (int y = static_cast<int>(field.top) + 3; y < static_cast<int>(field.bottom) - 3; ++y)
      for (int x = static_cast<int>(field.left) + 3; x < static_cast<int>(field.right) - 3; ++x) {
        const int green = p.rgba[4 * (static_cast<std::size_t>(y) * p.width + x) + 1];
        least = std::min(least, green), most = std::max(most, green);
      }
    return most - least;
  };
  CHECK(contrast(fit) < 0.6 * contrast(test));
}

TEST_CASE("a direction of 0, 0, 0 is refused", "[window]") {
  ReaderState state;
  state.lesson = "ray-sphere";
  WindowDriver window(lessons::all_lessons(), 1280, 1000, state, with_parameters());
  window.frames(2);
  for (const char* field : {"parameter direction.x", "parameter direction.y", "parameter direction.z"}) {
    type_into(window, field, "0");
    window.key(key::enter);
    window.frames(2);
  }
  CHECK(std::get<Vec3>(window.player().parameters().at("direction")).norm() > 0);
  CHECK(window.has("refused parameter direction.z"));
}

TEST_CASE("Down goes through all that can be pressed, with a ring around it", "[window]") {
  WindowDriver window(both, 1280, 800, {}, with_parameters());
  std::set<std::string> held;
  window.key(key::down);
  const std::string first = window.ui.focus();
  do {
    held.insert(window.ui.focus());
    REQUIRE(window.has("focus ring"));
    const Rect ring = window.rect("focus ring"), widget = window.rect(window.ui.focus());
    CHECK((ring.left <= widget.middle_x() && widget.middle_x() <= ring.right));
    CHECK((ring.top <= widget.middle_y() && widget.middle_y() <= ring.bottom));
    window.key(key::down);
  } while (window.ui.focus() != first && held.size() < 200);
  for (const char* name : {"lesson", "method", "preset 1", "preset 2", "theme", "help", "parameters", "parameter r",
                           "parameter c.x", "handle c", "projection", "line 1", "scrubber", "play", "speed"}) {
    INFO(name);
    CHECK(held.contains(name));
  }
  window.key(key::up);
  CHECK(window.ui.focus() != first);
  window.key(key::escape);
  CHECK(window.ui.focus().empty());
  CHECK_FALSE(window.has("focus ring"));
}

TEST_CASE("Enter presses what the keyboard holds: theme, speed, method, a number", "[window]") {
  WindowDriver window(both, 1280, 800, {}, with_parameters());
  hold(window, "theme");
  window.key(key::enter);
  CHECK(window.ui.settings().theme == ThemeName::screen);
  hold(window, "speed");
  window.key(key::enter);
  CHECK(window.player().clock().speed() == 1.5);

  hold(window, "method");
  window.key(key::enter);
  window.frames(2);
  hold(window, "method distance");
  window.key(key::enter);
  window.frames(2);
  CHECK(window.player().played().method() == "distance");
  CHECK(window.ui.focus() == "method");  // where it was before the menu

  hold(window, "parameter r");
  window.key(key::enter);
  window.frames(2);
  window.type("1,25");
  window.key(key::enter);
  CHECK(radius(window) == 1.25);
  CHECK(window.player().index() == 0);
}

TEST_CASE("F6 goes from part to part of the window", "[window]") {
  WindowDriver window(both, 1280, 800, {}, with_parameters());
  std::set<std::string> firsts;
  for (int i = 0; i < 5; ++i) {
    window.key(key::f6);
    firsts.insert(window.ui.focus());
  }
  CHECK(firsts.size() == 5);
  CHECK(firsts.contains("lesson"));
  CHECK(firsts.contains("line 1"));
}

TEST_CASE("Shift and the arrows move the handle that is held, or else turn the scene", "[window]") {
  WindowDriver window(both);
  const Camera home = window.player().camera().goal();
  window.key(key::right, false, true);
  CHECK(window.player().index() == 0);
  CHECK(window.player().camera().goal().azimuth != home.azimuth);
  window.key(key::z, true);
  CHECK(window.player().camera().goal().azimuth == home.azimuth);
  window.key(key::up, true);
  CHECK(window.player().camera().goal().target != home.target);
  window.type("+");
  CHECK(window.player().camera().goal().half_height < home.half_height);
  window.type("f");
  CHECK(window.player().camera().goal().half_height == Approx(home.half_height).epsilon(0.5));

  hold(window, "handle c");
  const Rect before = window.rect("handle c");
  window.key(key::right, false, true);
  window.frames(2);
  CHECK(window.rect("handle c").middle_x() == Approx(before.middle_x() + 8).margin(0.5));
  CHECK(window.rect("handle c").middle_y() == Approx(before.middle_y()).margin(0.5));
}

TEST_CASE("a key that is held turns and shifts the scene smoothly, and then all is at rest", "[window]") {
  WindowDriver window(both);
  const bool turns = GENERATE(true, false);
  const auto seen = [&] {
    const Camera& c = window.player().camera().now();
    return turns ? 2 * c.azimuth : 400 * c.target.y() / c.half_height;  // what a frame may change by a tenth at most
  };
  const double home = seen();
  window.modifiers(!turns, turns);
  window.press(turns ? key::right : key::up, true);
  double last = home;
  for (int frame = 0; frame < 60; ++frame) {
    window.frames();
    CHECK(window.ui.rest() == 0);
    CHECK(std::abs(seen() - last) < (turns ? 0.1 : 10));
    last = seen();
  }
  CHECK(std::abs(last - home) > (turns ? 2 : 80));
  window.press(turns ? key::right : key::up, false);
  window.modifiers(false, false);
  window.frames(2);
  CHECK(seen() == last);
  CHECK(window.ui.rest() > 1);
  window.key(key::z, true);
  CHECK(seen() == Approx(home));
}

TEST_CASE("undo leaves the step where the reader has gone on, and redo does it again", "[window]") {
  WindowDriver window(both);
  const Vec3 before = std::get<Vec3>(window.player().parameters().at("c"));
  window.drag("handle c", 60, 30);
  const Vec3 dragged = std::get<Vec3>(window.player().parameters().at("c"));
  REQUIRE(dragged != before);
  window.key(key::right);
  REQUIRE(window.player().index() == 1);
  window.key(key::z, true);
  CHECK(std::get<Vec3>(window.player().parameters().at("c")) == before);
  CHECK(window.player().index() == 1);
  window.key(key::z, true, true);
  CHECK(std::get<Vec3>(window.player().parameters().at("c")) == dragged);
  CHECK(window.player().index() == 1);
  window.key(key::z, true);
  window.key(key::y, true);
  CHECK(std::get<Vec3>(window.player().parameters().at("c")) == dragged);
  window.key(key::y, true);
  CHECK(window.ui.message() == "Nothing to do again");

  window.key(key::z, true);
  window.type("2");  // another change: there is nothing to do again
  window.key(key::y, true);
  CHECK(window.player().played().preset_id() == "squared-outside");
  window.key(key::z, true);  // a preset had chosen the first step, so that is taken back, too
  CHECK(window.player().index() == 1);
}

TEST_CASE("presets beyond the ninth have keys", "[window]") {
  ReaderState state;
  state.lesson = "intervals";
  WindowDriver window(lessons::all_lessons(), 1280, 800, state);
  const std::vector<const Preset*> group = window.player().played().group();
  REQUIRE(group.size() >= 10);
  window.type("0");
  CHECK(window.player().played().preset_id() == group[9]->id);
  window.key(key::page_up);
  CHECK(window.player().played().preset_id() == group[8]->id);
  for (std::size_t i = 9; i < group.size(); ++i) {
    window.key(key::page_down);
    CHECK(window.player().played().preset_id() == group[i]->id);
  }
  window.key(key::page_down);
  CHECK(window.player().played().preset_id() == group[0]->id);
}

TEST_CASE("an exercise begun by keyboard hands over what there is to move", "[window]") {
  const auto [lesson, handle] =
      GENERATE(table<const char*, const char*>({{"crossings", "handle p"}, {"sphere-sphere", "handle b"}}));
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at(lesson, ""));
  window.player().last();
  window.frames(2);
  hold(window, "try 1");
  window.key(key::enter);
  window.frames(3);
  REQUIRE(window.player().exercise());
  CHECK(window.ui.focus() == handle);
  CHECK(window.has("focus ring"));
  const Parameters before = window.player().parameters();
  window.key(key::right, false, true);
  CHECK(window.player().parameters() != before);
}

TEST_CASE("an exercise begun by the pointer leaves the keyboard alone", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 1400, place_at("sphere-sphere", ""));
  window.player().last();
  window.frames(2);
  window.click("try 1");
  window.frames(3);
  REQUIRE(window.player().exercise());
  CHECK(window.ui.focus().empty());
}

TEST_CASE("in a sheet the arrows lead along its rows", "[window]") {
  WindowDriver window(isect::lessons::all_lessons());
  window.type("s");
  window.frames(2);
  window.key(key::down);
  const std::string first = window.ui.focus();
  window.key(key::right);
  CHECK(window.ui.focus() != first);
  window.key(key::left);
  CHECK(window.ui.focus() == first);
  CHECK(window.player().index() == 0);
}

TEST_CASE("in a sheet Tab leads to all there is, and out of a field too", "[window]") {
  WindowDriver window(isect::lessons::all_lessons());
  window.type("s");
  window.frames(2);
  window.key(key::tab);
  const std::string first = window.ui.focus();
  std::set<std::string> met;
  for (int i = 0; i < 40 && met.insert(window.ui.focus()).second; ++i) window.key(key::tab);
  CHECK(window.ui.focus() == first);
  CHECK((met.contains("format svg") && met.contains("other width") && met.contains("save")));
  window.key(key::tab, false, true);
  window.key(key::tab);
  CHECK(window.ui.focus() == first);
  CHECK(window.has("lesson panel"));

  for (int i = 0; i < 40 && window.ui.focus() != "other width"; ++i) window.key(key::tab);
  window.frames(2);
  window.type("9,5");  // what has the ring takes what is typed
  window.key(key::tab);
  CHECK(window.ui.settings().save_width_cm == 9.5);
  for (const char* next : {"save name", "save folder", "save"}) {
    CHECK(window.ui.focus() == next);
    window.frames(2);
    window.key(key::tab);
  }
}

TEST_CASE("Tab leaves a number that is typed for the next field, and takes it", "[window]") {
  WindowDriver window(both, 1280, 800, {}, with_parameters());
  type_into(window, "parameter r", "2,75");
  window.key(key::tab);
  CHECK(radius(window) == 2.75);
  const std::string next = window.ui.focus();
  CHECK((!next.empty() && next != "parameter r"));
  type_into(window, "parameter r", "3");
  window.key(key::tab, false, true);
  CHECK(radius(window) == 3);
  CHECK((!window.ui.focus().empty() && window.ui.focus() != next));
}

}  // namespace keyboard_test
