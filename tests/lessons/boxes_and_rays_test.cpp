// The lessons of boxes and of rays: what their presets show, against numbers worked out by hand.

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>

#include <isect/sphere_aabb.h>
#include "lessons/lessons.h"
#include "lessons/obb_obb/picture.h"
#include "lessons/ray_polygon/picture.h"
#include "lessons/shared/relation.h"
#include "tests/catch.h"
#include "viz/player/reader_state.h"
#include "viz/walk/closing.h"

namespace boxes_and_rays_test {
using namespace isect;
using namespace isect::viz;

namespace {

const Lesson& lesson(const std::string& id) { return lesson_named(lessons::all_lessons(), id); }

Walk walk_of(const std::string& id, const std::string& preset_id) {
  return lesson(id).walk(preset(lesson(id), preset_id).parameters);
}

const Step& step_of(const Walk& walk, const std::string& slug) {
  for (const Step& s : walk.steps)
    if (s.slug == slug) return s;
  FAIL("no step " << slug);
  return walk.steps.front();
}

bool has_step(const Walk& walk, const std::string& slug) {
  for (const Step& s : walk.steps)
    if (s.slug == slug) return true;
  return false;
}

double value_of(const Step& step, const std::string& name) {
  for (const Value& v : step.values)
    if (v.name == name) return v.value;
  FAIL("no value " << name);
  return 0;
}

/// The methods that do not agree with the exact one.
std::vector<std::string> dissenters(const std::string& id, const std::string& preset_id) {
  std::vector<std::string> found;
  for (const Opinion& o : lesson(id).opinions(preset(lesson(id), preset_id).parameters))
    if (!o.agrees) found.push_back(o.method);
  return found;
}

}  // namespace

TEST_CASE("the ball-and-box lesson gathers the squared distance axis by axis", "[sphere-aabb]") {
  const Walk walk = walk_of("sphere-aabb", "corner");  // gaps 3/4, 5/8, -5/8
  CHECK(value_of(step_of(walk, "axis-x"), "*d*^2") == 0.5625);
  CHECK(value_of(step_of(walk, "axis-y"), "*d*^2") == 0.953125);
  CHECK(value_of(step_of(walk, "axis-z"), "*d*^2") == 1.34375);
  CHECK(step_of(walk, "axis-y").line == 2);
  CHECK(step_of(walk, "axis-z").line == 1);
  CHECK(step_of(walk, "relation").comparison->right == 2.25);
  CHECK(walk.steps.back().counters.mul == 4);
  CHECK(walk.steps.back().counters.sqrt == 0);
}

TEST_CASE("the ball-and-box lesson shows every region and every relation", "[sphere-aabb]") {
  const std::map<std::string, std::pair<int, Verdict::Kind>> expected = {
      {"corner", {3, Verdict::Kind::yes}},         {"corner-miss", {3, Verdict::Kind::no}},
      {"touching-face", {1, Verdict::Kind::on}},   {"touching-edge", {2, Verdict::Kind::on}},
      {"touching-corner", {3, Verdict::Kind::on}}, {"ball-inside", {0, Verdict::Kind::yes}},
      {"box-inside", {0, Verdict::Kind::yes}},     {"face", {1, Verdict::Kind::yes}},
      {"edge", {2, Verdict::Kind::yes}},           {"apart", {1, Verdict::Kind::no}},
      {"centre-inside", {0, Verdict::Kind::yes}}};
  CHECK(expected.size() == lesson("sphere-aabb").presets.size());
  for (const auto& [id, what] : expected) {
    INFO(id);
    const Walk walk = walk_of("sphere-aabb", id);
    int gaps = 0;
    for (const char* axis : {"axis-x", "axis-y", "axis-z"}) gaps += step_of(walk, axis).line > 0 ? 1 : 0;
    CHECK(gaps == what.first);
    CHECK(walk.steps.back().verdict.kind == what.second);
    const bool note_says_overlap = step_of(walk, "relation").line == 3;
    CHECK(note_says_overlap == (what.second == Verdict::Kind::yes));  // touching: the strict comparison refuses
  }
  CHECK(walk_of("sphere-aabb", "ball-inside").steps.back().verdict.text == "the ball lies inside the box");
  CHECK(walk_of("sphere-aabb", "box-inside").steps.back().verdict.text == "the box lies inside the ball");
}

TEST_CASE("the box grown by the radius errs at a corner, and the note's comparison at touching", "[sphere-aabb]") {
  CHECK(has_step(walk_of("sphere-aabb", "corner-miss"), "grown"));
  CHECK_FALSE(has_step(walk_of("sphere-aabb", "touching-face"), "grown"));
  CHECK(dissenters("sphere-aabb", "corner-miss") == std::vector<std::string>{"centre in the box expanded by *r*"});
  CHECK(dissenters("sphere-aabb", "touching-corner") == std::vector<std::string>{"if, else (<), the note's"});
  CHECK(dissenters("sphere-aabb", "corner").empty());
}

TEST_CASE("a box with exchanged corners meets no ball", "[sphere-aabb]") {
  Parameters p = lesson("sphere-aabb").presets.front().parameters;
  p["b_max"] = Vec3(-3, 1, 1);
  CHECK(lesson("sphere-aabb").walk(p).steps.back().verdict.kind == Verdict::Kind::no);
}

namespace {

/// The greatest of 15 numbers that are positive where the axis separates, each divided by the axis's length: from the
/// corners themselves, without the core's polynomials.
double widest_gap(const Obb<double, 3>& a, const Obb<double, 3>& b) {
  std::vector<Vec3> axes;
  for (int i = 0; i < 3; ++i) axes.insert(axes.end(), {Vec3(a.axes.col(i)), Vec3(b.axes.col(i))});
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) axes.push_back(a.axes.col(i).cross(b.axes.col(j)));
  double widest = -1e300;
  for (const Vec3& l : axes) {
    if (l.norm() < 1e-9) continue;
    const auto ends = [&](const Obb<double, 3>& box) {
      Interval<double> range = {1e300, -1e300};
      for (int i = 0; i < 8; ++i) {
        const Vec3 s((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
        const double at = l.normalized().dot(box.center + box.axes * box.half.cwiseProduct(s));
        range = {std::min(range.lo, at), std::max(range.hi, at)};
      }
      return range;
    };
    const Interval<double> of_a = ends(a), of_b = ends(b);
    widest = std::max(widest, std::max(of_a.lo - of_b.hi, of_b.lo - of_a.hi));
  }
  return widest;
}

}  // namespace

TEST_CASE("the oriented-box lesson: each kind of axis separates in a preset, alone of the kinds so far", "[obb-obb]") {
  const auto slugs = [](const char* id) {
    std::vector<std::string> all;
    const Walk walk = walk_of("obb-obb", id);
    for (int i = 0; i <= outcome(walk); ++i) all.push_back(walk.steps[i].slug);
    return all;
  };
  CHECK(slugs("normal-of-a") == std::vector<std::string>{"axes", "normals-a", "relation"});
  CHECK(slugs("normal-of-b") == std::vector<std::string>{"axes", "normals-a", "normals-b", "relation"});
  CHECK(slugs("edges") == std::vector<std::string>{"axes", "normals-a", "normals-b", "edges", "relation"});
  for (const char* id : {"normal-of-a", "normal-of-b", "edges"}) {
    INFO(id);
    const Step& last = walk_of("obb-obb", id).steps.back();
    CHECK(last.verdict.kind == Verdict::Kind::no);
    CHECK(last.counters.early_out);
    CHECK(widest_gap(lessons::obb_obb_lesson::setup(preset(lesson("obb-obb"), id).parameters).a,
                     lessons::obb_obb_lesson::setup(preset(lesson("obb-obb"), id).parameters).b) > 0.25);
  }
}

TEST_CASE("the oriented-box lesson ends with the true relation", "[obb-obb]") {
  const std::map<std::string, Relation> expected = {
      {"overlapping", Relation::overlapping}, {"normal-of-a", Relation::disjoint}, {"normal-of-b", Relation::disjoint},
      {"edges", Relation::disjoint},          {"touching", Relation::touching},    {"b-inside-a", Relation::b_inside_a},
      {"parallel", Relation::overlapping},    {"slender", Relation::disjoint}};
  CHECK(expected.size() == lesson("obb-obb").presets.size());
  for (const auto& [id, relation] : expected) {
    INFO(id);
    const auto setup = lessons::obb_obb_lesson::setup(preset(lesson("obb-obb"), id).parameters);
    const double gap = widest_gap(setup.a, setup.b);
    if (relation == Relation::touching)
      CHECK(std::abs(gap) < 1e-15);
    else
      CHECK((gap > 0) == (relation == Relation::disjoint));
    CHECK(walk_of("obb-obb", id).steps.back().verdict.text == lessons::relation_words(relation, "the boxes"));
  }
  CHECK(value_of(walk_of("obb-obb", "overlapping").steps.back(), "axes asked") == 15);
}

TEST_CASE("the classical test errs on parallel edges without its epsilon, and on thin boxes with a coarse one",
          "[obb-obb]") {
  const Walk parallel = walk_of("obb-obb", "parallel");
  CHECK(step_of(parallel, "edges").line == 6);  // DISJOINT, by rounding errors
  CHECK(value_of(step_of(parallel, "edges"), "*d* = |**n** · **l**|") < 1e-15);
  CHECK(parallel.steps.back().verdict.kind == Verdict::Kind::yes);
  CHECK(dissenters("obb-obb", "parallel").front() == "no epsilon");
  CHECK(walk_of("obb-obb", "slender").steps.back().line == 7);  // OVERLAP
  CHECK(dissenters("obb-obb", "slender") == std::vector<std::string>{"epsilon 0.125"});
  CHECK(dissenters("obb-obb", "overlapping").empty());
}

TEST_CASE("the map of oriented boxes agrees with the projections of their corners", "[obb-obb]") {
  const CaseMap& map = *lesson("obb-obb").map;
  const auto says = [&](const Parameters& p) { return map.branches[map.branch(p)]; };
  const Parameters edges = preset(lesson("obb-obb"), "edges").parameters;
  CHECK(says(edges) == "edge × edge");
  int apart = 0;
  for (int i = 0; i < 64; ++i) {
    const Vec2 share((i % 8 + 0.4) / 8, (i / 8 + 0.6) / 8);
    const Parameters there = map.moved(edges, map.lo + share.cwiseProduct(map.hi - map.lo));
    const auto setup = lessons::obb_obb_lesson::setup(there);
    const bool disjoint = widest_gap(setup.a, setup.b) > 0;
    CHECK((says(there) == "edge × edge" || says(there).starts_with("a normal")) == disjoint);
    apart += disjoint ? 1 : 0;
  }
  CHECK((apart > 8 && apart < 56));
}

TEST_CASE("directions that make no frame make no box", "[obb-obb]") {
  Parameters p = lesson("obb-obb").presets.front().parameters;
  p["b_v"] = p["b_u"];
  CHECK(lesson("obb-obb").walk(p).steps.back().verdict.kind == Verdict::Kind::no);
}

TEST_CASE("the rays lesson: t counts lengths of the direction, and the range says whether it counts", "[rays]") {
  const auto t_of = [](const char* id) { return value_of(step_of(walk_of("rays", id), "wall"), "*t*"); };
  const auto kind = [](const char* id) { return walk_of("rays", id).steps.back().verdict.kind; };
  CHECK(t_of("ray") == 3);
  CHECK(t_of("unit") == Approx(3 * std::hypot(1.5, 0.5)).epsilon(1e-15));
  CHECK(t_of("ray-behind") == -1);
  CHECK(t_of("line") == -1);
  CHECK(t_of("segment-on") == 1);
  CHECK(t_of("segment") > 1);
  for (const char* id : {"ray", "unit", "line", "segment-on"}) CHECK(kind(id) == Verdict::Kind::yes);
  for (const char* id : {"ray-behind", "segment", "parallel", "slow-bullet"}) CHECK(kind(id) == Verdict::Kind::no);
  CHECK(kind("segment-in-wall") == Verdict::Kind::yes);
  CHECK_FALSE(has_step(walk_of("rays", "parallel"), "wall"));
  CHECK(walk_of("rays", "ray").steps.back().counters.sqrt == 0);
  CHECK(walk_of("rays", "unit").steps.back().counters.sqrt == 1);
  CHECK(walk_of("rays", "unit").steps.back().counters.div == walk_of("rays", "ray").steps.back().counters.div + 2);
}

TEST_CASE("the map of rays is that of t = distance / direction, however the ray is made", "[rays]") {
  const CaseMap& map = *lesson("rays").map;
  std::map<std::string, int> seen;
  for (const char* id : {"ray", "line", "segment", "unit"})
    for (int i = 0; i < 64; ++i) {
      const Vec2 to(1.5 * (i % 8) - 5.25, i / 8 - 3.0);  // exact, with a row of parallel rays
      const Parameters there = map.moved(preset(lesson("rays"), id).parameters, to);
      const std::string says = map.branches[map.branch(there)];
      INFO(id << " at " << to.transpose());
      const double t = to.x() / to.y();
      CHECK(says == (to.y() == 0 ? "parallel" : t < 0 ? "behind **o**" : t <= 1 ? "within **d**" : "beyond **d**"));
      ++seen[says];
    }
  CHECK(seen.size() == 4);
}

TEST_CASE("the rays lesson: the bullet hits between two frames that both miss it", "[rays]") {
  const Walk walk = walk_of("rays", "bullet");
  const Question& seen = *step_of(walk, "frames").question;
  CHECK(seen.choices[seen.answer] == "0");
  CHECK(walk.steps.back().verdict.kind == Verdict::Kind::yes);
  CHECK(value_of(walk.steps.back(), "*t*_{in}") == Approx(2.75 / 4.5).epsilon(1e-15));
}

TEST_CASE("a ray without a direction is a point, and the rays lesson does not stumble over it", "[rays]") {
  for (const char* made : {"direction", "unit", "points", "motion"}) {
    INFO(made);
    Parameters p = lesson("rays").presets.front().parameters;
    p["made"] = std::string(made);
    p["d"] = Vec3(0, 0, 0);
    p["q"] = p["o"];
    CHECK(lesson("rays").walk(p).steps.back().verdict.kind == Verdict::Kind::no);
  }
}

TEST_CASE("the ray-polygon lesson drops the coordinate whose projection has the largest area", "[ray-polygon]") {
  for (const Preset& p : lesson("ray-polygon").presets) {
    INFO(p.id);
    const auto setup = lessons::ray_polygon_lesson::setup(p.parameters);
    const Walk walk = lesson("ray-polygon").walk(p.parameters);
    std::array<double, 3> area2 = {};  // by the shoelace formula, of each projection
    for (int axis = 0; axis < 3; ++axis) {
      const auto flat = lessons::ray_polygon_lesson::flattened(setup, {0, 0, 0}, axis);
      for (std::size_t i = 0; i < flat.ring.size(); ++i) {
        const auto &a = flat.ring[i], &b = flat.ring[(i + 1) % flat.ring.size()];
        area2[axis] += a.x() * b.y() - a.y() * b.x();
      }
      CHECK(value_of(walk.steps.front(), std::string("*n*_") + "xyz"[axis]) == Approx(area2[axis]).margin(1e-12));
    }
    if (!has_step(walk, "drop")) continue;
    const int dropped = step_of(walk, "drop").question->answer;
    for (const double other : area2) CHECK(std::abs(area2[dropped]) >= std::abs(other));
  }
}

TEST_CASE("the ray-polygon lesson shows every way to hit and to miss", "[ray-polygon]") {
  using enum Verdict::Kind;
  const std::map<std::string, std::pair<Verdict::Kind, int>> expected = {
      {"hit", {yes, 6}},     {"notch", {no, 7}},    {"behind", {no, 3}}, {"parallel", {no, 1}},
      {"coplanar", {on, 1}}, {"upright", {yes, 6}}, {"on-edge", {on, 7}}};
  CHECK(expected.size() == lesson("ray-polygon").presets.size());
  for (const auto& [id, what] : expected) {
    INFO(id);
    const Step& last = walk_of("ray-polygon", id).steps.back();
    CHECK(last.verdict.kind == what.first);
    CHECK(last.line == what.second);
  }
  CHECK(value_of(walk_of("ray-polygon", "hit").steps.back(), "*t*") == 2);
  const auto crossed = [](const char* id) {
    const Walk walk = walk_of("ray-polygon", id);
    const Question& q = *step_of(walk, "crossings").question;
    return q.choices[static_cast<std::size_t>(q.answer)];
  };
  CHECK(crossed("hit") == "1");
  CHECK(crossed("notch") == "2");
}

TEST_CASE("the wrong coordinate dropped collapses an upright polygon, and nothing is inside", "[ray-polygon]") {
  CHECK(value_of(walk_of("ray-polygon", "upright").steps.back(), "*n*_y") == 0);
  CHECK(dissenters("ray-polygon", "upright") == std::vector<std::string>{"*y* dropped"});
  CHECK(dissenters("ray-polygon", "hit").empty());
  CHECK(dissenters("ray-polygon", "on-edge").front() == "projected (the note)");
}

}  // namespace boxes_and_rays_test
