// What the lesson of moving bodies says in the end, in words and numbers, is what rational arithmetic says.

#include <set>

#include "tests/catch.h"
#include "tests/lessons/moving_oracle.h"
#include "viz/text/rich_text.h"

namespace moving_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using namespace isect::tests::moving;
using isect::test::Contains;

TEST_CASE("two moving bodies meet, and first do so, when rationals say so", "[words]") {
  std::set<std::string> seen;
  over_settings("", 400, [&](const Parameters& p, const Walk& walk) {
    const bool met = meet(p, number(p, "duration")), later = meet(p, long_after);
    const Step& last = ending(walk);
    const std::string told = plain(last.verdict.text);
    CAPTURE(told, last.caption);
    if (says(told, "within ε, but they do not meet")) {
      CHECK_FALSE(met);
      CHECK(last.verdict.kind == Verdict::Kind::on);
      seen.insert("near");
      return;
    }
    CHECK((last.verdict.kind != Verdict::Kind::no) == met);
    CHECK(says(told, "do not meet") == !met);
    CHECK(says(told, "do not meet by t") == (!met && later));
    if (!met) seen.insert(later ? "late" : "no");
    if (!met) return;
    const double first = first_contact_of(p);
    CHECK(shows(told, first));
    CHECK(told.ends_with("at t = 0") == (first == 0));
    const bool grazing = are_balls(p) && first > 0 && Balls(p).discriminant() == 0;
    if (are_balls(p)) CHECK(says(told, "they touch at") == (grazing || Balls(p).c == 0));
    seen.insert(grazing ? "grazing" : first == 0 ? "at once" : "met");
  });
  for (const char* outcome : {"near", "late", "no", "grazing", "at once", "met"}) {
    INFO(outcome);
    CHECK(seen.contains(outcome));
  }
}

TEST_CASE("b moves with the difference of the velocities, and the question accepts no other", "[words]") {
  int asked = 0;
  over_settings("", 100, [&](const Parameters& p, const Walk& walk) {
    const Step& seen = *find(walk, "seen-from-a");
    Vec2 d;
    for (int i = 0; i < 2; ++i)
      d[i] = static_cast<double>(Rational(coordinate(p, "v_b", i)) - Rational(coordinate(p, "v_a", i)));
    const std::string right = "(" + shown(d.x()) + ", " + shown(d.y()) + ")";
    CHECK_THAT(seen.formula, Contains(right));
    CHECK(says(seen.caption, "b is at rest, too") == (d == Vec2::Zero()));
    if (!seen.question) return;
    ++asked;
    const std::string& prompt = seen.question->prompt;
    CHECK(says(prompt, "*x*-component") != says(prompt, "*y*-component"));
    CHECK(answer(seen) == shown(d[says(prompt, "*x*-component") ? 0 : 1]));
  });
  CHECK(asked > 50);
}

TEST_CASE("rounding misleads the plain methods at great speed, and the lesson says so", "[words]") {
  for (const char* preset_id : {"fast", "balls-fast"}) {
    INFO(preset_id);
    const Parameters& p = preset(lesson(id), preset_id).parameters;
    const std::vector<Opinion> said = lesson(id).opinions(p);
    CHECK((said[0].says == "they meet") == meet(p, number(p, "duration")));
    CHECK_FALSE(said[1].agrees);
    CHECK_THAT(ending(lesson(id).walk(p)).caption, Contains("Rounding has misled"));
  }
}

TEST_CASE("the map's branch is that of the place, whatever the method", "[words]") {
  const CaseMap& map = *lesson(id).map;
  std::set<std::string> seen;
  over_settings("", 300, [&](const Parameters& p, const Walk&) {
    const bool later = meet(p, long_after), met = meet(p, number(p, "duration"));
    const std::string branch = map.branches[static_cast<std::size_t>(map.branch(p))];
    CAPTURE(branch);
    CHECK((branch == "at once") == meet(p, 0));
    CHECK((branch == "later") == (!met && later));
    CHECK((branch == "no contact" || branch == "no relative motion") == !later);
    if (branch == "between tests") CHECK((met && text(p, "method") == "discrete"));
    seen.insert(branch);
  });
  CHECK(seen.size() == map.branches.size());
}

TEST_CASE("the numbers of the exercises are right", "[words]") {
  const std::vector<Exercise>& all = lesson(id).closing->exercises;
  CHECK_THAT(all[1].solution, Contains("from 0.275 to 0.375"));
  Parameters p = preset(lesson(id), all[1].preset).parameters;
  for (const auto& [name, told] : all[1].by) set(lesson(id), p, name, told);
  const Times times = boxes(p, 0, number(p, "duration"));
  CHECK(static_cast<double>(times.in) == Approx(0.275));
  CHECK(static_cast<double>(times.out) == Approx(0.375));

  p = preset(lesson(id), "balls-meet").parameters;
  p["a"] = Vec3(0, 0, 0), p["b"] = Vec3(10, 0, 0), p["v_a"] = Vec3(2, 0, 0), p["v_b"] = Vec3(-3, 0, 0);
  p["r_a"] = p["r_b"] = 1.0;
  CHECK(Balls(p).first() == Approx(1.6));
  CHECK_THAT(all[2].solution, Contains("= 1.6"));
}

}  // namespace moving_words_test
