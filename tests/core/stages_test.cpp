// What a listener hears of a sign's stages: those that ran, what each found, and that the last one decided.

#include <isect/numbers/stages.h>

#include <cmath>
#include <map>
#include <variant>
#include <vector>

#include <isect/orient.h>
#include "bench/orient2d/families.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace stages_test {
using namespace isect;
using namespace isect::bench;
using oracle::Rational;
using Kind = Stage::Kind;
using Point2 = Point<double, 2>;

namespace {

struct Listener : HearsStages {
  std::vector<Stage> stages;
  int fallbacks = 0;
  void operator()(const Stage& stage) { stages.push_back(stage); }
  void operator()(const Fallback&) { ++fallbacks; }
};

Rational area2(const Point2& a, const Point2& b, const Point2& c) {
  const auto p = oracle::rational(a), q = oracle::rational(b), r = oracle::rational(c);
  return (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0]);
}

/// Checks the stages of one sign; returns the deciding one.
Kind check(const Point2& a, const Point2& b, const Point2& c) {
  Listener heard;
  const int turn = orient2d(a, b, c, heard);
  const Rational truth = area2(a, b, c);
  REQUIRE(turn == oracle::sign(truth));
  REQUIRE(turn == orient2d(a, b, c));
  REQUIRE_FALSE(heard.stages.empty());
  REQUIRE(heard.fallbacks == (heard.stages.size() > 1 ? 1 : 0));
  REQUIRE(heard.stages.front().kind == Kind::doubles);
  for (std::size_t i = 0; i < heard.stages.size(); ++i) {
    const Stage& stage = heard.stages[i];
    REQUIRE(stage.sign.has_value() == (i + 1 == heard.stages.size()));
    if (i > 0) REQUIRE(stage.kind != Kind::doubles);
    if (std::isfinite(stage.value) && std::isfinite(stage.bound) && stage.bound > 0)
      REQUIRE(abs(Rational(stage.value) - truth) <= Rational(stage.bound) + abs(truth) * Rational(0x1p-52));
    if (stage.step > 0 && std::isfinite(stage.step)) REQUIRE(denominator(Rational(truth / Rational(stage.step))) == 1);
  }
  REQUIRE(heard.stages.back().sign == turn);
  return heard.stages.back().kind;
}

}  // namespace

TEST_CASE("a listener hears each stage of a sign, and the last one decides", "[stages]") {
  std::map<Kind, int> decided;
  for (const NamedDraw<OrientCase<double>>& family : orient2d_draws<double>) {
    Random random(stream(tests::seed(), family.name));
    for (int i = tests::cases(1000, 50'000); i > 0; --i) {
      INFO(family.name << ", ISECT_SEED=" << tests::seed());
      const OrientCase<double> t = family.draw(random);
      ++decided[check(t.a, t.b, t.c)];
    }
  }
  for (const Kind kind : {Kind::doubles, Kind::compensated, Kind::short_exact}) CHECK(decided[kind] > 50);
}

TEST_CASE("each stage decides the cases that it is for", "[stages]") {
  CHECK(check({0, 0}, {4, 0}, {0, 3}) == Kind::doubles);
  CHECK(check({0.5, 0.25}, {2, 1}, {-2, -1}) == Kind::grid);
  CHECK(check({std::nextafter(0.0625, 1), 0.0625}, {1.5, 1.5}, {3, 3}) == Kind::compensated);
  CHECK(check({1.1, 1.1}, {2.3, 2.3}, {-3.7, -3.7}) == Kind::triple_double);
  CHECK(check({1e-50, std::nextafter(1e-50, 1)}, {1, 1}, {2, 2}) == Kind::medium_exact);
  CHECK(check({0x1.1p-530, 0x1p-530}, {0x1p-529, 0x1p-528}, {0x1p-527, 0}) == Kind::short_exact);
  CHECK(check({1e-60, std::nextafter(1e-60, 1)}, {1, 1}, {2, 2}) == Kind::exact);
}

TEST_CASE("a sign out of range goes on in short numbers, and then exactly", "[stages]") {
  Listener heard;
  const double huge = 0x1p515;
  CHECK(orient2d({0.3 * huge, 1.7 * huge}, {2.2 * huge, 1.5 * huge}, {-2.1 * huge, -1.3 * huge}, heard) == -1);
  REQUIRE(heard.stages.size() == 2);
  CHECK_FALSE(std::isfinite(heard.stages[0].value));
  CHECK(heard.stages[1].kind == Kind::short_exact);
  CHECK(check({1e300, 1e300}, {-1e300, -1e300}, {3, 7}) == Kind::exact);
}

TEST_CASE("who hears no stages is told of Fallback alone", "[stages]") {
  static_assert(hears_stages<Listener> && hears_stages<Listener&> && !hears_stages<NoTrace>);
  static_assert(!hears_stages<Record<orient::Event>> && heard<Listener>);
  Record<std::variant<Fallback>> record;
  CHECK(orient2d({0.5, 0.25}, {2, 1}, {-2, -1}, record) == 0);
  CHECK(record.events.size() == 1);
}

}  // namespace stages_test
