// Sorting points by columns: what it costs, by counting comparisons.

#include <isect/parts/sort_points.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "bench/random_shapes.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace sort_points_test {
using namespace isect;

namespace {

long comparisons = 0;

/// A coordinate that counts how often it is compared.
struct Coordinate {
  double value = 0;

  Coordinate() = default;
  Coordinate(double x) : value(x) {}
  explicit Coordinate(std::size_t n) : value(static_cast<double>(n)) {}
  operator double() const { return value; }

  friend bool operator<(const Coordinate& a, const Coordinate& b) { return ++comparisons, a.value < b.value; }
  friend bool operator==(const Coordinate& a, const Coordinate& b) { return ++comparisons, a.value == b.value; }
};

using Points = Ring<Coordinate, 2>;

template <class Draw>
Points drawn(std::size_t n, const Draw& draw) {
  Points points;
  while (points.size() < n) {
    const Point<double, 2> p = draw();
    points.push_back({p[0], p[1]});
  }
  return points;
}

/// The number of comparisons per point; the result must be sorted.
double cost(Points points) {
  comparisons = 0;
  sort_points(points);
  const double each = static_cast<double>(comparisons) / static_cast<double>(points.size());
  REQUIRE(std::is_sorted(points.begin(), points.end(), before<Coordinate>));
  return each;
}

}  // namespace

TEST_CASE("points that are spread evenly are sorted with as many comparisons each, however many they are",
          "[sort_points]") {
  bench::Random random(tests::seed());
  INFO("seed " << tests::seed());
  const auto even = [&](std::size_t n) { return drawn(n, [&] { return random.in_box<2>(1); }); };
  const double few = cost(even(1 << 13)), many = cost(even(1 << 19));
  INFO(few << " of few, " << many << " of many");
  CHECK(many < 1.05 * few);
  CHECK(many < 20);  // lg of 2^19 is 19, and a comparison of points takes one of coordinates or three
}

TEST_CASE("points that are not are sorted with some n lg n comparisons, wherever they lie", "[sort_points]") {
  bench::Random random(tests::seed());
  INFO("seed " << tests::seed());
  const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  int i = 0;
  const std::pair<std::string, std::function<Point<double, 2>()>> families[] = {
      {"one column", [&] { return Point<double, 2>(3, random.unit()); }},
      {"one place", [&] { return Point<double, 2>(3, 4); }},
      {"one far away", [&] { return Point<double, 2>(++i == 1 ? 1e9 : random.unit(), random.unit()); }},
      {"sizes of all kinds", [&] { return Point<double, 2>(random.magnitude(-300, 300), random.unit()); }},
      {"halves of halves", [&] { return Point<double, 2>(std::ldexp(1, -random.below(1000)), random.unit()); }},
      {"a grid", [&] { return bench::vector<double, 2>(random, bench::Numbers::grid); }},
      {"from end to end", [&] { return Point<double, 2>(random.uniform(-1, 1) * most, random.unit()); }},
      {"half the range", [&] { return Point<double, 2>(random.unit() * most, random.unit()); }},
      {"subnormal", [&] { return Point<double, 2>(random.below(100'000) * least, random.unit()); }},
      {"zeros of both signs", [&] { return Point<double, 2>(random.one_in(2) ? 0.0 : -0.0, random.unit()); }},
      {"sorted already", [&] { return Point<double, 2>(++i, random.unit()); }},
      {"sorted, and in one column", [&] { return Point<double, 2>(++i < 3 ? 1e12 * i : 1 + 1e-9 * i, 0); }},
      {"falling", [&] { return Point<double, 2>(--i, 0); }}};
  for (const auto& [name, draw] : families)
    for (const int lg : {12, 13, 17}) {
      i = 0;
      const double each = cost(drawn(std::size_t{1} << lg, draw));
      INFO(name << ", 2^" << lg << " points: " << each << " comparisons each");
      CHECK(each < 8 * lg);
    }
}

}  // namespace sort_points_test
