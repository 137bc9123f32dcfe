// The usual ways to write an orientation: right on small integers, and wrong where rounding must defeat them.

#include <isect/methods/orient.h>

#include <optional>
#include <string>

#include <isect/counted.h>
#include "bench/orient2d/families.h"
#include "bench/orient2d/oracle.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace orient_methods_test {
using namespace isect;
using namespace isect::bench;
using orient::Corner;

namespace {

/// Calls check(name, method) for each; a method takes a case.
template <class S, class Check>
void for_each_method(const Check& check) {
  using Case = OrientCase<S>;
  check("pivot a", [](const Case& t) { return orient::pivoted<Corner::a>(t.a, t.b, t.c); });
  check("pivot b", [](const Case& t) { return orient::pivoted<Corner::b>(t.a, t.b, t.c); });
  check("pivot c", [](const Case& t) { return orient::pivoted<Corner::c>(t.a, t.b, t.c); });
  check("expanded", [](const Case& t) { return orient::expanded(t.a, t.b, t.c); });
  check("fused", [](const Case& t) { return orient::fused(t.a, t.b, t.c); });
}

int sign(auto x) { return (x > 0) - (x < 0); }

/// How far `fused` is off for the vectors as they were rounded, in ulps; nothing where a product is too small or large.
template <class S>
std::optional<double> fused_off(const OrientCase<S>& t) {
  using Limits = std::numeric_limits<S>;
  const Vector<S, 2> u = t.a - t.c, v = t.b - t.c;
  for (const S product : {u[0] * v[1], u[1] * v[0]})
    if (!std::isfinite(product) || std::abs(product) < Limits::min() / Limits::epsilon()) return {};
  const auto p = oracle::rational<S, 2>(u), q = oracle::rational<S, 2>(v);
  return oracle::ulps(orient::fused(t.a, t.b, t.c), p[0] * q[1] - p[1] * q[0]);
}

}  // namespace

TEMPLATE_TEST_CASE("every form gives twice the area of small triangles", "[orient_methods]", float, double) {
  using S = TestType;
  for_each_method<S>([](const std::string& name, const auto& method) {
    INFO(name);
    CHECK(method({{0, 0}, {4, 0}, {0, 3}}) == 12);
    CHECK(method({{0, 0}, {0, 3}, {4, 0}}) == -12);
    CHECK(method({{1, 1}, {2, 2}, {5, 5}}) == 0);
    Random random(tests::seed());
    for (int i = 0; i < 2000; ++i) {
      const auto corner = [&] { return vector<S, 2>(random, Numbers::grid); };
      const OrientCase<S> t = {corner(), corner(), corner()};
      REQUIRE(sign(method(t)) == oracle::orientation(t.a, t.b, t.c));
    }
  });
}

TEMPLATE_TEST_CASE("every form is wrong near a line, and where products overflow or vanish",
                   "[orient_methods][failure]", float, double) {
  using S = TestType;
  for_each_method<S>([](const std::string& name, const auto& method) {
    for (const NamedDraw<OrientCase<S>>& family : orient2d_draws<S>) {
      const std::string_view drawn = family.name;
      if (drawn != "near-collinear" && drawn != "decimal" && drawn != "range") continue;
      Random random(stream(tests::seed(), family.name));
      int wrong = 0;
      for (int i = 0; i < 1000; ++i) {
        const OrientCase<S> t = family.draw(random);
        wrong += sign(method(t)) != oracle::orientation(t.a, t.b, t.c);
      }
      INFO(name << ", " << family.name);
      CHECK(wrong > 5);
    }
  });
}

TEMPLATE_TEST_CASE("the fused form is within 1.5 ulp of the area of its rounded vectors", "[orient_methods]", float,
                   double) {
  using S = TestType;
  double worst = 0;
  int asked = 0;
  const auto attack = [&](const OrientCase<S>& t) {
    const std::optional<double> off = fused_off(t);
    if (!off) return;
    ++asked, worst = std::max(worst, *off);
    if (*off > 1.5) REQUIRE(*off <= 1.5);
  };
  Random random(bench::stream(tests::seed(), "fused"));
  INFO("seed " << tests::seed());
  for (const NamedDraw<OrientCase<S>>& family : orient2d_draws<S>)
    for (int i = 0; i < tests::cases(2000, 100'000); ++i) attack(family.draw(random));
  for (const Numbers numbers : all_numbers)
    for (int i = 0; i < tests::cases(1000, 50'000); ++i)
      attack({vector<S, 2>(random, numbers), vector<S, 2>(random, numbers), vector<S, 2>(random, numbers)});

  // vectors that are nearly parallel, whose products nearly cancel: all that is left is what rounding took
  for (int i = 0; i < tests::cases(20'000, 1'000'000); ++i) {
    const S k = static_cast<S>(random.uniform(0.5, 2));
    OrientCase<S> t = {random.in_box<2>(1).template cast<S>(), {}, {0, 0}};
    for (int j = 0; j < 2; ++j) t.b[j] = moved(k * t.a[j], random.integer(-2, 2));
    if (random.one_in(2)) t.b[0] *= static_cast<S>(random.uniform(-1, 1));  // or not so nearly
    attack(t);
  }

  // areas next to a power of two: the sum is rounded in the larger ulps above it, and the truth lies below
  for (int i = 0; i < tests::cases(20'000, 1'000'000); ++i) {
    const auto side = [&] { return static_cast<S>(random.uniform(0.7, 1.4)); };
    OrientCase<S> t = {{side(), side()}, {0, side()}, {0, 0}};
    t.b[0] = moved((t.a[0] * t.b[1] - S(0.5)) / t.a[1], random.integer(-1, 1));
    attack(t);
  }
  CAPTURE(worst);
  CHECK(worst > 0.9);  // so the attack comes near
  CHECK(asked > 30'000);
}

TEST_CASE("long double decides Kettner's grids, and not a small number beside a large one",
          "[orient_methods][failure]") {
  using L = long double;
  for (const NamedDraw<OrientCase<double>>& family : orient2d_draws<double>) {
    const std::string_view drawn = family.name;
    const bool grid = drawn.starts_with("Kettner");
    if (!grid && drawn != "small beside large") continue;
    Random random(stream(tests::seed(), family.name));
    int wrong = 0;
    for (int i = 0; i < 2000; ++i) {
      const OrientCase<double> t = family.draw(random);
      const L area2 = orient::pivoted<Corner::c, L>(t.a.cast<L>(), t.b.cast<L>(), t.c.cast<L>());
      wrong += sign(area2) != oracle::orientation(t.a, t.b, t.c);
    }
    INFO(family.name);
    if (grid && std::numeric_limits<L>::digits >= 64) CHECK(wrong == 0);
    if (!grid && std::numeric_limits<L>::digits <= 64) CHECK(wrong > 50);
  }
}

TEST_CASE("the expanded form turns a point that is there twice", "[orient_methods][failure]") {
  Random random(tests::seed());
  int turns = 0;
  for (int i = 0; i < 1000; ++i) {
    const OrientCase<double> t = orient_families::ordinary<double>(random);
    turns += orient::expanded(t.a, t.a, t.c) != 0;
    REQUIRE(orient::pivoted<Corner::a>(t.a, t.a, t.c) == 0);
    REQUIRE(orient::fused(t.a, t.a, t.c) == 0);
  }
  CHECK(turns > 100);
}

TEST_CASE("the forms cost what their formulas say, and tell each line", "[orient_methods]") {
  using S = Counted<double>;
  const Point<S, 2> a = {S(0), S(0)}, b = {S(4), S(0)}, c = {S(0), S(3)};
  tally() = {};
  CHECK(orient::pivoted<Corner::b>(a, b, c).value == 12);
  CHECK((tally().mul == 2 && tally().add == 5));
  tally() = {};
  CHECK(orient::expanded(a, b, c).value == 12);
  CHECK((tally().mul == 6 && tally().add == 5));

  Record<orient::NaiveEvent<double>> record;
  orient::pivoted<Corner::b>(Point<double, 2>(0, 0), Point<double, 2>(4, 0), Point<double, 2>(0, 3), record);
  REQUIRE(record.events.size() == 3);
  CHECK(std::get<orient::Pivot<double>>(record.events[0]).first == Vector<double, 2>(-4, 3));
  CHECK(std::get<orient::Products<double>>(record.events[1]).second == -12);
  CHECK(std::get<orient::Area2<double>>(record.events[2]).area2 == 12);

  record.events.clear();
  orient::fused(Point<double, 2>(0, 0), Point<double, 2>(4, 0), Point<double, 2>(0, 3), record);
  REQUIRE(record.events.size() == 3);
  CHECK(std::get<orient::Residue<double>>(record.events[1]).rest == 0);
}

TEST_CASE("NaN is no side", "[orient_methods]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for_each_method<double>([&](const std::string& name, const auto& method) {
    INFO(name);
    CHECK(sign(method({{0, nan}, {4, 0}, {0, 3}})) == 0);
  });
}

}  // namespace orient_methods_test
