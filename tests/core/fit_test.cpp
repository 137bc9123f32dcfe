// Bounding volumes of points: they hold every point, and no smaller number would.

#include <isect/fit.h>

#include <algorithm>
#include <limits>
#include <vector>

#include <isect/point_aabb.h>
#include <isect/point_kdop.h>
#include <isect/point_sphere.h>
#include "bench/random_obb.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/core/clouds.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace fit_test {
using namespace isect;
using oracle::Rational;
using tests::clouds::cloud;
using oracle::operator-;
using tests::inf, tests::not_a_number;

namespace {

template <class S, int N>
using Points = std::vector<Point<S, N>>;

template <class S, int N, class Shape>
bool holds_all(const Shape& shape, const Points<S, N>& points) {
  return std::all_of(points.begin(), points.end(), [&](const auto& p) { return locate(p, shape) != Location::out; });
}

template <class S>
S less(S x) {
  return std::nextafter(x, -std::numeric_limits<S>::infinity());
}

/// Normals of the faces of a box, of a diagonal cut, and of skew directions.
template <class S, int N>
std::vector<Vector<S, N>> normals(bench::Random& random) {
  std::vector<Vector<S, N>> result;
  for (int k = 0; k < N; ++k) result.push_back(Vector<S, N>::Unit(k));
  result.push_back(Vector<S, N>::Ones());
  result.push_back(Vector<S, N>::Unit(0) - Vector<S, N>::Unit(1));
  result.push_back(random.heading<N>().template cast<S>());
  return result;
}

/// Compares the volumes' sizes with those of the points in rationals, by division where the core multiplies.
template <class S, int N>
void check_sizes(const Points<S, N>& points, const Kdop<S, N>& kdop, const Sphere<S, N>& sphere) {
  for (std::size_t i = 0; i < kdop.normals.size(); ++i) {
    const auto n = oracle::rational<S, N>(kdop.normals[i]);
    Rational lo = oracle::dot(n, oracle::rational<S, N>(points[0])), hi = lo;
    for (const Point<S, N>& p : points) {
      const Rational x = oracle::dot(n, oracle::rational<S, N>(p));
      lo = std::min(lo, x), hi = std::max(hi, x);
    }
    const Interval<S> slab = kdop.slabs[i];
    if (std::isfinite(slab.hi)) REQUIRE((Rational(slab.hi) >= hi && Rational(less(slab.hi)) < hi));
    if (std::isfinite(slab.lo)) REQUIRE((Rational(slab.lo) <= lo && Rational(-less(-slab.lo)) > lo));
  }
  Rational farthest2 = 0;
  const auto center = oracle::rational<S, N>(sphere.center);
  for (const Point<S, N>& p : points) {
    const auto f = oracle::rational<S, N>(p) - center;
    farthest2 = std::max(farthest2, oracle::dot(f, f));
  }
  const Rational r(sphere.radius);
  REQUIRE(r * r >= farthest2);
  if (sphere.radius > 0) {
    const Rational smaller(less(sphere.radius));
    REQUIRE(smaller * smaller < farthest2);
  }
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("every fit holds every point, and no smaller size would", "[fit]", FLOATS_AND_DIMENSIONS) {
  const int cases = tests::cases(60, 25000);
  for (const bench::Numbers numbers : bench::all_numbers) {
    bench::Random random(tests::seed() + static_cast<unsigned>(numbers));
    for (int i = 0; i < cases; ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Points<S, N> points = cloud<S, N>(random, numbers);
      const Aabb<S, N> aabb = fit_aabb(points);
      REQUIRE(holds_all(aabb, points));
      for (int k = 0; k < N; ++k) {
        const auto at_end = [&](S end) {
          return std::any_of(points.begin(), points.end(), [&](const auto& p) { return p[k] == end; });
        };
        REQUIRE((at_end(aabb.lo[k]) && at_end(aabb.hi[k])));
      }

      const Sphere<S, N> sphere = fit_sphere(points);
      REQUIRE(holds_all(sphere, points));
      const Kdop<S, N> kdop = fit_kdop(points, normals<S, N>(random));
      if (finite(kdop)) REQUIRE(holds_all(kdop, points));
      check_sizes(points, kdop, sphere);

      const Obb<S, N> obb = fit_obb(points);
      REQUIRE(holds_all(obb, points));
      for (int k = 0; k < N; ++k) {
        Obb<S, N> smaller = obb;
        smaller.half[k] = less(obb.half[k]);
        REQUIRE_FALSE(holds_all(smaller, points));
      }
    }
  }
}

TEMPLATE_TEST_CASE_SIG("no points, NaN or infinity have empty fits", "[fit]", FLOATS_AND_DIMENSIONS) {
  const std::vector<Vector<S, N>> axes = {Vector<S, N>::Unit(0), Vector<S, N>::Ones()};
  std::vector<Points<S, N>> unusable(1);
  for (const double bad : {not_a_number, inf, -inf}) {
    Points<S, N> points(3, Point<S, N>::Ones());
    points[1][N - 1] = static_cast<S>(bad);
    unusable.push_back(points);
  }
  for (const Points<S, N>& points : unusable) {
    CHECK(empty(fit_aabb(points)));
    CHECK(empty(fit_sphere(points)));
    CHECK(empty(fit_obb(points)));
    CHECK(empty(fit_kdop(points, axes)));
    CHECK(locate<S, N>(Point<S, N>::Ones(), fit_obb(points)) == Location::out);
  }
}

TEMPLATE_TEST_CASE_SIG("one point fits itself", "[fit]", FLOATS_AND_DIMENSIONS) {
  const Points<S, N> point = {Point<S, N>::Constant(static_cast<S>(0.1))};
  CHECK(fit_sphere(point).radius == 0);
  CHECK(fit_sphere(point).center == point[0]);
  CHECK(fit_obb(point).half.isZero(0));
  CHECK(fit_aabb(point).lo == fit_aabb(point).hi);
}

TEMPLATE_TEST_CASE_SIG("the corners of a brick have the brick", "[fit]", FLOATS_AND_DIMENSIONS) {
  Points<S, N> points;
  for (int corner = 0; corner < 1 << N; ++corner) {
    Point<S, N> c;
    for (int k = 0; k < N; ++k) c[k] = static_cast<S>((corner >> k & 1 ? 1 : -1) << k);
    points.push_back(c);
  }
  CHECK(fit_sphere(points).radius == Approx(N == 2 ? std::sqrt(5) : std::sqrt(21)).epsilon(1e-6));
  Vector<S, N> half = fit_obb(points).half;
  std::sort(half.begin(), half.end());
  for (int k = 0; k < N; ++k) CHECK(half[k] == Approx(1 << k).epsilon(1e-6));
  const Kdop<S, N> kdop = fit_kdop<S, N>(points, {Vector<S, N>::Ones()});
  CHECK(kdop.slabs[0] == Interval<S>{S(1 - (1 << N)), S((1 << N) - 1)});
}

TEMPLATE_TEST_CASE_SIG("points in a tilted plane have a thin box", "[fit]", FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  const Eigen::Matrix<S, N, N> frame = bench::rotation<S, N>(random, 3);
  Points<S, N> points;
  for (int i = 0; i < 50; ++i) {
    Vector<double, N> s = random.in_box<N>(1);
    s[0] = 0;
    points.push_back(frame * s.template cast<S>());
  }
  const Obb<S, N> box = fit_obb(points);
  CHECK(box.half.minCoeff() < 8 * std::numeric_limits<S>::epsilon());
}

TEMPLATE_TEST_CASE_SIG("the ball of points on a sphere is that sphere, nearly", "[fit]", FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  Points<S, N> points;
  for (int i = 0; i < 200; ++i) points.push_back(random.heading<N>().template cast<S>());
  CHECK(fit_sphere(points).radius < 1.1);
}

TEMPLATE_TEST_CASE_SIG("sizes beyond the largest number are infinite", "[fit]", FLOATS_AND_DIMENSIONS) {
  const S most = std::numeric_limits<S>::max();
  const Points<S, N> points = {Point<S, N>::Constant(-most), Point<S, N>::Constant(most)};
  CHECK(fit_sphere(points).radius == std::numeric_limits<S>::infinity());
  CHECK(fit_kdop<S, N>(points, {Vector<S, N>::Ones()}).slabs[0].hi == std::numeric_limits<S>::infinity());
  CHECK(holds_all(fit_aabb(points), points));
  const Points<S, N> half = {points[0] / 2, points[1] / 2};
  CHECK(holds_all(fit_sphere(half), half));
  CHECK(holds_all(fit_obb(half), half));
}

TEMPLATE_TEST_CASE_SIG("the oriented box is no larger than the straight one, but for rounding", "[fit]",
                       FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  for (int i = 0; i < 300; ++i) {
    const Points<S, N> points = cloud<S, N>(random, bench::Numbers::ordinary);
    const Aabb<S, N> straight = fit_aabb(points);
    const double volume = (straight.hi - straight.lo).template cast<double>().prod();
    const double turned = fit_obb(points).half.template cast<double>().prod() * (1 << N);
    CHECK(turned <= volume + 100 * std::numeric_limits<S>::epsilon());
  }
}

TEST_CASE("the events tell which points decide", "[fit]") {
  Record<fit::Event> record;
  const Points<double, 2> points = {{0, 0}, {3, 1}, {-1, 2}};
  fit_kdop<double, 2>(points, {Vector<double, 2>::Unit(0)}, record);
  std::vector<fit::Extreme> extremes;
  for (const auto& event : record.events)
    if (const auto* extreme = std::get_if<fit::Extreme>(&event)) extremes.push_back(*extreme);
  REQUIRE(extremes.size() == 2);
  CHECK(extremes[0].side == -extremes[1].side);
  for (const fit::Extreme& extreme : extremes) CHECK(extreme.point == (extreme.side == 1 ? 1 : 2));
}

TEMPLATE_TEST_CASE_SIG("eigenvectors are orthonormal, belong to a symmetric matrix and ascend", "[fit]", ((int N), N),
                       2, 3) {
  using Matrix = Eigen::Matrix<double, N, N>;
  bench::Random random(tests::seed());
  const auto check = [](const Matrix& m) {
    const Matrix v = fit::detail::eigenvectors<N>(m), diagonal = v.transpose() * m * v;
    CAPTURE(m, v);
    const double tolerance = 16 * std::numeric_limits<double>::epsilon() * std::max(m.norm(), 1e-290);
    CHECK((v.transpose() * v - Matrix::Identity()).norm() <= 16 * std::numeric_limits<double>::epsilon());
    for (int i = 0; i < N; ++i) {
      for (int j = 0; j < N; ++j) CHECK((i == j || std::abs(diagonal(i, j)) <= tolerance));
      CHECK((i == 0 || diagonal(i - 1, i - 1) <= diagonal(i, i) + tolerance));
    }
  };
  for (int round = 0; round < tests::cases(200, 100000); ++round) {
    Matrix m = Matrix::NullaryExpr([&] { return random.uniform(-1, 1); });
    m = m + m.transpose().eval();
    check(m);
    check(m * 1e-150);
    check(m * m);                            // as covariances are
    check(m.col(0) * m.col(0).transpose());  // two eigenvalues are 0
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j)
        if (i != j) m(i, j) *= 1e-17;  // nearly along the axes
    check(m);
  }
  CHECK(fit::detail::eigenvectors<N>(3 * Matrix::Identity()) == Matrix::Identity());
  CHECK(fit::detail::eigenvectors<N>(Matrix::Zero()) == Matrix::Identity());
  const Matrix hair = Matrix::Identity() + std::numeric_limits<double>::denorm_min() * Matrix::Ones();
  CHECK(fit::detail::eigenvectors<N>(hair).array().isFinite().all());
}

}  // namespace fit_test
