// Polygons in space, and what meets them, in scenes.

#include <nlohmann/json.hpp>

#include "tests/app/shell.h"
#include "tests/catch.h"

namespace polygons_in_space_test {
using isect::test::Contains;
using isect::test::Shell;
using isect::test::write;
using Json = nlohmann::ordered_json;

namespace {

/// The answer to the first question of a scene.
Json answer(const Shell& shell, const std::string& objects, const std::string& ask = R"("all pairs")") {
  write(shell.work() / "s.json", R"({"objects": [)" + objects + R"(], "ask": )" + ask + "}");
  const auto ran = shell("isect scene s.json --json");
  INFO(objects << "\n" << ran.err);
  REQUIRE(ran.status == 0);
  return Json::parse(ran.out)[0];
}
std::string verdict(const Shell& shell, const std::string& objects) { return answer(shell, objects)["verdict"]; }

}  // namespace

TEST_CASE("a polygon in space meets what has a point in it", "[scene]") {
  const Shell shell;
  const std::string polygon =  // an L; what is right above (1, 3) is its notch
      R"({"polygon": "P", "points": [[0,0,0],[4,0,0],[4,4,0],[2,4,0],[2,2,0],[0,2,0]]}, )";
  const auto expect = [&](const std::string& other, const char* expected) {
    INFO(other);
    CHECK(verdict(shell, polygon + other) == expected);
  };
  expect(R"({"point": "q", "at": [1,1,0]})", "q lies on P");
  expect(R"({"point": "q", "at": [2,3,0]})", "q lies on P");
  expect(R"({"point": "q", "at": [1,3,0]})", "q does not lie on P");
  expect(R"({"point": "q", "at": [1,1,1e-300]})", "q does not lie on P");
  expect(R"({"sphere": "S", "center": [1,3,0], "radius": 1})", "P and S touch");
  expect(R"({"sphere": "S", "center": [1,3,0], "radius": 0.9999999999999999})", "P and S are disjoint");
  expect(R"({"sphere": "S", "center": [1,1,3], "radius": 3})", "P and S touch");
  expect(R"({"box": "A", "lo": [0.5,2.5,-1], "hi": [1.5,3.5,1]})", "P and A are disjoint");
  expect(R"({"box": "A", "lo": [0.5,2,-1], "hi": [1.5,3.5,1]})", "P and A touch");
  expect(R"({"box": "A", "lo": [-1,-1,-1], "hi": [9,9,1]})", "P lies in A");
  expect(R"({"obb": "O", "center": [1,3,0], "u": [0.6,0.8,0], "v": [-0.8,0.6,0], "w": [0,0,1], "half": [0.5,0.5,1]})",
         "P and O are disjoint");
  expect(R"({"obb": "O", "center": [1,3,0], "u": [0.6,0.8,0], "v": [-0.8,0.6,0], "w": [0,0,1], "half": [1,0.5,1]})",
         "P and O overlap");
  expect(R"({"capsule": "C", "p": [1,3,-5], "q": [1,3,5], "r": 1})", "P and C touch");
  expect(R"({"capsule": "C", "p": [1,3,-5], "q": [1,3,5], "r": 0.99})", "P and C are disjoint");
  expect(R"({"triangle": "T", "points": [[1,3,-1],[1,3,1],[1.5,3.5,0]]})", "P and T are disjoint");
  expect(R"({"triangle": "T", "points": [[1,3,-1],[1,3,1],[2.5,3,0]]})", "P and T overlap");
  expect(R"({"polygon": "Q", "points": [[1,3,-1],[1.5,3,-1],[1.5,3,1],[1,3,1]]})", "P and Q are disjoint");
  expect(R"({"polygon": "Q", "points": [[1,3,-1],[2,3,-1],[2,3,1],[1,3,1]]})", "P and Q touch");
  expect(R"({"polygon": "Q", "points": [[0,0,0],[2,0,0],[2,2,0],[0,2,0]]})", "Q lies in P");
  expect(R"({"kdop": "K", "normals": [[1,0,0],[0,1,0],[0,0,1]], "lo": [0,2.5,-1], "hi": [1,3,1]})",
         "P and K are disjoint");
  expect(R"({"kdop": "K", "normals": [[1,0,0],[0,1,0],[0,0,1]], "lo": [0,2,-1], "hi": [1,3,1]})", "P and K touch");
  expect(R"({"hull": "H", "points": [[1,3,-1],[1.5,3,1],[1,3.5,1],[0.5,3,1]]})", "P and H are disjoint");
  expect(R"({"hull": "H", "points": [[1,3,-1],[4,3,1],[1,3.5,1],[0.5,3,1]]})", "P and H overlap");
  expect(R"({"hull": "H", "points": [[-9,-9,-9],[90,0,-9],[0,90,-9],[0,0,90]]})", "P lies in H");
  expect(R"({"frustum": "F", "eye": [1,3,9], "forward": [0,0,-1], "up": [0,1,0], "angle": 2, "near": 1, "far": 10})",
         "P and F are disjoint");
  expect(R"({"frustum": "F", "eye": [1,3,9], "forward": [0,0,-1], "up": [0,1,0], "angle": 20, "near": 1, "far": 10})",
         "P and F overlap");
  expect(R"({"cloud": "D", "points": [[1,1,0],[1,3,0],[4,4,0]]})", "2 of 3 points of D lie on P");
  expect(R"({"mesh": "M", "points": [[1,3,-1],[1,3,1],[1.5,3.5,0],[3,1,0]], "triangles": [[0,1,2],[0,1,3]]})",
         "P meets 1 of 2 triangles of M");
}

TEST_CASE("what runs along a line meets a mesh in whose plane it lies, and triangles without an area", "[scene]") {
  const Shell shell;
  for (const char* line :
       {R"({"ray": "g", "origin": [-1,1,0], "dir": [1,0,0]})", R"({"line": "g", "origin": [-1,1,0], "dir": [1,0,0]})",
        R"({"segment": "g", "from": [-1,1,0], "to": [4,1,0]})"}) {
    const std::string along = std::string(line) + R"(, {"mesh": "M", "points": )";
    CHECK(verdict(shell, along + R"([[0,0,0],[3,0,0],[0,3,0]], "triangles": [[0,1,2]]})") == "g meets M");
    CHECK(verdict(shell, along + R"([[0,2,0],[3,2,0],[0,3,0]], "triangles": [[0,1,2]]})") ==
          "g meets no triangle of M");
    CHECK(verdict(shell, along + R"([[0,0,0],[0,3,0],[0,2,0]], "triangles": [[0,1,2]]})") == "g meets M");
    CHECK(verdict(shell, along + R"([[0,2,0],[0,3,0],[0,5,0]], "triangles": [[0,1,2]]})") ==
          "g meets no triangle of M");
  }
  const Json first = answer(shell, R"({"ray": "r", "origin": [-1,1,0], "dir": [1,0,0]},
      {"mesh": "M", "points": [[0,0,0],[3,0,0],[0,3,0]], "triangles": [[0,1,2]]})");
  CHECK(first["result"]["t"] == 1);
}

TEST_CASE("a walk's answer stands among all answers, and a box is not called after the circle around it", "[scene]") {
  const Shell shell;
  write(shell.work() / "s.json", R"({"objects": [{"circle": "A", "center": [0,0], "radius": 2},
      {"box": "W", "lo": [-1,-1], "hi": [1,1]}, {"point": "p", "at": [0,0]},
      {"polygon": "P", "points": [[-1,-1],[1,-1],[0,2]]}], "ask": [["A", "W"], {"walk": ["p", "P"]}]})");
  CHECK_THAT(shell("isect explain s.json").out, !Contains("box A"));
  const std::string last =
      shell("isect render s.json --format svg --step all --out out && cat out/scene/s/*-answers.txt").out;
  CHECK_THAT(last, Contains("p and P, step by step: p lies inside P"));
}

TEST_CASE("any two objects have a test, in space and in the plane", "[scene]") {
  const Shell shell;
  const auto all_decided = [&](const std::vector<std::string>& kinds) {
    std::string objects;
    for (const std::string& kind : kinds)
      for (const char* name : {"A", "B"}) {  // "sphere": "sphereA", ...
        const std::string type = kind.substr(0, kind.find(' '));
        objects += (objects.empty() ? "" : ", ") + ("{\"" + type + "\": \"" + type + name + "\", ") +
                   kind.substr(kind.find(' ') + 1) + "}";
      }
    write(shell.work() / "s.json", R"({"objects": [)" + objects + R"(], "ask": "all pairs"})");
    const auto ran = shell("isect scene s.json --json");
    INFO(ran.err);
    REQUIRE(ran.status == 0);
    const Json all = Json::parse(ran.out);
    const std::size_t n = 2 * kinds.size();
    CHECK(all.size() == n * (n - 1) / 2 - 1);  // but the two points
    for (const Json& answer : all) CHECK_THAT(answer["verdict"].get<std::string>(), !Contains("not decided"));
  };
  const std::string cube = R"([[0,0,0],[1,0,0],[0,1,0],[0,0,1],[1,1,1]])";
  all_decided({R"(point "at": [0,0,1])", R"(segment "from": [0,0,0], "to": [1,1,2])",
               R"(ray "origin": [0,0,0], "dir": [1,1,1])", R"(line "origin": [0,0,0], "dir": [1,1,1])",
               R"(plane "normal": [0,0,1], "d": -1)", R"(sphere "center": [0,0,0], "radius": 1)",
               R"(box "lo": [0,0,0], "hi": [1,1,1])",
               R"(obb "center": [0,0,0], "u": [1,0,0], "v": [0,1,0], "w": [0,0,1], "half": [1,1,1])",
               R"(capsule "p": [0,0,0], "q": [1,0,0], "r": 0.5)", R"(triangle "points": [[0,0,0],[1,0,0],[0,1,0]])",
               R"(polygon "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]])",
               R"(kdop "normals": [[1,0,0],[0,1,0],[0,0,1]], "lo": [0,0,0], "hi": [1,1,1])", "hull \"points\": " + cube,
               "cloud \"points\": " + cube,
               R"(mesh "points": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], "triangles": [[0,2,1],[0,1,3],[1,2,3],[0,3,2]])",
               R"(frustum "eye": [0,0,0], "forward": [1,0,0], "up": [0,1,0], "angle": 60, "near": 1, "far": 4)"});
  const std::string square = R"([[0,0],[1,0],[1,1],[0,1]])";
  all_decided({R"(point "at": [0,1])", R"(segment "from": [0,0], "to": [1,2])", R"(ray "origin": [0,0], "dir": [1,1])",
               R"(line "origin": [0,0], "dir": [1,1])", R"(plane "normal": [0,1], "d": -1)",
               R"(circle "center": [0,0], "radius": 1)", R"(box "lo": [0,0], "hi": [1,1])",
               R"(obb "center": [0,0], "u": [1,0], "v": [0,1], "half": [1,1])",
               R"(capsule "p": [0,0], "q": [1,0], "r": 0.5)", R"(triangle "points": [[0,0],[1,0],[0,1]])",
               "polygon \"points\": " + square, R"(kdop "normals": [[1,0],[0,1],[1,1]], "lo": [0,0,0], "hi": [1,1,2])",
               "hull \"points\": " + square, "cloud \"points\": " + square});
}

TEST_CASE("a polygon that has no surface is not decided, and one that is not plane is told", "[scene]") {
  const Shell shell;
  CHECK_THAT(verdict(shell, R"({"polygon": "P", "points": [[0,0,0],[2,2,0],[2,0,0],[0,2,0]]}, )"
                            R"({"sphere": "S", "center": [0,0,0], "radius": 1})"),
             Contains("not decided, as the outline of P has no area, crosses or touches itself"));
  const Json bent = answer(shell, R"({"polygon": "P", "points": [[0,0,0],[4,0,0],[4,4,1],[0,4,0]]}, )"
                                  R"({"sphere": "S", "center": [0,0,0], "radius": 1})");
  CHECK(bent["verdict"] == "P and S overlap");
  CHECK(bent["result"]["off_plane"].get<double>() > 0.4);
}

TEST_CASE("a polygon that is not plane is the same triangles whatever it is asked about", "[scene]") {
  const Shell shell;
  write(shell.work() / "s.json", R"({"objects": [{"polygon": "P", "points": [[0,0,0],[4,0,0],[4,4,4],[0,4,0]]},
    {"ray": "r", "origin": [1,1,9], "dir": [0,0,-1]}, {"point": "p", "at": [1,1,0]}, {"point": "q", "at": [1,1,1]},
    {"segment": "s", "from": [1,1,-0.5], "to": [1,1,0.5]}, {"box": "B", "lo": [0.5,0.5,-1], "hi": [1.5,1.5,0.4]}],
    "ask": [["r","P"], ["p","P"], ["q","P"], ["s","P"], ["B","P"], {"first hit": "r"}]})");
  const auto ran = shell("isect scene s.json --json");
  REQUIRE(ran.status == 0);
  const Json all = Json::parse(ran.out);
  const std::vector<std::string> told = {"r meets P", "p lies on P",     "q does not lie on P",
                                         "s meets P", "B and P overlap", "r meets q first, at t = 8"};
  for (std::size_t i = 0; i < told.size(); ++i) CHECK(all[i]["verdict"] == told[i]);
  CHECK(all[0]["result"]["t"] == 9);
  CHECK_THAT(ran.err, Contains("P: Its corners lie up to"));
}

TEST_CASE("rays, lines and segments enter a capsule", "[scene]") {
  const Shell shell;
  const auto hit = [&](const std::string& line, const char* ask) {
    return answer(shell, line + R"(, {"capsule": "C", "p": [-3,0,0], "q": [3,0,0], "r": 5},
                              {"sphere": "S", "center": [-3,0,0], "radius": 1})",
                  "[" + std::string(ask) + "]");
  };
  const auto ray = hit(R"({"ray": "r", "origin": [9,4,0], "dir": [-1,0,0]})", R"(["r", "C"])");
  CHECK(ray["verdict"] == "r meets C");
  CHECK(ray["result"]["t_in"] == 3);
  CHECK(ray["result"]["t_out"] == 15);
  const auto within = hit(R"({"ray": "r", "origin": [0,1,0], "dir": [0,2,0]})", R"(["r", "C"])");
  CHECK(within["result"]["t_in"] == 0);
  CHECK(within["result"]["t_out"] == 2);
  const auto segment = hit(R"({"segment": "s", "from": [9,4,0], "to": [1,4,0]})", R"(["s", "C"])");
  CHECK(segment["result"]["t_in"] == 0.375);
  CHECK(segment["result"]["t_out"] == 1);
  const auto missed = hit(R"({"line": "g", "origin": [0,5.000000000000001,0], "dir": [1,0,0]})", R"(["g", "C"])");
  CHECK(missed["verdict"] == "g misses C");
  const auto first = hit(R"({"ray": "r", "origin": [9,0,0], "dir": [-1,0,0]})", R"({"first hit": "r"})");
  CHECK(first["verdict"] == "r meets C first, at t = 1");
}

}  // namespace polygons_in_space_test
