// What the lessons of points and of rays say, on settings that nobody chose, against rationals.

#include <limits>

#include "bench/ray_plane/oracle.h"
#include "lessons/lessons.h"
#include "lessons/points/picture.h"
#include "lessons/rays/picture.h"
#include "tests/catch.h"
#include "tests/lessons/random_settings.h"
#include "tests/lessons/words.h"
#include "tests/settings.h"
#include "viz/player/reader_state.h"
#include "viz/walk/closing.h"

namespace points_and_rays_words_test {
using namespace isect;
using namespace isect::viz;
using tests::answer, tests::says;

namespace {

const Step& step_of(const Walk& walk, const std::string& slug) {
  for (const Step& s : walk.steps)
    if (s.slug == slug) return s;
  FAIL("no step " << slug);
  return walk.steps.front();
}

/// Whether the points are at most `tolerance` apart; NaN: no.
bool near(const Vec3& p, const Vec3& q, double tolerance) {
  if (p.hasNaN() || q.hasNaN()) return false;
  using oracle::operator-;
  const auto l = oracle::rational<double, 3>(p) - oracle::rational<double, 3>(q);
  return oracle::dot(l, l) <= oracle::Rational(tolerance) * oracle::Rational(tolerance);
}

bool near_on_each_axis(const Vec3& p, const Vec3& q, double tolerance) {
  for (int i = 0; i < 3; ++i)
    if (abs(oracle::Rational(p[i]) - oracle::Rational(q[i])) > oracle::Rational(tolerance)) return false;
  return true;
}

}  // namespace

TEST_CASE("what the lesson of points says is true of any points, units and tolerances", "[point and ray words]") {
  const Lesson& lesson = lesson_named(lessons::all_lessons(), "points");
  bench::Random random(bench::stream(tests::seed(), "words of points"));
  for (int i = 0; i < tests::cases(1000, 10000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    Parameters p = tests::random_setting(lesson, random);
    if (random.one_in(8)) p["q"] = p["p"];  // their squares stay within the range
    const lessons::points_lesson::Setup s(p);
    const Walk walk = lesson.walk(p);
    const Step& last = walk.steps[outcome(walk)];
    if (walk.method == "equality") {
      CHECK(last.verdict.text == (s.tp == s.tq ? "EQUAL" : "DIFFERENT"));
      CHECK(last.line == (s.tp == s.tq ? 3 : 2));
      for (const Step& step : walk.steps) {
        if (says(step.caption, "ten steps")) CHECK(s.tq.x() == 1 - std::numeric_limits<double>::epsilon() / 2);
        if (step.question) CHECK((answer(step) == "DIFFERENT") == says(step.formula, "≠"));
        if (step.question && says(step.formula, "no number"))
          CHECK(says(step.question->because, "not a number is unequal"));
      }
    } else if (walk.method == "nearness") {
      const bool truth = near(s.tp, s.tq, s.tested_within);
      CHECK(last.verdict.text == (truth ? "NEAR" : "FAR"));
      int wrong = 0;
      for (const char* slug : {"squares", "distance", "coordinates"}) {
        const Step& step = step_of(walk, slug);
        wrong += says(step.caption, "and is wrong");
        CHECK(says(step.caption, "and is wrong") != says(step.caption, "it is right"));
        if (says(step.caption, "and is wrong")) CHECK(says(step.caption, truth ? "says FAR" : "says NEAR"));
        if (says(step.caption, "overflow")) CHECK(says(step.formula, "∞"));
        if (says(step.caption, "vanish")) CHECK(says(step.formula, " = 0 "));
      }
      const bool in_cube = !s.is_nan && near_on_each_axis(s.tp, s.tq, s.tested_within);
      const std::string& why = step_of(walk, "squares").question->because;
      const bool rounded_err = says(step_of(walk, "squares").caption, "and is wrong") ||
                               says(step_of(walk, "distance").caption, "and is wrong");
      CHECK(says(why, "in the cube, but not in the ball") == (in_cube && !truth));
      CHECK(says(why, "leaves the range") == (rounded_err && s.unit != 1));
      CHECK(says(why, "rounding loses") == (rounded_err && s.unit == 1));
      const char* const counts[] = {"All four methods agree", "One of the other three", "Two of the other three",
                                    "All three other methods"};
      CHECK(says(last.caption, counts[wrong]));
    } else {
      const bool pq = near(s.tp, s.tq, s.tested_within), qr = near(s.tq, s.tr, s.tested_within),
                 pr = near(s.tp, s.tr, s.tested_within);
      CHECK((last.verdict.kind == Verdict::Kind::no) == (pq && qr && !pr));
      CHECK(says(last.caption, "All three are near") == (pq && qr && pr));
      CHECK(says(last.caption, "one of them is not near") == !(pq && qr));
    }
  }
}

TEST_CASE("what the lesson of rays says is true of any ray, segment, line and bullet", "[point and ray words]") {
  const Lesson& lesson = lesson_named(lessons::all_lessons(), "rays");
  bench::Random random(bench::stream(tests::seed(), "words of rays"));
  for (int i = 0; i < tests::cases(1000, 10000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const Parameters p = tests::random_setting(lesson, random);
    const Walk walk = lesson.walk(p);
    const Step& last = walk.steps[outcome(walk)];
    if (walk.method == "a bullet") {
      const Vec3 o = std::get<Vec3>(p.at("o")), d = std::get<Vec3>(p.at("d"));
      int seen = 0;  // the wall is the box from (1/4, -3/2) to (1/2, 7/4)
      for (const Vec3& at : {o, Vec3(o + d)})
        seen += at.x() >= 0.25 && at.x() <= 0.5 && at.y() >= -1.5 && at.y() <= 1.75;
      CHECK(answer(step_of(walk, "frames")) == std::to_string(seen));
      if (seen > 0) CHECK(last.verdict.kind == Verdict::Kind::yes);
      continue;
    }
    const lessons::rays_lesson::Setup s = lessons::rays_lesson::setup(p);
    const oracle::RayPlane truth = oracle::ray_plane(s.ray, s.plane);
    CHECK(last.verdict.kind == (truth.meets ? Verdict::Kind::yes : Verdict::Kind::no));
    CHECK(last.line == (truth.parallel ? 3 : truth.meets ? 6 : 5));
    CHECK(says(last.caption, "*t* < 0") == (truth.line && *truth.line < 0));
    CHECK(says(last.caption, "ends before") == (truth.line && !truth.meets && *truth.line > 0));
    CHECK(says(last.verdict.text, "lies in the wall") == truth.coplanar);
    const bool unit = s.made == lessons::rays_lesson::Made::unit || s.d.head<2>().squaredNorm() == 1;
    if (s.made != lessons::rays_lesson::Made::points)
      CHECK(says(step_of(walk, "parameter").caption, "signed distance") == unit);
  }
}

}  // namespace points_and_rays_words_test
