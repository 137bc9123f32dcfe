// The lessons of two shapes: their presets are what their names say, and their last step is the exact answer.

#include <map>

#include <isect/aabb_aabb.h>
#include <isect/interval_interval.h>
#include <isect/sphere_sphere.h>
#include "lessons/lessons.h"
#include "lessons/shared/relation.h"
#include "tests/catch.h"
#include "viz/case_map.h"
#include "viz/place.h"

namespace pairs_test {
using namespace isect;
using namespace isect::viz;

namespace {

Walk walk_of(const std::string& lesson, const std::string& id) {
  const Lesson& l = lesson_named(lessons::all_lessons(), lesson);
  return l.walk(preset(l, id).parameters);
}

double number(const Parameters& p, const char* name) { return std::get<double>(p.at(name)); }
Vec3 vector(const Parameters& p, const char* name) { return std::get<Vec3>(p.at(name)); }

Relation of_intervals(const Parameters& p) {
  return relate(Interval<double>{number(p, "a_min"), number(p, "a_max")},
                Interval<double>{number(p, "b_min"), number(p, "b_max")});
}
Relation of_boxes(const Parameters& p) {
  return relate(Aabb<double, 3>{vector(p, "a_min"), vector(p, "a_max")},
                Aabb<double, 3>{vector(p, "b_min"), vector(p, "b_max")});
}
Relation of_balls(const Parameters& p) {  // the unit changes nothing about how they lie
  return relate(Sphere<double, 3>{vector(p, "a"), number(p, "r1")}, Sphere<double, 3>{vector(p, "b"), number(p, "r2")});
}

/// The relation of each preset, the exact one, which the last step's verdict has to name.
std::map<std::string, Relation> relations(const std::string& lesson, Relation (*exact)(const Parameters&)) {
  std::map<std::string, Relation> found;
  const Lesson& l = lesson_named(lessons::all_lessons(), lesson);
  for (const Preset& p : l.presets) {
    INFO(lesson << " " << p.id);
    const Relation truth = exact(p.parameters);
    const Verdict verdict = l.walk(p.parameters).steps.back().verdict;
    CHECK(verdict.kind == lessons::verdict_kind(truth));
    bool named = false;
    for (const char* they : {"the intervals", "the points", "the boxes", "the balls"})
      named = named || verdict.text == lessons::words(truth, they);
    CHECK(named);
    found[p.id] = truth;
  }
  return found;
}

using enum Relation;

}  // namespace

TEST_CASE("the interval lesson shows all six relations, and points", "[pair lessons]") {
  const auto is = relations("intervals", of_intervals);
  CHECK(is == std::map<std::string, Relation>{{"overlapping", overlapping},
                                              {"b-after-a", disjoint},
                                              {"a-after-b", disjoint},
                                              {"touching", touching},
                                              {"a-inside-b", a_inside_b},
                                              {"b-inside-a", b_inside_a},
                                              {"equal", equal},
                                              {"empty", disjoint},
                                              {"same-point", equal},
                                              {"near-points", disjoint}});
  CHECK(walk_of("intervals", "a-after-b").steps.back().counters.compare == 1);
  CHECK(walk_of("intervals", "a-after-b").steps.back().counters.early_out);
  CHECK(walk_of("intervals", "overlapping").steps.back().counters.compare == 2);
}

TEST_CASE("the box lesson shows all six relations, and stops at the first gap", "[pair lessons]") {
  const auto is = relations("aabb-aabb", of_boxes);
  for (const char* gap : {"gap-x", "gap-y", "gap-z"}) CHECK(is.at(gap) == disjoint);
  for (const char* part : {"touching-face", "touching-edge", "touching-corner"}) CHECK(is.at(part) == touching);
  CHECK(is.at("overlapping") == overlapping);
  CHECK(is.at("a-inside-b") == a_inside_b);
  CHECK(is.at("b-inside-a") == b_inside_a);
  CHECK(is.at("equal") == equal);
  const auto steps = [](const char* id) { return outcome(walk_of("aabb-aabb", id)) + 1; };
  CHECK(steps("gap-x") == 3);
  CHECK(steps("gap-y") == 4);
  CHECK(steps("gap-z") == 5);
  CHECK(steps("overlapping") == 5);
  CHECK(walk_of("aabb-aabb", "overlapping").steps.back().counters.compare == 6);
  CHECK(walk_of("aabb-aabb", "gap-x").steps.back().counters.compare <= 2);
}

TEST_CASE("the ball lesson shows the relations, and where the note's comparison fails", "[pair lessons]") {
  const auto is = relations("sphere-sphere", of_balls);
  CHECK(is == std::map<std::string, Relation>{{"overlapping", overlapping},
                                              {"disjoint", disjoint},
                                              {"touching", touching},
                                              {"inside", a_inside_b},
                                              {"inner-touch", b_inside_a},
                                              {"equal", equal},
                                              {"overflow", overlapping},
                                              {"underflow", overlapping}});
  const auto last = [](const char* id) { return walk_of("sphere-sphere", id).steps.back(); };
  CHECK(last("overlapping").line == 4);
  for (const char* failing : {"touching", "overflow", "underflow"}) CHECK(last(failing).line == 5);
  CHECK(last("overlapping").counters.sqrt == 0);
  CHECK(last("overlapping").counters.compare == 1);
}

TEST_CASE("exchanged ends make a shape empty, and the lessons say so", "[pair lessons]") {
  const Lesson& lines = lesson_named(lessons::all_lessons(), "intervals");
  Parameters p = lines.presets.front().parameters;
  p["a_max"] = -5.0;
  CHECK(lines.walk(p).steps.back().verdict.kind == Verdict::Kind::no);
  const Lesson& boxes = lesson_named(lessons::all_lessons(), "aabb-aabb");
  p = boxes.presets.front().parameters;
  p["a_max"] = Vec3(-5, 1, 1);
  CHECK(boxes.walk(p).steps.back().verdict.kind == Verdict::Kind::no);
  p["a_max"] = Vec3(1e6, -1e6, 0);
  CHECK_FALSE(boxes.walk(p).steps.empty());
}

}  // namespace pairs_test
