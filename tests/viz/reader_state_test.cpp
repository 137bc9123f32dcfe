// Places as JSON and in figures: what is written is read back, and what is wrong is named.

#include "viz/player/reader_state.h"

#include <cmath>
#include <numbers>

#include "bench/random.h"
#include "tests/catch.h"
#include "tests/settings.h"
#include "tests/viz/moving_lesson.h"
#include "tests/viz/toy_lesson.h"
#include "viz/compose/compose.h"
#include "viz/player/direction.h"

namespace reader_state_test {
using namespace isect::viz;
using isect::test::Contains;
using isect::test::toy;

namespace {

const std::vector<const Lesson*> lessons = {&toy()};
ReaderState read(const std::string& text) { return reader_state_from_json(text, lessons); }

ReaderState full_place() {
  Camera camera;
  camera.target = Vec3(0.1, 2, -3);
  camera.azimuth = 1.0 / 3;
  camera.perspective = true;
  Parameters parameters = toy().presets[1].parameters;
  parameters["radius"] = 0.1;
  return {"toy", "", 2, parameters, camera};
}

void check_same(const ReaderState& a, const ReaderState& b) {
  CHECK(a.lesson == b.lesson);
  CHECK(a.preset == b.preset);
  CHECK(a.step == b.step);
  CHECK(a.parameters.value() == b.parameters.value());
  REQUIRE(a.camera.has_value() == b.camera.has_value());
  if (!a.camera) return;
  CHECK(a.camera->target == b.camera->target);
  CHECK_THAT(a.camera->azimuth, Catch::Matchers::WithinULP(b.camera->azimuth, 1));  // not all angles are degrees
  CHECK_THAT(a.camera->elevation, Catch::Matchers::WithinULP(b.camera->elevation, 1));
  CHECK(a.camera->half_height == b.camera->half_height);
  CHECK(a.camera->perspective == b.camera->perspective);
  CHECK_THAT(a.camera->field_of_view, Catch::Matchers::WithinULP(b.camera->field_of_view, 1));
}

ReaderState seen(const std::string& camera) { return read("{\"lesson\": \"toy\", \"camera\": " + camera + "}"); }

}  // namespace

TEST_CASE("a place goes through JSON and through a figure's metadata unchanged", "[reader_state]") {
  const ReaderState state = full_place();
  check_same(read(to_json(state)), state);
  check_same(reader_state_from_metadata(metadata(state), lessons), state);

  const ReaderState preset{"toy", "far", 1, toy().presets[1].parameters, {}};
  check_same(read(to_json(preset)), preset);
  check_same(reader_state_from_metadata(metadata(preset), lessons), preset);
  CHECK(metadata(preset).at("version") == version());
  CHECK(metadata(preset).at("step") == "2");  // counted from 1, as people do
}

TEST_CASE("a camera's angles are degrees, and those that were typed come back as they were", "[reader_state]") {
  const Camera degrees = *seen(R"({"azimuth": 70, "elevation": 35, "field_of_view": 30})").camera;
  CHECK(degrees.azimuth == 70 * std::numbers::pi / 180);
  CHECK(degrees.elevation == 35 * std::numbers::pi / 180);
  CHECK(degrees.field_of_view == 30 * std::numbers::pi / 180);
  CHECK_THAT(to_json(ReaderState{"toy", "", {}, {}, Camera{}}),
             Contains(R"("angles":"degrees")") && Contains(R"("azimuth":30.0)") && Contains(R"("elevation":22.0)") &&
                 Contains(R"("field_of_view":35.0)"));
  CHECK(seen(R"({"elevation": 90})").camera->elevation == std::numbers::pi / 2);

  isect::bench::Random random(isect::bench::stream(isect::tests::seed(), "camera"));
  for (int i = 0; i < 10000; ++i) {
    ReaderState state = full_place();
    state.camera->azimuth = random.uniform(-7, 7), state.camera->elevation = random.uniform(-1.5, 1.5);
    const ReaderState once = read(to_json(state)), twice = read(to_json(once));
    CHECK_THAT(std::remainder(once.camera->azimuth - state.camera->azimuth, 2 * std::numbers::pi),
               Catch::Matchers::WithinAbs(0, 2e-15));
    CHECK(once.camera->elevation == twice.camera->elevation);  // nothing drifts
    CHECK(once.camera->azimuth == twice.camera->azimuth);
  }
}

TEST_CASE("a camera from before angles were degrees is read as it was", "[reader_state]") {
  const Camera old = *seen(R"({"target":[0.1,2.0,-3.0],"azimuth":0.52359877559829882,"elevation":-1.25,
                               "half_height":2.5,"perspective":true,"field_of_view":0.6108652381980153})")
                          .camera;
  CHECK(old.azimuth == 0.52359877559829882);
  CHECK(old.elevation == -1.25);
  CHECK(old.field_of_view == 0.6108652381980153);
  CHECK(reader_state_from_metadata({{"lesson", "toy"}, {"camera", R"({"azimuth":70.0,"field_of_view":0.61})"}}, lessons)
            .camera->azimuth == 70);
  CHECK(seen(R"({"angles": "radians", "azimuth": 0.5})").camera->azimuth == 0.5);
  CHECK(seen(R"({"angles": "degrees", "azimuth": 0.5})").camera->azimuth == 0.5 * std::numbers::pi / 180);

  // What people wrote themselves can be either where all angles are small; nobody guesses.
  for (const std::string small : {R"({"azimuth": 0.5, "elevation": 1.25})", R"({"elevation": -1, "half_height": 2})"})
    CHECK_THROWS_WITH(seen(small), Contains("can be degrees, or radians as in older files") &&
                                       Contains("\"angles\": \"degrees\" or \"angles\": \"radians\""));
  for (const std::string sure : {R"({"azimuth": 0, "elevation": 0})", R"({"azimuth": 1, "elevation": 20})"})
    CHECK_NOTHROW(seen(sure));
}

TEST_CASE("messages about angles name the unit", "[reader_state]") {
  CHECK_THROWS_WITH(seen(R"({"elevation": 95})"),
                    Contains("camera elevation: 95") && Contains("degrees from -90 to 90"));
  CHECK_THROWS_WITH(seen(R"({"azimuth": 361})"), Contains("degrees from -360 to 360"));
  CHECK_THROWS_WITH(seen(R"({"field_of_view": 179})"), Contains("degrees from 0.5 to 178"));
  CHECK_THROWS_WITH(seen(R"({"elevation": 35, "field_of_view": 0.6})"), Contains("radians from -1.57"));
  CHECK_THROWS_WITH(seen(R"({"angles": "degress", "azimuth": 3})"), Contains("mean \"degrees\""));
}

TEST_CASE("a camera with nothing but a direction has all in its frame, and keeps it", "[reader_state]") {
  const ReaderState turned = seen(R"({"azimuth": 70, "elevation": 35})");
  const Walk walk = toy().walk(*turned.parameters);
  for (const Step& step : walk.steps) {
    const Box2 box = extent(step.scene.items, *turned.camera);
    CHECK(box.hi.y() - box.lo.y() <= 2 * turned.camera->half_height);
    CHECK(box.hi.x() - box.lo.x() <= 2 * turned.camera->half_height * 1.6);
  }
  CHECK(turned.camera == seen_from(toy(), walk, 70, 35));
  check_same(read(to_json(turned)), turned);
  check_same(reader_state_from_metadata(metadata(turned), lessons), turned);
  CHECK(seen(R"({"azimuth": 70, "half_height": 2})").camera->half_height == 2);
  // A camera that does not give the direction, or gives it in radians, is read as it always was.
  for (const std::string plain : {R"({"perspective": true})", R"({"angles": "radians", "azimuth": 0.5})"})
    CHECK(seen(plain).camera->half_height == opening(toy()).half_height);
}

TEST_CASE("what a file leaves out comes from the preset, or from the lesson", "[reader_state]") {
  CHECK(std::get<Vec3>(read(R"({"lesson": "toy", "preset": "far"})").parameters->at("origin")) == Vec3(2, 0, 0));
  const ReaderState changed = read(R"({"lesson": "toy", "parameters": {"radius": 3}})");
  CHECK(std::get<double>(changed.parameters->at("radius")) == 3);
  CHECK(std::get<Vec3>(changed.parameters->at("origin")) == Vec3(0, 0, 0));
  CHECK_FALSE(changed.step);  // the walk as a whole
  CHECK_FALSE(changed.camera);
  CHECK_THAT(to_json(changed), !Contains("step"));
  const ReaderState seen = read(R"({"lesson": "toy", "camera": {"half_height": 2}})");
  CHECK(seen.camera->half_height == 2);
  CHECK(seen.camera->azimuth == toy().camera.azimuth);
}

TEST_CASE("a wrong field of a place is named", "[reader_state]") {
  CHECK_THROWS_WITH(read(""), Contains("not JSON"));
  CHECK_THROWS_WITH(read(R"({"lesson": "toy",)"), Contains("not JSON") && Contains("line 1"));
  CHECK_THROWS_WITH(read("[1]"), Contains("no JSON object"));
  CHECK_THROWS_WITH(read("{}"), Contains("lesson: missing"));
  CHECK_THROWS_WITH(read(R"({"lesson": 7})"), Contains("lesson") && Contains("7"));
  CHECK_THROWS_WITH(read(R"({"lesson": "tyo"})"), Contains("lesson") && Contains("mean \"toy\""));
  CHECK_THROWS_WITH(read(R"({"lesson": "toy", "preset": "fra"})"), Contains("preset") && Contains("mean \"far\""));
  CHECK_THROWS_WITH(read(R"({"lesson": "toy", "paramters": {}})"), Contains("mean \"parameters\""));
  CHECK_THROWS_WITH(read(R"({"lesson": "toy", "parameters": 1})"), Contains("parameters"));
  CHECK_THROWS_WITH(read(R"({"lesson": "toy", "parameters": {"radus": 1}})"), Contains("mean \"radius\""));
  CHECK_THROWS_WITH(read(R"({"lesson": "toy", "parameters": {"radius": 1e999}})"), Contains("not JSON"));
  CHECK_THROWS_WITH(read(R"({"lesson": "toy", "parameters": {"radius": -1}})"), Contains("radius"));
  CHECK_THROWS_WITH(read(R"({"lesson": "toy", "parameters": {"radius": null}})"), Contains("radius"));
  CHECK_THROWS_WITH(read(R"({"lesson": "toy", "parameters": {"origin": [1, 2]}})"), Contains("origin"));
  CHECK_THROWS_WITH(read(R"({"lesson": "toy", "parameters": {"origin": [1, 2, "x"]}})"), Contains("origin"));
  for (const std::string step : {"0", "4", "-1", "1.5", "\"2\"", "99999999999999999999"})
    CHECK_THROWS_WITH(read(R"({"lesson": "toy", "step": )" + step + "}"), Contains("step") && Contains("1 to 3"));
  for (const std::string camera : {"3", R"({"target": 1})", R"({"half_height": 0})", R"({"elevation": 95})",
                                   R"({"perspective": 1})", R"({"azimut": 1})"})
    CHECK_THROWS_WITH(read(R"({"lesson": "toy", "camera": )" + camera + "}"), Contains("camera"));
}

TEST_CASE("a time goes with its step, through JSON and a figure, and is within the step's motion", "[reader_state]") {
  const Lesson moves = moving::lesson();
  const std::vector<const Lesson*> one = {&moves};
  const auto at = [&](const std::string& fields) {
    return reader_state_from_json("{\"lesson\": \"dot-moves\"" + fields + "}", one);
  };
  const ReaderState state = {"dot-moves", "usual", 1, moves.presets[0].parameters, {}, {}, 0.1};
  CHECK_THAT(to_json(state), Contains("\"step\": 2,\n  \"time\": 0.1"));
  CHECK(reader_state_from_json(to_json(state), one).time == 0.1);
  CHECK(metadata(state).at("time") == "0.1");
  CHECK(reader_state_from_metadata(metadata(state), one).time == 0.1);
  CHECK(at(R"(, "step": 3, "time": 2)").time == 2);
  CHECK(at(R"(, "step": 1, "time": 5, "parameters": {"duration": 6})").time == 5);
  CHECK_FALSE(at(R"(, "step": 3)").time);

  CHECK_THROWS_WITH(at(R"(, "time": 1)"), Contains("time: of which step"));
  CHECK_THROWS_WITH(at(R"(, "step": 4, "time": 1)"), Contains("time: nothing moves at step 4"));
  for (const std::string wrong : {"2.0001", "-0.5", "\"1\"", "null", "[1]"})
    CHECK_THROWS_WITH(at(R"(, "step": 1, "time": )" + wrong), Contains("time: " + wrong) && Contains("from 0 to 2"));
  CHECK_THROWS_WITH(reader_state_from_metadata({{"lesson", "dot-moves"}, {"step", "1"}, {"time", "x"}}, one),
                    Contains("time: not JSON"));
  const Walk walk = moves.walk(moves.presets[0].parameters);
  CHECK(checked_time(walk, 2, 0.25) == 0.25);
  CHECK_THROWS_WITH(checked_time(walk, 2, NAN), Contains("from 0 to 2"));
}

TEST_CASE("a flat lesson's camera does not turn", "[reader_state]") {
  Lesson flat = toy();
  flat.flat = true;
  const std::vector<const Lesson*> one = {&flat};
  CHECK(reader_state_from_json(R"({"lesson": "toy", "camera": {"half_height": 2}})", one).camera->azimuth == 0);
  for (const std::string turned : {R"({"azimuth": 0.5})", R"({"elevation": 1})", R"({"perspective": true})"})
    CHECK_THROWS_WITH(reader_state_from_json(R"({"lesson": "toy", "camera": )" + turned + "}", one),
                      Contains("camera") && Contains("straight on"));
}

TEST_CASE("a figure of another program is refused", "[reader_state]") {
  CHECK_THROWS_WITH(reader_state_from_metadata({{"Software", "other"}}, lessons), Contains("not made by isect"));
  CHECK_THROWS_WITH(reader_state_from_metadata({{"lesson", "toy"}, {"step", "x"}}, lessons), Contains("step"));
  CHECK_THROWS_WITH(reader_state_from_metadata({{"lesson", "toy"}, {"parameters", "{"}}, lessons),
                    Contains("parameters"));
}

TEST_CASE("JSON that nests without end is refused, wherever it stands", "[reader_state]") {
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  for (const std::string& text : {deep, std::string(100000, '['), "{\"lesson\": " + deep + "}",
                                  "{\"lesson\": \"toy\", \"parameters\": {\"x\": " + deep + "}}"})
    CHECK_THROWS_WITH(reader_state_from_json(text, lessons), Contains("nested more than 16 levels deep"));
  CHECK_THROWS_WITH(reader_state_from_metadata({{"lesson", "toy"}, {"camera", deep}}, lessons),
                    Contains("camera: nested"));
}

}  // namespace reader_state_test
