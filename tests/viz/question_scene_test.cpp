// The picture and the window while a question is open.

#include "viz/walk/question_scene.h"
#include "viz/walk/closing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/lessons/answered.h"
#include "tests/viz/pixels.h"
#include "tests/viz/window_driver.h"
#include "viz/text/rich_text.h"
#include "viz/walk/branch.h"

namespace question_scene_test {
using namespace isect;
using namespace isect::viz;
namespace on_show = isect::tests::on_show;

namespace {

ReaderState at(const std::string& lesson, const std::string& preset, int step) {
  ReaderState state;
  state.lesson = lesson, state.preset = preset, state.step = step;
  return state;
}

bool is_lit(const Item& item) {
  return std::visit(
      [](const auto& it) {
        if constexpr (requires { it.pen; })
          return it.pen == Pen::highlight;
        else
          return false;
      },
      item);
}

std::vector<Line> lit_lines(const Scene& scene) {
  std::vector<Line> lines;
  for (const Item& item : scene.items)
    if (const Line* line = std::get_if<Line>(&item); line && is_lit(item)) lines.push_back(*line);
  return lines;
}

/// How many items are a hit or a miss.
std::ptrdiff_t findings(const Scene& scene) {
  return std::ranges::count_if(scene.items, [](const Item& item) {
    return std::visit(
        [](const auto& it) {
          if constexpr (requires { it.role; })
            return it.role == Role::hit || it.role == Role::miss;
          else
            return false;
        },
        item);
  });
}

/// Calls ask(walk, index) at each step with a question, of all lessons and presets. It is never the first step.
template <class Ask>
void at_each_question(const Ask& ask) {
  for (const Lesson* lesson : lessons::all_lessons())
    for (const Preset& preset : lesson->presets) {
      const Walk walk = lesson->walk(preset.parameters);
      for (int k = 0; k < static_cast<int>(walk.steps.size()); ++k) {
        const Step& step = walk.steps[static_cast<std::size_t>(k)];
        if (!step.question) continue;
        INFO(lesson->id << " " << preset.id << ", " << step.slug << ": " << plain(step.question->prompt));
        REQUIRE(k > 0);
        ask(walk, k);
      }
    }
}

const Step& step_of(const Walk& walk, int k) { return walk.steps[static_cast<std::size_t>(k)]; }

}  // namespace

TEST_CASE("a question lights what its own step is about, and tells no hit and no miss before its answer", "[player]") {
  int asked = 0, lit = 0;
  at_each_question([&](const Walk& walk, int k) {
    const Step& step = step_of(walk, k);
    ++asked;
    const Scene scene = question_scene(walk, k);
    CHECK(findings(scene) <= findings(step_of(walk, k - 1).scene));
    if (step.question->over || step.scene.chart) return;
    const auto wanted = std::ranges::count_if(step.scene.items, is_lit);
    CHECK(std::ranges::count_if(scene.items, is_lit) == wanted);
    lit += wanted > 0;
  });
  CHECK(asked > 500);
  CHECK(lit > 100);
}

TEST_CASE("while a question is open, all on show is of its own step, or was given with it", "[question_scene]") {
  int asked = 0, shown_values = 0;
  at_each_question([&](const Walk& walk, int k) {
    const Step &step = step_of(walk, k), &last = step_of(walk, k - 1);
    ++asked;
    const Step shown = asking_step(walk, k);
    CHECK((shown.title.empty() && shown.caption.empty() && shown.formula.empty()));
    CHECK(shown.line == -1);
    CHECK_FALSE(shown.comparison);
    for (const Value& value : shown.values) {
      INFO(value.name << " = " << value.value);
      ++shown_values;
      CHECK_FALSE(value.fresh);
      const auto is_it = [&](const Value& v) {
        return v.name == value.name && (v.value == value.value || std::isnan(value.value));
      };
      const bool given = std::ranges::any_of(step.question->given, is_it);
      CHECK((given || (std::ranges::any_of(step.values, is_it) && std::ranges::any_of(last.values, is_it))));
    }
    for (const int line : shown.refused) CHECK((line != step.line && std::ranges::count(step.refused, line) > 0));
    for (const int line : shown.untaken) CHECK((line != step.line && std::ranges::count(step.untaken, line) > 0));
    CHECK((shown.verdict.text.empty() || shown.verdict.text == step.verdict.text));
  });
  CHECK(asked >= 583);
  CHECK(shown_values > 500);
}

TEST_CASE("an answer that is a computed number follows from what is on show while its question is open",
          "[question_scene]") {
  int computed = 0;
  at_each_question([&](const Walk& walk, int k) {
    const Question& question = *step_of(walk, k).question;
    const std::optional<std::vector<double>> choices = on_show::numeric_choices(question);
    if (!choices || std::ranges::all_of(*choices, [](double x) { return x == std::round(x); })) return;
    std::string way;
    CHECK(on_show::answered(walk, k, &way) == on_show::How::by_numbers);
    CHECK_FALSE(way.empty());
    ++computed;
  });
  CHECK(computed > 60);
}

TEST_CASE("every question can be answered without its picture", "[question_scene]") {
  using on_show::How;
  std::map<std::string, int> answered;
  at_each_question([&](const Walk& walk, int k) {
    std::string way;
    const How how = on_show::answered(walk, k, &way);
    CHECK((how == How::by_numbers || how == How::in_words));
    ++answered[way];
  });
  for (const auto& [words, way] : on_show::ways_in_words()) {
    INFO(words);
    CHECK(answered[words] > 0);
  }
}

TEST_CASE("no number on show bears the name that is asked for", "[question_scene]") {
  int told_by_the_step = 0;
  at_each_question([&](const Walk& walk, int k) {
    const Step& step = step_of(walk, k);
    const std::string prompt = plain(step.question->prompt);
    const auto asks_for = [&](const Value& value) {
      const std::string name = plain(value.name);
      return prompt.find("What is " + name + "?") != prompt.npos ||
             prompt.find("What is the " + name + "?") != prompt.npos ||
             prompt.find("What is the discriminant " + name) != prompt.npos;
    };
    CHECK(std::ranges::none_of(asking_step(walk, k).values, asks_for));
    told_by_the_step += std::ranges::any_of(step.values, asks_for);
  });
  CHECK(told_by_the_step > 40);
}

TEST_CASE("the card never says the opposite of what the lit line does", "[branch]") {
  int refused = 0, entered = 0, alone = 0;
  for (const Lesson* lesson : lessons::all_lessons())
    for (const Preset& preset : lesson->presets) {
      const Walk walk = lesson->walk(preset.parameters);
      for (int k = 0; k + 1 < static_cast<int>(walk.steps.size()); ++k) {
        const Step &step = walk.steps[static_cast<std::size_t>(k)], &next = walk.steps[static_cast<std::size_t>(k) + 1];
        if (!step.comparison || step.line < 0) continue;
        const std::string line = walk.pseudocode[static_cast<std::size_t>(step.line)];
        if (!has_condition(line)) continue;
        INFO(lesson->id << " " << preset.id << ", " << step.slug << ": " << line << " | " << step.comparison->text);
        const auto refusals = [&](const Step& s) { return std::ranges::count(s.refused, step.line); };
        const bool enters =
            next.line == step.line + 1 && !line.empty() && line.back() != ':' &&
            walk.pseudocode[static_cast<std::size_t>(next.line)].find_first_not_of(' ') > line.find_first_not_of(' ');
        const bool does_all = line.find(": ") != line.npos && step.decides;  // "if ...: return ..."
        if (refusals(next) > refusals(step)) {
          ++refused;
          CHECK_FALSE(step.comparison->holds);
          CHECK(taken(walk, k) == false);
        } else if (enters || does_all) {
          enters ? ++entered : ++alone;
          CHECK(step.comparison->holds);
          CHECK(taken(walk, k) == true);
        }
      }
    }
  CHECK(refused > 60);
  CHECK(entered > 20);
  CHECK(alone > 20);
}

TEST_CASE("a condition that joins several inequalities holds as they do, each with its own numbers", "[branch]") {
  int joined = 0;
  for (const Lesson* lesson : lessons::all_lessons())
    for (const Preset& preset : lesson->presets)
      for (const Step& step : lesson->walk(preset.parameters).steps) {
        if (!step.comparison || step.comparison->parts.empty()) continue;
        INFO(lesson->id << " " << preset.id << ", " << step.slug << ": " << step.comparison->text);
        ++joined;
        const std::vector<Comparison>& parts = step.comparison->parts;
        for (const Comparison& part : parts) CHECK(step.comparison->text.find(part.text) != std::string::npos);
        const bool both = step.comparison->text.find(" or ") == std::string::npos;
        if (both)
          CHECK(step.comparison->holds == std::ranges::all_of(parts, &Comparison::holds));
        else if (parts.size() == 2)
          CHECK(step.comparison->holds == (parts[0].holds || parts[1].holds));
        else  // A or (B and C)
          CHECK(step.comparison->holds == (parts[0].holds || (parts[1].holds && parts[2].holds)));
      }
  CHECK(joined > 15);
}

TEST_CASE("the current line says yes where its condition is true, and the card shows each half", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("ray-sphere", "two-roots"));
  const auto& steps = window.player().walk().steps;
  const auto which = std::ranges::find(steps, "which-root", &Step::slug);
  REQUIRE(which != steps.end());
  window.player().go_to(static_cast<int>(which - steps.begin()));
  window.frames(2);
  CHECK(window.has("yes 10"));
  CHECK_FALSE(window.has("no 10"));
  REQUIRE(window.has("condition 3"));
  const Rect card = window.rect("comparison");
  CHECK(window.rect("condition 1").bottom <= window.rect("condition 2").top);
  CHECK((window.rect("condition 1").top > card.top && window.rect("condition 3").bottom < card.bottom));
}

TEST_CASE("a digit answers where it is an answer, and loads no preset while a question is open", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("crossings", "inside"));
  window.player().first();
  window.key(key::right);
  REQUIRE(window.player().quiz().asked());
  window.player().show_choices();
  const Question question = *window.player().quiz().asked();
  const std::string preset = window.player().played().preset_id();
  REQUIRE(window.player().played().group().size() > 1);
  const auto is_choice = [&](char c) {
    return std::ranges::any_of(question.choices, [&](const std::string& choice) { return plain(choice)[0] == c; });
  };
  for (char digit = '0'; digit <= '9'; ++digit)
    if (!is_choice(digit)) window.type(std::string(1, digit));
  REQUIRE(window.player().quiz().asked());
  CHECK(window.player().played().preset_id() == preset);
  const std::string right = plain(question.choices[static_cast<std::size_t>(question.answer)]);
  REQUIRE(right.size() == 1);
  window.type(right);
  REQUIRE(window.player().quiz().answered());
  CHECK(window.player().quiz().answered()->right());
  CHECK(window.player().played().preset_id() == preset);
  window.type("2");  // the question is over
  CHECK(window.player().played().preset_id() == window.player().played().group()[1]->id);
}

TEST_CASE("Right to a question about the next edge lights and names that edge", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("crossings", "inside", 2));
  const auto rules = [&] { return lit_lines(window.player().scene()); };
  int asked = 0;
  while (!window.player().at_end()) {
    const std::vector<Line> before = rules();
    const Picture picture = window.picture();
    window.key(key::right);
    if (!window.player().quiz().asked()) continue;
    const Step& next = window.player().walk().steps[static_cast<std::size_t>(window.player().index()) + 1];
    if (lit_lines(next.scene).empty()) continue;
    ++asked;
    REQUIRE(rules().size() == 1);
    CHECK(rules()[0].from == lit_lines(next.scene)[0].from);
    CHECK(rules()[0].to == lit_lines(next.scene)[0].to);
    if (!before.empty()) CHECK(rules()[0].from != before[0].from);
    for (const char* name : {"a", "b"})
      CHECK(std::ranges::any_of(window.player().scene().items, [&](const Item& item) {
        const Label* label = std::get_if<Label>(&item);
        return label && label->text.find(name) != std::string::npos && label->at != Vec3::Zero();
      }));
    CHECK(window.picture().rgba != picture.rgba);
  }
  CHECK(asked > 0);
}

TEST_CASE("clipping asks about a side that is drawn and lit", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("clipping", "both-ends-cut", 3));
  window.key(key::right);
  REQUIRE(window.player().quiz().asked());
  REQUIRE(lit_lines(window.player().scene()).size() == 1);
  const Line side = lit_lines(window.player().scene())[0];
  CHECK(side.from.x() == 2);  // the right one, and not the left one of the step before
  CHECK(side.to.x() == 2);
}

TEST_CASE("what methods say waits for the outcome, and while a question is open", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("sphere-sphere", "touching", 2));
  REQUIRE(window.player().played().methods_differ());
  CHECK_FALSE(window.has("alarm"));
  window.player().go_to(outcome(window.player().walk()));
  window.frames(2);
  CHECK(window.has("alarm"));
  window.player().go_to(2);
  window.key(key::right);
  REQUIRE(window.player().quiz().asked());
  window.frames(2);
  CHECK_FALSE(window.has("alarm"));
  CHECK_FALSE(window.has("methods side by side"));
  CHECK_FALSE(window.has("comparison"));
}

TEST_CASE("while a question is open the step before it is told no more, as the picture is of the next one",
          "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("crossings", "vertex-passed", 2));
  const auto ground = [&] {  // of the current line
    const Rect r = window.rect("line 5");
    const Picture picture = window.picture();
    const int x = static_cast<int>(r.left + 6), y = static_cast<int>(r.middle_y());
    return std::array{channel(picture, x, y, 0), channel(picture, x, y, 1), channel(picture, x, y, 2)};
  };
  const std::array<int, 3> marked = ground();
  window.key(key::right);
  window.frames(2);
  REQUIRE(window.player().quiz().asked());
  REQUIRE(window.player().step().line == 4);
  CHECK(ground() != marked);
  const Rect words = window.rect("lesson words");
  CHECK(window.rect("answer").top < words.top + 0.4f * words.height());  // nothing but the prompt stands above it
  window.player().answer(0);
  window.frames(2);
  CHECK(window.has("what came of it"));
}

TEST_CASE("the wall stands nowhere before it is asked where a line meets it", "[question_scene]") {
  const auto named = [](const Scene& scene, const char* name) {
    return std::ranges::any_of(scene.items, [&](const Item& item) {
      const Label* label = std::get_if<Label>(&item);
      return label && label->text == name;
    });
  };
  int asked = 0;
  const Lesson& rays = lesson_named(lessons::all_lessons(), "rays");
  for (const Preset& preset : rays.presets) {
    const Walk walk = rays.walk(preset.parameters);
    const auto wall = std::ranges::find(walk.steps, "wall", &Step::slug);
    if (wall == walk.steps.end()) continue;
    CAPTURE(preset.id);
    for (auto step = walk.steps.begin(); step != wall; ++step) CHECK_FALSE(named(step->scene, "wall"));
    const Scene question = question_scene(walk, static_cast<int>(wall - walk.steps.begin()));
    CHECK(named(question, "wall"));
    for (int t = -40; t <= 40; ++t) CHECK_FALSE(named(question, shown(t).c_str()));  // no mark of t stands at it
    ++asked;
  }
  CHECK(asked == 7);
}

TEST_CASE("presets are numbers while a question is open, as their names may tell its answer", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("ray-sphere", "two-roots", 4));
  const Rect chip = window.rect("preset 2");
  CHECK(window.ui.title().find("two roots") != std::string::npos);
  window.key(key::right);
  REQUIRE(window.player().quiz().asked());
  window.frames(2);
  CHECK(window.ui.title() == "Ray and sphere, preset 1, step 5 of 13 – isect");
  CHECK(window.rect("preset 2").left == chip.left);  // nothing moves
  for (const Preset* preset : window.player().played().group())
    CHECK(window.player().told_title(*preset).find(plain(preset->title)) == std::string::npos);
  window.player().answer(0);
  window.frames(2);
  CHECK(window.ui.title().find("two roots") != std::string::npos);
  CHECK(window.player().told_title(window.player().lesson().presets[0]) == "two roots");
}

TEST_CASE("two sides that read alike and differ are shown in full", "[window]") {
  const auto card = [](const char* preset) {
    WindowDriver window(lessons::all_lessons(), 1280, 800, at("ray-sphere", preset, 7));
    REQUIRE(window.player().step().slug == "which-root");
    REQUIRE(window.has("comparison"));
    return std::pair(window.has("meaning in full"), window.rect("comparison").height());
  };
  const auto [near_alike, near_height] = card("near-surface");
  const auto [far_alike, far_height] = card("two-roots");
  CHECK((near_alike && !far_alike));
  CHECK(near_height > far_height);
}

TEST_CASE("play rests at a question without taking time, and says so by its icon", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("ray-sphere", "two-roots", 2));
  CHECK(std::isinf(window.ui.rest()));
  window.type(" ");
  CHECK(window.ui.rest() > 1);  // until the next step
  CHECK(window.ui.rest() <= 1.6);
  for (int i = 0; i < 9 && !window.player().quiz().asked(); ++i) window.wait(0.5f);
  REQUIRE(window.player().quiz().asked());
  CHECK_FALSE(window.player().running());
  CHECK(std::isinf(window.ui.rest()));
  const int before = window.player().index();
  window.type(" ");  // the question is skipped, and play goes on
  CHECK(window.player().index() == before + 1);
  CHECK(window.player().running());
}

TEST_CASE("N and a button let play pass over questions, and that is kept", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("ray-sphere", "two-roots", 2));
  window.type("n");
  CHECK(window.ui.message() == "Play passes over questions now");
  CHECK(window.ui.settings().nonstop);
  window.type(" ");
  for (int i = 0; i < 200 && window.player().clock().playing(); ++i) {
    window.wait(0.5f);
    CHECK_FALSE(window.player().quiz().asked());
  }
  CHECK(window.player().at_end());

  Settings kept;
  kept.nonstop = true;
  WindowDriver again(lessons::all_lessons(), 1280, 800, {}, kept);
  CHECK_FALSE(again.player().clock().stops_at_questions());
  again.click("pass questions");
  CHECK(again.player().clock().stops_at_questions());
  CHECK_FALSE(again.ui.settings().nonstop);
}

TEST_CASE("the t-axis of a question's picture marks no t that its own step finds", "[question_scene]") {
  int kept_back = 0;
  at_each_question([&](const Walk& walk, int k) {
    const Step& step = step_of(walk, k);
    const std::optional<Axis>& before = step_of(walk, k - 1).scene.axis;
    if (step.question->over || !step.scene.axis || !before) return;
    const Scene asked = question_scene(walk, k);
    REQUIRE(asked.axis);
    CHECK(asked.axis->ticks.size() == before->ticks.size());
    CHECK(asked.axis->shared == before->shared);
    kept_back += step.scene.axis->ticks.size() > before->ticks.size() || step.scene.axis->shared != before->shared;
  });
  CHECK(kept_back > 0);
}

TEST_CASE("what came of an answer is in sight, whatever stands above it", "[window]") {
  const auto [width, height] = GENERATE(table<float, float>({{1280, 800}, {800, 600}}));
  WindowDriver window(isect::lessons::all_lessons(), width, height, {}, {}, layout_only);
  int answered = 0;
  ask_all(window, isect::lessons::all_lessons(), [&](const Question&) {
    window.player().answer(0);
    window.frames(4);
    if (!window.player().quiz().answered()) return;
    ++answered;
    INFO(window.ui.title());
    const Rect told = window.rect("what came of it"), words = window.rect("lesson words");
    CHECK((told.top >= words.top && told.bottom <= words.bottom));
  });
  CHECK(answered > 40);
}

}  // namespace question_scene_test
