// Marks in a scene's picture: computed points, exact lengths and angles, and what is told where there is none.

#include <cmath>

#include "app/scene/edit.h"
#include "app/scene/exact_points.h"
#include "app/scene/lesson.h"
#include "tests/app/refusals.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/text/rich_text.h"

namespace scene_marks_test {
namespace scene = isect::program::scene;
namespace viz = isect::viz;
using namespace isect::test;
using viz::Vec3;

namespace {

const std::string objects =
    R"({"circle": "S", "center": [0, 0], "radius": 5}, {"circle": "T", "center": [8, 0], "radius": 5},
  {"ray": "r", "origin": [-9, 3], "dir": [1, 0]}, {"segment": "s", "from": [-8, -4], "to": [6, -4]},
  {"point": "p", "at": [0, 1]})";

std::string scene_of(const std::string& marks, const std::string& more = "") {
  return "{\"objects\": [" + objects + "],\n\"ask\": [[\"r\", \"S\"], [\"p\", \"S\"]],\n\"marks\": [" + marks + "]" +
         more + "}";
}

viz::Walk walk_of(const std::string& text) {
  const viz::Lesson lesson = scene::lesson_of(text, "");
  return lesson.walk(lesson.presets.front().parameters);
}

/// Returns the text of each label that is none of an object.
std::vector<std::string> labels(const viz::Step& step) {
  std::vector<std::string> all;
  for (const viz::Item& item : step.scene.items)
    if (const viz::Label* label = std::get_if<viz::Label>(&item))
      if (const std::string text = viz::plain(label->text); std::string("STrsp").find(text) == std::string::npos)
        all.push_back(text);
  return all;
}

/// Returns where the label stands.
Vec3 place_of(const viz::Step& step, const std::string& text) {
  for (const viz::Item& item : step.scene.items)
    if (const viz::Label* label = std::get_if<viz::Label>(&item); label && viz::plain(label->text) == text)
      return label->at;
  FAIL("no label " << text);
  return Vec3::Zero();
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("lengths and angles are told exactly where they are rational, and as about so large elsewhere", "[scene]") {
  const auto length = [](const Vec3& a, const Vec3& b) {
    return scene::length_text(scene::exact_point(a), scene::exact_point(b));
  };
  CHECK(length({0, 0, 0}, {3, 4, 0}) == "5");
  CHECK(length({1, 1, 1}, {2, 3, 3}) == "3");
  CHECK(length({0, 0, 0}, {0.75, 1, 0}) == "1.25");
  CHECK(length({0, 0, 0}, {2, 3, 0}) == "≈ 3.6056");
  CHECK(length({2, 2, 2}, {2, 2, 2}) == "0");
  CHECK(length({0, 0, 0}, {3, 4 + 0x1p-40, 0}).starts_with("≈ "));  // a double can't tell it from 5, or hardly
  CHECK(length({-1e300, 0, 0}, {1e300, 0, 0}) == "2e+300");
  scene::ExactPoint third = scene::exact_point({5, 0, 0});
  third.w = isect::Exact(3.0);
  CHECK(scene::length_text(scene::exact_point({0, 0, 0}), third) == "5/3");

  const auto angle = [](const Vec3& u, const Vec3& v) {
    return scene::angle_text(scene::exact_vector(u), scene::exact_vector(v));
  };
  CHECK(angle({1, 2, 3}, {3, 0, -1}) == "90°");
  CHECK(angle({1, 0, 0}, {2, 2, 0}) == "45°");
  CHECK(angle({1, 1, 0}, {0, 1, 1}) == "60°");
  CHECK(angle({1, 1, 0}, {-1, 0, -1}) == "120°");
  CHECK(angle({1, 0, 0}, {-3, 3, 0}) == "135°");
  CHECK(angle({1, 1, 0}, {2, 1, 1}) == "30°");
  CHECK(angle({1, 2, 0}, {-2, -4, 0}) == "180°");
  CHECK(angle({3, 4, 0}, {1, 0, 0}) == "≈ 53.13°");
  CHECK(angle({1, 0, 0}, {0x1p-60, 1, 0}) != "90°");
  CHECK_FALSE(scene::is_right(scene::exact_vector({1, 0, 0}), scene::exact_vector({0x1p-60, 1, 0})));
  CHECK(scene::is_right(scene::exact_vector({1e200, 1, 0}), scene::exact_vector({-1, 1e200, 0})));
}

TEST_CASE("feet and meeting points are exact, and lie where they must", "[scene]") {
  const scene::ExactPoint p = scene::exact_point({1, 2, 2});
  const scene::ExactVector origin = scene::exact_vector({0, 0, 0}), dir = scene::exact_vector({1, 1, 1});
  const scene::ExactPoint foot = scene::foot_on_line(p, origin, dir, {}, {});
  CHECK(scene::is_right(scene::from_to(foot, p), dir));  // at 5/3, which is no double
  CHECK(scene::length_text(foot, scene::exact_point({0, 0, 0})).starts_with("≈ 2.8868"));
  CHECK(scene::nearest_doubles(scene::foot_on_line(p, origin, dir, 2.0, {})) == Vec3(2, 2, 2));
  CHECK(scene::nearest_doubles(scene::foot_on_line(p, origin, dir, 0.0, 1.0)) == Vec3(1, 1, 1));
  const scene::ExactVector n = scene::exact_vector({1, 2, 2});
  const scene::ExactPoint on_plane = scene::foot_on_plane(p, n, isect::Exact(-3.0));
  CHECK((scene::dot(n, on_plane.x) - isect::Exact(3.0) * on_plane.w).sign() == 0);
  CHECK(scene::length_text(on_plane, p) == "2");
  const auto met = scene::meeting(origin, scene::exact_vector({-1, 0, 1}), n, isect::Exact(-3.0));
  REQUIRE(met);
  CHECK(met->w.sign() > 0);
  CHECK(scene::nearest_doubles(*met) == Vec3(-3, 0, 3));
  CHECK_FALSE(scene::meeting(origin, scene::exact_vector({2, -1, 0}), n, isect::Exact(-3.0)));
}

TEST_CASE("marks stand at places of objects and of the core's answers", "[scene]") {
  const viz::Walk walk = walk_of(scene_of(R"({"point": "q", "at": "r x S"}, {"point": "q2", "at": "r x S", "nth": 2},
    {"point": "f", "at": "foot of p on s"}, {"point": "c", "at": "S x T"}, {"point": "g", "at": "foot of p on T"},
    {"dimension": ["q", "q2"], "label": "*chord*"}, {"dimension": ["p", "f"]}, {"dimension": ["S.center", "T.center"]},
    {"angle": ["s.to", "f", [6, 6]]}, {"right angle": ["p", "f", "s.to"], "label": "90°"}, {"arrow": ["p", [3, 1]], "label": "v"},
    {"brace": ["s.from", "f"], "label": "b"}, {"line": ["S.center", "T.center"]})"));
  const viz::Step& s = walk.steps[0];
  CHECK(labels(s) == Texts{"q", "q₂", "f", "c", "g", "chord", "5", "8", "≈ 59.036°", "90°", "v", "b"});
  CHECK(place_of(s, "q").isApprox(Vec3(-4, 3, 0)));
  CHECK(place_of(s, "q₂").isApprox(Vec3(4, 3, 0)));
  CHECK(place_of(s, "f") == Vec3(0, -4, 0));
  CHECK(place_of(s, "c").isApprox(Vec3(4, 3, 0)));
  const Vec3 g = place_of(s, "g");
  CHECK((g - Vec3(8, 0, 0)).norm() == Approx(5));
  CHECK_THAT(viz::plain(walk.alt), Contains("Marked:") && Contains("the length from p to f: 5") &&
                                       Contains("the right angle at f between p and s.to"));
  for (const std::size_t i : {1, 2}) CHECK(labels(walk.steps[i]).size() >= 12);
}

TEST_CASE("marks follow a drag, and what is there no more is told and not drawn", "[scene]") {
  const viz::Lesson lesson = scene::lesson_of(
      scene_of(
          R"({"point": "q", "at": "r x S"}, {"dimension": ["q", "S.center"]}, {"right angle": ["p", "S.center", "T.center"], "to step": 1},
      {"point": "f", "at": "foot of p on s"}, {"dimension": ["p", "f"]})"),
      "");
  viz::Parameters now = lesson.presets.front().parameters;
  viz::set(lesson, now, "p.at", "0,3.5");
  viz::set(lesson, now, "r.origin", "-9,6");
  const viz::Walk walk = lesson.walk(now);
  CHECK(labels(walk.steps[0]) == Texts{"f", "7.5"});
  CHECK_THAT(viz::plain(walk.steps[0].caption),
             Contains("Not drawn is the point q, where r and S meet: r misses S.") &&
                 Contains("Not drawn is the length from q to S.center: r misses S."));
}

TEST_CASE("a right angle that is none is refused with the true angle", "[scene]") {
  CHECK(refused(scene_of(R"({"right angle": ["p", "S.center", "T.center"]})")).empty());
  CHECK_THAT(refused(scene_of(R"({"right angle": ["p", "s.to", "s.from"]})")),
             Contains("line 5: marks[0]: ") && Contains("it is ≈ 39.806°"));
  CHECK_THAT(refused(scene_of(R"({"point": "q", "at": "r x S"}, {"right angle": ["p", "q", [-9, 3]]})")),
             Contains("marks[1]"));
}

TEST_CASE("what is wrong with a mark is told by line and field", "[scene]") {
  CHECK_THAT(refused(scene_of(R"({"dimention": ["p", "s.to"]})")), Contains("did you mean \"dimension\"?"));
  CHECK_THAT(refused(scene_of(R"({"arrow": ["p", "s.too"]})")),
             Contains("line 5: marks[0].arrow[1]") && Contains("did you mean \"to\"?"));
  CHECK_THAT(refused(scene_of(R"({"arrow": ["p", "S"]})")), Contains("such as \"S.center\""));
  CHECK_THAT(refused(scene_of(R"({"arrow": ["p", "r and S"]})")), Contains("a place is expected"));
  CHECK_THAT(refused(scene_of(R"({"arrow": ["p"]})")), Contains("2 places are expected"));
  CHECK_THAT(refused(scene_of(R"({"arrow": ["p", [1, 2, 3]]})")), Contains("3 coordinates"));
  CHECK_THAT(refused(scene_of(R"({"arrow": ["p", [1, 2]], "lable": "x"})")), Contains("did you mean \"label\"?"));
  CHECK_THAT(refused(scene_of(R"({"arrow": ["p", [1, 2]], "color": "teal"})")),
             Contains("first, second, text or muted"));
  CHECK_THAT(refused(scene_of(R"({"point": "p", "at": [1, 2]})")), Contains("another object or mark"));
  CHECK_THAT(refused(scene_of(R"({"point": "q", "at": "foot of p on s", "nth": 2})")), Contains("marks[0].nth"));
  CHECK_THAT(refused(scene_of(R"({"line": ["q", "p"]}, {"point": "q", "at": "r x S"})")), Contains("\"q\""));
  CHECK_THAT(refused(scene_of(R"({"arrow": ["p", [1, 2]], "from step": 3, "to step": 2})")),
             Contains("below \"from step\""));
  CHECK_THAT(refused(scene_of(R"({"arrow": ["p", [1, 2]], "from step": 0})")), Contains("the number of a step"));
}

TEST_CASE("marks and objects are drawn in the steps that their author says", "[scene]") {
  const std::string marks = R"({"arrow": ["p", [3, 1]], "label": "v", "from step": 2, "to step": 2})";
  const viz::Walk walk = walk_of(scene_of(marks));
  CHECK(labels(walk.steps[0]).empty());
  CHECK(labels(walk.steps[1]) == Texts{"v"});
  CHECK(labels(walk.steps[2]).empty());

  const viz::Walk late = walk_of(R"({"objects": [{"circle": "A", "center": [0, 0], "radius": 1},
    {"circle": "B", "center": [3, 0], "radius": 1, "from step": 3}, {"point": "p", "at": [0, 0], "to step": 1}],
    "ask": [["A", "p"], ["A", "B"], ["p", "B"]]})");
  const auto names = [](const viz::Step& step) {
    std::string all;
    for (const viz::Item& item : step.scene.items)
      if (const viz::Label* label = std::get_if<viz::Label>(&item)) all += viz::plain(label->text);
    return all;
  };
  CHECK(names(late.steps[0]) == "Ap");
  CHECK(names(late.steps[1]) == "Ap");  // it asks about p
  CHECK(names(late.steps[2]) == "AB");
  CHECK(names(late.steps[3]) == "ABp");
}

TEST_CASE("marks that tell an answer are left out while answers are hidden", "[scene]") {
  const std::string marks =
      R"({"point": "q", "at": "r x S"}, {"dimension": ["q", "S.center"]}, {"dimension": ["p", "S.center"]})";
  CHECK(labels(walk_of(scene_of(marks)).steps[1]).size() >= 3);
  CHECK(labels(walk_of(scene_of(marks, ", \"answers\": \"hidden\"")).steps[1]) == Texts{"1"});
}

TEST_CASE("an object's name changes in marks, too, and with an object its marks go", "[scene]") {
  const std::string text =
      scene_of(R"({"point": "q", "at": "r x S"}, {"arrow": ["q", "S.center"]}, {"arrow": ["p", "s.to"]})");
  const std::string renamed = scene::with_name(text, "S", "Ball");
  CHECK_THAT(renamed, Contains("\"r x Ball\"") && Contains("\"Ball.center\"") && Contains("\"s.to\""));
  CHECK(refused(renamed).empty());
  const std::string without = scene::without_object(text, "r");
  CHECK_THAT(without, !Contains("\"point\": \"q\"") && !Contains("S.center") && Contains("\"s.to\""));
  CHECK(refused(without).empty());
}

TEST_CASE("marks are drawn in every format, in the plane and in space", "[scene]") {
  const Shell shell;
  write(shell.work() / "plane.json", scene_of(R"({"point": "q", "at": "r x S"}, {"dimension": ["p", "S.center"]},
    {"angle": ["p", "S.center", "q"]}, {"brace": ["s.from", "s.to"], "label": "*s*"})"));
  write(shell.work() / "space.json", R"({"objects": [{"plane": "E", "normal": [0, 1, 0], "d": 0},
    {"point": "p", "at": [1, 2, 1]}, {"sphere": "S", "center": [3, 0, 0], "radius": 1}],
    "marks": [{"point": "f", "at": "foot of p on E"}, {"line": ["p", "f"]}, {"right angle": ["p", "f", [2, 0, 1]]},
      {"dimension": ["p", "f"]}, {"point": "g", "at": "foot of p on S"}, {"angle": ["p", "f", "g"]}]})");
  for (const std::string theme : {"screen", "print", "grey", "dark"}) {
    const Ran r = shell("isect render plane.json space.json --step 1 --format png,svg,pdf,tikz --theme " + theme);
    INFO(r.err);
    CHECK(r.status == 0);
  }
  CHECK_THAT(contents(shell.work() / "figures/scene/space/01-objects.svg"),
             Contains("right angle at f between p and (2, 0, 1)"));
  CHECK_THAT(contents(shell.work() / "figures/scene/plane/01-objects.svg"), Contains("Marked: the point q, "));
  CHECK_THAT(shell("isect explain plane.json").out, Contains("Marked:"));
}

}  // namespace scene_marks_test
