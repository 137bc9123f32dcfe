// Places as JSON and in figures: what is written is read back, and what is wrong is named.

#include "viz/place.h"

#include "tests/catch.h"
#include "tests/viz/toy_lesson.h"

namespace place_test {
using namespace isect::viz;
using isect::test::Contains;
using isect::test::toy;

namespace {

const std::vector<const Lesson*> lessons = {&toy()};
Place read(const std::string& text) { return place_from_json(text, lessons); }

Place full_place() {
  Camera camera;
  camera.target = Vec3(0.1, 2, -3);
  camera.azimuth = 1.0 / 3;
  camera.perspective = true;
  Parameters parameters = toy().presets[1].parameters;
  parameters["radius"] = 0.1;
  return {"toy", "", 2, parameters, camera};
}

void check_same(const Place& a, const Place& b) {
  CHECK(a.lesson == b.lesson);
  CHECK(a.preset == b.preset);
  CHECK(a.step == b.step);
  CHECK(a.parameters.value() == b.parameters.value());
  REQUIRE(a.camera.has_value() == b.camera.has_value());
  if (!a.camera) return;
  CHECK(a.camera->target == b.camera->target);
  CHECK(a.camera->azimuth == b.camera->azimuth);
  CHECK(a.camera->elevation == b.camera->elevation);
  CHECK(a.camera->half_height == b.camera->half_height);
  CHECK(a.camera->perspective == b.camera->perspective);
  CHECK(a.camera->field_of_view == b.camera->field_of_view);
}

}  // namespace

TEST_CASE("a place goes through JSON and through a figure's metadata unchanged", "[place]") {
  const Place place = full_place();
  check_same(read(to_json(place)), place);
  check_same(place_from_metadata(metadata(place), lessons), place);

  const Place preset{"toy", "far", 1, toy().presets[1].parameters, {}};
  check_same(read(to_json(preset)), preset);
  check_same(place_from_metadata(metadata(preset), lessons), preset);
  CHECK(metadata(preset).at("version") == version());
  CHECK(metadata(preset).at("step") == "2");  // counted from 1, as people do
}

TEST_CASE("what a file leaves out comes from the preset, or from the lesson", "[place]") {
  CHECK(std::get<Vec3>(read(R"({"lesson": "toy", "preset": "far"})").parameters->at("origin")) == Vec3(2, 0, 0));
  const Place changed = read(R"({"lesson": "toy", "parameters": {"radius": 3}})");
  CHECK(std::get<double>(changed.parameters->at("radius")) == 3);
  CHECK(std::get<Vec3>(changed.parameters->at("origin")) == Vec3(0, 0, 0));
  CHECK_FALSE(changed.step);  // the walk as a whole
  CHECK_FALSE(changed.camera);
  CHECK_THAT(to_json(changed), !Contains("step"));
  const Place seen = read(R"({"lesson": "toy", "camera": {"half_height": 2}})");
  CHECK(seen.camera->half_height == 2);
  CHECK(seen.camera->azimuth == toy().camera.azimuth);
}

TEST_CASE("a wrong field of a place is named", "[place]") {
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
  for (const std::string camera : {"3", R"({"target": 1})", R"({"half_height": 0})", R"({"elevation": 2})",
                                   R"({"perspective": 1})", R"({"azimut": 1})"})
    CHECK_THROWS_WITH(read(R"({"lesson": "toy", "camera": )" + camera + "}"), Contains("camera"));
}

TEST_CASE("a flat lesson's camera does not turn", "[place]") {
  Lesson flat = toy();
  flat.flat = true;
  const std::vector<const Lesson*> one = {&flat};
  CHECK(place_from_json(R"({"lesson": "toy", "camera": {"half_height": 2}})", one).camera->azimuth == 0);
  for (const std::string turned : {R"({"azimuth": 0.5})", R"({"elevation": 1})", R"({"perspective": true})"})
    CHECK_THROWS_WITH(place_from_json(R"({"lesson": "toy", "camera": )" + turned + "}", one),
                      Contains("camera") && Contains("straight on"));
}

TEST_CASE("a figure of another program is refused", "[place]") {
  CHECK_THROWS_WITH(place_from_metadata({{"Software", "other"}}, lessons), Contains("not made by isect"));
  CHECK_THROWS_WITH(place_from_metadata({{"lesson", "toy"}, {"step", "x"}}, lessons), Contains("step"));
  CHECK_THROWS_WITH(place_from_metadata({{"lesson", "toy"}, {"parameters", "{"}}, lessons), Contains("parameters"));
}

TEST_CASE("JSON that nests without end is refused, wherever it stands", "[place]") {
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  for (const std::string& text : {deep, std::string(100000, '['), "{\"lesson\": " + deep + "}",
                                  "{\"lesson\": \"toy\", \"parameters\": {\"x\": " + deep + "}}"})
    CHECK_THROWS_WITH(place_from_json(text, lessons), Contains("nested more than 16 levels deep"));
  CHECK_THROWS_WITH(place_from_metadata({{"lesson", "toy"}, {"camera", deep}}, lessons), Contains("camera: nested"));
}

}  // namespace place_test
