// What the lessons of volumes, hulls and hierarchies say, in words, is what brute force says.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include <isect/aabb_aabb.h>
#include <isect/orient.h>
#include <isect/ray_aabb.h>
#include <isect/triangle_aabb.h>
#include "lessons/bounding_volumes/object.h"
#include "lessons/convex_hull/picture.h"
#include "lessons/hierarchy/tree.h"
#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/lessons/random_settings.h"
#include "tests/settings.h"
#include "viz/player/reader_state.h"
#include "viz/walk/closing.h"

namespace volumes_words_test {
using namespace isect;
using namespace isect::viz;

namespace {

const Lesson& lesson(const char* id) { return lesson_named(lessons::all_lessons(), id); }
bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
std::string text_of(const Parameters& p, const char* name) { return std::get<std::string>(p.at(name)); }
Vec3 vector(const Parameters& p, const char* name) { return std::get<Vec3>(p.at(name)); }

template <class Look>
void over_settings(const Lesson& l, int how_many, const Look& look) {
  bench::Random random(bench::stream(tests::seed(), (l.id + " in words").c_str()));
  for (const Preset& p : l.presets) look(p.parameters);
  for (int i = 0; i < how_many; ++i) look(tests::random_setting(l, random));
}

/// The part of the sphere of all directions that the closed surface covers, seen from p: 1 inside, 0 outside.
double cover(const TriangleMesh<double>& mesh, const Vec3& p) {
  double angle = 0;
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) {
    const auto t = triangle(mesh, i);
    const Vec3 a = t.vertices[0] - p, b = t.vertices[1] - p, c = t.vertices[2] - p;
    const double x = a.norm(), y = b.norm(), z = c.norm();
    angle += 2 * std::atan2(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
  }
  return angle / (4 * std::numbers::pi);
}

}  // namespace

TEST_CASE("a box in the void, across the surface and wholly inside get a verdict each", "[bounding volumes]") {
  int within = 0, in_void = 0, crossing = 0, trivial = 0;
  const auto look = [&](Parameters p) {
    p["walk"] = std::string("test");
    const auto mesh = lessons::bounding_volumes_lesson::object(text_of(p, "object"), vector(p, "tip"));
    const Vec3 q = vector(p, "q"), reach = Vec3::Constant(std::get<double>(p.at("reach")));
    const Aabb<double, 3> b = {q - reach, q + reach};
    bool meets = false, all_in = true, all_beyond = false;
    for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i) meets = meets || intersects(triangle(mesh, i), b);
    for (int axis = 0; axis < 3; ++axis) {
      bool below = true, above = true;
      for (const Vec3& v : mesh.vertices) {
        below = below && v[axis] < b.lo[axis], above = above && v[axis] > b.hi[axis];
        all_in = all_in && b.lo[axis] <= v[axis] && v[axis] <= b.hi[axis];
      }
      all_beyond = all_beyond || below || above;
    }
    const Walk walk = lesson("bounding-volumes").walk(p);
    const std::string& said = walk.steps[outcome(walk)].verdict.text;
    CAPTURE(said, text_of(p, "object"), vector(p, "tip").transpose(), q.transpose(), reach.x());
    CHECK(holds(said, "trivial reject") == all_beyond);
    CHECK(holds(said, "trivial accept") == all_in);
    if (all_beyond || all_in) {
      ++trivial;
      return;
    }
    CHECK(holds(said, "CROSSING") == meets);
    if (meets) {
      ++crossing;
      return;
    }
    const double share = cover(mesh, q);
    const bool inside = share > 0.5;
    CHECK(std::abs(share - (inside ? 1 : 0)) < 1e-6);
    CHECK(holds(said, "b lies inside a") == inside);
    CHECK(holds(said, "in the void") == !inside);
    CHECK(lesson("bounding-volumes").map->branch(p) == (inside ? 4 : 2));
    within += inside, in_void += !inside;
  };
  over_settings(lesson("bounding-volumes"), tests::cases(700, 7000), look);
  bench::Random random(bench::stream(tests::seed(), "small boxes"));
  for (int i = 0; i < tests::cases(300, 3000); ++i) {
    Parameters p = tests::random_setting(lesson("bounding-volumes"), random);
    p["reach"] = random.uniform(0, 0.125), p["q"] = Vec3(random.uniform(-0.2, 0.9) * vector(p, "tip"));
    look(p);
  }
  for (const int seen : {within, in_void, crossing, trivial}) CHECK(seen > 20);
}

namespace {

/// Whether no two of the points span a segment on this side of p: +1 for the lower hull's vertices, -1 for the upper's.
bool on_chain(const Ring<double, 2>& points, const Point<double, 2>& p, int side) {
  for (const auto& a : points)
    for (const auto& b : points)
      if (before<double>(a, p) && before<double>(p, b) && side * orient2d(a, b, p) >= 0) return false;
  return true;
}

}  // namespace

TEST_CASE("a point leaves a chain of the hull only if it is not on that hull", "[convex hull]") {
  int removed = 0, several = 0, straight = 0;
  over_settings(lesson("convex-hull"), tests::cases(1000, 10000), [&](const Parameters& p) {
    const Ring<double, 2> points = lessons::convex_hull_lesson::points_of(p);
    int vertices = 0;
    Ring<double, 2> seen;
    for (const auto& x : points) {
      if (std::ranges::find(seen, x) != seen.end()) continue;
      seen.push_back(x);
      vertices += on_chain(points, x, 1) || on_chain(points, x, -1);
    }
    const Walk walk = lesson("convex-hull").walk(p);
    CAPTURE(vector(p, "p").transpose(), text_of(p, "points"));
    CHECK(walk.steps[outcome(walk)].verdict.text == "a hull of " + std::to_string(vertices) + " vertices");
    for (const Step& s : walk.steps) {
      const bool lower = s.slug.starts_with("lower-"), upper = s.slug.starts_with("upper-");
      if (!lower && !upper) continue;
      int gone = 0;
      for (const Item& item : s.scene.items)
        if (const auto* dot = std::get_if<Dot>(&item); dot && dot->mark == Mark::no) {
          const Point<double, 2> x = dot->at.head<2>();
          gone += std::ranges::count(points, x) > 1 ? 0 : 1;
          CHECK_FALSE(on_chain(points, x, lower ? 1 : -1));
          if (holds(s.caption, "runs straight on") && !holds(s.caption, "turn right"))
            CHECK((!on_chain(points, x, 1) && !on_chain(points, x, -1)));
        }
      CHECK((s.line == 1) == holds(s.title, "drop"));
      removed += gone > 0, several += gone > 1, straight += holds(s.caption, "straight");
      if (s.question && s.question->line) CHECK((s.question->line->truth == 2) == holds(s.title, "a left turn"));
      if (s.question && !s.question->line) CHECK(std::stoi(s.question->choices[s.question->answer]) >= gone);
    }
  });
  for (const int seen : {removed, several, straight}) CHECK(seen > 20);
}

TEST_CASE("a ray among boxes and two objects end with what brute force finds", "[hierarchy]") {
  namespace own = lessons::hierarchy_lesson;
  int hits = 0, misses = 0, pairs = 0, apart = 0;
  over_settings(lesson("hierarchy"), tests::cases(600, 6000), [&](Parameters p) {
    if (text_of(p, "walk") == "growth") p["walk"] = std::string("ray");
    const own::Boxes boxes = own::boxes_of(p);
    const Walk walk = lesson("hierarchy").walk(p);
    const Step& last = walk.steps[outcome(walk)];
    CAPTURE(last.verdict.text, last.caption);
    if (text_of(p, "walk") == "ray") {
      bool any = false;
      for (const auto& box : boxes)
        any = any || intersects(Ray<double, 2>{vector(p, "o").head<2>(), vector(p, "d").head<2>()}, box);
      CHECK((last.verdict.kind == Verdict::Kind::yes) == any);
      ++(any ? hits : misses);
    }
    if (text_of(p, "walk") == "pairs") {
      int met = 0;
      for (const auto& a : boxes)
        for (const auto& b : own::cluster(vector(p, "q"))) met += intersects(a, b);
      CHECK(last.verdict.text == (met == 0   ? "no pair meets"
                                  : met == 1 ? "1 pair meets"
                                             : std::to_string(met) + " pairs meet"));
      ++(met > 0 ? pairs : apart);
    }
    if (text_of(p, "walk") == "build") {
      int splits = 0;
      for (const Step& s : walk.steps) splits += s.slug.starts_with("cut-");
      for (const Value& v : last.values)
        if (v.name == "nodes") CHECK(v.value == 2 * splits + 1);
    }
  });
  for (const int seen : {hits, misses, pairs, apart}) CHECK(seen > 10);
}

}  // namespace volumes_words_test
