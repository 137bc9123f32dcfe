// The eight experiments of the rules-of-thumb lesson: that each rule saves what it says, wherever the point is dragged,
// and counts against independent ones.

#include <algorithm>

#include <isect/orient.h>
#include "bench/prose.h"
#include "bench/rational.h"
#include "bench/rows.h"
#include "lessons/lessons.h"
#include "lessons/rules_of_thumb/experiment.h"
#include "lessons/speed_against_error/results.h"
#include "tests/catch.h"
#include "viz/chart/chart.h"
#include "viz/walk/closing.h"

namespace rules_of_thumb_test {
using namespace isect;
using namespace isect::lessons::rules_of_thumb_lesson;
namespace viz = isect::viz;

namespace {

const viz::Lesson& lesson() {
  for (const viz::Lesson* l : lessons::all_lessons())
    if (l->id == "rules-of-thumb") return *l;
  throw std::runtime_error("no such lesson");
}

viz::Walk walk_of(const std::string& id) { return lesson().walk(viz::preset(lesson(), id).parameters); }
Flat p_of(const std::string& id) { return std::get<viz::Vec3>(viz::preset(lesson(), id).parameters.at("p")).head<2>(); }

double value(const viz::Walk& walk, const std::string& name) {
  for (const viz::Value& v : walk.steps.back().values)
    if (v.name == name) return v.value;
  throw std::runtime_error("no value " + name);
}

double detail_of(const Experiment& e, const std::string& name) {
  for (const auto& [n, v] : e.details)
    if (n == name) return v;
  throw std::runtime_error("no detail " + name);
}

}  // namespace

TEST_CASE("there are eight rules, and each saves something in its preset", "[rules-of-thumb lesson]") {
  CHECK(lesson().presets.size() == 8);
  for (const viz::Preset& p : lesson().presets) {
    INFO(p.id);
    const viz::Walk walk = lesson().walk(p.parameters);
    CHECK(viz::outcome(walk) == 3);
    CHECK(walk.steps.back().verdict.kind == viz::Verdict::Kind::yes);
    if (p.id == "7-measure") continue;
    CHECK(value(walk, "with the rule") < value(walk, "without the rule"));
  }
}

TEST_CASE("every box is rejected, accepted or left to the axes", "[rules-of-thumb lesson]") {
  const Experiment e = trivial(p_of("1-trivial"));
  CHECK(detail_of(e, "rejected by balls") + detail_of(e, "accepted by balls") + detail_of(e, "left to the axes") == 14);
  for (const char* name : {"rejected by balls", "accepted by balls", "left to the axes"}) CHECK(detail_of(e, name) > 0);
  const Experiment far = trivial({50, 50});
  CHECK(detail_of(far, "rejected by balls") == 14);
  // 3 differences, 3 products, 2 sums; the sum of the radii and its square; 1 comparison
  CHECK(far.after == 14 * 11);
}

TEST_CASE("a kept axis saves nothing when the boxes overlap", "[rules-of-thumb lesson]") {
  const Experiment e = reuse(p_of("2-reuse"));
  CHECK(detail_of(e, "axis still separates") > 6);
  const Experiment inside = reuse({-2, -0.9});
  CHECK(detail_of(inside, "axis still separates") == 0);
  CHECK(inside.before == 12 * 15);
  CHECK(inside.after == inside.before);
}

TEST_CASE("on y one or two comparisons reject, on x none does", "[rules-of-thumb lesson]") {
  const Experiment above = reorder({-1, 5});  // above all boxes: y ends after a_min > b_max
  CHECK(above.after == 7);
  CHECK(above.before == 7 * 3);
  const Experiment below = reorder({-1, -5});
  CHECK(below.after == 7 * 2);
  CHECK(below.before == 7 * 4);
  const Experiment beside = reorder({50, 0});  // there x is the better axis
  CHECK(beside.before == 7);
  CHECK(beside.after > beside.before);
}

TEST_CASE("Haines' method takes one root for a hit, the formula three costly operations for a line",
          "[rules-of-thumb lesson]") {
  const Experiment e = postpone(p_of("4-postpone"));
  CHECK(e.before == 9);  // the line meets three balls
  CHECK(e.after == 2);   // one is behind
  const Experiment right = postpone({3, -0.5});
  CHECK(right.before == 9);
  CHECK(right.after == 0);
  CHECK(postpone({3, 3}).before == 0);
}

TEST_CASE("without the normal the plane needs far fewer operations than space", "[rules-of-thumb lesson]") {
  for (const Flat& p : {p_of("5-dimension"), Flat(-2, 0.25), Flat(0, -0.5), Flat(3, 3)}) {
    const Experiment e = fewer_axes(p);
    CHECK(detail_of(e, "for the normal, once") > 0);
    CHECK(2 * e.after < e.before);
    CHECK(e.after + detail_of(e, "for the normal, once") > 2 * e.after);  // a single ray pays for the normal, too
  }
}

TEST_CASE("preparing pays from the point that the lesson names", "[rules-of-thumb lesson]") {
  const Experiment e = precalculate(p_of("6-precalculate"));
  CHECK(e.before == 60 * 48);
  const double stored = detail_of(e, "stored once"), each = detail_of(e, "steps per point"),
               pays = detail_of(e, "pays off from this many points");
  CHECK(e.after == Approx(stored + 60 * each));
  CHECK(stored + pays * each <= 48 * pays);
  CHECK(stored + (pays - 1) * each > 48 * (pays - 1));
}

TEST_CASE("the chart of times is that of the measurements", "[rules-of-thumb lesson]") {
  const viz::Walk walk = walk_of("7-measure");
  const auto rows = bench::rows_of(lessons::speed_against_error_lesson::results(), "sphere-aabb", "double", "ordinary");
  for (const char* method : {"if, else (<)", "rejections", "clamp"}) {
    const auto row =
        std::ranges::find_if(rows, [&](const bench::Row* r) { return r->library == "isect" && r->method == method; });
    REQUIRE(row != rows.end());
    CHECK(value(walk, std::string(method) + ", time") == (*row)->ns);
  }
  const double noise = lessons::speed_against_error_lesson::results().machine.noise;
  const auto& question = walk.steps[1].question;
  REQUIRE((question && question->order));
  const auto place = [&](const std::string& method) {
    const auto found = std::ranges::find(question->order->tiles, method);
    REQUIRE(found != question->order->tiles.end());
    return question->order->ranks.at(static_cast<std::size_t>(found - question->order->tiles.begin()));
  };
  CHECK((place("clamp") < place("if, else (<)")) ==
        (value(walk, "clamp, time") * (1 + noise) < value(walk, "if, else (<), time")));
  for (const viz::Step& s : walk.steps) {
    CHECK(bool(s.scene.chart));
    if (s.slug != viz::closing_slug)
      CHECK_THAT(s.source, isect::test::Contains(lessons::speed_against_error_lesson::results().machine.cpu));
  }
}

TEST_CASE("the noise of the measurements is told, however small it is", "[rules-of-thumb lesson]") {
  const viz::Walk walk = walk_of("7-measure");
  const std::string& caption = walk.steps.at(1).caption;
  const std::string noise = bench::share(lessons::speed_against_error_lesson::results().machine.noise, 1);
  CHECK_THAT(caption, isect::test::Contains("up to " + noise + " longer"));
  CHECK_FALSE(noise.starts_with("0 "));
}

TEST_CASE("the rounded sign errs as often as the lesson says", "[rules-of-thumb lesson]") {
  const Flat a(-3.1, -1.7), p = p_of("8-robust");
  int wrong = 0;
  for (int k = 1; k <= 24; ++k) {
    const Flat q = a + (k / 25.0) * (p - a);
    const Vector<double, 2> f = a - q, g = p - q;
    const double rounded = f.x() * g.y() - f.y() * g.x();
    const auto ra = oracle::rational(a), rp = oracle::rational(p), rq = oracle::rational(q);
    const int truth = oracle::sign((rp[0] - ra[0]) * (rq[1] - ra[1]) - (rp[1] - ra[1]) * (rq[0] - ra[0]));
    CHECK(truth == orient2d(a, p, q));
    wrong += ((rounded > 0) - (rounded < 0)) != truth;
  }
  const Experiment e = robust(p);
  CHECK(wrong > 0);
  CHECK(e.before == wrong);
  CHECK(e.after == 0);
}

}  // namespace rules_of_thumb_test
