// Where things stand in the window, and what colour they have.

#include <imgui_internal.h>

#include <set>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/sample_lesson.h"
#include "tests/viz/window_driver.h"
#include "viz/rich_text.h"
#include "viz/window/layout.h"

namespace window_look_test {
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
  static const std::set<std::string> areas = {"scene",     "lesson panel", "code panel",          "top bar",
                                              "transport", "lesson words", "lesson fields",       "code lines",
                                              "values",    "message",      "methods side by side"};
  return !areas.contains(name) && !name.starts_with("handle ");
}

bool meet(const Rect& a, const Rect& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/// The part of a pseudocode line or parameter field that its scrolling area shows; empty if it is scrolled
/// away.
Rect visible(const WindowDriver& window, const std::string& name, Rect r) {
  const char* area = name.starts_with("line ")        ? "code lines"
                     : name.starts_with("choice ")    ? "lesson words"
                     : name == "save preset"          ? "lesson words"
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

TEST_CASE("Tab gives the panels' place to the scene and back", "[window]") {
  WindowDriver window(both);
  const float width = window.rect("scene").width();
  window.key(key::tab);
  CHECK(window.rect("scene").width() == 1280);
  CHECK_FALSE(window.has("code panel"));
  window.key(key::tab);
  CHECK(window.rect("scene").width() == width);
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
  write_file(std::string(ISECT_PICTURES) + "/window-" + name_of(name) + (scale > 1 ? "-2x" : "") + ".png",
             png(picture));
}

TEST_CASE("every sign that is said or shown as a number has a glyph in the window's fonts", "[window]") {
  const WindowDriver window(isect::lessons::all_lessons());
  std::set<std::string> texts = {shown(179700), shown(1.121e8), shown(-2.5e-7)};
  for (const Lesson* lesson : isect::lessons::all_lessons()) {
    texts.insert({plain(lesson->title), plain(lesson->summary)});
    for (const Parameter& p : lesson->parameters) texts.insert(p.help);
    for (const Preset& p : lesson->presets) {
      texts.insert(plain(p.title));
      const Walk walk = lesson->walk(p.parameters);
      texts.insert(walk.pseudocode.begin(), walk.pseudocode.end());
      for (const Step& s : walk.steps) {
        texts.insert(plain(s.title));
        for (const Value& v : s.values) texts.insert({plain(v.name), shown(v.value)});
        if (s.comparison) texts.insert({plain(s.comparison->text), plain(s.comparison->meaning)});
      }
    }
  }
  for (const std::string& text : texts)
    for (const char* at = text.c_str(); *at;) {
      unsigned sign = 0;
      at += ImTextCharFromUtf8(&sign, at, nullptr);
      INFO(text << ": U+" << std::hex << sign);
      for (const ImFont* font : ImGui::GetIO().Fonts->Fonts)
        REQUIRE(font->FindGlyphNoFallback(static_cast<ImWchar>(sign)) != nullptr);
    }
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

TEST_CASE("chips shrink from the end, but never the chosen one", "[window]") {
  const std::vector<float> wide = {80, 80, 80, 80};
  CHECK(chip_widths(wide, 30, 10, 400, 0) == wide);
  CHECK(chip_widths(wide, 30, 10, 310, 0) == std::vector<float>{80, 80, 80, 30});
  CHECK(chip_widths(wide, 30, 10, 310, 3) == std::vector<float>{80, 80, 30, 80});
  CHECK(chip_widths({}, 30, 10, 310, -1).empty());
}

}  // namespace window_look_test
