// The picture and the window while a question is open.

#include "viz/asking.h"
#include "viz/closing.h"

#include <algorithm>
#include <array>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/pixels.h"
#include "tests/viz/window_driver.h"
#include "viz/rich_text.h"

namespace asking_test {
using namespace isect;
using namespace isect::viz;

namespace {

Place at(const std::string& lesson, const std::string& preset, int step) {
  Place place;
  place.lesson = lesson, place.preset = preset, place.step = step;
  return place;
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

}  // namespace

TEST_CASE("a question lights what its own step is about, and tells no hit and no miss before its answer", "[player]") {
  int asked = 0, lit = 0;
  for (const Lesson* lesson : lessons::all_lessons())
    for (const Preset& p : lesson->presets) {
      const Walk walk = lesson->walk(p.parameters);
      for (std::size_t i = 1; i < walk.steps.size(); ++i) {
        const Step& step = walk.steps[i];
        if (!step.question) continue;
        INFO(lesson->id << " " << p.id << ", " << step.slug);
        ++asked;
        const Scene scene = question_scene(walk, static_cast<int>(i));
        CHECK(findings(scene) <= findings(walk.steps[i - 1].scene));
        if (step.question->over || step.scene.chart) continue;
        const auto wanted = std::ranges::count_if(step.scene.items, is_lit);
        CHECK(std::ranges::count_if(scene.items, is_lit) == wanted);
        lit += wanted > 0;
      }
    }
  CHECK(asked > 500);
  CHECK(lit > 100);
}

TEST_CASE("Right to a question about the next edge lights and names that edge", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("crossings", "inside", 2));
  const auto rules = [&] { return lit_lines(window.player().scene()); };
  int asked = 0;
  while (!window.player().at_end()) {
    const std::vector<Line> before = rules();
    const Picture picture = window.picture();
    window.key(key::right);
    if (!window.player().asked()) continue;
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
  REQUIRE(window.player().asked());
  REQUIRE(lit_lines(window.player().scene()).size() == 1);
  const Line side = lit_lines(window.player().scene())[0];
  CHECK(side.from.x() == 2);  // the right one, and not the left one of the step before
  CHECK(side.to.x() == 2);
}

TEST_CASE("with the panels hidden the question stands over the scene, and is answered there", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("ray-sphere", "two-roots", 4));
  window.key(key::tab);
  CHECK_FALSE(window.has("question over scene"));
  window.key(key::right);
  window.frames(2);
  REQUIRE(window.player().asked());
  REQUIRE(window.has("question over scene"));
  REQUIRE(window.has("choice 1"));
  const Rect card = window.rect("question over scene"), choice = window.rect("choice 1"), scene = window.rect("scene");
  CHECK((choice.top > card.top && choice.bottom < card.bottom && choice.left > card.left && choice.right < card.right));
  CHECK((card.left >= scene.left && card.bottom <= window.rect("transport").top && card.top >= scene.top));
  const Camera camera = window.player().camera().goal();
  const int right = window.player().asked()->answer;
  window.click("choice " + std::to_string(right));
  REQUIRE(window.player().answered());
  CHECK(window.player().answered()->right());
  CHECK(window.player().camera().goal().azimuth == camera.azimuth);  // the click did not reach the scene
  window.frames(2);
  REQUIRE(window.has("question over scene"));  // it says whether that was right
  REQUIRE(window.has("tripod"));
  CHECK(window.rect("question over scene").bottom <= window.rect("tripod").top);
}

TEST_CASE("what methods say waits for the outcome, and while a question is open", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("sphere-sphere", "touching", 2));
  REQUIRE(window.player().methods_differ());
  CHECK_FALSE(window.has("alarm"));
  window.player().go_to(outcome(window.player().walk()));
  window.frames(2);
  CHECK(window.has("alarm"));
  window.player().go_to(2);
  window.key(key::right);
  REQUIRE(window.player().asked());
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
  REQUIRE(window.player().asked());
  REQUIRE(window.player().step().line == 4);
  CHECK(ground() != marked);
  const Rect words = window.rect("lesson words");
  CHECK(window.rect("choice 1").top < words.top + 0.4f * words.height());  // nothing but the prompt stands above it
  window.player().answer(0);
  window.frames(2);
  CHECK(window.has("what came of it"));
}

TEST_CASE("the wall stands nowhere before it is asked where a line meets it", "[asking]") {
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
  REQUIRE(window.player().asked());
  window.frames(2);
  CHECK(window.ui.title() == "Ray and sphere, preset 1, step 5 of 13 – isect");
  CHECK(window.rect("preset 2").left == chip.left);  // nothing moves
  for (const Preset* preset : window.player().group())
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
  for (int i = 0; i < 9 && !window.player().asked(); ++i) window.wait(0.5f);
  REQUIRE(window.player().asked());
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
  for (int i = 0; i < 200 && window.player().playing(); ++i) {
    window.wait(0.5f);
    CHECK_FALSE(window.player().asked());
  }
  CHECK(window.player().at_end());

  Settings kept;
  kept.nonstop = true;
  WindowDriver again(lessons::all_lessons(), 1280, 800, {}, kept);
  CHECK_FALSE(again.player().stops_at_questions());
  again.click("pass questions");
  CHECK(again.player().stops_at_questions());
  CHECK_FALSE(again.ui.settings().nonstop);
}

TEST_CASE("the t-axis of a question's picture marks no t that its own step finds", "[asking]") {
  int kept_back = 0;
  for (const Lesson* lesson : isect::lessons::all_lessons())
    for (const Preset& preset : lesson->presets) {
      const Walk walk = lesson->walk(preset.parameters);
      for (std::size_t k = 1; k < walk.steps.size(); ++k) {
        const Step& step = walk.steps[k];
        const std::optional<Axis>& before = walk.steps[k - 1].scene.axis;
        if (!step.question || step.question->over || !step.scene.axis || !before) continue;
        CAPTURE(lesson->id, preset.id, k + 1);
        const Scene asked = question_scene(walk, static_cast<int>(k));
        REQUIRE(asked.axis);
        CHECK(asked.axis->ticks.size() == before->ticks.size());
        CHECK(asked.axis->shared == before->shared);
        kept_back += step.scene.axis->ticks.size() > before->ticks.size() || step.scene.axis->shared != before->shared;
      }
    }
  CHECK(kept_back > 0);
}

TEST_CASE("what came of an answer is in sight, whatever stands above it", "[window]") {
  const auto [width, height] = GENERATE(table<float, float>({{1280, 800}, {800, 600}}));
  WindowDriver window(isect::lessons::all_lessons(), width, height, {}, {}, layout_only);
  int answered = 0;
  ask_all(window, isect::lessons::all_lessons(), [&](const Question&) {
    window.player().answer(0);
    window.frames(4);
    if (!window.player().answered()) return;
    ++answered;
    INFO(window.ui.title());
    const Rect told = window.rect("what came of it"), words = window.rect("lesson words");
    CHECK((told.top >= words.top && told.bottom <= words.bottom));
  });
  CHECK(answered > 40);
}

}  // namespace asking_test
