// Where a name occurs, what is said about it, and how it is lit in the window: the same name is lit everywhere.

#include <set>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/window_driver.h"
#include "viz/text/names.h"
#include "viz/walk/closing.h"
#include "viz/walk/pseudocode.h"

namespace light_test {
using namespace isect;
using namespace isect::viz;
using isect::test::Contains;

namespace {

std::vector<std::string> named(const std::string& markup) { return keys(names_in(markup)); }
using Keys = std::vector<std::string>;

ReaderState haines() {
  ReaderState state;
  state.lesson = "ray-sphere", state.preset = "two-roots";
  return state;
}

/// The number of places that are lit for a name.
int lit(const WindowDriver& window, const std::string& key) {
  int count = 0;
  while (window.has("lit " + key + " " + std::to_string(count + 1))) ++count;
  return count;
}

/// Moves the pointer over an area, row by row, until a name is lit.
bool find_name(WindowDriver& window, const Rect& area, const std::string& key) {
  for (float y = area.top + 4; y < area.bottom; y += 6)
    for (float x = area.left + 2; x < area.right; x += 5) {
      window.move(x, y);
      window.frames();
      if (lit(window, key) > 0) return true;
    }
  return false;
}

/// The parts of the window in which a name is lit.
std::set<std::string> parts(const WindowDriver& window, const std::string& key) {
  std::set<std::string> all;
  for (int i = 1; i <= lit(window, key); ++i) {
    const Rect r = window.rect("lit " + key + " " + std::to_string(i));
    for (const char* part : {"lesson panel", "scene", "code lines", "values"})
      if (window.rect(part).contains(r.middle_x(), r.middle_y())) all.insert(part);
  }
  return all;
}

}  // namespace

TEST_CASE("names are letters in italic or bold with their subscript, in whatever face", "[names]") {
  CHECK(named("The length *l* of **l** is *m*^2 + *t*_{max}") == Keys{"l", "m", "t_max"});
  CHECK(named("*t*_1 and *t*_{1,2}, *q*_{ij}") == Keys{"t_1", "t_1,2", "q_ij"});
  CHECK(named("An **if** instead of *Intersection Detection*, r") == Keys{});
  CHECK(keys(names_in_line("    t₁ ← (−B − √D) / 2A; q_ij ← |a_i · b_j|")) ==
        Keys{"t_1", "B", "D", "A", "q_ij", "a_i", "b_j"});
  CHECK(keys(names_in_line("if p on a horizontal a b: return ON", {"p", "a", "b"})) == Keys{"p", "a", "b"});
  const std::string text = "m² ← l² − s²";
  const std::vector<Name> names = names_in_line(text);
  REQUIRE(names.size() == 3);
  CHECK(text.substr(names[2].begin, names[2].end - names[2].begin) == "s");
}

TEST_CASE("what is told of a name is how it is computed and its number, or its knob", "[names]") {
  const auto lessons = lessons::all_lessons();
  const Lesson& lesson = lesson_named(lessons, "ray-sphere");
  const Parameters& setting = preset(lesson, "two-roots").parameters;
  const Walk walk = lesson.walk(setting);
  const auto sum = [&](const std::string& slug, const std::string& key) {
    const auto step = std::ranges::find(walk.steps, slug, &Step::slug);
    return sum_of(lesson, setting, walk, static_cast<int>(step - walk.steps.begin()), key);
  };
  const Step& last = walk.steps[static_cast<std::size_t>(outcome(walk))];
  for (const Value& v : last.values)
    if (v.name == "*s*") CHECK_THAT(sum(last.slug, "s"), Contains("s = l · d = " + shown(v.value)));
  CHECK_THAT(sum(walk.steps.front().slug, "s"), Contains("s = l · d"));  // not known yet
  CHECK_THAT(sum(walk.steps.front().slug, "r"), Contains("Radius of the ball"));
  CHECK(sum(last.slug, "zz").empty());
}

TEST_CASE("the pointer on a value lights its name in text, code, values and scene, and tells its sum", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, haines());
  window.player().last();
  window.player().go_to(outcome(window.player().walk()));
  window.frames(2);
  CHECK(lit(window, "s") == 0);
  const Rect row = window.rect("value s");
  window.move(row.middle_x(), row.middle_y());
  window.frames(2);
  CHECK_THAT(window.ui.sum(), Contains("s = l · d = "));
  CHECK(window.has("sum"));
  CHECK(parts(window, "s").contains("values"));
  CHECK(parts(window, "s").contains("code lines"));
  window.move(1, 1);
  window.frames(2);
  CHECK(lit(window, "s") == 0);
  CHECK_FALSE(window.has("sum"));
}

TEST_CASE("a name in the text, in the code or in the picture lights all others", "[window]") {
  const std::string from = GENERATE("lesson words", "code lines", "scene");
  INFO(from);
  WindowDriver window(lessons::all_lessons(), 1280, 800, haines());
  const std::vector<Step>& steps = window.player().walk().steps;
  const auto named_everywhere = std::ranges::find_if(steps, [](const Step& step) {
    const bool drawn = std::ranges::any_of(step.scene.items, [](const Item& item) {
      const Label* label = std::get_if<Label>(&item);
      return label && label->text == "*s*";
    });
    return drawn && !step.formula.empty() && keys(names_in(step.formula)).front() == "s";
  });
  REQUIRE(named_everywhere != steps.end());
  window.player().go_to(static_cast<int>(named_everywhere - steps.begin()));
  window.frames(2);
  REQUIRE(find_name(window, window.rect(from), "s"));
  CHECK(parts(window, "s") == std::set<std::string>{"lesson panel", "scene", "code lines", "values"});
  CHECK(window.has("lit object 1"));
}

TEST_CASE("what the keyboard holds is lit, too: a line, a value, a comparison, a handle", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, haines());
  window.player().go_to(outcome(window.player().walk()));
  window.frames(2);
  const auto hold = [&](const std::string& name) {
    for (int i = 0; i < 200 && window.ui.focus() != name; ++i) window.key(key::down);
    REQUIRE(window.ui.focus() == name);
    window.frames(2);
  };
  hold("handle center");
  CHECK(lit(window, "c") > 1);
  CHECK_THAT(window.ui.sum(), Contains("Centre of the ball"));
  hold("line 2");
  CHECK(lit(window, "s") > 1);
  hold("value s");
  CHECK_THAT(window.ui.sum(), Contains("s = l · d"));
  window.key(key::escape);
  window.frames(2);
  CHECK(lit(window, "s") == 0);
}

TEST_CASE("a light comes up within 120 ms, at once without motion, and then all rests", "[window]") {
  const bool reduced = GENERATE(false, true);
  WindowDriver window(lessons::all_lessons(), 1280, 800, haines(), {}, {.reduced_motion = reduced});
  window.player().go_to(outcome(window.player().walk()));
  window.wait(1);
  window.wait(1);
  const Rect row = window.rect("value s");
  ImGui::GetIO().MousePos = {row.middle_x(), row.middle_y()};
  window.wait(0.03f);
  CHECK(window.ui.rest() == 0);
  window.wait(0.03f);
  CHECK((window.ui.rest() > 0) == reduced);
  window.wait(0.2f);
  window.wait(0.01f);
  CHECK(window.ui.rest() > 0);
}

}  // namespace light_test
