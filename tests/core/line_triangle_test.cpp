#include <isect/line_triangle.h>

#include <cmath>
#include <limits>

#include "bench/line_triangle/oracle.h"
#include "bench/random_rays.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace line_triangle_test {
using namespace isect;
using bench::Numbers, bench::Random;
using oracle::Rational, oracle::operator-;

namespace {

template <class S>
Triangle<S, 3> draw(Random& random, Numbers numbers) {
  Triangle<S, 3> x = {{bench::vector<S, 3>(random, numbers), bench::vector<S, 3>(random, numbers),
                       bench::vector<S, 3>(random, numbers)}};
  auto& [a, b, c] = x.vertices;
  switch (random.below(8)) {
    case 0:  // a segment, its third corner at an end, between or beyond
      c = random.one_in(2) ? a : Point<S, 3>(a / 2 + b / 2);
      break;
    case 1:
      c = b = a;
      break;
    case 2:
      for (int i = 0, kept = random.below(3); i < 3; ++i)
        if (i != kept) b[i] = c[i] = a[i];
      break;
    case 3:
      c[2] = b[2] = a[2];
      break;
    default:
      break;
  }
  return x;
}

/// A ray from anywhere, or in the plane of the triangle, along an edge, at a corner.
template <class S>
Segment<S, 3> course(Random& random, Numbers numbers, const Triangle<S, 3>& x) {
  Segment<S, 3> s = {bench::vector<S, 3>(random, numbers), bench::vector<S, 3>(random, numbers)};
  const auto& [a, b, c] = x.vertices;
  const auto part = [&] { return static_cast<S>(random.integer(-4, 6)) / 4; };
  const auto in_plane = [&]() -> Point<S, 3> { return a + part() * (b - a) + part() * (c - a); };
  if (random.one_in(3)) s.q = in_plane();
  if (random.one_in(3)) s.p = in_plane();
  if (random.one_in(5)) s.p = a + part() * (b - a);
  if (random.one_in(5)) s.q = a + part() * (b - a);
  if (random.one_in(8)) s.p = c;
  return s;
}

}  // namespace

TEST_CASE("a ray first meets a triangle across its plane, in it, or as the segment that it is", "[line_triangle]") {
  const Triangle<double, 3> x = {{Point<double, 3>{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  const auto ray = [](Point<double, 3> o, Vector<double, 3> d, Interval<double> range = semi_infinite<double>) {
    return Ray<double, 3>{o, d, range};
  };
  CHECK(first_hit(ray({1, 1, 3}, {0, 0, -1}), x) == 3.0);
  CHECK(first_hit(ray({3, 3, 3}, {0, 0, -1}), x) == std::nullopt);
  CHECK(first_hit(ray({-2, 1, 0}, {1, 0, 0}), x) == 2.0);  // in its plane
  CHECK(first_hit(ray({1, 1, 0}, {1, 0, 0}), x) == 0.0);
  CHECK(first_hit(ray({-2, 0, 0}, {1, 0, 0}), x) == 2.0);  // along an edge
  CHECK(first_hit(ray({-2, 1, 0}, {1, 0, 0}, infinite<double>), x) == 2.0);
  CHECK(first_hit(ray({-2, 1, 0}, {1, 0, 0}, {0, 1}), x) == std::nullopt);
  CHECK(first_hit(ray({-2, 1, 1}, {1, 0, 0}), x) == std::nullopt);  // above it
  CHECK(first_hit(ray({1, 1, 0}, {0, 0, 0}, {-3, 2}), x) == -3.0);  // a point
  const Triangle<double, 3> thin = {{Point<double, 3>{1, 1, 0}, {4, 4, 0}, {2, 2, 0}}};
  CHECK(first_hit(ray({3, 3, 3}, {0, 0, -1}), thin) == 3.0);
  CHECK(first_hit(ray({0, 0, 0}, {1, 1, 0}), thin) == 1.0);
  CHECK(first_hit(ray({3, 3, 0}, {0, 0, 0}, {-3, 2}), thin) == -3.0);
  CHECK(first_hit(ray({0, 0, 0}, {1, 1, 1}), thin) == std::nullopt);
  const Triangle<double, 3> point = {{Point<double, 3>{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}};
  CHECK(first_hit(ray({0, 0, 0}, {1, 1, 1}), point) == 1.0);
  CHECK(first_hit(Segment<double, 3>{{0, 0, 0}, {4, 4, 4}}, point) == 0.25);
  CHECK(first_hit(Segment<double, 3>{{1, 1, 1}, {1, 1, 1}}, point) == 0.0);
  CHECK(first_hit(Segment<double, 3>{{1, 1, 0}, {1, 1, 0}}, x) == 0.0);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    CHECK(first_hit(ray({1, 1, bad}, {0, 0, -1}), x) == std::nullopt);
    CHECK(first_hit(Segment<double, 3>{{0, 0, 0}, {4, bad, 4}}, point) == std::nullopt);
    CHECK(first_hit(ray({1, 1, 3}, {0, 0, -1}), {{Point<double, 3>{0, 0, 0}, {4, 0, bad}, {0, 4, 0}}}) == std::nullopt);
  }
  CHECK(first_hit(ray({1, 1, 3}, {0, 0, -1}, {5, 4}), x) == std::nullopt);
}

TEMPLATE_TEST_CASE("line and triangle: the first t is that of rational arithmetic", "[line_triangle]", float, double) {
  using S = TestType;
  int hits = 0, misses = 0, thin = 0, coplanar = 0;
  double worst = 0;
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < tests::cases(800, 150000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Triangle<S, 3> x = draw<S>(random, numbers);
      const Segment<S, 3> s = course(random, numbers, x);
      if (!finite(s) || !finite(x) || s.p == s.q) continue;
      const auto v = oracle::corners(x);
      const auto p = oracle::rational<S, 3>(s.p), q = oracle::rational<S, 3>(s.q);
      const std::optional<S> of_segment = first_hit(s, x);
      const auto truth = oracle::first_hit(p, q - p, {0, 1}, v);
      REQUIRE(of_segment.has_value() == truth.has_value());
      if (truth) REQUIRE((0 <= *of_segment && *of_segment <= 1 && oracle::ulps(*of_segment, *truth) <= 2));

      const Ray<S, 3> ray = {s.p, s.q - s.p, bench::range<S>(random, Numbers::grid)};
      if (!finite(ray) || ray.direction.isZero(0) || empty(ray.range)) continue;
      const std::optional<S> t = first_hit(ray, x);
      const auto d = oracle::rational<S, 3>(ray.direction);
      const auto first = oracle::first_hit(p, d, cast<double>(ray.range), v);
      REQUIRE(t.has_value() == first.has_value());
      (t ? hits : misses) += 1;
      if (!t) continue;
      REQUIRE((ray.range.lo <= *t && *t <= ray.range.hi));
      worst = std::max(worst, oracle::ulps(*t, *first));
      coplanar += intersect(ray, x).coplanar;
      thin += triangle_half_spaces::detail::degenerate(cast<double>(x), NoTrace());
    }
  }
  CHECK(worst <= 2);
  for (const int often : {hits, misses}) CHECK(often > 1000);
  for (const int often : {thin, coplanar}) CHECK(often > 200);
}

}  // namespace line_triangle_test
