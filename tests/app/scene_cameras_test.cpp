// Cameras of single steps of a scene: in pictures, in animations and in the window.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "app/figures/figure_maker.h"
#include "app/figures/film.h"
#include "app/scene/edit.h"
#include "app/scene/file.h"
#include "app/scene/lesson.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/player/camera_moves.h"

namespace scene_cameras_test {
namespace scene = isect::program::scene;
namespace viz = isect::viz;
using isect::program::Excerpt;
using isect::program::Shot;
using isect::test::Contains;
using isect::test::Ran;
using isect::test::Shell;
using isect::test::write;

namespace {

constexpr double degree = std::numbers::pi / 180;
const std::string balls = R"({"sphere": "A", "center": [-1, 0, 0], "radius": 1},
    {"sphere": "B", "center": [1, 0.5, 0], "radius": 1.5}, {"ray": "r", "origin": [-4, 0, 0], "dir": [1, 0, 0]})";
const std::string near = R"({"azimuth": 80, "elevation": 10, "target": [1, 0, 0], "half_height": 2})";

/// A scene in space whose two questions have these fields besides.
std::string scene_of(const std::string& first, const std::string& second, const std::string& more = "") {
  return "{\"objects\": [" + balls + "],\n\"ask\": [{\"of\": [\"A\", \"B\"]" + first + "},\n{\"first hit\": \"r\"" +
         second + "}]" + more + "}";
}
std::string camera(const std::string& text) { return ", \"camera\": " + text; }

std::string refused(const std::string& text) {
  try {
    scene::read_scene(text, "");
  } catch (const viz::BadInput& e) {
    return e.what();
  }
  return "";
}

Excerpt excerpt_of(const viz::Lesson& lesson) {
  Excerpt e;
  e.lesson = &lesson, e.folder = "s", e.parameters = lesson.presets.front().parameters;
  e.walk = lesson.walk(e.parameters);
  return e;
}

/// How often each kind of shot stands in a film: at rest, on the way.
std::pair<int, int> counts(const std::vector<Shot>& shots) {
  const auto rest = std::ranges::count_if(shots, [](const Shot& s) { return s.share == 1; });
  return {static_cast<int>(rest), static_cast<int>(shots.size()) - static_cast<int>(rest)};
}

/// The seconds of each picture of an APNG, from its frame controls.
std::vector<double> times_of(const std::string& apng) {
  std::vector<double> times;
  const auto two_bytes = [&](std::size_t at) {
    return 256 * static_cast<unsigned char>(apng.at(at)) + static_cast<unsigned char>(apng.at(at + 1));
  };
  for (std::size_t at = apng.find("fcTL"); at != apng.npos; at = apng.find("fcTL", at + 4))
    times.push_back(static_cast<double>(two_bytes(at + 24)) / two_bytes(at + 26));
  return times;
}

}  // namespace

TEST_CASE("a question's step is seen from its own camera, the others from the scene's", "[scene]") {
  const viz::Lesson& lesson = scene::kept_lesson_of(
      scene_of(camera(near), camera(R"({"elevation": 60})"), camera(R"({"azimuth": -20, "perspective": true})")), "");
  const Excerpt e = excerpt_of(lesson);
  REQUIRE(e.walk.steps.size() == 4);
  CHECK_FALSE(e.walk.steps[0].view);
  const auto seen = [&](std::size_t step) { return isect::program::camera_for(e, e.walk.steps[step], 1.6); };
  CHECK(seen(0).azimuth == Approx(-20 * degree));
  CHECK(seen(1).azimuth == Approx(80 * degree));
  CHECK(seen(1).elevation == Approx(10 * degree));
  CHECK(seen(1).target == viz::Vec3(1, 0, 0));
  CHECK(seen(1).half_height == 2);
  CHECK(seen(1).perspective);
  CHECK(seen(2).azimuth == Approx(-20 * degree));  // what it leaves out is the scene's
  CHECK(seen(2).elevation == Approx(60 * degree));
  CHECK(seen(2).half_height > 2);  // all is in the frame
}

TEST_CASE("a camera that a preset's file or --camera gives holds for all steps", "[scene]") {
  const viz::Lesson& lesson = scene::kept_lesson_of(scene_of(camera(near), ""), "");
  Excerpt e = excerpt_of(lesson);
  e.camera = viz::Camera{.azimuth = 1};
  CHECK(isect::program::camera_for(e, e.walk.steps[1], 1.6) == *e.camera);
  CHECK(counts(isect::program::film_of(e, {0, 1, 2}, 2)) == std::pair(3, 0));
}

TEST_CASE("in the plane a step's camera has a place and a scale", "[scene]") {
  const auto flat = [](const std::string& fields) {
    return R"({"objects": [{"circle": "A", "center": [0, 0], "radius": 1}, {"point": "p", "at": [3, 0]}],
 "ask": [{"of": ["A", "p"], "camera": )" +
           fields + "}]}";
  };
  const viz::Lesson& lesson = scene::kept_lesson_of(flat(R"({"target": [3, 0], "half_height": 0.5})"), "");
  const Excerpt e = excerpt_of(lesson);
  const viz::Camera seen = isect::program::camera_for(e, e.walk.steps.at(1), 1.6);
  CHECK(seen.target == viz::Vec3(3, 0, 0));
  CHECK(seen.half_height == 0.5);
  CHECK(seen.azimuth == 0);
  CHECK_THAT(refused(flat(R"({"azimuth": 20})")), Contains("line 2: ask[0].camera.azimuth: ") && Contains("target"));
}

TEST_CASE("a wrong camera is refused with its line and field", "[scene]") {
  const auto with = [](const std::string& fields) { return refused(scene_of("", camera(fields))); };
  const std::string here = "line 4: ask[1].camera";
  CHECK_THAT(with(R"({"elevation": 100})"), Contains(here + ".elevation: -90 to 90 degrees"));
  CHECK_THAT(with(R"({"half_height": 0})"), Contains(here + ".half_height: a length above 0"));
  CHECK_THAT(with(R"({"field_of_view": 180})"), Contains(here + ".field_of_view: 0.5 to 178 degrees"));
  CHECK_THAT(with(R"({"target": [0, 0]})"), Contains(here + ".target: 2 coordinates"));
  CHECK_THAT(with(R"({"perspective": 1})"), Contains(here + ".perspective: true or false"));
  CHECK_THAT(with(R"({"zoom": 2})"), Contains(here + ".zoom: unknown") && Contains("half_height"));
  CHECK_THAT(with("{}"), Contains(here + ": it is empty"));
  CHECK_THAT(with("7"), Contains(here + ": an object in braces"));
}

TEST_CASE("a walk's steps have the camera of its question, and questions with cameras are no group", "[scene]") {
  const viz::Lesson& lesson = scene::kept_lesson_of("{\"objects\": [" + balls + R"(],
 "ask": [["r", "A"], {"walk": ["A", "B"], "camera": {"azimuth": 5}}, ["r", "B"]]})",
                                                    "");
  const Excerpt e = excerpt_of(lesson);
  REQUIRE(e.walk.steps.size() > 5);
  for (std::size_t s = 0; s < e.walk.steps.size(); ++s) {
    const bool of_walk = s >= 2 && s + 2 < e.walk.steps.size();
    CAPTURE(s);
    CHECK(e.walk.steps[s].view.has_value() == of_walk);
  }
}

TEST_CASE("a length stands across the view of its step", "[scene]") {
  const viz::Lesson& lesson = scene::kept_lesson_of("{\"objects\": [" + balls + R"(],
 "camera": {"azimuth": 0, "elevation": 0}, "marks": [{"dimension": ["A.center", [1, 0, 0]]}],
 "ask": [{"of": ["A", "B"], "camera": {"elevation": 90}}]})",
                                                    "");
  const Excerpt e = excerpt_of(lesson);
  const auto depth = [&](std::size_t step) {
    double most = 0;
    for (const viz::Item& item : e.walk.steps.at(step).scene.items)
      if (const viz::Arrow* arrow = std::get_if<viz::Arrow>(&item)) most = std::max(most, std::abs(arrow->to.z()));
    return most;
  };
  CHECK(depth(0) < 1e-9);
  CHECK(depth(1) > 0.1);
}

TEST_CASE("an animation sees the way between cameras in equally many pictures, and none where they are equal",
          "[scene]") {
  const auto film = [](const std::string& first, const std::string& second) {
    const viz::Lesson& lesson = scene::kept_lesson_of(scene_of(first, second), "");
    return isect::program::film_of(excerpt_of(lesson), {0, 1, 2, 3}, 2.5);
  };
  CHECK(counts(film("", "")) == std::pair(4, 0));
  CHECK(counts(film(camera(near), camera(near))) == std::pair(4, 12));  // and none to the card
  const std::vector<Shot> shots = film(camera(near), "");
  CHECK(counts(shots) == std::pair(4, 24));
  CHECK(shots.back().times == 4);
  for (std::size_t i = 1; i < shots.size(); ++i) {
    if (shots[i].share == 1) continue;
    CHECK(shots[i].seconds < 0.1);
    CHECK(shots[i].from != shots[i].step);
    CHECK((shots[i - 1].share == 1 || shots[i - 1].share < shots[i].share));
  }
}

TEST_CASE("in the window the camera moves to the step's own, unless it is the reader's", "[scene]") {
  const viz::Lesson& lesson = scene::kept_lesson_of(
      scene_of(camera(R"({"azimuth": 80, "target": [1, 0, 0], "half_height": 2, "perspective": true})"), ""), "");
  viz::Player player({&lesson});
  const viz::Camera usual = player.camera().goal();
  player.next();
  CHECK(player.camera().moving());
  CHECK(player.camera().goal().half_height == 2);
  CHECK(player.camera().goal().perspective);
  player.advance(0.1);
  const double azimuth = player.camera().now().azimuth;
  CHECK((azimuth > usual.azimuth && azimuth < 80 * degree));
  player.advance(10);
  CHECK(player.camera().now() == player.camera().goal());
  player.back();
  CHECK(player.camera().goal() == usual);

  player.pin_camera(true);
  player.next();
  CHECK(player.camera().goal() == usual);
  player.pin_camera(false);
  player.back();
  orbit(player, {50, 0});
  const viz::Camera own = player.camera().goal();
  player.next();
  CHECK(player.camera().goal() == own);
  frame_all(player);
  CHECK(player.camera().goal().azimuth == Approx(80 * degree));
  player.back();
  CHECK(player.camera().goal() == usual);
}

TEST_CASE("a projection that the reader has chosen stays from step to step", "[scene]") {
  const viz::Lesson& lesson = scene::kept_lesson_of(scene_of(camera(R"({"azimuth": 80})"), ""), "");
  viz::Player player({&lesson});
  set_perspective(player, true);
  frame_all(player);
  player.next();
  CHECK(player.camera().goal().perspective);
  CHECK(player.camera().goal().azimuth == Approx(80 * degree));
}

TEST_CASE("a question's camera stays when the window removes another question", "[scene]") {
  const std::string text = scene_of(camera(near), "");
  CHECK_THAT(scene::without_question(text, scene::Json::parse(R"({"first hit": "r"})")),
             Contains("half_height") && !Contains("first hit"));
  CHECK_THAT(scene::without_question(text, scene::Json::parse(R"(["A", "B"])")),
             Contains("first hit") && !Contains("half_height"));
}

TEST_CASE("pictures and animations of a scene use the cameras of its steps", "[scene]") {
  const Shell shell;
  write(shell.work() / "plain.json", scene_of("", ""));
  write(shell.work() / "turned.json", scene_of(camera(near), ""));
  const auto svg = [&](const std::string& file, int step) {
    const Ran r = shell("isect render " + file + " --format svg --step " + std::to_string(step) + " --out -");
    REQUIRE(r.status == 0);
    return r.out.substr(r.out.find("<title"));
  };
  CHECK(svg("plain.json", 1) == svg("turned.json", 1));
  CHECK(svg("plain.json", 2) != svg("turned.json", 2));

  const std::string film = " --format apng --size 320x200 --seconds 1 --out -";
  CHECK(times_of(shell("isect render plain.json" + film).out).size() == 7);  // the card counts four times
  const std::vector<double> times = times_of(shell("isect render turned.json" + film).out);
  REQUIRE(times.size() == 31);
  CHECK(times[0] == 1);
  CHECK(times[1] == 0.04);
  CHECK(times[13] == 1);

  write(shell.work() / "wrong.json", scene_of(camera(R"({"half_height": -1})"), ""));
  const Ran r = shell("isect render wrong.json");
  CHECK(r.status == 2);
  CHECK_THAT(r.err, Contains("wrong.json: line 3: ask[0].camera.half_height"));
}

}  // namespace scene_cameras_test
