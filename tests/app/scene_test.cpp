// Scene files: every type and every pair, answers equal to the oracle's, and errors reported by line and field.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/scene/lesson.h"
#include "app/scene/save.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/formats/files.h"
#include "viz/player/snap.h"

namespace scene_test {
namespace fs = std::filesystem;
namespace viz = isect::viz;
using namespace isect::test;
using Catch::Matchers::StartsWith;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* two_balls = R"({
  // 3-4-5: rounding decides nothing here
  "title": "Two balls",
  "objects": [
    {"sphere": "A", "center": [0, 0, 0], "radius": 2},
    {"sphere": "B2", "center": [3, 4, 0], "radius": 3},
    {"ray": "r", "origin": [-5, 0, 0], "dir": [2, 0, 0]}
  ],
  "ask": [["A", "B2"], ["r", "A"], ["B2", "r"], {"first hit": "r"}]
})";

Json answers(const Shell& shell, const std::string& scene) {
  write(shell.work() / "scene.json", scene);
  const Ran r = shell("isect scene scene.json --json");
  INFO(scene << "\n" << r.err);
  REQUIRE(r.status == 0);
  return Json::parse(r.out);
}

std::string verdict(const Shell& shell, const std::string& objects, const std::string& ask = "\"all pairs\"") {
  const Json all = answers(shell, R"({"objects": [)" + objects + R"(], "ask": )" + ask + "}");
  REQUIRE(all.size() == 1);
  return all[0]["verdict"];
}

}  // namespace

TEST_CASE("a scene's answers are those of the oracle, in words and as JSON", "[scene]") {
  const Shell shell;
  const Json all = answers(shell, two_balls);
  REQUIRE(all.size() == 4);
  CHECK(all[0]["ask"] == std::vector<std::string>{"A", "B2"});
  CHECK(all[0]["verdict"] == "A and B₂ touch");
  CHECK(all[0]["result"]["relation"] == "touch_outer");
  CHECK(all[1]["verdict"] == "r meets A");
  CHECK(all[1]["result"]["t0"] == 1.5);
  CHECK(all[2]["query"]["kind"] == "ray_sphere");  // in either order
  CHECK(all[3]["verdict"] == "r meets A first, at t = 1.5");
  for (const Json& answer : all)
    if (answer.contains("query")) {
      write(shell.work() / "query.jsonl", answer["query"].dump() + "\n");
      CHECK(Json::parse(shell("isect query query.jsonl").out)["result"] == answer["result"]);
    }
  const Ran words = shell("isect scene scene.json");
  CHECK(words.out == "A and B₂ touch\nr meets A\nr misses B₂\nr meets A first, at t = 1.5\n");
}

TEST_CASE("every pair of objects that has a test is told as it lies", "[scene]") {
  const Shell shell;
  const std::string unit_box = R"({"box": "A", "lo": [0, 0, 0], "hi": [1, 1, 1]})",
                    flat_box = R"({"box": "A", "lo": [0, 0], "hi": [1, 1]})",
                    ball = R"({"sphere": "S", "center": [0, 0, 0], "radius": 1})",
                    obb =
                        R"({"obb": "O", "center": [0,0,0], "u": [1,0,0], "v": [0,1,0], "w": [0,0,1], "half": [1,1,1]})",
                    square = R"({"polygon": "P", "points": [[0,0],[2,0],[2,2],[0,2]]})",
                    wall = R"({"polygon": "P", "points": [[0,-1,-1],[0,1,-1],[0,1,1],[0,-1,1]]})",
                    floor = R"({"plane": "F", "normal": [0, 1, 0], "d": 0})",
                    capsule = R"({"capsule": "C", "p": [3, 0], "q": [3, 2], "r": 1})";
  const auto ray = [](const std::string& origin, const std::string& dir, const std::string& more = "") {
    return R"(, {"ray": "r", "origin": )" + origin + R"(, "dir": )" + dir + more + "}";
  };
  CHECK(verdict(shell, ball + "," + unit_box) == "S and A overlap");
  CHECK(verdict(shell, unit_box + R"(, {"box": "B", "lo": [1,1,1], "hi": [2,2,2]})") == "A and B touch");
  CHECK(verdict(shell, flat_box + R"(, {"box": "B", "lo": [-1,-1], "hi": [2,2]})") == "A lies in B");
  CHECK(verdict(shell, R"({"sphere": "S", "center": [0, 0], "radius": 2}, )" + capsule) == "S and C touch");
  CHECK(verdict(shell, capsule + R"(, {"capsule": "D", "p": [6, 0], "q": [9, 0], "r": 0.5})") ==
        "C and D are disjoint");
  CHECK(verdict(
            shell,
            obb + R"(, {"obb": "Q", "center": [2,0,0], "u": [1,0,0], "v": [0,1,0], "w": [0,0,1], "half": [1,1,1]})") ==
        "O and Q touch");
  CHECK(verdict(shell, floor + "," + ball) == "F cuts S");
  CHECK(verdict(shell, floor + "," + unit_box) == "F and A touch");
  CHECK(verdict(shell, R"({"triangle": "T", "points": [[2,0,0],[0,2,0],[0,0,2]]}, )" + unit_box) == "T and A overlap");
  CHECK(
      verdict(shell, R"({"segment": "s", "from": [0,0], "to": [2,2]}, {"segment": "u", "from": [0,2], "to": [2,0]})") ==
      "s and u cross");
  CHECK(
      verdict(shell, R"({"segment": "s", "from": [0,0], "to": [2,2]}, {"segment": "u", "from": [1,1], "to": [3,3]})") ==
      "s and u share a stretch");
  CHECK(verdict(shell, R"({"point": "p", "at": [1,0,0]}, )" + ball) == "p lies on the boundary of S");
  CHECK(verdict(shell, R"({"point": "p", "at": [0.5,0.5]}, )" + flat_box) == "p lies inside A");
  CHECK(verdict(shell, R"({"point": "p", "at": [1.5,0,0]}, )" + obb) == "p lies outside O");
  CHECK(verdict(shell, R"({"point": "p", "at": [1,2]}, )" + square) == "p lies on the boundary of P");
  CHECK(
      verdict(
          shell,
          R"({"polygon": "P", "rings": [[[0,0],[4,0],[4,4],[0,4]],[[1,1],[2,1],[2,2]]]}, {"point": "p", "at": [1.75,1.25]})") ==
      "p lies outside P");
  CHECK(verdict(shell, R"({"point": "p", "at": [1,2]}, {"point": "q", "at": [1,2]})", R"([["p","q"]])") ==
        "p and q coincide");
  CHECK(verdict(shell, ball + ray("[-3,1,0]", "[1,0,0]")) == "r meets S in one point");
  CHECK(verdict(shell, ball + ray("[0,0,0]", "[1,0,0]", ", \"tmax\": 0.5")) == "r meets S");  // inside a solid ball
  CHECK(verdict(shell, ball + ray("[-3,0,0]", "[1,0,0]", ", \"tmax\": 1.5")) == "r misses S");
  CHECK(verdict(shell, unit_box + ray("[-1,0.5,0.5]", "[1,0,0]")) == "r meets A");
  CHECK(verdict(shell, obb + ray("[-3,1.25,0]", "[1,0,0]")) == "r misses O");
  CHECK(verdict(shell, floor + ray("[0,0,0]", "[1,0,0]")) == "r lies in F");
  CHECK(verdict(shell, floor + ray("[0,1,0]", "[1,1,0]")) == "r misses F");
  CHECK(verdict(shell, wall + ray("[-1,0,0]", "[1,0,0]")) == "r meets P");
  CHECK(verdict(shell, wall + ray("[-1,1,0]", "[1,0,0]")) == "r meets P on its boundary");
  CHECK(verdict(shell, wall + ray("[0,3,0]", "[0,-1,0]")) == "r meets P, in whose plane it lies");
  CHECK(verdict(shell, wall + ray("[0,3,0]", "[0,1,0]")) == "r misses P, in whose plane it lies");
  CHECK(verdict(shell, R"({"line": "g", "origin": [9,0,0], "dir": [1,0,0]}, )" + ball) == "g meets S");
  CHECK(verdict(shell, R"({"segment": "s", "from": [-3,0,0], "to": [-1,0,0]}, )" + ball) == "s meets S");
}

TEST_CASE("a segment in space whose direction would be rounded is answered by its ends", "[scene]") {
  const Shell shell;
  const Json all = answers(shell, R"({"objects": [{"segment": "s", "from": [0.1, 0, 0], "to": [1e20, 0, 0]},
    {"box": "A", "lo": [0,0,0], "hi": [1,1,1]}, {"point": "p", "at": [0, 0, 0]}], "ask": [["s", "A"], ["p", "A"]]})");
  CHECK(all[0]["verdict"] == "s meets A");
  CHECK(all[1]["verdict"] == "p lies on the boundary of A");  // the others are answered
}

TEST_CASE("hits that only roots and quotients tell apart are put in order", "[scene]") {
  const Shell shell;
  const auto first = [&](const std::string& x) {
    return verdict(shell,
                   R"({"ray": "r", "origin": [-5,0,0], "dir": [1,0,0]}, {"sphere": "A", "center": [0,0,0], "radius": 1},
                      {"box": "B", "lo": [)" +
                       x + R"(,-1,-1], "hi": [1,1,1]})",
                   R"([{"first hit": "r"}])");
  };
  CHECK(first("-1") == "r meets A and B at the same t");
  CHECK(first("-1.5") == "r meets B first, at t = 3.5");
  CHECK(first("-0.5") == "r meets A first, at t = 4");
}

TEST_CASE("what is wrong with a scene is told by line and field, with what is allowed", "[scene]") {
  const Shell shell;
  const auto refused = [&](const std::string& scene) {
    write(shell.work() / "bad.json", scene);
    const Ran r = shell("isect scene bad.json");
    INFO(scene);
    CHECK(r.status == 2);
    CHECK_THAT(r.err, StartsWith("isect: bad.json: line "));
    return r.err;
  };
  const std::string point = R"({"point": "p", "at": [0, 0]})";
  CHECK_THAT(refused("{\n \"objects\": [\n  " + point + ",\n  {\"spere\": \"A\"}]}"),
             Contains("line 4: objects[1].spere: ") && Contains("\"sphere\""));
  CHECK_THAT(refused("{\"objects\": [\n{\"sphere\": \"A\", \"centre\": [0, 0]}]}"),
             Contains("line 2: objects[0].centre: ") && Contains("\"center\"") && Contains("radius"));
  CHECK_THAT(refused(R"({"objects": [{"sphere": "A", "center": [0, 0], "radius": -1}]})"),
             Contains("radius: -1 is below 0"));
  CHECK_THAT(refused(R"({"objects": [{"sphere": "A", "center": [0, "x"], "radius": 1}]})"),
             Contains("center[1]: a finite number"));
  CHECK_THAT(refused(R"({"objects": [)" + point + "," + point + "]}"), Contains("name of another"));
  CHECK_THAT(refused(R"({"objects": [)" + point + R"(, {"point": "q", "at": [0, 0, 1]}]})"), Contains("3 coordinates"));
  CHECK_THAT(refused(R"({"objects": [{"ray": "r", "origin": [0, 0], "dir": [0, 0]}]})"),
             Contains("dir: a vector of any length but 0"));
  CHECK_THAT(refused(R"({"objects": [{"circle": "C", "center": [0, 0, 0], "radius": 1}]})"), Contains("in space"));
  CHECK_THAT(refused(R"({"objects": [{"circle": "C", "center": [0, 0], "radios": 1}]})"), Contains("mean \"radius\""));
  CHECK_THAT(refused(R"({"objects": [{"obb": "O", "center": [0, 0], "u": [1, 1], "v": [0, 1], "half": [1, 1]}]})"),
             Contains("objects[0].u: give axes of length 1"));
  CHECK_THAT(refused(R"({"objects": [{"point": "p q", "at": [0, 0]}]})"), Contains("letters and digits"));
  CHECK_THAT(refused(R"({"objects": [{"triangle": "t", "points": [[0, 0], [1, 0]]}]})"),
             Contains("3 points are expected"));
  CHECK_THAT(refused(R"({"objects": [], "ask": []})"), Contains("objects: a list of 1 to"));
  CHECK_THAT(refused(R"({"objects": [)" + point + R"(], "ask": [["p", "r"]]})"),
             Contains("ask[0]: no object is called \"r\""));
  CHECK_THAT(refused(R"({"objects": [)" + point + R"(], "ask": [{"first hit": "p"}]})"),
             Contains("a ray, a line or a segment"));
  CHECK_THAT(refused(R"({"objects": [)" + point + R"(], "camera": {"elevation": 100}})"), Contains("-90 to 90"));
  CHECK_THAT(refused("{\"objects\": [\n" + point + "\n"), Contains("line 3, column 1: no JSON"));
  CHECK_THAT(refused("[1]"), Contains("an object in braces"));
  CHECK(shell("isect scene absent.json").status == 4);
}

TEST_CASE("a scene that is no JSON, or holds what is none of ours, is told by its place and what is meant", "[scene]") {
  const Shell shell;
  struct Wrong {
    std::string scene, place, why;
  };
  const std::string point = R"({"point": "p", "at": [0, 0]})", space = R"({"point": "p", "at": [0, 0, 0]})";
  const auto objects = [](const std::string& text) { return "{\"objects\": [\n" + text + "]}"; };
  const std::vector<Wrong> all = {
      // Texts that are not JSON.
      {" \n\n", "the file is empty", ""},
      {std::string("\0\1\2", 3), "line 1, column 1: no JSON", "no text in UTF-8"},
      {"{\"title\": \"\xE9t\xE9\", \"objects\": []}", "line 1, column 13", "no text in UTF-8"},
      {"\xFF\xFE{", "line 1, column 1", "no text in UTF-8"},
      {objects(point + ",\n"), "line 3, column 1", "the comma before it is one too many"},
      {objects(point + "\n " + point), "line 3, column 2", "is a comma missing before it?"},
      {"{'objects': []}", "line 1, column 2", "double quotes"},
      {"{objects: []}", "line 1, column 2", "double quotes"},
      {"# mine\n{}", "line 1, column 1", "a comment begins with //"},
      {objects(R"({"sphere": "Ä", "center": [0, 0], "radius": NaN})"), "line 2, column 45", "a number is finite"},
      {objects(R"({"point": "p", "at": [0, Infinity]})"), "line 2, column 26", "a number is finite"},
      {objects(R"({"point": "p", "at": [.5, 1]})"), "line 2, column 23", "0.5"},
      {objects(R"({"point": "p", "at": [+5, 1]})"), "line 2, column 23", "no plus sign"},
      {objects(R"({"point": "p", "at": [1/3, 1]})"), "line 2, column ", "written out"},
      {objects(R"({"sphere": "A", "center": [0, 0], "radius": 0,5})"), "line 2, column ", "a decimal point"},
      {objects(point) + " {}", "line 2, column ", "expected end of input"},
      {"{\"objects\": [" + point + "]", "line 1, column ", "expected '}'"},
      // Files that are not scenes.
      {"7", "line 1: the file: ", "in braces"},
      {"{\"title\": \"x\"}", "line 1: the file: ", "\"objects\" is missing"},
      {R"({"lesson": "ray-sphere"})", "line 1: lesson: ", "a preset’s file"},
      {R"({"objects": {"a": 1}})", "line 1: objects: ", "a list of 1 to 1000"},
      {objects("7"), "line 2: objects[0]: ", "{\"sphere\": \"A\", ...}"},
      {objects(R"({"type": "sphere", "name": "A"})"), "line 2: objects[0].type: ", "{\"sphere\": \"A\", ...}"},
      {"{\"objects\": [" + point + "], \"asks\": []}", "line 1: asks: ", "mean \"ask\""},
      {"{\"title\": 3, \"objects\": [" + point + "]}", "line 1: title: ", "a text"},
      // Objects that are not valid.
      {objects(R"({"point": "ä", "at": [0, 0]})"), "line 2: objects[0].point: ", "a to z"},
      {objects(R"({"point": "p", "at": [0, null]})"), "line 2: objects[0].at[1]: ", "a finite number"},
      {objects(R"({"point": "p", "at": [0, 1e308]})"), "line 2: objects[0].at[1]: ", "1e300 is the most"},
      {objects(R"({"point": "p", "at": [0, 0, 0, 0]})"), "line 2: objects[0].at: ", "two or three numbers"},
      {objects(R"({"sphere": "A", "center": [0, 0]})"), "line 2: objects[0]: ", "\"radius\" is missing"},
      {objects(R"({"frustum": "F", "eye": [0, 0], "forward": [0, 1], "up": [1, 0], "angle": 40, "near": 1, "far": 5})"),
       "line 2: objects[0]: ", "three coordinates"},
      {objects(
           R"({"frustum": "F", "eye": [0,0,0], "forward": [0,1,0], "up": [0,1,0], "angle": 40, "near": 1, "far": 5})"),
       "line 2: objects[0]: F: ", "along one line"},
      {objects(
           R"({"frustum": "F", "eye": [0,0,0], "forward": [0,1,0], "up": [1,0,0], "angle": 40, "near": 6, "far": 5})"),
       "line 2: objects[0]: F: ", "less than far"},
      {objects(R"({"kdop": "K", "normals": [[1, 0], [0, 1]], "lo": [2, 0], "hi": [1, 1]})"),
       "line 2: objects[0]: K: ", "it is empty"},
      {objects(R"({"kdop": "K", "normals": [[1, 0]], "lo": [0], "hi": [1]})"),
       "line 2: objects[0]: K: ", "do not span the plane"},
      {objects(R"({"polygon": "P", "points": [[0,0],[1,0],[1,1]], "rings": []})"), "line 2: objects[0]: ", "one of"},
      {objects(R"({"mesh": "M", "points": [[0,0,0],[1,0,0],[0,1,0]], "triangles": [[0,1,3]]})"),
       "line 2: objects[0].triangles: ", "they are 0 to 2"},
      // Questions, notes and cameras that are not valid.
      {"{\"objects\": [" + point + "], \"ask\": \"all\"}", "line 1: ask: ", "\"all pairs\""},
      {"{\"objects\": [" + point + "], \"ask\": [\"p\"]}", "line 1: ask[0]: ", "two names"},
      {"{\"objects\": [" + point + "], \"ask\": [{\"firsthit\": \"p\"}]}",
       "line 1: ask[0].firsthit: ", "mean \"first hit\""},
      {"{\"objects\": [" + point + "], \"notes\": [{\"text\": \"x\"}]}", "line 1: notes[0]: ", "\"at\" is missing"},
      {"{\"objects\": [" + space + "], \"camera\": {\"zoom\": 2}}", "line 1: camera.zoom: ", "azimuth"},
  };
  for (const Wrong& w : all) {
    write(shell.work() / "bad.json", w.scene);
    const Ran r = shell("isect scene bad.json");
    INFO(w.scene);
    CHECK(r.status == 2);
    CHECK(r.out.empty());
    CHECK_THAT(r.err, StartsWith("isect: bad.json: ") && Contains(w.place) && Contains(w.why));
    CHECK(std::count(r.err.begin(), r.err.end(), '\n') == 1);
  }
  write(shell.work() / "bad.json", objects(R"({"cloud": "C", "file": "absent.csv"})"));
  const Ran absent = shell("isect scene bad.json");
  CHECK(absent.status == 4);
  CHECK_THAT(absent.err, Contains("absent.csv") && Contains("line 2: objects[0].file"));
  CHECK_THAT(shell("isect bad.json").err, Contains("isect scene bad.json"));
}

TEST_CASE("a table with semicolons may have decimal commas, and a text STL that is cut off is refused", "[scene]") {
  const Shell shell;
  write(shell.work() / "p.csv", "x;y\n0,5;0,25\n1;-1,5\n");
  CHECK(verdict(shell, R"({"cloud": "C", "file": "p.csv"}, {"box": "B", "lo": [0.25, 0], "hi": [1, 1]})") ==
        "1 of 2 points of C lies inside B");
  write(shell.work() / "m.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n");
  write(shell.work() / "s.json", R"({"objects": [{"mesh": "M", "file": "m.stl"}]})");
  CHECK_THAT(shell("isect scene s.json").err, Contains("m.stl: line 5: it ends where vertex is expected"));
}

TEST_CASE("whatever takes a preset's file takes a scene", "[scene]") {
  const Shell shell;
  write(shell.work() / "notes/balls.json", two_balls);
  const Ran r = shell("isect render notes/balls.json --format png,svg,pdf,tikz --step 2");
  CHECK(r.status == 0);
  CHECK_THAT(r.out, StartsWith("figures/scene/balls/02-a-b2.png\n"));
  const std::string svg = contents(shell.work() / "figures/scene/balls/02-a-b2.svg");
  CHECK_THAT(svg, Contains("ball") && Contains("A and B₂ touch"));
  CHECK_THAT(shell("isect show figures/scene/balls/02-a-b2.png").err, Contains("no display"));  // it knows the scene
  CHECK(shell("isect show figures/scene/balls/02-a-b2.svg").status == 77);

  CHECK_THAT(shell("isect explain notes/balls.json").out,
             Contains("Verdict: A and B₂ touch") && Contains("A.radius = 2"));
  CHECK_THAT(shell("isect explain notes/balls.json --set A.radius=2.5").out, Contains("Verdict: A and B₂ overlap"));
  CHECK_THAT(shell("isect explain notes/balls.json --set r.dir=0,0,0").err, Contains("any length but 0"));
  CHECK(shell("isect strip notes/balls.json --step 2-3").status == 0);
  CHECK(shell("isect deck notes/balls.json").status == 0);
  CHECK(shell("isect handout notes/balls.json").status == 0);

  write(shell.work() / "notes/foreign.json", R"({"objects": [{"id": 7}]})");
  CHECK(shell("isect check --dir notes --update").status == 0);
  const Ran same = shell("isect check --dir notes");
  CHECK(same.status == 0);
  CHECK_THAT(same.err, Contains("passed over") && Contains("foreign.json"));
  std::string moved = two_balls;
  moved.replace(moved.find("[3, 4, 0]"), 9, "[3, 4, 1]");
  write(shell.work() / "notes/balls.json", moved);
  const Ran other = shell("isect check --dir notes");
  CHECK(other.status == 1);
  CHECK_THAT(other.out, Contains("are disjoint"));
}

TEST_CASE("numbers are saved into the scene's own text, and nothing else of it changes", "[scene]") {
  const Shell shell;
  const std::string text = R"({ "title": "{ \"objects\" }", // radius: 2
  "objects": [
    {"sphere": "A", /* here */ "center": [0, 0.10, 0], "radius":2 },
    {"cloud": "C", "points": [[1, 2, 3],
                              [4, 5, 6]]},
    {"kdop": "K", "normals": [[1,0,0],[0,1,0],[0,0,1]], "lo": [0, 0, 0], "hi": [1, 1, 1]}
  ],
  "ask": [["C", "A"]] }
)";
  write(shell.work() / "s.json", text);
  const auto with = [&](const std::string& old, const std::string& now, std::string from) {
    REQUIRE(from.find(old) != from.npos);
    return from.replace(from.find(old), old.size(), now);
  };
  const Ran r = shell("isect scene s.json --set A.radius=20 --set C.2=4,5,-0.1 --set K.hi2=3 --save new.json");
  INFO(r.err);
  CHECK(r.status == 0);
  CHECK(r.out == "2 of 2 points of C lie inside A\n");
  CHECK(contents(shell.work() / "s.json") == text);
  const std::string now =
      with("\"radius\":2", "\"radius\":20", with("[4, 5, 6]", "[4, 5, -0.1]", with("[1, 1, 1]", "[1, 3, 1]", text)));
  CHECK(contents(shell.work() / "new.json") == now);
  CHECK(shell("isect scene new.json --save ./new.json --set A.center=0,0.1,0").status == 0);  // the same number
  CHECK(contents(shell.work() / "new.json") == now);

  const Ran other = shell("isect scene s.json --save new.json --set A.radius=1");
  CHECK(other.status == 4);
  CHECK_THAT(other.err, Contains("cannot write 'new.json'"));
  CHECK(contents(shell.work() / "new.json") == now);
  CHECK_THAT(shell("isect scene s.json --set A.radus=1").err, Contains("A.radius"));
  CHECK_THAT(shell("isect scene s.json --set A.radius=-1").err, Contains("at least 0"));

  write(shell.work() / "p.csv", "0,0,0\n1,1,1\n");
  write(shell.work() / "f.json", R"({"objects": [{"cloud": "C", "file": "p.csv"}]})");
  CHECK_THAT(shell("isect scene f.json --set C.1=2,2,2 --save g.json").err, Contains("C.1: it stands in a file"));
  CHECK_FALSE(fs::exists(shell.work() / "g.json"));
}

TEST_CASE("what is no shape is refused, and what no test decides is said to be open", "[scene]") {
  const Shell shell;
  struct Refused {
    const char *objects, *why;
  };
  for (const auto& [objects, why] :
       {Refused{R"({"box": "A", "lo": [1, 0], "hi": [0, 1]})",
                "objects[0].lo: give a lo with no coordinate above that of hi"},
        {R"({"obb": "O", "center": [0, 0], "u": [1, 0], "v": [1, 0], "half": [1, 1]})", "right angles"},
        {R"({"obb": "O", "center": [0, 0], "u": [0, 0], "v": [0, 1], "half": [1, 1]})", "length 1"},
        {R"({"obb": "O", "center": [0, 0], "u": [1, 0], "v": [0, 1], "half": [1, -1]})", "at least 0"},
        {R"({"ray": "r", "origin": [0, 0], "dir": [1, 0], "tmin": 2, "tmax": 1})", "a tmax of at least tmin"},
        {R"({"sphere": "A", "center": [0, 0], "radius": -1e400})", "line 1: objects[0].radius: -1e400 is too large"},
        {R"({"sphere": "A", "center": [0, 0], "radius": 1, "radius": 2})", "objects[0].radius: it is given twice"}}) {
    INFO(objects);
    write(shell.work() / "s.json", std::string(R"({"objects": [)") + objects + "]}");
    const Ran r = shell("isect scene s.json");
    CHECK(r.status == 2);
    CHECK_THAT(r.err, Contains(why));
  }
  write(shell.work() / "box.json", R"({"objects": [{"box": "A", "lo": [0, 0], "hi": [1, 1]}]})");
  CHECK_THAT(shell("isect scene box.json --set A.lo=2,0").err, Contains("A.lo") && Contains("above that of hi"));
  CHECK(shell("isect scene box.json --set A.lo=0.5,0.25").status == 0);  // in the plane two numbers do

  for (const char* command : {"isect scene d.json", "isect render d.json", "isect explain d.json"})
    for (const int levels : {65, 200'000}) {
      write(shell.work() / "d.json", R"({"objects": )" + std::string(static_cast<std::size_t>(levels), '['));
      const Ran r = shell(command);
      INFO(command << ' ' << levels);
      CHECK(r.status == 2);
      CHECK_THAT(r.err, Contains("deeper than the 64 levels"));
    }

  // 0.1 + 1.6 is rounded: the ends alone decide
  const std::string segment = R"({"segment": "s", "from": [0.1, -1.3, -0.7], "to": [1.7, 0.1, 0.3]},
    {"sphere": "S", "center": [1, -0.5, 0], "radius": 0.5}, {"triangle": "T", "points": [[0, -2, 0], [4, 0, 0], [0, 2, 0]]})";
  const Json all = answers(shell, R"({"objects": [)" + segment + R"(], "ask": [["s", "S"], ["s", "T"]]})");
  CHECK(all[0]["verdict"] == "s meets S");
  CHECK(all[1]["verdict"] == "s meets T");
  const Json first = answers(shell, R"({"objects": [{"ray": "r", "origin": [-2, 0, 0], "dir": [1, 0, 0]},
    {"triangle": "T", "points": [[-1.5, -1, 0], [1, 0, 0], [-1.5, 1, 0]]},
    {"sphere": "B", "center": [0, 0, 0], "radius": 1}], "ask": [{"first hit": "r"}]})");
  CHECK(first[0]["verdict"] == "r meets T first, at t = 0.5");
  const Json where = answers(shell, R"({"objects": [)" + segment + R"(], "ask": [{"first hit": "s"}]})");
  CHECK(where[0]["verdict"] == "s meets S first, at t = 0.38412");
}

TEST_CASE("a ray in a polygon's plane is a hit like any other, and corners off one plane are told", "[scene]") {
  const Shell shell;
  const std::string ray = R"({"ray": "r", "origin": [-2, 0, 0], "dir": [1, 0, 0]}, )";
  const std::string later = R"({"sphere": "B", "center": [9, 0, 0], "radius": 1}, )";
  const Json first =
      answers(shell, R"({"objects": [)" + ray + later + R"({"polygon": "P", "points": [[-1, -1, 0], [1, -1, 0],
    [1, 1, 0], [-1, 1, 0]]}], "ask": [{"first hit": "r"}, ["r", "P"]]})");
  CHECK(first[0]["verdict"] == "r meets P first, at t = 1");
  CHECK((first[1]["result"]["hit_in_plane"] == true && first[1]["result"]["coplanar"] == true));
  CHECK_FALSE(first[1]["result"].contains("off_plane"));

  const std::string down = R"({"ray": "r", "origin": [0, 0, 5], "dir": [0, 0, -1]}, )";
  const auto bent = [&](const std::string& z) {
    return answers(shell, R"({"objects": [)" + down +
                              R"({"polygon": "P", "points": [[-1, -1, 0], [1, -1, 0], [1, 1, )" + z +
                              R"(], [-1, 1, 0]]}], "ask": [["r", "P"]]})")[0];
  };
  CHECK(bent("0")["verdict"] == "r meets P");
  CHECK(bent("1e-12")["verdict"] == "r meets P");
  CHECK(bent("1e-12")["result"]["off_plane"].get<double>() > 0);
  CHECK(bent("0.5")["result"]["t"] == 5);  // on a triangle of three of its corners
  CHECK_THAT(shell("isect explain scene.json").out, Contains("off one plane"));
}

TEST_CASE("numbers that read alike are told apart in a walk", "[scene]") {
  const Shell shell;
  const auto told = [&](const std::string& x) {
    write(shell.work() / "s.json", R"({"objects": [{"sphere": "A", "center": [0, 0, 0], "radius": 1},
      {"sphere": "B", "center": [)" + x +
                                       R"(, 0, 0], "radius": 1}], "ask": [{"walk": ["A", "B"]}]})");
    return shell("isect explain s.json").out;
  };
  CHECK_THAT(told("2.0000000000000004"), Contains("d = 2.0000000000000004 > r_a + r_b = 2"));
  CHECK_THAT(told("2"), Contains("d = 2 = r_a + r_b = 2"));
  // the true sum of these radii is not a double, and the distance is the one that it is rounded to
  write(shell.work() / "h.json", R"({"objects": [{"sphere": "A", "center": [0, 0, 0], "radius": 1},
      {"sphere": "B", "center": [1, 0, 0], "radius": 1e-30}], "ask": [{"walk": ["A", "B"]}]})");
  CHECK_THAT(shell("isect explain h.json").out, Contains("d < r_a + r_b, rounded to 1 and 1"));
}

TEST_CASE("what lies in what is told of every pair that can", "[scene]") {
  const Shell shell;
  const std::string ball = R"({"sphere": "S", "center": [0, 0, 0], "radius": 9}, )";
  CHECK(verdict(shell, ball + R"({"capsule": "C", "p": [0, 0, 0], "q": [1, 0, 0], "r": 1})") == "C lies in S");
  CHECK(verdict(shell, ball + R"({"capsule": "C", "p": [0, 0, 0], "q": [1, 0, 0], "r": 20})") == "S lies in C");
  CHECK(verdict(shell, ball + R"({"box": "B", "lo": [0, 0, 0], "hi": [1, 1, 1]})") == "B lies in S");
  CHECK(verdict(shell, ball + R"({"sphere": "T", "center": [1, 0, 0], "radius": 1})") == "T lies in S");
}

TEST_CASE("all pairs: points among themselves are asked where there is nothing else", "[scene]") {
  const Shell shell;
  write(shell.work() / "p.json",
        R"({"objects": [{"point": "P", "at": [0, 0]}, {"point": "Q", "at": [0, 1]}], "ask": "all pairs"})");
  CHECK(shell("isect scene p.json").out == "P and Q differ\n");
}

TEST_CASE("a broken scene fails a check, and its baselines are nobody's to remove", "[scene]") {
  const Shell shell;
  write(shell.work() / "notes/balls.json", two_balls);
  REQUIRE(shell("isect check --dir notes --update=all").status == 0);
  const std::vector<std::string> before = files_in(shell.work() / "notes/snapshots");
  std::string broken = two_balls;
  broken.erase(broken.find("[0, 0, 0]"), 1);
  write(shell.work() / "notes/balls.json", broken);
  const Ran r = shell("isect check --dir notes --update=failed");
  CHECK(r.status == 2);
  CHECK_THAT(r.out + r.err, Contains("line 5, column ") && Contains("no JSON"));
  CHECK(files_in(shell.work() / "notes/snapshots") == before);
}

TEST_CASE("the window writes into the scene's file unless somebody else has changed it", "[scene]") {
  const Shell shell;
  const std::string path = (shell.work() / "s.json").string();
  const std::string text = R"({"objects": [{"sphere": "A", "center": [0, 0.10, 0], "radius": 2 }]} // mine)";
  write(path, text);
  isect::program::scene::KeptFile file(path);
  viz::Parameters now = isect::program::scene::read_scene(text, "").parameters;
  for (const double radius : {3.5, 0.25}) {  // again, after its own change
    now.at("A.radius") = radius;
    file.save(now);
    std::string expected = text;
    expected.replace(expected.find("\"radius\": 2 ") + 10, 1, viz::to_text(radius));
    CHECK(contents(path) == expected);
  }
  write(path, text + "\n");
  CHECK_THROWS_WITH(file.save(now), Contains("somebody has changed it"));
  CHECK(contents(path) == text + "\n");
  fs::remove(path);
  CHECK_THROWS_AS(file.save(now), viz::FileError);
  CHECK_FALSE(fs::exists(path));
  CHECK_THROWS_AS(isect::program::scene::KeptFile("/dev/null"), viz::FileError);
}

TEST_CASE("a scene that was saved is as if opened from its file", "[scene]") {
  const std::string text = R"({"objects": [{"sphere": "A", "center": [0, 0, 0], "radius": 2}]} // mine)";
  const viz::Lesson& scene = isect::program::scene::kept_lesson_of(text, "");
  viz::Parameters now = scene.presets.front().parameters;
  now.at("A.radius") = 0.25;
  isect::program::scene::keep(scene, "", now);
  CHECK(scene.presets.front().parameters == now);
  CHECK_THAT(scene.made_from, Contains("0.25"));
  CHECK(scene.steps(now).steps.size() == 1);
}

TEST_CASE("a drag in a scene snaps to where any of its answers changes, and says which", "[scene]") {
  const std::string text = R"({"objects": [{"sphere": "A", "center": [0, 0, 0], "radius": 1},
    {"sphere": "B", "center": [4, 0, 0], "radius": 1}, {"sphere": "C", "center": [0, 9, 0], "radius": 1}],
    "ask": [["A", "B"], ["A", "C"]]})";
  const viz::Lesson& scene = isect::program::scene::kept_lesson_of(text, "");
  const viz::Parameters before = scene.presets.front().parameters;
  const viz::Walk walk = scene.steps(before);
  const auto handle = std::ranges::find(walk.steps[0].scene.handles, "A.center", &viz::Handle::parameter);
  REQUIRE(handle != walk.steps[0].scene.handles.end());
  const viz::Vec3 to(2.75, 0, 0);
  const auto found = viz::find_border(scene, viz::way_of(scene, before, *handle, handle->at, to), 0, 1.25, 1);
  REQUIRE(found);
  CHECK(found->exact);
  CHECK(std::get<viz::Vec3>(found->setting.at("A.center")) == viz::Vec3(2, 0, 0));
  CHECK(found->told == "A and B touch, exactly");
}

TEST_CASE("the parts of a scene's objects bear their names, in figures and in words", "[scene]") {
  const Shell shell;
  write(shell.work() / "s.json", R"({"objects": [{"ray": "r1", "origin": [-4, 0, 0], "dir": [1, 0, 0]},
    {"capsule": "C", "p": [0, 0.1, 0], "q": [0.3, 1, 0.2], "r": 0.7}, {"box": "A", "lo": [1, 1, 1], "hi": [2, 2, 2]},
    {"obb": "B", "center": [5, 0, 0], "u": [1, 0, 0], "v": [0, 1, 0], "w": [0, 0, 1], "half": [1, 1, 1]},
    {"polygon": "P", "points": [[6, -1, -1], [6, 1, -1], [6, 1, 1]]}], "ask": [["r1", "C"], ["r1", "A"]]})");
  REQUIRE(shell("isect render s.json --step 1 --format svg --out out").status == 0);
  const std::string svg = contents(shell.work() / "out/scene/s/01-objects.svg");
  for (const char* id : {"arrow-r1", "capsule-C", "line-C", "solid-A", "solid-B", "region-P"})
    CHECK_THAT(svg, Contains(std::string("<g id=\"") + id));
  CHECK_THAT(svg, !Contains("id=\"solid-second") && !Contains("id=\"region-second"));
  const Ran words = shell("isect explain s.json");
  CHECK_THAT(words.out, Contains("oriented box B") && Contains("r₁ and A: r₁ misses A"));
  CHECK_THAT(words.out, !Contains("segment"));  // the capsule is described by its numbers
}

TEST_CASE("a missing file of a mesh is told with the scene's name", "[scene]") {
  const Shell shell;
  write(shell.work() / "s.json", R"({"objects": [{"mesh": "M", "file": "none.obj"}], "ask": []})");
  for (const char* command : {"isect scene s.json", "isect render s.json --out out", "isect explain s.json"}) {
    const Ran r = shell(command);
    CHECK(r.status == 4);
    CHECK_THAT(r.err, Contains("s.json: ") && Contains("none.obj") && Contains("objects[0].file"));
  }
}

TEST_CASE("where an outline crosses itself, that is said, and what has no area is not decided", "[scene]") {
  const Shell shell;
  const std::string ray = R"({"ray": "r", "origin": [2.1, 1.5, -2], "dir": [0, 0, 1]}, )";
  CHECK(verdict(shell, ray + R"({"polygon": "P", "points": [[-1,-1,0],[1,1,0],[1,-1,0],[-1,1,0]]})") ==
        "r and P: not decided, as the outline of P has no area, crosses or touches itself");
  write(shell.work() / "s.json", R"({"objects": [)" + ray + R"({"polygon": "Q", "points":
    [[1,1,0],[4,1,0],[2,3,0],[2,0,0],[3,3,0]]}], "ask": [["r", "Q"]]})");
  CHECK_THAT(shell("isect explain s.json").out, Contains("Q crosses or touches itself") && Contains("even-odd rule"));
}

TEST_CASE("clipping a polygon leaves its holes out", "[scene]") {
  const Shell shell;
  const std::string holed =
      R"({"objects": [{"polygon": "H", "rings": [[[0,0],[6,0],[6,6],[0,6]], [[2,2],[2,4],[4,4],[4,2]]]},
    {"box": "W", "lo": [2.5,2.5], "hi": [3.5,3.5]}, {"box": "V", "lo": [1,1], "hi": [8,3.5]}], "ask": )";
  const Json all = answers(shell, holed + R"([{"clip": "H", "to": "W"}, ["H", "W"], {"clip": "H", "to": "V"}]})");
  CHECK(all[0]["verdict"] == "nothing of H lies in W");  // it lies in the hole
  CHECK(all[1]["verdict"] == "H and W are disjoint");
  CHECK(all[2]["verdict"] == "the part of H in V has 2 outlines, of 4 and 4 corners");
  REQUIRE(all[2]["rings"].size() == 2);
  const auto area = [](const Json& ring) {
    double twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Json &p = ring[i], &q = ring[(i + 1) % ring.size()];
      twice += p[0].get<double>() * q[1].get<double>() - p[1].get<double>() * q[0].get<double>();
    }
    return std::abs(twice) / 2;
  };
  CHECK(area(all[2]["rings"][0]) == 5 * 2.5);
  CHECK(area(all[2]["rings"][1]) == 2 * 1.5);
  write(shell.work() / "walk.json", holed + R"([{"walk": ["H", "W"], "lesson": "clipping"}]})");
  const Ran walk = shell("isect scene walk.json");
  CHECK(walk.status == 2);
  CHECK_THAT(walk.err, Contains("ask[0]: ") && Contains("H has holes"));
}

TEST_CASE("in the plane a line and a segment that lie along each other share a stretch", "[scene]") {
  const Shell shell;
  const std::string line = R"({"line": "l", "origin": [0,0], "dir": [1,0]}, )",
                    ray = R"({"ray": "r", "origin": [2,0], "dir": [-3,0]}, )",
                    inside = R"({"segment": "q", "from": [1,0], "to": [3,0]})",
                    behind = R"({"segment": "q", "from": [2.5,0], "to": [6,0]})",
                    across = R"({"segment": "q", "from": [1,-1], "to": [1,1]})";
  CHECK(verdict(shell, line + inside) == "l and q share a stretch");
  CHECK(verdict(shell, ray + inside) == "r and q share a stretch");
  CHECK(verdict(shell, ray + behind) == "r misses q");
  CHECK(verdict(shell, line + across) == "l and q have one point in common");
  const std::string first = R"({"segment": "q", "from": [-1,0], "to": [-4,0]})";
  CHECK(verdict(shell, ray + first, R"([{"first hit": "r"}])") == "r meets q first, at t = 1");
}

TEST_CASE("what a hierarchy leaves out is named, and a frustum's planes are said to be rounded", "[scene]") {
  const Shell shell;
  write(shell.work() / "s.json", R"({"objects": [{"box": "A", "lo": [0,0,0], "hi": [1,1,1]},
    {"box": "B", "lo": [2,0,0], "hi": [3,1,1]}, {"point": "P", "at": [3,0,-3]},
    {"kdop": "D", "normals": [[1,0,0],[0,1,0],[0,0,1]], "lo": [4,0,0], "hi": [5,1,1]},
    {"frustum": "F", "eye": [0,0,0], "forward": [0,0,-1], "up": [0,1,0], "angle": 90, "near": 1, "far": 6}],
    "ask": [{"hierarchy": "all"}, ["P", "F"]]})");
  const std::string words = shell("env COLUMNS=200 isect explain s.json").out;
  CHECK_THAT(words, Contains("Without D, F, whose corners would be rounded"));
  CHECK_THAT(words, Contains("planes of F are those of its angle, rounded"));
}

TEST_CASE("a ray enters a ball and leaves it, within its own range", "[scene]") {
  const Shell shell;
  const auto formula = [&](const std::string& range) {
    write(shell.work() / "s.json",
          R"({"objects": [{"ray": "r", "origin": [-3, 0, 0], "dir": [1, 0, 0])" + range +
              R"(}, {"sphere": "S", "center": [0, 0, 0], "radius": 1}], "ask": [["r", "S"]]})");
    return shell("isect explain s.json --brief").out;
  };
  CHECK_THAT(formula(""), Contains("t_in = 2, t_out = 4"));
  CHECK_THAT(formula(R"(, "tmax": 3.5)"), Contains("t_in = 2, t_out = 3.5"));
  CHECK_THAT(formula(R"(, "tmin": 2.5)"), Contains("t_in = 2.5, t_out = 4"));
}

TEST_CASE("the examples are scenes, each under fifteen lines of objects, and answer", "[scene]") {
  const Shell shell;
  int count = 0;
  for (const auto& entry : fs::directory_iterator(ISECT_EXAMPLE_SCENES)) {
    if (entry.path().extension() != ".json") continue;
    const std::string text = contents(entry.path());
    INFO(entry.path());
    CHECK(std::ranges::count(text, '\n') <= 16);
    const Ran r = shell("isect scene " + entry.path().string());
    CHECK(r.status == 0);
    CHECK_FALSE(r.out.empty());
    ++count;
  }
  CHECK(count >= 10);
}

}  // namespace scene_test
