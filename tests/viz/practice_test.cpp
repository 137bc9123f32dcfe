// What a reader does in the window with a whole lesson: keeps a step under the hand, tries exercises, sees a line fail.

#include "viz/player/practice.h"
#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/window_driver.h"
#include "viz/chart/case_map.h"
#include "viz/player/reader_state.h"
#include "viz/walk/closing.h"

namespace practice_test {
using namespace isect;
using namespace isect::viz;

namespace {

const Lesson& spheres() { return lesson_named(lessons::all_lessons(), "sphere-sphere"); }

ReaderState at(const std::string& preset) {
  ReaderState state;
  state.lesson = "sphere-sphere", state.preset = preset;
  return state;
}

/// The least distance from a point to a segment.
double distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double t = d.squaredNorm() > 0 ? std::clamp(d.dot(p - a) / d.squaredNorm(), 0.0, 1.0) : 0;
  return (a + t * d - p).norm();
}
/// Whether a point is at what the item shows: on a line, in a ball, or in a box a little wider than the shape.
struct Shows {
  const Vec3& p;
  double near;
  bool operator()(const Dot& it) const { return (it.at - p).norm() <= near; }
  bool operator()(const Label& it) const { return (it.at - p).norm() <= near; }
  bool operator()(const Heading&) const { return false; }
  bool operator()(const RightAngle& it) const { return (it.at - p).norm() <= near; }
  bool operator()(const Raster&) const { return false; }
  bool operator()(const Ball& it) const { return (it.center - p).norm() <= it.radius + near; }
  bool operator()(const Circle& it) const { return (it.center - p).norm() <= it.radius + near; }
  bool operator()(const Chain& it) const { return within(it.points); }
  bool operator()(const Region& it) const {
    return std::ranges::any_of(it.rings, [&](const auto& ring) { return within(ring); });
  }
  bool operator()(const Solid& it) const { return within(it.vertices); }
  bool operator()(const Mesh& it) const { return within(it.vertices); }
  bool operator()(const auto& line) const { return distance(p, line.from, line.to) <= near; }
  bool within(const std::vector<Vec3>& vertices) const {
    Vec3 lo = Vec3::Constant(1e300), hi = -lo;
    for (const Vec3& v : vertices) lo = lo.cwiseMin(v), hi = hi.cwiseMax(v);
    const double wider = near + 0.1 * (hi - lo).maxCoeff();
    return (p.array() >= lo.array() - wider).all() && (p.array() <= hi.array() + wider).all();
  }
};
bool stands_on(const Item& item, const Vec3& p) { return std::visit(Shows{p, 1e-6 * (1 + p.norm())}, item); }

/// Solves the first exercise.
void find_it(Player& player) {
  for (const auto& [name, text] : spheres().closing->exercises.front().by) {
    Parameters setting = player.parameters();
    set(spheres(), setting, name, text);
    player.edit(name, setting.at(name));
  }
}

}  // namespace

TEST_CASE("an outcome stays the outcome, whatever setting is dragged", "[player]") {
  for (const Lesson* lesson : lessons::all_lessons()) {
    ReaderState state;
    state.lesson = lesson->id;
    Player player({lesson}, state);
    player.go_to(outcome(player.walk()));
    for (const Preset& p : lesson->presets) {
      INFO(lesson->id << " " << p.id);
      for (const auto& [name, value] : p.parameters) {
        try {
          player.edit(name, value);
        } catch (const BadInput&) {  // some are in order only together
          continue;
        }
        CHECK(player.index() == outcome(player.walk()));
      }
    }
  }
}

TEST_CASE("a step keeps its name when the setting changes, and a map that is left gives way to the outcome",
          "[player]") {
  Player player({&spheres()}, at("overlapping"));
  const auto step_named = [&](const std::string& slug) {
    return static_cast<int>(std::ranges::find(player.walk().steps, slug, &Step::slug) - player.walk().steps.begin());
  };
  player.go_to(step_named("compare"));
  player.edit("r_b", 0.01);
  CHECK(player.step().slug == "compare");
  player.go_to(step_named(case_map_slug));
  player.edit("r_b", 1e5);  // beyond the map
  CHECK(player.index() == outcome(player.walk()));
  player.edit("r_b", 1.0);
  CHECK(player.step().slug == case_map_slug);
}

TEST_CASE("a handle stands on what is drawn", "[player]") {
  for (const Lesson* lesson : lessons::all_lessons())
    for (const Preset& p : lesson->presets)
      for (const Step& step : lesson->walk(p.parameters).steps)
        for (const Handle& handle : step.scene.handles) {
          INFO(lesson->id << " " << p.id << ", " << step.slug << ": " << handle.parameter);
          CHECK(std::ranges::any_of(step.scene.items, [&](const Item& item) { return stands_on(item, handle.at); }));
        }
}

TEST_CASE("a handle that is dragged back to where it was taken leaves the preset as it was", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, {}, {}, names_only);
  int dragged = 0;
  for (const Lesson* lesson : lessons::all_lessons()) {
    window.player().open(*lesson);
    window.frames(2);
    const std::string preset = window.player().played().preset_id();
    const std::vector<Handle> handles = window.player().scene().handles;
    for (const Handle& handle : handles) {
      INFO(lesson->id << ": " << handle.parameter);
      const Rect grip = window.rect("handle " + handle.id());
      const float x = grip.middle_x() + 3, y = grip.middle_y() - 2;
      window.move(x, y);
      window.button(true);
      window.move(x + 37, y + 23);
      window.move(x, y);
      window.button(false);
      CHECK(window.player().played().preset_id() == preset);
      ++dragged;
    }
  }
  CHECK(dragged > 60);
}

TEST_CASE("what to remember is no scene: no drag over it and no wheel moves the one before", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("rays", "ray"));
  window.key(key::end);
  REQUIRE(window.player().scene().chart);
  const Camera before = window.player().camera().goal();
  const Rect scene = window.rect("scene");
  window.move(scene.middle_x(), scene.middle_y());
  window.button(true);
  window.move(scene.middle_x() + 100, scene.middle_y() + 140);
  window.button(false);
  ImGui::GetIO().MouseWheel = 3;
  window.frames(2);
  const Camera after = window.player().camera().goal();
  CHECK((after.target == before.target && after.half_height == before.half_height && after.azimuth == before.azimuth));
}

TEST_CASE("every handle is at least 24 px wide, and has its name beside it", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, {}, {}, names_only);
  for (const Lesson* lesson : lessons::all_lessons()) {
    window.player().open(*lesson);
    window.frames(2);
    for (const Handle& h : window.player().scene().handles) {
      INFO(lesson->id << ": " << h.parameter);
      const Rect grip = window.rect("handle " + h.id());
      CHECK((grip.width() >= 24 && grip.height() >= 24));
      if (!h.one_of.empty()) continue;  // named where the pointer is
      double least = 1e9;
      for (const PlacedLabel& label : window.ui.labels()) {
        const double x =
            std::clamp<double>(grip.middle_x() - window.rect("scene").left, label.box.left, label.box.right);
        const double y =
            std::clamp<double>(grip.middle_y() - window.rect("scene").top, label.box.top, label.box.bottom);
        least = std::min(least, std::hypot(x + window.rect("scene").left - grip.middle_x(),
                                           y + window.rect("scene").top - grip.middle_y()));
      }
      CHECK(least < 110);
    }
  }
}

TEST_CASE("what a step has not changed is not marked as new", "[player]") {
  for (const Lesson* lesson : lessons::all_lessons())
    for (const Preset& p : lesson->presets) {
      const Walk walk = lesson->walk(p.parameters);
      for (std::size_t i = 1; i < walk.steps.size(); ++i)
        for (const Value& now : walk.steps[i].values)
          for (const Value& before : walk.steps[i - 1].values) {
            INFO(lesson->id << " " << p.id << ", " << walk.steps[i].slug << ": " << now.name);
            CHECK_FALSE((now.fresh && now.name == before.name && now.value == before.value));
          }
    }
}

TEST_CASE("only what was done is counted, and from the step that did it", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("overlapping"));
  CHECK(window.player().step().counters.mul == 0);  // a difference of two centres multiplies nothing
  CHECK(window.player().step().counters.add == 3);
  CHECK(window.has("count add"));
  for (const char* name : {"count mul", "count div", "count sqrt", "count cmp"}) CHECK_FALSE(window.has(name));
  window.key(key::right);
  CHECK(window.player().step().counters.mul == 3);
  CHECK(window.has("count mul"));
}

TEST_CASE("the current line says no as soon as its condition is found false", "[window]") {
  ReaderState state;
  state.lesson = "ray-sphere", state.preset = "two-roots", state.step = 3;
  WindowDriver window(lessons::all_lessons(), 1280, 800, state);
  REQUIRE(window.player().step().slug == "early-reject");
  REQUIRE_FALSE(window.player().step().comparison->holds);
  CHECK(window.has("no 4"));
  window.player().back();
  window.frames(2);
  CHECK_FALSE(window.has("no 4"));
}

TEST_CASE("an exercise is tried from its own preset, and found when the core says so", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 1400, at("inside"));
  window.key(key::end);
  window.frames(2);
  REQUIRE(window.player().step().slug == closing_slug);
  window.click("solution 2");
  window.click("try 1");
  window.frames(2);
  CHECK(window.player().played().preset_id() == "overlapping");
  CHECK(window.player().index() == outcome(window.player().walk()));
  REQUIRE(window.has("exercise"));
  CHECK_FALSE(exercise_solved(window.player()));
  CHECK(window.ui.settings().scores.at("sphere-sphere").solved.empty());
  find_it(window.ui.player());
  window.frames(2);
  CHECK(exercise_solved(window.player()));
  CHECK(window.player().step().verdict.kind == Verdict::Kind::on);
  window.click("end exercise");
  window.frames(2);
  CHECK(window.player().step().slug == closing_slug);
  CHECK_FALSE(window.has("exercise"));
  CHECK(window.ui.settings().scores.at("sphere-sphere").solved ==
        std::set<std::string>{spheres().closing->exercises.front().prompt});
  CHECK((window.has("solved 1") && !window.has("solved 2")));
}

TEST_CASE("a program with a wrong line is shown, and its correction when a setting is found or asked for", "[window]") {
  const auto& exercises = lesson_named(lessons::all_lessons(), "intervals").closing->exercises;
  const auto wrong = std::ranges::find_if(exercises, [](const Exercise& e) { return !e.program.empty(); });
  REQUIRE(wrong != exercises.end());
  const std::string number = std::to_string(wrong - exercises.begin() + 1);
  ReaderState state;
  state.lesson = "intervals", state.preset = "empty";
  WindowDriver window(lessons::all_lessons(), 1280, 2400, state);
  window.key(key::end);
  window.frames(2);
  REQUIRE(window.has("program"));
  const float below = window.rect("solution " + number).bottom;
  CHECK(window.rect("program").bottom <= window.rect("try " + number).top);
  window.click("solution " + number);  // what follows makes room for it
  window.click("solution " + number);
  window.frames(2);
  CHECK(window.rect("solution " + number).bottom == below);

  window.click("try " + number);
  window.frames(2);
  CHECK(window.player().played().preset_id() == wrong->preset);
  REQUIRE(window.has("program"));
  CHECK_FALSE(exercise_solved(window.player()));
  CHECK_FALSE(window.has("found"));
  for (const auto& [name, text] : wrong->by) {
    Parameters setting = window.player().parameters();
    set(window.player().lesson(), setting, name, text);
    window.ui.player().edit(name, setting.at(name));
  }
  window.frames(2);
  CHECK(exercise_solved(window.player()));
  REQUIRE(window.has("found"));
  CHECK(window.rect("found").top >= window.rect("program").bottom);
}

TEST_CASE("the closing step leads to lessons that share an idea", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 2400, at("inside"));
  window.key(key::end);
  window.frames(2);
  REQUIRE(window.has("same idea Minkowski sum: sphere-aabb"));
  window.click("same idea Minkowski sum: sphere-aabb");
  window.frames(2);
  CHECK(window.player().lesson().id == "sphere-aabb");
}

TEST_CASE("the end leads on: the next lesson first, then exercises, the same ideas, and references folded",
          "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 2400, at("inside"), {}, layout_only);
  CHECK_FALSE(window.has("next lesson"));
  window.key(key::end);
  window.frames(2);
  REQUIRE(window.has("next lesson"));
  CHECK(window.rect("next lesson").bottom < window.rect("try 1").top);
  CHECK(window.rect("try 1").bottom < window.rect("same idea Minkowski sum: sphere-aabb").top);
  CHECK(window.rect("same idea Minkowski sum: sphere-aabb").bottom < window.rect("reading").top);
  const std::string next = next_lesson(window.player())->id;
  const auto open_from_end = [&](const auto& action) {
    window.player().open(spheres());
    window.key(key::end);
    window.frames(2);
    action();
    window.frames(2);
    CHECK(window.player().lesson().id == next);
    CHECK(window.player().index() == 0);
  };
  open_from_end([&] { window.click("next lesson"); });
  open_from_end([&] { window.key(key::right); });
  open_from_end([&] { window.type("n"); });
  CHECK_FALSE(window.ui.settings().nonstop);  // there N does this alone
  open_from_end([&] { window.click("next"); });
  window.key(key::z, true);
  CHECK(window.player().lesson().id == "sphere-sphere");
  CHECK(window.player().step().slug == closing_slug);
}

TEST_CASE("a key that is held stops at the end of its lesson, and the last lesson leads nowhere", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, at("inside"), {}, layout_only);
  window.press(key::right, true);
  window.frames(400);
  CHECK(window.player().lesson().id == "sphere-sphere");
  CHECK(window.player().at_end());
  window.press(key::right, false);
  window.frames(2);
  window.key(key::right);
  CHECK(window.player().lesson().id != "sphere-sphere");

  window.player().open(spheres());
  window.key(key::tab);
  window.press(key::page_down, true);
  window.frames(400);
  CHECK((window.player().lesson().id == "sphere-sphere" && window.player().at_end()));
  window.press(key::page_down, false);
  window.frames(2);
  window.key(key::page_down);
  CHECK((window.player().lesson().id != "sphere-sphere" && window.player().index() == 0));
  window.key(key::tab);

  window.player().open(*lessons::all_lessons().back());
  window.key(key::end);
  window.frames(2);
  CHECK_FALSE(window.has("next lesson"));
  window.key(key::right);
  window.click("next");
  CHECK(window.player().lesson().id == lessons::all_lessons().back()->id);
  CHECK(window.player().at_end());
}

TEST_CASE("another method keeps the step's place, in every lesson", "[player]") {
  int changed = 0;
  for (const Lesson* lesson : lessons::all_lessons()) {
    ReaderState state;
    state.lesson = lesson->id;
    Player player({lesson}, state);
    for (const Method& method : player.played().methods())
      for (const int i : {0, player.count() / 2, outcome(player.walk()), player.count() - 1}) {
        player.go_to(i);
        Player other = player;
        try {
          other.load_method(method.choice);
        } catch (const BadInput&) {  // this method can't take the setting
          continue;
        }
        INFO(lesson->id << ", " << method.choice << ", step " << i);
        const bool has_it =
            std::ranges::find(other.walk().steps, player.step().slug, &Step::slug) != other.walk().steps.end();
        if (i > 0 && i == outcome(player.walk()))
          CHECK(other.index() == outcome(other.walk()));
        else if (has_it)
          CHECK(other.step().slug == player.step().slug);
        else
          CHECK(other.index() == std::min(i, outcome(other.walk())));
        ++changed;
      }
  }
  CHECK(changed > 30);
}

TEST_CASE("one key shows the published line fail", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 1000, at("overlapping"));
  window.ui.player().go_to(3);
  window.frames(2);
  CHECK(window.has("see it fail"));
  window.type("e");
  window.frames(2);
  CHECK(window.player().played().preset_id() == "touching");
  CHECK(window.player().walk().pseudocode[window.player().step().line] == spheres().errata.front().published);
  CHECK_FALSE(window.has("see it fail"));  // it does
  int shown = 0;
  for (const Lesson* lesson : lessons::all_lessons())
    for (const Preset& preset : lesson->presets) {
      window.player().open(*lesson);
      window.player().load(preset);
      for (int i = 0; i < window.player().count() && !erratum(window.player()); ++i) window.player().go_to(i);
      if (!erratum(window.player())) continue;
      CAPTURE(lesson->id, preset.id);
      show_erratum(window.player());
      const bool first_line = window.player().step().line == 0;
      CHECK((window.player().index() > 0 || first_line));  // where its line stands, or where it has led
      ++shown;
    }
  CHECK(shown > 5);
}

TEST_CASE("E leads back from the published line's failure to where the reader was", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 1400, at("overlapping"), {}, layout_only);
  window.ui.player().go_to(3);
  window.frames(2);
  CHECK_FALSE(window.has("way back"));
  const ReaderState before = window.player().reader_state();
  const auto is_back = [&] {
    const ReaderState now = window.player().reader_state();
    CHECK(now.preset == before.preset);
    CHECK(now.step == before.step);
    CHECK((now.camera == before.camera));
    window.frames(2);
    CHECK_FALSE(window.has("way back"));
  };
  const auto see = [&] {
    window.type("e");
    window.frames(2);
    CHECK(window.player().played().preset_id() == "touching");
    REQUIRE(window.has("way back"));
  };
  see();
  window.type("e");
  is_back();
  see();
  window.click("way back");
  is_back();
  see();
  window.ui.player().edit("r_b", 0.5);  // from a setting made of it, too
  window.frames(2);
  window.click("way back");
  is_back();
  see();
  window.type("1");  // on to another preset: the way back ends
  window.frames(2);
  CHECK_FALSE(window.has("way back"));
}

}  // namespace practice_test
