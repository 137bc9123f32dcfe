// What the lessons of two shapes say, on settings that nobody chose: the verdict in words, the lines and the counts are
// those of oracles that look at points or compute in rationals.

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <isect/aabb_aabb.h>
#include "bench/aabb_aabb/oracle.h"
#include "bench/capsule_capsule/oracle.h"
#include "bench/obb_obb/oracle.h"
#include "bench/sphere_aabb/oracle.h"
#include "bench/sphere_sphere/oracle.h"
#include "lessons/lessons.h"
#include "lessons/obb_obb/picture.h"
#include "lessons/relations/telling.h"
#include "lessons/shared/relation.h"
#include "lessons/sphere_sphere/picture.h"
#include "tests/catch.h"
#include "tests/lessons/random_settings.h"
#include "tests/lessons/words.h"
#include "tests/settings.h"
#include "viz/player/reader_state.h"
#include "viz/walk/closing.h"

namespace pairs_words_test {
using namespace isect;
using namespace isect::viz;
using tests::says;

namespace {

double number(const Parameters& p, const char* name) { return std::get<double>(p.at(name)); }
Vec3 vector(const Parameters& p, const char* name) { return std::get<Vec3>(p.at(name)); }

/// Runs `check(walk, last, setting)` on random settings of a lesson; `last` is the step that shows the outcome.
template <class Check>
void on_random_settings(const std::string& id, int few, const Check& check) {
  const Lesson& lesson = lesson_named(lessons::all_lessons(), id);
  bench::Random random(bench::stream(tests::seed(), id.c_str()));
  for (int i = 0; i < tests::cases(few, 10 * few); ++i) {
    const Parameters p = tests::random_setting(lesson, random);
    INFO(id << ", seed " << tests::seed() << ", case " << i);
    const Walk walk = lesson.walk(p);
    check(walk, walk.steps[outcome(walk)], p);
  }
}

/// The answer that a question accepts.
std::string answer(const Step& step) {
  return step.question->choices.at(static_cast<std::size_t>(step.question->answer));
}

/// The choice that the question "How do they lie?" accepts.
std::string in_choices(Relation r) {
  switch (r) {
    case Relation::a_inside_b:
    case Relation::b_inside_a:
      return "one inside the other";
    case Relation::equal:
      return "the same set";
    case Relation::touching:
      return "touching from outside";
    default:
      return lessons::relation_name(r);
  }
}

/// Checks the number that is typed as the answer to a question; where none can be typed, the right choice.
void asks_for(const Question& question, const oracle::Rational& truth) {
  const double exact = static_cast<double>(truth);
  if (question.number) {
    CHECK(std::abs(question.number->truth - exact) <= 1e-12 * std::abs(exact));
    return;
  }
  const std::string& right = question.choices.at(static_cast<std::size_t>(question.answer));
  CHECK((right == shown(exact) || right == shown(exact * (1 - 1e-12)) || right == shown(exact * (1 + 1e-12))));
}

/// Compares what the end of the walk of two balls says with rationals.
void said_of_balls(const Walk& walk, const Step& last, const Parameters& p) {
  const auto setup = lessons::sphere_sphere_lesson::setup(p);
  const Sphere<double, 3> a = setup.tested(setup.a), b = setup.tested(setup.b);
  const Relation truth = oracle::relation(a, b);
  CHECK(last.verdict.text == lessons::relation_words(truth, "the balls"));
  CHECK(last.verdict.kind == lessons::verdict_kind(truth));
  const bool overlap = last.line == 4, touch = truth == Relation::touching;
  CHECK(says(last.caption, "is wrong here") == (!touch && overlap != (truth != Relation::disjoint)));
  CHECK(says(last.caption, "calls touching DISJOINT") == touch);
  using oracle::operator-;
  const auto l = oracle::rational<double, 3>(a.center) - oracle::rational<double, 3>(b.center);
  const oracle::Rational rest = oracle::Rational(a.radius) - oracle::Rational(b.radius);
  const bool inside = truth == Relation::a_inside_b || truth == Relation::b_inside_a;
  if (overlap || touch) CHECK(says(last.caption, "internal tangency") == (inside && oracle::dot(l, l) == rest * rest));
  const bool one_point = truth == Relation::equal && a.radius == 0, inner = inside && oracle::dot(l, l) == rest * rest;
  CHECK(says(last.formula, " > ") == (truth == Relation::disjoint));
  CHECK(says(last.formula, " < ") == !(truth == Relation::disjoint || touch || inner || one_point));
  if (says(last.caption, "left the range")) CHECK(setup.unit != 1);
  if (says(last.caption, "rounding has changed")) CHECK(setup.unit == 1);
  const auto compare = std::ranges::find(walk.steps, std::string("compare"), &Step::slug);
  CHECK(says(compare->caption, "the same point") == one_point);
  if (says(compare->caption, "stored as zero")) CHECK((setup.unit < 1 && !one_point));
}

}  // namespace

TEST_CASE("what the interval lesson says is true of any two intervals, empty ones too", "[pair words]") {
  on_random_settings("intervals", 1000, [](const Walk& walk, const Step& last, const Parameters& p) {
    using Line = Aabb<double, 1>;
    const auto line = [](double lo, double hi) { return Line{Vector<double, 1>(lo), Vector<double, 1>(hi)}; };
    const double a_min = number(p, "a_min"), a_max = number(p, "a_max"), b_min = number(p, "b_min"),
                 b_max = number(p, "b_max");
    const Relation truth = oracle::by_points(line(a_min, a_max), line(b_min, b_max));
    const bool points = a_min == a_max && b_min == b_max, reversed = a_min > a_max || b_min > b_max;
    CHECK(last.verdict.text == lessons::relation_words(truth, points ? "the points" : "the intervals"));
    const bool gap_found = a_min > b_max || b_min > a_max;
    CHECK(last.question.has_value() == !(gap_found || points));  // it has been told
    if (last.question) CHECK(answer(last) == in_choices(truth));
    CHECK(last.line == (a_min > b_max ? 1 : b_min > a_max ? 3 : 4));
    CHECK(says(last.caption, "exchanged ends") == reversed);
    CHECK(last.formula.starts_with("common") == (!reversed && truth != Relation::disjoint));
    CHECK(last.formula.starts_with("gap") == (!reversed && truth == Relation::disjoint));
    for (const Step& step : walk.steps) {
      if (says(step.caption, "a common number")) CHECK(truth != Relation::disjoint);
      if (step.comparison) CHECK((step.comparison->meaning == "DISJOINT") == step.comparison->holds);
      if (!step.comparison || !step.question) continue;
      if (says(step.question->prompt, "How long is what they share")) {
        CHECK((step.slug == "b-beyond-a" && !reversed));
        asks_for(*step.question, std::min(oracle::Rational(a_max), oracle::Rational(b_max)) -
                                     std::max(oracle::Rational(a_min), oracle::Rational(b_min)));
        continue;
      }
      CHECK((answer(step) == "DISJOINT") == step.comparison->holds);
      if (step.slug == "b-beyond-a") CHECK((answer(step) == "OVERLAP") == !step.comparison->holds);
    }
  });
}

TEST_CASE("what the box lesson says is true of any two boxes, empty ones too", "[pair words]") {
  on_random_settings("aabb-aabb", 1000, [](const Walk& walk, const Step& last, const Parameters& p) {
    const Aabb<double, 3> a = {vector(p, "a_min"), vector(p, "a_max")}, b = {vector(p, "b_min"), vector(p, "b_max")};
    const Relation truth = oracle::by_points(a, b);
    CHECK(last.verdict.text == lessons::relation_words(truth, "the boxes"));
    const bool note_finds_a_gap = (a.lo.array() > b.hi.array()).any() || (b.lo.array() > a.hi.array()).any();
    CHECK(last.question.has_value() != note_finds_a_gap);  // it has been told
    if (last.question) CHECK(answer(last) == in_choices(truth));
    for (const Step& step : walk.steps)
      if (step.question && step.slug.starts_with("axis-")) {
        const int axis = step.slug.back() - 'x';
        const bool gap = a.lo[axis] > b.hi[axis] || b.lo[axis] > a.hi[axis];
        const auto common = [&](int i) -> oracle::Rational {
          return std::min(oracle::Rational(a.hi[i]), oracle::Rational(b.hi[i])) -
                 std::max(oracle::Rational(a.lo[i]), oracle::Rational(b.lo[i]));
        };
        if (says(step.question->prompt, "How long is what they share"))
          asks_for(*step.question, common(axis));
        else if (says(step.question->prompt, "What is the volume"))
          asks_for(*step.question, gap ? oracle::Rational(0) : common(0) * common(1) * common(2));
        else
          CHECK(answer(step) == (gap ? "DISJOINT" : axis == 2 ? "OVERLAP" : "nothing yet"));
      }
    CHECK(last.line == (note_finds_a_gap ? 2 : 3));
    CHECK(last.formula.starts_with("b ⊆ a") == (truth == Relation::b_inside_a));
    CHECK(last.formula.starts_with("a ⊆ b") == (truth == Relation::a_inside_b));
  });
}

TEST_CASE("what the sphere lesson says is true of any two balls, in huge and tiny units too", "[pair words]") {
  on_random_settings("sphere-sphere", 1000, said_of_balls);
  const Lesson& of_balls = lesson_named(lessons::all_lessons(), "sphere-sphere");
  bench::Random random(bench::stream(tests::seed(), "points and near misses"));
  int points = 0, rounded = 0;
  for (int i = 0; i < tests::cases(300, 3000); ++i) {
    Parameters p = tests::random_setting(of_balls, random);
    if (i % 3 != 0) p["b"] = p["a"];
    if (i % 3 != 1) p["r_a"] = 0.0, p["r_b"] = 0.0;
    if (i % 3 == 0) {  // as far apart as they reach, up to rounding
      const Vec3 way(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1));
      p["r_a"] = way.norm(), p["unit"] = std::string("one");
      p["b"] = Vec3(std::get<Vec3>(p["a"]) + way);
    }
    const Walk walk = of_balls.walk(p);
    const Step& last = walk.steps[outcome(walk)];
    INFO(last.caption << "\n" << last.formula);
    said_of_balls(walk, last, p);
    points += says(last.caption, "refuses it"), rounded += says(last.caption, "rounding has changed");
  }
  CHECK(points > 0);
  CHECK(rounded > 0);
  const Lesson& lesson = lesson_named(lessons::all_lessons(), "sphere-sphere");
  for (const Preset& p : lesson.presets) {
    INFO(p.id);
    const Walk walk = lesson.walk(p.parameters);
    const auto asked = std::ranges::find(walk.steps, std::string("compare"), &Step::slug);
    const auto setup = lessons::sphere_sphere_lesson::setup(p.parameters);
    CHECK(answer(*asked) == in_choices(oracle::relation(setup.tested(setup.a), setup.tested(setup.b))));
  }
}

TEST_CASE("what the sphere-and-box lesson says is true of any ball and box", "[pair words]") {
  on_random_settings("sphere-aabb", 1000, [](const Walk& walk, const Step& last, const Parameters& p) {
    const Sphere<double, 3> ball = {vector(p, "c"), number(p, "r")};
    const Aabb<double, 3> box = {vector(p, "b_min"), vector(p, "b_max")};
    const Relation truth = oracle::relation(ball, box);
    CHECK(last.verdict.kind == lessons::verdict_kind(truth));
    if ((box.lo.array() > box.hi.array()).any()) {
      CHECK(says(tests::own_step(walk, 3).caption, "exchanged"));
      return;
    }

    const Step& end = tests::own_step(walk, 3);
    CHECK(answer(end) == in_choices(truth));
    CHECK(says(end.caption, "does not reach") == (truth == Relation::disjoint));
    const Vec3 nearest = ball.center.cwiseMax(box.lo).cwiseMin(box.hi);
    const auto sides = (nearest.array() == box.lo.array() || nearest.array() == box.hi.array()).count();
    const char* const places[] = {"", "lies in a face", "lies on an edge", "is a corner"};
    if (nearest != ball.center) CHECK(says(end.caption, places[sides]));
    if (nearest == ball.center) CHECK(says(end.caption, "**c** itself"));
    const Vec3 reach = Vec3::Constant(ball.radius);
    const bool expanded_holds = (ball.center.array() >= (box.lo - reach).array()).all() &&
                                (ball.center.array() <= (box.hi + reach).array()).all();
    CHECK((last.slug == "grown") == (truth == Relation::disjoint && expanded_holds));
  });
}

TEST_CASE("what the oriented-box lesson says is true of any two boxes, with any epsilon", "[pair words]") {
  on_random_settings("obb-obb", 1000, [](const Walk& walk, const Step& last, const Parameters& p) {
    const auto setup = lessons::obb_obb_lesson::setup(p);
    const oracle::obb::Exactly<3> a(setup.a), b(setup.b);
    const Relation truth = oracle::obb::by_projection(a, b);
    CHECK(last.verdict.text == lessons::relation_words(truth, "the boxes"));
    CHECK(answer(last) == in_choices(truth));
    const bool meet = truth != Relation::disjoint, overlap = last.line == 7;
    CHECK(says(last.caption, "wrong here") == (meet != overlap));
    if (truth == Relation::b_inside_a && overlap) CHECK(says(last.caption, "*r*_b ≤ *r*_a for those of a"));
    if (truth == Relation::a_inside_b && overlap) CHECK(says(last.caption, "*r*_a ≤ *r*_b for those of b"));
    for (const Step& step : walk.steps) {
      if (says(step.caption, "there is a gap between the two projections")) CHECK_FALSE(meet);
      const bool group = step.slug == "normals-b" || step.slug == "edges";
      if (group && step.question)
        CHECK(answer(step) == (step.comparison->holds ? "DISJOINT" : step.slug == "edges" ? "OVERLAP" : "nothing yet"));
    }
  });
}

TEST_CASE("what the capsule lesson says at the end is true of any two capsules", "[pair words]") {
  on_random_settings("capsule-capsule", 1000, [](const Walk& walk, const Step& last, const Parameters& p) {
    const auto capsule = [&](const char* from, const char* to, const char* radius) {
      return Capsule<double, 2>{vector(p, from).head<2>(), vector(p, to).head<2>(), number(p, radius)};
    };
    const Capsule<double, 2> a = capsule("p_a", "q_a", "r_a"), b = capsule("p_b", "q_b", "r_b");
    const Relation truth = oracle::relation(a, b);
    CHECK(last.verdict.text == lessons::relation_words(truth, "the capsules"));
    CHECK(answer(last) == in_choices(truth));
    CHECK(last.line == (truth == Relation::disjoint                                     ? 4
                        : truth == Relation::touching || truth == Relation::overlapping ? 6
                                                                                        : 5));
    std::set<int> tested;  // the ends named so far
    const Vec2 ends[] = {a.p, a.q, b.p, b.q};
    const char* const names[] = {"**p**_a", "**q**_a", "**p**_b", "**q**_b"};
    for (const Step& step : walk.steps) {
      if (step.slug == "crossing") CHECK((answer(step) == "2") == (step.formula == "*d* = 0"));
      if (!step.slug.starts_with("ends-")) continue;
      double least = std::numeric_limits<double>::infinity();
      const std::string asked = step.question ? step.question->prompt : "";
      const std::string subject = asked.substr(0, asked.find("tested"));  // then come the other segment's ends
      for (int i = 0; i < 4; ++i) {
        if (step.question ? says(subject, names[i]) : says(step.caption, (names[i] + std::string(":")).c_str()))
          tested.insert(i);
        if (!tested.contains(i)) continue;
        const Capsule<double, 2>& other = i < 2 ? b : a;
        const Vec2 along = other.q - other.p;
        const double way = along.squaredNorm() > 0 ? (ends[i] - other.p).dot(along) / along.squaredNorm() : 0.0;
        least = std::min(least, (other.p + std::clamp(way, 0.0, 1.0) * along - ends[i]).norm());
      }
      CHECK(step.values.back().value == Approx(least).margin(1e-9));
      if (step.question) CHECK(answer(step) == shown(step.values.back().value));
    }
    const auto& comparison = last.comparison;
    const bool all = tested.size() == 4 || tested.empty();
    if (comparison && !comparison->holds)
      CHECK(says(comparison->meaning, "less still") == (!all && comparison->left > 0));
  });
}

TEST_CASE("what the lesson of relations says is true of any pair of any kind", "[pair words]") {
  using namespace lessons::relations_lesson;
  on_random_settings("relations", 1000, [](const Walk& walk, const Step& last, const Parameters& p) {
    const Kind* const kind = kind_of(p);
    if (!kind) {
      std::set<Relation> found;
      for (const Kind k : kinds) found.insert(Pair(k, pose(p)).truth);
      CHECK(answer(tests::own_step(walk, 0)) == std::to_string(found.size()));
      return;
    }
    const Pair pair(*kind, pose(p));
    Relation truth = pair.truth;
    if (const auto* box = std::get_if<Aabb<double, 3>>(&pair.a))
      truth = oracle::by_points(*box, std::get<Aabb<double, 3>>(pair.b));
    if (const auto* ball = std::get_if<Sphere<double, 3>>(&pair.a))
      truth = oracle::relation(*ball, std::get<Sphere<double, 3>>(pair.b));
    CHECK(last.verdict.text == lessons::relation_words(truth, they(*kind)));
    const std::map<Relation, int> lines = {{Relation::disjoint, 0},   {Relation::equal, 1},
                                           {Relation::a_inside_b, 2}, {Relation::b_inside_a, 3},
                                           {Relation::touching, 4},   {Relation::overlapping, 5}};
    CHECK(last.line == lines.at(truth));
    CHECK(answer(walk.steps[1]) == (truth == Relation::disjoint ? "1" : "5"));
    for (const Step& step : walk.steps)
      if (step.slug == "containment")
        CHECK(answer(step) == (truth == Relation::equal        ? "each in the other"
                               : truth == Relation::a_inside_b ? "a lies in b"
                               : truth == Relation::b_inside_a ? "b lies in a"
                                                               : "neither"));
    for (const Step& step : walk.steps) {
      if (step.slug != "containment") continue;
      const auto rings = std::ranges::count_if(step.scene.items, [](const Item& item) {
        const Dot* dot = std::get_if<Dot>(&item);
        return dot && dot->mark == Mark::ring && dot->role == Role::miss;
      });
      CHECK(says(step.question->because, "No point") == (rings == 0));
      CHECK(says(step.question->because, "of the larger one") == (rings == 1));
    }
    if (const auto* ball = std::get_if<Sphere<double, 3>>(&pair.a)) {
      const auto& other = std::get<Sphere<double, 3>>(pair.b);
      const oracle::Rational rest = oracle::Rational(ball->radius) - oracle::Rational(other.radius);
      using oracle::operator-;
      const auto l = oracle::rational<double, 3>(ball->center) - oracle::rational<double, 3>(other.center);
      const bool inside = truth == Relation::a_inside_b || truth == Relation::b_inside_a;
      CHECK(says(last.caption, "touch from inside") == (inside && oracle::dot(l, l) == rest * rest));
    }
  });
}

}  // namespace pairs_words_test
