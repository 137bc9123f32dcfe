// The list of a scene's objects in the window, driven with the pointer and the keyboard.

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/scene/editor.h"
#include "app/scene/lesson.h"
#include "tests/catch.h"
#include "tests/viz/window_driver.h"
#include "viz/text/rich_text.h"

namespace objects_panel_test {
using namespace isect::viz;
using isect::program::scene::editor;
using isect::program::scene::kept_lesson_of;
using isect::program::scene::text_with;
using isect::test::Contains;

namespace {

const std::string three = R"({"objects": [
    {"circle": "A", "center": [0, 0], "radius": 1}, // mine
    {"circle": "B", "center": [3, 0], "radius": 1},
    {"box": "C", "lo": [0, 2], "hi": [1, 3]}
  ],
  "ask": [["A", "B"], ["A", "C"]]
})";

WindowOptions with_editor() {
  WindowOptions options = layout_only;
  options.scene_editor = editor();
  return options;
}

struct Scene3 {
  explicit Scene3(const std::string& text = three, const WindowOptions& options = with_editor())
      : lesson(kept_lesson_of(text, "")), window({&lesson}, 1280, 800, {}, {}, options) {
    window.frames(2);
  }
  Player& player() { return window.player(); }
  std::string text() { return *text_with(player().lesson(), player().parameters()); }
  void click(const std::string& name) {
    window.click(name);
    window.frames(2);
  }
  /// Moves the keyboard's ring to this widget.
  void ring(const std::string& name) {
    for (int i = 0; i < 200 && window.ui.focus() != name; ++i) window.key(key::down);
    REQUIRE(window.ui.focus() == name);
  }
  void undo() {
    window.key(key::z, true);
    window.frames(2);
  }

  const Lesson& lesson;
  WindowDriver window;
};

}  // namespace

TEST_CASE("a scene's objects are listed beside its picture, and its answers in the left panel", "[scene]") {
  Scene3 s;
  for (const char* name : {"object A", "switch A", "object B", "object C", "add object"}) CHECK(s.window.has(name));
  CHECK_FALSE(s.window.has("find objects"));
  CHECK_FALSE(s.window.has("code panel"));
  REQUIRE((s.window.has("answer 2") && s.window.has("answer 3")));
  CHECK(s.window.rect("answer 2").right < s.window.rect("scene").left + 1);
  s.click("answer 3");
  CHECK(s.player().index() == 2);
  WindowDriver without({&s.lesson}, 1280, 800, {}, {}, layout_only);  // nobody who knows such files
  CHECK(without.has("code panel"));
  CHECK_FALSE(without.has("object A"));
}

TEST_CASE("a switch hides an object from the picture, not from the answers, and undo shows it again", "[scene]") {
  Scene3 s;
  const std::size_t items = s.player().scene().items.size();
  const std::string verdict = s.player().walk().steps[1].verdict.text;
  s.click("switch A");
  CHECK(s.player().scene().items.size() < items);
  CHECK(s.player().walk().steps[1].verdict.text == verdict);
  CHECK_THAT(s.text(), Contains("\"hidden\": true") && Contains("// mine"));
  CHECK(s.window.has("object A"));
  s.undo();
  CHECK(s.player().scene().items.size() == items);
  CHECK(&s.player().lesson() == &s.lesson);
  CHECK(s.text() == three);
  s.window.key(key::y, true);
  CHECK(s.player().scene().items.size() < items);
}

TEST_CASE("the palette adds an object in the middle of what is seen, under a free name", "[scene]") {
  Scene3 s;
  const Vec3 middle = s.player().camera().goal().target;
  const Parameters before = s.player().parameters();
  s.click("add object");
  CHECK_FALSE(s.window.has("add cone"));  // it has three coordinates
  s.click("add sphere");
  REQUIRE(s.window.has("object D"));
  const double height = s.player().camera().goal().half_height;
  CHECK((std::get<Vec3>(s.player().parameters().at("D.center")) - middle).norm() < 0.1 * height);
  CHECK(std::get<double>(s.player().parameters().at("D.radius")) < 0.5 * height);
  CHECK(s.window.has("handle D.center"));
  s.window.drag("handle D.center", 20, 10);
  s.click("add object");
  s.click("add box");
  REQUIRE(s.window.has("object E"));  // and the drag of D is in the text
  CHECK_THAT(s.text(), Contains("\"circle\": \"D\"") && Contains("\"box\": \"E\"") && Contains("// mine"));
  for (int i = 0; i < 3; ++i) s.undo();
  CHECK(s.player().parameters() == before);
  CHECK(s.text() == three);
  CHECK_FALSE(s.window.has("object D"));
}

TEST_CASE("a name is typed in place, and refused with a word when it is taken", "[scene]") {
  Scene3 s;
  s.ring("object A");
  s.window.key(key::f2);
  s.window.frames(4);
  REQUIRE(s.window.has("name field"));
  s.window.type("ball");
  s.window.key(key::enter);
  s.window.frames(2);
  CHECK(s.window.has("object ball"));
  CHECK(s.window.ui.focus() == "object ball");
  CHECK_THAT(plain(s.player().walk().steps[1].verdict.text), Contains("ball and B"));
  s.window.key(key::f2);
  s.window.frames(4);
  s.window.type("B");
  s.window.key(key::enter);
  s.window.frames(2);
  CHECK_THAT(s.window.ui.message(), Contains("\"B\" is the name of another object"));
  CHECK(s.window.has("object ball"));
  s.undo();
  CHECK(s.window.has("object A"));
  CHECK(s.text() == three);
}

TEST_CASE("Delete removes an object with its questions, asks nothing, and undo brings all back", "[scene]") {
  Scene3 s;
  const int steps = s.player().count();
  s.ring("object B");
  s.window.key(key::del);
  s.window.frames(2);
  CHECK_FALSE(s.window.has("object B"));
  CHECK(s.player().count() < steps);
  CHECK(s.window.ui.focus() == "object C");
  CHECK_THAT(s.text(), !Contains("\"B\"") && Contains("// mine"));
  s.undo();
  CHECK(s.window.has("object B"));
  CHECK(s.player().count() == steps);
  CHECK(s.text() == three);
  for (const char* name : {"B", "C"}) {
    s.ring(std::string("object ") + name);
    s.window.key(key::del);
    s.window.frames(2);
  }
  s.window.key(key::del);  // the last one stays: a scene holds an object at least
  s.window.frames(2);
  CHECK(s.window.has("object A"));
  CHECK_THAT(s.window.ui.message(), Contains("a list of 1 to 1000 objects is expected"));
}

TEST_CASE("two objects are chosen, and one of the questions about them is asked", "[scene]") {
  Scene3 s;
  const int steps = s.player().count();
  CHECK_FALSE(s.window.has("ask 1"));
  s.click("object B");
  CHECK(s.window.has("remove object"));
  s.window.wait(1);  // no double click
  s.click("object C");
  REQUIRE(s.window.has("ask 1"));
  s.click("ask 1");
  CHECK(s.player().count() == steps + 1);
  CHECK(s.player().index() == 3);
  CHECK_THAT(plain(s.player().step().verdict.text), Contains("B and C"));
  CHECK_THAT(s.text(), Contains(R"(["A", "C"], ["B", "C"]])"));
  s.undo();
  CHECK(s.player().count() == steps);
  CHECK_FALSE(s.window.has("remove object"));
  s.ring("object B");  // by keyboard, too: it is chosen no longer
  s.window.key(key::enter);
  s.window.frames(2);
  CHECK(s.window.has("remove object"));
}

TEST_CASE("a question that is asked is removed by its cross, or by keys, and undo asks it again", "[scene]") {
  Scene3 s;
  const int steps = s.player().count();
  CHECK_FALSE(s.window.has("unask 1"));
  s.click("object A");
  REQUIRE((s.window.has("unask 1") && s.window.has("unask 2")));
  s.click("unask 2");
  CHECK(s.player().count() < steps);
  CHECK_THAT(s.window.ui.message(), Contains("How A and C lie"));
  CHECK_THAT(s.text(), Contains(R"("ask": [["A", "B"]])") && Contains("// mine"));
  CHECK_FALSE(s.window.has("unask 2"));
  s.undo();
  CHECK(s.player().count() == steps);
  CHECK(s.text() == three);
  s.ring("unask 1");
  s.window.key(key::enter);
  s.window.frames(2);
  CHECK_THAT(s.text(), Contains(R"("ask": [["A", "C"]])"));
}

const std::string outline = R"({"objects": [
    {"polygon": "P", "points": [[0, 0], [4, 0], [4, 4], [0, 4]]}, // mine
    {"point": "q", "at": [2, -0.5]}
  ],
  "ask": [["q", "P"]]
})";

TEST_CASE("a double click on a side adds a corner, one on a corner removes it, and undo knows both", "[scene]") {
  Scene3 s(outline);
  const Rect first = s.window.rect("handle P.1"), second = s.window.rect("handle P.2");
  const float x = first.middle_x() + 0.3f * (second.middle_x() - first.middle_x()), y = first.middle_y();
  const Camera view = s.player().camera().goal();
  s.window.click(x, y);
  s.window.click(x, y);
  s.window.frames(2);
  REQUIRE(s.window.has("handle P.5"));
  CHECK((std::get<Vec3>(s.player().parameters().at("P.2")) - Vec3(1.2, 0, 0)).norm() < 0.1);
  CHECK(s.player().camera().goal() == view);
  CHECK_THAT(s.text(), Contains("// mine"));
  s.window.wait(1);
  s.window.drag("handle P.2", 0, 60);
  CHECK(std::get<Vec3>(s.player().parameters().at("P.2")).y() < -0.1);
  s.window.wait(1);

  const Rect corner = s.window.rect("handle P.2");
  s.window.click(corner.middle_x(), corner.middle_y());
  s.window.click(corner.middle_x(), corner.middle_y());
  s.window.frames(2);
  CHECK_FALSE(s.window.has("handle P.5"));
  CHECK(std::get<Vec3>(s.player().parameters().at("P.2")) == Vec3(4, 0, 0));
  CHECK(s.text() == outline);
  s.undo();
  CHECK(s.window.has("handle P.5"));
  for (int i = 0; i < 6 && s.text() != outline; ++i) s.undo();  // presses at handles are remembered, too
  CHECK(s.text() == outline);

  s.window.wait(1);
  s.window.click(first.middle_x(), first.middle_y());  // between two short drags nothing is removed
  s.window.wait(1);
  s.window.move(first.middle_x(), first.middle_y());
  s.window.button(true);
  s.window.move(first.middle_x() + 3, first.middle_y());
  s.window.button(false);
  s.window.button(true);
  s.window.button(false);
  s.window.frames(2);
  CHECK(s.window.has("handle P.4"));
}

TEST_CASE("Insert and Delete at a corner's ring add and remove one, but three stay", "[scene]") {
  Scene3 s(outline);
  s.ring("handle P.2");
  s.window.key(key::insert);
  s.window.frames(2);
  CHECK(s.window.ui.focus() == "handle P.3");
  CHECK(std::get<Vec3>(s.player().parameters().at("P.3")) == Vec3(4, 2, 0));
  for (int i = 0; i < 2; ++i) {
    s.ring("handle P.1");
    s.window.key(key::del);
    s.window.frames(2);
  }
  CHECK(s.window.has("handle P.3"));
  CHECK_FALSE(s.window.has("handle P.4"));
  s.ring("handle P.1");
  s.window.key(key::del);
  s.window.frames(2);
  CHECK(s.window.has("handle P.3"));
  CHECK_THAT(s.window.ui.message(), Contains("a list of 3 to 10000 points is expected"));
  CHECK(s.window.has("object P"));
  for (int i = 0; i < 3; ++i) s.undo();
  CHECK(s.text() == outline);
}

TEST_CASE("undo of a question leads back to the step where it was added", "[scene]") {
  Scene3 s;
  s.player().go_to(1);
  s.window.frames(2);
  s.click("object B");
  s.click("object C");
  s.click("ask 1");
  REQUIRE(s.player().index() != 1);
  const int answer = s.player().index();
  s.undo();
  CHECK(s.player().index() == 1);
  CHECK(s.text() == three);
  s.window.key(key::y, true);
  s.window.frames(2);
  CHECK(s.player().index() == answer);
}

TEST_CASE("a scene that was edited is not told to be as in the file, and its preset leads back to the file",
          "[scene]") {
  WindowOptions options = with_editor();
  options.save_scene = [](const Lesson& lesson, const Parameters& p) { isect::program::scene::keep(lesson, "", p); };
  Scene3 s(three, options);
  const auto as_in_file = [&] {
    s.window.frames();
    const bool changed = s.window.has("changed");
    CHECK((s.window.ui.title().find(", changed,") != std::string::npos) == changed);
    return !changed;
  };
  CHECK(as_in_file());
  s.click("switch B");
  CHECK_FALSE(as_in_file());
  s.undo();
  CHECK(as_in_file());
  s.window.key(key::y, true);
  CHECK_FALSE(as_in_file());
  s.window.key(key::s, true);
  CHECK(as_in_file());
  s.undo();  // past what was saved
  CHECK_FALSE(as_in_file());
  const bool by_key = GENERATE(true, false);
  by_key ? s.window.type("1") : s.click("changed");
  s.window.frames(2);
  CHECK(as_in_file());
  CHECK_THAT(s.text(), Contains("\"hidden\": true"));
  s.undo();
  CHECK_FALSE(as_in_file());
}

TEST_CASE("an edited scene is unsaved until Ctrl+S writes its text, and again after undo", "[scene]") {
  std::vector<std::string> written;
  WindowOptions options = with_editor();
  options.save_scene = [&](const Lesson& lesson, const Parameters& p) {
    written.push_back(*text_with(lesson, p));
    isect::program::scene::keep(lesson, "", p);
  };
  Scene3 s(three, options);
  CHECK(s.window.ui.may_close());
  s.click("switch B");
  CHECK_FALSE(s.window.ui.may_close());
  s.window.key(key::s, true);
  REQUIRE(written.size() == 1);
  CHECK_THAT(written[0], Contains("\"hidden\": true") && Contains("// mine"));
  CHECK(s.window.ui.may_close());
  s.undo();
  CHECK_FALSE(s.window.ui.may_close());
  s.window.key(key::s, true);
  CHECK(written.back() == three);
}

TEST_CASE("of 1,000 objects the rows in view are drawn, a search finds others, and a drag lists nothing anew",
          "[scene]") {
  std::string objects;
  for (int i = 0; i < 1000; ++i)
    objects += fmt::format(R"({}{{"circle": "b{}", "center": [{}, {}], "radius": 0.4}})", i == 0 ? "" : ",", i, i % 40,
                           i / 40);
  int listed = 0, asked = 0;
  WindowOptions options = with_editor();
  options.scene_editor.objects = [&](const Lesson& lesson) { return ++listed, editor().objects(lesson); };
  options.scene_editor.questions = [&](const Lesson& lesson, const std::vector<std::string>& names) {
    return ++asked, editor().questions(lesson, names);
  };
  Scene3 s(R"({"objects": [)" + objects + "]}", options);
  const auto rows = [&] {
    return std::ranges::count_if(s.window.ui.rects(),
                                 [](const auto& one) { return one.first.starts_with("object b"); });
  };
  CHECK((rows() > 5 && rows() < 40));
  CHECK(listed == 1);
  const Rect r = s.window.rect("handle b500.center");
  s.window.move(r.middle_x(), r.middle_y());
  s.window.button(true);
  for (int i = 1; i <= 10; ++i) s.window.move(r.middle_x() + static_cast<float>(i), r.middle_y());
  s.window.button(false);
  CHECK(std::get<Vec3>(s.player().parameters().at("b500.center")) != Vec3(20, 12, 0));
  CHECK((listed == 1 && asked == 0));
  CHECK((rows() > 5 && rows() < 40));
  s.window.click("find objects");
  s.window.type("b777");
  s.window.frames(2);
  CHECK(rows() == 1);
  CHECK(s.window.has("object b777"));
}

}  // namespace objects_panel_test
