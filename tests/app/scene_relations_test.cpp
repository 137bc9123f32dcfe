// How two objects of a scene lie: one rule for all kinds of them, and the same answer whatever way it is found.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/scene/file.h"
#include "app/scene/lesson.h"
#include "tests/catch.h"
#include "viz/chart/chart.h"
#include "viz/text/rich_text.h"

namespace scene_relations_test {
namespace scene = isect::program::scene;
namespace viz = isect::viz;
using Json = nlohmann::ordered_json;

namespace {

Json answers(const std::string& objects, const std::string& ask) {
  return scene::answers(scene::read_scene(R"({"objects": [)" + objects + R"(], "ask": )" + ask + "}", ""));
}

/// The relation of the objects named A and B; "meet" where the answer says no more; "not decided".
std::string relation(const std::string& objects) {
  const Json answer = answers(objects, R"([["A", "B"]])")[0], &result = answer["result"];
  INFO(objects << "\n" << answer.dump());
  if (result.contains("not decided")) return "not decided";
  if (result.contains("meet")) return result["meet"] == true ? "meet" : "disjoint";
  REQUIRE(result.contains("relation"));
  return result["relation"];
}

std::string list(const std::vector<double>& v) { return fmt::format("[{}]", fmt::join(v, ", ")); }

/// A box from lo to hi in the form of a box, an oriented box and a k-DOP.
std::vector<std::string> solids(const std::string& name, const std::vector<double>& lo, const std::vector<double>& hi) {
  std::vector<double> center, half;
  for (std::size_t i = 0; i < 3; ++i) center.push_back((lo[i] + hi[i]) / 2), half.push_back((hi[i] - lo[i]) / 2);
  return {fmt::format(R"({{"box": "{}", "lo": {}, "hi": {}}})", name, list(lo), list(hi)),
          fmt::format(
              R"({{"obb": "{}", "center": {}, "u": [0, 1, 0], "v": [-1, 0, 0], "w": [0, 0, 1], "half": [{}, {}, {}]}})",
              name, list(center), half[1], half[0], half[2]),
          fmt::format(R"({{"kdop": "{}", "normals": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "lo": {}, "hi": {}}})", name,
                      list(lo), list(hi))};
}
std::string hull_of_box(const std::string& name, const std::vector<double>& lo, const std::vector<double>& hi) {
  std::string corners;
  for (int k = 0; k < 8; ++k)
    corners += (k == 0 ? "" : ", ") + list({(k & 1 ? hi : lo)[0], (k & 2 ? hi : lo)[1], (k & 4 ? hi : lo)[2]});
  return fmt::format(R"({{"hull": "{}", "points": [{}]}})", name, corners);
}

/// A prism over a convex outline of n corners, 4 high, of 4 n - 4 facets: it reaches from x = 0 to n - 1.
std::string prism(const std::string& name, int n) {
  std::string points;
  for (const int z : {0, 4})
    for (int i = 0; i < n; ++i) points += (points.empty() ? "" : ", ") + list({double(i), double(i * i), double(z)});
  return fmt::format(R"({{"hull": "{}", "points": [{}]}})", name, points);
}

std::string turned(const std::string& r) {
  return r == "a_contains_b" ? "b_contains_a" : r == "b_contains_a" ? "a_contains_b" : r;
}

}  // namespace

TEST_CASE("how a hull lies does not depend on how many facets it has", "[scene]") {
  struct Place {
    std::vector<double> lo, hi;
    std::string of_box;  ///< the box as A, the prism as B
    bool thin = false;
  };
  const std::vector<Place> places = {
      {{-1, -1, -1}, {99, 999, 9}, "a_contains_b"},  // around it
      {{3, 14, 1}, {3.5, 14.5, 2}, "b_contains_a"},  // within
      {{3, 14, 2}, {3.5, 14.5, 4}, "b_contains_a"},  // within, on the top
      {{3, 14, 4}, {3.5, 14.5, 6}, "touch"},         // on the top
      {{-1, -1, 4}, {99, 999, 6}, "touch"},          // a face holds the top
      {{-1, -1, -1}, {99, 999, 0}, "touch"},         // and the bottom
      {{-3, -1, 1}, {0, 3, 2}, "touch"},             // an edge on a face
      {{3, 14, 3}, {3.5, 14.5, 6}, "overlap"},       // through the top
      {{-1, -1, 1}, {99, 999, 2}, "overlap"},        // a slice
      {{3, 14, 4.5}, {3.5, 14.5, 6}, "disjoint"},    //
      {{3, -9, 1}, {3.5, 8, 2}, "disjoint"},         // beside it, within its box
      {{3, 14, 2}, {3.5, 14.5, 2}, "b_contains_a", true},
      {{3, 14, 4}, {3.5, 14.5, 4}, "b_contains_a", true},
      {{-1, -1, 4}, {99, 999, 4}, "touch", true},
      {{-1, -1, 2}, {99, 999, 2}, "overlap", true},
      {{3, 14, 3}, {3, 14, 6}, "overlap", true},  // a rod
      {{3, 14, 4}, {3, 14, 6}, "touch", true},
      {{3, 14, 5}, {3, 14, 6}, "disjoint", true},
  };
  for (const int n : {9, 10, 20})  // 32, 36 and 76 facets: with the faces of a box at most 40, or more
    for (const Place& place : places)
      for (const std::string& a : solids("A", place.lo, place.hi)) {
        const std::string b = prism("B", n);
        INFO(n << ": " << a);
        const std::string told = relation(a + ", " + b);
        const bool beyond = 4 * n - 4 + 6 > 40;
        const bool says_less = beyond && place.thin && told == "meet" && place.of_box != "disjoint";
        CHECK((told == place.of_box || says_less));
        CHECK((!says_less || place.of_box != "b_contains_a"));
        std::string names = a;  // the other way round
        names.replace(names.find("\"A\""), 3, "\"B\"");
        std::string other = b;
        other.replace(other.find("\"B\""), 3, "\"A\"");
        const std::string back = relation(names + ", " + other);
        CHECK((back == turned(place.of_box) || (says_less && back == "meet")));
      }
}

TEST_CASE("balls, capsules and segments without a radius lie to a hull of any size as to a box", "[scene]") {
  struct Place {
    std::string p, q;
    double r;
    std::string told;  ///< the relation of the capsule as A
  };
  const std::vector<Place> places = {
      {"[3, 14, 2]", "[3.5, 15, 2]", 0, "b_contains_a"},  // within
      {"[3, 14, 4]", "[3.5, 15, 4]", 0, "b_contains_a"},  // on the top
      {"[0, 0, 0]", "[0, 0, 4]", 0, "b_contains_a"},      // an edge
      {"[0, 0, 4]", "[-1, 0, 4]", 0, "touch"},
      {"[0, 0, 2]", "[-1, -1, 2]", 0, "touch"},
      {"[3, 14, 4]", "[3, 400, 4]", 0, "touch"},  // along the top, and beyond
      {"[3, 14, 4]", "[3, 14, 9]", 0, "touch"},
      {"[3, 14, 2]", "[3, 14, 9]", 0, "overlap"},  // through the top
      {"[3, 14, -9]", "[3, 14, 9]", 0, "overlap"},
      {"[0, 0, 9]", "[5, 30, -5]", 0, "overlap"},
      {"[0, -1, 2]", "[0, 1, 2]", 0, "touch"},  // across an upright edge
      {"[0, 1, 2]", "[7, 48, 2]", 0, "overlap"},
      {"[9, 1, 2]", "[9, 60, 2]", 0, "disjoint"},
      {"[3, 14, 2]", "[3, 14, 2]", 0.25, "b_contains_a"},
      {"[3, 14, 6]", "[3, 15, 6]", 2, "touch"},
      {"[3, 14, 6]", "[3, 15, 6]", 2.5, "overlap"},
      {"[3, 14, 6]", "[3, 15, 6]", 1.5, "disjoint"},
      {"[0, 0, 0]", "[9, 99, 0]", 999, "a_contains_b"},
  };
  for (const int n : {9, 20})
    for (const Place& place : places) {
      INFO(n << ": " << place.p << " " << place.q << " " << place.r);
      const std::string capsule =
          fmt::format(R"({{"capsule": "A", "p": {}, "q": {}, "r": {}}})", place.p, place.q, place.r);
      CHECK(relation(capsule + ", " + prism("B", n)) == place.told);
    }
}

TEST_CASE("plates are told alike in whatever form they are given", "[scene]") {
  struct Place {
    std::vector<double> lo, hi;  ///< flat in z
    std::string told;            ///< the relation of the plate to the cube from -1 to 1
  };
  const std::vector<Place> places = {{{-0.5, -0.5, 0}, {0.5, 0.5, 0}, "b_contains_a"},
                                     {{-0.5, -0.5, 1}, {0.5, 0.5, 1}, "b_contains_a"},
                                     {{-1, -1, 0}, {1, 1, 0}, "b_contains_a"},
                                     {{-2, -2, 0}, {2, 2, 0}, "overlap"},
                                     {{-2, -2, 1}, {2, 2, 1}, "touch"},
                                     {{0.5, -0.5, 0}, {2, 0.5, 0}, "overlap"},
                                     {{1, -0.5, 0}, {2, 0.5, 0}, "touch"},
                                     {{1, 1, 1}, {2, 2, 1}, "touch"},
                                     {{1.5, -0.5, 0}, {2, 0.5, 0}, "disjoint"},
                                     {{-2, -2, 1.5}, {2, 2, 1.5}, "disjoint"}};
  const auto square = [](const std::string& name, const Place& at) {
    return fmt::format(R"({{"polygon": "{}", "points": [{}, {}, {}, {}]}})", name, list(at.lo),
                       list({at.hi[0], at.lo[1], at.lo[2]}), list(at.hi), list({at.lo[0], at.hi[1], at.lo[2]}));
  };
  for (const Place& place : places) {
    std::vector<std::string> plates = solids("A", place.lo, place.hi), cubes = solids("B", {-1, -1, -1}, {1, 1, 1});
    plates.push_back(square("A", place));
    cubes.push_back(hull_of_box("B", {-1, -1, -1}, {1, 1, 1}));
    for (const std::string& a : plates)
      for (const std::string& b : cubes) {
        INFO(a << ", " << b);
        CHECK(relation(a + ", " + b) == place.told);
      }
  }

  // Two plates, and a triangle as a polygon of three corners.
  const std::string triangle = "[[-2, 0, -2], [2, 0, -2], [0, 0, 2]]";
  const auto outline = [](const std::string& kind, const std::string& name, const std::string& points) {
    return fmt::format(R"({{"{}": "{}", "points": {}}})", kind, name, points);
  };
  const std::map<std::string, std::string> told = {
      {"[[-1, 0, -1], [1, 0, -1], [0, 0, 0]]", "a_contains_b"},  // within
      {triangle, "equal"},
      {"[[-2, -1, -1], [2, -1, -1], [0, 5, -1]]", "overlap"},  // across
      {"[[0, 0, 0], [9, 0, 0], [9, 0, 1]]", "overlap"},        // in one plane
      {"[[0, 0, 2], [9, 0, 2], [9, 0, 3]]", "touch"},
      {"[[-2, 0, -2], [2, 0, -2], [0, 0, -9]]", "touch"},  // beside each other
      {"[[0, 0, 0], [1, 1, 0], [-1, 1, 0]]", "touch"},     // a corner on it
      {"[[0, 1, 0], [1, 1, 0], [-1, 1, 1]]", "disjoint"},
  };
  for (const auto& [points, expected] : told)
    for (const char* a : {"triangle", "polygon"})
      for (const char* b : {"triangle", "polygon"}) {
        INFO(a << ", " << b << " " << points);
        CHECK(relation(outline(a, "A", triangle) + ", " + outline(b, "B", points)) == expected);
      }
  for (const char* kind : {"triangle", "polygon"})
    for (const std::string& cube : solids("B", {-1, -1, -1}, {1, 1, 1})) {
      INFO(kind << ", " << cube);
      CHECK(relation(outline(kind, "A", triangle) + ", " + cube) == "overlap");
      CHECK(relation(outline(kind, "A", "[[-1, 0, 0], [1, 0, 0], [0, 1, 1]]") + ", " + cube) == "b_contains_a");
      CHECK(relation(outline(kind, "A", "[[-1, 0, 1], [1, 0, 1], [0, 1, 3]]") + ", " + cube) == "touch");
      CHECK(relation(outline(kind, "A", "[[0, 0, 1], [5, 0, 1], [0, 5, 1]]") + ", " + cube) == "touch");
      CHECK(relation(outline(kind, "A", "[[0, 0, 0], [5, 0, 5], [0, 5, 5]]") + ", " + cube) == "overlap");
    }
}

TEST_CASE("a ground plate that a view volume cuts through overlaps it", "[scene]") {
  const std::string eye =
      R"({"frustum": "A", "eye": [0,150,0], "forward": [1,-0.1,0], "up": [0,1,0], "angle": 45, "near": 1, "far": 10000}, )";
  CHECK(relation(eye + R"({"box": "B", "lo": [-7500,0,-7500], "hi": [7500,0,7500]})") == "overlap");
  CHECK(relation(eye + R"({"box": "B", "lo": [-7500,0,-7500], "hi": [-5,0,7500]})") == "disjoint");
}

TEST_CASE("a polygon without its repeated corners and the points of its sides is the same", "[scene]") {
  const std::vector<std::string> squares = {
      "[[0,0],[2,0],[2,2],[0,2]]",
      "[[0,0],[2,0],[2,2],[0,2],[0,0]]",
      "[[0,2],[2,2],[2,0],[0,0],[0,2]]",
      "[[0,0],[1,0],[2,0],[2,2],[0,2]]",
      "[[1,0],[2,0],[2,1],[2,1],[2,2],[0,2],[0,2],[0,0.3],[0,0],[0.1,0]]",
      "[[1,2],[0,2],[0,1],[0,0],[0.5,0],[1,0],[2,0],[2,0],[2,2],[1.5,2],[1.25,2],[1,2]]"};
  const auto polygon = [](const std::string& name, const std::string& points) {
    return fmt::format(R"({{"polygon": "{}", "points": {}}})", name, points);
  };
  const std::map<std::string, std::string> told = {
      {"[[0.5,0.5],[1,0.5],[1,1]]", "a_contains_b"},     {"[[0,0],[1,0],[1,0],[1,1]]", "a_contains_b"},
      {"[[2,0],[4,0],[4,2],[2,2],[2,0]]", "touch"},      {"[[1,1],[4,1],[4,3]]", "overlap"},
      {"[[-1,-1],[5,-1],[5,5],[-1,5]]", "b_contains_a"}, {"[[3,0],[4,0],[4,1]]", "disjoint"}};
  for (const std::string& a : squares) {
    for (const std::string& b : squares) {
      INFO(a << " " << b);
      CHECK(relation(polygon("A", a) + ", " + polygon("B", b)) == "equal");
      CHECK(relation(polygon("A", a) + R"(, {"box": "B", "lo": [0,0], "hi": [2,2]})") == "equal");
    }
    for (const auto& [b, expected] : told) {
      INFO(a << " " << b);
      CHECK(relation(polygon("A", a) + ", " + polygon("B", b)) == expected);
    }
  }
  // Outlines that go on and come back, or have a notch, are not convex.
  for (const char* other : {"[[0,0],[3,0],[2,0],[2,2],[0,2]]", "[[0,0],[2,0],[1,1],[2,2],[0,2]]"})
    CHECK(relation(polygon("A", other) + ", " + polygon("B", "[[0.25,0.5],[0.5,0.5],[0.5,1]]")) == "a_contains_b");
}

TEST_CASE("a segment with decimal ends meets a polygon in space, or misses it", "[scene]") {
  const std::string square = R"({"polygon": "B", "points": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]]})";
  const auto segment = [](const std::string& from, const std::string& to) {
    return fmt::format(R"({{"segment": "A", "from": {}, "to": {}}}, )", from, to);
  };
  const auto told = [&](const std::string& from, const std::string& to) -> std::string {
    return answers(segment(from, to) + square, R"([["A", "B"]])")[0]["verdict"];
  };
  CHECK(told("[0.1, 0.2, 0.3]", "[0.7, 0.9, -0.4]") == "A meets B");
  CHECK(told("[0.1, 0.2, 0.3]", "[3.7, 0.9, -0.4]") == "A misses B");
  CHECK(told("[0.1, 0.2, 0.3]", "[0.7, 0.9, 0.1]") == "A misses B");
  CHECK(told("[0.1, 0.2, 0.3]", "[0.7, 0.9, 0]") == "A meets B");
  CHECK(told("[0.1, 0, 0.3]", "[0.7, 0, -0.4]") == "A meets B on its boundary");
  CHECK(told("[0.1, -1e-300, 0.3]", "[0.7, -1e-300, -0.4]") == "A misses B");
  CHECK(told("[-0.1, 0.3, 0]", "[0.7, 0.1, 0]") == "A meets B, in whose plane it lies");
  CHECK(told("[-0.1, 0.3, 0]", "[-0.7, 0.1, 0]") == "A misses B, in whose plane it lies");

  const Json first = answers(segment("[0.1, 0.2, 0.3]", "[0.7, 0.9, -0.4]") + square, R"([{"first hit": "A"}])")[0];
  REQUIRE(first["hits"].size() == 1);
  CHECK(std::abs(first["hits"][0]["t"].get<double>() - 0.3 / 0.7) < 1e-15);
}

TEST_CASE("a relation is told as seen from the first of the question, whatever the order", "[scene]") {
  const std::string both =
      R"({"box": "A", "lo": [-1,-1,-1], "hi": [1,1,1]}, {"capsule": "B", "p": [-1,0,0], "q": [1,0,0], "r": 5})";
  const Json all = answers(both, R"([["A", "B"], ["B", "A"]])");
  CHECK(all[0]["verdict"] == "A lies in B");
  CHECK(all[0]["result"]["relation"] == "b_contains_a");
  CHECK(all[1]["verdict"] == "A lies in B");
  CHECK(all[1]["result"]["relation"] == "a_contains_b");
}

namespace {

/// n boxes, the k-th from k to k + 1.5 along x.
std::string row_of_boxes(int n, double moved = 0) {
  std::string objects;
  for (int k = 0; k < n; ++k)
    objects += fmt::format(R"({}{{"box": "b{}", "lo": [{}, 0, 0], "hi": [{}, 1, 1]}})", k == 0 ? "" : ", ", k,
                           k + (k == 3 ? moved : 0), k + 1.5);
  return R"({"objects": [)" + objects + R"(], "ask": "all pairs"})";
}

}  // namespace

TEST_CASE("of many pairs a step tells those of one object, and few have a step each", "[scene]") {
  const viz::Lesson few = scene::lesson_of(row_of_boxes(20), "");
  CHECK(few.walk(few.presets[0].parameters).steps.size() == 1 + 190 + 1);

  const viz::Lesson many = scene::lesson_of(row_of_boxes(60), "");
  const std::vector<viz::Step> steps = many.walk(many.presets[0].parameters).steps;
  REQUIRE(steps.size() == 1 + 59 + 1);
  CHECK(steps[1].slug == "b0-and-others");
  CHECK(viz::plain(steps[1].verdict.text) == "b₀ meets 1 of 59 others");
  CHECK_THAT(viz::plain(steps[1].caption), isect::test::Contains("b₀ and b₁ overlap."));
  CHECK(viz::plain(steps[59].verdict.text) == "b₅₈ and b₅₉ overlap");
  CHECK(scene::answers(scene::read_scene(row_of_boxes(60), "")).size() == 60 * 59 / 2);
  // The last step's card has room for few: of many answers it shows those that meet something, and how many there are.
  for (const auto& [walked, all] :
       {std::pair{few.walk(few.presets[0].parameters), 190}, {many.walk(many.presets[0].parameters), 59}}) {
    const viz::Step& last = walked.steps.back();
    const auto& rows = std::get<viz::Card>(last.scene.chart->kind).rows;
    CHECK((rows.size() > 10 && rows.size() <= 36));
    for (const auto& row : rows)
      CHECK_THAT(viz::plain(row.text), !isect::test::Contains("disjoint") && !isect::test::Contains("meets 0"));
    CHECK_THAT(last.caption, isect::test::Contains(fmt::format("{} of {}", rows.size(), all)));
  }
}

TEST_CASE("of more than 200 objects a step shows those that it is about, and the first one all, without names",
          "[scene]") {
  const auto names = [](const viz::Step& step) {
    return std::ranges::count_if(step.scene.items,
                                 [](const viz::Item& item) { return std::holds_alternative<viz::Label>(item); });
  };
  const auto last_but_one = [](const viz::Lesson& lesson) {
    const viz::Walk walk = lesson.walk(lesson.presets[0].parameters);
    return std::pair(walk.steps.front(), walk.steps[walk.steps.size() - 2]);
  };
  const auto [all, two] = last_but_one(scene::lesson_of(row_of_boxes(200), ""));
  CHECK((names(all) == 200 && names(two) == 200));
  const auto [more, alone] = last_but_one(scene::lesson_of(row_of_boxes(201), ""));
  CHECK((names(more) == 0 && names(alone) == 2));
  CHECK(more.scene.items.size() >= 201);
  CHECK(alone.scene.items.size() < 10);

  std::size_t answered = 0;
  scene::each_answer(scene::read_scene(row_of_boxes(1000), ""), [&](const Json&) { ++answered; });
  CHECK(answered == 1000 * 999 / 2);
  CHECK_THROWS_WITH(scene::read_scene(row_of_boxes(1001), ""), isect::test::Contains("a list of 1 to 1000 objects"));
}

TEST_CASE("a moved object is asked anew, and all others stay as they were", "[scene]") {
  const viz::Lesson lesson = scene::lesson_of(row_of_boxes(30), "");
  viz::Parameters moved = lesson.presets[0].parameters;
  moved["b3.lo"] = viz::Vec3(3 - 2.75, 0, 0);
  const viz::Lesson fresh = scene::lesson_of(row_of_boxes(30, -2.75), "");
  const auto same = [](const viz::Walk& a, const viz::Walk& b) {
    REQUIRE(a.steps.size() == b.steps.size());
    for (std::size_t i = 0; i < a.steps.size(); ++i) {
      CHECK(a.steps[i].caption == b.steps[i].caption);
      CHECK(a.steps[i].verdict.text == b.steps[i].verdict.text);
    }
  };
  same(lesson.walk(moved), fresh.walk(fresh.presets[0].parameters));
  const viz::Lesson as_was = scene::lesson_of(row_of_boxes(30), "");
  same(lesson.walk(lesson.presets[0].parameters), as_was.walk(as_was.presets[0].parameters));
  moved["b3.lo"] = viz::Vec3(3, 0.5, 0);
  static_cast<void>(lesson.walk(moved));
  moved["b3.lo"] = viz::Vec3(3 - 2.75, 0, 0);
  same(lesson.walk(moved), fresh.walk(fresh.presets[0].parameters));
}

}  // namespace scene_relations_test
