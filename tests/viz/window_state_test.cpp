// What the window gives away and takes in: clipboard, figures, settings; and what it says without a display.

#include <cstdlib>
#include <filesystem>

#include "tests/catch.h"
#include "tests/scratch.h"
#include "tests/viz/sample_lesson.h"
#include "tests/viz/window_driver.h"
#include "viz/window.h"

namespace window_state_test {
using namespace isect::viz;

namespace {

const Lesson disc = sample::lesson(), ball = sample::other_lesson();
const std::vector<const Lesson*> both = {&disc, &ball};

}  // namespace

TEST_CASE("the state goes through the clipboard and back", "[window]") {
  WindowDriver window(both);
  window.type("p2");
  window.key(key::end);
  window.key(key::c, true);
  const std::string copied = ImGui::GetClipboardText();
  const Place before = window.player().place();

  window.type("]1o");
  CHECK(window.player().lesson().id == "point-ball");
  ImGui::SetClipboardText(copied.c_str());
  window.key(key::v, true);
  CHECK(window.player().place().lesson == "point-disc");
  CHECK(window.player().place().preset == "squared-outside");
  CHECK(window.player().place().step == before.step);
  CHECK(window.player().camera().now().perspective);
}

TEST_CASE("a pasted text that is no state is refused with its reason, and nothing is lost", "[window]") {
  WindowDriver window(both);
  window.type("2");
  window.key(key::right);
  const char* bad = GENERATE("", "{", "[1, 2]", R"({"lesson": "point-dis"})", R"({"lesson": "point-disc", "step": 99})",
                             R"({"lesson": "point-disc", "parameters": {"r": -1}})");
  INFO(bad);
  ImGui::SetClipboardText(bad);
  window.key(key::v, true);
  CHECK_FALSE(window.ui.message().empty());
  CHECK(window.has("message"));
  CHECK(window.player().preset_id() == "squared-outside");
  CHECK(window.player().index() == 1);
  window.wait(30);
  CHECK(window.ui.message().empty());
}

TEST_CASE("a figure is saved where its name says, and opens again at its place", "[window]") {
  const std::string folder = isect::test::scratch("isect-window-test").string();
  std::filesystem::remove_all(folder);
  WindowDriver window(both, 1280, 800, {}, {}, {.reduced_motion = true, .figures = folder});
  window.key(key::right);
  window.type("s");
  window.frames(2);
  REQUIRE(window.has("save sheet"));
  window.key(key::enter);
  window.frames(2);
  const std::string png_file = folder + "/point-disc/squared-inside/02-length.png";
  CHECK(window.ui.message() == "Saved " + png_file);
  const std::string bytes = read_file(png_file);
  const Picture saved = read_png(bytes);
  CHECK(saved.width == 960);
  CHECK(saved.height == 600);
  const Place place = place_from_metadata(png_metadata(bytes), both);
  CHECK(place.lesson == "point-disc");
  CHECK(place.step == 1);

  window.key(key::f12);
  window.click("format svg");
  window.click("save theme grey");
  window.click("save");
  window.frames(2);
  const std::string svg_file = folder + "/point-disc/squared-inside/02-length.svg";
  CHECK(window.ui.message() == "Saved " + svg_file);
  CHECK(read_file(svg_file).find("<svg") != std::string::npos);
  CHECK(window.ui.settings().save_format == "svg");
  CHECK(window.ui.settings().save_theme == ThemeName::grey);
  std::filesystem::remove_all(folder);
}

TEST_CASE("a figure that can't be written is told, and the window goes on", "[window]") {
  const std::string file = isect::test::scratch("isect-window-no-folder").string();
  write_file(file, "a file where a folder should be");
  WindowDriver window(both, 1280, 800, {}, {}, {.reduced_motion = true, .figures = file});
  window.type("s");
  window.key(key::enter);
  window.frames(2);
  CHECK(window.ui.message().find(file) != std::string::npos);
  window.key(key::right);
  CHECK(window.player().index() == 1);
  std::filesystem::remove(file);
}

TEST_CASE("settings survive a run, and a spoilt file or field gives defaults", "[window]") {
  const std::string file = isect::test::scratch("isect-settings-test.json").string();
  Settings s;
  s.theme = ThemeName::grey;
  s.save_format = "svg";
  s.speed = 1.5;
  s.width = 1600;
  s.place = Player(both).place();
  s.place->step = 3;
  write_settings(file, s);
  const Settings read = read_settings(file, both);
  CHECK(read.theme == ThemeName::grey);
  CHECK(read.save_format == "svg");
  CHECK(read.speed == 1.5);
  CHECK(read.width == 1600);
  REQUIRE(read.place);
  CHECK(read.place->step == 3);

  write_file(file, R"({"theme": 7, "width": "wide", "save_theme": "gray", "speed": 2, "place": {"lesson": "x"}})");
  const Settings half = read_settings(file, both);
  CHECK(half.theme == ThemeName::dark);
  CHECK(half.width == 1280);
  CHECK(half.save_theme == ThemeName::print);
  CHECK(half.speed == 2);
  CHECK_FALSE(half.place);

  write_file(file, "\x01\x02 no JSON");
  CHECK(read_settings(file, both).width == 1280);
  std::filesystem::remove(file);
  CHECK(read_settings(file, both).height == 800);
}

TEST_CASE("a spoilt file of settings is set aside, and none that was set aside before is lost", "[window]") {
  const std::string file = isect::test::scratch("isect-spoilt-test.json").string();
  const auto remove_all = [&] {
    for (const std::string end : {"", ".damaged", ".damaged-2"}) std::filesystem::remove(file + end);
  };
  remove_all();
  CHECK(set_spoilt_settings_aside("").empty());
  CHECK(set_spoilt_settings_aside(file).empty());  // there is none
  write_settings(file, {});
  CHECK(set_spoilt_settings_aside(file).empty());
  CHECK(std::filesystem::exists(file));

  write_file(file, R"({"theme": "grey", "pla)");
  CHECK(set_spoilt_settings_aside(file) ==
        file + " is damaged, and the window starts afresh. It is kept as " + file + ".damaged");
  CHECK_FALSE(std::filesystem::exists(file));
  write_file(file, "[]");
  CHECK(set_spoilt_settings_aside(file).ends_with(".damaged-2"));
  CHECK(read_file(file + ".damaged") == R"({"theme": "grey", "pla)");
  CHECK(read_file(file + ".damaged-2") == "[]");
  remove_all();
}

TEST_CASE("without a display the window says so", "[window]") {
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  CHECK_THROWS_AS(show(both, {}), NoDisplay);
}

}  // namespace window_state_test
