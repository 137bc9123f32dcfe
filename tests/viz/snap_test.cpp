// Shift snaps a drag to where the case changes: found to neighbouring doubles, and exactly where a double is there.

#include <cmath>
#include <ctime>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/window_driver.h"
#include "viz/player/practice.h"
#include "viz/player/snap.h"
#include "viz/walk/closing.h"

namespace snap_test {
using namespace isect;
using namespace isect::viz;
using isect::test::Contains;

namespace {

double number(const Player& player, const std::string& name) { return std::get<double>(player.parameters().at(name)); }

/// Waits until a search has ended.
void rest(WindowDriver& window) {
  for (int i = 0; i < 1000 && window.ui.rest() == 0; ++i) window.frames();
}

/// Takes hold of a handle and drags it with Shift held.
void drag_with_shift(WindowDriver& window, const std::string& handle, float dx, float dy) {
  const Rect r = window.rect("handle " + handle);
  window.move(r.middle_x(), r.middle_y());
  window.button(true);
  window.modifiers(false, true);
  window.move(r.middle_x() + dx / 2, r.middle_y() + dy / 2);
  rest(window);
  window.move(r.middle_x() + dx, r.middle_y() + dy);
  rest(window);
  window.modifiers(false, false);
  window.button(false);
}

/// How often the slow lesson was asked for its steps.
int asked = 0;

/// A walk of one step, which says whether x is at least a third, and has x as its handle.
Walk walk_at(double x) {
  Walk walk;
  Step step;
  step.slug = "told", step.title = "Told";
  step.verdict = {Verdict::Kind::yes, 3 * x >= 1 ? "more" : "less"};
  step.scene.items = {Ball{Vec3::Zero(), 1}};
  step.scene.handles = {{.parameter = "x", .kind = Handle::Kind::along, .at = Vec3(x, 0, 0)}};
  walk.steps = {step};
  return walk;
}

/// Is x at least a third? It takes 6 ms of the processor's time to tell.
const Lesson& slow() {
  static const Lesson lesson = {
      .id = "slow",
      .title = "Slow",
      .rows = "N00",
      .summary = "Whether a number is at least a third.",
      .parameters = {{.name = "x", .label = "*x*", .help = "A number.", .initial = 0.0, .lo = -9, .hi = 9}},
      .group_by = "",
      .presets = {{"less", "less", "", {{"x", 0.0}}}},
      .camera = {},
      .steps =
          [](const Parameters& p) {
            ++asked;
            const std::clock_t begun = std::clock();
            while (std::clock() - begun < 6 * CLOCKS_PER_SEC / 1000) continue;
            return walk_at(std::get<double>(p.at("x")));
          },
      .flat = true};
  return lesson;
}

/// Is x at least a third? Told for x up to 1 only, which no parameter's range says.
const Lesson& refusing() {
  static const Lesson lesson = {
      .id = "refusing",
      .title = "Refusing",
      .rows = "N00",
      .summary = "Whether a number is at least a third, if it is at most 1.",
      .parameters = {{.name = "x", .label = "*x*", .help = "A number.", .initial = 0.0, .lo = -9, .hi = 9}},
      .group_by = "",
      .presets = {{"less", "less", "", {{"x", 0.0}}}, {"more", "more", "", {{"x", 0.5}}}},
      .camera = {},
      .steps =
          [](const Parameters& p) {
            const double x = std::get<double>(p.at("x"));
            if (x > 1) throw BadInput("x is more than 1");
            return walk_at(x);
          },
      .flat = true};
  return lesson;
}

/// The case where a number is one double less, and where it is one more.
std::pair<std::string, std::string> beside(const Player& player, const std::string& name) {
  Parameters less = player.parameters(), more = less;
  double &low = std::get<double>(less.at(name)), &high = std::get<double>(more.at(name));
  low = std::nextafter(low, -INFINITY), high = std::nextafter(high, INFINITY);
  return {case_of(player.lesson(), less), case_of(player.lesson(), more)};
}

}  // namespace

TEST_CASE("an end of an interval snaps to where the intervals touch, exactly", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("intervals", "overlapping"));
  const Rect a = window.rect("handle a_max"), b = window.rect("handle b_min");
  drag_with_shift(window, "b_min", a.middle_x() - b.middle_x() + 7, 3);  // a little beyond
  CHECK(number(window.player(), "b_min") == number(window.player(), "a_max"));
  CHECK_THAT(window.ui.message(), Contains("exactly"));
  window.drag("handle b_min", 30, 0);  // without Shift it goes on
  CHECK(number(window.player(), "b_min") > number(window.player(), "a_max"));
  CHECK(window.ui.message().empty());
}

TEST_CASE("where the border is no double, a drag snaps to one of its neighbours, and that is said", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("ray-sphere", "two-roots"));
  const std::string before = case_of(window.player().lesson(), window.player().parameters());
  drag_with_shift(window, "radius", -30, -60);  // until the line passes the ball
  CHECK_THAT(window.ui.message(), Contains("Between two neighbouring doubles"));
  const auto [less, more] = beside(window.player(), "radius");
  CHECK(less != more);
  CHECK((less == before || more == before));
  CHECK(window.player().undo());
  CHECK(number(window.player(), "radius") ==
        std::get<double>(preset(window.player().lesson(), "two-roots").parameters.at("radius")));
}

TEST_CASE("what has snapped stays when Shift is let go before the button", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("intervals", "overlapping"));
  const Rect a = window.rect("handle a_max"), b = window.rect("handle b_min");
  window.move(b.middle_x(), b.middle_y());
  window.button(true);
  window.modifiers(false, true);
  window.move(a.middle_x() + 7, b.middle_y());
  rest(window);
  window.modifiers(false, false);
  window.frames(2);
  CHECK(number(window.player(), "b_min") == number(window.player(), "a_max"));
  const Rect toast = window.rect("message");
  CHECK(toast.bottom <= window.rect("changed").top);
  window.move(a.middle_x() + 9, b.middle_y());
  CHECK(number(window.player(), "b_min") > number(window.player(), "a_max"));
  window.button(false);
}

TEST_CASE("a drag ends where a key brings another lesson", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("intervals", "overlapping"));
  for (const bool snapping : {false, true}) {
    const Lesson& lesson = window.player().lesson();
    REQUIRE_FALSE(window.player().scene().handles.empty());
    const Rect r = window.rect("handle " + window.player().scene().handles.front().id());
    window.move(r.middle_x(), r.middle_y());
    window.button(true);
    window.modifiers(false, snapping);
    window.move(r.middle_x() + 20, r.middle_y());
    window.type("]");
    REQUIRE(&window.player().lesson() != &lesson);
    const Parameters before = window.player().parameters();
    window.move(r.middle_x() + 60, r.middle_y() + 20);
    rest(window);
    window.modifiers(false, false);
    window.button(false);
    CHECK((window.player().parameters() == before));
    CHECK(window.ui.message().empty());
  }
}

TEST_CASE("a drag on which nothing changes goes where the pointer goes", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("intervals", "overlapping"));
  const double before = number(window.player(), "b_max");
  drag_with_shift(window, "b_max", 12, 0);
  CHECK(number(window.player(), "b_max") > before);
  CHECK(window.ui.message().empty());
}

TEST_CASE("a point snaps onto the edge that its drag crosses", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("crossings", "on-vertex"));
  Player& player = window.player();
  player.edit("p", Vec3(0.5, 0, 0));
  window.frames(2);
  CHECK(case_of(player.lesson(), player.parameters()).find("IN") != std::string::npos);
  const float pixels = window.rect("handle v2").middle_x() - window.rect("handle p").middle_x();  // 1.75
  drag_with_shift(window, "p", pixels * -2 / 1.75f, 0);  // to the vertex v0 at (-1.5, 0)
  CHECK(std::get<Vec3>(player.parameters().at("p")) == Vec3(-1.5, 0, 0));
  CHECK_THAT(window.ui.message(), Contains("exactly"));
}

TEST_CASE("a point snaps to a place that is unlike all about it, and so an exercise is solved by dragging",
          "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("crossings", "inside"));
  Player& player = window.player();
  player.last();
  window.frames(2);
  begin_exercise(player, 0);  // where does the closed rule err? only at the height of a corner
  window.frames(2);
  CHECK_FALSE(exercise_solved(player));
  const Rect p = window.rect("handle p");
  const Vec3 from = std::get<Vec3>(player.parameters().at("p"));
  window.move(p.middle_x(), p.middle_y());
  window.button(true);
  window.modifiers(false, true);
  const Rect corner = window.rect("handle v2");  // at (2.25, -0.5)
  window.move(p.middle_x() + 2, corner.middle_y() + 5);
  rest(window);
  window.modifiers(false, false);
  window.button(false);
  window.frames(2);
  const Vec3 now = std::get<Vec3>(player.parameters().at("p"));
  CHECK(now != from);
  CHECK(now.y() == -0.5);
  CHECK_THAT(window.ui.message(), Contains("Here exactly"));
  CHECK_THAT(window.ui.message(), Contains("Wrong: the truth is 1 crossing"));
  CHECK(exercise_solved(player));
}

TEST_CASE("a landmark is found where it is a case of its own, and the nearer border if there is one", "[snap]") {
  // x = 1 is unlike all about it; from 3 on is another case.
  Lesson lesson = slow();
  lesson.steps = [](const Parameters& p) {
    const double x = std::get<double>(p.at("x"));
    Walk walk;
    walk.steps.emplace_back();
    walk.steps[0].verdict = {Verdict::Kind::yes, x == 1 ? "one" : x >= 3 ? "more" : "less"};
    return walk;
  };
  const Handle handle = {.parameter = "x", .kind = Handle::Kind::along, .at = Vec3::Zero()};
  Scene scene;
  scene.items = {Dot{Vec3(1, 5, 0), Mark::disc, Role::first}, Dot{Vec3(2, 5, 0), Mark::disc, Role::first}};
  const Parameters setting = {{"x", 0.0}};
  const auto found = [&](double to, const Scene& marked) {
    const Vec3 end(to, 0, 0);
    const auto all = landmarks(lesson, setting, handle, Vec3::Zero(), end, marked, 1);
    return find_border(lesson, way_of(lesson, setting, handle, Vec3::Zero(), end), 0, 1.25, 1, all);
  };
  const auto one = found(1.1, scene), without = found(1.1, {}), near = found(2.9, scene);
  REQUIRE(one);
  CHECK(one->exact);
  CHECK(std::get<double>(one->setting.at("x")) == 1);
  CHECK(one->told == "Here exactly: “one”");
  CHECK_FALSE(without);
  REQUIRE(near);
  CHECK(std::get<double>(near->setting.at("x")) == Approx(3));
  const auto beyond = found(0.7, scene);  // x = 1 lies behind the end of the way
  CHECK_FALSE(beyond);
}

TEST_CASE("what a handle carries with it is no landmark of its way", "[snap]") {
  Lesson lesson = slow();
  lesson.parameters.clear();
  Parameters setting;
  for (const char* name : {"a", "b", "c"}) {
    lesson.parameters.push_back({.name = name, .label = "", .help = "A point.", .initial = Vec3(0, 0, 0)});
    setting[name] = Vec3(0, 0, 0);
  }
  Scene scene;
  scene.handles = {{.parameter = "b", .kind = Handle::Kind::point, .at = Vec3(2, 0, 0)},
                   {.parameter = "c", .kind = Handle::Kind::point, .at = Vec3(3, 0, 0)}};
  const auto shares = [&](const std::vector<std::string>& with) {
    const Handle handle = {
        .parameter = "a", .kind = Handle::Kind::shift, .at = Vec3::Zero(), .with = with, .name = "all of it"};
    std::vector<double> all;
    for (const Landmark& l : landmarks(lesson, setting, handle, Vec3::Zero(), {4, 0, 0}, scene, 1))
      all.push_back(l.share);
    return all;
  };
  CHECK(shares({}) == std::vector<double>{0.75, 0.5});
  CHECK(shares({"b"}) == std::vector<double>{0.75});
}

TEST_CASE("bounding volumes snap, though a walk of them takes long", "[snap]") {
  const Lesson& lesson = lesson_named(lessons::all_lessons(), "bounding-volumes");
  int found = 0;
  for (const Preset& preset : lesson.presets) {
    const Walk walk = lesson.walk(preset.parameters);
    for (const Handle& h : walk.steps.front().scene.handles)
      for (const Vec3& way : {Vec3(4, 2, 0), Vec3(-4, -2, 0)})
        found += find_border(lesson, way_of(lesson, preset.parameters, h, h.at, h.at + way), 0, 1, 1).has_value();
  }
  CHECK(found > 0);
}

TEST_CASE("Ctrl, Shift and an arrow take a held handle to where the case changes next", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("intervals", "overlapping"));
  for (int i = 0; i < 200 && window.ui.focus() != "handle b_min"; ++i) window.key(key::down);
  window.key(key::right, true, true);
  rest(window);
  CHECK(number(window.player(), "b_min") == number(window.player(), "a_max"));
  CHECK_THAT(window.ui.message(), Contains("exactly"));
  window.key(key::up, true, true);
  rest(window);
  CHECK_THAT(window.ui.message(), Contains("does not change"));
}

TEST_CASE("the setting snaps to a border of the map, too", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("sphere-sphere", "overlapping"));
  Player& player = window.player();
  const CaseMap& map = *player.lesson().map;
  window.type("w");
  window.frames(2);
  const Rect plane = window.rect("map plane"), from = window.rect("map setting");
  const Vec2 here = map.place(player.parameters());
  const int branch = map.branch(player.parameters());
  const auto corner = [&](double x, double y) { return Vec2(map.lo + Vec2(x, y).cwiseProduct(map.hi - map.lo)); };
  bool other = false;
  for (const auto& [x, y] : {std::pair{0.02, 0.98}, {0.98, 0.98}, {0.02, 0.02}, {0.98, 0.02}}) {
    if (map.branch(map.moved(player.parameters(), corner(x, y))) == branch) continue;
    other = true;
    window.move(from.middle_x(), from.middle_y());
    window.button(true);
    window.modifiers(false, true);
    window.move(plane.left + static_cast<float>(x) * plane.width(),
                plane.bottom - static_cast<float>(y) * plane.height());
    window.modifiers(false, false);
    window.button(false);
    break;
  }
  REQUIRE(other);
  CHECK(map.place(player.parameters()) != here);
  CHECK((window.ui.message().find("exactly") != std::string::npos ||
         window.ui.message().find("neighbouring doubles") != std::string::npos));
}

TEST_CASE("a frame asks a slow lesson a few questions, and the snap comes when all are asked", "[window]") {
  // A frame begins no question after an eightieth of a second, three of them; the last step of the search may then ask
  // two. So no clock is needed to see that they are few.
  constexpr int most = 6;
  WindowDriver window({&slow()}, 1280, 800);
  const auto x = [&] { return number(window.player(), "x"); };
  const auto asked_in = [&](const auto& action) {
    const int before = asked;
    action();
    return asked - before;
  };
  const auto hold = [&] {
    const Rect r = window.rect("handle x");
    window.move(r.middle_x(), r.middle_y());
    window.button(true);
    return r;
  };
  Rect r = hold();
  window.move(r.middle_x() + 100, r.middle_y());
  const float unit = static_cast<float>(100 / x());
  window.button(false);
  CHECK(window.player().undo());
  window.frames(2);
  CHECK(x() == 0);

  r = hold();
  window.modifiers(false, true);
  CHECK(asked_in([&] { window.move(r.middle_x() + unit * 0.5f, r.middle_y()); }) <= most);
  int all = 0, frames = 0;
  CHECK(window.ui.message().empty());
  SECTION("while the button is held") {
    // The pointer goes on, and the search does not begin anew each time.
    for (; x() == 0 && frames < 200; ++frames) {
      const float away = 0.5f + 0.001f * static_cast<float>(frames % 5);
      const int now = asked_in([&] { window.move(r.middle_x() + unit * away, r.middle_y()); });
      CHECK(now <= most);
      if (frames == 14) CHECK_THAT(window.ui.message(), Contains("Looking for where the case changes"));
      all += now;
    }
  }
  SECTION("after it was released") {
    window.modifiers(false, false);
    window.button(false);
    for (; window.ui.rest() == 0 && frames < 200; ++frames) {
      const int now = asked_in([&] { window.frames(); });
      CHECK(now <= most);
      all += now;
    }
  }
  CHECK(all > 30);
  CHECK(frames > 10);
  CHECK(3 * x() >= 1);
  CHECK(3 * std::nextafter(x(), 0.0) < 1);
  CHECK_THAT(window.ui.message(), Contains("Between two neighbouring doubles"));
}

TEST_CASE("what is done meanwhile ends the search for a border", "[window]") {
  WindowDriver window({&slow()}, 1280, 800);
  const Rect r = window.rect("handle x");
  window.move(r.middle_x(), r.middle_y());
  window.button(true);
  window.modifiers(false, true);
  window.move(r.middle_x() + 200, r.middle_y());
  CHECK(window.ui.rest() == 0);
  for (int i = 0; i < 100 && window.ui.message().empty(); ++i) window.frames();
  CHECK_THAT(window.ui.message(), Contains("Looking"));
  SECTION("a drag without Shift") {
    window.modifiers(false, false);
    window.move(r.middle_x() + 20, r.middle_y());
  }
  SECTION("another setting") { window.player().edit("x", -2.0); }
  const double x = number(window.player(), "x");
  CHECK(x != 0);
  window.frames(3);
  CHECK(window.ui.rest() > 0);
  CHECK(window.ui.message().empty());
  rest(window);
  CHECK(number(window.player(), "x") == x);
}

TEST_CASE("a search goes around settings that the lesson refuses, whether they are places or landmarks", "[snap]") {
  const auto at = [](double x) { return Parameters{{"x", x}}; };
  const Way way = [&](double share) { return at(4 * share); };  // refused from a quarter on
  const auto border = find_border(refusing(), way, 0, 1, 1);
  REQUIRE(border);
  CHECK(std::abs(3 * std::get<double>(border->setting.at("x")) - 1) < 1e-15);
  const Way beyond = [&](double share) { return at(0.5 + 4 * share); };  // all that is not refused is one case
  CHECK_FALSE(find_border(refusing(), beyond, 0, 1, 1, {{0.3, at(1.7)}, {0.6, at(2.9)}}));
}

TEST_CASE("a drag into what the lesson refuses is refused in words, with Shift as without", "[window]") {
  ReaderState start = place_at("refusing", "more");
  WindowDriver window({&refusing()}, 1280, 800, start);
  const Rect r = window.rect("handle x");
  const float away = 4 * (r.middle_x() - window.rect("scene").middle_x());  // from 0.5 to 2 or more
  REQUIRE(away != 0);
  for (const bool shift : {false, true}) {
    CAPTURE(shift);
    window.move(r.middle_x(), r.middle_y());
    window.button(true);
    window.modifiers(false, shift);
    window.move(r.middle_x() + away, r.middle_y());
    rest(window);
    CHECK(window.ui.message() == "x is more than 1");
    CHECK(number(window.player(), "x") == 0.5);
    window.modifiers(false, false);
    window.button(false);
    window.wait(20);  // until the words have gone
    CHECK(window.ui.message().empty());
  }
}

TEST_CASE("wherever a shape is brought to touch another one, the picture marks what they share", "[snap]") {
  const Lesson& relations = lesson_named(lessons::all_lessons(), "relations");
  const auto kind = std::ranges::find(relations.parameters, "kind", &Parameter::name);
  REQUIRE(kind != relations.parameters.end());
  int touching = 0;
  for (const std::string& choice : kind->choices)
    for (const Vec3& to : {Vec3(1, 0, 0), Vec3(-1, 2, 0), Vec3(2, 1, -1), Vec3(0, 1, 1), Vec3(0.3, 0.7, 0.2)}) {
      Parameters setting = preset(relations, "ball-overlapping").parameters;
      setting["kind"] = choice;
      const Walk walk = relations.walk(setting);
      const auto& handles = walk.steps.front().scene.handles;
      const auto handle = std::ranges::find(handles, "b", &Handle::parameter);
      if (handle == handles.end()) continue;  // of all kinds together
      const auto found =
          find_border(relations, way_of(relations, setting, *handle, handle->at, handle->at + 5 * to), 0, 1, 0);
      if (!found) continue;
      const Walk there = relations.walk(found->setting);
      const Step& last = there.steps[static_cast<std::size_t>(outcome(there))];
      if (last.verdict.text.find("touch") == std::string::npos) continue;
      ++touching;
      CAPTURE(choice, to.transpose(), last.verdict.text, found->told);
      CHECK(std::ranges::any_of(last.scene.items, [](const Item& item) {
        return std::visit(
            [](const auto& it) {
              if constexpr (requires { it.role; })
                return it.role == Role::hit;
              else
                return false;
            },
            item);
      }));
    }
  CHECK(touching > 5);
}

TEST_CASE("in every lesson a drag that changes the case snaps to a border between cases", "[snap]") {
  int snapped = 0;
  for (const Lesson* lesson : lessons::all_lessons()) {
    const Parameters& setting = lesson->presets.front().parameters;
    const Walk walk = lesson->walk(setting);
    for (const Handle& h : walk.steps.front().scene.handles) {
      INFO(lesson->id << " " << h.parameter);
      const Way way = way_of(*lesson, setting, h, h.at, h.at + Vec3(1.5, 0.75, 0));
      const auto found = find_border(*lesson, way, 0, 1, 1);
      if (!found) continue;
      ++snapped;
      CHECK_NOTHROW(validate(*lesson, found->setting));
      CHECK(found->exact == (found->told.find("exactly") != std::string::npos));
      if (found->exact) CHECK(case_of(*lesson, found->setting) != case_of(*lesson, setting));
    }
  }
  CHECK(snapped > 10);
}

}  // namespace snap_test
