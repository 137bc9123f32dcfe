// Tighter balls and boxes hold every point; the smallest ball has a test of its own, smallest_ball_test.cpp.

#include "core/fit_tight.h"

#include <limits>

#include "bench/random_obb.h"
#include "bench/rational.h"
#include "core/point_obb.h"
#include "core/point_sphere.h"
#include "tests/catch.h"
#include "tests/core/ball_oracle.h"
#include "tests/peer_cases.h"
#include "tests/settings.h"

namespace fit_tight_test {
using namespace isect;
using bench::Numbers;

namespace {

template <class S, int N>
using Points = std::vector<Point<S, N>>;

template <class S, int N, class Shape>
bool holds_all(const Shape& shape, const Points<S, N>& points) {
  return std::all_of(points.begin(), points.end(),
                     [&](const auto& p) { return locate(p, shape) != Location::out; });
}

/// Clouds, and all that is degenerate: duplicates, points on a line, in a plane or on a sphere.
template <class S, int N>
Points<S, N> cloud(bench::Random& random, Numbers numbers, int n) {
  Points<S, N> points(n);
  for (Point<S, N>& p : points) p = bench::vector<S, N>(random, numbers);
  const int shape = random.below(6);
  const Vector<S, N> u = points[0] / 4, v = points.back() / 4;
  for (Point<S, N>& p : points) {
    if (shape == 0) p = points[0];
    if (shape == 1) p = u + static_cast<S>(random.uniform(-1, 1)) * v;
    if (shape == 2) p = static_cast<S>(random.uniform(-1, 1)) * u + static_cast<S>(random.uniform(-1, 1)) * v;
    if (shape == 3 && random.one_in(2)) p = points[0];
    if (shape == 4 && numbers == Numbers::ordinary) p = random.heading<N>().template cast<S>();
  }
  return points;
}

template <class S, int N>
double volume_of(const Obb<S, N>& box) {
  return box.half.template cast<double>().prod() * (1 << N);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("every tighter fit holds every point", "[fit_tight]", FLOATS_AND_DIMENSIONS) {
  for (const Numbers numbers : bench::all_numbers) {
    bench::Random random(tests::seed() + static_cast<unsigned>(numbers));
    for (int i = 0; i < tests::cases(10, 600); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Points<S, N> points = cloud<S, N>(random, numbers, 1 + random.below(12));
      REQUIRE(holds_all(fit_sphere_smallest(points), points));
      REQUIRE(holds_all(fit_sphere_ritter(points), points));
      const Obb<S, N> tight = fit_obb_tight(points);
      REQUIRE(holds_all(tight, points));
      const Obb<S, N> principal = fit_obb(points);
      REQUIRE_FALSE(fit_tight::smaller(principal, tight));
      Record<fit_tight::Event> record;
      REQUIRE(fit_sphere_smallest(points, record).radius == fit_sphere_smallest(points).radius);
    }
  }
}

TEMPLATE_TEST_CASE_SIG("no ball is smaller than the smallest one", "[fit_tight]", FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  for (const Numbers numbers : {Numbers::ordinary, Numbers::grid, Numbers::nudged, Numbers::decimal})
    for (int i = 0; i < tests::cases(10, 400); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const Points<S, N> points = cloud<S, N>(random, numbers, 1 + random.below(7));
      const double least = std::sqrt(static_cast<double>(oracle::smallest_ball<S, N>(points).radius2));
      REQUIRE(static_cast<double>(fit_sphere_smallest(points).radius) >= least * (1 - 1e-15));
      REQUIRE(static_cast<double>(fit_sphere_ritter(points).radius) >= least * (1 - 1e-15));
    }
}

TEMPLATE_TEST_CASE_SIG("points no use for a fit have empty tight ones", "[fit_tight]",
                       FLOATS_AND_DIMENSIONS) {
  Points<S, N> points(3, Point<S, N>::Ones());
  points[1][0] = std::numeric_limits<S>::quiet_NaN();
  for (const Points<S, N>& unusable : std::vector<Points<S, N>>{{}, points}) {
    CHECK(empty(fit_sphere_smallest(unusable)));
    CHECK(empty(fit_sphere_ritter(unusable)));
    CHECK(empty(fit_obb_tight(unusable)));
  }
  points[1] = points[0];
  CHECK(fit_sphere_smallest(points).radius == 0);
  CHECK(fit_obb_tight(points).half.isZero(0));
}

TEMPLATE_TEST_CASE_SIG("the tight box of a turned brick is the brick", "[fit_tight]", FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix<S, N, N> frame = bench::rotation<S, N>(random, 3);
    Points<S, N> points;
    for (int corner = 0; corner < 1 << N; ++corner) {
      Point<S, N> c;
      for (int k = 0; k < N; ++k) c[k] = static_cast<S>((corner >> k & 1 ? 1 : -1) * (k + 1));
      points.push_back(frame * c);
    }
    CHECK(volume_of(fit_obb_tight(points)) == Approx(N == 2 ? 8 : 48).epsilon(1e-5));
  }
}

TEST_CASE("tight boxes are as tight as the known ones", "[fit_tight]") {
  int count = 0;
  for (const tests::PeerCase& found : tests::all_cases("bounding_volume_fit")) {
    const nlohmann::json& c = found.content;
    if (!c["expected"].contains("known_tight_obb")) continue;
    Points<double, 3> points;
    for (const nlohmann::json& p : c["points"])
      points.emplace_back(p[0].get<double>(), p[1].get<double>(), p[2].get<double>());
    const Obb<double, 3> tight = fit_obb_tight(points);
    INFO(found.name << ", " << points.size() << " points, by principal axes "
                 << volume_of(fit_obb(points)));
    CHECK(volume_of(tight) <= c["expected"]["volume_upper_bound"].get<double>() * (1 + 1e-4));
    CHECK(holds_all(tight, points));
    ++count;
  }
  CHECK(count > 0);
}

}  // namespace fit_tight_test
