// Where things stand in the window, and what colour they have.

#include <imgui_internal.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/sample_lesson.h"
#include "tests/viz/window_driver.h"
#include "viz/compose/item_names.h"
#include "viz/player/camera_moves.h"
#include "viz/text/rich_text.h"
#include "viz/text/utf8.h"
#include "viz/walk/alt_text.h"
#include "viz/window/layout.h"
#include "viz/window/map_view.h"

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

/// With two panes, the second one's widgets have the names of the first one's after this prefix.
const std::string side = "other ";
std::string within_pane(const std::string& name) { return name.starts_with(side) ? name.substr(side.size()) : name; }

/// Whether a name is of a widget that a person aims at or reads; other areas hold such, or lie over others for a while.
bool is_widget(const std::string& full_name) {
  const std::string name = within_pane(full_name);
  static const std::set<std::string> areas = {
      "scene",        "lesson panel",         "code panel", "top bar",      "transport",
      "lesson words", "lesson fields",        "values",     "message",      "operations",
      "comparison",   "methods side by side", "focus ring", "code lines",   "map",
      "map plane",    "map setting",          "trail",      "pane heads",   "parted line",
      "parted value", "told words",           "lecture",    "tripod",       "what came of it",
      "told state",   "projection text",      "the answer", "known values", "time"};
  return !areas.contains(name) && !name.starts_with("handle ") && !name.starts_with("no ") &&
         !name.starts_with("yes ") && !name.starts_with("number ") && !name.starts_with("new ") &&
         !name.starts_with("trail ") && !name.starts_with("more ") && !name.starts_with("without effect ") &&
         !name.ends_with(" under pointer");
}

bool meet(const Rect& a, const Rect& b) {
  constexpr float touch = 0.5f;
  return a.left < b.right - touch && b.left < a.right - touch && a.top < b.bottom - touch && b.top < a.bottom - touch;
}

/// The part of a pseudocode line, a field or an answer that its scrolling area shows; empty if it is scrolled away.
Rect visible(const WindowDriver& window, const std::string& full_name, Rect r) {
  const std::string name = within_pane(full_name), pane = full_name.substr(0, full_name.size() - name.size());
  static const std::pair<const char*, const char*> areas[] = {{"line ", "code lines"},
                                                              {"choice ", "lesson words"},
                                                              {"answer", "lesson words"},
                                                              {"tile ", "lesson words"},
                                                              {"point ", "lesson words"},
                                                              {"give answer", "lesson words"},
                                                              {"show choices", "lesson words"},
                                                              {"what was typed", "lesson words"},
                                                              {"reply", "lesson words"},
                                                              {"numbers again", "lesson words"},
                                                              {"save preset", "lesson words"},
                                                              {"again ", "lesson words"},
                                                              {"try ", "lesson words"},
                                                              {"program", "lesson words"},
                                                              {"found", "lesson words"},
                                                              {"solution ", "lesson words"},
                                                              {"see it fail", "lesson words"},
                                                              {"same idea ", "lesson words"},
                                                              {"take review ", "lesson words"},
                                                              {"next lesson", "lesson words"},
                                                              {"reading", "lesson words"},
                                                              {"solved ", "lesson words"},
                                                              {"way back", "lesson words"},
                                                              {"exercise", "lesson words"},
                                                              {"parameter ", "lesson fields"},
                                                              {"refused ", "lesson fields"},
                                                              {"meaning", "values"},
                                                              {"condition ", "values"},
                                                              {"unit ", "values"},
                                                              {"value ", "values"}};
  static const char* const of_strip[] = {"choice ",        "answer", "tile ",         "give answer",  "show choices",
                                         "what was typed", "reply",  "numbers again", "unread answer"};
  static const char* const beside[] = {"line ", "point ", "told value ", "told formula"};
  const auto begins = [&](const char* start) { return name.starts_with(start); };
  for (const auto& [in, area] : {std::pair(std::ranges::any_of(of_strip, begins), "told words"),
                                 std::pair(std::ranges::any_of(beside, begins), "told state")})
    if (in && window.has(area)) {
      const Rect clip = window.rect(area);
      return {r.left, std::max(r.top, clip.top), r.right, std::min(r.bottom, clip.bottom)};
    }
  for (const auto& [start, area] : areas) {
    if (!name.starts_with(start) || !window.has(pane + area)) continue;
    const Rect clip = window.rect(pane + area);
    return {r.left, std::max(r.top, clip.top), r.right, std::min(r.bottom, clip.bottom)};
  }
  return r;
}

void check_layout(const WindowDriver& window, float width, float height) {
  std::vector<std::pair<std::string, Rect>> widgets;
  for (const auto& [name, whole] : window.ui.rects()) {
    const Rect r = visible(window, name, whole);
    if (is_widget(name) && r.top < r.bottom) widgets.emplace_back(name, r);
  }
  REQUIRE(widgets.size() > (window.has("lecture") ? 10 : 12));
  for (std::size_t i = 0; i < widgets.size(); ++i) {
    const auto& [name, r] = widgets[i];
    INFO(name << ": " << r.left << " " << r.top << " " << r.right << " " << r.bottom);
    if (!(r.left >= 0 && r.top >= 0 && r.right <= width && r.bottom <= height)) FAIL_CHECK("it leaves the window");
    for (std::size_t j = 0; j < i; ++j)
      if (meet(r, widgets[j].second)) FAIL_CHECK("it meets " << widgets[j].first);
  }
  for (const auto& [full_name, r] : window.ui.rects()) {
    const std::string name = within_pane(full_name), pane = full_name.substr(0, full_name.size() - name.size());
    if (!name.starts_with("handle ")) continue;
    for (const char* mark : {"tripod", "verdict", "alarm", "projection", "changed"})
      if (window.has(pane + mark) && meet(r, window.rect(pane + mark))) FAIL_CHECK(full_name << " meets " << mark);
  }
  for (const auto& [name, r] : window.ui.rects())
    if (name.starts_with("new ") && meet(r, window.rect("number " + name.substr(4)))) FAIL_CHECK(name << " covers it");
  std::vector<const char*> regions = {"top bar", "scene", "transport"};
  for (const char* name : {"code panel", "lesson panel", "lecture", "map", "pane heads", "time", "other scene",
                           "other code panel", "other time"})
    if (window.has(name)) regions.push_back(name);
  float area = 0;
  for (const char* a : regions) {
    area += window.rect(a).width() * window.rect(a).height();
    for (const char* b : regions)
      if (a != b && meet(window.rect(a), window.rect(b))) FAIL_CHECK(a << " meets " << b);
  }
  CHECK(area == Approx(width * height));
}

/// Walks a setting in the window, each second step with its question open; checks where things stand and that no words
/// are cut.
void walk(WindowDriver& window, float width, float height) {
  CutWords cut;
  for (int i = 0; i < window.player().count(); ++i) {
    window.player().go_to(i);
    if (i % 2) window.player().next();
    window.frames();  // finds how high things are
    ImGui::GetIO().UserData = &cut;
    window.frames();
    ImGui::GetIO().UserData = nullptr;
    INFO(window.ui.title() << " at " << width << " x " << height);
    check_layout(window, width, height);
    for (const std::string& words : cut) FAIL_CHECK("cut: " << words);
    cut.clear();
  }
}

}  // namespace

TEST_CASE("Tab gives the panels' place to the scene and back", "[window]") {
  WindowDriver window(both);
  const float width = window.rect("scene").width();
  window.key(key::tab);
  CHECK(window.rect("scene").width() == 1280);
  CHECK_FALSE(window.has("code panel"));
  CHECK(window.has("lecture"));
  window.key(key::tab);
  CHECK(window.rect("scene").width() == width);
  CHECK_FALSE(window.has("lecture"));
}

TEST_CASE("the scene has room in every window: in a narrow one the text stands below it", "[window]") {
  const auto [width, height] = GENERATE(table<float, float>(
      {{800, 500}, {800, 600}, {959, 700}, {960, 700}, {1024, 768}, {1280, 800}, {2560, 1440}, {800, 1280}}));
  const WindowLayout at = window_layout(width, height);
  INFO(width << " x " << height);
  CHECK(at.scene.width() >= 400);
  CHECK(at.scene.height() >= (height < 600 ? 210 : 270));
  CHECK(at.lesson.height() >= 160);
  const bool below = at.lesson.top == at.scene.bottom && at.lesson.right == at.code.left;
  const bool beside = at.lesson.right == at.scene.left && at.lesson.top == at.scene.top;
  CHECK((width < 960 ? below : beside));
}

TEST_CASE("panels are a share of the window, with a least and a most", "[window]") {
  const auto [width, height, lesson, code] = GENERATE(table<float, float, float, float>({{800, 600, 496, 304},
                                                                                         {1280, 800, 304, 344},
                                                                                         {1920, 1080, 456, 516},
                                                                                         {2560, 1440, 560, 560},
                                                                                         {3840, 2160, 560, 560}}));
  const WindowLayout at = window_layout(width, height);
  INFO(width << " x " << height);
  CHECK(at.lesson.width() == lesson);  // of the narrow one, below the scene, all that the code leaves
  CHECK(at.code.width() == code);
  CHECK(at.scene.width() >= 0.49f * width);
  const Rect all[] = {at.top, at.lesson, at.scene, at.code, at.transport};
  float area = 0;
  for (std::size_t i = 0; i < std::size(all); ++i) {
    area += all[i].width() * all[i].height();
    for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(meet(all[i], all[j]));
  }
  CHECK(area == Approx(width * height));
  const WindowDriver window(both, width, height, {}, {}, layout_only);
  CHECK(window.rect("lesson panel").width() == lesson);
  CHECK(window.rect("code panel").width() == code);
}

TEST_CASE("there is one scale of sizes: code is as large as words, and nothing is smaller", "[window]") {
  const WindowDriver window(both);
  std::set<long> sizes;
  for (const ImFont* font : ImGui::GetIO().Fonts->Fonts)
    sizes.insert(std::lround(font->FontSize * font->Scale));  // with the space between lines, by 1.164 larger
  const auto high = [](double size) { return std::lround(1.164 * size); };
  CHECK(sizes == std::set<long>{high(body_size), high(heading_size), high(large_size)});
  CHECK(Paragraph().size == body_size);
}

TEST_CASE("a wide panel breaks fewer lines of pseudocode", "[window][layout]") {
  const auto more_rows_at = [](float width, float height) {  // of all lines, after the first: each line has one pitch
    WindowDriver window(isect::lessons::all_lessons(), width, height, place_at("ray-sphere", "two-roots"), {},
                        layout_only);
    float least = height, sum = 0;
    int lines = 0;
    for (const auto& [name, r] : window.ui.rects())
      if (name.starts_with("line ")) least = std::min(least, r.height()), sum += r.height(), ++lines;
    return sum - static_cast<float>(lines) * least;
  };
  CHECK(more_rows_at(1280, 800) > 10);
  CHECK(more_rows_at(2560, 1440) == Approx(0).margin(0.1));
}

TEST_CASE("an open sheet dims the window and takes every click, one beside it closes it", "[window]") {
  const auto [width, height] = GENERATE(table<float, float>({{800, 600}, {1280, 800}, {1920, 1080}, {2560, 1440}}));
  WindowDriver window(both, width, height, {}, {}, layout_only);
  const auto brightness = [&] {
    const std::array<int, 3> c = pixel(window.picture(), 6, window.rect("lesson panel").middle_y());
    return c[0] + c[1] + c[2];
  };
  const int bright = brightness();
  for (const char* name : {"next", "play", "theme", "line 3"}) {
    window.type("?");
    window.frames(2);
    REQUIRE(window.has("key sheet"));
    CHECK(brightness() < 0.8 * bright);
    const Rect sheet = window.rect("key sheet"), widget = window.rect(name);
    const int step = window.player().index();
    const bool beside = !sheet.contains(widget.middle_x(), widget.middle_y());
    window.click(name);
    INFO(name << " at " << width);
    CHECK(window.has("key sheet") == !beside);
    CHECK(window.player().index() == step);
    CHECK_FALSE(window.player().clock().playing());
    CHECK(window.ui.settings().theme == ThemeName::dark);
    if (!beside) window.key(key::escape);
    window.frames(2);
    CHECK_FALSE(window.has("key sheet"));
    CHECK(brightness() == bright);
  }
  window.click("next");
  CHECK(window.player().index() == 1);
}

TEST_CASE("no words of a sheet are cut, at any size", "[window][layout]") {
  const auto [width, height] = GENERATE(table<float, float>({{800, 600}, {1280, 800}, {1920, 1080}, {2560, 1440}}));
  WindowDriver window(isect::lessons::all_lessons(), width, height, {}, {}, layout_only);
  const std::pair<const char*, const char*> sheets[] = {
      {"?", "key sheet"}, {"g", "terms"}, {"t", "reviews"}, {"h", "progress sheet"}, {"", "picker"}};
  for (const auto& [typed, name] : sheets) {
    if (*typed)
      window.type(typed);
    else
      window.key(key::o, true);
    window.frames(2);
    INFO(name << " at " << width);
    REQUIRE(window.has(name));
    CutWords cut;
    ImGui::GetIO().UserData = &cut;
    window.frames();
    ImGui::GetIO().UserData = nullptr;
    for (const std::string& words : cut) FAIL_CHECK("cut: " << words);
    window.key(key::escape);
    window.frames(2);
    REQUIRE_FALSE(window.has(name));
  }
}

TEST_CASE("a message covers neither the axes in the corner nor what stands in the other one", "[window]") {
  const auto [width, height] = GENERATE(table<float, float>({{800, 600}, {1280, 800}, {1920, 1080}, {2560, 1440}}));
  WindowDriver window(isect::lessons::all_lessons(), width, height, {}, {}, names_only);
  int marks = 0;
  for (const Lesson* lesson : isect::lessons::all_lessons()) {
    window.player().open(*lesson);
    window.ui.complain("A message that is as long as the reason why a file can't be written into some far folder");
    window.frames(2);
    REQUIRE(window.has("message"));
    const Rect message = window.rect("message"), scene = window.rect("scene");
    INFO(lesson->id << " at " << width);
    CHECK((message.left >= scene.left && message.right <= scene.right && message.top > scene.top));
    for (const char* mark : {"tripod", "projection", "changed", "pin"}) {
      if (!window.has(mark)) continue;
      ++marks;
      CHECK_FALSE(meet(message, window.rect(mark)));
    }
  }
  CHECK(marks > 10);
}

TEST_CASE("a message covers no name of a map and hardly a word of a closing card", "[window]") {
  const auto [lesson, step] =
      GENERATE(table<const char*, int>({{"collision", 1}, {"ray-sphere", 1}, {"ray-sphere", 0}}));
  WindowDriver window(isect::lessons::all_lessons(), 1280, 800, place_at(lesson, ""), {}, names_only);
  window.key(key::tab);
  window.player().go_to(window.player().count() - 1 - step);  // the card, or the map before it
  window.frames(30);
  window.ui.complain("A message");
  window.frames(2);
  const Rect message = window.rect("message"), scene = window.rect("scene");
  CHECK((message.top >= scene.top && message.bottom <= scene.bottom));
  REQUIRE_FALSE(window.ui.labels().empty());
  for (const PlacedLabel& label : window.ui.labels()) {
    INFO(lesson << ": " << label.text);
    const float top = scene.top + static_cast<float>(label.box.top),
                left = scene.left + static_cast<float>(label.box.left);
    const Rect words{left, top, scene.left + static_cast<float>(label.box.right),
                     scene.top + static_cast<float>(label.box.bottom)};
    const float inside = step == 0 ? 6 : 0;  // px: a card has words everywhere
    CHECK_FALSE(meet(message.inset(inside), words));
  }
}

TEST_CASE("a long line of pseudocode ends its rows where a reader minds it least", "[window]") {
  using Rows = std::vector<std::string>;
  CHECK(code_rows("q ← √(r² − m²)", 31) == Rows{"q ← √(r² − m²)"});
  CHECK(code_rows("if l² > r² or (l² = r² and s > 0)", 31) == Rows{"if l² > r²", "    or (l² = r² and s > 0)"});
  CHECK(code_rows("  if n · d > 0: t_in ← max(t_in, t)", 31) == Rows{"  if n · d > 0:", "      t_in ← max(t_in, t)"});
  CHECK(code_rows("  else: as bright as n · l says", 26) == Rows{"  else: as bright", "      as n · l says"});
  CHECK(code_rows("DISJOINT if a and b have no common point", 31) ==
        Rows{"DISJOINT if a and b have", "    no common point"});
  CHECK(code_rows("  if n · d = 0: go on, as p and q are not beyond it", 33) ==
        Rows{"  if n · d = 0: go on, as p and q", "      are not beyond it"});
  CHECK(code_rows("    if |n · l| > r_a + r_b: return DISJOINT", 24) ==
        Rows{"    if |n · l|", "        > r_a + r_b:", "        return DISJOINT"});
  CHECK(code_rows("judge each answer by the exact oracle", 31) == Rows{"judge each answer by", "    the exact oracle"});
  CHECK(code_rows("a_very_long_word another", 10) == Rows{"a_very_long_word another"});
  for (const Lesson* lesson : isect::lessons::all_lessons())
    for (const Preset& preset : lesson->presets)
      for (const std::string& line : lesson->walk(preset.parameters).pseudocode)
        for (const int columns : {24, 28, 31, 35}) {
          std::string all;
          const Rows rows = code_rows(line, columns);
          for (const std::string& row : rows) {
            INFO(lesson->id << ": " << row);
            const std::size_t begin = row.find_first_not_of(' ');
            CHECK((static_cast<int>(count_characters(row)) <= columns || row.find(' ', begin) == std::string::npos));
            all += (all.empty() ? row : " " + row.substr(begin));
          }
          CHECK(all == line);
        }
}

TEST_CASE("what goes on beyond the end of a panel is seen to", "[window]") {
  WindowDriver window(isect::lessons::all_lessons(), 800, 600, place_at("relations", "polygon-overlapping"));
  window.player().go_to(2);
  window.frames(3);
  REQUIRE(window.has("more below words"));
  CHECK_FALSE(window.has("more above words"));
  const Rect r = window.rect("more below words");
  window.move(r.middle_x(), r.top - 20);
  for (int i = 0; i < 20; ++i) window.wheel(-5);
  CHECK_FALSE(window.has("more below words"));
  CHECK(window.has("more above words"));
  window.resize(1280, 1400);
  window.frames(3);
  CHECK_FALSE((window.has("more below words") || window.has("more above words")));
}

TEST_CASE("what says that a setting was changed covers no word", "[window][layout]") {
  const auto [width, height] = GENERATE(table<float, float>({{800, 600}, {1280, 800}}));
  WindowDriver window(isect::lessons::all_lessons(), width, height, {}, {}, names_only);
  int changed = 0, names = 0;
  for (const Lesson* lesson : isect::lessons::all_lessons()) {
    window.player().open(*lesson);
    window.player().first();
    if (window.player().scene().handles.empty()) continue;
    const Handle handle = window.player().scene().handles.front();
    window.player().drag_handle(handle, handle.at + Vec3(0.11, 0.07, 0));
    if (!window.player().played().preset_id().empty()) continue;
    for (int i = 0; i < window.player().count(); ++i) {
      window.player().go_to(i);
      window.frames(2);
      ++changed;
      const Rect scene = window.rect("scene"), mark = window.rect("changed");
      for (const PlacedLabel& label : window.ui.labels()) {
        const TextBox& b = label.box;
        ++names;
        INFO(window.ui.title() << " at " << width << ": " << label.text);
        CHECK_FALSE((b.left + scene.left < mark.right - 8 && mark.left + 8 < b.right + scene.left &&
                     b.top + scene.top < mark.bottom - 8 && mark.top + 8 < b.bottom + scene.top));
      }
    }
  }
  CHECK(changed > 50);
  CHECK(names > 200);
}

TEST_CASE("no verdict covers a name, at any size", "[window][layout]") {
  const auto [width, height] = GENERATE(table<float, float>({{800, 600}, {1280, 800}, {2560, 1440}}));
  WindowDriver window(isect::lessons::all_lessons(), width, height, {}, {}, names_only);
  int told = 0, names = 0;
  for (const Lesson* lesson : isect::lessons::all_lessons()) {
    window.player().open(*lesson);
    for (const Preset& preset : lesson->presets) {
      window.player().load(preset);
      window.player().go_to(outcome(window.player().walk()));
      window.frames(2);
      if (!window.has("verdict")) continue;
      ++told;
      const Rect scene = window.rect("scene"), chip = window.rect("verdict");
      for (const PlacedLabel& label : window.ui.labels()) {
        INFO(window.ui.title() << " at " << width << ": " << label.text);
        ++names;
        CHECK((label.box.left + scene.left >= chip.right || label.box.top + scene.top >= chip.bottom));
      }
    }
  }
  CHECK(told > 150);
  CHECK(names > 1000);
}

TEST_CASE("no handle covers a name, at any size", "[window][layout]") {
  const auto [width, height] = GENERATE(table<float, float>({{800, 600}, {1280, 800}, {2560, 1440}}));
  WindowDriver window(isect::lessons::all_lessons(), width, height, {}, {}, names_only);
  int names = 0;
  const double ring = width == 800 ? 7.8 : 12;  // px; small drawings have small ones in a small window
  for (const Lesson* lesson : isect::lessons::all_lessons()) {
    window.player().open(*lesson);
    std::set<std::string> methods;
    for (const Preset& preset : lesson->presets) {
      if (!methods.insert(preset.group).second) continue;
      window.player().load(preset);
      for (int i = 0; i < window.player().count(); ++i) {
        window.player().go_to(i);
        window.frames(2);
        const Rect scene = window.rect("scene");
        if (window.has("projection text")) {
          const Rect r = window.rect("projection text");
          for (const PlacedLabel& label : window.ui.labels())
            CHECK((label.box.right < r.left - scene.left + 8 || label.box.bottom < r.top - scene.top + 4));
        }
        for (const Handle& h : window.player().scene().handles) {
          const Rect grip = window.rect("handle " + h.id());
          for (const PlacedLabel& label : window.ui.labels()) {
            ++names;
            const double x = grip.middle_x() - scene.left, y = grip.middle_y() - scene.top;
            const double across = std::max({label.box.left - x, x - label.box.right, 0.0});
            const double down = std::max({label.box.top - y, y - label.box.bottom, 0.0});
            INFO(window.ui.title() << " at " << width << ": " << h.parameter << " over " << label.text);
            CHECK(std::hypot(across, down) >= ring - 1);
          }
        }
      }
    }
  }
  CHECK(names > 1000);
}

TEST_CASE("what explains a mark stands beside it, however large the window is", "[window][layout]") {
  const auto [width, height] = GENERATE(table<float, float>({{800, 600}, {1280, 800}, {2560, 1440}}));
  WindowDriver window(isect::lessons::all_lessons(), width, height, place_at("robustness", "orientation"));
  window.player().go_to(3);
  window.frames(2);
  const Scene& scene = window.player().scene();
  const Rect r = window.rect("scene");
  const View view(window.player().camera().now(), r.width(), r.height() - 42, {0, 0});
  int explained = 0, counted = 0;
  for (const Item& item : scene.items)
    if (const Heading* heading = std::get_if<Heading>(&item))
      if (const std::size_t colon = heading->text.find(": "); colon != std::string::npos)
        counted += std::stoi(heading->text.substr(colon + 2));
  CHECK(counted == window.player().step().values[0].value);  // each cell once
  for (const PlacedLabel& label : window.ui.labels())
    for (std::size_t i = 0; i + 1 < scene.items.size(); ++i) {
      const Raster* swatch = std::get_if<Raster>(&scene.items[i]);
      const Heading* heading = std::get_if<Heading>(&scene.items[i + 1]);
      if (!swatch || !heading || plain(heading->text) != label.text) continue;
      const double gap = (heading->at - swatch->corner - swatch->across).x() * view.scale_at(heading->at);
      INFO(label.text << ": " << gap);
      CHECK(gap < 48);
      ++explained;
    }
  CHECK(explained >= 4);
  const auto raster =
      std::ranges::find_if(scene.items, [](const Item& i) { return std::holds_alternative<Raster>(i); });
  REQUIRE(raster != scene.items.end());
  const Raster& cells = std::get<Raster>(*raster);
  const Vec2 a = view.project(cells.corner).at + Vec2(0, 42);
  const Vec2 b = view.project(cells.corner + cells.across + cells.down).at + Vec2(0, 42);
  for (const PlacedLabel& label : window.ui.labels()) {
    INFO(label.text << " stands on the cells");
    const bool beside = label.box.right <= a.x() || label.box.left >= b.x();
    CHECK((beside || label.box.bottom <= a.y() || label.box.top >= b.y()));
  }
}

TEST_CASE("with the panels hidden the step's words and its line stand below the scene, which keeps its size",
          "[window]") {
  WindowDriver window(both);
  window.key(key::tab);
  for (int i = 0; i < window.player().count(); ++i) window.player().go_to(i), window.frames(2);
  const Rect scene = window.rect("scene");
  for (int i = 0; i < window.player().count(); ++i) {
    window.player().go_to(i);
    window.frames(2);
    const int line = window.player().step().line;
    CHECK(window.rect("lecture").height() > 40);
    if (line >= 0) CHECK(window.rect("line " + std::to_string(line + 1)).top > scene.bottom);
    CHECK(window.rect("scene").height() == scene.height());
  }
}

TEST_CASE("nothing overlaps, nothing is cut and nothing leaves the window, at any size, density and lesson",
          "[window][layout]") {
  const double scale = GENERATE(1.0, 2.0);  // 96 and 192 dpi
  const auto [width, height] =
      GENERATE(table<float, float>({{800, 600}, {1024, 768}, {1280, 800}, {1920, 1080}, {2560, 1440}}));
  Settings settings;
  settings.parameters_open = width == 1280 || (width == 800 && scale > 1);
  WindowDriver window(isect::lessons::all_lessons(), width, height, {}, settings,
                      {.scale = scale, .reduced_motion = true, .draw_scene = false, .place_names = false});
  const bool all = std::getenv("ISECT_LONG") != nullptr;
  for (const Lesson* lesson : isect::lessons::all_lessons()) {
    window.player().open(*lesson);
    std::set<std::string> methods;
    for (const Preset& preset : lesson->presets) {
      if (!all && !methods.insert(preset.group).second) continue;
      if (!all && scale == 2 && methods.size() > 1) break;
      window.player().load(preset);
      walk(window, width, height);
    }
  }
}

TEST_CASE("with the map beside the scene nothing overlaps, and nothing is cut, at any size", "[window][layout]") {
  const auto [width, height] =
      GENERATE(table<float, float>({{800, 600}, {1024, 768}, {1280, 800}, {1920, 1080}, {2560, 1440}}));
  Settings settings;
  settings.map = true;
  WindowDriver window(isect::lessons::all_lessons(), width, height, {}, settings, layout_only);
  for (const Lesson* lesson : isect::lessons::all_lessons()) {
    if (!lesson->map) continue;
    window.player().open(*lesson);
    for (const Preset& preset : lesson->presets)
      if (!has_map(window.player())) window.player().load(preset);
    window.frames();
    REQUIRE(window.has("map"));
    CHECK(window.rect("map plane").width() > 120);
    CHECK(window.rect("map plane").height() > 40);
    walk(window, width, height);
  }
}

TEST_CASE("with two panes nothing overlaps, and nothing is cut, at any size", "[window][layout]") {
  const auto [width, height] =
      GENERATE(table<float, float>({{800, 600}, {1024, 768}, {1280, 800}, {1920, 1080}, {2560, 1440}}));
  WindowDriver window(isect::lessons::all_lessons(), width, height, {}, {}, layout_only);
  for (const Lesson* lesson : isect::lessons::all_lessons()) {
    window.player().open(*lesson);
    window.frames();
    window.type("v");
    window.frames();
    REQUIRE(window.has("other scene"));
    CHECK(window.rect("other scene").height() > 150);
    CHECK(window.rect("other code lines").height() > 60);
    walk(window, width, height);
  }
}

TEST_CASE("small drawings on a page keep their texts apart and in the scene, in the least window", "[window][layout]") {
  WindowDriver window(isect::lessons::all_lessons(), 800, 600);
  int pages = 0;
  for (const Lesson* lesson : isect::lessons::all_lessons()) {
    window.player().open(*lesson);
    for (int i = 0; i < window.player().count(); ++i) {
      if (!is_page(window.player().walk().steps[i].scene)) continue;
      ++pages;
      window.player().go_to(i);
      window.frames(2);
      INFO(window.ui.title());
      const std::vector<PlacedLabel>& labels = window.ui.labels();
      const Rect scene = window.rect("scene");
      for (std::size_t k = 0; k < labels.size(); ++k) {
        const TextBox& a = labels[k].box;
        INFO(labels[k].text);
        CHECK((a.left >= 0 && a.top >= 0 && a.right <= scene.width() && a.bottom <= scene.height()));
        for (std::size_t m = 0; m < k; ++m) {
          const TextBox& b = labels[m].box;
          if (a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom)
            FAIL_CHECK("it meets " << labels[m].text);
        }
      }
    }
  }
  CHECK(pages > 5);
}

TEST_CASE("nothing overlaps and nothing is cut at 3840 x 2160, nor at 288 dpi", "[window][layout]") {
  const auto [scale, width, height] = GENERATE(table<double, float, float>({{1.0, 3840, 2160}, {3.0, 1280, 720}}));
  WindowDriver window(isect::lessons::all_lessons(), width, height, {}, {},
                      {.scale = scale, .reduced_motion = true, .draw_scene = false, .place_names = false});
  for (const Lesson* lesson : isect::lessons::all_lessons()) {
    window.player().open(*lesson);
    walk(window, width, height);
  }
}

TEST_CASE("large counts stand beside each other within their panel", "[window][layout]") {
  for (const char* preset : {"overlap", "void", "within"}) {
    WindowDriver window(isect::lessons::all_lessons(), 800, 600, place_at("bounding-volumes", preset));
    for (int i = 0; i < window.player().count(); ++i) {
      window.player().go_to(i);
      window.frames(2);
      check_layout(window, 800, 600);
      float end = 0;
      for (const char* name : {"mul", "add", "div", "sqrt", "cmp"}) {
        const std::string count = std::string("count ") + name;
        if (!window.has(count)) continue;
        CHECK(window.rect(count).left > end + 5);
        end = window.rect(count).right;
      }
    }
  }
}

TEST_CASE("a ray's t-axis stands below the scene, in each step and size", "[window]") {
  for (const auto& [width, height] : {std::pair(1280.0f, 800.0f), std::pair(800.0f, 600.0f)}) {
    WindowDriver window(isect::lessons::all_lessons(), width, height);
    int with_axis = 0;
    for (const Lesson* lesson : isect::lessons::all_lessons()) {
      window.player().open(*lesson);
      const std::vector<Step>& steps = window.player().walk().steps;
      if (std::ranges::none_of(steps, [](const Step& step) { return step.scene.axis.has_value(); })) continue;
      ++with_axis;
      for (int k = 0; k < static_cast<int>(steps.size()); ++k) {
        window.player().go_to(k);
        window.frames(2);
        const Scene& shown = window.player().scene();
        CAPTURE(lesson->id, k, width);
        if (shown.chart || !shown.axis) continue;
        const Rect scene = window.rect("scene");
        std::vector<std::string> below;
        for (const PlacedLabel& label : window.ui.labels()) {
          CHECK(label.box.bottom <= scene.height());
          if (label.box.top > 0.8 * scene.height()) below.push_back(label.text);
        }
        for (const Axis::Tick& tick : shown.axis->ticks)
          if (!tick.label.empty()) CHECK(std::ranges::count(below, plain(tick.label)) > 0);
      }
    }
    CHECK(with_axis >= 5);
  }
}

TEST_CASE("the axes in the corner give way to what is named there", "[window]") {
  WindowDriver window(isect::lessons::all_lessons(), 800, 600, place_at("ray-tracing", "lit"));
  window.frames(2);
  CHECK(window.has("tripod"));
  for (int k = 0; k < 25 && window.has("tripod"); ++k) {  // until the eye comes to lie there
    const Rect scene = window.rect("scene");
    pan(window.player(), View(window.player().camera().now(), scene.width(), scene.height()), {0, 0}, {0, 8});
    window.frames(2);
  }
  CHECK_FALSE(window.has("tripod"));
  int drawn = 0;
  for (const Lesson* lesson : isect::lessons::all_lessons()) {
    window.player().open(*lesson);
    window.player().go_to(outcome(window.player().walk()));
    window.frames(2);
    if (!window.has("tripod")) continue;
    ++drawn;
    const Rect scene = window.rect("scene"), tripod = window.rect("tripod");
    for (const PlacedLabel& label : window.ui.labels()) {
      INFO(lesson->id << ": " << label.text);
      const TextBox& box = label.box;
      CHECK_FALSE(
          meet(tripod, {scene.left + static_cast<float>(box.left), scene.top + static_cast<float>(box.top),
                        scene.left + static_cast<float>(box.right), scene.top + static_cast<float>(box.bottom)}));
    }
  }
  CHECK(drawn > 8);
}

TEST_CASE("with the panels hidden nothing overlaps, and nothing is cut, at any size", "[window][layout]") {
  const auto [width, height] = GENERATE(table<float, float>({{800, 600}, {1280, 800}, {1920, 1080}, {2560, 1440}}));
  WindowDriver window(isect::lessons::all_lessons(), width, height, {}, {}, layout_only);
  window.key(key::tab);
  for (const Lesson* lesson : isect::lessons::all_lessons()) {
    window.player().open(*lesson);
    walk(window, width, height);
    const float time =
        window.has("time") ? window.rect("time").height() : 0;  // bodies that move have a line below them
    CHECK(window.rect("scene").height() + time > 0.49f * height);
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

TEST_CASE("minus 0 is shown with its sign beside 0, and alone without", "[window]") {
  const auto value = [](const std::string& name, double x) {
    Value v;
    v.name = name, v.value = x;
    return v;
  };
  const std::vector<Value> both_zeros = {value("p", 0.0), value("q", -0.0)};
  CHECK(shown(both_zeros) == std::vector<std::string>{"0", "−0"});
  CHECK(shown({both_zeros[1]}) == std::vector<std::string>{shown(-0.0)});
}

TEST_CASE("values that read alike and are not equal are shown in full", "[window]") {
  int found = 0;
  const Lesson& points = lesson_named(isect::lessons::all_lessons(), "points");
  const Walk walk = points.walk(preset(points, "ten-steps").parameters);
  for (int step = 0; step < static_cast<int>(walk.steps.size()); ++step) {
    const std::vector<Value>& values = walk.steps[step].values;
    for (const Value& v : values) {
      const auto alike = [&](const Value& w) { return shown(w.value) == shown(v.value) && w.value != v.value; };
      if (std::ranges::none_of(values, alike) || shown(v.value) == to_text(v.value)) continue;
      ++found;
      WindowDriver window(isect::lessons::all_lessons(), 1280, 800,
                          {.lesson = "points", .preset = "ten-steps", .step = step});
      if (!window.has("number " + plain(v.name))) window.type("a");  // a question waits
      INFO(step << ' ' << v.name);
      CHECK(window.rect("number " + plain(v.name)).width() > 100);
    }
  }
  CHECK(found > 0);
}

TEST_CASE("small multiples take the room of a large window, and figures keep the lesson's columns", "[window]") {
  WindowDriver window(isect::lessons::all_lessons(), 2560, 1440, place_at("speed-against-error", "ray-sphere"), {},
                      layout_only);
  Player& player = window.player();
  for (int i = 0; i < player.count() && player.step().slug != "typical"; ++i) player.go_to(i);
  REQUIRE(player.step().slug == "typical");
  window.frames(3);
  const ReaderState state = player.reader_state();
  const double aspect = player.camera().aspect();
  const auto half_height = [&](const Scene& scene) { return frame(*state.camera, {&scene}, aspect, 0).half_height; };
  REQUIRE(player.is_arranged());
  CHECK(player.scene().items.size() == player.step().scene.items.size());
  CHECK(1.05 * half_height(player.scene()) < half_height(player.step().scene));
  CHECK(&player.own_scene() == &player.step().scene);

  const Rect scene = window.rect("scene");
  window.drag(scene.left + 40, scene.top + 150, scene.left + 90, scene.top + 170);
  window.frames(2);
  CHECK_FALSE(player.is_arranged());  // the reader's own view, which copied states and figures keep
  window.key(key::z, true);
  window.frames(2);
  CHECK(player.is_arranged());
  CHECK(player.camera().goal() == *state.camera);

  window.key(key::right);
  window.frames(2);
  CHECK_FALSE(player.is_arranged());
}

}  // namespace window_look_test
