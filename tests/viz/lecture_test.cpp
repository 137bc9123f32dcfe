// The strip of a lecture, and the keys with which one is given.

#include <algorithm>
#include <string>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/at_question.h"
#include "tests/viz/sample_lesson.h"
#include "tests/viz/window_driver.h"
#include "viz/text/rich_text.h"
#include "viz/window/panels.h"

namespace lecture_test {
using namespace isect;
using namespace isect::viz;

namespace {

const Lesson number = sample::asking_for_a_number(), disc = sample::lesson();

ReaderState at(const std::string& lesson, const std::string& preset, int step) {
  ReaderState state = place_at(lesson, preset);
  state.step = step;
  return state;
}

int step_called(const Player& player, const std::string& slug) {
  const std::vector<Step>& steps = player.walk().steps;
  const auto found = std::ranges::find(steps, slug, &Step::slug);
  REQUIRE(found != steps.end());
  return static_cast<int>(found - steps.begin());
}

bool within(const Rect& r, const Rect& whole) {
  return r.left >= whole.left && r.right <= whole.right && r.top >= whole.top && r.bottom <= whole.bottom;
}

/// Checks that the strip stands where it stood, and that all of the question lies in it; what lies below its end is
/// scrolled to.
void check_strip(const WindowDriver& window, const Rect& strip) {
  const Rect now = window.rect("lecture");
  CHECK((now.top == strip.top && now.bottom == strip.bottom));
  CHECK(window.rect("scene").bottom <= now.top);
  CHECK(now.bottom <= window.rect("transport").top);
  static const char* const words[] = {"choice ", "answer",         "tile ",      "give answer",    "show choices",
                                      "reply",   "what was typed", "the answer", "what came of it"};
  static const char* const state[] = {"point ", "told value ", "told formula", "line "};
  for (const auto& [name, r] : window.ui.rects()) {
    const auto begins = [&name = name](const char* start) { return name.starts_with(start); };
    const bool beside = std::ranges::any_of(state, begins);
    if (!beside && std::ranges::none_of(words, begins)) continue;
    const std::string part = beside ? "told state" : "told words";
    const Rect place = window.rect(part);
    INFO(name << ": " << r.left << " " << r.top << " " << r.right << " " << r.bottom);
    CHECK((r.left >= place.left && r.right <= place.right && r.top >= place.top));
    if (r.bottom > place.bottom) CHECK(window.has("more below " + part));
  }
}

}  // namespace

TEST_CASE("in a lecture a question stands in the strip and covers nothing, at any size and with larger words",
          "[lecture][layout]") {
  const auto [width, height, size] = GENERATE(table<float, float, double>(
      {{800, 600, 1.0}, {1280, 800, 1.0}, {1280, 800, 1.6}, {1920, 1080, 1.0}, {1920, 1080, 2.0}, {2560, 1440, 1.0}}));
  CAPTURE(width, height, size);
  Settings settings;
  settings.size = size;
  WindowDriver window(lessons::all_lessons(), width, height, {}, settings, layout_only);
  window.key(key::tab);
  const Rect strip = window.rect("lecture");
  const bool roomy = width >= 1280 && size == 1;
  int asked = 0;
  ask_all(window, lessons::all_lessons(), [&](const Question&) {
    ++asked;
    window.frames(2);
    INFO(window.ui.title());
    check_strip(window, strip);
    const Rect words = window.rect("told words");
    const bool more = window.player().quiz().asks_more();
    // a line is pointed at in the strip's other half
    const Quiz& quiz = window.player().quiz();
    if (!quiz.wants_line())
      CHECK(window.rect(quiz.wants_order() ? "tile 0" : more ? "answer" : "choice 0").top < words.bottom);
    if (roomy) CHECK(within(window.rect(more ? "answer" : "choice 0"), words));
    if (more) {
      window.player().show_choices();
      window.frames(2);
      check_strip(window, strip);
    }
    window.player().answer(0);
    window.frames(2);
    REQUIRE(window.player().quiz().answered());
    CHECK(within(window.rect("what came of it"), words));
    check_strip(window, strip);
  });
  CHECK(asked > 40);
}

TEST_CASE("the strip is a share of the window, and the same in all steps of all lessons", "[lecture]") {
  for (const auto& [width, height] :
       {std::pair(800.0f, 500.0f), std::pair(1280.0f, 800.0f), std::pair(2560.0f, 1440.0f)}) {
    const WindowLayout layout = lecture_layout(width, height);
    CHECK(layout.lesson.top == layout.scene.bottom);
    CHECK(layout.lesson.height() >= 130);
    CHECK(layout.lesson.height() < 0.6f * layout.scene.height());
    WindowDriver window({&disc, &number}, width, height, {}, {}, layout_only);
    window.key(key::tab);
    for (int i = 0; i < window.player().count(); ++i) {
      window.player().go_to(i);
      window.frames(2);
      CHECK(window.rect("lecture").top == layout.lesson.top);
      CHECK(window.rect("scene").bottom == layout.scene.bottom);
    }
  }
}

TEST_CASE("in a lecture a question stands with the numbers it needs", "[lecture]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("ray-sphere", "inside"));
  window.player().go_to(step_called(window.player(), "passing-distance") - 1);
  window.key(key::tab);
  window.key(key::right);
  window.frames(2);
  REQUIRE(window.player().quiz().asked());
  for (const Value& given : window.player().quiz().asked()->given)
    CHECK(within(window.rect("told value " + plain(given.name)), window.rect("told state")));
  REQUIRE(window.has("known values"));
  CHECK(window.rect("known values").left > window.rect("answer").right);
}

TEST_CASE("in a lecture the question is answered in the strip, and the scene stays as it is", "[lecture]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("ray-sphere", "two-roots", 4));
  window.key(key::tab);
  const Rect scene = window.rect("scene");
  window.key(key::right);
  window.frames(2);
  REQUIRE(window.player().quiz().asked());
  window.player().show_choices();
  window.frames(2);
  REQUIRE(window.has("choice 1"));
  CHECK(within(window.rect("choice 1"), window.rect("told words")));
  CHECK(window.rect("scene").bottom == scene.bottom);
  const Camera camera = window.player().camera().goal();
  const int right = window.player().quiz().asked()->answer;
  window.click("choice " + std::to_string(right));
  REQUIRE(window.player().quiz().answered());
  CHECK(window.player().quiz().answered()->right());
  CHECK(window.player().camera().goal().azimuth == camera.azimuth);
  window.frames(2);
  CHECK(within(window.rect("what came of it"), window.rect("told words")));
  CHECK(window.has("choice " + std::to_string(right)));
  CHECK(window.rect("scene").bottom == scene.bottom);
}

TEST_CASE("the last of five answers is reached by keys in the least window", "[lecture]") {
  WindowDriver window(lessons::all_lessons(), 800, 600, place_at("speed-against-error", "ray-sphere"), {}, layout_only);
  window.player().go_to(step_called(window.player(), "cost") - 1);
  window.key(key::tab);
  for (int i = 0; i < 4 && !window.player().quiz().asked(); ++i) window.key(key::page_down);  // first the words' rest
  window.frames(2);
  REQUIRE(window.player().quiz().asked());
  REQUIRE(window.player().quiz().asked()->choices.size() == 5);
  for (int i = 0; i < 80 && window.ui.focus() != "choice 4"; ++i) window.key(key::down);
  REQUIRE(window.ui.focus() == "choice 4");
  window.frames(3);
  CHECK(within(window.rect("choice 4"), window.rect("told words")));
  window.key(key::enter);
  REQUIRE(window.player().quiz().answered());
  CHECK(window.player().quiz().answered()->choice == 4);
}

TEST_CASE("Page Down goes to a question, then to its answer, and Page Up back, and N goes on, too", "[lecture]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("ray-sphere", "two-roots", 4));
  const std::string preset = window.player().played().preset_id();
  const bool by_letter = GENERATE(false, true);
  const auto on = [&] {
    if (by_letter) return window.type("n");
    window.key(key::page_down);
    window.frames(2);
  };
  window.key(key::tab);
  on();
  REQUIRE(window.player().quiz().asked());
  CHECK(window.player().index() == 4);
  CHECK_FALSE(window.has("the answer"));
  on();
  CHECK_FALSE(window.player().quiz().asked());
  CHECK(window.player().index() == 5);
  REQUIRE(window.has("the answer"));
  CHECK(window.has("choice " + std::to_string(window.player().step().question->answer)));
  CHECK(window.player().answers_given() == 0);  // nobody has answered it
  on();
  CHECK_FALSE(window.has("the answer"));
  while (window.player().index() > 4) window.key(key::page_up);
  CHECK(window.player().index() == 4);
  CHECK(window.player().played().preset_id() == preset);
  CHECK(window.player().clock().stops_at_questions());
  window.type("2");
  CHECK(window.player().played().preset_id() == window.player().played().group()[1]->id);
  window.key(key::tab);
  window.key(key::page_up);
  CHECK(window.player().played().preset_id() == preset);  // with the panels it goes to presets
}

TEST_CASE("in a lecture Page Down leaves an answer that is being typed", "[lecture]") {
  AtQuestion asked({&number});
  asked.window.key(key::tab);
  asked.type("0.5");
  REQUIRE(asked.window.player().quiz().asked());
  asked.window.key(key::page_down);
  asked.window.frames(3);
  CHECK(asked.window.player().index() == 2);
  CHECK_FALSE(asked.window.player().quiz().asked());
  asked.window.key(key::page_down);
  CHECK(asked.window.player().index() == 3);
}

TEST_CASE("only outside of a lecture the full screen tells how one begins", "[lecture]") {
  WindowDriver window({&disc});
  const auto told = [&] {
    window.key(key::f11);
    const std::string words = window.ui.message();
    window.key(key::f11);
    return words;
  };
  CHECK(told() == "Ctrl + and Ctrl − change the size of everything, Tab begins a lecture");
  window.key(key::tab);
  CHECK(told() == "Ctrl + and Ctrl − change the size of everything");
}

TEST_CASE("B or a dot makes the screen dark in a lecture, and any key or click makes it light", "[lecture]") {
  WindowDriver window({&disc});
  window.type("b");
  CHECK_FALSE(window.has("dark"));
  window.key(key::tab);
  for (const char* sign : {"b", ".", "B"}) {
    window.type(sign);
    REQUIRE(window.has("dark"));
    window.key(key::page_down);
    CHECK_FALSE(window.has("dark"));
    CHECK(window.player().index() == 0);
  }
  for (const key::Code code : {key::insert, key::backspace, key::f6, key::keypad_enter}) {
    window.type(".");
    REQUIRE(window.has("dark"));
    window.key(code);
    CHECK_FALSE(window.has("dark"));
  }
  window.type(".");
  window.type("x");
  CHECK_FALSE(window.has("dark"));
  window.type(".");
  window.frames(2);
  window.click("dark screen");
  CHECK_FALSE(window.has("dark"));
  window.type(".");
  window.key(key::q, true);
  CHECK((window.ui.wants_to_close() && !window.has("dark")));
}

TEST_CASE("what is shown large are the values of the line and, up to three, of the condition, new ones, of the formula",
          "[lecture]") {
  const auto named = [](const char* name, bool fresh = false) {
    Value v;
    v.name = name, v.fresh = fresh;
    return v;
  };
  const auto names = [](const std::vector<Value>& values) {
    std::vector<std::string> all;
    for (const Value& v : values) all.push_back(plain(v.name));
    return all;
  };
  using Names = std::vector<std::string>;
  Walk walk;
  walk.pseudocode = {"if l² > r²", "  s ← l · d"};
  Step step;
  step.values = {named("*s*"), named("*l*"), named("*l*^2"), named("*r*^2", true), named("*q*", true)};
  CHECK(names(values_in_use(walk, step)) == Names{"r²", "q"});
  step.line = 1;
  CHECK(names(values_in_use(walk, step)) == Names{"s", "l", "r²"});
  step.line = 0;
  step.comparison.emplace().text = "*l*^2 > *r*^2";
  CHECK(names(values_in_use(walk, step)) == Names{"l²", "r²", "q"});
  step.values[3].fresh = step.values[4].fresh = false;
  CHECK(names(values_in_use(walk, step)) == Names{"l²", "r²"});  // l is not a part of l²
  step.comparison.reset();
  step.line = -1;
  CHECK(values_in_use(walk, step).empty());
  step.formula = "*q* = √(*r*^2 − *m*^2)";
  CHECK(names(values_in_use(walk, step)) == Names{"r²", "q"});
}

TEST_CASE("in a lecture the current line is large, and says yes or no", "[lecture]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("ray-sphere", "two-roots"));
  window.player().go_to(step_called(window.player(), "which-root"));
  window.key(key::tab);
  window.frames(2);
  REQUIRE((window.has("line 10") && window.has("yes 10")));
  CHECK(window.rect("line 10").height() >= 38);
  CHECK(within(window.rect("yes 10"), window.rect("line 10")));
}

TEST_CASE("each name of the line is shown large with its value, also one that is squared or a knob", "[lecture]") {
  Walk walk;
  walk.pseudocode = {"Δ ← B² − 4 A C", "m² ← l² − s²", "R ← r_a + r_b", "t ← −(n · o + D) / (n · d)"};
  const auto told = [&](int line, const std::vector<std::string>& known, const std::vector<std::string>& knobs) {
    const auto values = [](const std::vector<std::string>& names) {
      std::vector<Value> all;
      for (const std::string& name : names) all.push_back({.name = name});
      return all;
    };
    Step step;
    step.line = line, step.values = values(known);
    std::vector<std::string> names;
    for (const Value& v : values_in_use(walk, step, values(knobs))) names.push_back(v.name);
    return names;
  };
  using Names = std::vector<std::string>;
  CHECK(told(0, {"*A*", "*B*", "*C*", "*Δ*"}, {}) == Names{"*A*", "*B*", "*C*", "*Δ*"});
  CHECK(told(1, {"*s*", "*l*^2", "*m*^2"}, {"*r*"}) == Names{"*s*", "*l*^2", "*m*^2"});
  CHECK(told(2, {"*R*^2"}, {"*r*_a", "*r*_b", "*t*"}) == Names{"*R*^2", "*r*_a", "*r*_b"});
  CHECK(told(2, {"*R*^2", "*R*"}, {}) == Names{"*R*"});
  CHECK(told(3, {"**n** · **o** + *D*", "**n** · **d**", "*t*"}, {"*D*"}) ==
        Names{"**n** · **o** + *D*", "**n** · **d**", "*t*"});
}

namespace {

/// The sample lesson, whose steps say so many paragraphs.
Lesson talkative(int paragraphs) {
  Lesson l = sample::lesson();
  l.id = "point-words";
  l.steps = [paragraphs](const Parameters& values) {
    Walk w = sample::walk(values);
    for (Step& step : w.steps) {
      step.caption = "The first of them is short.";
      for (int i = 1; i < paragraphs; ++i)
        step.caption += "\nHere is a paragraph with as many words as it takes to begin another line, and some more.";
    }
    return w;
  };
  return l;
}

}  // namespace

TEST_CASE("in a lecture words that are longer than their column go on beside it, or are shown before a key goes on",
          "[lecture]") {
  const auto [paragraphs, beside] = GENERATE(table<int, bool>({{1, false}, {5, true}, {30, false}}));
  CAPTURE(paragraphs);
  const Lesson words = talkative(paragraphs);
  WindowDriver window({&words});
  window.player().go_to(1);
  window.key(key::tab);
  window.frames(3);
  const bool more = paragraphs == 30;
  CHECK(window.has("more below told words") == more);
  REQUIRE(window.has("told on") == beside);
  if (beside) {
    CHECK(within(window.rect("told on"), window.rect("told state")));
    CHECK_FALSE(window.has("more below told state"));
    CHECK(window.rect("told on").top >= window.rect("line 2").bottom);
  }
  const key::Code code = GENERATE(key::page_down, key::right);
  int pages = 0;
  for (; window.has("more below told words") && pages < 20; ++pages) {
    window.key(code);
    window.frames(2);
    REQUIRE(window.player().index() == 1);
    REQUIRE_FALSE(window.player().quiz().asked());
    CHECK(window.has("more above told words"));
  }
  CHECK((more ? pages > 1 && pages < 20 : pages == 0));
  window.key(code);
  window.frames(2);
  CHECK(window.player().quiz().asked());
}

TEST_CASE("in a lecture the space bar shows the words' rest before it plays, and N goes on at once", "[lecture]") {
  const Lesson words = talkative(12);
  WindowDriver window({&words}, 800, 600);
  window.key(key::tab);
  window.frames(2);
  REQUIRE(window.has("more below told words"));
  window.type(" ");
  CHECK_FALSE(window.player().running());
  CHECK(window.has("more above told words"));
  window.type("n");
  CHECK(window.player().index() == 1);
  window.frames(2);
  CHECK_FALSE(window.has("more above told words"));  // another step begins at its beginning
}

TEST_CASE("in a lecture of the usual size no words of a step lie below the strip's end", "[lecture][layout]") {
  const char* const id = GENERATE("relations", "sphere-sphere", "rays", "ray-sphere");
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at(id, ""), {}, layout_only);
  window.key(key::tab);
  for (int i = 0; i < window.player().count(); ++i) {
    for (const bool passed : {false, true}) {
      window.player().go_to(i);
      if (passed && i + 1 < window.player().count()) {
        window.player().next();
        if (window.player().quiz().asked()) window.player().next();
      }
      window.frames(2);
      INFO(window.ui.title());
      CHECK_FALSE(window.has("more below told words"));
      CHECK_FALSE(window.has("more below told state"));
    }
  }
}

TEST_CASE("letters of a lecture grow with its strip, and code is never smaller than words", "[lecture][layout]") {
  double before = 0;
  for (const float strip : {130.0f, 239.0f, 340.0f, 420.0f}) {
    const LectureSizes sizes = lecture_sizes(strip);
    CHECK(sizes.words >= 15);
    CHECK(sizes.large >= 20);
    CHECK(sizes.large >= sizes.words);
    CHECK(sizes.words >= before);
    before = sizes.words;
  }
  CHECK(before > 21);
  const auto height_of_line = [](float width, float height) {
    WindowDriver window(lessons::all_lessons(), width, height, place_at("ray-sphere", "two-roots"), {}, layout_only);
    window.player().go_to(step_called(window.player(), "which-root"));
    window.key(key::tab);
    window.frames(2);
    return window.rect("line 10").height();
  };
  CHECK(height_of_line(1920, 1080) >= height_of_line(1280, 800) + 4);
  CHECK(height_of_line(2560, 1440) > height_of_line(1920, 1080));
}

TEST_CASE("a line breaks alike in a lecture whether it says yes or no, or nothing yet", "[lecture][layout]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("relations", "ball-overlapping"), {}, layout_only);
  REQUIRE(window.player().walk().steps[0].line == 0);
  REQUIRE(window.player().walk().steps[1].line == 0);
  window.key(key::tab);
  for (float width = 1200; width <= 1600; width += 25) {
    CAPTURE(width);
    window.resize(width, 800);
    std::vector<float> heights;
    for (const int step : {0, 1}) {
      window.player().go_to(step);
      window.frames(2);
      heights.push_back(window.rect("line 1").height());
    }
    CHECK(heights[0] == heights[1]);
  }
}

TEST_CASE("in a lecture all that is known at a question stands as large as values, each on one line", "[lecture]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("ray-sphere", "two-roots"));
  window.key(key::tab);
  int seen = 0;
  for (int i = 0; i + 1 < window.player().count(); ++i) {
    window.player().go_to(i);
    window.player().next();
    if (!window.player().quiz().asked() || window.player().quiz().wants_line()) continue;
    window.frames(2);
    for (const Value& known : window.player().shown().values) {
      INFO(window.ui.title() << ": " << known.name);
      const Rect r = window.rect("told value " + plain(known.name));
      CHECK((r.height() > 28 && r.height() < 50));
      ++seen;
    }
  }
  CHECK(seen > 3);
}

TEST_CASE("in a low lecture the button that shows the choices stands in the strip whole", "[lecture][layout]") {
  WindowDriver window({&number}, 800, 600, {}, {}, layout_only);
  window.player().go_to(1);
  window.key(key::tab);
  window.key(key::right);
  window.frames(2);
  REQUIRE(window.player().quiz().asks_more());
  CHECK(within(window.rect("show choices"), window.rect("told words")));
  CHECK(window.rect("answer").width() >= 100);
  window.click("show choices");
  CHECK_FALSE(window.player().quiz().asks_more());
}

TEST_CASE("beside a closing card a lecture tells what the card leaves out, and no line", "[lecture]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("ray-sphere", "two-roots"));
  window.player().last();
  window.key(key::tab);
  window.frames(2);
  REQUIRE(window.player().step().line >= 0);
  CHECK_FALSE(window.has("line " + std::to_string(window.player().step().line + 1)));
  CHECK_FALSE(window.has("more below told words"));
  for (const auto& [name, r] : window.ui.rects()) CHECK_FALSE(name.starts_with("told value "));
}

TEST_CASE("in a lecture a pointer that rests lights nothing until it moves or presses", "[lecture]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("ray-sphere", "two-roots"), {}, layout_only);
  window.player().go_to(step_called(window.player(), "which-root"));
  window.key(key::tab);
  window.frames(2);
  const auto lit = [&] {
    return std::ranges::any_of(window.ui.rects(), [](const auto& r) { return r.first.starts_with("lit "); });
  };
  std::string value;
  for (const auto& [name, r] : window.ui.rects())
    if (name.starts_with("told value ")) value = name;
  REQUIRE_FALSE(value.empty());
  const Rect r = window.rect(value);
  window.move(r.left + 14, r.middle_y());
  window.frames(20);
  REQUIRE(lit());
  window.wait(2.9f);
  CHECK(window.ui.rest() < 1);  // then it will be hidden
  window.wait(0.5f);
  window.frames(20);
  CHECK_FALSE(lit());
  CHECK(ImGui::GetMouseCursor() == ImGuiMouseCursor_None);
  ImGui::GetIO().MousePos = {r.left + 14, r.middle_y()};  // as a back end tells it in each frame
  window.frames(20);
  CHECK_FALSE(lit());
  window.move(r.left + 15, r.middle_y());
  window.frames(20);
  CHECK(lit());
  window.wait(4);
  window.frames(2);
  const int step = window.player().index();
  window.click("back");
  CHECK(window.player().index() != step);
  window.wait(4);
  window.frames(2);
  window.button(true);  // without a move
  window.button(false);
  CHECK(window.player().index() != step - 1);
}

}  // namespace lecture_test
