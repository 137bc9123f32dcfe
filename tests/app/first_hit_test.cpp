// What a ray meets first, where that is decided by numbers that no doubles tell apart: objects of all types that are
// met in one and the same point, and then one of them by an ulp sooner or later.

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>

#include "app/scene/answered.h"
#include "app/scene/file.h"
#include "app/scene/object_pictures.h"
#include "tests/catch.h"
#include "viz/text/rich_text.h"

namespace first_hit_test {
using namespace isect;
using namespace isect::program::scene;

namespace {

/// Converts numbers of a scene of size 1 to those of a scene 2^exponent times as large.
struct Scale {
  int exponent;

  double operator()(double x) const { return std::ldexp(x, exponent); }
  Json operator()(std::initializer_list<double> point) const {
    Json list = Json::array();
    for (const double x : point) list.push_back((*this)(x));
    return list;
  }
};

/// An object that the ray meets later if its numbers grow, and sooner if they shrink, or the other way round.
struct Tied {
  Json object;
  std::vector<Json::json_pointer> numbers;  ///< empty if the ray would miss the moved object
  int way;                                  ///< 1: greater numbers are met later

  /// The object, met an ulp later (1) or sooner (-1).
  Json moved(int by) const {
    Json result = object;
    for (const Json::json_pointer& at : numbers) {
      const double x = result.at(at).get<double>();
      result[at] = std::nextafter(x, by * way > 0 ? HUGE_VAL : -HUGE_VAL);
    }
    return result;
  }
};

Json::json_pointer at(const char* place) { return Json::json_pointer(place); }

/// Objects that a ray from (-3, -2, 5) along (3, 1, -2) meets in (3, 0, 1).
std::vector<Tied> tied_in_a_point(const Scale& of) {
  const Json corners = {of({3, -2, 0}), of({3, 3, 0}), of({3, 0, 4})};
  Json four = corners;
  four.push_back(of({6, 0, 1}));
  const std::vector<Json::json_pointer> three_x = {at("/points/0/0"), at("/points/1/0"), at("/points/2/0")};
  return {
      {{{"plane", "P"}, {"normal", {1, 0, 0}}, {"d", of(-3)}}, {at("/d")}, -1},
      {{{"plane", "Q"}, {"normal", {1, 2, -2}}, {"d", of(-1)}}, {at("/d")}, -1},
      {{{"box", "B"}, {"lo", of({3, -1, 0})}, {"hi", of({5, 1, 2})}}, {at("/lo/0")}, 1},
      {{{"obb", "O"},
        {"center", of({4, 0, 1})},
        {"u", {0, 1, 0}},
        {"v", {0, 0, 1}},
        {"w", {1, 0, 0}},
        {"half", of({1, 1, 1})}},
       {at("/half/2")},
       -1},
      {{{"sphere", "S"}, {"center", of({4, 2, -1})}, {"radius", of(3)}}, {at("/radius")}, -1},
      {{{"capsule", "C"}, {"p", of({2, 3, -1})}, {"q", of({6, 1, -1})}, {"r", of(3)}}, {at("/r")}, -1},
      {{{"capsule", "D"}, {"p", of({4, 2, -1})}, {"q", of({6, 6, -5})}, {"r", of(3)}}, {at("/r")}, -1},
      {{{"triangle", "T"}, {"points", corners}}, three_x, 1},
      {{{"polygon", "V"}, {"points", corners}}, three_x, 1},
      {{{"hull", "H"}, {"points", four}}, three_x, 1},
      {{{"mesh", "M"}, {"points", four}, {"triangles", {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}}}, three_x, 1},
      {{{"kdop", "K"},
        {"normals", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}},
        {"lo", of({3, -1, 0, -9})},
        {"hi", of({6, 1, 4, 9})}},
       {at("/lo/0")},
       1},
      {{{"frustum", "F"},
        {"eye", of({0, 0, 1})},
        {"forward", {1, 0, 0}},
        {"up", {0, 1, 0}},
        {"angle", 90},
        {"near", of(3)},
        {"far", of(8)}},
       {at("/near")},
       1},
      {{{"segment", "E"}, {"from", of({3, -1, 1})}, {"to", of({3, 1, 1})}}, {}, 1},
  };
}

/// Objects that a ray from the origin along x meets at 5 - sqrt(3).
std::vector<Tied> tied_at_a_root(const Scale& of) {
  return {
      {{{"sphere", "S"}, {"center", of({5, 1, 0})}, {"radius", of(2)}}, {at("/radius")}, -1},
      {{{"sphere", "R"}, {"center", of({5, 0, -2.75})}, {"radius", of(3.25)}}, {at("/radius")}, -1},
      {{{"capsule", "C"}, {"p", of({5, -1, 0})}, {"q", of({9, -1, 0})}, {"r", of(2)}}, {at("/r")}, -1},
      {{{"capsule", "D"}, {"p", of({5, 1, -3})}, {"q", of({5, 1, 5})}, {"r", of(2)}}, {at("/r")}, -1},
      {{{"capsule", "E"}, {"p", of({9, 2.75, 0})}, {"q", of({5, 2.75, 0})}, {"r", of(3.25)}}, {at("/r")}, -1},
  };
}

/// Objects in the plane that a ray from (-3, -2) along (3, 1) meets in (3, 0).
std::vector<Tied> tied_in_the_plane(const Scale& of) {
  const std::vector<Json::json_pointer> two_x = {at("/points/0/0"), at("/points/1/0")};
  const Json corners = {of({3, -2}), of({3, 3}), of({6, 0})};
  return {
      {{{"box", "B"}, {"lo", of({3, -1})}, {"hi", of({5, 1})}}, {at("/lo/0")}, 1},
      {{{"obb", "O"}, {"center", of({4, 0})}, {"u", {0, 1}}, {"v", {-1, 0}}, {"half", of({1, 1})}},
       {at("/half/1")},
       -1},
      {{{"sphere", "S"}, {"center", of({6, 4})}, {"radius", of(5)}}, {at("/radius")}, -1},
      {{{"capsule", "C"}, {"p", of({2, 7})}, {"q", of({10, 1})}, {"r", of(5)}}, {at("/r")}, -1},
      {{{"plane", "P"}, {"normal", {1, 2}}, {"d", of(-3)}}, {at("/d")}, -1},
      {{{"triangle", "T"}, {"points", corners}}, two_x, 1},
      {{{"polygon", "V"}, {"points", corners}}, two_x, 1},
      {{{"hull", "H"}, {"points", corners}}, two_x, 1},
      {{{"kdop", "K"}, {"normals", {{1, 0}, {0, 1}, {1, 1}}}, {"lo", of({3, -1, -9})}, {"hi", of({6, 1, 9})}},
       {at("/lo/0")},
       1},
      {{{"segment", "E"}, {"from", of({3, -1})}, {"to", of({3, 1})}}, {at("/from/0"), at("/to/0")}, 1},
  };
}

std::string name_of(const Json& object) { return object.begin().value().get<std::string>(); }

Answered first_hit(const Json& ray, std::vector<Json> objects) {
  objects.insert(objects.begin(), ray);
  const File file = read_scene(Json{{"objects", objects}}.dump(), ".");
  const NamedValues numbers = {file.parameters, file.flat};
  return answered(Context{file, numbers, ObjectPictures().room(numbers, file.objects)}, FirstHitAsked{0});
}

std::string told(const Answered& a) { return viz::plain(a.verdict.text); }
std::string last_of(const Answered& a) { return a.json["hits"].back()["object"].get<std::string>(); }

/// Checks all objects, met at the same t, and then each of them alone an ulp sooner and an ulp later.
void check_all(const Json& ray, const std::vector<Tied>& tied) {
  std::vector<Json> objects;
  for (const Tied& t : tied) objects.push_back(t.object);
  const auto names = [&](std::size_t without) {
    std::string all;
    const std::size_t last = without + 1 == tied.size() ? tied.size() - 2 : tied.size() - 1;
    for (std::size_t i = 0; i < tied.size(); ++i) {
      if (i == without) continue;
      all += (all.empty() ? "" : i == last ? " and " : ", ") + name_of(tied[i].object);
    }
    return "r meets " + all + " at the same t";
  };
  CHECK(told(first_hit(ray, objects)) == names(tied.size()));
  for (std::size_t i = 0; i < tied.size(); ++i) {
    if (tied[i].numbers.empty()) continue;
    std::vector<Json> changed = objects;
    const std::string name = name_of(tied[i].object);
    CAPTURE(name);
    changed[i] = tied[i].moved(-1);
    CHECK(told(first_hit(ray, changed)).starts_with("r meets " + name + " first, at t = "));
    changed[i] = tied[i].moved(1);
    const Answered later = first_hit(ray, changed);
    CHECK(told(later) == names(i));
    CHECK(last_of(later) == name);
  }
}

}  // namespace

TEST_CASE("what is met in one point is met at the same t, and by an ulp sooner or later it is told in order",
          "[scene][first hit]") {
  for (const int exponent : {0, -37, 990, -990}) {
    const Scale of{exponent};
    CAPTURE(exponent);
    check_all({{"ray", "r"}, {"origin", of({-3, -2, 5})}, {"dir", of({3, 1, -2})}}, tied_in_a_point(of));
    check_all({{"ray", "r"}, {"origin", of({0, 0, 0})}, {"dir", of({1, 0, 0})}}, tied_at_a_root(of));
    check_all({{"ray", "r"}, {"origin", of({-3, -2})}, {"dir", of({3, 1})}}, tied_in_the_plane(of));
  }
}

TEST_CASE("hits are put in order where their t is too large for a double, or too small", "[scene][first hit]") {
  for (const auto& [size, direction] : {std::pair{600, -600}, {-600, 600}}) {
    const Scale of{size}, along{direction};
    CAPTURE(size);
    check_all({{"ray", "r"}, {"origin", of({-3, -2, 5})}, {"dir", along({3, 1, -2})}}, tied_in_a_point(of));
    check_all({{"line", "r"}, {"origin", of({0, 0, 0})}, {"dir", along({1, 0, 0})}}, tied_at_a_root(of));
    check_all({{"ray", "r"}, {"origin", of({-3, -2})}, {"dir", along({3, 1})}}, tied_in_the_plane(of));
  }
}

TEST_CASE("a segment whose ends are no vector apart meets what it meets in order, and all at once where it begins",
          "[scene][first hit]") {
  const Scale of{0};
  check_all({{"segment", "r"}, {"from", {-3, -2, 5}}, {"to", {9, 2, -3}}}, tied_in_a_point(of));
  const Json segment = {{"segment", "r"}, {"from", {0.1, 0, 0}}, {"to", {1e20, 0, 0}}};
  const Json box = {{"box", "A"}, {"lo", {3, -1, -1}}, {"hi", {4, 1, 1}}};
  const auto ball = [](double radius) { return Json{{"sphere", "B"}, {"center", {5, 0, 0}}, {"radius", radius}}; };
  CHECK(told(first_hit(segment, {box, ball(2)})) == "r meets A and B at the same t");
  CHECK(told(first_hit(segment, {box, ball(std::nextafter(2, 3))})).starts_with("r meets B first"));
  CHECK(told(first_hit(segment, {box, ball(std::nextafter(2, 1))})).starts_with("r meets A first"));
  CHECK(told(first_hit({{"ray", "r"}, {"origin", {3.5, 0, 0}}, {"dir", {1, 2, 3}}}, {box, ball(2)})) ==
        "r meets A and B at the same t");
}

TEST_CASE("a capsule whose ends coincide is met where the ball is, and not where the ray begins",
          "[scene][first hit]") {
  const Json ray = {{"ray", "r"}, {"origin", {-9, 4, 1}}, {"dir", {1, 0, 0}}};
  const Json capsule = {{"capsule", "C"}, {"p", {0, 0, 1}}, {"q", {0, 0, 1}}, {"r", 5}};  // at t = 6, by 3, 4, 5
  const auto box = [](double x) { return Json{{"box", "B"}, {"lo", {x, 3, 0}}, {"hi", {9, 5, 2}}}; };
  CHECK(told(first_hit(ray, {capsule, box(-3)})) == "r meets C and B at the same t");
  CHECK(told(first_hit(ray, {capsule, box(std::nextafter(-3, -4))})).starts_with("r meets B first"));
  CHECK(told(first_hit(ray, {capsule, box(std::nextafter(-3, 0))})).starts_with("r meets C first"));
}

TEST_CASE("what is thin is met like all else", "[scene][first hit]") {
  const auto first = [](const std::string& along, const std::string& other) {
    const File file = read_scene(R"({"objects": [)" + along + ", " + other +
                                     R"(, {"box": "b", "lo": [2,-1,-1], "hi": [3,1,1]}], "ask": [{"first hit": "r"}]})",
                                 "");
    return answers(file)[0]["verdict"].get<std::string>();
  };
  const std::string ray = R"({"ray": "r", "origin": [-4,0,0], "dir": [1,0,0]})";
  CHECK(first(ray, R"({"plane": "P", "normal": [0,1,0], "d": 0})") == "r meets P first, at t = 0");
  CHECK(first(ray, R"({"point": "e", "at": [-2,0,0]})") == "r meets e first, at t = 2");
  CHECK(first(ray, R"({"point": "e", "at": [2,0,0]})") == "r meets e and b at the same t");
  CHECK(first(ray, R"({"point": "e", "at": [-5,0,0]})") == "r meets b first, at t = 6");
  CHECK(first(ray, R"({"cloud": "C", "points": [[1,0,0],[-2,0,0],[0,5,0]]})") == "r meets C first, at t = 2");
  CHECK(first(ray, R"({"line": "g", "origin": [-1,0,0], "dir": [0,1,0]})") == "r meets g first, at t = 3");
  CHECK(first(ray, R"({"ray": "g", "origin": [-1,-1,0], "dir": [0,1,0]})") == "r meets g first, at t = 3");
  CHECK(first(ray, R"({"ray": "g", "origin": [-1,1,0], "dir": [0,1,0]})") == "r meets b first, at t = 6");
  CHECK(first(ray, R"({"line": "g", "origin": [9,0,0], "dir": [-2,0,0]})") == "r meets g first, at t = 0");
  CHECK(first(ray, R"({"ray": "g", "origin": [-3,0,0], "dir": [2,0,0]})") == "r meets g first, at t = 1");
  CHECK(first(ray, R"({"line": "g", "origin": [-1,0,1], "dir": [0,1,0]})") == "r meets b first, at t = 6");
  const std::string line = R"({"line": "r", "origin": [-4,0,0], "dir": [1,0,0]})";
  CHECK(first(line, R"({"plane": "P", "normal": [0,1,0], "d": 0})") == "r meets nothing first, as all of it lies in P");
  CHECK(first(line, R"({"plane": "P", "normal": [1,0,0], "d": 5})") == "r meets P first, at t = −1");
}

}  // namespace first_hit_test
