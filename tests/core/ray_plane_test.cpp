#include <isect/methods/ray_plane.h>
#include <isect/ray_plane.h>

#include <cmath>
#include <limits>

#include <isect/counted.h>
#include "bench/random_rays.h"
#include "bench/ray_plane/oracle.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace ray_plane_test {
using namespace isect;
using bench::Numbers;
using bench::Random;
using oracle::Rational;
using tests::at, tests::inf, tests::not_a_number;

namespace {

/// The plane x = at.
template <class S, int N>
Plane<S, N> wall(double where, double length = 1) {
  return {at<S, N>(length), static_cast<S>(-where * length)};
}

template <class S>
bool nothing(const RayPlane<S>& r) {
  return !r && !r.parallel && !r.coplanar && !r.line && !r.t;
}
template <class S>
bool identical(const RayPlane<S>& a, const RayPlane<S>& b) {
  return a.parallel == b.parallel && a.coplanar == b.coplanar && a.line == b.line && a.t == b.t && a.meets == b.meets;
}
template <class S>
bool same_verdicts(const RayPlane<S>& a, const RayPlane<S>& b) {
  return a.parallel == b.parallel && a.coplanar == b.coplanar && a.line.has_value() == b.line.has_value() &&
         a.t.has_value() == b.t.has_value() && a.meets == b.meets;
}

/// A plane, and a ray that is aimed at a point of it every other time.
template <class S, int N>
struct Case {
  Ray<S, N> ray;
  Plane<S, N> plane;
};
template <class S, int N>
Case<S, N> draw(Random& random, Numbers numbers) {
  Case<S, N> c = {bench::ray<S, N>(random, numbers),
                  {bench::direction<S, N>(random, numbers), bench::number<S>(random, numbers)}};
  if (random.one_in(2)) return c;
  // the plane through a point of the ray, as nearly as S can: at an end of the range, or in the ray's direction
  const S t = random.one_in(2) ? c.ray.range.lo : c.ray.range.hi;
  if (random.one_in(3)) {
    c.plane.normal = Vector<S, N>::Zero();
    c.plane.normal[0] = c.ray.direction[1], c.plane.normal[1] = -c.ray.direction[0];
  }
  const S d = -c.plane.normal.dot(c.ray.at(std::isinf(t) ? S(0) : t));
  if (std::isfinite(d)) c.plane.d = bench::moved(d, random.one_in(3) ? random.integer(-1, 1) : 0);
  return c;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a ray towards a plane meets it once", "[ray_plane]", FLOATS_AND_DIMENSIONS) {
  const RayPlane<S> r = intersect<S, N>({at<S, N>(-3, 1), at<S, N>(2, 1)}, wall<S, N>(1));
  CHECK(r);
  CHECK_FALSE(r.parallel);
  CHECK(r.line == S(2));
  CHECK(r.t == S(2));
}

TEMPLATE_TEST_CASE_SIG("a ray away from a plane misses it, its line does not", "[ray_plane]", FLOATS_AND_DIMENSIONS) {
  Ray<S, N> ray = {at<S, N>(3), at<S, N>(1)};
  CHECK_FALSE(intersect(ray, wall<S, N>(1)));
  CHECK(intersect(ray, wall<S, N>(1)).line == S(-2));
  ray.range = infinite<S>;
  CHECK(intersect(ray, wall<S, N>(1)).t == S(-2));
}

TEMPLATE_TEST_CASE_SIG("both ends of a segment belong to it", "[ray_plane]", FLOATS_AND_DIMENSIONS) {
  const Ray<S, N> s = segment<S, N>(at<S, N>(1), at<S, N>(4));
  CHECK(intersect(s, wall<S, N>(1)).t == S(0));
  CHECK(intersect(s, wall<S, N>(4)).t == S(1));
  CHECK_FALSE(intersect(s, wall<S, N>(5)));
  CHECK_FALSE(intersect(s, wall<S, N>(0)));
  CHECK(intersect(line_through<S, N>(at<S, N>(1), at<S, N>(4)), wall<S, N>(-5)).t == S(-2));
}

TEMPLATE_TEST_CASE_SIG("a parallel ray lies beside the plane or in it", "[ray_plane]", FLOATS_AND_DIMENSIONS) {
  const RayPlane<S> beside = intersect<S, N>({at<S, N>(0), at<S, N>(0, 1)}, wall<S, N>(1));
  CHECK((!beside && beside.parallel && !beside.coplanar && !beside.line));
  const RayPlane<S> within = intersect<S, N>({at<S, N>(1, 7), at<S, N>(-0., 1)}, wall<S, N>(1));
  CHECK((within && within.parallel && within.coplanar && !within.line && !within.t));
  const RayPlane<S> empty = intersect<S, N>({at<S, N>(1), at<S, N>(0, 1), {S(1), S(0)}}, wall<S, N>(1));
  CHECK((!empty && empty.coplanar));
}

TEMPLATE_TEST_CASE_SIG("ray and plane: a zero direction makes the ray a point", "[ray_plane]", FLOATS_AND_DIMENSIONS) {
  CHECK(intersect<S, N>({at<S, N>(1), at<S, N>(0)}, wall<S, N>(1)).coplanar);
  const RayPlane<S> off = intersect<S, N>({at<S, N>(2), at<S, N>(0)}, wall<S, N>(1));
  CHECK((!off && off.parallel && !off.coplanar));
}

TEMPLATE_TEST_CASE_SIG("a zero normal, an empty range and NaN meet nothing", "[ray_plane]", FLOATS_AND_DIMENSIONS) {
  const Ray<S, N> ray = {at<S, N>(-3), at<S, N>(1)};
  CHECK(nothing(intersect(ray, Plane<S, N>{at<S, N>(0), S(0)})));
  CHECK(nothing(intersect(ray, Plane<S, N>{at<S, N>(-0.), S(1)})));
  CHECK_FALSE(intersect<S, N>({ray.origin, ray.direction, {S(5), S(3)}}, wall<S, N>(1)));
  const S infinity = static_cast<S>(inf);
  CHECK_FALSE(intersect<S, N>({ray.origin, ray.direction, {infinity, infinity}}, wall<S, N>(1)));
  for (const double bad : {not_a_number, inf, -inf}) {
    CHECK(nothing(intersect<S, N>({at<S, N>(bad), at<S, N>(1)}, wall<S, N>(1))));
    CHECK(nothing(intersect<S, N>({at<S, N>(0), at<S, N>(1, bad)}, wall<S, N>(1))));
    CHECK(nothing(intersect(ray, Plane<S, N>{at<S, N>(1, bad), S(1)})));
    CHECK(nothing(intersect(ray, Plane<S, N>{at<S, N>(1), static_cast<S>(bad)})));
  }
  CHECK(nothing(intersect<S, N>({at<S, N>(0), at<S, N>(1), {static_cast<S>(not_a_number), S(1)}}, wall<S, N>(1))));
}

TEST_CASE("a plane of any length meets a ray of any length", "[ray_plane]") {
  for (const double length : {1e-300, 1e-200, 1., 1e200, 1e300})
    for (const double speed : {1e-300, 1e-9, 1., 1e9, 1e300}) {
      const RayPlane<double> r = intersect<double, 3>({{-3, 1, 0}, {speed, speed, 0}}, {{length, 0, 0}, -length});
      REQUIRE(r);
      const Rational t = Rational(4) / Rational(speed);
      CHECK(oracle::ulps(*r.t, t) <= 2);
    }
  const RayPlane<double> far = intersect<double, 3>({{-1e300, 0, 0}, {1e-300, 0, 0}}, {{1, 0, 0}, -1e300});
  CHECK(far);  // at t = 2e600
  CHECK(far.t == inf);
}

TEST_CASE("the far plane of the report is met where it is", "[ray_plane]") {
  // a unit diagonal normal that is rounded, and a plane a million away: 27 % off in float arithmetic
  const float n = 1 / std::sqrt(3.f);
  const Ray<float, 3> ray = {{1e6f, 1e6f, 1e6f}, {-n, -n, -n}, infinite<float>};
  const Plane<float, 3> plane = {{n, n, n}, -1732050.9f};
  const Rational truth = (3 * Rational(n) * Rational(1e6f) - Rational(1732050.9f)) / (3 * Rational(n) * Rational(n));
  CHECK(oracle::ulps(*intersect(ray, plane).t, truth) <= 2);
  CHECK(oracle::ulps(*ray_plane::textbook(ray, plane), truth) > 1000);
}

TEST_CASE("the textbook's method agrees on ordinary rays", "[ray_plane]") {
  Random random(tests::seed());
  for (int i = 0; i < 2000; ++i) {
    const Ray<double, 3> ray = {random.in_box<3>(1), random.in_box<3>(1)};
    const Plane<double, 3> plane = {random.in_box<3>(1), random.uniform(-1, 1)};
    INFO("seed " << tests::seed() << ", case " << i);
    const std::optional<double> t = ray_plane::textbook(ray, plane);
    REQUIRE(t.has_value() == intersect(ray, plane).t.has_value());
    if (t) REQUIRE(*t == Approx(*intersect(ray, plane).t));
  }
  CHECK_FALSE(ray_plane::textbook<double, 2>({{0, 1}, {1, 0}}, {{0, 1}, 0}));
  using C = Counted<double>;
  tally() = {};
  CHECK(
      ray_plane::textbook<C, 3>({{C(-3), C(0), C(0)}, {C(1), C(0), C(0)}, {C(0), C(9)}}, {{C(1), C(0), C(0)}, C(-1)}));
  CHECK(tally().mul == 6);
  CHECK(tally().div == 1);
}

TEMPLATE_TEST_CASE_SIG("ray and plane: every answer is that of rational arithmetic", "[ray_plane][random]",
                       FLOATS_AND_DIMENSIONS) {
  int hits = 0, misses = 0, parallel = 0, coplanar = 0, at_ends = 0;
  double worst = 0;
  const int count = tests::cases(1000, 320000);
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + static_cast<int>(numbers));
    for (int i = 0; i < count; ++i) {
      const Case<S, N> c = draw<S, N>(random, numbers);
      if (c.plane.normal == Vector<S, N>::Zero()) continue;
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const RayPlane<S> r = intersect(c.ray, c.plane);
      REQUIRE(intersects(c.ray, c.plane) == r.meets);
      REQUIRE(first_hit(c.ray, c.plane) == (r.meets && r.coplanar ? c.ray.range.lo : r.t));
      const oracle::RayPlane t = oracle::ray_plane(c.ray, c.plane);
      REQUIRE(r.parallel == t.parallel);
      REQUIRE(r.coplanar == t.coplanar);
      REQUIRE(r.meets == t.meets);
      REQUIRE(r.line.has_value() == t.line.has_value());
      REQUIRE(r.t.has_value() == (t.meets && !t.coplanar));
      if (r.line) worst = std::max(worst, oracle::ulps(*r.line, *t.line));
      if (r.t) {
        worst = std::max(worst, oracle::ulps(*r.t, *t.line));
        REQUIRE((c.ray.range.lo <= *r.t && *r.t <= c.ray.range.hi));
        at_ends += c.ray.range.lo == *r.t || *r.t == c.ray.range.hi;
      }
      hits += r.t.has_value(), misses += !r.parallel && !r, parallel += r.parallel, coplanar += r.coplanar;
    }
  }
  CHECK(worst <= 2);
  for (const int often : {hits, misses, parallel, coplanar, at_ends}) CHECK(often > count / 8);
}

TEMPLATE_TEST_CASE_SIG("listening, mirroring, swapping axes and scaling change no verdict", "[ray_plane][property]",
                       FLOATS_AND_DIMENSIONS) {
  for (const Numbers numbers : bench::all_numbers) {
    Random random(tests::seed() + 100 + static_cast<int>(numbers));
    for (int i = 0; i < 300; ++i) {
      const Case<S, N> c = draw<S, N>(random, numbers);
      INFO("seed " << tests::seed() << ", numbers " << static_cast<int>(numbers) << ", case " << i);
      const RayPlane<S> r = intersect(c.ray, c.plane);
      REQUIRE(intersects(c.ray, c.plane) == r.meets);
      REQUIRE(first_hit(c.ray, c.plane) == (r.meets && r.coplanar ? c.ray.range.lo : r.t));

      Record<ray_plane::Event<S>> record;
      REQUIRE(identical(intersect(c.ray, c.plane, record), r));
      REQUIRE(identical(intersect(c.ray, Plane<S, N>{-c.plane.normal, -c.plane.d}), r));

      const Ray<S, N> mirrored = {c.ray.origin, -c.ray.direction, {-c.ray.range.hi, -c.ray.range.lo}};
      REQUIRE(same_verdicts(intersect(mirrored, c.plane), r));
      if (r.t) REQUIRE(*intersect(mirrored, c.plane).t == -*r.t);

      Case<S, N> swapped = c;
      for (Vector<S, N>* v : {&swapped.ray.origin, &swapped.ray.direction, &swapped.plane.normal}) {
        std::swap((*v)[0], (*v)[N - 1]);
        (*v)[1] = -(*v)[1];
      }
      REQUIRE(same_verdicts(intersect(swapped.ray, swapped.plane), r));

      if (numbers == Numbers::wide || numbers == Numbers::tiny || numbers == Numbers::huge) continue;
      Case<S, N> scaled = c;
      const S lengths = std::ldexp(S(1), random.integer(-20, 20)), normal = std::ldexp(S(1), random.integer(-20, 20));
      scaled.ray.origin *= lengths, scaled.ray.direction *= lengths;
      scaled.plane.normal *= normal, scaled.plane.d *= normal * lengths;
      if (scaled.ray.origin / lengths != c.ray.origin || scaled.ray.direction / lengths != c.ray.direction ||
          scaled.plane.normal / normal != c.plane.normal || scaled.plane.d / (normal * lengths) != c.plane.d)
        continue;  // a number was lost to underflow
      REQUIRE(identical(intersect(scaled.ray, scaled.plane), r));
    }
  }
}

TEMPLATE_TEST_CASE_SIG("moving ray and plane together by whole numbers changes nothing", "[ray_plane][property]",
                       FLOATS_AND_DIMENSIONS) {
  Random random(tests::seed());
  for (int i = 0; i < 2000; ++i) {
    const Case<S, N> c = draw<S, N>(random, Numbers::grid);
    INFO("seed " << tests::seed() << ", case " << i);
    Vector<S, N> by;
    for (int k = 0; k < N; ++k) by[k] = static_cast<S>(random.integer(-1000, 1000));
    Case<S, N> moved = c;
    moved.ray.origin += by, moved.plane.d -= c.plane.normal.dot(by);
    if (moved.plane.d + c.plane.normal.dot(by) != c.plane.d) continue;  // the plane was nudged
    REQUIRE(same_verdicts(intersect(moved.ray, moved.plane), intersect(c.ray, c.plane)));
  }
}

TEMPLATE_TEST_CASE_SIG("every hit lies on the plane", "[ray_plane][property]", FLOATS_AND_DIMENSIONS) {
  Random random(tests::seed());
  for (int i = 0; i < 5000; ++i) {
    const Case<S, N> c = draw<S, N>(random, i % 2 ? Numbers::decimal : Numbers::distant);
    INFO("seed " << tests::seed() << ", case " << i);
    const std::optional<S> t = intersect(c.ray, c.plane).t;
    if (!t) continue;
    const Point<double, N> x = c.ray.at(*t).template cast<double>();
    const Vector<double, N> n = c.plane.normal.template cast<double>();
    const double coordinate =
        4 * std::numeric_limits<S>::epsilon() *
        (c.ray.origin.cwiseAbs().maxCoeff() + std::abs(*t) * c.ray.direction.cwiseAbs().maxCoeff());
    const double measuring =
        8 * std::numeric_limits<double>::epsilon() * (n.cwiseAbs().dot(x.cwiseAbs()) + std::abs(c.plane.d));
    REQUIRE(std::abs(n.dot(x) + c.plane.d) <= n.template lpNorm<1>() * coordinate + measuring);
  }
}

}  // namespace ray_plane_test
