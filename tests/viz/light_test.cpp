// Where a name occurs, what is said about it, and how it is lit in the window: the same name is lit everywhere.

#include <set>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/window_driver.h"
#include "viz/chart/chart.h"
#include "viz/compose/halos.h"
#include "viz/text/names.h"
#include "viz/walk/closing.h"
#include "viz/walk/pseudocode.h"
#include "viz/window/measures.h"

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

/// The first step whose picture has this label beside a line.
int step_with_label(const Player& player, const std::string& markup) {
  const std::vector<Step>& steps = player.walk().steps;
  const auto found = std::ranges::find_if(steps, [&](const Step& step) {
    return std::ranges::any_of(step.scene.items, [&](const Item& item) {
      const Label* label = std::get_if<Label>(&item);
      return label && label->text == markup && label->until;
    });
  });
  if (found == steps.end()) throw std::runtime_error("no label " + markup);
  return static_cast<int>(found - steps.begin());
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

TEST_CASE("a lit name is near-black on the highlight, in every theme and in every part", "[window]") {
  Settings settings;
  settings.theme = GENERATE(ThemeName::dark, ThemeName::screen, ThemeName::print, ThemeName::grey);
  INFO(name_of(settings.theme));
  const Palette colours = palette(settings.theme);
  CHECK(contrast_ratio(colours.on_highlight, colours.highlight) >= 7);
  WindowDriver window(lessons::all_lessons(), 1280, 800, haines(), settings);
  window.player().go_to(step_with_label(window.player(), "*s*"));
  window.frames(2);
  const Rect row = window.rect("value s");
  window.move(row.middle_x(), row.middle_y());
  window.frames(4);
  const Picture picture = window.picture();
  const auto at = [&](int x, int y) {
    const std::uint8_t* p = &picture.rgba[4 * (static_cast<std::size_t>(y) * picture.width + x)];
    return Colour{p[0] / 255.0, p[1] / 255.0, p[2] / 255.0};
  };
  int seen = 0;
  for (int i = 1; i <= lit(window, "s"); ++i) {
    const Rect r = window.rect("lit s " + std::to_string(i)).inset(2);
    int bright = 0, all = 0;
    double most = 1;
    for (int y = static_cast<int>(r.top); y < static_cast<int>(r.bottom); ++y)
      for (int x = static_cast<int>(r.left); x < static_cast<int>(r.right); ++x) {
        ++all, bright += contrast_ratio(at(x, y), colours.highlight) < 1.05;
        most = std::max(most, contrast_ratio(at(x, y), colours.highlight));
      }
    if (bright < all / 3) continue;  // scrolled out of its part
    ++seen;
    INFO("place " << i);
    CHECK(most >= 5);  // thin strokes of small letters are smoothed
  }
  CHECK(seen >= 3);
}

TEST_CASE("a lit line has its number beside it, from the step or from a knob", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, haines());
  Player& player = window.player();
  player.go_to(step_with_label(player, "*s*"));
  const std::optional<Measure> s = measure_of(player, "s");
  REQUIRE(s);
  CHECK(s->name == "s");
  for (const Value& v : player.step().values)
    if (v.name == "*s*") CHECK(s->number == shown(v.value));
  REQUIRE(measure_of(player, "r"));
  CHECK_FALSE(measure_of(player, "zz"));
  CHECK(words_beside({"s", "4.472"}, "s") == "= 4.472");
  CHECK(words_beside({"m²", "21.15"}, "m") == "m² = 21.15");

  window.frames(2);
  CHECK_FALSE(window.has("measure s"));
  const Rect row = window.rect("value s"), scene = window.rect("scene");
  window.move(row.middle_x(), row.middle_y());
  window.frames(3);
  REQUIRE(window.has("measure s"));
  const Rect r = window.rect("measure s");
  CHECK((r.left >= scene.left && r.right <= scene.right && r.top >= scene.top && r.bottom <= scene.bottom));
}

TEST_CASE("the pointer at a marker of a chart is told its numbers", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, {}, {}, names_only);
  window.player().open(lesson_named(lessons::all_lessons(), "speed-against-error"));
  const std::vector<Step>& steps = window.player().walk().steps;
  const auto plot = std::ranges::find_if(
      steps, [](const Step& step) { return step.scene.chart && std::holds_alternative<Plot>(step.scene.chart->kind); });
  REQUIRE(plot != steps.end());
  window.player().go_to(static_cast<int>(plot - steps.begin()));
  window.frames(2);
  const Rect scene = window.rect("scene");
  bool found = false;
  for (float y = scene.bottom - 60; y > scene.top + 40 && !found; y -= 14)
    for (float x = scene.left + 20; x < scene.right - 20 && !found; x += 14) {
      window.move(x, y);
      found = window.has("chart marker");
    }
  REQUIRE(found);
  const Rect marker = window.rect("chart marker");
  CHECK(std::abs(marker.middle_x() - ImGui::GetIO().MousePos.x) <= 12);
  CHECK(std::abs(marker.middle_y() - ImGui::GetIO().MousePos.y) <= 12);
  window.move(scene.left + 2, scene.bottom - 2);
  CHECK_FALSE(window.has("chart marker"));
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
