#include <isect/sphere_triangle.h>

#include <random>

#include "bench/sphere_triangle/oracle.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace sphere_triangle_test {
using namespace isect;
using tests::inf, tests::not_a_number;

namespace {

using Vec = Vector<double, 3>;
using oracle::operator*, oracle::operator+, oracle::operator-;

/// The points of a segment, or the point that it is.
oracle::Sides segment_sides(const Capsule<double, 3>& segment) {
  const oracle::Place p = oracle::rational(segment.p), d = oracle::rational(segment.q) - p;
  oracle::Sides sides;
  for (std::size_t i = 0; i < 3; ++i) {
    oracle::Place unit = {0, 0, 0};
    unit[i] = 1;
    const oracle::Place n = oracle::dot(d, d) == 0 ? unit : oracle::cross(d, unit);
    sides.push_back({n, -oracle::dot(n, p)});
    sides.push_back({oracle::Rational(-1) * n, oracle::dot(n, p)});
  }
  sides.push_back({d, -oracle::dot(d, p)});
  sides.push_back({oracle::Rational(-1) * d, oracle::dot(d, p) + oracle::dot(d, d)});
  return sides;
}

Relation relation(const Capsule<double, 3>& capsule, const Triangle<double, 3>& triangle) {
  const oracle::Rational r(capsule.radius), d2 = oracle::distance2(oracle::stretch(capsule), triangle);
  if (d2 > r * r) return Relation::disjoint;
  if (r == 0) return reversed(oracle::relation(triangle, segment_sides(capsule)));
  bool held = true;
  for (const Vec& v : triangle.vertices)
    held &= oracle::distance2<3>(oracle::rational(v), oracle::stretch(capsule)) <= r * r;
  if (held) return Relation::b_inside_a;
  return d2 == r * r ? Relation::touching : Relation::overlapping;
}

}  // namespace

TEST_CASE("balls and capsules lie to a triangle as their distances tell", "[sphere_triangle]") {
  std::mt19937_64 random(tests::seed());
  for (const bool whole : {true, false}) {
    const auto number = [&](int lo, int hi) -> double {
      if (whole) return std::uniform_int_distribution<int>(lo, hi)(random);
      return std::uniform_real_distribution<double>(lo, hi)(random);
    };
    const auto vector = [&]() -> Vec { return {number(-5, 5), number(-5, 5), number(-5, 5)}; };
    std::array<int, 6> seen = {};
    for (int round = 0; round < tests::cases(1500, 50000); ++round) {
      Triangle<double, 3> triangle = {{vector(), vector(), vector()}};
      if (round % 7 == 0) triangle.vertices[1] = triangle.vertices[round % 14 == 0 ? 0 : 2];
      double r = number(0, round % 5 == 0 ? 12 : 4);
      Sphere<double, 3> ball = {vector(), r};
      if (round % 6 == 0) ball = {triangle.vertices[0] + Vec(1, -2, 2), r = 3};  // it may touch there
      const Capsule<double, 3> capsule = {ball.center, vector(), r};
      CAPTURE(round, whole);
      const Relation of_ball = relation({ball.center, ball.center, r}, triangle),
                     of_capsule = relation(capsule, triangle);
      REQUIRE(relate(ball, triangle) == of_ball);
      REQUIRE(intersects(ball, triangle) == (of_ball != Relation::disjoint));
      REQUIRE(relate(capsule, triangle) == of_capsule);
      REQUIRE(intersects(capsule, triangle) == (of_capsule != Relation::disjoint));
      ++seen[static_cast<std::size_t>(of_ball)], ++seen[static_cast<std::size_t>(of_capsule)];
    }
    CHECK(seen[static_cast<std::size_t>(Relation::disjoint)] > 50);
    CHECK(seen[static_cast<std::size_t>(Relation::b_inside_a)] > 20);
    CHECK(seen[static_cast<std::size_t>(Relation::overlapping)] > 50);
    CHECK((!whole || seen[static_cast<std::size_t>(Relation::touching)] > 20));
  }
}

TEST_CASE("an ulp decides at a corner, an edge and the face of a triangle", "[sphere_triangle]") {
  const Triangle<double, 3> triangle = {{{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}}};
  const auto related = [&](const Vec& center, double r) { return relate(Sphere<double, 3>{center, r}, triangle); };
  const struct {
    Vec center;
    double r;
  } touching[] = {{{-2, -3, 6}, 7}, {{4, -3, 4}, 5}, {{2, 3, 4}, 4}};
  for (const auto& [center, r] : touching) {
    CHECK(related(center, r) == Relation::touching);
    CHECK(related(center, std::nextafter(r, 0)) == Relation::disjoint);
    CHECK(related(center, std::nextafter(r, 99)) == Relation::overlapping);
    const Capsule<double, 3> away = {center, center + Vec(0, 0, 5), r};
    CHECK(relate(away, triangle) == Relation::touching);
  }
  const auto with_segment = [&](const Vec& p, const Vec& q) { return relate(Capsule<double, 3>{p, q, 0}, triangle); };
  CHECK(with_segment({2, 2, -5}, {2, 2, 5}) == Relation::overlapping);
  CHECK(with_segment({2, 2, 0}, {2, 2, 5}) == Relation::touching);
  CHECK(with_segment({0, 2, -5}, {0, 2, 5}) == Relation::touching);
  CHECK(with_segment({2, 2, 0}, {20, 2, 0}) == Relation::overlapping);
  CHECK(with_segment({0, 0, 0}, {0, 20, 0}) == Relation::touching);
  CHECK(with_segment({0, 0, 0}, {0, 5, 0}) == Relation::a_inside_b);
  CHECK(relate(Sphere<double, 3>{{2, 2, 0}, 0}, triangle) == Relation::a_inside_b);
  CHECK(relate(Capsule<double, 3>{{2, 2, -5}, {2, 2, 5}, 1}, triangle) == Relation::overlapping);
  CHECK(relate(Capsule<double, 3>{{20, 2, -5}, {20, 2, 5}, 0}, triangle) == Relation::disjoint);
  CHECK(relate(Capsule<double, 3>{{0, 0, 0}, {9, 9, 0}, 9}, triangle) == Relation::b_inside_a);
}

TEST_CASE("a ball or a triangle that is empty, NaN or infinite meets nothing", "[sphere_triangle]") {
  const Triangle<double, 3> triangle = {{{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}}};
  CHECK(relate(Sphere<double, 3>{{0, 0, 0}, -1}, triangle) == Relation::disjoint);
  for (const double bad : {not_a_number, inf}) {
    CHECK_FALSE(intersects(Sphere<double, 3>{{bad, 0, 0}, 1}, triangle));
    CHECK_FALSE(intersects(Capsule<double, 3>{{0, 0, 0}, {0, bad, 0}, 1}, triangle));
    CHECK_FALSE(
        intersects(Sphere<double, 3>{{0, 0, 0}, 1}, Triangle<double, 3>{{{{0, 0, 0}, {bad, 0, 0}, {0, 9, 0}}}}));
  }
}

}  // namespace sphere_triangle_test
