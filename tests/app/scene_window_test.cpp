// A user's own scenes in the window: their handles, their contacts, and what a walk of a lesson refuses.

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/scene/lesson.h"
#include "lessons/lessons.h"
#include "tests/app/many_balls.h"
#include "tests/catch.h"
#include "tests/viz/window_driver.h"
#include "viz/formats/files.h"
#include "viz/walk/question_scene.h"

namespace scene_window_test {
using namespace isect::viz;
using isect::program::scene::kept_lesson_of;
using isect::program::scene::kept_walks_of;
using isect::test::Contains;
using isect::test::many_balls;

namespace {

/// The scenes of the examples, and each as a walk of the lessons that accept it.
std::vector<const Lesson*> all_scenes() {
  std::vector<const Lesson*> all;
  for (const auto& entry : std::filesystem::directory_iterator(ISECT_EXAMPLE_SCENES)) {
    if (entry.path().extension() != ".json") continue;
    const std::string text = read_file(entry.path().string());
    all.push_back(&kept_lesson_of(text, ISECT_EXAMPLE_SCENES));
    for (const Lesson* lesson : isect::lessons::all_lessons()) {
      try {
        all.push_back(&kept_walks_of(*lesson, "", text, ISECT_EXAMPLE_SCENES));
      } catch (const BadInput&) {
        continue;  // it takes none of these objects
      }
    }
  }
  return all;
}

/// The marks that the picture of the first question adds to the objects.
std::vector<Item> marks_of(const std::string& objects, const std::string& asked) {
  const Lesson& scene = kept_lesson_of(R"({"objects": [)" + objects + R"(], "ask": [)" + asked + "]}", "");
  const Walk walk = scene.steps(scene.presets.front().parameters);
  std::vector<Item> marks;
  for (const Item& item : walk.steps.at(1).scene.items)
    std::visit(
        [&](const auto& it) {
          if constexpr (requires { it.role; })
            if (it.role == Role::hit) marks.push_back(item);
        },
        item);
  return marks;
}

}  // namespace

TEST_CASE("the handles of a walk through a scene are the scene's own, also while a question is open", "[scene]") {
  int asked = 0;
  for (const Lesson* lesson : all_scenes()) {
    const Walk walk = lesson->walk(lesson->presets.front().parameters);
    const auto known = [&](const Handle& handle) {
      INFO(lesson->title << ": " << handle.parameter);
      return std::ranges::find(lesson->parameters, handle.parameter, &Parameter::name) != lesson->parameters.end();
    };
    for (int k = 0; k < static_cast<int>(walk.steps.size()); ++k) {
      const Step& step = walk.steps[static_cast<std::size_t>(k)];
      CAPTURE(lesson->title, step.slug);
      CHECK(std::ranges::all_of(step.scene.handles, known));
      if (!step.question) continue;
      ++asked;
      CHECK(std::ranges::all_of(question_scene(walk, k).handles, known));
    }
  }
  CHECK(asked > 20);
}

TEST_CASE("a ray's handle is dragged while a question of its walk is open", "[scene]") {
  const Lesson& scene = kept_lesson_of(read_file(ISECT_EXAMPLE_SCENES "/crates-and-a-ray.json"), ISECT_EXAMPLE_SCENES);
  WindowDriver window({&scene}, 1280, 800);
  for (int i = 0; i < 20 && !window.player().quiz().asked(); ++i) window.key(key::right);
  REQUIRE(window.player().quiz().asked());
  window.frames(2);
  const Vec3 before = std::get<Vec3>(window.player().parameters().at("r.origin"));
  window.drag("handle r.origin", 20, 10);
  CHECK(std::get<Vec3>(window.player().parameters().at("r.origin")) != before);
  CHECK(window.ui.message().empty());
}

TEST_CASE("a drag of a corner to where its lesson refuses the polygon is refused in words, with Shift, too",
          "[scene]") {
  const Lesson& scene = kept_lesson_of(R"({"objects": [{"point": "p", "at": [0, 0]},
    {"polygon": "P", "points": [[-2, -2], [2, -2], [2, 2], [-2, 2]]}],
    "ask": [{"walk": ["p", "P"], "lesson": "convex-polygon"}]})",
                                       "");
  for (const bool shift : {false, true}) {
    CAPTURE(shift);
    WindowDriver window({&scene}, 1280, 800);
    const Rect r = window.rect("handle P.3"), other = window.rect("handle P.1");
    window.move(r.middle_x(), r.middle_y());
    window.button(true);
    window.modifiers(false, shift);
    for (const float way : {0.3f, 0.8f}) {  // to the other corner, so that P is a dart in the end
      window.move(r.middle_x() + way * (other.middle_x() - r.middle_x()),
                  r.middle_y() + way * (other.middle_y() - r.middle_y()));
      for (int i = 0; i < 400 && window.ui.rest() == 0; ++i) window.frames();
    }
    CHECK_THAT(window.ui.message(), Contains("P is not convex"));
    window.modifiers(false, false);
    window.button(false);
    window.frames(2);
    CHECK(scene.walk(window.player().parameters()).steps.size() == static_cast<std::size_t>(window.player().count()));
  }
}

TEST_CASE("a scene of two hundred objects shows names by need", "[scene]") {
  const Lesson& scene = kept_lesson_of(many_balls(200, R"([["b0", "b1"], ["b5", "b6"], ["b20", "b199"]])"), "");
  WindowDriver window({&scene}, 1280, 800);
  window.frames(3);
  CHECK(window.ui.labels().empty());
  CHECK(window.rect("lesson words").height() > 400);  // the hint takes one line
  window.key(key::right);
  window.frames(3);
  std::vector<std::string> names;
  for (const PlacedLabel& label : window.ui.labels()) names.push_back(label.text);
  std::ranges::sort(names);
  CHECK(names == std::vector<std::string>{"b₀", "b₁"});
}

TEST_CASE("six boxes keep the names of their corners for the pointer and the keyboard's ring", "[scene]") {
  const Lesson& scene = kept_lesson_of(read_file(ISECT_EXAMPLE_SCENES "/crates-and-a-ray.json"), ISECT_EXAMPLE_SCENES);
  WindowDriver window({&scene}, 1280, 800);
  window.frames(2);
  for (const PlacedLabel& label : window.ui.labels()) CHECK(label.text.find('.') == std::string::npos);
  for (int i = 0; i < 40 && !window.ui.focus().starts_with("handle"); ++i) window.key(key::down);
  REQUIRE(window.ui.focus().starts_with("handle"));
  window.frames(2);
  CHECK(window.has("name of the ringed handle"));
}

TEST_CASE("a face of a box, a frame and a whole polygon are dragged with the pointer", "[scene]") {
  const Lesson& scene = kept_lesson_of(R"({"objects": [{"box": "A", "lo": [-1, -1, -1], "hi": [1, 1, 1]},
    {"obb": "B", "center": [4, 0, 0], "u": [1, 0, 0], "v": [0, 1, 0], "w": [0, 0, 1], "half": [1, 0.5, 0.75]},
    {"polygon": "P", "points": [[-4, -1, 0], [-2.5, -1, 0], [-3, 1, 0]]}]})",
                                       "");
  WindowDriver window({&scene}, 1280, 800);
  window.frames(2);
  const Parameters before = window.player().parameters();
  const auto point = [&](const char* name) { return std::get<Vec3>(window.player().parameters().at(name)); };
  const auto was = [&](const char* name) { return std::get<Vec3>(before.at(name)); };
  const auto changed = [&] {
    std::vector<std::string> names;
    for (const auto& [name, value] : window.player().parameters())
      if (value != before.at(name)) names.push_back(name);
    window.player().undo();
    window.frames(60);
    return names;
  };
  using Names = std::vector<std::string>;
  window.drag("handle A.hi.y", 0, -30);
  CHECK(point("A.hi").y() > 1.05);
  CHECK((point("A.hi").x() == 1 && point("A.hi").z() == 1));
  CHECK(changed() == Names{"A.hi"});
  window.drag("handle A.hi.y", 0, 500);  // through the face across
  CHECK(point("A.hi").y() == -1);
  CHECK(window.ui.message().find("not allowed") == std::string::npos);
  CHECK(changed() == Names{"A.hi"});
  window.drag("handle B.half.x", 30, 0);
  CHECK(point("B.half").x() > 1.05);
  CHECK(changed() == Names{"B.half"});
  window.drag("handle B.u", 0, -60);
  CHECK(std::abs(point("B.u").dot(point("B.v"))) < 1e-12);
  CHECK(changed() == Names{"B.u", "B.v", "B.w"});
  window.drag("handle P", 20, 10);
  for (const char* corner : {"P.2", "P.3"})
    CHECK((point(corner) - point("P.1")).isApprox(was(corner) - was("P.1"), 1e-12));
  CHECK(changed() == Names{"P.1", "P.2", "P.3"});
}

TEST_CASE("where two objects touch, the picture marks it", "[scene]") {
  const auto dot = [](const std::vector<Item>& marks) {
    REQUIRE(marks.size() == 1);
    const Dot* only = std::get_if<Dot>(&marks[0]);
    REQUIRE(only);
    return only->at;
  };
  const auto ball = [](const char* name, const char* center, const char* radius) {
    return std::string(R"({"sphere": ")") + name + R"(", "center": )" + center + R"(, "radius": )" + radius + "}";
  };
  const std::string a = R"({"box": "A", "lo": [0, 0, 0], "hi": [4, 3, 2]})";
  const std::string two = R"(["A", "B"])";
  CHECK(dot(marks_of(ball("A", "[0, 0]", "2") + "," + ball("B", "[3, 4]", "3"), two)).isApprox(Vec3(1.2, 1.6, 0)));
  CHECK(dot(marks_of(a + "," + ball("B", "[2, 2, 5]", "3"), two)).isApprox(Vec3(2, 2, 2)));
  CHECK(dot(marks_of(a + "," + R"({"box": "B", "lo": [4, 3, 2], "hi": [5, 5, 5]})", two)) == Vec3(4, 3, 2));
  CHECK(dot(marks_of(R"({"capsule": "A", "p": [0, 0, 0], "q": [4, 0, 0], "r": 1},
    {"capsule": "B", "p": [2, 3, 0], "q": [2, 6, 0], "r": 2})",
                     two))
            .isApprox(Vec3(2, 1, 0)));

  const std::vector<Item> edge = marks_of(a + "," + R"({"box": "B", "lo": [4, 1, 2], "hi": [6, 5, 5]})", two);
  REQUIRE(edge.size() == 1);
  REQUIRE(std::holds_alternative<Chain>(edge[0]));
  CHECK(std::get<Chain>(edge[0]).points == std::vector<Vec3>{{4, 1, 2}, {4, 3, 2}});
  const std::vector<Item> face = marks_of(a + "," + R"({"box": "B", "lo": [4, 1, 1], "hi": [6, 5, 5]})", two);
  REQUIRE(face.size() == 1);
  REQUIRE(std::holds_alternative<Region>(face[0]));
  CHECK(std::get<Region>(face[0]).rings[0] == std::vector<Vec3>{{4, 1, 1}, {4, 3, 1}, {4, 3, 2}, {4, 1, 2}});

  CHECK(marks_of(a + "," + ball("B", "[9, 9, 9]", "1"), two).empty());
  CHECK(marks_of(a + "," + R"({"box": "B", "lo": [3, 1, 1], "hi": [6, 5, 5]})", two).empty());
}

}  // namespace scene_window_test
