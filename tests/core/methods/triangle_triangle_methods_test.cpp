#include <isect/methods/triangle_triangle.h>

#include <array>
#include <cmath>

#include <isect/counted.h>
#include "bench/half_spaces/oracle.h"
#include "bench/random.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace triangle_triangle_methods_test {
using namespace isect;
using namespace isect::triangle_triangle;
using Three = Triangle<double, 3>;
using C = Counted<double>;

namespace {

const Three floor_tile = {{Point<double, 3>{0, 0, 0}, Point<double, 3>{4, 0, 0}, Point<double, 3>{0, 4, 0}}};

Three triangle(const Point<double, 3>& p, const Point<double, 3>& q, const Point<double, 3>& r) { return {{p, q, r}}; }

/// Whole numbers from -2 to 2: all cases are frequent, and doubles are exact.
Three drawn(bench::Random& random) {
  for (;;) {
    Three x;
    for (auto& v : x.vertices)
      for (int i = 0; i < 3; ++i) v[i] = random.integer(-2, 2);
    if (!triangle_triangle::detail::normal(x).isZero(0)) return x;
  }
}

bool meet(const Three& a, const Three& b) { return !oracle::clipped(b, oracle::sides(a)).empty(); }

}  // namespace

TEST_CASE("triangles of small whole numbers meet as rationals say, by intervals and by signs",
          "[triangle_triangle_methods]") {
  bench::Random random(tests::seed());
  std::array<int, 2> seen = {};
  int flat = 0;
  for (int i = 0; i < tests::cases(3000, 60000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const Three a = drawn(random);
    Three b = drawn(random);
    if (i % 4 == 0) {  // in the plane of a
      const auto& [p, q, r] = a.vertices;
      for (auto& v : b.vertices) {
        const double along_q = random.integer(-1, 2), along_r = random.integer(-1, 2);
        v = p + along_q * (q - p) + along_r * (r - p);
      }
      if (triangle_triangle::detail::normal(b).isZero(0)) continue;
      ++flat;
    }
    const bool truth = meet(a, b);
    REQUIRE(by_signs(a, b) == truth);
    REQUIRE(by_signs(b, a) == truth);
    Record<IntervalsEvent<double>> record;
    const bool found = by_intervals(a, b, record);
    // Only shares are rounded: where the intervals meet in one number, rounding may decide.
    const auto* shared = record.events.empty() ? nullptr : std::get_if<Shared<double>>(&record.events.back());
    if (!shared || std::abs(shared->hi - shared->lo) > 1e-12) REQUIRE(found == truth);
    ++seen[truth];
  }
  CHECK(seen[0] > 300);
  CHECK(seen[1] > 300);
  CHECK(flat > 100);
}

TEST_CASE("signs are right where rounding decides", "[triangle_triangle_methods]") {
  bench::Random random(tests::seed());
  int wrong = 0;
  for (int i = 0; i < tests::cases(1000, 20000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    Three a, b;
    for (auto& v : a.vertices) v = random.in_box<3>(2);
    for (auto& v : b.vertices) v = random.in_box<3>(2);
    b.vertices[0] = a.vertices[0] + random.unit() * (a.vertices[1] - a.vertices[0]);
    const bool truth = meet(a, b);
    REQUIRE(by_signs(a, b) == truth);
    wrong += by_intervals(a, b) != truth;
  }
  CHECK(wrong > 20);
}

TEST_CASE("the events tell heights, the line of both planes, both parts of it and what these share",
          "[triangle_triangle_methods]") {
  const Three wall = triangle({1, 1, -1}, {1, 1, 1}, {3, 3, 1});
  Record<IntervalsEvent<double>> record;
  CHECK(by_intervals(floor_tile, wall, record));
  REQUIRE(record.events.size() == 6);
  const auto& heights = std::get<Heights<double>>(record.events[1]);
  CHECK(heights.of == 1);
  CHECK(heights.heights == std::array<double, 3>{-16, 16, 16});
  const auto& cut = std::get<Cut<double>>(record.events[4]);
  CHECK(cut.alone == 0);
  CHECK(cut.shares == std::array<double, 2>{0.5, 0.5});
  const int axis = std::get<LineOfPlanes<double>>(record.events[2]).axis;
  CHECK(axis < 2);
  CHECK((cut.interval.lo == 1 && cut.interval.hi == 2));
  const auto& shared = std::get<Shared<double>>(record.events[5]);
  CHECK((shared.lo == 1 && shared.hi == 2 && shared.holds));

  Record<SignsEvent> signs;
  CHECK(by_signs(floor_tile, wall, signs));
  REQUIRE(signs.events.size() == 6);
  CHECK(std::get<triangle_triangle::Sides>(signs.events[1]).signs == Signs{-1, 1, 1});
  CHECK(std::get<Alone>(signs.events[3]).corner == 0);
  CHECK(std::get<Ends>(signs.events[5]).sign <= 0);
}

TEST_CASE("a triangle above the other, and one beside it in its plane, end early", "[triangle_triangle_methods]") {
  Record<SignsEvent> signs;
  CHECK_FALSE(by_signs(floor_tile, triangle({0, 0, 1}, {1, 0, 2}, {0, 1, 3}), signs));
  CHECK(std::get<triangle_triangle::Sides>(signs.events.back()).beside);
  signs.events.clear();
  CHECK_FALSE(by_signs(floor_tile, triangle({5, 0, 0}, {6, 0, 0}, {5, 1, 0}), signs));
  CHECK(std::get<InPlane>(signs.events.back()).apart);
  CHECK(by_signs(floor_tile, triangle({4, 0, 0}, {6, 0, 0}, {5, 1, 0})));
  CHECK(by_intervals(floor_tile, triangle({1, 1, 0}, {2, 1, 0}, {1, 2, 0})));
}

TEST_CASE("intervals take four divisions", "[triangle_triangle_methods]") {
  const auto counted = [](const Three& x) {
    Triangle<C, 3> all;
    for (std::size_t i = 0; i < 3; ++i) all.vertices[i] = x.vertices[i].cast<C>();
    return all;
  };
  tally() = {};
  CHECK(by_intervals(counted(floor_tile), counted(triangle({1, 1, -1}, {1, 1, 1}, {3, 3, 1}))));
  CHECK(tally().div == 4);
}

}  // namespace triangle_triangle_methods_test
