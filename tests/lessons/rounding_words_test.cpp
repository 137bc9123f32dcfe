// What the lesson on bounding a rounding error says: against rationals, and against the table of the numbers.

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include <isect/orient.h>
#include "bench/random.h"
#include "bench/rational.h"
#include "lessons/rounding_bound/setup.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"

namespace rounding_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using isect::test::Contains;
using oracle::Rational;
using Point2 = Point<double, 2>;

namespace {

constexpr double u = 0x1p-53;
const std::string id = "rounding-bound";

double number(const Parameters& p, const char* name) { return std::get<double>(p.at(name)); }

double moved(double x, int steps) {
  for (int k = 0; k < std::abs(steps); ++k) x = std::nextafter(x, steps < 0 ? -INFINITY : INFINITY);
  return x;
}
/// A point of the setting, as it is tested: `right` and `up` move it by so many doubles.
Point2 tested(const Parameters& p, const char* name, int right = 0, int up = 0) {
  const double unit = text(p, "unit") == "huge" ? 0x1p515 : text(p, "unit") == "tiny" ? 0x1p-530 : 1;
  const Vec3& at = std::get<Vec3>(p.at(name));
  return {moved(unit * at.x(), right), moved(unit * at.y(), up)};
}

int sign(double x) { return (x > 0) - (x < 0); }

/// One determinant, in doubles as the book has it, and in rationals.
struct Found {
  std::array<std::array<double, 2>, 4> coordinates;  ///< whose differences are taken
  double left, right, det, bound;
  Rational truth;

  Found(const Point2& a, const Point2& b, const Point2& c)
      : coordinates{{{a[0], c[0]}, {b[1], c[1]}, {a[1], c[1]}, {b[0], c[0]}}} {
    const double ax = a[0] - c[0], by = b[1] - c[1], ay = a[1] - c[1], bx = b[0] - c[0];
    left = ax * by, right = ay * bx, det = left - right;
    bound = 5 * u * (std::max(std::abs(left), 0x1p-960) + std::max(std::abs(right), 0x1p-960));
    truth = (Rational(a[0]) - Rational(c[0])) * (Rational(b[1]) - Rational(c[1])) -
            (Rational(a[1]) - Rational(c[1])) * (Rational(b[0]) - Rational(c[0]));
  }
  bool passes(double factor) const { return std::abs(det) - factor * bound >= 0; }
  int turn() const { return oracle::sign(truth); }
  bool finite() const { return std::isfinite(det) && std::isfinite(bound); }
};

Found ringed(const Parameters& p) {
  const auto steps = [&](const char* name) { return static_cast<int>(std::round(number(p, name))); };
  return {tested(p, "a", steps("right"), steps("up")), tested(p, "b"), tested(p, "c")};
}

std::string side(int turn) { return turn > 0 ? "left of the line" : turn < 0 ? "right of the line" : "on the line"; }

/// Whether a product of two doubles errs by more than one rounding may.
bool loses_digits(double x, double y) {
  const Rational exact = Rational(x) * Rational(y);
  return exact != 0 && abs(Rational(x * y) - exact) > abs(exact) * Rational(u);
}

}  // namespace

TEST_CASE("the filter lets through as many signs as rationals count, wrong ones among them", "[words]") {
  int weak = 0, harmless = 0;
  const auto check = [&](const Parameters& p, const Walk& walk) {
    const double factor = number(p, "factor");
    const Point2 b = tested(p, "b"), c = tested(p, "c"), middle = tested(p, "a");
    int passing = 0, wrong = 0, beside = 0, cells = 0;
    for (int i = -32; i <= 32; ++i)
      for (int j = -32; j <= 32; ++j) {
        const Found f({moved(middle[0], i), moved(middle[1], j)}, b, c);
        ++cells;
        if (!f.passes(factor)) continue;
        ++passing;
        wrong += sign(f.det) != f.turn();
        beside += f.det == 0 && f.turn() != 0;
      }
    const Step& last = ending(walk);
    CHECK(last.slug == "filter");
    CHECK(value(last, "cells") == cells);
    CHECK(value(last, "signs that get through") == passing);
    CHECK(value(last, "wrong ones among these") == wrong);
    CHECK((last.verdict.kind == Verdict::Kind::no) == (wrong > 0));
    CHECK(last.question.has_value() == (passing > 0));
    if (passing > 0) CHECK(last.question->answer == (wrong == 0 ? 0 : 10 * wrong < cells ? 1 : 2));
    CHECK(says(last.caption, "All of them are right.") == (passing > 0 && wrong == 0));
    CHECK(says(last.caption, "this is the naive test") == (factor == 0 && passing == cells));
    if (wrong > 0) CHECK_THAT(last.caption, Contains("of points beside it in " + std::to_string(beside) + "."));
    if (factor > 0.6 + 1e-9) CHECK(wrong == 0);  // Shewchuk's constant
    CHECK(says(last.caption, "Shewchuk") ==
          (factor > 0.6 + 1e-9 && factor < 1 && passing > 0 && text(p, "unit") == "one"));
    CHECK(says(last.caption, "That is proved") == (factor == 1 && passing > 0));
    (wrong > 0 ? weak : harmless) += 1;
  };
  on_random_settings(id, 40, check);
  for (const Preset& preset : lesson(id).presets) {
    INFO(preset.id);
    check(preset.parameters, walk_of(id, preset.id));
  }
  CHECK((weak > 0 && harmless > 5));
}

TEST_CASE("each line of the derivation tells the run's own rounding", "[words]") {
  int certain = 0, open = 0, lost = 0, infinite = 0;
  on_random_settings(id, 300, [&](const Parameters& p, const Walk& walk) {
    const Found f = ringed(p);
    int exact = 0;
    for (const auto& [x, y] : f.coordinates) {
      const bool rounded = Rational(x - y) != Rational(x) - Rational(y);
      exact += !rounded;
      if (x * y > 0 && std::abs(x) <= 2 * std::abs(y) && std::abs(y) <= 2 * std::abs(x)) CHECK_FALSE(rounded);
    }
    const Step& differences = *find(walk, "differences");
    CHECK(value(differences, "differences without rounding") == exact);
    CHECK(answer(differences) == std::to_string(exact));
    const auto& [a, c] = f.coordinates[0];
    CHECK(says(find(walk, "model")->caption, "is a double itself") == (Rational(a - c) == Rational(a) - Rational(c)));

    const std::string products = find(walk, "products")->caption;
    const auto difference = [&](std::size_t i) { return f.coordinates[i][0] - f.coordinates[i][1]; };
    const bool loses =
        f.finite() && (loses_digits(difference(0), difference(1)) || loses_digits(difference(2), difference(3)));
    CHECK(says(products, "it overflows") == !f.finite());
    CHECK(says(products, "The model fails") == loses);
    const bool tiny = f.finite() && !loses && f.bound < 5 * u * 0x1p-900;
    CHECK(says(products, "though here none is lost") == tiny);
    CHECK(says(products, "three factors") == (f.finite() && !loses && !tiny));
    lost += loses, infinite += !f.finite();

    const Step &bound = *find(walk, "bound"), &decision = *find(walk, "decision");
    CHECK(value(bound, "*bound*") == f.bound);
    if (f.finite()) {
      const Rational error = abs(Rational(f.det) - f.truth);
      CHECK(error <= Rational(f.bound));
      CHECK((says(bound.caption, "the errors cancel") || says(bound.caption, "nothing is rounded")) == (error == 0));
      const double off = static_cast<double>(error);
      const bool told = std::ranges::find(bound.values, "error", &Value::name) != bound.values.end();
      CHECK((told || off <= 0x1p-1074));  // one smaller than the least double is told as a share alone
      if (told) CHECK(std::abs(std::abs(value(bound, "error")) - off) <= 1e-12 * off + 1e-322);
      CHECK(says(find(walk, "determinant")->caption, "came out equal") == (f.det == 0));
    }
    const double factor = number(p, "factor");
    const bool through = f.passes(factor), right = sign(f.det) == f.turn();
    if (decision.comparison) CHECK(decision.comparison->holds == through);
    CHECK(decision.comparison.has_value() == (std::isfinite(f.det) && std::isfinite(factor * f.bound)));
    CHECK((find(walk, "taken") != nullptr) == through);
    if (const Step* taken = find(walk, "taken")) {
      CHECK(says(taken->title, "is right") == right);
      CHECK((taken->verdict.kind == Verdict::Kind::no) == !right);
      CHECK(says(taken->caption, "The sign is certain") == f.passes(1));
      CHECK_THAT(taken->verdict.text, Contains(side(f.turn())));
    }
    (f.passes(1) ? certain : open) += 1;
  });
  CHECK((certain > 20 && open > 20 && lost > 5 && infinite > 5));
}

TEST_CASE("stages run up to the first that is certain, each with the bound that is said of it", "[words]") {
  std::size_t told = 0;
  const auto check = [&](const Parameters& p, const Walk& walk) {
    const Found f = ringed(p);
    std::vector<const Step*> stages;
    for (const Step& step : walk.steps)
      if (step.line == 7) stages.push_back(&step);
    CHECK(stages.empty() == f.passes(number(p, "factor")));
    for (std::size_t i = 0; i < stages.size(); ++i) {
      const bool last = i + 1 == stages.size();
      INFO(stages[i]->slug);
      CHECK(stages[i]->decides == last);
      CHECK((stages[i]->verdict.kind != Verdict::Kind::open) == last);
      ++told;
    }
    if (!stages.empty()) CHECK_THAT(stages.back()->verdict.text, Contains("**a** lies " + side(f.turn())));
  };
  for (const Preset& p : lesson(id).presets) {
    INFO(p.id);
    check(p.parameters, lesson(id).walk(p.parameters));
  }
  on_random_settings(id, 200, check);
  CHECK(told > 50);

  const lessons::rounding_bound_lesson::Run run{
      lessons::rounding_bound_lesson::Setup(preset(lesson(id), "on-line").parameters)};
  int fine = 0;
  for (const Stage& stage : run.stages) {
    if (stage.kind == Stage::Kind::compensated) {
      CHECK(stage.bound == 50 * u * u * run.size());
      ++fine;
    }
    if (stage.kind == Stage::Kind::triple_double) {
      CHECK(stage.bound == 1000 * u * u * u * run.size());
      ++fine;
    }
  }
  CHECK(fine == 2);
}

TEST_CASE("each preset ends in the stage that it is for", "[words]") {
  const auto decided = [](const char* preset_id) {
    const Walk walk = walk_of(id, preset_id);
    const auto last =
        std::find_if(walk.steps.rbegin(), walk.steps.rend(), [](const Step& s) { return s.line == 5 || s.line == 7; });
    return last->slug;
  };
  CHECK(decided("near") == "two-doubles");
  CHECK(decided("ordinary") == "taken");
  CHECK(decided("certain") == "taken");
  CHECK(decided("on-line") == "three-doubles");
  CHECK(decided("short-numbers") == "zero-check");
  CHECK(decided("weak") == "taken");
  CHECK(decided("half") == "two-doubles");
  CHECK(decided("naive") == "taken");
  CHECK(decided("small-beside-large") == "bits-255");
  CHECK(decided("many-bits") == "all-bits");
  CHECK(decided("underflow") == "bits-127");
  CHECK(decided("overflow") == "bits-127");
  for (const char* wrong : {"weak", "naive"})
    CHECK(find(walk_of(id, wrong), "taken")->verdict.kind == Verdict::Kind::no);
  CHECK(value(*find(walk_of(id, "rounded-differences"), "differences"), "differences without rounding") == 2);
  CHECK(value(*find(walk_of(id, "exact-differences"), "differences"), "differences without rounding") == 4);
}

TEST_CASE("in the exercise 0.43 lets one wrong sign through, and 0.44 none", "[words]") {
  const auto wrong = [](const char* factor) {
    return value(ending(with(id, "weak", {{"factor", factor}})), "wrong ones among these");
  };
  CHECK(wrong("0.43") == 1);
  CHECK(wrong("0.44") == 0);
  CHECK(says(ending(with(id, "weak", {{"factor", "0.43"}})).formula, "a wrong sign gets through"));
}

TEST_CASE("what the exercises say of other polynomials and of short numbers holds", "[words]") {
  struct Heard : HearsOperations {
    std::vector<Operation> all;
    void operator()(const Operation& o) { all.push_back(o); }
    void operator()(const Fallback&) {}
  } heard;
  orient3d({1, 2, 3}, {4, 6, 5}, {7, 9, 8}, {0.5, 0.25, 1}, heard);
  const Operation& last = heard.all.back();
  CHECK(last.roundings == 8);
  CHECK(last.bound == 9 * u * last.size);

  bench::Random random(bench::stream(seed(), "short numbers"));
  for (int i = 0; i < 2000; ++i) {
    const auto whole = [&] { return Point2(random.integer(-(1 << 25), 1 << 25), random.integer(-(1 << 25), 1 << 25)); };
    const Found f(whole(), whole(), whole());
    REQUIRE(Rational(f.det) == f.truth);
    const auto single = [&] {
      return Point2(static_cast<float>(random.uniform(1, 2)), static_cast<float>(random.uniform(1, 2)));
    };
    const Point2 a = single(), b = single();
    const Point2 near(static_cast<float>((a[0] + b[0]) / 2), static_cast<float>((a[1] + b[1]) / 2));
    const Found g(a, b, near);
    REQUIRE(sign(g.det) == g.turn());
    REQUIRE((Rational(g.left) - Rational(g.right)) == g.truth);
  }
}

TEST_CASE("bits and costs of the stages are those of the table of the numbers", "[words]") {
  std::ifstream file(ISECT_NUMBERS);
  const std::string table{std::istreambuf_iterator<char>(file), {}};
  using Kind = Stage::Kind;
  const std::pair<Kind, const char*> names[] = {{Kind::doubles, "Bounded<double>"},
                                                {Kind::grid, "Grid"},
                                                {Kind::compensated, "Compensated"},
                                                {Kind::triple_double, "TripleDouble"},
                                                {Kind::medium_exact, "MediumExact"},
                                                {Kind::short_exact, "ShortExact"},
                                                {Kind::exact, "Exact"}};
  for (const auto& [kind, name] : names) {
    INFO(name);
    const std::regex row("\n\\| `" + std::string(name) + "`[^|]*\\|[^|]*\\| *([0-9]*)[^|]*\\| *([0-9.]+)");
    std::smatch m;
    REQUIRE(std::regex_search(table, m, row));
    const auto& words = lessons::rounding_bound_lesson::words_of(kind);
    CHECK(words.cost == std::stod(m[2]));
    CHECK(words.bits == (m[1].length() > 0 ? std::stoi(m[1]) : 0));
  }
}

}  // namespace rounding_words_test
