// All lessons in one sheet, and the terms in another.

#include <filesystem>

#include "lessons/course.h"
#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/window_driver.h"
#include "viz/compose/halos.h"
#include "viz/player/practice.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"

namespace picker_test {
using namespace isect;
using namespace isect::viz;

namespace {

ReaderState at(const std::string& lesson) {
  ReaderState state;
  state.lesson = lesson;
  return state;
}

WindowOptions with_course() {
  WindowOptions options{.reduced_motion = true};
  options.course = lessons::course();
  return options;
}

WindowOptions with_course_undrawn() {
  WindowOptions options = with_course();
  options.draw_scene = options.place_names = false;
  return options;
}

/// How well these words, in small letters, name a lesson: its title, the title's begin, a part of it, or none.
int rank_of(const Lesson& lesson, const std::string& words) {
  std::string title = plain(lesson.title);
  std::ranges::transform(title, title.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (title == words || title.substr(0, title.find(':')) == words || lesson.id == words) return 0;
  const auto at = title.find(words);
  return at == 0 ? 1 : at != title.npos ? 2 : 3;
}

}  // namespace

TEST_CASE("parts begin with lessons of the course, in its order, and terms lead to lessons", "[course]") {
  const std::vector<const Lesson*>& all = lessons::all_lessons();
  std::size_t last = 0;
  for (const Course::Part& part : lessons::course().parts) {
    INFO(part.title);
    const Lesson* first = &lesson_named(all, part.first);
    const std::size_t index = std::ranges::find(all, first) - all.begin();
    CHECK((index > last || index == 0));
    last = index;
  }
  CHECK(lessons::course().parts.front().first == all.front()->id);
  for (const Course::Term& term : lessons::course().terms) CHECK_NOTHROW(lesson_named(all, term.lesson));
}

TEST_CASE("the picker shows all lessons without scrolling, each by its whole title", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, {}, {}, with_course());
  window.key(key::o, true);
  window.frames(2);
  const Rect sheet = window.rect("picker");
  float top = 0;
  for (const Lesson* lesson : window.player().lessons()) {
    INFO(lesson->id);
    REQUIRE(window.has("lesson " + lesson->id));
    const Rect r = window.rect("lesson " + lesson->id);
    CHECK((r.top >= sheet.top && r.bottom <= sheet.bottom && r.left >= sheet.left && r.right <= sheet.right));
    CHECK(text_width(ImGui::GetFont(), lesson->title) <= r.width());
    if (r.left < sheet.middle_x()) CHECK(std::exchange(top, r.top) < r.top);  // in the order of the course
  }
}

TEST_CASE("no lesson leaves the picker's sight when a preset has been saved", "[window]") {
  const std::string folder = (std::filesystem::temp_directory_path() / "isect-picker-presets").string();
  std::filesystem::remove_all(folder);
  WindowOptions options = with_course();
  options.figures = folder;
  WindowDriver window(lessons::all_lessons(), 1280, 800, {}, {}, options);
  window.type("s");
  window.frames(2);
  window.click("save as preset");
  window.frames(2);
  window.move(5, 5);  // over no row, whose lesson would be told
  window.key(key::o, true);
  window.frames(2);
  const std::string id = window.player().lesson().id;
  REQUIRE(window.has("saved " + id + ", setting-1"));
  for (const Lesson* lesson : window.player().lessons()) {
    INFO(lesson->id);
    CHECK(window.rect("lesson " + lesson->id).bottom <= window.rect("about " + id).top);
  }

  // A preset is found by the name that stands there, not by folders above it.
  for (const char* words : {"setting", "isect-picker-presets"}) {
    window.click("search");
    window.type(words);
    window.frames(2);
    CHECK(window.has("saved " + id + ", setting-1") == (words == std::string("setting")));
    for (std::size_t i = 0; i < std::string(words).size(); ++i) window.key(key::backspace);
  }
  std::filesystem::remove_all(folder);
}

TEST_CASE("arrows choose a lesson and Enter opens it", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, {}, {}, with_course());
  window.key(key::o, true);
  window.frames(2);
  for (int i = 0; i < 3; ++i) window.key(key::down);
  const std::string held = window.ui.focus();
  REQUIRE(held.starts_with("lesson "));
  CHECK(window.has("focus ring"));
  window.key(key::enter);
  window.frames(2);
  CHECK(window.player().lesson().id == held.substr(7));
  CHECK_FALSE(window.has("picker"));
}

TEST_CASE("words narrow the picker, and Enter opens the first that has them", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, {}, {}, with_course());
  window.key(key::o, true);
  window.frames(2);
  window.type("BALL ray");
  CHECK(window.has("lesson ray-sphere"));
  CHECK_FALSE(window.has("lesson clipping"));
  CHECK(window.has("about ray-sphere"));  // what Enter opens
  CHECK(window.player().index() == 0);
  window.key(key::enter);
  window.frames(2);
  CHECK(window.player().lesson().id == "ray-sphere");
  window.click("lesson");
  window.frames(2);
  CHECK(window.has("recent relations"));  // where we were before
  window.click("recent relations");
  CHECK(window.player().lesson().id == "relations");
}

TEST_CASE("a title that is typed opens its lesson, whole or up to its colon, and so does an id", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, {}, {}, with_course_undrawn());
  for (const Lesson* lesson : lessons::all_lessons())
    for (const std::string& words : {plain(lesson->title), plain(short_title(*lesson)), lesson->id}) {
      CAPTURE(words);
      window.key(key::o, true);
      window.frames(2);
      window.type(words);
      window.key(key::enter);
      window.frames(2);
      CHECK(window.player().lesson().id == lesson->id);
      CHECK_FALSE(window.has("picker"));
    }
}

TEST_CASE("what is found by its title stands before the rest, the exact title first", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, {}, {}, with_course_undrawn());
  for (const std::string words : {"collision", "polygon", "sphere", "ray and", "interval", "slab"}) {
    CAPTURE(words);
    window.key(key::o, true);
    window.frames(2);
    window.type(words);
    window.frames(2);
    std::vector<std::tuple<float, float, int>> rows;  // from the left, from the top
    for (const Lesson* lesson : lessons::all_lessons())
      if (const std::string name = "lesson " + lesson->id; window.has(name))
        rows.emplace_back(window.rect(name).left, window.rect(name).top, rank_of(*lesson, words));
    REQUIRE_FALSE(rows.empty());
    std::ranges::sort(rows);
    for (std::size_t i = 1; i < rows.size(); ++i) CHECK(std::get<2>(rows[i - 1]) <= std::get<2>(rows[i]));
    CHECK(window.rect("chosen row").left == std::get<0>(rows.front()));
    CHECK(window.rect("chosen row").top == std::get<1>(rows.front()));
    window.key(key::escape);
    window.frames(2);
  }
}

TEST_CASE("the row that Enter opens looks chosen from the start, in all themes", "[window]") {
  for (const ThemeName theme : {ThemeName::dark, ThemeName::screen, ThemeName::grey}) {
    CAPTURE(name_of(theme));
    Settings kept;
    kept.theme = theme;
    WindowDriver window(lessons::all_lessons(), 1280, 800, at("ray-sphere"), kept, with_course());
    window.key(key::o, true);
    window.frames(2);
    REQUIRE(window.has("chosen row"));
    const auto holds = [&](const std::string& name) {
      const Rect row = window.rect("chosen row"), r = window.rect(name);
      return row.left == r.left && row.top == r.top;
    };
    CHECK(holds("lesson ray-sphere"));
    const Palette c = palette(theme);
    CHECK(contrast_ratio(c.on_first, c.first) >= 4.5);
    CHECK(contrast_ratio(c.first, c.window) >= 3);
    const Rect r = window.rect("chosen row");
    const Picture all = window.picture();
    const std::uint8_t* p =
        &all.rgba[4 * (static_cast<std::size_t>(r.middle_y()) * all.width + static_cast<std::size_t>(r.left + 4))];
    CHECK(std::abs(p[0] - 255 * c.first.r) <= 1.5);
    CHECK(std::abs(p[2] - 255 * c.first.b) <= 1.5);

    window.key(key::enter);  // the lesson on show goes on
    window.frames(2);
    CHECK_FALSE(window.has("picker"));
    CHECK(window.player().lesson().id == "ray-sphere");

    window.key(key::o, true);
    window.frames(2);
    window.key(key::down);  // from the chosen row on
    CHECK(window.ui.focus() == "lesson " + next_lesson(window.player())->id);
    CHECK(holds(window.ui.focus()));
    window.type("b");  // what is found is chosen anew
    CHECK(window.ui.focus().empty());
  }
}

TEST_CASE("the picker understands the words of the subject, and Enter on none of them keeps the search", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, {}, {}, with_course());
  const auto search = [&](const char* words) {
    window.key(key::escape);
    window.frames(2);
    window.key(key::o, true);
    window.frames(2);
    window.type(words);
  };
  for (const auto& [words, lesson] : {std::pair("ray box", "clipping"),
                                      {"cube", "aabb-aabb"},
                                      {"point inside", "crossings"},
                                      {"slab", "intervals"},
                                      {"ray polygon", "ray-polygon"}}) {
    CAPTURE(words);
    search(words);
    CHECK(window.has(std::string("lesson ") + lesson));
  }
  search("quaternion");
  CHECK_FALSE(window.has("about relations"));  // no lesson has it, so none is shown
  window.key(key::enter);
  window.frames(2);
  for (int i = 0; i < 10; ++i) window.key(key::backspace);
  window.type("sphere");
  CHECK(window.has("lesson sphere-sphere"));
}

TEST_CASE("a lesson is found by its presets and by the terms that it explains", "[window]") {
  for (const auto& [words, lesson] : {std::pair("tunnelling", "collision"), std::pair("too short", "rays")}) {
    WindowDriver window(lessons::all_lessons(), 1280, 800, {}, {}, with_course());
    window.key(key::o, true);
    window.frames(2);
    window.type(words);
    window.frames(2);
    INFO(words);
    CHECK(window.has(std::string("lesson ") + lesson));
    CHECK_FALSE(window.has("lesson points"));
  }
}

TEST_CASE("what was answered and read to its end is kept, and stands in the picker", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("ray-sphere"), {}, with_course());
  int asked = 0, right = 0;
  while (!window.player().at_end()) {
    window.key(key::right);
    const Question* q = window.player().quiz().asked();
    if (!q) continue;
    right += ++asked % 2;
    const int wrong = (q->answer + 1) % static_cast<int>(q->choices.size());
    window.answer(asked % 2 ? q->answer : wrong);
  }
  REQUIRE(asked >= 3);
  window.frames(2);
  const Settings kept = window.ui.settings();
  CHECK(static_cast<int>(kept.scores.at("ray-sphere").answers.size()) == asked);
  CHECK(kept.scores.at("ray-sphere").right() == right);
  CHECK(kept.scores.at("ray-sphere").finished);
  window.key(key::o, true);
  window.frames(2);
  CHECK(window.has("score ray-sphere"));
  CHECK_FALSE(window.has("score clipping"));
}

TEST_CASE("the picker shows what a lesson looks like", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("ray-sphere"), {}, with_course());
  const auto shown = [&] {
    const Rect r = window.rect("lesson picture").inset(4);
    const Picture all = window.picture();
    std::set<std::array<int, 3>> colours;
    for (int y = static_cast<int>(r.top); y < static_cast<int>(r.bottom); ++y)
      for (int x = static_cast<int>(r.left); x < static_cast<int>(r.right); ++x) {
        const std::uint8_t* p = &all.rgba[4 * (static_cast<std::size_t>(y) * all.width + static_cast<std::size_t>(x))];
        colours.insert({p[0], p[1], p[2]});
      }
    return colours;
  };
  window.key(key::o, true);
  window.frames(3);
  const auto own = shown();
  CHECK(own.size() > 100);
  const Rect other = window.rect("lesson intervals");
  window.move(other.middle_x(), other.middle_y());
  window.frames(3);
  CHECK(shown() != own);
}

TEST_CASE("what was answered wrong is offered again at the end, until it is answered right", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("ray-sphere"), {}, with_course());
  int step = -1;
  while (!window.player().at_end()) {
    window.key(key::right);
    const Question* q = window.player().quiz().asked();
    if (!q || step >= 0) continue;
    step = window.player().index() + 1;
    window.answer((q->answer + 1) % static_cast<int>(q->choices.size()));
  }
  REQUIRE(step > 0);
  window.frames(2);
  const std::string again = "again " + std::to_string(step + 1);
  window.ui.player().last();
  for (int i = 0; i < 60 && window.ui.focus() != again; ++i) window.key(key::down);
  REQUIRE(window.ui.focus() == again);
  window.key(key::enter);
  const Question* q = window.player().quiz().asked();
  REQUIRE(q);
  CHECK(window.player().index() + 1 == step);
  window.answer(q->answer);
  window.player().last();
  window.frames(2);
  CHECK_FALSE(window.has(again));
}

TEST_CASE("what was skipped is kept, and offered at the end until it is answered", "[window]") {
  Settings kept;
  {
    WindowDriver window(lessons::all_lessons(), 1280, 800, at("ray-sphere"), {}, with_course_undrawn());
    while (!window.player().at_end()) window.key(key::right);
    kept = window.ui.settings();
  }
  const std::set<std::string> skipped = kept.scores.at("ray-sphere").skipped;
  REQUIRE(skipped.size() >= 3);
  CHECK(kept.scores.at("ray-sphere").answers.empty());
  kept.reader_state.reset();
  WindowDriver window(lessons::all_lessons(), 1280, 3600, at("ray-sphere"), kept, with_course_undrawn());
  window.ui.player().last();
  window.frames(2);
  int step = 1;
  while (step < window.player().count() && !window.has("again " + std::to_string(step + 1))) ++step;
  REQUIRE(step < window.player().count());
  window.click("again " + std::to_string(step + 1));
  const Question* q = window.player().quiz().asked();
  REQUIRE(q);
  CHECK(window.player().index() + 1 == step);
  window.answer(q->answer);
  window.frames(2);
  CHECK(window.ui.settings().scores.at("ray-sphere").skipped.size() == skipped.size() - 1);
  window.ui.player().last();
  window.frames(2);
  CHECK_FALSE(window.has("again " + std::to_string(step + 1)));
}

TEST_CASE("G shows the terms, and each leads to its lesson", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, {}, {}, with_course());
  window.type("g");
  window.frames(2);
  REQUIRE(window.has("terms"));
  window.type("winding");
  CHECK(window.has("term winding number"));
  CHECK_FALSE(window.has("term tangent"));
  window.key(key::enter);
  window.frames(2);
  CHECK(window.player().lesson().id == "crossings");
  CHECK_FALSE(window.has("terms"));
}

TEST_CASE("presets that have no room in the bar have a menu, and cover no title", "[window]") {
  WindowDriver window(lessons::all_lessons(), 800, 600, at("intervals"), {}, with_course());
  REQUIRE(window.has("presets"));
  CHECK(window.rect("lesson").right <= window.rect("presets").left);
  CHECK(window.rect("presets").right <= window.rect("theme").left);
  window.click("presets");
  window.frames(2);
  window.click("preset 10");
  CHECK(window.player().played().preset_id() == window.player().played().group()[9]->id);
}

}  // namespace picker_test
