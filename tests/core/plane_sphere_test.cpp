#include <isect/plane_sphere.h>

#include "bench/rational.h"
#include "bench/simple_shapes.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/core/motion.h"
#include "tests/settings.h"

namespace plane_sphere_test {
using namespace isect;
using namespace isect::oracle;
using tests::at, tests::inf, tests::not_a_number;

namespace {

template <class S, int N>
Relation related(const Plane<S, N>& plane, const Sphere<S, N>& sphere) {
  const Relation r = relate(plane, sphere);
  CHECK(intersects(plane, sphere) == (r != Relation::disjoint));
  if (r != Relation::disjoint) CHECK(side(plane, sphere) == 0);
  return r;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a plane misses a ball, touches it, or cuts it, and an ulp decides", "[plane_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  const Plane<S, N> plane = {at<S, N>(3, 4), S(-10)};  // 2 away from the origin
  const auto ball = [](double x, double y, S r) { return Sphere<S, N>{at<S, N>(x, y), r}; };
  CHECK(related(plane, ball(0, 0, 1)) == Relation::disjoint);
  CHECK(related(plane, ball(0, 0, std::nextafter(S(2), S(0)))) == Relation::disjoint);
  CHECK(related(plane, ball(0, 0, 2)) == Relation::touching);
  CHECK(related(plane, ball(0, 0, std::nextafter(S(2), S(3)))) == Relation::overlapping);
  CHECK(related(plane, ball(2, 1, 1)) == Relation::overlapping);  // its center lies in the plane
  CHECK(side(plane, ball(0, 0, 1)) == -1);
  CHECK(side(plane, ball(3, 4, 1)) == 1);
}

TEMPLATE_TEST_CASE_SIG("a ball of radius 0 touches the planes through it", "[plane_sphere]", FLOATS_AND_DIMENSIONS) {
  const Plane<S, N> plane = {at<S, N>(1, 1), S(-3)};
  CHECK(related(plane, Sphere<S, N>{at<S, N>(1, 2), S(0)}) == Relation::touching);
  CHECK(related(plane, Sphere<S, N>{at<S, N>(1, 2), S(-0.0)}) == Relation::touching);
  CHECK(related(plane, Sphere<S, N>{at<S, N>(1, 1), S(0)}) == Relation::disjoint);
  CHECK(side(plane, Sphere<S, N>{at<S, N>(1, 1), S(0)}) == -1);
}

TEMPLATE_TEST_CASE_SIG("plane and sphere: the normal may have any length, and lengths any size", "[plane_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  constexpr int most = std::numeric_limits<S>::max_exponent - 6;
  for (const int e : {-most, -most / 2, 0, most / 2, most}) {
    const double k = std::ldexp(1.0, e);
    const Sphere<S, N> unit = {at<S, N>(0, 0), S(2)}, scaled = {at<S, N>(0, 0), S(2 * k)};
    CHECK(related(Plane<S, N>{at<S, N>(3 * k, 4 * k), S(-10 * k)}, unit) == Relation::touching);
    CHECK(related(Plane<S, N>{at<S, N>(3 * k, 4 * k), S(-11 * k)}, unit) == Relation::disjoint);
    CHECK(related(Plane<S, N>{at<S, N>(3, 4), S(-10 * k)}, scaled) == Relation::touching);
    CHECK(related(Plane<S, N>{at<S, N>(3, 4), S(-9 * k)}, scaled) == Relation::overlapping);
  }
}

TEMPLATE_TEST_CASE_SIG("plane and sphere: a zero normal is no plane, and what is empty, NaN or infinite meets nothing",
                       "[plane_sphere]", FLOATS_AND_DIMENSIONS) {
  const Sphere<S, N> ball = {at<S, N>(1, 2), S(3)};
  const Plane<S, N> good = {at<S, N>(1, 0), S(0)};
  const auto nothing = [](const Plane<S, N>& plane, const Sphere<S, N>& sphere) {
    CHECK(related(plane, sphere) == Relation::disjoint);
    CHECK(side(plane, sphere) == 0);
  };
  for (const double d : {-1, 0, 1}) nothing({at<S, N>(0, -0.0), S(d)}, ball);
  nothing(good, {ball.center, S(-1)});
  for (const double bad : {not_a_number, inf, -inf}) {
    nothing({at<S, N>(1, bad), S(0)}, ball);
    nothing({at<S, N>(1, 0), S(bad)}, ball);
    nothing(good, {at<S, N>(0, bad), S(1)});
    nothing(good, {at<S, N>(0, 0), S(bad)});
  }
}

TEST_CASE("the events tell both signs, and each fallback", "[plane_sphere]") {
  Record<plane_sphere::Event> record;
  relate<double, 2>({{3, 4}, -10}, {{0, 0}, 2}, record);
  REQUIRE(record.events.size() == 2);
  CHECK(std::holds_alternative<Fallback>(record.events[0]));
  const auto& decision = std::get<plane_sphere::Decision>(record.events[1]);
  CHECK((decision.center == -1 && decision.clear == 0));
}

TEMPLATE_TEST_CASE_SIG("plane and sphere: verdicts are those of rational arithmetic", "[plane_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  bench::Random random(tests::seed());
  int seen[6] = {}, sides[3] = {};
  for (const bench::Numbers numbers : bench::all_numbers)
    for (int i = 0; i < tests::cases(1500, 125000); ++i) {
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      Sphere<S, N> ball = bench::ball<S, N>(random, numbers);
      const bool whole = random.one_in(2);
      Plane<S, N> plane = {bench::vector<S, N>(random, whole ? bench::Numbers::grid : numbers),
                           bench::number<S>(random, numbers)};
      if (random.one_in(3)) plane.normal = Vector<S, N>::Unit(random.below(N));  // touches that are exact
      const Vector<double, N> n = plane.normal.template cast<double>(), c = ball.center.template cast<double>();
      if (random.one_in(4)) plane.d = bench::moved(static_cast<S>(-n.dot(c)), random.integer(-2, 2));
      const double height = std::abs(n.dot(c) + double(plane.d)) / n.stableNorm();
      if (random.one_in(2) && std::isfinite(height))
        ball.radius = bench::moved(static_cast<S>(height), random.integer(-2, 2));
      if (!finite(ball) || !finite(plane) || plane.normal.isZero(0) || ball.radius < 0) continue;

      // the point of the plane nearest to the center
      const Coordinates<N> normal = rational(plane.normal), center = rational(ball.center);
      const Rational h = dot(normal, center) + Rational(plane.d);
      const Coordinates<N> f = Rational(h / dot(normal, normal)) * normal;
      const Rational radius = ball.radius;
      const int clear = sign(dot(f, f) - radius * radius);
      const Relation truth = clear > 0 ? Relation::disjoint : clear == 0 ? Relation::touching : Relation::overlapping;

      if (relate(plane, ball) != truth) FAIL("wrong");
      if (intersects(plane, ball) != (clear <= 0)) FAIL("wrong: intersects");
      if (side(plane, ball) != (clear > 0 ? sign(h) : 0)) FAIL("wrong: side");
      const Plane<S, N> turned = {-plane.normal, -plane.d};
      if (side(turned, ball) != -side(plane, ball)) FAIL("not opposite when turned around");
      if (numbers <= bench::Numbers::distant) {
        const tests::Motion<N> move = tests::motion<N>(random);
        if (relate(move(plane), move(ball)) != truth) FAIL("not the same when moved");
      }
      ++seen[static_cast<int>(truth)], ++sides[side(plane, ball) + 1];
    }
  for (const Relation r : {Relation::disjoint, Relation::touching, Relation::overlapping})
    CHECK(seen[static_cast<int>(r)] > 300);
  for (const int count : sides) CHECK(count > 300);
}

}  // namespace plane_sphere_test
