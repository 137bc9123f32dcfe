// The handles of a scene's shapes: one for each number, and whatever is dragged leaves a scene that can be read.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/scene/lesson.h"
#include "app/scene/save.h"
#include "app/scene/types.h"
#include "bench/random.h"
#include "tests/catch.h"
#include "viz/player/snap.h"

namespace scene_handles_test {
namespace scene = isect::program::scene;
namespace viz = isect::viz;
using isect::test::Contains;
using viz::Handle;
using viz::Vec3;

namespace {

/// One object of each type, in the plane too where it exists there, and in all ways in which its numbers are written.
const std::vector<std::string>& objects() {
  static const std::vector<std::string> all = {
      R"({"point": "A", "at": [1, 2, 3]})",
      R"({"point": "A", "at": [1, 2]})",
      R"({"segment": "A", "from": [0, 0, 0], "to": [1, 2, 3]})",
      R"({"segment": "A", "from": [0, 0], "to": [1, 2]})",
      R"({"ray": "A", "origin": [0, 1, 0], "dir": [1, 0.5, 2], "tmin": -1, "tmax": 3})",
      R"({"ray": "A", "origin": [0, 1], "dir": [1, 0.5], "tmax": 3})",
      R"({"line": "A", "origin": [0, 1, 0], "dir": [1, 0.5, 2]})",
      R"({"line": "A", "origin": [0, 1], "dir": [1, 0.5]})",
      R"({"plane": "A", "normal": [0, 2, 1], "d": -3})",
      R"({"plane": "A", "normal": [2, 1], "d": -3})",
      R"({"sphere": "A", "center": [1, 2, 3], "radius": 2})",
      R"({"circle": "A", "center": [1, 2], "radius": 2})",
      R"({"box": "A", "lo": [-1, -2, -3], "hi": [1, 2, 4]})",
      R"({"box": "A", "lo": [-1, -2], "hi": [1, 2]})",
      R"({"obb": "A", "center": [1, 0, 0], "u": [0.6, 0.8, 0], "v": [-0.8, 0.6, 0], "w": [0, 0, 1], "half": [1, 2, 0.5]})",
      R"({"obb": "A", "center": [1, 0], "u": [0.6, 0.8], "v": [-0.8, 0.6], "half": [1, 2]})",
      R"({"capsule": "A", "p": [0, 0, 0], "q": [2, 0, 0], "r": 1})",
      R"({"capsule": "A", "p": [0, 0], "q": [2, 0], "r": 1})",
      R"({"cylinder": "A", "p": [0, 0, 0], "q": [2, 1, 0], "r": 1})",
      R"({"cone": "A", "apex": [0, 0, 0], "base": [2, 1, 0], "r": 1})",
      R"({"triangle": "A", "points": [[0, 0, 0], [2, 0, 0], [0, 1, 1]]})",
      R"({"triangle": "A", "points": [[0, 0], [2, 0], [0, 1]]})",
      R"({"polygon": "A", "points": [[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0]]})",
      R"({"polygon": "A", "rings": [[[0, 0], [4, 0], [4, 4], [0, 4]], [[1, 1], [2, 1], [1, 2]]]})",
      R"({"polygon": "A", "points": [[0, 0], [2, 0], [2, 1]], "at": [1, 0.5]})",
      R"({"kdop": "A", "normals": [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], "lo": [0, 0, 0, 0.5], "hi": [1, 2, 1, 3]})",
      R"({"kdop": "A", "normals": [[1, 0], [0, 1], [1, 1]], "lo": [0, 0, 0.5], "hi": [1, 2, 2]})",
      R"({"frustum": "A", "eye": [0, 1, 0], "forward": [1, 0, 0.5], "up": [0, 1, 0], "angle": 40, "aspect": 1.5,
          "near": 1, "far": 5})",
      R"({"frustum": "A", "eye": [0, 1, 0], "forward": [1, 0, 0], "up": [0, 1, 0], "angle": 40, "near": 1, "far": 5})",
      R"({"hull": "A", "points": [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2], [1, 1, 1]]})",
      R"({"hull": "A", "points": [[0, 0], [2, 0], [0, 2], [1, 1]]})",
      R"({"mesh": "A", "points": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
          "triangles": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]})",
      R"({"mesh": "A", "points": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "triangles": [[0, 1, 2]], "at": [1, 2, 3]})",
      R"({"cloud": "A", "points": [[0, 0, 0], [1, 2, 3]]})",
      R"({"cloud": "A", "points": [[0, 0], [1, 2], [3, 1]], "at": [0.5, 0]})"};
  return all;
}

std::string scene_of(const std::string& objects, const std::string& ask = "[]") {
  return R"({"objects": [)" + objects + R"(], "ask": )" + ask + "}";
}

std::vector<Handle> handles(const viz::Lesson& lesson, const viz::Parameters& at) {
  return lesson.steps(at).steps.front().scene.handles;
}

Handle handle(const viz::Lesson& lesson, const viz::Parameters& at, const std::string& id) {
  for (const Handle& h : handles(lesson, at))
    if (h.id() == id) return h;
  throw std::runtime_error("no handle " + id);
}

/// A scene whose handles are dragged.
struct Dragged {
  explicit Dragged(const std::string& text) : lesson(scene::lesson_of(text, "")), now(lesson.presets[0].parameters) {}

  const viz::Lesson lesson;
  viz::Parameters now;

  const viz::Condition* operator()(const std::string& id, const Vec3& to) {
    return drag(lesson, now, handle(lesson, now, id), to);
  }
  Vec3 place(const std::string& id) const { return handle(lesson, now, id).at; }
  Vec3 point(const char* name) const { return std::get<Vec3>(now.at(name)); }
  double number(const char* name) const { return std::get<double>(now.at(name)); }
};

/// Whether two settings are equal; points that are not moved are moved by 0.
bool same(viz::Parameters a, viz::Parameters b) {
  const viz::Setting zero = Vec3(0, 0, 0);
  a.try_emplace("A.at", zero), b.try_emplace("A.at", zero);
  return a == b;
}

}  // namespace

TEST_CASE("every type of objects has a handle for each of its numbers, and each is known by a name of its own",
          "[scene]") {
  std::set<scene::Type> seen;
  for (const std::string& object : objects()) {
    INFO(object);
    const std::string text = scene_of(object);
    const viz::Lesson lesson = scene::lesson_of(text, "");
    seen.insert(scene::read_scene(text, "").objects.at(0).type);
    std::set<std::string> ids, changed, coordinates;
    for (const Handle& h : handles(lesson, lesson.presets[0].parameters)) {
      CHECK(h.at.allFinite());
      CHECK(ids.insert(h.id()).second);
      changed.insert(h.parameter);
      changed.insert(h.with.begin(), h.with.end());
      if (h.kind == Handle::Kind::on_line && !h.name.empty()) coordinates.insert(h.name);
    }
    for (const viz::Parameter& p : lesson.parameters) {
      INFO(p.name);
      CHECK(changed.contains(p.name));
      if (p.name != "A.lo" && p.name != "A.hi" && p.name != "A.half") continue;
      for (const char* axis : {".x", ".y", ".z"})
        CHECK(coordinates.contains(p.name + axis) == (axis[1] != 'z' || !lesson.flat));
    }
  }
  CHECK(seen.size() == scene::types().size());
}

TEST_CASE("wherever a handle is dragged to, the scene is written, and read again with the same numbers", "[scene]") {
  isect::bench::Random random(49);
  int moved = 0;
  for (const std::string& object : objects()) {
    const std::string text = scene_of(object + " // mine\n");
    Dragged drags(text);
    const scene::File file = scene::read_scene(text, "");
    for (int i = 0; i < 60; ++i) {
      const std::vector<Handle> all = handles(drags.lesson, drags.now);
      const Handle& h = all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))];
      const double reach = random.one_in(8) ? 1e6 : random.one_in(8) ? 0 : 6;
      Vec3 to =
          h.anchor + Vec3(random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach));
      if (random.one_in(6)) to = h.at;
      if (file.flat) to.z() = 0;
      INFO(object << "\n" << h.id() << " to " << to.transpose());
      moved += drag(drags.lesson, drags.now, h, to) == nullptr;
      CHECK_NOTHROW(viz::validate(drags.lesson, drags.now));
      const std::string written = scene::with_numbers(text, file, drags.now);
      CHECK_THAT(written, Contains("// mine"));
      const viz::Lesson again = scene::lesson_of(written, "");
      CHECK(same(again.presets[0].parameters, drags.now));
    }
  }
  CHECK(moved > 1000);
}

TEST_CASE("a handle that is dragged to where it stands moves nothing", "[scene]") {
  for (const std::string& object : objects()) {
    Dragged drags(scene_of(object));
    for (const Handle& h : handles(drags.lesson, drags.now)) {
      INFO(object << "\n" << h.id());
      viz::Parameters there = drags.now;
      CHECK_FALSE(drag(drags.lesson, there, h, h.at));
      drags.now.try_emplace("A.at", Vec3(0, 0, 0));
      for (const auto& [name, value] : there) {
        const double most = h.kind == Handle::Kind::point || h.kind == Handle::Kind::shift ? 0 : 1e-12;
        if (const double* x = std::get_if<double>(&value))
          CHECK(std::abs(*x - drags.number(name.c_str())) <= 100 * most);
        else
          CHECK((std::get<Vec3>(value) - drags.point(name.c_str())).norm() <= most);
      }
    }
  }
}

TEST_CASE("a face is moved alone, and stops at the one across", "[scene]") {
  Dragged box(scene_of(R"({"box": "A", "lo": [-1, -2, -3], "hi": [1, 2, 4]})"));
  CHECK_FALSE(box("A.hi.x", {2.5, 7, 7}));
  CHECK(box.point("A.hi") == Vec3(2.5, 2, 4));
  CHECK_FALSE(box("A.lo.y", {9, 9, 9}));
  CHECK(box.point("A.lo") == Vec3(-1, 2, -3));
  CHECK(box("A.lo", {9, 0, 0}));  // a corner is refused there
  CHECK(box.point("A.lo") == Vec3(-1, 2, -3));

  Dragged obb(scene_of(
      R"({"obb": "A", "center": [1, 0, 0], "u": [0.6, 0.8, 0], "v": [-0.8, 0.6, 0], "w": [0, 0, 1], "half": [1, 2, 3]})"));
  CHECK_FALSE(obb("A.half.x", Vec3(1, 0, 0) + 4 * Vec3(0.6, 0.8, 0) + Vec3(0, 0, 5)));
  CHECK(obb.point("A.half").isApprox(Vec3(4, 2, 3), 1e-15));
  CHECK_FALSE(obb("A.half.z", Vec3(1, 0, -5)));
  CHECK(obb.point("A.half").z() == 0);

  Dragged kdop(scene_of(R"({"kdop": "A", "normals": [[1, 0], [0, 2], [1, 1]], "lo": [0, 0, 0.5], "hi": [1, 4, 2]})"));
  CHECK_FALSE(kdop("A.hi2", {9, 1.5, 0}));
  CHECK(kdop.number("A.hi2") == 3);
  CHECK_FALSE(kdop("A.lo1", {7, 0, 0}));
  CHECK(kdop.number("A.lo1") == 1);
  const viz::Condition* forbids = kdop("A.lo3", {0, 8, 0});  // it stops at hi3 = 2, which still meets x = 1
  CHECK_FALSE(forbids);
  CHECK(kdop.number("A.lo3") == 2);
  forbids = kdop("A.hi2", {0, -3, 0});  // y = 0 would not reach x + y = 2
  REQUIRE(forbids);
  CHECK(forbids->allowed == "slabs that have a point in common");
}

TEST_CASE("a frame turns after its knob, and its axes stay at right angles", "[scene]") {
  const char* flat = R"({"obb": "A", "center": [1, 0], "u": [0.6, 0.8], "v": [-0.8, 0.6], "half": [1, 2]})";
  Dragged in_plane(scene_of(flat));
  CHECK_FALSE(in_plane("A.u", {1, -7, 0}));
  CHECK(in_plane.point("A.u").isApprox(Vec3(0, -1, 0), 1e-15));
  CHECK(in_plane.point("A.v").isApprox(Vec3(1, 0, 0), 1e-15));
  CHECK_FALSE(in_plane("A.u", {1, 7, 0}));  // half a turn
  CHECK(in_plane.point("A.u").isApprox(Vec3(0, 1, 0), 1e-15));
  CHECK(in_plane.point("A.v").isApprox(Vec3(-1, 0, 0), 1e-15));
  CHECK((in_plane.point("A.center") == Vec3(1, 0, 0) && in_plane.point("A.half") == Vec3(1, 2, 0)));
  const viz::Parameters before = in_plane.now;
  CHECK_FALSE(in_plane("A.u", {1, 0, 0}));  // the centre is no direction
  CHECK(in_plane.now == before);

  isect::bench::Random random(7);
  Dragged obb(scene_of(
      R"({"obb": "A", "center": [1, 0, 0], "u": [0.6, 0.8, 0], "v": [-0.8, 0.6, 0], "w": [0, 0, 1], "half": [1, 2, 3]})"));
  for (int i = 0; i < 2000; ++i) {
    const char* names[] = {"A.u", "A.v", "A.w"};
    const char* name = names[random.below(3)];
    const Vec3 way(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    Handle knob = {.parameter = name, .kind = Handle::Kind::turn, .at = {}, .anchor = Vec3(1, 0, 0)};
    for (const char* other : names)
      if (other != name) knob.with.emplace_back(other);
    drag(obb.lesson, obb.now, knob, Vec3(1, 0, 0) + way);
    CHECK(obb.point(name).isApprox(way.normalized(), 1e-12));
  }
  Eigen::Matrix3d axes;
  axes << obb.point("A.u"), obb.point("A.v"), obb.point("A.w");
  CHECK((axes.transpose() * axes).isApprox(Eigen::Matrix3d::Identity(), 1e-11));
  CHECK(axes.determinant() > 0);  // it is not mirrored
}

TEST_CASE("a plane is moved along its normal, and turns about its middle", "[scene]") {
  const std::string ball = R"(, {"sphere": "B", "center": [2, 0, 3], "radius": 1})";
  Dragged plane(scene_of(R"({"plane": "A", "normal": [0, 0, 2], "d": -2})" + ball));
  const Vec3 middle = plane.place("A.d");
  CHECK(middle == Vec3(2, 0, 1));
  CHECK_FALSE(plane("A.d", {9, 9, 2.5}));
  CHECK(plane.number("A.d") == -5);
  const Vec3 there = plane.place("A.d");
  CHECK_FALSE(plane("A.normal", there + Vec3(3, 0, 3)));
  const Vec3 n = plane.point("A.normal");
  CHECK(n.isApprox(std::sqrt(2) * Vec3(1, 0, 1), 1e-15));
  CHECK(std::abs(n.dot(there) + plane.number("A.d")) < 1e-14);
}

TEST_CASE("a frustum's planes and its angle follow their handles, and near stays before far", "[scene]") {
  Dragged drags(scene_of(R"({"frustum": "A", "eye": [0, 1, 0], "forward": [2, 0, 0], "up": [0, 1, 0], "angle": 40,
    "aspect": 1.5, "near": 1, "far": 4})"));
  CHECK_FALSE(drags("A.angle", {4, 5, 7}));
  CHECK(drags.number("A.angle") == Approx(90));
  CHECK_FALSE(drags("A.aspect", {4, 1, 8}));
  CHECK(drags.number("A.aspect") == Approx(2));
  CHECK_FALSE(drags("A.far", {3, 0, 0}));
  CHECK(drags.number("A.far") == 3);
  const viz::Condition* forbids = drags("A.near", {8, 0, 0});  // up to far there would be nothing
  REQUIRE(forbids);
  CHECK(forbids->allowed == "a far of more than near");
  CHECK(drags.number("A.near") == 1);
  CHECK(drags("A.up", {1, 1, 0}));  // along forward
  CHECK(drags("A.forward", {0, 1, 0}));
  CHECK(drags.point("A.forward") == Vec3(2, 0, 0));
}

TEST_CASE("a range of a ray ends where it is dragged to, and not before it begins", "[scene]") {
  Dragged ray(scene_of(R"({"ray": "A", "origin": [1, 0, 0], "dir": [2, 0, 0], "tmin": 0.5, "tmax": 3})"));
  CHECK_FALSE(ray("A.tmax", {6, 5, 0}));
  CHECK(ray.number("A.tmax") == 2.5);
  CHECK_FALSE(ray("A.tmax", {-6, 5, 0}));
  CHECK(ray.number("A.tmax") == 0.5);
  CHECK_FALSE(ray("A.tmin", {90, 0, 0}));
  CHECK(ray.number("A.tmin") == 0.5);
}

TEST_CASE("a shape made of points moves as a whole, and only its numbers change in the text", "[scene]") {
  const std::string text = R"({"objects": [ // mine
    {"polygon": "A", "points": [[0, 0], /* here */ [2, 0],
                                [2, 1]]}]})";
  Dragged drags(text);
  CHECK_FALSE(drags("A", drags.place("A") + Vec3(0.5, -1, 0)));
  CHECK(drags.point("A.1").isApprox(Vec3(0.5, -1, 0), 1e-15));
  CHECK((drags.point("A.3") - drags.point("A.1")).isApprox(Vec3(2, 1, 0), 1e-15));
  drags.now.at("A.1") = Vec3(0.5, -1, 0), drags.now.at("A.2") = Vec3(2.5, -1, 0), drags.now.at("A.3") = Vec3(2.5, 0, 0);
  CHECK(scene::with_numbers(text, scene::read_scene(text, ""), drags.now) == R"({"objects": [ // mine
    {"polygon": "A", "points": [[0.5, -1], /* here */ [2.5, -1],
                                [2.5, 0]]}]})");

  const viz::Parameters before = drags.now;
  const Handle first = handle(drags.lesson, before, "A");
  for (int i = 0; i < 3; ++i) drag(drags.lesson, drags.now, first, first.at + Vec3(1, 0, 0));  // it is not the latest
  CHECK(drags.point("A.2").isApprox(Vec3(3.5, -1, 0), 1e-12));
}

TEST_CASE("a mesh is moved by a field of its own, which the text gets behind its name", "[scene]") {
  const std::string mesh = R"("points": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
     "triangles": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]}, {"point": "p", "at": [5, 0, 0]})";
  const std::string text = scene_of(R"({"mesh": "M" /* mine */, )" + mesh, R"([["p", "M"]])");
  Dragged drags(text);
  const auto told = [](const viz::Lesson& lesson, const viz::Parameters& at) {
    return lesson.steps(at).steps.back().verdict.kind;
  };
  CHECK(told(drags.lesson, drags.now) == viz::Verdict::Kind::no);
  CHECK_FALSE(drags("M.at", drags.place("M.at") + Vec3(5, 0, 0)));
  CHECK(drags.point("M.at") == Vec3(5, 0, 0));
  CHECK(told(drags.lesson, drags.now) != viz::Verdict::Kind::no);  // its corner is there
  const std::string written = scene::with_numbers(text, scene::read_scene(text, ""), drags.now);
  CHECK(written == scene_of(R"({"mesh": "M", "at": [5, 0, 0] /* mine */, )" + mesh, R"([["p", "M"]])"));
  const viz::Lesson again = scene::lesson_of(written, "");
  CHECK(again.presets[0].parameters == drags.now);
  CHECK_FALSE(drags.lesson.presets[0].parameters.contains("M.at"));  // not until it is moved
  CHECK(told(again, drags.now) != viz::Verdict::Kind::no);

  viz::set(drags.lesson, drags.now, "M.at", "0,0,0");
  CHECK(scene::with_numbers(text, scene::read_scene(text, ""), drags.now) == text);
  CHECK_THROWS_WITH(
      scene::read_scene(scene_of(R"({"triangle": "T", "points": [[0,0],[1,0],[0,1]], "at": [1, 1]})"), ""),
      Contains("objects[0].at: unknown"));
  CHECK_THROWS_WITH(scene::read_scene(scene_of(R"({"hull": "H", "points": [[0,0],[1,0],[0,1]], "at": [1, 1, 1]})"), ""),
                    Contains("objects[0].at: 3 coordinates in a scene whose others have 2"));
}

TEST_CASE("in a crowded scene only what a step is about has a handle for each number", "[scene]") {
  std::string objects;
  for (const char* name : {"A", "B", "C", "D", "E"})
    objects += fmt::format(R"({}{{"box": "{}", "lo": [0, 0, 0], "hi": [1, 1, 1]}})", objects.empty() ? "" : ", ", name);
  const viz::Lesson lesson = scene::lesson_of(scene_of(objects, R"([["A", "B"]])"), "");
  const viz::Walk walk = lesson.steps(lesson.presets[0].parameters);
  const auto count = [](const viz::Step& step, const std::string& name) {
    return std::ranges::count_if(step.scene.handles,
                                 [&](const Handle& h) { return h.parameter.starts_with(name + "."); });
  };
  CHECK(count(walk.steps.at(0), "A") == 3);  // two corners, and the whole
  CHECK(count(walk.steps.at(1), "A") == 9);
  CHECK(count(walk.steps.at(1), "C") == 3);
}

TEST_CASE("each kind of handle snaps to where the answer changes", "[scene]") {
  struct Way {
    const char *objects, *ask, *id;
    Vec3 to;
    bool exact;  ///< whether the border is a double
  };
  const std::vector<Way> ways = {
      {R"({"box": "A", "lo": [0, 0, 0], "hi": [1, 1, 1]}, {"box": "B", "lo": [3, 0, 0], "hi": [4, 1, 1]})",
       R"([["A", "B"]])",
       "A",
       {3, 0.5, 0.5},
       true},
      {R"({"box": "A", "lo": [0, 0, 0], "hi": [1, 1, 1]}, {"box": "B", "lo": [3, 0, 0], "hi": [4, 1, 1]})",
       R"([["A", "B"]])",
       "A.hi.x",
       {3.5, 0.5, 0.5},
       true},
      {R"({"obb": "A", "center": [0, 0, 0], "u": [1, 0, 0], "v": [0, 1, 0], "w": [0, 0, 1], "half": [2.75, 0.25, 0.25]},
          {"obb": "B", "center": [0, 3, 0], "u": [1, 0, 0], "v": [0, 1, 0], "w": [0, 0, 1], "half": [0.5, 0.5, 0.5]})",
       R"([["A", "B"]])",
       "A.u",
       {0.25, 4, 0},
       false},
      {R"({"plane": "A", "normal": [0, 0, 1], "d": 0}, {"sphere": "B", "center": [0, 0, 3], "radius": 1})",
       R"([["A", "B"]])",
       "A.d",
       {0, 0, 2.5},
       false},
      {R"({"frustum": "A", "eye": [0, 0, 0], "forward": [1, 0, 0], "up": [0, 1, 0], "angle": 40, "near": 1, "far": 5},
          {"point": "p", "at": [2, 1.5, 0]})",
       R"([["p", "A"]])",
       "A.angle",
       {5, 6, 0},
       false},
      {R"({"polygon": "A", "points": [[0, 0], [2, 0], [2, 2], [0, 2]]}, {"point": "p", "at": [3, 1]})",
       R"([["p", "A"]])",
       "A",
       {2.5, 1, 0},
       true}};
  for (const Way& way : ways) {
    INFO(way.objects << "\n" << way.id);
    const viz::Lesson lesson = scene::lesson_of(scene_of(way.objects, way.ask), "");
    const viz::Parameters before = lesson.presets[0].parameters;
    const Handle h = handle(lesson, before, way.id);
    const auto found = viz::find_border(lesson, viz::way_of(lesson, before, h, h.at, way.to), 0, 1.25, 1);
    REQUIRE(found);
    CHECK((found->exact || !way.exact));
    CHECK(found->setting != before);
    CHECK_NOTHROW(viz::validate(lesson, found->setting));
    if (way.exact) CHECK(viz::case_of(lesson, found->setting) != viz::case_of(lesson, before));
  }
}

}  // namespace scene_handles_test
