// What the lesson of two triangles says of sides, intervals, relation and mesh is what rational arithmetic says.

#include <map>
#include <random>
#include <set>

#include "bench/half_spaces/oracle.h"
#include "tests/catch.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"

namespace triangle_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using isect::test::Contains;
using oracle::Place;
using oracle::Rational;
using oracle::operator-;

namespace {

const std::string id = "triangle-triangle";

using Corners = std::array<Place, 3>;

Triangle<double, 3> triangle(const Parameters& p, const std::string& name) {
  Triangle<double, 3> x;
  for (std::size_t i = 0; i < 3; ++i) x.vertices[i] = std::get<Vec3>(p.at(name + std::to_string(i)));
  return x;
}
Corners corners(const Triangle<double, 3>& x) {
  return {oracle::rational(x.vertices[0]), oracle::rational(x.vertices[1]), oracle::rational(x.vertices[2])};
}
Place normal(const Corners& x) { return oracle::cross(x[1] - x[0], x[2] - x[0]); }
bool has_area(const Corners& x) {
  const Place n = normal(x);
  return oracle::dot(n, n) != 0;
}

/// The sides of the corners of x, seen from the plane.
std::array<int, 3> sides(const Corners& plane, const Corners& x) {
  std::array<int, 3> all = {};
  for (std::size_t i = 0; i < 3; ++i) all[i] = oracle::sign(oracle::dot(normal(plane), x[i] - plane[0]));
  return all;
}
bool on_one_side(const std::array<int, 3>& s) { return s[0] != 0 && s[0] == s[1] && s[0] == s[2]; }

/// How two triangles lie; both have an area.
Relation relation(const Triangle<double, 3>& a, const Triangle<double, 3>& b) {
  return oracle::relation(oracle::sides(a), oracle::sides(b));
}

/// Whether all that they share is no more than corners and edges of both: it is spanned by the corners they share.
bool no_fault(const Triangle<double, 3>& a, const Triangle<double, 3>& b) {
  std::set<Place> shared;
  const Corners x = corners(a), y = corners(b);
  for (const Place& p : x)
    for (const Place& q : y)
      if (p == q) shared.insert(p);
  if (shared.size() == 3) return false;
  // what they have in common is convex: it is spanned by the corners of the clipped triangle
  for (const Place& p : oracle::clipped(a, oracle::sides(b))) {
    if (shared.contains(p)) continue;
    if (shared.size() < 2) return false;
    const Place u = *shared.begin(), v = *shared.rbegin();
    const Place turn = oracle::cross(v - u, p - u);
    const Rational along = oracle::dot(p - u, v - u);
    if (oracle::dot(turn, turn) != 0 || along < 0 || along > oracle::dot(v - u, v - u)) return false;
  }
  return true;
}

/// Calls check(setting, walk) on all presets and on random settings.
template <class Check>
void over_settings(int how_many, const Check& check) {
  for (const Preset& p : lesson(id).presets) {
    INFO(p.id);
    check(p.parameters, lesson(id).walk(p.parameters));
  }
  on_random_settings(id, how_many, check);
}

/// Calls check(setting, walk) on triangles whose corners are whole numbers from 0 to 2: they touch often, in any way.
template <class Check>
void over_a_grid(int how_many, const Check& check) {
  std::mt19937 random(7);
  Parameters p = preset(lesson(id), "signs-crossing").parameters;
  for (int i = 0; i < how_many; ++i) {
    for (const char* name : {"a0", "a1", "a2", "b0", "b1", "b2"}) {
      Vec3 corner;
      for (int axis = 0; axis < 3; ++axis) corner[axis] = static_cast<double>(random() % 3);
      p[name] = corner;
    }
    CAPTURE(i);
    check(p, lesson(id).walk(p));
  }
}

bool told_rounding(const Walk& walk) {
  return std::ranges::any_of(walk.steps, [](const Step& s) {
    return says(s.caption, "Rounding has misled") || says(s.caption, "this method fails");
  });
}

}  // namespace

TEST_CASE("two triangles lie as rationals say, and the lesson tells when a method is wrong", "[words]") {
  std::map<Relation, int> seen;
  const auto check = [&](const Parameters& p, const Walk& walk) {
    const Triangle<double, 3> a = triangle(p, "a"), b = triangle(p, "b");
    if (!has_area(corners(a)) || !has_area(corners(b))) return;
    const Relation truth = relation(a, b);
    const std::string told = plain(ending(walk).verdict.text);
    CAPTURE(told);
    CHECK((ending(walk).verdict.kind == Verdict::Kind::no) == (truth == Relation::disjoint));
    CHECK(says(told, "disjoint") == (truth == Relation::disjoint));
    CHECK(says(told, "touch") == (truth == Relation::touching));
    CHECK(says(told, "overlap") == (truth == Relation::overlapping));
    const bool found = !says(walk.pseudocode[static_cast<std::size_t>(ending(walk).line)], "DISJOINT");
    const bool in_plane = says(walk.pseudocode[static_cast<std::size_t>(ending(walk).line)], "parts them");
    if (!in_plane) CHECK(told_rounding(walk) == (found != (truth != Relation::disjoint)));
    if (text(p, "method") == "signs") CHECK_FALSE(told_rounding(walk));
    ++seen[truth];
  };
  over_settings(150, check);
  over_a_grid(400, check);
  for (const Relation r : {Relation::disjoint, Relation::touching, Relation::overlapping}) CHECK(seen[r] > 20);
}

TEST_CASE("what is said of the sides of corners is true of their exact signs", "[words]") {
  std::set<std::string> seen;
  over_settings(150, [&](const Parameters& p, const Walk& walk) {
    const Corners of[] = {corners(triangle(p, "a")), corners(triangle(p, "b"))};
    for (const std::size_t which : {0U, 1U}) {
      const Step* step = find(walk, which == 0 ? "sides-a" : "sides-b");
      if (!step) continue;
      const auto s = sides(of[1 - which], of[which]);
      const auto [least, most] = std::ranges::minmax(s);
      const std::string told = plain(step->caption);
      CAPTURE(told);
      if (says(told, "Rounding has changed a sign") || says(told, "has no area")) continue;
      CHECK(says(told, "strictly on one side") == on_one_side(s));
      CHECK(says(told, "lie on both sides") == (least < 0 && most > 0));
      CHECK(told.starts_with("All corners of") == (on_one_side(s) || (least == 0 && most == 0)));
      const auto zeros = std::ranges::count(s, 0);
      const bool one_side = least == 0 || most == 0;
      CHECK(says(told, "One corner of") == (zeros == 1 && one_side));
      CHECK(says(told, "An edge of") == (zeros == 2 && has_area(of[which])));
      seen.insert(told.substr(0, 12));
      if (step->question) CHECK(step->question->answer == (on_one_side(s) ? 0 : least == 0 && most == 0 ? 3 : 2));
    }
  });
  CHECK(seen.size() >= 4);
}

TEST_CASE("the intervals are where the edges meet the other plane", "[words]") {
  int compared = 0;
  over_settings(150, [&](const Parameters& p, const Walk& walk) {
    const Corners of[] = {corners(triangle(p, "a")), corners(triangle(p, "b"))};
    for (const std::size_t which : {0U, 1U}) {
      const std::string name = which == 0 ? "a" : "b";
      const Step* step = find(walk, "interval-" + name);
      if (!step) continue;
      const Corners &x = of[which], &plane = of[1 - which];
      const std::string formula = plain(step->formula);
      const std::size_t axis = static_cast<std::size_t>(formula[formula.find(" on ") + 4] - 'x');
      const auto s = sides(plane, x);
      std::vector<double> ends;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if (s[i] == 0) ends.push_back(static_cast<double>(x[i][axis]));
        if (s[i] * s[j] >= 0) continue;
        const Rational from = oracle::dot(normal(plane), x[i] - plane[0]),
                       to = oracle::dot(normal(plane), x[j] - plane[0]);
        ends.push_back(static_cast<double>(Rational(x[i][axis] + from / (from - to) * (x[j][axis] - x[i][axis]))));
      }
      if (ends.empty()) continue;  // rounding alone has let it reach the plane
      const auto [lo, hi] = std::ranges::minmax(ends);
      CHECK(value(*step, name + " from") == Approx(lo).margin(1e-9));
      CHECK(value(*step, name + " to") == Approx(hi).margin(1e-9));
      ++compared;
    }
  });
  CHECK(compared > 30);
}

TEST_CASE("a mesh may have two triangles that share no more than corners and edges of both", "[words]") {
  std::set<int> answers;
  over_settings(150, [&](const Parameters& p, const Walk& walk) {
    const Triangle<double, 3> a = triangle(p, "a"), b = triangle(p, "b");
    const Step& step = *find(walk, "mesh");
    CAPTURE(step.caption);
    if (!has_area(corners(a)) || !has_area(corners(b))) {
      CHECK_THAT(step.caption, Contains("a fault by itself"));
      return;
    }
    const bool meet = relation(a, b) != Relation::disjoint;
    CHECK(says(step.caption, "no common point") == !meet);
    if (meet) CHECK(says(step.caption, "nothing else: no fault") == no_fault(a, b));
    CHECK(step.question.has_value() == meet);
    if (!step.question) return;
    CHECK(step.question->answer == (no_fault(a, b) ? 0 : 1));
    answers.insert(step.question->answer);
  });
  CHECK(answers.size() == 2);
}

TEST_CASE("a line of both planes is spoken of where both triangles have one and reach it", "[words]") {
  std::map<bool, int> seen;
  const auto check = [&](const Parameters& p, const Walk& walk) {
    const Corners a = corners(triangle(p, "a")), b = corners(triangle(p, "b"));
    const auto reaches = [](const Corners& plane, const Corners& x) {
      const auto s = sides(plane, x);
      return !on_one_side(s) && std::ranges::count(s, 0) < 3;
    };
    const bool has_line = has_area(a) && has_area(b) && reaches(a, b) && reaches(b, a);
    for (const char* slug : {"line", "order"}) {
      const Step* step = find(walk, slug);
      if (!step) continue;
      CAPTURE(step->caption);
      CHECK(says(step->caption, "meet in a line (dashed)") == has_line);
      if (std::string(slug) == "order") CHECK(step->question.has_value() == has_line);
      ++seen[has_line];
    }
    if (const Step* step = find(walk, "sides")) {
      CHECK(says(step->caption, "are not all axes") == !(has_area(a) && has_area(b)));
      if (says(step->caption, "separating axis"))
        CHECK(relation(triangle(p, "a"), triangle(p, "b")) == Relation::disjoint);
      if (says(step->caption, "no axis separates"))
        CHECK(relation(triangle(p, "a"), triangle(p, "b")) != Relation::disjoint);
    }
    const std::string& told = find(walk, "relation")->caption;
    if (says(told, "The interior of")) CHECK(says(told, "it is a segment") == !(has_area(a) && has_area(b)));
  };
  over_settings(150, check);
  over_a_grid(400, check);
  CHECK(seen[true] > 30);
  CHECK(seen[false] > 2);
}

TEST_CASE("a triangle without area that crosses a plane has no line of both planes", "[words]") {
  for (const char* of : {"crossing", "signs-crossing"}) {
    Parameters p = preset(lesson(id), of).parameters;
    p["a1"] = p["a2"];
    const Walk walk = lesson(id).walk(p);
    const bool by_signs = text(p, "method") == "signs";
    INFO(of);
    REQUIRE(find(walk, by_signs ? "order" : "sides"));
    CHECK_THAT(find(walk, by_signs ? "order" : "sides")->caption,
               Contains(by_signs ? "there is no line of both planes" : "are not all axes"));
  }
}

TEST_CASE("presets of two triangles are what their names say", "[words]") {
  const auto told = [](const std::string& preset_id) { return plain(ending(walk_of(id, preset_id)).verdict.text); };
  for (const char* touching : {"edge-on-edge", "vertex-on-face", "vertex-on-vertex", "neighbours"})
    CHECK_THAT(told(touching), Contains("touch"));
  for (const char* overlapping : {"crossing", "piercing", "on-plane", "one-plane"})
    CHECK_THAT(told(overlapping), Contains("overlap"));
  for (const char* disjoint : {"parallel", "above", "gap", "one-plane-apart", "segment", "rounding-meet"})
    CHECK_THAT(told(disjoint), Contains("disjoint"));
  CHECK_THAT(told("one-plane-inside"), Contains("b lies inside a"));
  for (const char* misled : {"rounding-apart", "rounding-gap", "rounding-meet", "segment"}) {
    INFO(misled);
    CHECK(told_rounding(walk_of(id, misled)));
    CHECK_FALSE(lesson(id).opinions(preset(lesson(id), misled).parameters)[1].agrees);
  }
}

}  // namespace triangle_words_test
