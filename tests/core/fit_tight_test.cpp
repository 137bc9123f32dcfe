// Tighter balls and boxes hold every point; the smallest ball has its own test, smallest_sphere_test.cpp.

#include <isect/fit_tight.h>

#include <limits>
#include <map>
#include <numbers>

#include <isect/point_obb.h>
#include <isect/point_sphere.h>
#include "bench/random_obb.h"
#include "bench/rational.h"
#include "tests/catch.h"
#include "tests/core/ball_oracle.h"
#include "tests/core/hull_oracle.h"
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
  return std::all_of(points.begin(), points.end(), [&](const auto& p) { return locate(p, shape) != Location::out; });
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

template <class S, int N>
oracle::Rational exact_volume(const Obb<S, N>& box) {
  std::array<oracle::Coordinates<N>, N> a;
  for (int i = 0; i < N; ++i) a[i] = oracle::rational<S, N>(box.axes.col(i));
  oracle::Rational volume;
  if constexpr (N == 2)
    volume = abs(oracle::Rational(a[0][0] * a[1][1] - a[0][1] * a[1][0]));
  else
    volume = abs(oracle::dot(oracle::cross(a[0], a[1]), a[2]));
  for (int i = 0; i < N; ++i) volume *= 2 * oracle::Rational(box.half[i]);
  return volume;
}

/// The area of the smallest rectangle around points, among those with a side along an edge of their hull.
template <class S>
oracle::Rational least_rectangle(const Points<S, 2>& points) {
  const Ring<S, 2> hull = oracle::hull(points);
  oracle::Rational least = -1;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    using oracle::operator-;
    const auto u = oracle::rational(hull[(i + 1) % hull.size()]) - oracle::rational(hull[i]);
    const std::array axes = {u, oracle::Coordinates<2>{-u[1], u[0]}};
    oracle::Rational area = 1;
    for (const auto& axis : axes) {
      std::vector<oracle::Rational> along;
      for (const Point<S, 2>& p : hull) along.push_back(oracle::dot(axis, oracle::rational(p)));
      const auto [lo, hi] = std::minmax_element(along.begin(), along.end());
      area *= *hi - *lo;
    }
    const oracle::Rational length2 = oracle::dot(u, u);
    if (length2 == 0) return 0;
    area /= length2;
    if (least < 0 || area < least) least = area;
  }
  return least;
}

/// Points around which boxes are hard to fit: many on a sphere, needles, discs, all far away from the origin, a lattice
/// with every point twice, and sizes near both ends of the range.
template <class S, int N>
std::vector<Points<S, N>> families(bench::Random& random) {
  const Eigen::Matrix<double, N, N> turn = bench::rotation<double, N>(random, 3);
  const auto made = [&](int n, const auto& point) {
    Points<S, N> points;
    for (int i = 0; i < n; ++i) points.push_back((turn * point()).template cast<S>());
    return points;
  };
  const auto stretched = [&](double first, double others) {
    return [&random, first, others] {
      Vector<double, N> p = others * random.in_box<N>(1);
      p[0] *= first / others;
      return p;
    };
  };
  const auto far = [&] { return Vector<double, N>(Vector<double, N>::Constant(1e6) + random.in_box<N>(1)); };
  std::vector<Points<S, N>> all = {made(200, [&] { return random.heading<N>(); }), made(40, stretched(1, 1e-9)),
                                   made(40, stretched(1e-9, 1)), made(40, far)};
  Points<S, N> lattice;
  for (int i = 0; i < 2 * 27; ++i) {
    lattice.push_back(Point<S, N>::Zero());
    for (int k = 0, rest = i / 2; k < N; ++k, rest /= 3) lattice.back()[k] = static_cast<S>(rest % 3);
  }
  all.push_back(lattice);
  for (const double size : {8.0 * std::numeric_limits<S>::denorm_min(), std::numeric_limits<S>::max() / 8.0})
    all.push_back(made(20, [&] { return Vector<double, N>(size * random.in_box<N>(1)); }));
  return all;
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
      REQUIRE_FALSE(fit_tight::detail::smaller(principal, tight));
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

TEMPLATE_TEST_CASE_SIG("points no use for a fit have empty tight ones", "[fit_tight]", FLOATS_AND_DIMENSIONS) {
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

TEMPLATE_TEST_CASE_SIG("a tight box of points that are hard to fit holds them and is no larger than the principal one",
                       "[fit_tight]", FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  for (int i = 0; i < tests::cases(2, 50); ++i)
    for (const Points<S, N>& points : families<S, N>(random)) {
      INFO("seed " << tests::seed() << ", case " << i << ", " << points.size() << " points, " << points[0].transpose());
      const Obb<S, N> tight = fit_obb_tight(points), principal = fit_obb(points);
      REQUIRE(finite(tight.half));
      REQUIRE(holds_all(tight, points));
      // they are compared in doubles
      REQUIRE(exact_volume(tight) <= exact_volume(principal) * oracle::Rational(1 + 0x1p-49));
      if constexpr (N == 3) {  // as the hull shows
        const Hull3<S> hull = convex_hull(points);
        const Obb<S, 3> of_hull = fit_obb_tight(hull);
        REQUIRE(holds_all(of_hull, points));
        REQUIRE(exact_volume(of_hull) <= exact_volume(fit_obb(hull.vertices)) * oracle::Rational(1 + 0x1p-49));
      }
    }
}

TEMPLATE_TEST_CASE("in the plane the tight box is the smallest but for rounding", "[fit_tight]", float, double) {
  using S = TestType;
  bench::Random random(tests::seed());
  double worst = 0;
  int areas = 0;
  const auto attack = [&](const Points<S, 2>& points) {
    const Aabb<S, 2> around = fit_aabb(points);
    // of the points, and from the origin: the center is rounded, to a subnormal unit at least
    oracle::Rational size = 0, reach(std::numeric_limits<S>::min());
    for (int k = 0; k < 2; ++k) {
      const oracle::Rational lo(around.lo[k]), hi(around.hi[k]);
      size += hi - lo, reach = std::max({reach, oracle::Rational(abs(lo)), oracle::Rational(abs(hi))});
    }
    const oracle::Rational least = least_rectangle(points);
    const Obb<S, 2> tight = fit_obb_tight(points);
    if (size == 0 || !finite(tight.half)) return;
    const oracle::Rational more = (exact_volume(tight) - least) / (size * (size + reach));
    worst = std::max(worst, static_cast<double>(more) / std::numeric_limits<S>::epsilon());
    areas += least > 0;
  };
  for (const Numbers numbers : {Numbers::ordinary, Numbers::grid, Numbers::nudged, Numbers::decimal})
    for (int i = 0; i < tests::cases(100, 5000); ++i) attack(cloud<S, 2>(random, numbers, 1 + random.below(12)));
  for (int i = 0; i < tests::cases(2, 50); ++i)
    for (const Points<S, 2>& points : families<S, 2>(random))
      if (std::abs(points[0][0]) > std::numeric_limits<S>::min()) attack(points);
  INFO("larger by " << worst << " eps of size and reach");
  CHECK(worst < 4);
  CHECK(areas > 100);
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
    INFO(found.name << ", " << points.size() << " points, by principal axes " << volume_of(fit_obb(points)));
    CHECK(volume_of(tight) <= c["expected"]["volume_upper_bound"].get<double>() * (1 + 1e-4));
    CHECK(holds_all(tight, points));
    ++count;
  }
  CHECK(count > 0);
}

namespace {

/// fit::detail::polished, with all points each time.
Eigen::Matrix3d polished_by_all(Eigen::Matrix3d axes, const Points<double, 3>& q) {
  const auto about = directions<double, 3>(26);
  double volume = fit::detail::volume_along<3>(axes, q);
  for (double angle = 0.2; angle > fit::detail::resolution; angle /= 2)
    for (int since = 0, tries = 0; since < 26 && tries < 200; ++since, ++tries) {
      const double turn = tries % 2 ? angle : -angle;
      const Eigen::Matrix3d next = Eigen::AngleAxisd(turn, about[tries / 2 % 13].normalized()) * axes;
      const double less = fit::detail::volume_along<3>(next, q);
      if (fit::detail::clearly_less(less, volume)) axes = next, volume = less, since = 0;
    }
  return axes;
}

/// fit::detail::smallest_along, without bounds.
std::vector<Eigen::Matrix3d> smallest_of_all(const std::vector<Vector<double, 3>>& bases, const Points<double, 3>& q,
                                             std::size_t most) {
  std::map<float, Eigen::Matrix3d> found;
  for (const Vector<double, 3>& base : bases) {
    const Eigen::Matrix3d axes = fit::detail::turned_about(base, q);
    found.emplace(static_cast<float>(fit::detail::volume_along<3>(axes, q)), axes);  // unless there is one
  }
  std::vector<Eigen::Matrix3d> axes;
  for (const auto& one : found)
    if (axes.size() < most) axes.push_back(one.second);
  return axes;
}

}  // namespace

TEST_CASE("the search for a tight box finds the same by few points and bounds as by all", "[fit_tight]") {
  bench::Random random(23);
  int many = 0;
  for (int k = 0; k < 60; ++k) {
    const Points<double, 3> q =
        cloud<double, 3>(random, k % 2 ? Numbers::grid : Numbers::ordinary, 4 + random.below(60));
    const Hull3<double> hull = convex_hull(q);
    std::vector<Vector<double, 3>> normals, bases;
    for (const auto& [a, b, c] : hull.triangles)
      normals.push_back((hull.vertices[b] - hull.vertices[a]).cross(hull.vertices[c] - hull.vertices[a]));
    bases = normals;
    for (int i = 0; i < 40; ++i) bases.push_back(bench::vector<double, 3>(random, Numbers::ordinary));
    const std::vector<Eigen::Matrix3d> best = fit::detail::smallest_along(bases, hull, normals, 16);
    CAPTURE(k, q.size());
    CHECK(best == smallest_of_all(bases, hull.vertices, 16));
    CHECK(fit::detail::polished(best[0], q, fit::detail::resolution) == polished_by_all(best[0], q));
    many += hull.vertices.size() > 16;
  }
  CHECK(many > 15);
}

TEST_CASE("rounding does not choose among the balls and rectangles of symmetrical points", "[fit_tight]") {
  Points<double, 2> ring;
  for (int i = 0; i < 12; ++i) ring.push_back({std::cos(std::numbers::pi * i / 6), std::sin(std::numbers::pi * i / 6)});
  const std::vector<int> support = fit::detail::smallest_ball<2>(ring).points;
  const Vector<double, 2> side = fit::detail::rectangle(ring);
  bench::Random random(tests::seed());
  for (int i = 0; i < 40; ++i) {
    Points<double, 2> nearly = ring;
    for (Point<double, 2>& p : nearly)
      for (double& x : p) x *= 1 + 0x1p-52 * (static_cast<double>(random.below(5)) - 2);
    INFO("seed " << tests::seed() << ", case " << i);
    CHECK(fit::detail::smallest_ball<2>(nearly).points == support);
    CHECK((fit::detail::rectangle(nearly) - side).norm() < 1e-9);
  }
}

}  // namespace fit_tight_test
