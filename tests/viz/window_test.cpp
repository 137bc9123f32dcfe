#include "viz/window.h"

#include <cstdlib>
#include <filesystem>
#include <set>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/sample_lesson.h"
#include "tests/viz/window_driver.h"
#include "viz/window/layout.h"

using namespace isect::viz;

namespace {

const Lesson disc = sample::lesson(), ball = sample::other_lesson();
const std::vector<const Lesson*> both = {&disc, &ball};

std::array<int, 3> pixel(const Picture& picture, float x, float y) {
  const std::size_t i = 4 * (static_cast<std::size_t>(y) * picture.width + static_cast<std::size_t>(x));
  return {picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]};
}

std::array<int, 3> bytes(const Colour& c) {
  const auto byte = [](double x) { return static_cast<int>(std::lround(255 * x)); };
  return {byte(c.r), byte(c.g), byte(c.b)};
}

/// What a person aims at; the rest are areas that hold such things, or lie over others for a while.
bool is_widget(const std::string& name) {
  static const std::set<std::string> areas = {"scene",        "lesson panel", "code panel", "top bar",  "transport",
                                              "lesson words", "lesson fields", "code lines", "values", "message"};
  return !areas.contains(name) && !name.starts_with("handle ");
}

bool meet(const Rect& a, const Rect& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/// The part of a pseudocode line or parameter field that its scrolling area shows; empty if it is scrolled away.
Rect visible(const WindowDriver& window, const std::string& name, Rect r) {
  const char* area = name.starts_with("line ")        ? "code lines"
                     : name.starts_with("choice ")    ? "lesson words"
                     : name.starts_with("parameter ") ? "lesson fields"
                     : name == "comparison"           ? "values"
                                                      : nullptr;
  if (!area) return r;
  const Rect clip = window.rect(area);
  return {r.left, std::max(r.top, clip.top), r.right, std::min(r.bottom, clip.bottom)};
}

void check_layout(const WindowDriver& window, float width, float height) {
  std::vector<std::pair<std::string, Rect>> widgets;
  for (const auto& [name, whole] : window.ui.rects()) {
    const Rect r = visible(window, name, whole);
    if (is_widget(name) && r.top < r.bottom) widgets.emplace_back(name, r);
  }
  REQUIRE(widgets.size() > 20);
  for (std::size_t i = 0; i < widgets.size(); ++i) {
    const auto& [name, r] = widgets[i];
    INFO(name << ": " << r.left << " " << r.top << " " << r.right << " " << r.bottom);
    CHECK((r.left >= 0 && r.top >= 0 && r.right <= width && r.bottom <= height));
    for (std::size_t j = 0; j < i; ++j) {
      INFO("and " << widgets[j].first);
      CHECK_FALSE(meet(r, widgets[j].second));
    }
  }
  const char* regions[] = {"top bar", "lesson panel", "scene", "code panel", "transport"};
  float area = 0;
  for (const char* a : regions) {
    area += window.rect(a).width() * window.rect(a).height();
    for (const char* b : regions) CHECK((a == b || !meet(window.rect(a), window.rect(b))));
  }
  CHECK(area == Approx(width * height));
}

}  // namespace

TEST_CASE("the keys step, jump and stop at questions", "[window]") {
  WindowDriver window(both);
  window.key(key::right);
  CHECK(window.player().index() == 1);
  window.key(key::right);
  CHECK(window.player().index() == 1);
  REQUIRE(window.player().asked());
  window.key(key::right);
  CHECK(window.player().index() == 2);
  window.key(key::left);
  CHECK(window.player().index() == 1);
  window.key(key::end);
  CHECK(window.player().at_end());
  window.key(key::home);
  CHECK(window.player().index() == 0);
  CHECK(window.ui.title() == "Point and disc, inside, step 1 of 5 – isect");
}

TEST_CASE("presets are loaded by chip and by number, and the method by its menu", "[window]") {
  WindowDriver window(both);
  window.click("preset 2");
  CHECK(window.player().preset_id() == "squared-outside");
  window.type("3");
  CHECK(window.player().preset_id() == "squared-on");
  window.type("9");  // there is no ninth
  CHECK(window.player().preset_id() == "squared-on");
  window.click("method");
  window.click("method distance");
  CHECK(window.player().preset_id() == "distance-on");
}

TEST_CASE("a dragged handle changes its parameter and the verdict at once", "[window]") {
  WindowDriver window(both);
  window.key(key::end);
  REQUIRE(window.player().step().verdict.kind == Verdict::Kind::yes);
  const auto center = [&] { return std::get<Vec3>(window.player().parameters().at("c")); };

  const Rect grip = window.rect("handle c");
  window.move(grip.middle_x(), grip.middle_y());
  window.button(true);
  window.move(grip.middle_x() + 120, grip.middle_y() + 150);
  window.move(grip.middle_x() + 240, grip.middle_y() + 250);
  CHECK(window.player().step().verdict.kind == Verdict::Kind::no);  // while it is still held
  window.button(false);
  CHECK(center().norm() > 1);
  CHECK(window.player().preset_id().empty());
  CHECK(window.has("changed"));
  const Rect now = window.rect("handle c");
  CHECK(now.middle_x() == Approx(grip.middle_x() + 240).margin(0.5));
  CHECK(now.middle_y() == Approx(grip.middle_y() + 250).margin(0.5));

  window.key('Z', true);
  CHECK(center() == Vec3(0, 0, 0));
  CHECK(window.player().preset_id() == "squared-inside");
}

TEST_CASE("a radius handle changes a number", "[window]") {
  WindowDriver window(both);
  window.drag("handle r", 0, -60);
  CHECK(std::get<double>(window.player().parameters().at("r")) > 1.6);
}

TEST_CASE("dragging beside the handles orbits, the right button pans, the wheel zooms, two clicks frame all", "[window]") {
  WindowDriver window(both);
  const Camera home = window.player().camera().now();
  const Rect scene = window.rect("scene");
  const float x = scene.left + 60, y = scene.top + 200;
  window.drag(x, y, x + 80, y + 30);
  const Camera turned = window.player().camera().now();
  CHECK(turned.azimuth != home.azimuth);
  CHECK(turned.elevation != home.elevation);
  CHECK(turned.target == home.target);

  window.drag(x, y, x + 80, y + 30, 1);
  CHECK(window.player().camera().now().target != turned.target);
  CHECK(window.player().camera().now().azimuth == turned.azimuth);

  window.wheel(2);
  CHECK(window.player().camera().now().half_height < turned.half_height);

  window.wait(1);  // so that the drags' clicks are long past
  window.click(x, y);
  window.click(x, y);
  CHECK(window.player().camera().now().azimuth == home.azimuth);
}

TEST_CASE("P and O and the name in the corner change the projection", "[window]") {
  WindowDriver window(both);
  window.type("p");
  CHECK(window.player().camera().now().perspective);
  window.type("o");
  CHECK_FALSE(window.player().camera().now().perspective);
  window.click("projection");
  CHECK(window.player().camera().now().perspective);
}

TEST_CASE("the scrubber follows the pointer", "[window]") {
  WindowDriver window(both);
  const Rect bar = window.rect("scrubber");
  window.move(bar.left + 16, bar.middle_y());
  window.button(true);
  window.move(bar.middle_x(), bar.middle_y());
  CHECK(window.player().index() == 2);
  window.move(bar.right - 16, bar.middle_y());
  CHECK(window.player().index() == 4);
  window.button(false);
  window.move(bar.left, bar.middle_y());
  CHECK(window.player().index() == 4);
}

TEST_CASE("the transport's buttons do what the keys do", "[window]") {
  WindowDriver window(both);
  window.click("next");
  CHECK(window.player().index() == 1);
  window.click("last");
  CHECK(window.player().at_end());
  window.click("back");
  CHECK(window.player().index() == 3);
  window.click("first");
  CHECK(window.player().index() == 0);
  window.click("speed");
  CHECK(window.player().speed() == 1.5);
  window.click("play");
  CHECK(window.player().playing());
  window.wait(1.2f);
  CHECK(window.player().index() == 1);
  window.type(" ");
  CHECK_FALSE(window.player().playing());
}

TEST_CASE("a question is answered by click or by letter, and the answer is told", "[window]") {
  WindowDriver window(both);
  window.player().go_to(1);
  window.key(key::right);
  REQUIRE(window.has("choice 1"));
  window.click("choice 1");
  REQUIRE(window.player().answered());
  CHECK_FALSE(window.player().answered()->right());
  CHECK(window.player().index() == 2);
  window.click("choice 0");  // too late
  CHECK(window.player().answered()->choice == 1);

  window.type("r");
  window.player().go_to(1);
  window.key(key::right);
  window.type("a");
  REQUIRE(window.player().answered());
  CHECK(window.player().answered()->right());
}

TEST_CASE("the state goes through the clipboard and back", "[window]") {
  WindowDriver window(both);
  window.type("p2");
  window.key(key::end);
  window.key('C', true);
  const std::string copied = ImGui::GetClipboardText();
  const Place before = window.player().place();

  window.type("]1o");
  CHECK(window.player().lesson().id == "point-ball");
  ImGui::SetClipboardText(copied.c_str());
  window.key('V', true);
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
  window.key('V', true);
  CHECK_FALSE(window.ui.message().empty());
  CHECK(window.has("message"));
  CHECK(window.player().preset_id() == "squared-outside");
  CHECK(window.player().index() == 1);
  window.wait(30);
  CHECK(window.ui.message().empty());
}

TEST_CASE("a number is typed after Ctrl+click, and a refused one is told", "[window]") {
  WindowDriver window(both);
  window.click("parameters");
  window.frames(2);
  const auto type_radius = [&](const std::string& number) {
    const Rect field = window.rect("parameter r");
    window.move(field.middle_x(), field.middle_y());
    ImGui::GetIO().KeyCtrl = true;
    ImGui::GetIO().KeyMods = ImGuiKeyModFlags_Ctrl;
    window.button(true);
    window.button(false);
    ImGui::GetIO().KeyCtrl = false;
    ImGui::GetIO().KeyMods = ImGuiKeyModFlags_None;
    window.frames(2);
    window.type(number);
    window.key(key::enter);
  };
  const auto radius = [&] { return std::get<double>(window.player().parameters().at("r")); };
  type_radius("2.75");
  CHECK(radius() == 2.75);
  CHECK(window.ui.message().empty());
  type_radius("-4");
  CHECK(radius() == 2.75);
  CHECK(window.ui.message().find("r") != std::string::npos);
}

TEST_CASE("letters typed into a field are no commands", "[window]") {
  WindowDriver window(both);
  window.key('O', true);
  window.frames(2);
  window.type("ball 2");
  CHECK(window.player().preset_id() == "squared-inside");
  window.type("");
  CHECK_FALSE(window.has("lesson point-disc"));
}

TEST_CASE("the picker finds a lesson by a word, and opens it by Enter or by click", "[window]") {
  WindowDriver window(both);
  window.key('O', true);
  window.frames(2);
  REQUIRE(window.has("search"));
  CHECK(window.has("pair point-ball"));
  CHECK(window.has("lesson point-disc"));
  window.type("BALL");
  CHECK_FALSE(window.has("lesson point-disc"));
  window.key(key::enter);
  CHECK(window.player().lesson().id == "point-ball");
  CHECK_FALSE(window.has("search"));

  window.click("lesson");
  window.frames(2);
  window.click("pair point-disc");
  CHECK(window.player().lesson().id == "point-disc");
}

TEST_CASE("the key sheet opens by key and by button, and closes by Escape", "[window]") {
  WindowDriver window(both);
  window.key(key::f1);
  CHECK(window.has("key sheet"));
  window.key(key::escape);
  CHECK_FALSE(window.has("key sheet"));
  window.type("?");
  CHECK(window.has("key sheet"));
  window.key(key::right);  // it keeps the keys from the lesson
  CHECK(window.player().index() == 0);
  window.key(key::f1);
  CHECK_FALSE(window.has("key sheet"));
  window.click("help");
  CHECK(window.has("key sheet"));
}

TEST_CASE("Tab gives the panels' place to the scene and back", "[window]") {
  WindowDriver window(both);
  const float width = window.rect("scene").width();
  window.key(key::tab);
  CHECK(window.rect("scene").width() == 1280);
  CHECK_FALSE(window.has("code panel"));
  window.key(key::tab);
  CHECK(window.rect("scene").width() == width);
}

TEST_CASE("a figure is saved where its name says, and opens again at its place", "[window]") {
  const std::string folder = (std::filesystem::temp_directory_path() / "isect-window-test").string();
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
  const std::string file = (std::filesystem::temp_directory_path() / "isect-window-no-folder").string();
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

TEST_CASE("a line of pseudocode leads to its step", "[window]") {
  WindowDriver window(both);
  window.click("line 3");
  CHECK(window.player().step().slug == "compare");
}

TEST_CASE("nothing overlaps and nothing leaves the window, at any size, step and lesson", "[window]") {
  const auto [width, height] = GENERATE(table<float, float>({{1024, 640}, {1280, 800}, {1920, 1080}}));
  const bool open = GENERATE(false, true);
  Settings settings;
  settings.parameters_open = open;
  const std::vector<const Lesson*>& lessons = isect::lessons::all_lessons();
  WindowDriver window(lessons, width, height, {}, settings);
  for (const Method& method : window.player().methods()) {
    window.player().load_method(method.choice);
    for (int i = 0; i < window.player().count(); ++i) {
      window.player().go_to(i);
      if (i % 2) window.player().next();  // with the question on show, where there is one
      window.frames(2);
      INFO(window.ui.title() << " at " << width << " x " << height);
      check_layout(window, width, height);
    }
  }
}

TEST_CASE("the picture shows panels, scene and the current line in their colours", "[window]") {
  const ThemeName name = GENERATE(ThemeName::dark, ThemeName::screen, ThemeName::grey);
  const double scale = GENERATE(1.0, 2.0);
  Settings settings;
  settings.theme = name;
  WindowDriver window(both, 1280, 800, {}, settings, {.scale = scale, .reduced_motion = true});
  window.player().go_to(2);
  window.frames(2);
  const Picture picture = window.picture();
  const auto at = [&](float x, float y) {
    const float s = static_cast<float>(scale);
    return pixel(picture, x * s, y * s);
  };
  const Theme theme = window_theme(name);
  const Rect line = window.rect("line 3"), play = window.rect("play"), scene = window.rect("scene");
  CHECK(at(line.right - 60, line.middle_y()) == bytes(theme.ink(Role::highlight)));
  CHECK(at(play.left + 5, play.middle_y()) == bytes(theme.ink(Role::first)));
  CHECK(at(10, 400) == bytes(theme.panel));
  CHECK(at(scene.left + 5, scene.top + 5) == bytes(theme.background));
  std::set<std::array<int, 3>> colours;
  for (float y = scene.top; y < scene.bottom; y += 3)
    for (float x = scene.left; x < scene.right; x += 3) colours.insert(at(x, y));
  CHECK(colours.size() > 30);
  write_file(std::string(ISECT_PICTURES) + "/window-" + name_of(name) + (scale > 1 ? "-2x" : "") + ".png", png(picture));
}

TEST_CASE("the theme button goes round and what was chosen is kept", "[window]") {
  WindowDriver window(both);
  CHECK(window.ui.settings().theme == ThemeName::dark);
  window.click("theme");
  CHECK(window.ui.settings().theme == ThemeName::screen);
  window.click("theme");
  CHECK(window.ui.settings().theme == ThemeName::grey);
  window.click("theme");
  CHECK(window.ui.settings().theme == ThemeName::dark);
}

TEST_CASE("settings survive a run; a spoilt file or field gives defaults", "[window]") {
  const std::string file = (std::filesystem::temp_directory_path() / "isect-settings-test.json").string();
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

TEST_CASE("chips shrink from the end, but never the chosen one", "[window]") {
  const std::vector<float> wide = {80, 80, 80, 80};
  CHECK(chip_widths(wide, 30, 10, 400, 0) == wide);
  CHECK(chip_widths(wide, 30, 10, 310, 0) == std::vector<float>{80, 80, 80, 30});
  CHECK(chip_widths(wide, 30, 10, 310, 3) == std::vector<float>{80, 80, 30, 80});
  CHECK(chip_widths({}, 30, 10, 310, -1).empty());
}

TEST_CASE("without a display the window says so", "[window]") {
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  CHECK_THROWS_AS(show(both, {}), NoDisplay);
}
