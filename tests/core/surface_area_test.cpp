// Surfaces and volumes against rationals with 100-digit roots: needles, wild meshes, and sizes up to the ends of the
// range.

#include <boost/multiprecision/mpfr.hpp>
#include <limits>

#include <isect/directions.h>
#include <isect/fit.h>
#include <isect/volume.h>
#include "bench/random_shapes.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace surface_area_test {
using namespace isect;
using bench::Numbers;
using bench::Random;
using oracle::Rational;
using oracle::operator-;
using Decimal =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<100>, boost::multiprecision::et_off>;

namespace {

using Triangles = std::vector<std::array<int, 3>>;

Decimal norm(const Rational& square) { return sqrt(Decimal(square)); }

template <class S>
Decimal true_area(const std::vector<Point<S, 3>>& vertices, const Triangles& triangles) {
  Decimal sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const auto p = oracle::rational<S, 3>(vertices[a]), q = oracle::rational<S, 3>(vertices[b]),
               r = oracle::rational<S, 3>(vertices[c]);
    const auto n = oracle::cross(r - q, p - q);
    sum += norm(oracle::dot(n, n)) / 2;
  }
  return sum;
}

/// The error of x in ulps; for an infinite x 0 if the truth is within `room` ulps of the largest S.
template <class S>
double off(S x, const Decimal& truth, double room = 3) {
  const S most = std::numeric_limits<S>::max();
  if (std::isinf(x)) return truth >= Decimal(most) * (1 - room * Decimal(std::numeric_limits<S>::epsilon())) ? 0 : 1e9;
  return oracle::ulps(x, Rational(truth));
}

/// A number of any size that S has.
template <class S>
S wild(Random& random) {
  using Limits = std::numeric_limits<S>;
  if (random.one_in(6)) return S(0);
  if (random.one_in(12)) return bench::moved(Limits::max(), -random.below(3));
  if (random.one_in(8)) return static_cast<S>(random.integer(-3, 3)) * Limits::denorm_min();
  return static_cast<S>(
      std::ldexp(random.uniform(-1, 1), random.integer(Limits::min_exponent - 20, Limits::max_exponent)));
}

}  // namespace

TEST_CASE("a needle has its whole surface", "[volume]") {
  const std::vector<Point<double, 3>> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0x1p540}};
  const Hull3<double> hull = convex_hull(points);
  CHECK(surface_area(hull) == Approx((1 + std::sqrt(0.5)) * 0x1p540).epsilon(1e-15));
  CHECK(off(surface_area(hull), true_area(hull.vertices, hull.triangles)) <= 3);
}

TEMPLATE_TEST_CASE("areas of meshes are within 3 ulp, whatever their numbers", "[volume]", float, double) {
  using S = TestType;
  Random random(bench::stream(tests::seed(), "areas"));
  double worst = 0;
  int finite = 0, infinite = 0, subnormal = 0;
  for (int i = 0; i < tests::cases(3000, 100000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const bool all_wild = random.one_in(3);
    const int shift = random.integer(-70, 70);
    const int exponent = (std::is_same_v<S, float> ? 1 : 8) * shift;
    const int thin = random.below(std::is_same_v<S, float> ? 60 : 500);
    std::vector<Point<S, 3>> vertices(3 + random.below(4));
    for (Point<S, 3>& p : vertices)
      for (int k = 0; k < 3; ++k)
        p[k] = all_wild ? wild<S>(random)  // or a needle, or a sheet, along the axes
                        : static_cast<S>(std::ldexp(random.uniform(-1, 1), exponent - (k < i % 3 ? thin : 0)));
    Triangles triangles;
    const int n = static_cast<int>(vertices.size());
    for (int k = 1 + random.below(5); k > 0; --k)
      triangles.push_back({random.below(n), random.below(n), random.below(n)});
    const S area = surface_area(vertices, triangles);
    worst = std::max(worst, off(area, true_area(vertices, triangles)));
    REQUIRE(worst <= 3);
    (std::isinf(area) ? infinite : finite) += 1;
    subnormal += area > 0 && area < std::numeric_limits<S>::min();
  }
  CAPTURE(worst);
  CHECK((finite > 500 && infinite > 50 && subnormal > 20));
}

TEMPLATE_TEST_CASE("areas and volumes of wild hulls are within 3 and 2 ulp", "[volume]", float, double) {
  using S = TestType;
  Random random(bench::stream(tests::seed(), "hulls"));
  for (int i = 0; i < tests::cases(150, 6000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    std::vector<Point<S, 3>> points(4 + random.below(6));
    for (Point<S, 3>& p : points)
      for (S& x : p) x = wild<S>(random);
    const Hull3<S> hull = convex_hull(points);
    REQUIRE(off(surface_area(hull), true_area(hull.vertices, hull.triangles)) <= 3);
    Rational sum = 0;
    for (const auto& [a, b, c] : hull.triangles)
      sum += oracle::dot(
          oracle::rational<S, 3>(hull.vertices[a]),
          oracle::cross(oracle::rational<S, 3>(hull.vertices[b]), oracle::rational<S, 3>(hull.vertices[c])));
    REQUIRE(off(volume(hull), Decimal(sum) / 6, 2) <= 2);
  }
}

TEMPLATE_TEST_CASE_SIG("surfaces of oriented boxes are within 3 ulp, whatever the axes", "[volume]",
                       FLOATS_AND_DIMENSIONS) {
  Random random(bench::stream(tests::seed(), "boxes"));
  for (int i = 0; i < tests::cases(500, 30000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    Obb<S, N> box = {Point<S, N>::Zero(), {}, {}};
    for (int k = 0; k < N; ++k) {
      box.half[k] = std::abs(i % 2 ? wild<S>(random) : static_cast<S>(random.unit()));
      for (int j = 0; j < N; ++j) box.axes(j, k) = i % 3 ? static_cast<S>(random.uniform(-1, 1)) : wild<S>(random);
    }
    Decimal truth = 0;
    for (int k = 0; k < N; ++k) {
      const auto u = oracle::rational<S, N>(box.axes.col((k + 1) % N));
      if constexpr (N == 2) {
        truth += 4 * norm(oracle::dot(u, u)) * Decimal(box.half[(k + 1) % N]);
      } else {
        const auto n = oracle::cross(u, oracle::rational<S, N>(box.axes.col((k + 2) % N)));
        truth += 8 * norm(oracle::dot(n, n)) * Decimal(box.half[(k + 1) % N]) * Decimal(box.half[(k + 2) % N]);
      }
    }
    REQUIRE(off(surface_area(box), truth) <= 3);
  }
}

namespace {

template <int N>
Rational determinant(const std::array<oracle::Coordinates<N>, N>& u) {
  if constexpr (N == 2)
    return u[0][0] * u[1][1] - u[0][1] * u[1][0];
  else
    return oracle::dot(u[0], oracle::cross(u[1], u[2]));
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("volumes of boxes are within 2 ulp, however skew, and what they leave void follows", "[volume]",
                       FLOATS_AND_DIMENSIONS) {
  Random random(bench::stream(tests::seed(), "box volumes"));
  double worst = 0;
  const auto hold = [&](double off) {
    worst = std::max(worst, off);
    if (off > 2) REQUIRE(off <= 2);
  };
  for (int i = 0; i < tests::cases(4000, 200'000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const Numbers numbers = bench::all_numbers[random.below(std::size(bench::all_numbers))];
    const auto any = [&] { return random.one_in(3) ? wild<S>(random) : bench::number<S>(random, numbers); };
    Obb<S, N> box = {Point<S, N>::Zero(), {}, {}};
    std::array<oracle::Coordinates<N>, N> axes;
    Rational truth = N == 2 ? 4 : 8;
    for (int k = 0; k < N; ++k) {
      const Vector<S, N> first = box.axes.col(0);
      for (int j = 0; j < N; ++j) box.axes(j, k) = i % 2 ? static_cast<S>(random.uniform(-1, 1)) : any();
      if (k > 0 && i % 4 == 1)  // nearly dependent: the volume is what rounding took
        for (int j = 0; j < N; ++j) box.axes(j, k) = bench::moved(first[j] * S(k + 1) / S(3), random.integer(-2, 2));
      axes[k] = oracle::rational<S, N>(box.axes.col(k));
      box.half[k] = std::abs(any()), truth *= Rational(box.half[k]);
    }
    truth *= abs(determinant<N>(axes));
    const S size = volume(box);
    hold(off(size, Decimal(truth), 2));

    Aabb<S, N> straight;
    Rational product = 1, surface = 0;
    for (int k = 0; k < N; ++k) {
      straight.lo[k] = any(), straight.hi[k] = any();
      if (random.one_in(4) && std::abs(straight.lo[k]) < 1)
        straight.hi[k] = bench::moved(straight.lo[k], random.below(3));
      if (straight.lo[k] > straight.hi[k]) std::swap(straight.lo[k], straight.hi[k]);
    }
    const auto sides = oracle::rational<S, N>(straight.hi) - oracle::rational<S, N>(straight.lo);
    for (int k = 0; k < N; ++k) product *= sides[k], surface += 2 * (N == 2 ? sides[k] : sides[k] * sides[(k + 1) % N]);
    hold(off(volume(straight), Decimal(product), 2));
    hold(off(surface_area(straight), Decimal(surface), 2));

    const S object = std::abs(any()), left = void_volume(box, object);
    if (!std::isfinite(size) || !std::isfinite(left)) continue;
    const Decimal unit = std::max({std::numeric_limits<S>::denorm_min(), bench::moved(size, 1) - size});
    const Decimal least =
        std::max(std::numeric_limits<S>::denorm_min(), bench::moved(std::abs(left), 1) - std::abs(left));
    if (unit > 0) REQUIRE(abs(Decimal(left) - (Decimal(truth) - Decimal(object))) <= 2 * unit + least / 2);
  }
  CAPTURE(worst);
  CHECK(worst > 0.45);
}

TEMPLATE_TEST_CASE("sizes of k-DOPs are those of their rounded polytopes, and what they leave void follows", "[volume]",
                   float, double) {
  using S = TestType;
  Random random(bench::stream(tests::seed(), "k-DOPs"));
  for (const Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(8, 400); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      std::vector<Point<S, 3>> points(4 + random.below(6));
      std::vector<Point<S, 2>> flat(3 + random.below(6));
      for (Point<S, 3>& p : points) p = bench::vector<S, 3>(random, numbers);
      for (Point<S, 2>& p : flat) p = bench::vector<S, 2>(random, numbers);

      const Kdop<S, 3> kdop = fit_kdop(points, directions<S, 3>(i % 2 ? 14 : 26));
      const Kdop<S, 2> flat_kdop = fit_kdop(flat, directions<S, 2>(8));
      if (!finite(kdop) || !finite(flat_kdop)) continue;
      const Polytope<S, 3> solid = polytope(kdop);
      if (!finite(solid.vertices)) continue;
      Rational sum = 0;
      Triangles fans;
      for (const std::vector<int>& ring : solid.faces)
        for (std::size_t k = 2; k < ring.size(); ++k) {
          fans.push_back({ring[0], ring[k - 1], ring[k]});
          sum += oracle::dot(oracle::rational<S, 3>(solid.vertices[ring[0]]),
                             oracle::cross(oracle::rational<S, 3>(solid.vertices[ring[k - 1]]),
                                           oracle::rational<S, 3>(solid.vertices[ring[k]])));
        }
      REQUIRE(off(volume(kdop), Decimal(sum) / 6, 2) <= 2);
      REQUIRE(off(surface_area(kdop), true_area(solid.vertices, fans)) <= 3);
      const S object = volume(convex_hull(points));
      if (std::isfinite(volume(kdop))) REQUIRE(void_volume(kdop, object) == volume(kdop) - object);

      const std::vector<Point<S, 2>> ring = polytope(flat_kdop).vertices;
      if (!finite(ring)) continue;
      Decimal perimeter = 0;
      Rational area2 = 0;
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const auto p = oracle::rational<S, 2>(ring[k]), q = oracle::rational<S, 2>(ring[(k + 1) % ring.size()]);
        perimeter += norm(oracle::dot(q - p, q - p)), area2 += p[0] * q[1] - p[1] * q[0];
      }
      REQUIRE(off(surface_area(flat_kdop), perimeter) <= 3);
      REQUIRE(off(volume(flat_kdop), Decimal(area2) / 2, 2) <= 2);
    }
}

TEMPLATE_TEST_CASE("balls are within 4 ulp", "[volume]", float, double) {
  using S = TestType;
  Random random(bench::stream(tests::seed(), "balls"));
  const Decimal pi = 4 * atan(Decimal(1));
  double worst = 0;
  for (int i = 0; i < tests::cases(20000, 300000); ++i) {
    INFO("seed " << tests::seed() << ", case " << i);
    const S r = i % 4 ? static_cast<S>(random.uniform(1, 2)) : std::abs(wild<S>(random));
    const Decimal d = r;
    const double all[] = {off(volume(Sphere<S, 2>{{0, 0}, r}), Decimal(pi * d * d), 4),
                          off(surface_area(Sphere<S, 2>{{0, 0}, r}), Decimal(2 * pi * d), 4),
                          off(volume(Sphere<S, 3>{{0, 0, 0}, r}), Decimal(4 * pi * d * d * d / 3), 4),
                          off(surface_area(Sphere<S, 3>{{0, 0, 0}, r}), Decimal(4 * pi * d * d), 4)};
    worst = std::max(worst, *std::max_element(std::begin(all), std::end(all)));
    REQUIRE(worst <= 4);
  }
  CAPTURE(worst);
}

}  // namespace surface_area_test
