// Pairs of a scene that can be asked in more than one way: by a query or by exact ends, by faces or by facets, in
// numbers of any size. Each way is compared with rationals, and with the other ways.

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include <isect/ray_outline.h>

#include "app/scene/answered.h"
#include "app/scene/file.h"
#include "app/scene/object_pictures.h"
#include "app/scene/pairs.h"
#include "app/scene/shapes.h"
#include "bench/half_spaces/oracle.h"
#include "bench/simple_shapes.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "tests/settings.h"
#include "viz/text/rich_text.h"

namespace scene_ways_test {
using namespace isect;
using namespace isect::oracle;
using namespace isect::program::scene;
using isect::test::Contains;
using isect::viz::Vec3;

namespace {

/// A scene's objects, whose questions name them.
class Scene {
 public:
  explicit Scene(const Json& objects) : file_(read_scene(Json{{"objects", objects}}.dump(), ".")) {}

  const Object& object(const std::string& name) const { return file_.objects[index(name)]; }
  NamedValues numbers() const { return {file_.parameters, file_.flat}; }
  Shaped shaped(const std::string& name) const { return {numbers(), object(name)}; }
  Told ask(const std::string& a, const std::string& b) const { return program::scene::ask(shaped(a), shaped(b)); }
  std::string told(const std::string& a, const std::string& b) const { return viz::plain(ask(a, b).verdict.text); }
  Answered first_hit(const std::string& ray) const {
    return answered(Context{file_, numbers(), ObjectPictures().room(numbers(), file_.objects)},
                    FirstHitAsked{index(ray)});
  }

 private:
  std::size_t index(const std::string& name) const {
    return static_cast<std::size_t>(std::ranges::find(file_.objects, name, &Object::name) - file_.objects.begin());
  }
  File file_;
};

Json list(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Json segment(const char* name, const Vec3& p, const Vec3& q) {
  return {{"segment", name}, {"from", list(p)}, {"to", list(q)}};
}
Json ray(const char* name, const Vec3& p, const Vec3& d) {
  return {{"ray", name}, {"origin", list(p)}, {"dir", list(d)}};
}
Json hull(const char* name, const std::vector<Vec3>& points) {
  Json all = Json::array();
  for (const Vec3& p : points) all.push_back(list(p));
  return {{"hull", name}, {"points", all}};
}

/// The half-spaces of a hull's facets, in rationals.
Sides sides(const Hull3<double>& hull) {
  Sides all;
  for (const auto& [i, j, k] : hull.triangles) {
    const auto at = [&](int v) { return rational(hull.vertices[static_cast<std::size_t>(v)]); };
    const oracle::Place inward = cross(at(k) - at(i), at(j) - at(i));
    all.push_back({inward, -dot(inward, at(i))});
  }
  return all;
}

double number(const Json& t) { return t.is_number() ? t.get<double>() : t == "inf" ? HUGE_VAL : -HUGE_VAL; }

/// Whether the answer is this part of the line, each end to 2 ulp.
void check_part(const Json& result, const std::optional<std::pair<Rational, Rational>>& truth) {
  REQUIRE(result["hit"] == truth.has_value());
  if (!truth) return;
  CHECK(ulps(number(result["t_in"]), truth->first) <= 2);
  CHECK(ulps(number(result["t_out"]), truth->second) <= 2);
}

/// Exponents of the powers of two that scale whole numbers: ordinary, far out, and both ends of what a scene accepts.
constexpr int sizes[] = {0, -3, 60, 600, 990, -60, -600, -1000, -1060};

}  // namespace

TEST_CASE("what runs along a line and lies within a hull meets it, as far as it does, for any number of facets",
          "[scene]") {
  std::mt19937_64 random(tests::seed());
  const auto whole = [&](int reach) { return std::uniform_int_distribution<int>(-reach, reach)(random); };
  const auto any = [&](int reach) { return Vec3(whole(reach), whole(reach), whole(reach)); };
  int inside = 0, inexact = 0, missed = 0, many = 0;
  for (int i = 0; i < tests::cases(600, 60000); ++i) {
    std::vector<Vec3> points;
    for (int n = 4 + (i % 4 == 0 ? 60 : i % 9); n > 0; --n)
      points.push_back(i % 4 == 0 ? Vec3(any(90).normalized().unaryExpr([](double x) { return std::round(64 * x); }))
                                  : any(8));
    const Hull3<double> truth = convex_hull(points);
    if (truth.dimension < 3) continue;
    const double unit = std::ldexp(1, sizes[i % std::size(sizes)]);
    const bool tenths = i % 3 == 0;  // then the ends' difference is seldom a vector of doubles
    const auto within = [&] {
      Vec3 x = Vec3::Zero();
      for (int k = 0; k < 4; ++k) x += truth.vertices[static_cast<std::size_t>(random() % truth.vertices.size())] / 4;
      return x;
    };
    const auto place = [&]() -> Vec3 { return (tenths ? 0.1 : 1) * (whole(1) == 0 ? any(9) : 8 * within()); };
    Vec3 p = place(), q = place();
    if (i % 2 == 0) p = within(), q = within() * (tenths ? 0.7 : 1);
    if (p == q) q.x() += 1;
    std::vector<Vec3> scaled = points;
    for (Vec3& v : scaled) v *= unit;
    p *= unit, q *= unit;
    const Sides solid = sides(convex_hull(scaled));
    INFO("case " << i << ", " << truth.triangles.size() << " facets");
    Scene scene({hull("h", scaled), segment("s", p, q)});
    const auto part_of_segment = part(rational(p), rational(q), solid);
    check_part(scene.ask("s", "h").result, part_of_segment);
    CHECK(scene.told("h", "s") == (part_of_segment ? "s meets h" : "s misses h"));
    const Vec3 d = q - p;
    if (!d.isZero(0)) {
      Rational none = Rational(0x1p1000);
      none = none * none * none * none;
      Scene along({hull("h", scaled), ray("r", p, d), {{"line", "g"}, {"origin", list(p)}, {"dir", list(d)}}});
      const oracle::Place to = rational(p) + rational(d);
      check_part(along.ask("r", "h").result, part(rational(p), to, solid, 0, none));
      check_part(along.ask("g", "h").result, part(rational(p), to, solid, -none, none));
    }
    inside += part_of_segment && part_of_segment->first == 0 && part_of_segment->second == 1;
    missed += !part_of_segment, many += truth.triangles.size() > 40;
    inexact += rational(p) + rational(d) != rational(q);
  }
  CHECK((inside > 100 && inexact > 60 && missed > 60 && many > 60));
}

TEST_CASE("a segment is told alike, whether its direction or its ends are asked", "[scene]") {
  std::mt19937_64 random(tests::seed() + 1);
  const auto whole = [&](int reach) { return std::uniform_int_distribution<int>(-reach, reach)(random); };
  const auto any = [&](int reach) { return Vec3(whole(reach), whole(reach), whole(reach)); };
  std::map<std::string, int> hits, misses;
  for (int i = 0; i < tests::cases(1500, 150000); ++i) {
    const double unit = std::ldexp(1, sizes[i % std::size(sizes)]);
    Vec3 p = any(4), q = i % 11 == 0 ? p : any(4);
    if (i % 7 == 0) q[i % 3] = p[i % 3];
    p *= unit, q *= unit;
    const auto scaled = [&](const Vec3& v) { return list(unit * v); };
    const Vec3 a = any(3), b = any(3), c = any(3), d = any(3);
    Json corners = {scaled(a), scaled(b), scaled(c)},
         square = {scaled({-2, -2, 1}), scaled({2, -2, 1}), scaled({2, 2, 1}), scaled({-2, 2, 1})};
    if (i % 5 == 0) square[2] = scaled({0, 0, 1});  // with a notch
    const Json others = {
        {{"sphere", "S"}, {"center", scaled(a)}, {"radius", unit * (1 + i % 4)}},
        {{"box", "B"}, {"lo", scaled(a.cwiseMin(b))}, {"hi", scaled(a.cwiseMax(b))}},
        {{"obb", "O"},
         {"center", scaled(a)},
         {"u", {0, 1, 0}},
         {"v", {-1, 0, 0}},
         {"w", {0, 0, 1}},
         {"half", {2 * unit, unit, 0}}},
        {{"plane", "P"}, {"normal", list(b.isZero(0) ? Vec3(0, 0, 1) : b)}, {"d", unit * whole(3)}},
        {{"triangle", "T"}, {"points", corners}},
        {{"polygon", "N"}, {"points", square}},
        {{"mesh", "M"},
         {"points", {scaled(a), scaled(b), scaled(c), scaled(d)}},
         {"triangles", {{0, 1, 2}, {1, 2, 3}}}},
    };
    Json objects = others;
    objects.push_back(segment("s", p, q));
    const Scene scene(objects);
    for (const Json& other : others) {
      const std::string name = other.begin().value();
      const Told told = scene.ask("s", name);
      if (told.open || told.result.contains("hit_without_area")) continue;
      const Shaped s = scene.shaped("s"), o = scene.shaped(name);
      REQUIRE(s.ray());
      const Answer& by_direction = told.answer;
      Answer by_ends;
      if (name == "N") {
        by_ends.t = first_hit(s.as<Segment, 3>(), Polygon<double, 3>{{o.ring()}});
        by_ends.meet = by_ends.t.has_value();
      } else {
        by_ends = by_core(s, o);
      }
      INFO("case " << i << ": " << told.result.dump() << "\n" << objects.dump());
      ++(by_ends.meet ? hits : misses)[name];
      const auto near = [](const std::optional<double>& x, const std::optional<double>& y) {
        if (!x || !y) return x.has_value() == y.has_value();
        return std::abs(*x - *y) <= 4 * std::numeric_limits<double>::epsilon() * std::abs(*x);
      };
      CHECK(by_direction.meet == by_ends.meet);
      CHECK(near(by_direction.t, by_ends.t));
      CHECK(by_direction.part.has_value() == by_ends.part.has_value());
      if (by_ends.part) CHECK(near(by_direction.part->hi, by_ends.part->hi));
      CHECK(by_direction.tangent == by_ends.tangent);
      if (name == "P") CHECK((by_direction.coplanar == by_ends.coplanar && by_direction.parallel == by_ends.parallel));
    }
  }
  for (const char* name : {"S", "B", "O", "P", "T", "N", "M"}) {
    INFO(name);
    CHECK(hits[name] > 15);
    CHECK(misses[name] > 15);
  }
}

TEST_CASE("a segment whose direction is no vector of doubles meets a polygon, lies in its plane, or misses it",
          "[scene]") {
  const Json square = {{"polygon", "N"}, {"points", {{0, 0, 0.25}, {1, 0, 0.25}, {1, 1, 0.25}, {0, 1, 0.25}}}},
             flat = {{"triangle", "T"}, {"points", {{0, 0, 0.25}, {1, 1, 0.25}, {0.5, 0.5, 0.25}}}};
  const auto told = [&](const Vec3& p, const Vec3& q, const char* name) {
    return Scene({square, flat, segment("s", p, q)}).told("s", name);
  };
  CHECK(told({0.1, 0.1, 0.1}, {0.7, 0.3, 0.35}, "N") == "s meets N");
  CHECK(told({0.1, 0.1, 0.1}, {0.7, 0.3, 0.24}, "N") == "s misses N");
  CHECK(told({0.1, 0, 0.1}, {0.7, 0, 0.35}, "N") == "s meets N on its boundary");
  CHECK(told({0.1, 0.3, 0.25}, {0.7, 0.9, 0.25}, "N") == "s meets N, in whose plane it lies");
  CHECK(told({1.1, 0.3, 0.25}, {1.7, 0.9, 0.25}, "N") == "s misses N, in whose plane it lies");
  CHECK(told({0.1, 0.1, 0.1}, {0.1, 0.1, 0.7}, "T") == "s meets T");  // a segment itself
  CHECK(told({0.1, 0.1, 0.1}, {0.1, 0.3, 0.7}, "T") == "s misses T");
}

TEST_CASE("a line enters a capsule where it does, in numbers of any size", "[scene]") {
  const Vec3 origin(0, 0, -5), direction(0, 0, 1);
  for (int size = -1070; size <= 990; size += 5)
    for (int speed : {-1070, -500, 0, 500, 990}) {
      const double unit = std::ldexp(1, size), rate = std::ldexp(1, speed);
      const Scene scene({ray("r", unit * origin, rate * direction),
                         {{"capsule", "C"}, {"p", list({-unit, 0, 0})}, {"q", list({unit, 0, 0})}, {"r", 0.5 * unit}},
                         {{"sphere", "S"}, {"center", list({0, 0, -0.125 * unit})}, {"radius", unit * 0.25}}});
      if (unit * 0.25 == 0) continue;
      INFO(size << ' ' << speed);
      const Told answer = scene.ask("r", "C");
      CHECK(viz::plain(answer.verdict.text) == "r meets C");
      const Rational t = Rational(unit) / Rational(rate);
      CHECK(ulps(number(answer.result["t_in"]), Rational(t * 9 / 2)) <= 2);
      CHECK(ulps(number(answer.result["t_out"]), Rational(t * 11 / 2)) <= 2);
      if (size < -1015) continue;  // the distances themselves are hardly numbers
      CHECK_THAT(viz::plain(scene.first_hit("r").verdict.text), Contains("r meets C first, at t = "));
    }
}

TEST_CASE("what a ray meets first is told beyond the numbers that t can be", "[scene]") {
  for (const double unit : {1e-309, 1.0, 1e300}) {
    const Scene scene({ray("r", {0, 0, 0}, {unit, 0, 0}),
                       {{"sphere", "A"}, {"center", {30, 0, 0}}, {"radius", 1}},
                       {{"box", "B"}, {"lo", {20, -1, -1}}, {"hi", {21, 1, 1}}},
                       {{"obb", "C"},
                        {"center", {40, 0, 0}},
                        {"u", {1, 0, 0}},
                        {"v", {0, 1, 0}},
                        {"w", {0, 0, 1}},
                        {"half", {1, 1, 1}}},
                       {{"plane", "D"}, {"normal", {1, 0, 0}}, {"d", -25}},
                       {{"triangle", "E"}, {"points", {{23, -1, -1}, {23, 2, -1}, {23, -1, 2}}}},
                       {{"capsule", "F"}, {"p", {22.5, 0, 0}}, {"q", {22.5, 1, 0}}, {"r", 0.25}}});
    INFO(unit);
    const Answered first = scene.first_hit("r");
    CHECK_THAT(viz::plain(first.verdict.text), Contains("r meets B first"));
    std::string order;
    for (const Json& hit : first.json["hits"]) order += hit["object"].get<std::string>();
    CHECK(order == "BFEDAC");
    for (const char* name : {"A", "B", "C", "D", "E", "F"})
      CHECK(scene.told("r", name) == "r meets " + std::string(name));
  }
}

TEST_CASE("a point for a segment, and a t beyond all doubles, are answers of a ball like others", "[scene]") {
  const Json ball = {{"sphere", "S"}, {"center", {1, 1}}, {"radius", 1}};
  const auto told = [&](const Json& other) { return Scene({ball, other}).told("s", "S"); };
  const Json at = {{"segment", "s"}, {"from", {1, 1}}, {"to", {1, 1}}},
             off = {{"segment", "s"}, {"from", {2, 2}}, {"to", {2, 2}}};
  CHECK(told(at) == "s meets S");
  CHECK(told(off) == "s misses S");
  CHECK(told({{"line", "s"}, {"origin", {1, 1}}, {"dir", {0, 1e-309}}}) == "s meets S");
  CHECK(told({{"line", "s"}, {"origin", {9, 1}}, {"dir", {0, 1e-309}}}) == "s misses S");
  CHECK(told({{"ray", "s"}, {"origin", {1, -9}}, {"dir", {0, 1e-309}}}) == "s meets S");
  CHECK(told({{"ray", "s"}, {"origin", {1, -9}}, {"dir", {0, -1e-309}}}) == "s misses S");
}

TEST_CASE("of a line one point lies in a box only where it is one, not where rounding makes it one", "[scene]") {
  const auto told = [](const Json& line, const Json& lo, const Json& hi) {
    Json scene = {{"objects", {line, {{"box", "B"}, {"lo", lo}, {"hi", hi}}}}};
    scene["ask"] = Json::array({{{"clip", "g"}, {"to", "B"}}});
    const File file = read_scene(scene.dump(), ".");
    const NamedValues numbers{file.parameters, file.flat};
    const Answered out =
        answered(Context{file, numbers, ObjectPictures().room(numbers, file.objects)}, ClipAsked{0, 1});
    return viz::plain(out.verdict.text);
  };
  const auto line = [](const char* type, const Json& origin, const Json& dir) {
    return Json{{type, "g"}, {"origin", origin}, {"dir", dir}};
  };
  const Json lo = {10, -1, -1}, hi = {10.5, 1, 1};
  CHECK_THAT(told(line("ray", {0, 0, 0}, {1, 0, 0}), lo, hi), Contains("from t = 10 to 10.5"));
  CHECK_THAT(told(line("ray", {-1e30, 0, 0}, {1, 0, 0}), lo, hi), Contains("the part from"));
  CHECK_THAT(told(line("ray", {0, 0, 0}, {1e-309, 0, 0}), lo, hi), Contains("the part from"));
  CHECK_THAT(told(line("line", {9, 0, 0}, {1, 1, 0}), lo, hi), Contains("one point lies in B: t = 1"));
  CHECK_THAT(told(line("line", {9, 0, 0}, {1, 0.9999999999999999, 0}), lo, hi), Contains("the part from"));
  CHECK_THAT(told(line("ray", {10.5, 0, 0}, {1, 0, 0}), lo, hi), Contains("one point lies in B: t = 0"));
  CHECK_THAT(told(line("ray", {10, 1}, {1, 0}), {10, 0}, {11, 1}), Contains("from t = 0 to 1"));
  CHECK_THAT(told(segment("g", {10.25, 0, 0}, {10.25, 0, 0}), lo, hi), Contains("one point lies in B"));
  CHECK_THAT(told(segment("g", {0.1, 0, 0}, {10, 1, 1}), lo, hi), Contains("one point lies in B: t = 1"));
}

TEST_CASE("a k-DOP without a corner among the doubles lies in an outline or beside it", "[scene]") {
  // Its only point is (19/80, 23/80), then it is a segment of such points
  for (const double reach : {1.0, 1.0000000000000002}) {
    const Scene scene({{{"kdop", "K"}, {"normals", {{3, 1}, {1, 3}}}, {"lo", {1, 1.1}}, {"hi", {reach, 1.1}}},
                       {{"polygon", "P"}, {"points", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}}},
                       {{"polygon", "Q"}, {"points", {{0.25, 0}, {1, 0}, {1, 1}, {0.25, 1}}}},
                       {{"polygon", "R"},
                        {"rings", {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0.125, 0.125}, {0.5, 0.125}, {0.5, 0.5}}}}}});
    CHECK(scene.told("K", "P") == "K and P have a common point");
    CHECK(scene.told("K", "Q") == "K and Q are disjoint");
    CHECK(scene.told("K", "R") == "K and R have a common point");
  }
}

TEST_CASE("who holds whom is told in the order of the question", "[scene]") {
  const Scene scene(
      {{{"box", "B"}, {"lo", {0, 0, 0}}, {"hi", {1, 1, 1}}},
       {{"capsule", "C"}, {"p", {0, 0, 0}}, {"q", {1, 0, 0}}, {"r", 5}},
       {{"kdop", "K"}, {"normals", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {"lo", {-9, -9, -9}}, {"hi", {9, 9, 9}}},
       hull("H", {{-99, -99, -99}, {99, 0, -99}, {0, 99, -99}, {0, 0, 99}})});
  const std::string by_size = "BCKH";
  for (std::size_t i = 0; i < by_size.size(); ++i)
    for (std::size_t j = 0; j < by_size.size(); ++j) {
      if (i == j) continue;
      const std::string a(1, by_size[i]), b(1, by_size[j]);
      INFO(a << b);
      CHECK(scene.ask(a, b).result["relation"] == (i < j ? "b_contains_a" : "a_contains_b"));
      CHECK(scene.told(a, b) == (i < j ? a + " lies in " + b : b + " lies in " + a));
    }
}

}  // namespace scene_ways_test
