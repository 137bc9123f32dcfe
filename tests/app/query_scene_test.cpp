// Whole scenes as lines of `isect query`, and what --strict refuses.

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "tests/app/shell.h"
#include "tests/catch.h"

namespace query_scene_test {
using namespace isect::test;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

/// The replies to some lines, and the exit status.
class Asked {
 public:
  Asked(const Shell& shell, const std::string& lines, const std::string& options = "") {
    write(shell.work() / "cases", lines);
    const Ran ran = shell("isect query cases " + options);
    INFO(ran.err);
    status = ran.status;
    std::istringstream out(ran.out);
    for (std::string line; std::getline(out, line);) replies.push_back(Json::parse(line));
  }

  int status;
  std::vector<Json> replies;
};

/// The only reply to a line.
Json reply(const Shell& shell, const std::string& line, const std::string& options = "") {
  const Asked asked(shell, line, options);
  REQUIRE(asked.replies.size() == 1);
  CHECK(asked.status == (asked.replies[0].contains("error") ? 1 : 0));
  return asked.replies[0];
}
std::string error(const Shell& shell, const std::string& line, const std::string& options = "") {
  const Json told = reply(shell, line, options);
  INFO(told.dump());
  REQUIRE(told.contains("error"));
  CHECK_FALSE(told.contains("result"));
  return told["error"];
}

const std::string ball_and_point =
    R"("objects": [{"sphere": "A", "center": [0, 0], "radius": 1}, {"point": "p", "at": [1, 0]}], "ask": [["p", "A"]])";

}  // namespace

TEST_CASE("a line that is a whole scene is answered as the scene is", "[query]") {
  const Shell shell;
  std::string lines;
  std::vector<Json> expected;
  for (const auto& entry : fs::directory_iterator(ISECT_EXAMPLE_SCENES)) {
    if (entry.path().extension() != ".json") continue;
    const Ran scene = shell("isect scene --json '" + entry.path().string() + "'");
    REQUIRE(scene.status == 0);
    expected.push_back({{"id", entry.path().stem().string()}, {"result", Json::parse(scene.out)}});
    Json line = Json::parse(contents(entry.path()), nullptr, true, true);
    line["id"] = entry.path().stem().string();
    lines += line.dump() + "\n";
  }
  const Asked asked(shell, lines, std::string("--files '") + ISECT_EXAMPLE_SCENES + "/'");
  CHECK(asked.status == 0);
  CHECK(asked.replies.size() > 12);
  CHECK(asked.replies == expected);
}

TEST_CASE("scenes and cases stand side by side, and what may stand beside a case may stand beside a scene", "[query]") {
  const Shell shell;
  const Asked asked(shell, R"({"id": [1], "note": {"of": "mine"}, "expected": 3, )" + ball_and_point + "}\n" +
                               R"({"kind": "orient2d", "a": [0, 0], "b": [1, 0], "c": [0, 1]})" + "\n{" +
                               ball_and_point + "}\n");
  CHECK(asked.status == 0);
  REQUIRE(asked.replies.size() == 3);
  CHECK(asked.replies[0]["id"] == Json({1}));
  CHECK(asked.replies[0]["result"][0]["result"]["location"] == "on");
  CHECK(asked.replies[1]["result"]["sign"] == 1);
  CHECK(asked.replies[2] == Json({{"id", nullptr}, {"result", asked.replies[0]["result"]}}));
  CHECK(reply(shell, R"({"id": 1, "objects": [{"point": "p", "at": [0, 0]}]})")["result"] == Json::array());
}

TEST_CASE("what is wrong in a scene's line is told by its field, and by the line where it has no id", "[query]") {
  const Shell shell;
  const std::map<std::string, std::string> cases = {
      {R"({"id": 1, "objects": [{"sphere": "A", "center": [0, 0], "radius": -1}]})",
       "objects[0].radius: -1 is below 0"},
      {R"({"objects": [{"box": "A", "lo": [0, 0]}]})", "line 1: objects[0]: \"hi\" is missing"},
      {R"({"id": 1, "objects": [{"sphere": "A", "center": [0, 0], "radius": 1}], "ask": [["A", "B"]]})",
       "ask[0]: no object is called \"B\""},
      {R"({"id": 1, "objects": [{"point": "A", "at": [0, 0]}], "scalar": "f32"})", "scalar: unknown"},
      {R"({"id": 1, "kind": "orient2d", "objects": []})", "field \"objects\": it is not known"},
      {R"({"id": 1, "objects": 7})", "objects: a list of 1 to"},
      {R"({"id": 1, "objects": [], "objects": []})", "field \"objects\": it is given twice"},
      {R"({"objects": [NaN]})", "line 1: no JSON: NaN at character 14 is no number"}};
  for (const auto& [line, what] : cases) CHECK_THAT(error(shell, line), Contains(what));
}

TEST_CASE("the files of a scene's line are those of one folder, and none where no folder is given", "[query]") {
  const Shell shell;
  write(shell.work() / "own/a/points.csv", "0,0\n1,0\n0,1\n");
  write(shell.work() / "secret.csv", "0,0\n1,0\n0,1\n");
  fs::create_symlink(shell.work() / "secret.csv", shell.work() / "own/link.csv");
  const auto line = [](const std::string& file) {
    return R"({"id": 1, "objects": [{"hull": "H", "file": ")" + file +
           R"("}, {"point": "p", "at": [0.5, 0.5]}], "ask": [["p", "H"]]})";
  };
  CHECK_THAT(error(shell, line("a/points.csv")), Contains("objects[0].file: no file is read without --files DIR"));
  for (const std::string folder : {"own", "own/", "./own/../own"})
    CHECK(reply(shell, line("a/points.csv"), "--files " + folder)["result"][0]["result"]["location"] == "on");
  for (const std::string& outside :
       {std::string("../secret.csv"), (shell.work() / "secret.csv").string(), std::string("link.csv")})
    CHECK_THAT(error(shell, line(outside), "--files own"), Contains("lies outside the folder of --files"));
  CHECK_THAT(error(shell, line("absent.csv"), "--files own"), Contains("absent.csv"));
  CHECK(shell("isect query --files nowhere cases").status == 4);
}

TEST_CASE("under --strict an empty shape is an error that names its field", "[query]") {
  const Shell shell;
  const std::string box = R"("alo": [0, 0], "ahi": [1, 1], )", ray = R"("origin": [0, 0], "dir": [1, 0], )";
  const std::map<std::string, std::string> cases = {
      {R"("kind": "sphere_sphere", "c1": [0, 0], "r1": 1, "c2": [0, 0], "r2": -1)", "field \"r2\": the ball is empty"},
      {R"("kind": "box_box", )" + box + R"("blo": [0, 2], "bhi": [1, 1])", "field \"blo\": the box is empty"},
      {R"("kind": "interval_interval", "a": [1, 0], "b": [0, 1])", "field \"a\": the interval is empty"},
      {R"("kind": "ray_sphere", )" + ray + R"("tmin": 2, "tmax": 1, "center": [0, 0], "radius": 1)",
       "field \"tmax\": the ray is empty"},
      {R"("kind": "capsule_capsule", "a": {"p": [0, 0], "q": [1, 0], "r": 1}, "b": {"p": [0, 0], "q": [1, 0], "r": -1})",
       "field \"b.r\": the capsule is empty"},
      {R"("kind": "point_cylinder", "point": [0, 0, 0], "p": [0, 0, 0], "q": [1, 0, 0], "r": -1)",
       "field \"r\": the cylinder is empty"},
      {R"("kind": "point_cylinder", "point": [0, 0, 0], "p": [1, 0, 0], "q": [1, 0, 0], "r": 1)",
       "field \"q\": there is no such cylinder"},
      {R"("kind": "point_cone", "point": [0, 0, 0], "apex": [0, 0, 0], "base": [1, 0, 0], "r": -1)",
       "field \"r\": the cone is empty"},
      {R"("kind": "point_cone", "point": [0, 0, 0], "apex": [1, 0, 0], "base": [1, 0, 0], "r": 1)",
       "field \"base\": there is no such cone"},
      {R"("kind": "point_obb", "point": [0, 0], "c": [0, 0], "u": [[1, 0], [2, 0]], "e": [1, 1])",
       "field \"u\": there is no such box"},
      {R"("kind": "point_obb", "point": [0, 0], "c": [0, 0], "u": [[1, 0], [0, 1]], "e": [1, -1])",
       "field \"e\": the box is empty"},
      {R"("kind": "kdop_kdop", "normals": [[1, 0], [0, 1]], "a": {"lo": [0, 0], "hi": [1, 1]}, "b": {"lo": [0, 2], "hi": [1, 1]})",
       "field \"b.lo[1]\": the k-DOP is empty"},
      {R"("kind": "plane_sphere", "normal": [0, 0], "d": 0, "center": [0, 0], "radius": 1)",
       "field \"normal\": there is no such plane"}};
  for (const auto& [fields, what] : cases) {
    const std::string line = R"({"id": 1, )" + fields + "}";
    INFO(line);
    CHECK(reply(shell, line).contains("result"));
    CHECK_THAT(error(shell, line, "--strict"), Contains(what));
  }
  CHECK(reply(shell, R"({"id": 1, "kind": "sphere_sphere", "c1": [0, 0], "r1": 0, "c2": [0, 0], "r2": 0})",
              "--strict")["result"]["relation"] == "equal");
}

}  // namespace query_scene_test
