// The operations of a sign in doubles: each value, error and bound against rational arithmetic, and the last one
// against the first stage, bit for bit.

#include <isect/numbers/operations.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include <isect/orient.h>
#include "bench/orient2d/families.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace operations_test {
using namespace isect;
using namespace isect::bench;
using oracle::Rational;
using Kind = Operation::Kind;
using Point2 = Point<double, 2>;

namespace {

struct Listener : HearsOperations, HearsStages {
  std::vector<Operation> operations;
  std::vector<Stage> stages;
  void operator()(const Operation& operation) { operations.push_back(operation); }
  void operator()(const Stage& stage) { stages.push_back(stage); }
  void operator()(const Fallback&) {}
};

Listener told(const Point2& a, const Point2& b, const Point2& c) {
  Listener heard;
  orient2d(a, b, c, heard);
  return heard;
}

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x == 0 ? 0 : x); }
bool near(double x, const Rational& truth) {
  return abs(Rational(x) - truth) <= abs(truth) * Rational(0x1p-52) + Rational(0x1p-1074);
}

/// The truth of each operation, found from its operands', and what it would be if only that operation rounded.
struct Truth {
  Rational all, once;
};
Truth truth_of(const Operation& o, const std::vector<Operation>& all, const std::vector<Truth>& before) {
  if (o.kind == Kind::difference) return {Rational(o.x) - Rational(o.y), Rational(o.x) - Rational(o.y)};
  const Rational a = before[o.a].all, b = before[o.b].all, x(all[o.a].value), y(all[o.b].value);
  if (o.kind == Kind::times) return {a * b, x * y};
  REQUIRE(o.kind == Kind::minus);
  return {a - b, x - y};
}

}  // namespace

TEST_CASE("the last operation has the value and the bound of the stage in doubles, bit for bit", "[operations]") {
  for (const NamedDraw<OrientCase<double>>& family : orient2d_draws<double>) {
    Random random(stream(tests::seed(), family.name));
    for (int i = tests::cases(500, 20'000); i > 0; --i) {
      INFO(family.name << ", ISECT_SEED=" << tests::seed());
      const OrientCase<double> t = family.draw(random);
      const Listener heard = told(t.a, t.b, t.c);
      REQUIRE(heard.operations.size() == 7);
      const Operation& last = heard.operations.back();
      const Stage& first = heard.stages.front();
      REQUIRE((bits(last.value) == bits(first.value) || (std::isnan(last.value) && std::isnan(first.value))));
      REQUIRE(bits(last.bound) == bits(first.bound));
      REQUIRE(last.roundings == 4);
    }
  }
}

TEST_CASE("every operation errs by what it says, within its bound", "[operations]") {
  for (const NamedDraw<OrientCase<double>>& family : orient2d_draws<double>) {
    Random random(stream(tests::seed(), family.name));
    for (int i = tests::cases(300, 10'000); i > 0; --i) {
      INFO(family.name << ", ISECT_SEED=" << tests::seed());
      const OrientCase<double> t = family.draw(random);
      const std::vector<Operation> all = told(t.a, t.b, t.c).operations;
      std::vector<Truth> truths;
      for (const Operation& o : all) {
        if (!std::isfinite(o.value)) {
          REQUIRE((std::isnan(o.delta) && std::isnan(o.error) && std::isnan(o.share)));
          break;
        }
        truths.push_back(truth_of(o, all, truths));
        const auto& [truth, once] = truths.back();
        const Rational value(o.value), error = value - truth;
        REQUIRE(near(o.error, error));
        if (once != 0) REQUIRE(near(o.delta, (value - once) / once));
        if (once == 0) REQUIRE(o.delta == 0);
        if (!std::isfinite(o.bound)) continue;
        REQUIRE(abs(error) <= Rational(o.bound) + Rational(5e-324));
        REQUIRE((0 <= o.share && o.share <= 1));
        if (o.bound > 0) REQUIRE(near(o.share, abs(error) / Rational(o.bound)));
      }
    }
  }
}

TEST_CASE("operations come in the order of the text, operands first, the left one before the right", "[operations]") {
  const std::vector<Operation> all = told({1, 2}, {4, 8}, {16, 32}).operations;
  REQUIRE(all.size() == 7);
  const auto is_difference = [&](std::size_t i, double x, double y) {
    return all[i].kind == Kind::difference && all[i].x == x && all[i].y == y && all[i].value == x - y;
  };
  CHECK(is_difference(0, 1, 16));
  CHECK(is_difference(1, 8, 32));
  CHECK((all[2].kind == Kind::times && all[2].a == 0 && all[2].b == 1 && all[2].value == 360));
  CHECK(is_difference(3, 2, 32));
  CHECK(is_difference(4, 4, 16));
  CHECK((all[5].kind == Kind::times && all[5].a == 3 && all[5].b == 4 && all[5].value == 360));
  CHECK((all[6].kind == Kind::minus && all[6].a == 2 && all[6].b == 5 && all[6].value == 0));
  CHECK((all[0].roundings == 1 && all[2].roundings == 3 && all[6].roundings == 4));
  CHECK(all[6].bound == 5 * 0x1p-53 * 720);
}

TEST_CASE("the model of one rounding fails where a product underflows, and the bound holds all the same",
          "[operations]") {
  const double tiny = 0x1p-530;
  const auto at = [&](double x, double y) { return Point2(x * tiny, y * tiny); };
  const std::vector<Operation> all = told(at(0.91, 0.66), at(2.2, 1.5), at(-2.1, -1.3)).operations;
  CHECK(std::abs(all[2].delta) > 0x1p-53);
  CHECK(all[2].size == 0x1p-960);
  CHECK(all[2].share <= 1);
}

TEST_CASE("who hears no operations is told none", "[operations]") {
  static_assert(hears_operations<Listener> && hears_operations<Listener&> && !hears_operations<NoTrace>);
  static_assert(!hears_operations<HearsStages>);
}

}  // namespace operations_test
