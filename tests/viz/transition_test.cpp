// From step to step.

#include "viz/player/transition.h"

#include <chrono>
#include <thread>
#include <utility>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/window_driver.h"
#include "viz/compose/halos.h"

namespace transition_test {
using namespace isect;
using namespace isect::viz;

namespace {

Scene with(const Vec3& a, const Vec3& b, double radius) {
  Scene scene;
  scene.items = {Dot{a}, Label{a, "a"}, Ball{b, radius}, Label{b, "b"}};
  return scene;
}

ReaderState sides() {
  ReaderState state;
  state.lesson = "clipping", state.preset = "both-ends-cut", state.step = 3;
  return state;
}

WindowOptions reduced(bool on) { return {.reduced_motion = on}; }

}  // namespace

TEST_CASE("what has the same name is on its way from one place to the other", "[transition]") {
  const Scene from = with({0, 0, 0}, {1, 1, 1}, 1), to = with({4, 0, 0}, {1, 1, 1}, 3);
  const Scene half = between(from, to, 0.5);
  CHECK(std::get<Dot>(half.items[0]).at == Vec3(2, 0, 0));
  CHECK(std::get<Label>(half.items[1]).at == Vec3(2, 0, 0));
  CHECK(std::get<Ball>(half.items[2]).radius == 2);
  CHECK(std::get<Dot>(between(from, to, 0).items[0]).at == Vec3(0, 0, 0));
  CHECK(std::get<Dot>(between(from, to, 1).items[0]).at == Vec3(4, 0, 0));
}

TEST_CASE("what is new, gone or of another shape does not move", "[transition]") {
  Scene from = with({0, 0, 0}, {1, 1, 1}, 1), to = with({4, 0, 0}, {1, 1, 1}, 1);
  from.items[0] = Chain{{Vec3(0, 0, 0), Vec3(1, 0, 0)}};
  to.items.emplace_back(Chain{{Vec3(5, 0, 0), Vec3(6, 0, 0), Vec3(7, 0, 0)}});
  const Scene half = between(from, to, 0.5);
  REQUIRE(half.items.size() == to.items.size());
  CHECK(std::get<Dot>(half.items[0]).at == Vec3(4, 0, 0));
  CHECK(std::get<Chain>(half.items[4]).points[0] == Vec3(5, 0, 0));
}

TEST_CASE("a page of small drawings stands at once", "[transition]") {
  const Scene from = with({0, 0, 0}, {1, 1, 1}, 1);
  Scene to = with({4, 0, 0}, {1, 1, 1}, 1);
  CHECK(may_move(from, to));
  to.items.emplace_back(Heading{{0, 2, 0}, "one of many"});
  CHECK_FALSE(may_move(from, to));
  CHECK_FALSE(may_move(to, from));
  CHECK(std::get<Dot>(between(from, to, 0.25).items[0]).at == Vec3(4, 0, 0));
}

TEST_CASE("a step takes 220 ms, its light 120, and then all is at rest", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, sides(), {}, reduced(false));
  window.wait(1);
  CHECK(std::isinf(window.ui.rest()));
  window.key(key::left);
  const auto at_start = window.picture().rgba;
  CHECK(window.player().motion().share() < 1);
  CHECK(window.player().motion().light() < 1);
  CHECK(window.ui.rest() == 0);
  window.wait(0.11f);
  CHECK(window.player().motion().light() == 1);
  CHECK(window.player().motion().share() < 1);
  const auto on_the_way = window.picture().rgba;
  window.wait(0.12f);
  CHECK(window.player().motion().share() == 1);
  CHECK(std::isinf(window.ui.rest()));
  CHECK(window.picture().rgba != on_the_way);
  CHECK(at_start != on_the_way);
}

TEST_CASE("the current line can be read while its light comes on", "[window]") {
  Settings settings;
  settings.theme = GENERATE(ThemeName::dark, ThemeName::screen, ThemeName::grey);
  WindowDriver window(lessons::all_lessons(), 1280, 800, sides(), settings, reduced(false));
  window.wait(1);
  window.key(key::left);
  int frames = 0;
  for (; window.player().motion().light() < 1; window.frames(), ++frames) {
    const Rect line = window.rect("line " + std::to_string(window.player().step().line + 1));
    const Picture picture = window.picture();
    const auto at = [&](float x, float y) {
      const std::uint8_t* p =
          &picture.rgba[4 * (static_cast<std::size_t>(y) * picture.width + static_cast<std::size_t>(x))];
      return Colour{p[0] / 255.0, p[1] / 255.0, p[2] / 255.0};
    };
    const Colour ground = at(line.right - 6, line.middle_y());
    double most = 1;
    for (float y = line.top + 2; y < line.bottom - 2; ++y)
      for (float x = line.left + 30; x < line.right - 40; ++x) most = std::max(most, contrast_ratio(at(x, y), ground));
    INFO("light " << window.player().motion().light());
    CHECK(most > 3.5);
  }
  CHECK(frames > 1);
}

namespace {

/// A lesson of one step, then a map of cases whose branches are counted as they are asked for.
struct Mapped {
  Mapped() {
    lesson.id = lesson.title = "mapped";
    lesson.presets = {{"all", "all", "", {}}};
    lesson.map = &map;
    lesson.steps = [](const Parameters&) {
      Walk walk;
      walk.steps.resize(1);
      walk.steps[0].slug = walk.steps[0].title = "ball", walk.steps[0].scene.items = {Ball{{0, 0, 0}, 1}};
      return walk;
    };
    asked = 0;
  }

  static int branch(const Parameters&) {
    ++asked;
    if (slow) std::this_thread::sleep_for(std::chrono::microseconds(60));
    return 0;
  }
  static Vec2 place(const Parameters&) { return Vec2::Zero(); }
  static Parameters moved(const Parameters& p, const Vec2&) { return p; }

  static constexpr int of_a_walk = 30;  ///< at most as many are asked for without the map, and for a walk or two
  static inline int asked = 0;
  static inline bool slow = false;
  CaseMap map = {"x", "y", {-1, -1}, {1, 1}, {"everywhere"}, branch, place, moved};
  Lesson lesson;
};

}  // namespace

TEST_CASE("a map is swept before its step comes, not while the scene is turned", "[window]") {
  const Mapped mapped;
  const std::vector<const Lesson*> lessons = {&mapped.lesson};
  WindowDriver window(lessons, 1280, 800, {}, {}, {.reduced_motion = false});
  window.frames(60);
  REQUIRE(window.ui.rest() > 0);
  const int once = Mapped::asked;
  CHECK(once > 10 * Mapped::of_a_walk);
  window.player().go_to(1);
  window.frames(10);
  CHECK(Mapped::asked == once);

  window.player().restart();  // another walk
  const Rect scene = window.rect("scene");
  window.move(scene.middle_x() + 200, scene.middle_y() + 200);
  window.button(true);
  Mapped::asked = 0;
  window.player().restart();
  for (int i = 0; i < 20; ++i) window.move(scene.middle_x() + 200 - static_cast<float>(i), scene.middle_y() + 200);
  CHECK(Mapped::asked <= Mapped::of_a_walk);
  window.button(false);
  window.frames(30);
  CHECK(Mapped::asked > 10 * Mapped::of_a_walk);
}

TEST_CASE("a map that takes long is swept a little in each frame, and no rest comes before it is there", "[window]") {
  const Mapped mapped;
  const std::vector<const Lesson*> lessons = {&mapped.lesson};
  WindowDriver window(lessons, 1280, 800, {}, {}, {.reduced_motion = true});
  window.frames(60);
  const int whole = std::exchange(Mapped::asked, 0);

  Mapped::slow = true;
  window.player().restart();
  constexpr int of_a_level = 61;
  int frames = 0;
  do {
    const int before = Mapped::asked;
    window.frames();
    CHECK(Mapped::asked <= before + of_a_level);
    ++frames;
  } while (window.ui.rest() == 0 && frames < 1000);
  Mapped::slow = false;
  CHECK(frames > 20);
  const int asked = Mapped::asked;
  CHECK(asked > whole / 2);
  window.player().go_to(1);
  window.frames(10);
  CHECK(Mapped::asked == asked);
}

TEST_CASE("under reduced motion nothing moves by itself", "[window]") {
  WindowDriver still(lessons::all_lessons(), 1280, 800, sides(), {}, reduced(true));
  still.key(key::left);
  CHECK(still.player().motion().share() == 1);
  CHECK(still.player().motion().light() == 1);
  CHECK(std::isinf(still.ui.rest()));
}

TEST_CASE("M asks for reduced motion", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, sides(), {}, reduced(false));
  window.type("m");
  CHECK(window.ui.settings().reduced_motion);
  window.wait(6);  // until the message has gone
  window.key(key::left);
  CHECK(std::isinf(window.ui.rest()));
  window.type("f");
  CHECK_FALSE(window.player().camera().moving());
}

TEST_CASE("a drag is no motion: the scene follows at once", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, sides(), {}, reduced(false));
  window.wait(1);
  window.drag("handle p", 20, -10);
  CHECK(window.player().motion().share() == 1);
}

TEST_CASE("many new texts come in several frames, and all is there before the window rests", "[window]") {
  const auto closing = [](double texts_a_frame, int& frames) {
    WindowOptions options = {.reduced_motion = true};
    options.texts_a_frame = texts_a_frame;
    WindowDriver window(isect::lessons::all_lessons(), 1280, 800, place_at("crossings", "vertex-passed"), {}, options);
    window.frames(20);
    window.key(key::end);
    for (frames = 0; window.ui.rest() == 0 && frames < 100; ++frames) window.frames();
    window.frames(3);
    return window.picture();
  };
  int at_once = 0, in_turn = 0;
  const Picture all = closing(HUGE_VAL, at_once), same = closing(5000, in_turn);
  CHECK(in_turn >= at_once + 3);
  CHECK(in_turn < 100);
  CHECK(all.rgba == same.rgba);
}

}  // namespace transition_test
