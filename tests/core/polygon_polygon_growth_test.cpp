// How the work of two polygons grows with their corners.

#include <cmath>
#include <numbers>
#include <utility>

#include <isect/polygon_polygon.h>
#include "tests/catch.h"
#include "tests/core/growth.h"

namespace polygon_polygon_growth_test {
using namespace isect;

namespace {

using Pair = std::pair<Polygon<double, 2>, Polygon<double, 2>>;

/// Round, with a notch at every second corner.
Polygon<double, 2> gear(int n, double x) {
  Ring<double, 2> ring;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n, r = i % 2 == 0 ? 1 : 1 - 1. / n;
    ring.push_back({x + r * std::cos(angle), r * std::sin(angle)});
  }
  return {{ring}};
}
/// Squares in rows.
Polygon<double, 2> squares(int n, double shift) {
  Polygon<double, 2> all;
  const int side = static_cast<int>(std::sqrt(n / 4));
  for (int i = 0; i < side; ++i)
    for (int k = 0; k < side; ++k) {
      const double x = 2 * i + shift, y = 2 * k + shift;
      all.rings.push_back({{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}});
    }
  return all;
}

}  // namespace

TEST_CASE("the work of two polygons grows with the edges whose boxes meet", "[polygon_polygon]") {
  const auto grows = [](int n, const auto& make, const auto& run) { return tests::growth(n, make, run); };
  const auto lie = [](const Pair& p) { return relate(p.first, p.second); };
  const auto meet = [](const Pair& p) { return intersects(p.first, p.second); };
  const auto gears = [](int n) { return Pair(gear(n, 0), gear(n, 0.3)); };
  const auto equal = [](int n) { return Pair(gear(n, 0), gear(n, 0)); };
  const auto apart = [](int n) { return Pair(squares(n, 0), squares(n, 1.25)); };
  const double overlapping = grows(1000, gears, lie), same = grows(1000, equal, lie), yes = grows(1000, gears, meet),
               rows = grows(1000, apart, lie);
  INFO("overlapping n^" << overlapping << ", equal n^" << same << ", yes or no n^" << yes << ", rows n^" << rows);
  CHECK(overlapping < 1.3);
  CHECK(same < 1.3);
  CHECK(yes < 1.3);
  CHECK(rows < 1.6);
}

}  // namespace polygon_polygon_growth_test
