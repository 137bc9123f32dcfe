// A contest judges rightly: methods made wrong on purpose, values of known error, and the same cases for the same seed.

#include "bench/contest.h"

#include "bench/machine.h"
#include "tests/catch.h"

namespace contest_test {
using namespace isect;
using namespace isect::bench;

namespace {

/// The question: is x at least a half, and if so what is 2 x?
struct Case {
  double x;
};
Truth truth(const Case& c) {
  if (c.x < 0.5) return {};
  return {1, oracle::Real{2 * c.x, 0}, 4};
}
CaseFamily<Case> family(const char* name = "uniform") {
  return {"halves", "double",
          name,     "numbers from 0 to 1.",
          true,     [](Random& random) { return Case{random.unit()}; },
          truth,    [](const Case& c) { return text("x", c.x); }};
}
std::optional<double> right(const Case& c) { return c.x < 0.5 ? std::nullopt : std::optional(2 * c.x); }

constexpr Effort few = {2000, 500, 2, 3, 1e-6, false};

Row only_row(const std::function<void(Contest<double, Case>&)>& enter, CaseFamily<Case> drawn = family()) {
  Session session(few, 1);
  Contest<double, Case> contest(session, std::move(drawn));
  enter(contest);
  contest.run();
  REQUIRE(session.found.rows.size() == 1);
  REQUIRE(session.found.note("halves", session.found.rows[0].family) == "numbers from 0 to 1.");
  REQUIRE(session.found.notes.size() == 1);
  return session.found.rows[0];
}

}  // namespace

TEST_CASE("a right method is never counted as wrong, and its values have no error", "[contest]") {
  const Row r = only_row([](auto& contest) { contest.enter("right", right).exact().standard(); });
  CHECK((r.test == "halves" && r.method == "right" && r.library == "isect" && r.scalar == "double"));
  CHECK((r.hard && r.exact && r.standard));
  CHECK((r.cases == 2000 && r.judged == 500 && r.wrong() == 0 && r.first_wrong.empty()));
  REQUIRE((r.ulps && r.conditioned));
  CHECK((r.ulps->most == 0 && r.conditioned->most == 0));
  CHECK(r.quantiles == std::vector<double>(41, 0.0));
  CHECK_FALSE(r.residual);
  CHECK_FALSE(r.fallback);
  CHECK((r.ns > 0 && r.median >= r.ns && r.spread >= 0));
  CHECK((r.lo >= r.ns && r.lo <= r.median && r.median <= r.hi));
  CHECK_FALSE(r.sides);
}

TEST_CASE("a method that always says yes is wrong wherever the truth is no, and the other way round", "[contest]") {
  std::vector<Case> cases;
  const Row yes = only_row([&](auto& contest) {
    contest.enter("yes", [](const Case&) { return true; });
    cases = contest.cases();
  });
  const Row no = only_row([](auto& contest) { contest.enter("no", [](const Case&) { return false; }); });
  const auto below = [](const Case& c) { return c.x < 0.5; };
  const auto small = std::count_if(cases.begin(), cases.begin() + 500, below);
  CHECK((yes.false_yes == small && yes.false_no == 0));
  CHECK((no.false_no == 500 - small && no.false_yes == 0));
  CHECK(yes.first_wrong == text("x", std::find_if(cases.begin(), cases.end(), below)->x));
  CHECK(no.first_wrong == text("x", std::find_if_not(cases.begin(), cases.end(), below)->x));
  CHECK_FALSE(yes.ulps);  // it gave no value
}

TEST_CASE("for verdicts alone nothing is timed, and only what promises to be exact is judged", "[contest]") {
  Effort effort = Effort::verdicts();
  effort.cases = 2000, effort.judged = 500;
  Session session(effort, 1);
  Contest<double, Case> contest(session, family());
  std::vector<bool> batch;
  contest.enter("no", [](const Case&) { return false; });
  contest.enter("exact", [](const Case&) { return false; }).exact();
  contest
      .enter_pass(
          "batch",
          [&] {
            for (const Case& c : contest.cases()) batch.push_back(c.x >= 0.5);
          },
          [&](std::size_t i) { return said(static_cast<bool>(batch[i])); })
      .exact();
  contest.run();
  REQUIRE(session.found.rows.size() == 2);
  const Row &wrong = session.found.rows[0], &right = session.found.rows[1];
  CHECK((wrong.method == "exact" && wrong.judged == 500 && wrong.wrong() > 100 && wrong.median == 0));
  CHECK((right.method == "batch" && right.judged == 500 && right.wrong() == 0 && !right.latency));
  CHECK(batch.size() == 2000);  // one pass
}

TEST_CASE("signs count as wrong when they differ, zero as no", "[contest]") {
  CaseFamily<Case> signs = family();
  signs.truth = [](const Case& c) -> Truth { return {c.x < 0.25 ? -1 : c.x < 0.5 ? 0 : 1, {}}; };
  const Row r =
      only_row([](auto& contest) { contest.enter("positive", [](const Case&) { return 1; }); }, std::move(signs));
  CHECK(r.false_yes > 80);  // a zero taken for positive
  CHECK(r.false_no > 80);   // a negative taken for positive
  CHECK(r.wrong() < 400);
}

TEST_CASE("where a test has sides, calling a point on and telling the wrong side are counted apart", "[contest]") {
  CaseFamily<Case> signs = family();
  signs.truth = [](const Case& c) -> Truth { return truth_of_sign(c.x < 0.25 ? -1 : c.x < 0.5 ? 0 : 1); };
  const auto judged = [&](int sign) {
    const Row r =
        only_row([&](auto& contest) { contest.enter("always", [sign](const Case&) { return sign; }); }, signs);
    REQUIRE(r.sides);
    CHECK(r.sides->called_on + r.sides->wrong_side == r.wrong());
    return r;
  };
  const Row zero = judged(0), plus = judged(1);
  CHECK((zero.sides->called_on > 300 && zero.sides->wrong_side == 0));
  CHECK((plus.sides->called_on == 0 && plus.sides->wrong_side > 200 && plus.false_yes > 80));

  CaseFamily<Case> places = family();
  places.truth = [](const Case& c) { return truth_of(c.x < 0.5 ? Location::in : Location::out); };
  const auto located = [&](const auto& answer) {
    return only_row([&](auto& contest) { contest.enter("one", answer); }, places);
  };
  const Row on = located([](const Case&) { return Location::on; }), yes = located([](const Case&) { return true; });
  CHECK((on.wrong() == 500 && on.sides->called_on == 500));  // "on" is not "in", though both say yes
  CHECK((yes.wrong() < 300 && yes.sides->called_on == 0 && yes.sides->wrong_side == yes.wrong()));
  CHECK(located([](const Case& c) { return c.x < 0.5 ? Location::in : Location::out; }).wrong() == 0);
}

TEST_CASE("on ordinary cases each call is timed after the answer before, too", "[contest]") {
  CHECK_FALSE(only_row([](auto& contest) { contest.enter("right", right); }).latency);  // hard
  CaseFamily<Case> ordinary = family();
  ordinary.hard = false;
  const Row r = only_row([](auto& contest) { contest.enter("right", right); }, ordinary);
  REQUIRE(r.latency);
  CHECK(*r.latency > 0);
  const Row batch = only_row(
      [](Contest<double, Case>& contest) {
        contest.enter_pass(
            "batch", [] {}, [&](std::size_t i) { return said(right(contest.cases()[i])); });
      },
      ordinary);
  CHECK_FALSE(batch.latency);

  std::vector<int> asked;
  ask_in_turn(std::vector{3, 1, 2}, [&](int x) { return asked.push_back(x), x; });
  CHECK(asked == std::vector{3, 1, 2});
  CHECK((bits_of(std::optional(1.5)) != 0 && bits_of(std::optional<float>()) == 0 && bits_of(Said{1}) == 1));
}

TEST_CASE("errors are in ulps of the truth, and divided by the condition", "[contest]") {
  const Row r = only_row([](auto& contest) {
    contest.enter("three ulps off", [](const Case& c) -> std::optional<double> {
      if (c.x < 0.5) return {};
      return 2 * c.x + 3 * std::ldexp(1.0, -52);  // the truth lies in [1, 2)
    });
  });
  CHECK(r.wrong() == 0);
  REQUIRE((r.ulps && r.conditioned));
  CHECK((r.ulps->median == 3 && r.ulps->p99 == 3 && r.ulps->most == 3));
  // 3 eps over the truth of 1 to 2, over u = eps / 2, over the condition 4
  CHECK((r.conditioned->most <= 1.5 && r.conditioned->most > 1.45));
  CHECK((r.conditioned->median > 0.75 && r.conditioned->median < 1.5));
}

TEST_CASE("values are judged only where method and truth both have one", "[contest]") {
  const Row r = only_row(
      [](auto& contest) { contest.enter("value everywhere", [](const Case& c) { return std::optional(2 * c.x); }); });
  CHECK(r.false_yes > 200);
  REQUIRE(r.ulps);
  CHECK(r.ulps->most == 0);
}

TEST_CASE("a value that is not a number has an infinite error, not a small one", "[contest]") {
  const Row r = only_row([](auto& contest) {
    contest.enter("nan", [](const Case& c) -> std::optional<double> {
      if (c.x < 0.5) return {};
      return std::numeric_limits<double>::quiet_NaN();
    });
  });
  REQUIRE(r.ulps);
  CHECK(r.ulps->median == std::numeric_limits<double>::infinity());
}

TEST_CASE("the residual is the family's, in units of roundoff", "[contest]") {
  CaseFamily<Case> drawn = family();
  drawn.residual = [](const Case&, double) { return std::ldexp(5, -53); };
  const Row r = only_row([](auto& contest) { contest.enter("right", right); }, std::move(drawn));
  REQUIRE(r.residual);
  CHECK((r.residual->median == 5 && r.residual->most == 5));
}

TEST_CASE("the share of fallbacks is over all cases", "[contest]") {
  std::vector<Case> cases;
  const auto falls = [](const Case& c) { return c.x > 0.75; };
  const Row r = only_row([&](auto& contest) {
    contest.enter("right", right).fallback(falls);
    cases = contest.cases();
  });
  const double share = static_cast<double>(std::count_if(cases.begin(), cases.end(), falls)) / 2000;
  REQUIRE(r.fallback);
  CHECK(*r.fallback == share);
  CHECK(fell_back([](const auto& trace) { trace(1), trace(Fallback{}), trace(2); }));
  CHECK_FALSE(fell_back([](const auto& trace) { trace(1); }));
}

TEST_CASE("a method that takes all cases at once is judged by what it says of each", "[contest]") {
  int passes = 0;
  const Row r = only_row([&](Contest<double, Case>& contest) {
    contest.enter_pass(
        "batch", [&] { ++passes; }, [&](std::size_t i) { return said(right(contest.cases()[i])); }, "a peer");
  });
  CHECK((r.library == "a peer" && r.wrong() == 0 && passes >= 3));
}

TEST_CASE("the same seed draws the same cases, another seed or family others", "[contest]") {
  const auto first = [](unsigned long long seed, const char* name) {
    Session session(few, seed);
    const Contest<double, Case> contest(session, family(name));
    return contest.cases().front().x;
  };
  CHECK(first(1, "uniform") == first(1, "uniform"));
  CHECK(first(1, "uniform") != first(2, "uniform"));
  CHECK(first(1, "uniform") != first(1, "other"));
}

TEST_CASE("quantiles are by the nearest rank", "[contest]") {
  std::vector<double> values;
  for (int i = 100; i >= 1; --i) values.push_back(i);
  const Distribution d(values);
  CHECK((d.quantile(0) == 1 && d.quantile(0.5) == 50 && d.quantile(0.99) == 99 && d.quantile(1) == 100));
  CHECK((d.curve().size() == 41 && d.curve()[0] == 1 && d.curve()[1] == 3 && d.curve()[40] == 100));
  CHECK(Distribution({7}).quantile(0.01) == 7);
  CHECK(Distribution({}).quantile(0.5) == 0);
  CHECK(Distribution({1, std::numeric_limits<double>::infinity()}).errors().median == 1);
}

TEST_CASE("the interval of a median holds it, narrows with more values, and is the same each time", "[contest]") {
  Random random(5);
  std::vector<double> few_values, many_values;
  for (int i = 0; i < 1000; ++i) (i < 9 ? few_values : many_values).push_back(random.uniform(1, 3));
  const Range few_range = median_interval(few_values), many_range = median_interval(many_values);
  const double median = Distribution(many_values).quantile(0.5);
  CHECK((many_range.lo < median && median < many_range.hi));
  CHECK(many_range.hi - many_range.lo < (few_range.hi - few_range.lo) / 3);
  CHECK((median_interval(few_values).lo == few_range.lo && median_interval(few_values).hi == few_range.hi));
  CHECK((median_interval({7}).lo == 7 && median_interval({7}).hi == 7 && median_interval({}).hi == 0));
  // The median of values from 1 to 3 is 2: it lies within the interval for about 19 of 20 samples.
  int within = 0;
  for (int sample = 0; sample < 200; ++sample) {
    std::vector<double> values;
    for (int i = 0; i < 31; ++i) values.push_back(random.uniform(1, 3));
    const Range range = median_interval(values);
    within += range.lo <= 2 && 2 <= range.hi;
  }
  CHECK((within > 180 && within < 200));
}

TEST_CASE("a processor is told by name, family and model", "[contest]") {
  CHECK(cpu_of("processor\t: 0\ncpu family\t: 25\nmodel\t\t: 17\nmodel name\t: A CPU\n\nmodel\t: 3\n") ==
        "A CPU, family 25, model 17");
  CHECK(cpu_of("model name : A CPU\n") == "A CPU");
  CHECK(cpu_of("") == "unknown");
}

TEST_CASE("a case is told in full precision", "[contest]") {
  CHECK(text("p", Point<double, 2>(0.1, 2), "r", 1.0 / 3) == "p (0.10000000000000001, 2) r 0.33333333333333331");
}

}  // namespace contest_test
