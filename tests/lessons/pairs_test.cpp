// The lessons of two shapes: their presets are what their names say, and their last step is the exact answer.

#include <map>
#include <sstream>

#include <isect/aabb_aabb.h>
#include <isect/capsule_capsule.h>
#include <isect/interval_interval.h>
#include <isect/sphere_sphere.h>
#include "bench/capsule_capsule/oracle.h"
#include "bench/random.h"
#include "lessons/lessons.h"
#include "lessons/shared/relation.h"
#include "tests/catch.h"
#include "tests/settings.h"
#include "viz/player/reader_state.h"
#include "viz/walk/closing.h"

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
  return relate(Sphere<double, 3>{vector(p, "a"), number(p, "r_a")},
                Sphere<double, 3>{vector(p, "b"), number(p, "r_b")});
}
Capsule<double, 2> capsule(const Parameters& p, const std::string& of) {
  return {vector(p, ("p_" + of).c_str()).head<2>(), vector(p, ("q_" + of).c_str()).head<2>(),
          number(p, ("r_" + of).c_str())};
}
Relation of_capsules(const Parameters& p) { return relate(capsule(p, "a"), capsule(p, "b")); }

/// The exact relation of each preset, which the last step's verdict must name.
std::map<std::string, Relation> relations(const std::string& lesson, Relation (*exact)(const Parameters&)) {
  std::map<std::string, Relation> found;
  const Lesson& l = lesson_named(lessons::all_lessons(), lesson);
  for (const Preset& p : l.presets) {
    INFO(lesson << " " << p.id);
    const Relation truth = exact(p.parameters);
    const Verdict verdict = l.walk(p.parameters).steps.back().verdict;
    CHECK(verdict.kind == lessons::verdict_kind(truth));
    bool named = false;
    for (const char* they : {"the intervals", "the points", "the boxes", "the balls", "the capsules"})
      named = named || verdict.text == lessons::relation_words(truth, they);
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

TEST_CASE("the capsule lesson asks for a crossing, then for the ends, and ends with the exact relation",
          "[pair lessons]") {
  const auto is = relations("capsule-capsule", of_capsules);
  CHECK(is == std::map<std::string, Relation>{{"side", overlapping},
                                              {"ends", disjoint},
                                              {"crossing", overlapping},
                                              {"parallel", touching},
                                              {"touching", touching},
                                              {"inside", b_inside_a},
                                              {"segments", overlapping}});
  const auto slugs = [](const char* id) {
    std::string all;
    const Walk walk = walk_of("capsule-capsule", id);
    for (int i = 0; i <= outcome(walk); ++i) all += walk.steps[i].slug + " ";
    return all;
  };
  CHECK(slugs("ends") == "reach crossing ends-a ends-b relation ");
  CHECK(slugs("side") == "reach crossing ends-a ends-b relation ");
  CHECK(slugs("crossing") == "reach crossing relation ");
  CHECK(slugs("inside") == "reach crossing ends-a relation ");  // an end of a is near enough

  const Lesson& lesson = lesson_named(lessons::all_lessons(), "capsule-capsule");
  for (const Preset& p : lesson.presets) {
    INFO(p.id);
    const std::vector<Opinion> said = lesson.opinions(p.parameters);
    CHECK(said[1].agrees == (p.id != "segments"));  // they cross where no double lies
  }
}

TEST_CASE("what the capsule lesson says of each end is true, in any setting", "[pair lessons]") {
  const Lesson& lesson = lesson_named(lessons::all_lessons(), "capsule-capsule");
  bench::Random random(tests::seed());
  std::map<std::string, int> heard;
  for (int i = 0; i < tests::cases(400, 20000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    Parameters p = lesson.presets.front().parameters;
    for (const char* end : {"p_a", "q_a", "p_b", "q_b"}) p[end] = Vec3(random.integer(-4, 4), random.integer(-3, 3), 0);
    for (const char* r : {"r_a", "r_b"}) p[r] = static_cast<double>(random.integer(0, 3));
    const Capsule<double, 2> a = capsule(p, "a"), b = capsule(p, "b");
    const oracle::Rational s = a.radius + b.radius;
    const std::pair<const char*, oracle::Rational> ends[] = {
        {"**p**_a", oracle::distance2(oracle::rational(a.p), oracle::stretch(b))},
        {"**q**_a", oracle::distance2(oracle::rational(a.q), oracle::stretch(b))},
        {"**p**_b", oracle::distance2(oracle::rational(b.p), oracle::stretch(a))},
        {"**q**_b", oracle::distance2(oracle::rational(b.q), oracle::stretch(a))}};

    const Walk walk = lesson.walk(p);
    CHECK(walk.steps.back().verdict.text == lessons::relation_words(oracle::relation(a, b), "the capsules"));
    for (const Step& step : walk.steps) {
      if (step.slug == "crossing" && step.formula == "*d* = 0")
        CHECK(oracle::distance2<2>(oracle::stretch(a), oracle::stretch(b)) == 0);
      std::istringstream lines(step.slug.starts_with("ends") ? step.caption : "");
      for (std::string line; std::getline(lines, line);)
        for (const auto& [name, d2] : ends) {
          if (!line.starts_with(name)) continue;
          const char* const far = d2 > s * s   ? "farther off than *R*."
                                  : d2 < s * s ? "nearer than *R*."
                                               : "exactly *R* away.";
          CHECK(line.ends_with(far));
          ++heard[far];
        }
    }
  }
  CHECK(heard.size() == 3);
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
