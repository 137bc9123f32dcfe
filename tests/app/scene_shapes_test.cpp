// Scenes of many numbers: k-DOPs, frusta, hulls, meshes and clouds, files of other programs, and what is made of them.

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/app/shell.h"
#include "tests/catch.h"

namespace scene_shapes_test {
using namespace isect::test;
using Catch::Matchers::StartsWith;
using Json = nlohmann::ordered_json;

namespace {

Json answers(const Shell& shell, const std::string& objects, const std::string& ask) {
  write(shell.work() / "scene.json", R"({"objects": [)" + objects + R"(], "ask": )" + ask + "}");
  const Ran r = shell("isect scene scene.json --json");
  INFO(objects << "\n" << r.err);
  REQUIRE(r.status == 0);
  return Json::parse(r.out);
}

std::string verdict(const Shell& shell, const std::string& objects) {
  const Json all = answers(shell, objects, R"("all pairs")");
  REQUIRE(all.size() == 1);
  return all[0]["verdict"];
}

std::string refused(const Shell& shell, const std::string& objects, const std::string& ask = "[]") {
  write(shell.work() / "bad.json", "{\"objects\": [\n" + objects + "],\n\"ask\": " + ask + "}");
  const Ran r = shell("isect scene bad.json");
  INFO(objects << "\n" << ask << "\n" << r.out);
  CHECK(r.status == 2);
  CHECK_THAT(r.err, StartsWith("isect: bad.json: "));
  return r.err;
}

/// A tetrahedron of volume 4/3, its corners at (0,0,0), (2,0,0), (0,2,0), (0,0,2); one coordinate is not a float.
constexpr const char* tetrahedron_obj =
    "# comment\nv 0 0 0\nv 2 0 0\nv 0 2 0.1\nv 0 0 2\nvn 0 0 1\nf 1/1/1 3//1 2\nf 1 2 4\nf 1 4 3\nf -3 -2 -1\n";

template <class T>
void append(std::string& to, T value, bool big_endian = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (big_endian) std::reverse(raw, raw + sizeof(T));
  to.append(raw, sizeof(T));
}

const float corners[4][3] = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0.5F}, {0, 0, 2}};
const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

std::string binary_stl() {
  std::string bytes = "solid, or so it says";
  bytes.resize(80, ' ');
  append(bytes, std::uint32_t{4});
  for (const auto& face : faces) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.0F);
    for (const int corner : face)
      for (const float x : corners[corner]) append(bytes, x);
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string binary_ply(bool big_endian) {
  std::string bytes = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                      "_endian 1.0\ncomment made by a test\nelement vertex 4\nproperty uchar red\nproperty float x\n"
                      "property float y\nproperty float z\nelement face 4\nproperty list uchar int vertex_indices\n"
                      "end_header\n";
  for (const auto& p : corners) {
    bytes += '\x7f';
    for (const float x : p) append(bytes, x, big_endian);
  }
  for (const auto& face : faces) {
    bytes += '\x03';
    for (const int corner : face) append(bytes, std::int32_t{corner}, big_endian);
  }
  return bytes;
}

}  // namespace

TEST_CASE("k-DOPs, frusta and hulls are asked as they lie", "[scene]") {
  const Shell shell;
  const std::string kdop =
      R"({"kdop": "K", "normals": [[1,0,0],[0,1,0],[0,0,1],[1,1,1]], "lo": [0,0,0,0], "hi": [1,1,1,2]})";
  CHECK(verdict(shell, kdop + R"(, {"point": "p", "at": [0.5, 0.5, 0.5]})") == "p lies inside K");
  CHECK(verdict(shell, kdop + R"(, {"point": "p", "at": [1, 0.5, 0.5]})") == "p lies on the boundary of K");
  CHECK(verdict(shell, kdop + R"(, {"point": "p", "at": [1, 1, 0.25]})") == "p lies outside K");
  const auto other = [](const std::string& lo) {
    return R"(, {"kdop": "L", "normals": [[1,0,0],[0,1,0],[0,0,1],[1,1,1]], "lo": [0,0,0,)" + lo +
           R"(], "hi": [1,1,1,3]})";
  };
  CHECK(verdict(shell, kdop + other("2.5")) == "K and L are disjoint");
  CHECK(verdict(shell, kdop + other("2")) == "K and L touch");

  const std::string frustum =
      R"({"frustum": "F", "eye": [0,0,0], "forward": [2,0,0], "up": [0,1,0], "angle": 90, "near": 1, "far": 4},)";
  CHECK(verdict(shell, frustum + R"({"box": "A", "lo": [2,-1,-1], "hi": [3,1,1]})") == "A lies in F");
  CHECK(verdict(shell, frustum + R"({"box": "A", "lo": [-2,-1,-1], "hi": [-1,1,1]})") == "F and A are disjoint");
  CHECK(verdict(shell, frustum + R"({"sphere": "S", "center": [1,0,0], "radius": 0.5})") == "F and S overlap");

  const std::string hull = R"({"hull": "H", "points": [[0,0,0],[2,0,0],[0,2,0],[0,0,2],[0.25,0.25,0.25]]},)";
  CHECK(verdict(shell, hull + R"({"point": "p", "at": [0.5, 0.5, 0.5]})") == "p lies inside H");
  CHECK(verdict(shell, hull + R"({"point": "p", "at": [1, 1, 0]})") == "p lies on the boundary of H");
  CHECK(verdict(shell, hull + R"({"point": "p", "at": [1, 1, 0.125]})") == "p lies outside H");
  CHECK(verdict(shell, hull + R"({"ray": "r", "origin": [-1, 0.5, 0.5], "dir": [1,0,0]})") == "r meets H");
  CHECK(verdict(shell, hull + R"({"line": "g", "origin": [9, 1.5, 1.5], "dir": [1,0,0]})") == "g misses H");
  const std::string flat = R"({"hull": "H", "points": [[0,0],[4,0],[4,4],[0,4],[1,1]]},)";
  CHECK(verdict(shell, flat + R"({"point": "p", "at": [4, 1]})") == "p lies on the boundary of H");
}

TEST_CASE("convex solids, balls, capsules, triangles, meshes and lines in space are asked about each other",
          "[scene]") {
  const Shell shell;
  // Each pair once touches in whole numbers and once lies apart by a little
  const std::string
      box = R"({"box": "A", "lo": [0,0,0], "hi": [4,4,4]})",
      tilted = R"(, {"obb": "O", "center": [5,0,2], "u": [0.6,0.8,0], "v": [-0.8,0.6,0], "w": [0,0,1],)",
      triangle = R"({"triangle": "T", "points": [[0,0,0],[9,0,0],[0,9,0]]})",
      frustum =
          R"({"frustum": "F", "eye": [0,0,0], "forward": [2,0,0], "up": [0,1,0], "angle": 90, "near": 1, "far": 4},)",
      capsule = R"(, {"capsule": "C", "p": [7,8,-10], "q": [7,8,20], "r": )";
  write(shell.work() / "t.obj", tetrahedron_obj);
  const std::string mesh = R"({"mesh": "M", "file": "t.obj"}, )";
  const auto expect = [&](const std::string& objects, const char* expected) {
    INFO(objects);
    CHECK(verdict(shell, objects) == expected);
  };
  expect(box + tilted + R"( "half": [1,1,1]})", "A and O overlap");
  expect(box + tilted + R"( "half": [0.5,0.5,0.5]})", "A and O are disjoint");
  expect(box + capsule + "5}", "A and C touch");
  expect(box + capsule + "4.9999999}", "A and C are disjoint");
  expect(triangle + R"(, {"sphere": "S", "center": [-2,-3,6], "radius": 7})", "T and S touch");
  expect(triangle + R"(, {"capsule": "C", "p": [2,2,-5], "q": [2,2,5], "r": 0})", "T and C overlap");
  expect(triangle + R"(, {"triangle": "U", "points": [[1,1,-1],[1,1,1],[2,2,5]]})", "T and U overlap");
  expect(triangle + R"(, {"triangle": "U", "points": [[1,1,1],[1,1,2],[2,2,5]]})", "T and U are disjoint");
  expect(triangle + R"(, {"point": "p", "at": [4.5,4.5,0]})", "p lies on T");
  expect(triangle + R"(, {"point": "p", "at": [5,4.5,0]})", "p does not lie on T");
  expect(triangle + tilted + R"( "half": [1,1,1]})", "T and O are disjoint");
  expect(triangle + tilted + R"( "half": [1,1,2]})", "T and O touch");
  expect(frustum + R"({"point": "p", "at": [2,0,0]})", "p lies inside F");
  expect(frustum + R"({"point": "p", "at": [4.5,0,0]})", "p lies outside F");
  expect(frustum + R"({"capsule": "C", "p": [5,0,0], "q": [9,0,0], "r": 0.5})", "F and C are disjoint");
  expect(frustum + R"({"segment": "s", "from": [0,0,0], "to": [2,0,0]})", "s meets F");
  expect(R"({"plane": "P", "normal": [1,0,0], "d": -9})" + tilted + R"( "half": [1,1,1]})", "P and O are disjoint");
  expect(R"({"plane": "P", "normal": [1,0,0], "d": -5})" + tilted + R"( "half": [1,1,1]})", "P cuts O");
  expect(R"({"plane": "P", "normal": [1,0,0], "d": -12})" + capsule + "5}", "P and C touch");
  expect(R"({"plane": "P", "normal": [1,0,0], "d": 1}, {"plane": "Q", "normal": [2,0,0], "d": 2})",
         "P and Q are the same");
  expect(R"({"plane": "P", "normal": [1,0,0], "d": 1}, {"plane": "Q", "normal": [2,0,0], "d": 3})",
         "P and Q are parallel");
  expect(mesh + R"({"point": "p", "at": [0.25,0.25,0.25]})", "p lies inside M");
  expect(mesh + R"({"point": "p", "at": [0,0,1]})", "p lies on the boundary of M");
  expect(mesh + R"({"sphere": "S", "center": [0.25,0.25,0.25], "radius": 0.125})", "S lies in M");
  expect(mesh + R"({"sphere": "S", "center": [0.25,0.25,0.25], "radius": 0.25})", "S meets 3 of 4 triangles of M");
  expect(R"({"line": "g", "origin": [0,0,0], "dir": [1,0,0]}, {"line": "h", "origin": [3,-1,0], "dir": [0,1,0]})",
         "g and h have one point in common");
  expect(R"({"line": "g", "origin": [0,0,0], "dir": [1,0,0]}, {"line": "h", "origin": [3,-1,1e-300], "dir": [0,1,0]})",
         "g and h are skew");
  expect(R"({"line": "g", "origin": [0,0], "dir": [1,0]}, {"ray": "h", "origin": [3,1], "dir": [2,0]})",
         "g and h are parallel");
  expect(R"({"sphere": "S", "center": [7,8], "radius": 5}, {"triangle": "T", "points": [[0,0],[4,0],[4,4]]})",
         "S and T touch");
  expect(R"({"sphere": "S", "center": [7,8], "radius": 4.5}, {"triangle": "T", "points": [[0,0],[4,0],[4,4]]})",
         "S and T are disjoint");
}

TEST_CASE("the points of a cloud are told apart by where they lie", "[scene]") {
  const Shell shell;
  const std::string cloud = R"({"cloud": "C", "points": [[0,0],[1,0],[2,0],[0.5,0.25],[3,3]]},)";
  for (const std::string shape :
       {R"({"box": "A", "lo": [0,-1], "hi": [2,1]})", R"({"sphere": "A", "center": [1,0], "radius": 1})",
        R"({"polygon": "A", "points": [[0,-1],[2,-1],[2,1],[0,1]]})",
        R"({"kdop": "A", "normals": [[1,0],[0,1]], "lo": [0,-1], "hi": [2,1]})",
        R"({"obb": "A", "center": [1,0], "u": [0,1], "v": [1,0], "half": [1,1]})",
        R"({"hull": "A", "points": [[0,-1],[2,-1],[2,1],[0,1]]})"}) {
    INFO(shape);
    const Json all = answers(shell, cloud + shape, R"([["C", "A"]])");
    CHECK(all[0]["verdict"] == "2 of 5 points of C lie inside A, 2 on its boundary");
    CHECK(all[0]["result"] == Json::parse(R"({"in": [1, 3], "on": [0, 2], "out": [4]})"));
  }
}

TEST_CASE("meshes come from OBJ, STL and PLY, clouds from CSV, with the numbers of the file", "[scene]") {
  const Shell shell;
  write(shell.work() / "in/t.obj", tetrahedron_obj);
  write(shell.work() / "in/t.stl", binary_stl());
  std::string text = "solid t\n";
  for (const auto& face : faces) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (const int corner : face) {
      text += "  vertex";
      for (const float x : corners[corner]) text += " " + std::to_string(x);
      text += "\n";
    }
    text += " endloop\nendfacet\n";
  }
  write(shell.work() / "in/text.STL", text + "endsolid t\n");
  write(shell.work() / "in/little.ply", binary_ply(false));
  write(shell.work() / "in/big.ply", binary_ply(true));
  write(shell.work() / "in/text.ply",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
        "element face 4\nproperty list uchar int vertex_index\nend_header\n0 0 0\n2 0 0\n0 2 0.5\n0 0 2\n"
        "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  for (const std::string file : {"t.obj", "t.stl", "text.STL", "little.ply", "big.ply", "text.ply"}) {
    INFO(file);
    const Json all = answers(shell, R"({"mesh": "M", "file": "in/)" + file + R"("},
      {"ray": "r", "origin": [-1, 0.5, 0.5], "dir": [2, 0, 0]})",
                             R"([["r", "M"], {"fit": "M", "volume": "hull"}])");
    CHECK(all[0]["result"]["t"] == 0.5);
    CHECK(all[1]["volumes"][0]["result"]["vertices"].size() == 4);  // corners are shared
    std::set<double> heights;
    for (const Json& p : all[1]["volumes"][0]["result"]["vertices"]) heights.insert(p[2].get<double>());
    CHECK(heights == std::set<double>{0, file == "t.obj" ? 0.1 : 0.5, 2});  // 0.1 is not a float
    CHECK(all[1]["volumes"][0]["fitted"] == "hull");
  }
  write(shell.work() / "in/p.csv", "x;y\n# a comment\n0,0;0\n1;0\n\n0.1; 1e-1\n");
  const Json fit = answers(shell, R"({"cloud": "C", "file": "in/p.csv"})", R"([{"fit": "C", "volume": "box"}])");
  CHECK(fit[0]["volumes"][0]["result"] == Json::parse(R"({"lo": [0.0, 0.0], "hi": [1.0, 0.1]})"));
}

TEST_CASE("a figure of a short file can be opened without it", "[scene]") {
  const Shell shell;
  write(shell.work() / "in/t.obj", tetrahedron_obj);
  write(shell.work() / "in/s.json", R"({"objects": [{"mesh": "M", "file": "t.obj"}], "ask": [{"fit": "M"}]})");
  REQUIRE(shell("isect render in/s.json --format png --step 1").status == 0);
  std::filesystem::remove_all(shell.work() / "in");
  CHECK(shell("isect show figures/scene/s/01-objects.png").status == 77);  // no display, and no complaint before that
}

TEST_CASE("volumes fit their points, parts lie in their box, hierarchies hold all", "[scene]") {
  const Shell shell;
  const std::string cube =
      R"({"cloud": "C", "points": [[0,0,0],[2,0,0],[0,2,0],[2,2,0],[0,0,2],[2,0,2],[0,2,2],[2,2,2],[1,1,1]]})";
  const Json all = answers(shell, cube, R"([{"fit": "C"}, {"fit": "C", "volume": "sphere"}])");
  REQUIRE(all[0]["volumes"].size() == 5);
  const auto size = [&](int i) { return all[0]["volumes"][i]["volume"].get<double>(); };
  CHECK(size(0) == Approx(4 * std::acos(-1) / 3 * std::pow(3, 1.5)));
  for (const int i : {1, 2, 3, 4}) CHECK(size(i) == Approx(8));
  CHECK(all[0]["verdict"] == "the hull of C has volume 8");
  CHECK(all[1]["volumes"][0]["result"]["center"] == Json::parse("[1.0, 1.0, 1.0]"));

  const std::string window = R"({"box": "W", "lo": [0,0], "hi": [2,1]},)";
  const auto clipped = [&](const std::string& what) {
    return answers(shell, window + what, R"([{"clip": "x", "to": "W"}])")[0];
  };
  CHECK(clipped(R"({"segment": "x", "from": [-1,0.5], "to": [3,0.5]})")["range"] == Json::parse("[0.25, 0.75]"));
  CHECK(clipped(R"({"ray": "x", "origin": [-1,0.5], "dir": [1,0]})")["verdict"] ==
        "of x the part from t = 1 to 3 lies in W");
  CHECK(clipped(R"({"line": "x", "origin": [-1,1], "dir": [0,1]})")["range"].is_null());
  CHECK(clipped(R"({"segment": "x", "from": [-1,0], "to": [1,2]})")["verdict"] == "of x one point lies in W: t = 0.5");
  CHECK(clipped(R"({"triangle": "x", "points": [[1,0.5],[5,0.5],[1,-3.5]]})")["vertices"].size() == 4);
  CHECK(clipped(R"({"polygon": "x", "points": [[3,3],[4,3],[4,4]]})")["verdict"] == "nothing of x lies in W");

  const std::string wall = R"({"plane": "E", "normal": [0,1], "d": -1},)";  // y >= 1 is kept
  const auto above = [&](const std::string& what) {
    return answers(shell, wall + what, R"([{"clip": "x", "to": "E"}])")[0];
  };
  const Json ray = above(R"({"ray": "x", "origin": [0,0], "dir": [1,0.5]})");
  CHECK(ray["range"] == Json::parse(R"([2.0, "inf"])"));
  CHECK(ray["verdict"] == "of x the part from t = 2 on lies where the normal of E points");
  CHECK(above(R"({"line": "x", "origin": [0,0], "dir": [1,-0.5]})")["verdict"] ==
        "of x the part up to t = −2 lies where the normal of E points");
  CHECK(above(R"({"line": "x", "origin": [0,1], "dir": [1,0]})")["verdict"] ==
        "of x all lies where the normal of E points");
  CHECK(above(R"({"segment": "x", "from": [0,0], "to": [3,2]})")["range"] == Json::parse("[0.5, 1.0]"));
  CHECK(above(R"({"segment": "x", "from": [0,0], "to": [3,1]})")["verdict"] ==
        "of x one point lies where the normal of E points: t = 1");
  CHECK(above(R"({"segment": "x", "from": [1e17,0], "to": [3,1.0000000000000002]})")["verdict"] !=
        "of x one point lies where the normal of E points: t = 1");
  CHECK(above(R"({"ray": "x", "origin": [0,0], "dir": [1,0]})")["verdict"] ==
        "nothing of x lies where the normal of E points");
  CHECK(above(R"({"triangle": "x", "points": [[0,0],[4,0],[0,4]]})")["verdict"] ==
        "the part of x where the normal of E points has 3 corners");
  CHECK(above(R"({"polygon": "x", "points": [[0,0],[4,0],[4,4],[0,4]]})")["vertices"] ==
        Json::parse("[[4.0, 1.0], [4.0, 4.0], [0.0, 4.0], [0.0, 1.0]]"));

  const Json tree = answers(shell, R"({"point": "a", "at": [0,0]}, {"sphere": "b", "center": [5,0], "radius": 1},
    {"box": "c", "lo": [0,5], "hi": [1,6]}, {"ray": "r", "origin": [0,0], "dir": [1,0]})",
                            R"([{"hierarchy": "all"}, {"hierarchy": ["a", "b"]}])");
  CHECK(tree[0]["hierarchy"] == Json::parse(R"(["a", "b", "c"])"));  // a ray has no box
  CHECK(tree[0]["leaves"] == 3);
  CHECK(tree[1]["verdict"] == "3 nodes, depth 1");
}

TEST_CASE("cylinders and cones are asked as the core asks them, and what no test decides is told", "[scene]") {
  const Shell shell;
  const std::string pillar = R"({"cylinder": "A", "p": [0,0,0], "q": [0,4,0], "r": 2},)",
                    cone = R"({"cone": "K", "apex": [0,3,0], "base": [0,0,0], "r": 4},)";
  const auto with_pillar = [&](const std::string& other) { return verdict(shell, pillar + other); };
  const auto with_cone = [&](const std::string& other) { return verdict(shell, cone + other); };
  CHECK(with_pillar(R"({"point": "x", "at": [1,2,1]})") == "x lies inside A");
  CHECK(with_pillar(R"({"point": "x", "at": [1.2,4,1.6]})") == "x lies outside A");  // by less than an ulp
  CHECK(with_cone(R"({"point": "x", "at": [0,3,0]})") == "x lies on the boundary of K");
  CHECK(with_pillar(R"({"sphere": "x", "center": [3,2,0], "radius": 1})") == "A and x touch");
  CHECK(with_pillar(R"({"sphere": "x", "center": [0,2,0], "radius": 2})") == "x lies in A");
  CHECK(with_cone(R"({"sphere": "x", "center": [0,1.25,0], "radius": 1.25})") == "x lies in K");
  CHECK(with_cone(R"({"sphere": "x", "center": [0,1.5,0], "radius": 1.5})") == "K and x overlap");
  CHECK(with_cone(R"({"sphere": "x", "center": [0,0,0], "radius": 4})") == "K lies in x");
  CHECK(with_pillar(R"({"plane": "x", "normal": [0,1,0], "d": -4})") == "A and x touch");
  CHECK(with_cone(R"({"plane": "x", "normal": [1,0,0], "d": 0})") == "x cuts K");
  const Json along = answers(shell, pillar + R"({"segment": "x", "from": [-4,1,0], "to": [4,1,0]})", R"([["x", "A"]])");
  CHECK(along[0]["result"] == Json::parse(R"({"hit": true, "t_in": 0.25, "t_out": 0.75})"));
  CHECK(along[0]["query"]["kind"] == "ray_cylinder");
  const Json first = answers(shell, pillar + cone + R"({"ray": "x", "origin": [-9,1.5,0], "dir": [1,0,0]})",
                             R"([{"first hit": "x"}])");  // both at t = 7
  CHECK(first[0]["verdict"] == "x meets A and K at the same t");
  CHECK(with_cone(R"({"capsule": "x", "p": [0,0,0], "q": [0,1,0], "r": 1})") ==
        "K and x: not decided, as no test is made for a cone and a capsule");
  const Json cloud =
      answers(shell, cone + R"({"cloud": "x", "points": [[0,0,0],[0,1,0],[4,0,0.5]]})", R"([["x", "K"]])");
  CHECK(cloud[0]["verdict"] == "1 of 3 points of x lies inside K, 1 on its boundary");
  CHECK(answers(shell, cone + R"({"point": "x", "at": [0,9,0]})", R"([{"hierarchy": "all"}])")[0]["leaves"] == 2);
  CHECK_THAT(refused(shell, R"({"cylinder": "A", "p": [0,0,0], "q": [0,0,0], "r": 2})"),
             Contains("give a q other than p"));
  CHECK_THAT(refused(shell, R"({"cone": "K", "apex": [0,0,0], "base": [0,0,1], "r": -2})"), Contains("-2 is below 0"));
  CHECK_THAT(refused(shell, R"({"": "F", "eye": [0,0,0], "forward": [1,0,0], "up": [0,1,0], "angle": 60,
    "near": 1, "far": 2})"),
             Contains("no type of object"));
  CHECK_THAT(refused(shell, R"({"circle": "C", "center": [0,0,0], "radius": 1})"), Contains("a circle in space"));
  CHECK_THAT(refused(shell, R"({"cone": "K", "apex": [0,0], "base": [0,1], "r": 2})"),
             Contains("a cone has three coordinates; there is none in the plane"));
}

TEST_CASE("a walk tells the lesson's steps on the scene's numbers", "[scene]") {
  const Shell shell;
  write(shell.work() / "w.json", R"({"objects": [{"sphere": "A", "center": [0,0,0], "radius": 2},
    {"sphere": "B", "center": [3,4,0], "radius": 3}], "ask": [{"walk": ["A", "B"]}]})");
  const std::string told = shell("isect explain w.json").out;
  const std::string lesson =
      shell("isect explain sphere-sphere --set a=0,0,0 --set r_a=2 --set b=3,4,0 --set r_b=3").out;
  CHECK_THAT(told, Contains("here A is a, and B is b") && Contains("Verdict: the balls touch"));
  const std::string line = "return d_sq <= s_sq";
  for (const std::string both : {"Nearer than they reach?", "25", "How they relate"}) {
    INFO(both);
    CHECK_THAT(told, Contains(both));
    CHECK_THAT(lesson, Contains(both));
  }
  CHECK_THAT(shell("isect scene w.json").out, StartsWith("A and B touch"));

  // Walks of polygons and boxes that no lesson has.
  const std::string flat = R"({"box": "W", "lo": [-2,-1], "hi": [2,1]}, {"segment": "s", "from": [-3,0], "to": [1,0]},
    {"polygon": "P", "points": [[3,0],[2,1.5],[0,2],[-2,1.5],[-3,0],[-2,-1.5],[0,-2],[2,-1.5]]})";
  const Json two = answers(shell, flat, R"([{"walk": ["W", "s"]}, {"walk": ["P", "W"]}])");
  CHECK(two[0]["walk"] == Json::parse(R"(["s", "W"])"));
  CHECK(two[1]["verdict"] == "the part of P in W has 4 corners");
  write(shell.work() / "flat.json", R"({"objects": [)" + flat + R"(], "ask": [{"walk": ["P", "W"]}]})");
  CHECK_THAT(shell("isect explain flat.json").out, Contains("Cut at the top side") && !Contains("**"));
  CHECK(shell("isect render flat.json").status == 0);
  const std::string obb = R"({"obb": "A", "center": [-1,0,0], "u": [0.8,0.6,0], "v": [-0.6,0.8,0], "w": [0,0,1],
    "half": [1,0.75,0.5]}, {"obb": "B", "center": [2,0,0], "u": [1,0,0], "v": [0,1,0], "w": [0,0,1], "half": [1,1,1]},
    {"ray": "r", "origin": [0,0,3], "dir": [0,0,-1]}, {"triangle": "t", "points": [[-1,-1,0],[2,-1,0],[-1,2,1]]})";
  const Json space = answers(shell, obb, R"([{"walk": ["A", "B"]}, {"walk": ["t", "r"]}])");
  CHECK(space[0]["result"]["relation"] == "disjoint");
  CHECK(space[1]["result"]["hit"] == true);
  write(shell.work() / "space.json",
        R"({"objects": [)" + obb + R"(], "ask": [{"walk": ["A", "B"]}, {"walk": ["t", "r"]}]})");
  CHECK_THAT(shell("isect explain space.json").out, Contains("The normals of a") &&
                                                        Contains("Which coordinate to drop?") &&
                                                        Contains("Verdict: the ray hits"));
  CHECK(shell("isect render space.json").status == 0);
  CHECK(shell("isect render w.json").status == 0);
}

TEST_CASE("a point in a polygon and the hull of points are walked as their lessons do", "[scene]") {
  const Shell shell;
  const std::string objects =
      R"({"point": "q", "at": [0, 0]}, {"polygon": "P", "points": [[-2,-1],[2,-1],[2,1],[-2,1]]},
    {"hull": "H", "points": [[0,0],[4,0],[4,4],[0,4],[2,2]]}, {"cloud": "C", "points": [[0,0],[1,0],[0,1]]})";
  const std::string ask =
      R"([{"walk": ["P", "q"]}, {"walk": ["q", "P"], "lesson": "convex-polygon"}, {"walk": "H"}, {"walk": "C"}])";
  const Json all = answers(shell, objects, ask);
  CHECK(all[0]["verdict"] == "q lies inside P");
  CHECK(all[1]["verdict"] == "q lies inside P");
  CHECK(all[2]["verdict"] == "the hull of H has 4 corners");
  CHECK(all[2]["result"]["hull"].size() == 4);
  CHECK(all[3]["verdict"] == "the hull of C has 3 corners");
  const std::string told = shell("isect explain scene.json").out;
  const Ran made = shell("isect render scene.json");
  INFO(made.err);
  CHECK(made.status == 0);
  CHECK_THAT(told, Contains("here q is p, and P is the polygon") && Contains("Odd or even") &&
                       Contains("A fan of wedges") && Contains("here H are the points"));

  const std::string bent = R"({"point": "q", "at": [0, 0]}, {"polygon": "P", "points": [[-2,-1],[2,-1],[0,0],[2,1]]})";
  CHECK_THAT(refused(shell, bent, R"([{"walk": ["q", "P"], "lesson": "convex-polygon"}])"),
             Contains("P is not convex"));
  std::string many;
  for (int i = 0; i < 101; ++i) many += (i > 0 ? ",[" : "[") + std::to_string(i) + "," + std::to_string(i * i) + "]";
  CHECK_THAT(refused(shell, R"({"hull": "H", "points": [)" + many + "]}", R"([{"walk": "H"}])"),
             Contains("H, step by step: H has 101 points") && Contains("100 are the most"));
}

TEST_CASE("a lesson takes what it can of a scene", "[scene]") {
  const Shell shell;
  const std::string mine = R"({"title": "Mine", "objects": [{"sphere": "S", "center": [0, 0], "radius": 1},
    {"point": "q", "at": [0.5, 0.25]}, {"polygon": "P", "points": [[-2,-1],[2,-1],[2,1],[-2,1]]},
    {"polygon": "bent", "points": [[-2,-1],[2,-1],[0,0],[2,1]]}], "ask": [["q", "S"]]})";
  write(shell.work() / "mine.json", mine);
  const Ran both = shell("isect explain crossings --scene mine.json");
  CHECK(both.status == 0);
  CHECK_THAT(both.out, Contains("Point in polygon: crossings: Mine") && Contains("here q is p, and P is the polygon") &&
                           Contains("bent is the polygon") && !Contains("q and S"));
  const Ran convex = shell("isect explain convex-polygon --scene mine.json");  // of both polygons the one that is
  CHECK(convex.status == 0);
  CHECK_THAT(convex.out, Contains("A fan of wedges") && !Contains("bent is the polygon"));
  const Ran moved = shell("isect explain crossings --scene mine.json --set q.at=9,0.25");
  CHECK_THAT(moved.out, Contains("OUT"));

  const Ran made = shell("isect render crossings --scene mine.json --step 2 --format svg");
  CHECK(made.out == "figures/scene/crossings-mine/02-q-p-ray.svg\n");
  const Ran again = shell("isect show " + made.out.substr(0, made.out.size() - 1));  // no display here
  CHECK(again.status == 77);
  const Ran shown = shell("isect show crossings --scene mine.json");
  CHECK(shown.status == 77);
  CHECK_THAT(shown.err, Contains("isect render crossings --scene mine.json"));

  const auto refusal = [&](const std::string& words) {
    const Ran r = shell("isect " + words);
    CHECK(r.status == 2);
    return r.err;
  };
  CHECK_THAT(refusal("show ray-sphere --scene mine.json"),
             Contains("none of its objects are what ray-sphere takes: ray"));
  CHECK_THAT(refusal("show trees --scene mine.json"), Contains("trees"));
  CHECK_THAT(refusal("show culling --scene mine.json"),
             Contains("none of its objects are what culling takes: frustum and box in space"));
  CHECK_THAT(refusal("show picking --scene mine.json"),
             Contains("picking takes no objects of a scene; these do: points, sphere-sphere"));
  CHECK_THAT(refusal("show --scene mine.json"), Contains("lesson"));
  CHECK_THAT(refusal("render crossings rays --scene mine.json"), Contains("one lesson"));
  CHECK(contents(shell.work() / "mine.json") == mine);
}

TEST_CASE("the boxes of a scene are walked through by each method of collision, and all find the same pairs",
          "[scene]") {
  const Shell shell;
  // Large and far off; A and B touch, D is a point in C, E lies apart.
  const std::string objects = R"({"box": "A", "lo": [1000, 0], "hi": [1100, 100]}, {"circle": "S", "center": [0, 0],
    "radius": 1}, {"box": "B", "lo": [1100, 50], "hi": [1300, 90]}, {"box": "C", "lo": [1250, -200], "hi": [1400, 60]},
    {"box": "D", "lo": [1300, 0], "hi": [1300, 0]}, {"box": "E", "lo": [2000, 0], "hi": [2050, 400]})";
  write(shell.work() / "s.json", R"({"objects": [)" + objects + "]}");
  for (const char* preset : {"brute-force", "sweep", "hierarchy"}) {
    const std::string words = " collision --scene s.json --preset " + std::string(preset);
    const Ran r = shell("isect explain" + words + " --step all");
    INFO(preset << r.err);
    CHECK(r.status == 0);
    CHECK_THAT(r.out, Contains("here A is 0, B is 1, C is 2, D is 3, E is 4.") && Contains("Verdict: 3 pairs, "));
    CHECK(shell("isect render" + words + " --format svg --out " + preset).status == 0);
  }
  CHECK_THAT(shell("isect show collision --scene s.json --preset sweep").err,
             Contains("isect render collision --scene s.json --preset sweep"));
  CHECK(files_in(shell.work() / "brute-force").size() != files_in(shell.work() / "sweep").size());
  CHECK(shell("isect explain collision --scene s.json --brief").out ==
        shell("isect explain collision --scene s.json --preset brute-force --brief").out);
  CHECK_THAT(shell("isect explain collision --scene s.json --set E.lo=1350,0").out, Contains("Verdict: 4 pairs, "));

  const Json asked = answers(shell, objects, R"([{"walk": "all", "lesson": "collision"},
    {"walk": ["E", "A", "D"], "lesson": "collision", "method": "sweep"}])");
  CHECK(asked[0]["verdict"] == "these meet: A and B, B and C, C and D");
  CHECK(asked[0]["result"]["pairs"] == Json::parse(R"([["A","B"],["B","C"],["C","D"]])"));
  CHECK(asked[1]["verdict"] == "no two of 3 boxes meet");
  CHECK_THAT(shell("isect explain scene.json").out, Contains("here E is 0, A is 1, D is 2."));

  const auto why = [&](const std::string& ask) {
    write(shell.work() / "w.json", R"({"objects": [)" + objects + R"(], "ask": [)" + ask + "]}");
    const Ran r = shell("isect scene w.json");
    CHECK(r.status == 2);
    return r.err;
  };
  CHECK_THAT(why(R"({"walk": ["A", "S"], "lesson": "collision"})"), Contains("\"S\" is a sphere; a box in the plane"));
  CHECK_THAT(why(R"({"walk": ["A", "A"], "lesson": "collision"})"), Contains("named twice"));
  CHECK_THAT(why(R"({"walk": ["A"], "lesson": "collision"})"), Contains("ask[0].walk: ") && Contains("2 to"));
  CHECK_THAT(why(R"({"walk": "all", "lesson": "collision", "method": "swep"})"), Contains("mean \"sweep\""));
  CHECK_THAT(why(R"({"walk": ["A", "B"], "lesson": "aabb-aabb", "method": "sweep"})"), Contains("ask[0].method: "));
  CHECK_THAT(shell("isect show collision --scene s.json --preset tunnelling").err,
             Contains("it is for the method, one of brute-force, sweep, hierarchy"));
  CHECK_THAT(shell("isect show crossings --scene s.json --preset vertex-passed").err, Contains("crossings takes none"));
  write(shell.work() / "s.json", R"({"objects": [{"box": "A", "lo": [0, 0, 0], "hi": [1, 1, 1]}]})");
  CHECK_THAT(shell("isect show collision --scene s.json").err, Contains("two boxes or more in the plane"));
  std::string many;
  for (int i = 0; i < 13; ++i)
    many += (i > 0 ? "," : "") + (R"({"box": "b)" + std::to_string(i) + R"(", "lo": [0, 0], "hi": [1, 1]})");
  write(shell.work() / "s.json", R"({"objects": [)" + many + "]}");
  CHECK_THAT(shell("isect show collision --scene s.json").err, Contains("they are 13") && Contains("12 are the most"));
}

TEST_CASE("a scene's boxes are built into a hierarchy and asked by its ray, step by step", "[scene]") {
  const Shell shell;
  const std::string objects = R"({"box": "A", "lo": [10, 0], "hi": [12, 3]}, {"box": "B", "lo": [14, 1], "hi": [15, 4]},
    {"box": "C", "lo": [11, 6], "hi": [14, 7]}, {"box": "D", "lo": [20, 0], "hi": [23, 2]},
    {"box": "E", "lo": [21, 4], "hi": [22, 8]}, {"box": "F", "lo": [17, 5], "hi": [19, 6]},
    {"ray": "r", "origin": [5, 3], "dir": [4, 0.75]})";
  const std::string of_ray = R"({"walk": "all", "lesson": "hierarchy", "method": "ray"})";
  const Json all = answers(shell, objects, R"([{"walk": "all", "lesson": "hierarchy"}, )" + of_ray + "]");
  CHECK(all[0]["result"]["hierarchy"] == "3 nodes, depth 1");
  CHECK(all[1]["verdict"] == "r meets F first, at t = 3");  // which touches the ray's height 5.25
  CHECK(all[1]["result"]["hits"].size() == 2);
  const Json none = answers(shell, objects + R"(, {"ray": "q", "origin": [5, 3], "dir": [-1, 0]})",
                            R"([{"walk": ["A", "B"], "lesson": "hierarchy", "method": "ray", "ray": "q"}])");
  CHECK(none[0]["verdict"] == "q meets none of them");

  write(shell.work() / "boxes.json", R"({"objects": [)" + objects + "]}");
  const Ran told = shell("isect explain hierarchy --scene boxes.json --preset ray");
  CHECK(told.status == 0);
  CHECK_THAT(told.out, Contains("box 5 at t = 3") && Contains("r is the ray"));
  CHECK_THAT(shell("isect explain hierarchy --scene boxes.json").out, Contains("3 nodes, depth 1"));

  const auto why = [&](const std::string& ask, const std::string& more = "") {
    return refused(shell, objects + more, "[" + ask + "]");
  };
  CHECK_THAT(why(of_ray, R"(, {"ray": "q", "origin": [5, 3], "dir": [-1, 0]})"), Contains("\"ray\" is expected"));
  CHECK_THAT(why(R"({"walk": "all", "lesson": "hierarchy", "method": "ray", "ray": "A"})"), Contains("a ray"));
  CHECK_THAT(why(R"({"walk": "all", "lesson": "collision", "ray": "r"})"), Contains("asks by no ray"));
  CHECK_THAT(why(R"({"walk": ["A", "B"], "ray": "r"})"), Contains("no such field"));
  CHECK_THAT(refused(shell, R"({"box": "A", "lo": [1, 1], "hi": [1, 1]}, {"box": "B", "lo": [1, 1], "hi": [1, 1]})",
                     R"([{"walk": "all", "lesson": "hierarchy"}])"),
             Contains("all of them are one point"));
}

TEST_CASE("a circle is the sphere of the plane", "[scene]") {
  const Shell shell;
  CHECK(verdict(shell,
                R"({"circle": "C", "center": [0,0], "radius": 1}, {"sphere": "D", "center": [2,0], "radius": 1})") ==
        "C and D touch");
  CHECK(shell("isect render scene.json --format svg").status == 0);
  CHECK(shell("isect scene scene.json --set C.radius=0.5 --save scene.json").status == 0);
  CHECK_THAT(contents(shell.work() / "scene.json"), Contains(R"({"circle": "C", "center": [0,0], "radius": 0.5})"));
}

TEST_CASE("outlines, segments and lines in the plane are asked about each other", "[scene]") {
  const Shell shell;
  const std::string notched = R"({"polygon": "P", "points": [[0,0],[4,0],[4,3],[2,1],[0,3]]}, )";
  const std::string holed = R"({"polygon": "P", "rings": [[[0,0],[6,0],[6,6],[0,6]],[[2,2],[4,2],[4,4],[2,4]]]}, )";
  const std::string hull = R"({"hull": "H", "points": [[0,0],[4,0],[4,4],[0,4],[2,2]]}, )";

  CHECK(verdict(shell, notched + R"({"ray": "r", "origin": [2,2], "dir": [0,-1]})") == "r meets P");
  CHECK(answers(shell, notched + R"({"ray": "r", "origin": [2,2], "dir": [0,-2]})",
                R"("all pairs")")[0]["result"]["t"] == 0.5);
  CHECK(verdict(shell, notched + R"({"ray": "r", "origin": [2,2], "dir": [0,1]})") == "r misses P");
  CHECK(verdict(shell, notched + R"({"ray": "r", "origin": [1,4], "dir": [0,-1], "tmax": 1.5})") == "r misses P");
  CHECK(verdict(shell, notched + R"({"line": "l", "origin": [2,2], "dir": [0,1]})") == "l meets P");
  CHECK(verdict(shell, holed + R"({"segment": "s", "from": [2.5,2.5], "to": [3.5,3.5]})") == "s misses P");
  CHECK(verdict(shell, holed + R"({"segment": "s", "from": [2.5,2.5], "to": [4,4]})") == "s meets P");  // its corner
  CHECK(verdict(shell, holed + R"({"segment": "s", "from": [1,1], "to": [1,1]})") == "s meets P");      // a point
  CHECK(verdict(shell, holed + R"({"segment": "s", "from": [3,3], "to": [3,3]})") == "s misses P");
  CHECK(verdict(shell, hull + R"({"ray": "r", "origin": [-1,2], "dir": [1,0]})") == "r meets H");

  const std::string segment = R"({"segment": "s", "from": [1,0], "to": [1,0.1]}, )";
  CHECK(verdict(shell, segment + R"({"ray": "r", "origin": [0,0.1], "dir": [1,0]})") ==
        "s and r have one point in common");
  CHECK(verdict(shell, segment + R"({"ray": "r", "origin": [0,0.10000000000000002], "dir": [1,0]})") == "s misses r");
  CHECK(verdict(shell, segment + R"({"line": "r", "origin": [1,9], "dir": [0,1]})") == "s and r share a stretch");
  CHECK(answers(shell, segment + R"({"segment": "u", "from": [2,-1], "to": [2,1]},
                                    {"ray": "r", "origin": [0,0.05], "dir": [1,0]})",
                R"([{"first hit": "r"}])")[0]["verdict"] == "r meets s first, at t = 1");
  CHECK(answers(shell, segment + R"({"segment": "u", "from": [0,0], "to": [4,0]})",
                R"([{"first hit": "u"}])")[0]["verdict"] == "u meets s first, at t = 0.25");

  const auto other = [&](const std::string& with, const std::string& points) {
    return verdict(shell, with + R"({"triangle": "T", "points": )" + points + "}");
  };
  CHECK(other(hull, "[[5,0],[6,0],[5,1]]") == "H and T are disjoint");
  CHECK(other(hull, "[[4,1],[6,0],[5,2]]") == "H and T touch");
  CHECK(other(hull, "[[3,1],[6,0],[5,2]]") == "H and T overlap");
  CHECK(other(hull, "[[1,1],[1,2],[2,1]]") == "T lies in H");              // clockwise
  CHECK(other(notched, "[[2,2],[3,3],[1,3]]") == "P and T are disjoint");  // in the notch
  CHECK(other(notched, "[[2,1],[3,3],[1,3]]") == "P and T touch");
  CHECK(other(notched, "[[2,0.5],[3,3],[1,3]]") == "P and T overlap");
  CHECK(other(notched, "[[0.5,0.5],[1,0.5],[1,1]]") == "T lies in P");
  CHECK(other(notched, "[[-9,-9],[99,-9],[-9,99]]") == "P lies in T");
  CHECK(other(notched, "[[2,0],[2,0.5],[2,0.75]]") == "T lies in P");  // without an area
  CHECK(other(notched, "[[2,0],[2,0.5],[2,2]]") == "P and T overlap");
  CHECK(other(notched, "[[2,2],[2,1],[2,1.5]]") == "P and T touch");
  CHECK(other(holed, "[[2.5,2.5],[3,2.5],[3,3]]") == "P and T are disjoint");  // in the hole
  CHECK(verdict(shell, holed + R"({"box": "B", "lo": [2,2], "hi": [4,4]})") == "P and B touch");
  CHECK(verdict(shell, holed + R"({"box": "B", "lo": [0,0], "hi": [6,6]})") == "P lies in B");
  CHECK(verdict(shell, holed + R"({"box": "B", "lo": [2,1], "hi": [4,4]})") == "P and B overlap");
  CHECK(verdict(shell, holed + R"({"polygon": "Q", "rings": [[[4,4],[4,2],[2,2],[2,4]],[[6,0],[6,6],[0,6],[0,0]]]})") ==
        "P and Q are equal");
  CHECK(verdict(shell, hull + R"({"box": "B", "lo": [1,1], "hi": [2,2]})") == "B lies in H");
  CHECK(verdict(shell, hull + R"({"hull": "K", "points": [[0,0],[0,4],[4,4],[4,0]]})") == "H and K are equal");
  CHECK(verdict(shell, hull + R"({"hull": "K", "points": [[5,5],[6,6]]})") == "H and K are disjoint");  // no area
}

TEST_CASE("a point lies beside a line or a plane, on it, or beyond its end", "[scene]") {
  const Shell shell;
  const auto at = [&](const std::string& x, const std::string& other) {
    return verdict(shell, R"({"point": "p", "at": )" + x + "}, " + other);
  };
  const std::string segment = R"({"segment": "s", "from": [0,0], "to": [0.3,0.9]})";
  CHECK(at("[0.1,0.3]", segment) == "p lies right of s");  // 0.9 is not three times 0.3
  CHECK(at("[0.15,0.45]", segment) == "p lies on s");
  CHECK(at("[0.6,1.8]", segment) == "p lies in line with s, beyond its end");
  CHECK(at("[1,0]", segment) == "p lies right of s");
  const std::string point = R"({"segment": "s", "from": [1,1], "to": [1,1]})";
  CHECK(at("[1,1]", point) == "p lies on s");
  CHECK(at("[1,2]", point) == "p lies in line with s, beyond its end");
  CHECK(at("[-2,0]", R"({"ray": "r", "origin": [0,0], "dir": [1,0]})") == "p lies in line with r, beyond its end");
  CHECK(at("[-2,0]", R"({"line": "l", "origin": [0,0], "dir": [1,0]})") == "p lies on l");
  CHECK(at("[2,0]", R"({"ray": "r", "origin": [0,0], "dir": [1,0], "tmax": 2})") == "p lies on r");

  const std::string plane = R"({"plane": "w", "normal": [0,0,1], "d": -0.5})";
  CHECK(at("[1,2,0.5]", plane) == "p lies in w");
  CHECK(at("[1,2,0.50000000000000011]", plane) == "p lies beside w, where its normal points");
  CHECK(at("[1,2,0]", plane) == "p lies beside w, on the side that its normal leaves");
}

TEST_CASE("corners lie beside a plane, in it or on both sides", "[scene]") {
  const Shell shell;
  const auto told = [&](const std::string& d, const std::string& other) {
    return verdict(shell, R"({"plane": "w", "normal": [0,0,1], "d": )" + d + "}, " + other);
  };
  const std::string triangle = R"({"triangle": "T", "points": [[0,0,0],[1,0,1],[0,1,1]]})";
  CHECK(told("-0.5", triangle) == "w cuts T");
  CHECK(told("-1", triangle) == "w and T touch");
  CHECK(told("-1.0000000000000002", triangle) == "T lies beside w, on the side that its normal leaves");
  CHECK(told("1e-300", triangle) == "T lies beside w, where its normal points");
  CHECK(told("-1", R"({"polygon": "T", "points": [[0,0,1],[1,0,1],[0,1,1]]})") == "T lies in w");
  CHECK(told("-0.5", R"({"hull": "T", "points": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]]})") == "w cuts T");
  CHECK(told("-0.5", R"({"cloud": "T", "points": [[0,0,0],[1,0,1]]})") == "T has points on both sides of w");
  // a vertex that no triangle has is not a corner
  const std::string mesh = R"({"mesh": "T", "points": [[0,0,0],[1,0,0],[0,1,0],[0,0,9]], "triangles": [[0,1,2]]})";
  CHECK(told("0", mesh) == "T lies in w");
  CHECK(told("-1", mesh) == "T lies beside w, on the side that its normal leaves");
}

TEST_CASE("a line of the plane, as a normal and a distance, is asked about all that has corners or is round",
          "[scene]") {
  const Shell shell;
  const auto [line, other, told] = GENERATE(table<const char*, const char*, const char*>(
      {{"[1, 1], \"d\": -2", R"({"obb": "B", "center": [0, 0], "u": [1, 0], "v": [0, 1], "half": [1, 1]})", "touch"},
       {"[1, 1], \"d\": -1.5", R"({"obb": "B", "center": [0, 0], "u": [1, 0], "v": [0, 1], "half": [1, 1]})", "cuts"},
       {"[1, 1], \"d\": -3", R"({"kdop": "B", "normals": [[1, 0], [0, 1]], "lo": [0, 0], "hi": [1, 2]})", "touch"},
       {"[1, 1], \"d\": -3.5", R"({"kdop": "B", "normals": [[1, 0], [0, 1]], "lo": [0, 0], "hi": [1, 2]})", "disjoint"},
       {"[0, 1], \"d\": -1", R"({"capsule": "B", "p": [0, 0], "q": [3, 0], "r": 1})", "touch"},
       {"[0, 1], \"d\": -1", R"({"capsule": "B", "p": [0, 0], "q": [3, 2], "r": 0})", "cuts"},
       {"[0, 1], \"d\": -1", R"({"triangle": "B", "points": [[0, 0], [1, 0], [0, 1]]})", "touch"},
       {"[0, 1], \"d\": -1", R"({"polygon": "B", "points": [[0, 0], [1, 0], [1, 3]]})", "cuts"},
       {"[0, 1], \"d\": -1", R"({"hull": "B", "points": [[0, 0], [1, 0], [1, 0.5]]})", "normal leaves"},
       {"[0, 1], \"d\": -1", R"({"cloud": "B", "points": [[0, 0], [1, 4]]})", "both sides"},
       {"[0, 1], \"d\": -1", R"({"plane": "B", "normal": [0, 2], "d": -2})", "the same"},
       {"[0, 1], \"d\": -1", R"({"plane": "B", "normal": [0, 2], "d": -1})", "parallel"},
       {"[0, 1], \"d\": -1", R"({"plane": "B", "normal": [1, 2], "d": -1})", "meet in a point"}}));
  CHECK_THAT(verdict(shell, std::string(R"({"plane": "A", "normal": )") + line + "}, " + other), Contains(told));
}

TEST_CASE("points of a cloud lie on what has no inside, or do not", "[scene]") {
  const Shell shell;
  const auto [other, told] = GENERATE(table<const char*, const char*>(
      {{R"({"segment": "s", "from": [0, 0], "to": [1.5, 1.5]})", "2 of 4 points of C lie on s"},
       {R"({"ray": "s", "origin": [1, 1], "dir": [1, 1]})", "2 of 4 points of C lie on s"},
       {R"({"line": "s", "origin": [9, 9], "dir": [1, 1]})", "3 of 4 points of C lie on s"},
       {R"({"point": "P", "at": [2, 3]})", "1 of 4 points of C is P"},
       {R"({"cloud": "D", "points": [[2, 2], [5, 5], [0, 0]]})", "2 of 4 points of C are also in D"}}));
  const std::string cloud = R"({"cloud": "C", "points": [[0, 0], [1, 1], [2, 2], [2, 3]]}, )";
  CHECK_THAT(verdict(shell, cloud + other), Contains(told));
  CHECK_THAT(verdict(shell, R"({"cloud": "C", "points": [[0, 0, 0], [1, 1, 0], [0.25, 0.25, 0], [0, 0, 1]]},
                               {"triangle": "T", "points": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]})"),
             Contains("2 of 4 points of C lie on T"));
}

TEST_CASE("two meshes meet where triangles of both have a point in common", "[scene]") {
  const Shell shell;
  const auto tetrahedron = [](const char* name, double x) {
    return fmt::format(R"({{"mesh": "{}", "points": [[{}, 0, 0], [{}, 0, 0], [{}, 2, 0], [{}, 0, 2]],
                        "triangles": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]}})",
                       name, x, x + 2, x, x);
  };
  CHECK_THAT(verdict(shell, tetrahedron("M", 0) + ", " + tetrahedron("N", 2)),
             Contains("N meets 3 of 4 triangles of M"));  // at a corner, which three triangles share
  CHECK_THAT(verdict(shell, tetrahedron("M", 0) + ", " + tetrahedron("N", 2.0009765625)), Contains("are disjoint"));
}

TEST_CASE("a point lies in a capsule, on it or outside", "[scene]") {
  const Shell shell;
  const auto told = [&](const std::string& at, const std::string& capsule) {
    return verdict(shell, R"({"point": "p", "at": )" + at + R"(}, {"capsule": "c", )" + capsule + "}");
  };
  const std::string flat = R"("p": [0,0], "q": [4,3], "r": 2.5)";
  CHECK(told("[0.5,3.5]", flat) == "p lies on the boundary of c");  // 2.5 from (2, 1.5), at right angles
  CHECK(told("[0.5,3.4999999999999996]", flat) == "p lies inside c");
  CHECK(told("[0.5,3.5000000000000004]", flat) == "p lies outside c");
  CHECK(told("[-1.5,-2]", flat) == "p lies on the boundary of c");  // beside an end
  CHECK(told("[5.5,5]", flat) == "p lies on the boundary of c");
  CHECK(told("[5.5,5.0000000000000009]", flat) == "p lies outside c");
  CHECK(told("[0,0,1]", R"("p": [0,0,0], "q": [0,0,0], "r": 1)") == "p lies on the boundary of c");
  CHECK(verdict(shell, R"({"cloud": "C", "points": [[0,0],[9,9],[0.5,3.5]]}, {"capsule": "c", )" + flat + "}") ==
        "1 of 3 points of C lies inside c, 1 on its boundary");
}

TEST_CASE("a box meets those triangles of a mesh that have a point in it", "[scene]") {
  const Shell shell;
  const std::string mesh =
      R"({"mesh": "M", "points": [[0,0,0],[4,0,0],[0,4,0],[0,0,4]], "triangles": [[0,2,1],[0,1,3],[0,3,2],[1,2,3]]}, )";
  const auto told = [&](const std::string& box) { return verdict(shell, mesh + R"({"box": "A", )" + box + "}"); };
  CHECK(told(R"("lo": [-1,-1,-1], "hi": [0,0,0])") == "A meets 3 of 4 triangles of M");
  CHECK(told(R"("lo": [0.5,0.5,0.5], "hi": [1,1,1])") == "A lies in M");  // within it
  CHECK(told(R"("lo": [2,1,1], "hi": [9,9,9])") == "A meets 1 of 4 triangles of M");
  CHECK(told(R"("lo": [2,1,1.0000000000000002], "hi": [9,9,9])") == "M and A are disjoint");
}

TEST_CASE("a concave polygon, two points and a frustum of a scene are walked through by their lessons", "[scene]") {
  const Shell shell;
  const auto told = [&](const std::string& lesson, const std::string& objects) {
    write(shell.work() / "s.json", R"({"objects": [)" + objects + "]}");
    return shell("isect explain " + lesson + " --scene s.json --step all");
  };
  // Large, far off and clockwise; on a corner, on an edge, inside, in the notch.
  const std::string arrow =
      R"(, {"polygon": "P", "points": [[1e6,1e6],[1000100,1000400],[1000200,1e6],[1000100,1000100]]})";
  const auto at = [&](const std::string& x, const std::string& y) {
    const Ran r = told("concave-polygon", R"({"point": "q", "at": [)" + x + ", " + y + "]}" + arrow);
    CHECK(r.status == 0);
    return r.out;
  };
  CHECK_THAT(at("1000100", "1000200"), Contains("Verdict: IN"));
  CHECK_THAT(at("1000100", "1000050"), Contains("Verdict: OUT"));
  CHECK_THAT(at("1000100", "1000100"), Contains("Verdict: ON"));
  CHECK_THAT(at("1000050", "1000200"), Contains("Verdict: ON"));
  CHECK(shell("isect render concave-polygon --scene s.json --format svg").status == 0);

  const std::string q = R"({"point": "q", "at": [0, 0]}, {"polygon": "P", )";
  CHECK_THAT(told("concave-polygon", q + R"("points": [[0,0],[1,1],[1,0],[0,1]]})").err, Contains("cross"));
  CHECK_THAT(told("concave-polygon", q + R"("rings": [[[0,0],[9,0],[9,9]],[[5,1],[6,1],[6,2]]]})").err,
             Contains("P has holes"));
  std::string round;
  for (int i = 0; i < 25; ++i)
    round +=
        (i == 0 ? "[" : ",[") + std::to_string(std::cos(0.25 * i)) + "," + std::to_string(std::sin(0.25 * i)) + "]";
  CHECK_THAT(told("concave-polygon", q + "\"points\": [" + round + "]}").err, Contains("24 are the most"));

  const std::string p = R"({"point": "p", "at": [1, 2, 3]}, {"point": "q", "at": )";
  CHECK_THAT(told("points", p + "[1, 2, 3]}").out, Contains("Verdict: EQUAL"));
  CHECK_THAT(told("points", p + "[1, 2, 3.0000000000000004]}").out, Contains("Verdict: DIFFERENT"));

  const std::string view = R"({"frustum": "F", "eye": [0,0,0], "forward": [1,0,0], "up": [0,1,0], "angle": 90,
                               "near": 1, "far": 4}, )";
  CHECK_THAT(told("culling", view + R"({"sphere": "S", "center": [9, 0, 0], "radius": 1})").out,
             Contains("Verdict: outside"));
  CHECK_THAT(told("culling", view + R"({"box": "B", "lo": [2, 0, 0], "hi": [3, 1, 1]})").out,
             Contains("Verdict: inside"));
}

TEST_CASE("what is wrong with many numbers is told by line and field, or by the file's own line", "[scene]") {
  const Shell shell;
  const auto file = [&](const std::string& name, const std::string& bytes) {
    write(shell.work() / name, bytes);
    return refused(shell, R"({"mesh": "M", "file": ")" + name + R"("})");
  };
  CHECK_THAT(file("a.obj", "v 0 0 0\nv 1 0 x\n"),
             Contains("line 2: objects[0].file: a.obj: line 2: \"x\" is no finite"));
  CHECK_THAT(file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"), Contains("line 4: vertex 4, and there are 3"));
  CHECK_THAT(file("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n"), Contains("line 3: a face has three"));
  CHECK_THAT(file("a.obj", "v 0 0 0\n"), Contains("a.obj holds no triangles"));
  CHECK_THAT(file("a.obj", ""), Contains("no points"));
  CHECK_THAT(file("a.stl", "hello"), Contains("nor a binary STL"));
  CHECK_THAT(file("a.stl", binary_stl().substr(0, 200)), Contains("solid") || Contains("no points"));
  CHECK_THAT(
      file("a.ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nend_header\n1 2\n"),
      Contains("ends early"));
  CHECK_THAT(file("b.ply", binary_ply(false).substr(0, 260)), Contains("ends early"));
  CHECK_THAT(file("c.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\nend_header\n"), Contains("line 3: "));
  CHECK_THAT(file("m.step", "1 2 3"), Contains("a name that ends in one of these is expected: .csv, .geojson, "));
  CHECK_THAT(file("m.txt", "1 2 3"), Contains("m.txt holds no triangles"));
  write(shell.work() / "p.csv", "0,0\n1,2,3\n");
  CHECK_THAT(refused(shell, R"({"cloud": "C", "file": "p.csv"})"),
             Contains("p.csv: line 2: 3 columns, and 2 in the first row"));
  CHECK_THAT(shell("isect scene absent.json").err, Contains("absent.json"));
  write(shell.work() / "absent.json", R"({"objects": [{"cloud": "C", "file": "gone.csv"}]})");
  const Ran gone = shell("isect scene absent.json");
  CHECK(gone.status == 4);
  CHECK_THAT(gone.err, Contains("gone.csv"));

  const std::string point = R"({"point": "p", "at": [0,0,0]})";
  CHECK_THAT(refused(shell, R"({"kdop": "K", "normals": [[1,0],[0,1]], "lo": [0], "hi": [1,1]})"),
             Contains("objects[0].lo: 2 numbers"));
  CHECK_THAT(refused(shell, R"({"kdop": "K", "normals": [[1,0]], "lo": [0], "hi": [1]})"), Contains("K: "));
  CHECK_THAT(refused(shell, R"({"kdop": "K", "normals": [[1,0],[0,1]], "lo": [2,0], "hi": [1,1]})"), Contains("empty"));
  CHECK_THAT(refused(shell, R"({"hull": "H", "points": [[0,0,0],[1,0,0],[0,1,0],[1,1,0]]})"), Contains("no volume"));
  CHECK_THAT(refused(shell, R"({"frustum": "F", "eye": [0,0], "forward": [1,0], "up": [0,1], "angle": 30, "near": 1,
    "far": 2})"),
             Contains("a frustum has three coordinates"));
  CHECK_THAT(refused(shell, R"({"frustum": "F", "eye": [0,0,0], "forward": [0,2,0], "up": [0,1,0], "angle": 30,
    "near": 1, "far": 2})"),
             Contains("along one line"));
  CHECK_THAT(refused(shell, R"({"frustum": "F", "eye": [0,0,0], "forward": [1,0,0], "up": [0,1,0], "angle": 180,
    "near": 1, "far": 2})"),
             Contains("180 is above 170"));
  CHECK_THAT(refused(shell, R"({"mesh": "M", "points": [[0,0,0],[1,0,0],[0,1,0]], "triangles": [[0,1,3]]})"),
             Contains("triangles: 3 is no number of a point; they are 0 to 2"));
  CHECK_THAT(refused(shell, R"({"cloud": "C", "points": [[0,0]], "file": "x.csv"})"),
             Contains("give one of: points, file"));
  CHECK_THAT(refused(shell, point, R"([{"fit": "p"}])"),
             Contains("ask[0].fit: \"p\" is a point; what is made of points"));
  CHECK_THAT(refused(shell, R"({"cloud": "C", "points": [[0,0]]})", R"([{"fit": "C", "volume": "spere"}])"),
             Contains("ask[0].volume: ") && Contains("\"sphere\""));
  CHECK_THAT(refused(shell, point, R"([{"fitt": "p"}])"), Contains("ask[0].fitt: unknown; did you mean \"fit\"?"));
  CHECK_THAT(refused(shell, point, R"([{}])"), Contains("one of these is expected: of, first hit, fit"));
  CHECK_THAT(refused(shell, point + R"(, {"box": "A", "lo": [0,0,0], "hi": [1,1,1]})", R"([{"clip": "p", "to": "A"}])"),
             Contains("a ray, a line, a segment"));
  CHECK_THAT(refused(shell, point, R"([{"hierarchy": "p"}])"), Contains("a mesh, \"all\""));
  CHECK_THAT(refused(shell, point, R"([{"hierarchy": "all"}])"), Contains("two objects at least"));
  CHECK_THAT(refused(shell, point, R"([{"walk": "p"}])"), Contains("no lesson steps through a point in space"));
  CHECK_THAT(refused(shell, point, R"([{"walk": "p", "lesson": "crosings"}])"), Contains("\"crossings\"?"));
  CHECK_THAT(refused(shell, point + R"(, {"box": "A", "lo": [0,0,0], "hi": [1,1,1]})", R"([{"walk": ["p", "A"]}])"),
             Contains("no lesson steps through a point and a box") && Contains("sphere and sphere"));
}

}  // namespace scene_shapes_test
