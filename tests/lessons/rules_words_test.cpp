// What the lessons on rules of thumb, robustness and measurements say: against counts in rationals, and against the
// measurements themselves.

#include <algorithm>
#include <cmath>

#include <isect/point_polygon.h>
#include "bench/rational.h"
#include "bench/rows.h"
#include "lessons/robustness/settings.h"
#include "lessons/rules_of_thumb/experiment.h"
#include "lessons/speed_against_error/results.h"
#include "tests/lessons/words.h"

namespace rules_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using isect::test::Contains;
using lessons::speed_against_error_lesson::results;

namespace {

/// The sign of the turn a, b, c in rationals.
template <class S>
int turn(const Point<S, 2>& a, const Point<S, 2>& b, const Point<S, 2>& c) {
  const auto ra = oracle::rational(a), rb = oracle::rational(b), rc = oracle::rational(c);
  return oracle::sign((rb[0] - ra[0]) * (rc[1] - ra[1]) - (rb[1] - ra[1]) * (rc[0] - ra[0]));
}

}  // namespace

TEST_CASE("a rule is said to save exactly where its count is less", "[words]") {
  const std::vector<Point<double, 2>> shape = {{-2.75, -1.25}, {-1.25, -1.75}, {-0.75, -0.5}, {0.5, -1.25},
                                               {0.875, 1.25},  {-0.5, 0.5},    {-1.5, 1.75},  {-2.25, 0.5}};
  int saved = 0, lost = 0;
  on_random_settings("rules-of-thumb", 1000, [&](const Parameters& setting, const Walk& walk) {
    const std::string& rule = text(setting, "rule");
    if (rule == "7-measure") return;
    const Step& last = ending(walk);
    const double with = value(last, "with the rule"), without = value(last, "without the rule");
    (with < without ? saved : lost) += 1;
    CHECK((last.verdict.kind == Verdict::Kind::yes) == (with < without));
    CHECK(says(last.verdict.text, "saves nothing") == (with >= without));
    CHECK((last.question->answer == 3) == (with >= without));
    CHECK(says(last.question->because, "nothing to save") == (with >= without));
    const Point<double, 2> p = point(setting);
    if (rule == "1-trivial")
      CHECK(value(last, "rejected by balls") + value(last, "accepted by balls") + value(last, "left to the axes") ==
            14);
    if (rule == "2-reuse") CHECK(says(last.title, "No axis") == (value(last, "axis still separates") == 0));
    if (rule == "5-dimension" && locate(p, shape) != Location::on) {
      const bool odd = winding(p, shape).crossings % 2 != 0;
      const int told = std::stoi(last.caption.substr(std::string("Now ").size()));
      CHECK((told % 2 != 0) == odd);
      CHECK(says(last.caption, "The answer is the same."));
    }
    if (rule == "8-robust") {
      const Point<double, 2> a(-3.1, -1.7);
      int wrong = 0, beside = 0;
      for (int k = 1; k <= 24; ++k) {
        const Point<double, 2> q = a + (k / 25.0) * (p - a);
        const Vector<double, 2> f = a - q, g = p - q;
        const double rounded = f.x() * g.y() - f.y() * g.x();
        const int truth = turn(a, p, q);
        wrong += ((rounded > 0) - (rounded < 0)) != truth, beside += truth != 0;
      }
      CHECK(without == wrong);
      CHECK(says(find(walk, "before")->caption, "Crosses") == (wrong > 0));
      const std::string many = beside == 0 ? "none" : beside == 24 ? "all 24" : std::to_string(beside);
      CHECK_THAT(find(walk, "rule")->caption, Contains("puts " + many + " beside"));
    }
  });
  CHECK((saved > 100 && lost > 20));
}

TEST_CASE("under the microscope a false zero and a wrong side are told apart", "[words]") {
  using namespace lessons::robustness_lesson;
  int with_sides = 0, zeros_only = 0;
  on_random_settings("robustness", 60, [&](const Parameters& setting, const Walk& walk) {
    const auto s = lessons::robustness_lesson::setting(text(setting, "test"), text(setting, "scalar"),
                                                       std::get<Vec3>(setting.at("p")));
    int zeros = 0, sides = 0;
    for (int i = -half; i <= half; ++i)
      for (int j = -half; j <= half; ++j) {
        const int truth = s.truth(i, j), answer = s.answer(i, j);
        const bool orientation = text(setting, "test") == "orientation";
        zeros += answer == 0 && truth != 0;
        sides += answer != 0 && answer != truth && (orientation || truth != 0);
        if ((i * 65 + j) % 97 != 0 || !orientation) continue;
        Point<double, 2> a = std::get<Vec3>(setting.at("p")).head<2>();
        const bool single = text(setting, "scalar") == "float";
        for (int k = 0; k < 2; ++k) {  // the neighbour, found by its distance
          const int steps = k == 0 ? i : j;
          for (int n = 0; n < std::abs(steps); ++n)
            a[k] = single ? std::nextafterf(static_cast<float>(a[k]), steps < 0 ? -INFINITY : INFINITY)
                          : std::nextafter(a[k], steps < 0 ? -INFINITY : INFINITY);
          if (single) a[k] = static_cast<float>(a[k]);
        }
        CHECK(truth == turn<double>(a, {1.5, 1.5}, {3, 3}));
      }
    const Step& last = ending(walk);
    CHECK(value(last, "wrong") == zeros + sides);
    CHECK(says(last.caption, "none names the wrong side") == (zeros > 0 && sides == 0));
    CHECK(says(last.caption, "No verdict is wrong") == (zeros + sides == 0));
    CHECK((last.verdict.kind == Verdict::Kind::yes) == (zeros + sides == 0));
    CHECK(last.question.has_value() == (zeros + sides > 0));
    with_sides += sides > 0, zeros_only += zeros > 0 && sides == 0;
  });
  CHECK(with_sides > 0);
  CHECK(zeros_only > 0);
}

TEST_CASE("the default wrong cells are all false zeros", "[words]") {
  const Step last = ending(walk_of("robustness", "orientation"));
  CHECK(value(last, "of these on the wrong side") == 0);
  CHECK(value(last, "of these called on the line") == 2066);
}

TEST_CASE("no difference is claimed that the noise of the measurement covers", "[words]") {
  const double noise = results().machine.noise;
  for (const Preset& p : lesson("speed-against-error").presets) {
    INFO(p.id);
    const Walk walk = lesson("speed-against-error").walk(p.parameters);
    const auto rows = bench::rows_of(results(), p.id, "double", "ordinary");
    const bench::Row &exact = *bench::exact_of(rows), &naive = *bench::standard_of(rows);
    const double least = (*std::ranges::min_element(rows, {}, &bench::Row::ns))->ns;
    const std::string methods = find(walk, "ordinary")->caption;
    const auto as_fast = std::ranges::count_if(rows, [&](const bench::Row* r) { return r->ns <= (1 + noise) * least; });
    CHECK(says(methods, "The fastest is") == (as_fast == 1));
    if (as_fast > 1) CHECK_THAT(methods, Contains(std::to_string(as_fast) + " methods are as fast"));

    bool faster = false;  // a method that is right on ordinary cases, by more than the noise
    for (const bench::Row* r : rows)
      faster = faster || (!r->exact && r->library == "isect" && r->wrong() == 0 && r->ns * (1 + noise) < exact.ns);
    const std::string choose = find(walk, "choose")->caption;
    CHECK_FALSE(says(choose, "no reason"));
    if (exact.ns <= 1.1 * naive.ns) CHECK(says(choose, "Faster there is") == faster);
    CHECK(value(*find(walk, "cost"), "cost, ordinary") == Approx(exact.ns / naive.ns).epsilon(0.05));
  }
  const Walk walk = walk_of("speed-against-error", "sphere-aabb");
  CHECK_THAT(find(walk, "choose")->caption, Contains("clamp"));
  // Among the methods as fast up to noise, the one that is least often wrong is chosen; the others are named.
  const std::string choose = find(walk_of("speed-against-error", "ray-sphere"), "choose")->caption;
  std::vector<const bench::Row*> fast = bench::rows_of(results(), "ray-sphere", "double", "ordinary");
  std::erase_if(fast, [](const bench::Row* r) { return r->exact || r->library != "isect"; });
  const double least = (*std::ranges::min_element(fast, {}, &bench::Row::ns))->ns;
  std::erase_if(fast, [&](const bench::Row* r) { return r->ns > (1 + noise) * least; });
  const auto wrong = [](const bench::Row* one) {
    long sum = 0;
    for (const bench::Row& r : results().rows)
      if (r.hard && r.test == one->test && r.scalar == one->scalar && r.method == one->method) sum += r.wrong();
    return sum;
  };
  const bench::Row* const named = *std::ranges::min_element(fast, {}, wrong);
  CHECK_THAT(choose, Contains("With " + named->method + ", "));
  CHECK(says(choose, "As fast, within the noise: ") == (fast.size() > 1));
  for (const bench::Row* r : fast) CHECK_THAT(choose, Contains(r->method));
}

TEST_CASE("on ordinary cases every method of the results is right", "[words]") {
  for (const bench::Row& r : results().rows)
    if (!r.hard) {
      INFO(r.test << ", " << r.method << ", " << r.scalar);
      CHECK(r.wrong() == 0);
    }
}

}  // namespace rules_words_test
