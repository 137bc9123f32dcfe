// The cases by name. Random and hard shapes stand in ray_sphere_properties_test.cpp and
// ray_sphere_families_test.cpp.

#include <isect/ray_sphere.h>

#include <cmath>
#include <limits>

#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace ray_sphere_test {
using namespace isect;
using tests::at, tests::inf, tests::not_a_number;

namespace {

template <class S, int N>
Sphere<S, N> ball(double radius = 1) {
  return {at<S, N>(0), static_cast<S>(radius)};
}

template <class S>
Interval<S> between(double lo, double hi) {
  return {static_cast<S>(lo), static_cast<S>(hi)};
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a ray towards a sphere enters and leaves it", "[ray_sphere]", FLOATS_AND_DIMENSIONS) {
  const RaySphere<S> r = intersect<S, N>({at<S, N>(-3), at<S, N>(1)}, ball<S, N>());
  CHECK(r);
  CHECK(r.line_roots == 2);
  CHECK(r.origin == Location::out);
  CHECK(r.roots == between<S>(2, 4));
  CHECK(r.surface == S(2));
  CHECK(r.solid == between<S>(2, 4));
}

TEMPLATE_TEST_CASE_SIG("t counts lengths of the direction", "[ray_sphere]", FLOATS_AND_DIMENSIONS) {
  const RaySphere<S> r = intersect<S, N>({at<S, N>(-3), at<S, N>(0.5)}, ball<S, N>());
  CHECK(r.roots == between<S>(4, 8));
}

TEMPLATE_TEST_CASE_SIG("a tangent ray touches once", "[ray_sphere]", FLOATS_AND_DIMENSIONS) {
  const RaySphere<S> r = intersect<S, N>({at<S, N>(-3, 1), at<S, N>(1)}, ball<S, N>());
  CHECK(r.line_roots == 1);
  CHECK(r.roots == between<S>(3, 3));
  CHECK(r.surface == S(3));
  CHECK(r.solid == between<S>(3, 3));
}

TEMPLATE_TEST_CASE_SIG("an ulp decides between miss, graze and hit", "[ray_sphere]", FLOATS_AND_DIMENSIONS) {
  const auto roots = [](S y) { return intersect<S, N>({at<S, N>(-3, y), at<S, N>(1)}, ball<S, N>()).line_roots; };
  CHECK(roots(std::nextafter(S(1), S(2))) == 0);
  CHECK(roots(S(1)) == 1);
  CHECK(roots(std::nextafter(S(1), S(0))) == 2);
}

TEMPLATE_TEST_CASE_SIG("a ray that passes by has nothing in common", "[ray_sphere]", FLOATS_AND_DIMENSIONS) {
  const RaySphere<S> r = intersect<S, N>({at<S, N>(-3, 2), at<S, N>(1)}, ball<S, N>());
  CHECK_FALSE(r);
  CHECK(r.line_roots == 0);
  CHECK(r.roots.lo > r.roots.hi);
  CHECK(r.origin == Location::out);
  CHECK_FALSE(r.surface);
}

TEMPLATE_TEST_CASE_SIG("a ray from inside leaves the ball once", "[ray_sphere]", FLOATS_AND_DIMENSIONS) {
  const RaySphere<S> r = intersect<S, N>({at<S, N>(0.5), at<S, N>(1)}, ball<S, N>());
  CHECK(r.line_roots == 2);
  CHECK(r.origin == Location::in);
  CHECK(r.surface == S(0.5));
  CHECK(r.solid == between<S>(0, 0.5));
  CHECK(r.roots == between<S>(-1.5, 0.5));
}

TEMPLATE_TEST_CASE_SIG("a sphere behind is met by the line, not by the ray", "[ray_sphere]", FLOATS_AND_DIMENSIONS) {
  Ray<S, N> ray = {at<S, N>(3), at<S, N>(1)};
  const RaySphere<S> r = intersect<S, N>(ray, ball<S, N>());
  CHECK_FALSE(r);
  CHECK(r.line_roots == 2);
  CHECK(r.roots == between<S>(-4, -2));
  CHECK_FALSE(r.surface);

  ray.range = infinite<S>;
  CHECK(intersect<S, N>(ray, ball<S, N>()).surface == S(-4));
  CHECK(intersect<S, N>(ray, ball<S, N>()).solid == between<S>(-4, -2));
}

TEMPLATE_TEST_CASE_SIG("a segment stops before, on, inside or behind the sphere", "[ray_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  const auto up_to = [](double hi) {
    return intersect<S, N>({at<S, N>(-3), at<S, N>(1), between<S>(0, hi)}, ball<S, N>());
  };
  CHECK_FALSE(up_to(1.5));
  CHECK(up_to(2).solid == between<S>(2, 2));
  CHECK(up_to(2).surface == S(2));
  CHECK(up_to(3).solid == between<S>(2, 3));
  CHECK(up_to(4).solid == between<S>(2, 4));
  CHECK(up_to(9).solid == between<S>(2, 4));
}

TEMPLATE_TEST_CASE_SIG("a segment within the ball meets the solid and not the surface", "[ray_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  const RaySphere<S> r = intersect<S, N>({at<S, N>(0), at<S, N>(1), between<S>(-0.5, 0.5)}, ball<S, N>());
  CHECK(r);
  CHECK_FALSE(r.surface);
  CHECK(r.solid == between<S>(-0.5, 0.5));
}

TEMPLATE_TEST_CASE_SIG("a range that starts at the exit holds that one point", "[ray_sphere]", FLOATS_AND_DIMENSIONS) {
  const RaySphere<S> r = intersect<S, N>({at<S, N>(-3), at<S, N>(1), between<S>(4, inf)}, ball<S, N>());
  CHECK(r.surface == S(4));
  CHECK(r.solid == between<S>(4, 4));
}

TEMPLATE_TEST_CASE_SIG("an origin on the surface is a hit at t = 0, whatever the heading", "[ray_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  const auto heading = [](double x, double y) { return intersect<S, N>({at<S, N>(-1), at<S, N>(x, y)}, ball<S, N>()); };

  const RaySphere<S> in = heading(1, 0), out = heading(-1, 0), along = heading(0, 1);
  for (const RaySphere<S>& r : {in, out, along}) {
    CHECK(r.origin == Location::on);
    CHECK(r.surface == S(0));
  }
  CHECK(in.solid == between<S>(0, 2));
  CHECK(out.solid == between<S>(0, 0));
  CHECK(along.solid == between<S>(0, 0));
  CHECK(along.line_roots == 1);
}

TEMPLATE_TEST_CASE_SIG("a range of one point asks for that point", "[ray_sphere]", FLOATS_AND_DIMENSIONS) {
  const auto only = [](double t) {
    return intersect<S, N>({at<S, N>(-3), at<S, N>(1), between<S>(t, t)}, ball<S, N>());
  };
  CHECK(only(2).surface == S(2));
  CHECK(only(2).solid == between<S>(2, 2));
  CHECK(only(3).solid == between<S>(3, 3));
  CHECK_FALSE(only(3).surface);
  CHECK_FALSE(only(1));
}

TEMPLATE_TEST_CASE_SIG("an empty range meets nothing, but the line and the origin keep their answers", "[ray_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  const RaySphere<S> r = intersect<S, N>({at<S, N>(0), at<S, N>(1), between<S>(1, -1)}, ball<S, N>());
  CHECK_FALSE(r);
  CHECK_FALSE(r.surface);
  CHECK(r.line_roots == 2);
  CHECK(r.roots == between<S>(-1, 1));
  CHECK(r.origin == Location::in);
}

TEMPLATE_TEST_CASE_SIG("a sphere of radius 0 is a point", "[ray_sphere]", FLOATS_AND_DIMENSIONS) {
  const RaySphere<S> through = intersect<S, N>({at<S, N>(-3), at<S, N>(1)}, ball<S, N>(0));
  CHECK(through.line_roots == 1);
  CHECK(through.solid == between<S>(3, 3));
  CHECK_FALSE(intersect<S, N>({at<S, N>(-3, std::numeric_limits<S>::denorm_min()), at<S, N>(1)}, ball<S, N>(0)));
  CHECK(intersect<S, N>({at<S, N>(0), at<S, N>(1)}, ball<S, N>(-0.0)).surface == S(0));
}

TEMPLATE_TEST_CASE_SIG("a sphere of negative radius is empty", "[ray_sphere]", FLOATS_AND_DIMENSIONS) {
  const RaySphere<S> r = intersect<S, N>({at<S, N>(-3), at<S, N>(1)}, ball<S, N>(-1));
  CHECK_FALSE(r);
  CHECK(r.line_roots == 0);
}

TEMPLATE_TEST_CASE_SIG("ray and sphere: a zero direction makes the ray a point", "[ray_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  const auto point = [](double x, const Interval<S>& range = semi_infinite<S>) {
    return intersect<S, N>({at<S, N>(x), at<S, N>(0, -0.0), range}, ball<S, N>());
  };
  CHECK(point(0.5).origin == Location::in);
  CHECK(point(0.5).solid == semi_infinite<S>);
  CHECK_FALSE(point(0.5).surface);
  CHECK(point(1).origin == Location::on);
  CHECK(point(1).surface == S(0));
  CHECK(point(1).solid == semi_infinite<S>);
  CHECK(point(2).origin == Location::out);
  CHECK_FALSE(point(2));
  CHECK_FALSE(point(0.5, between<S>(1, -1)));
  const S infinity = std::numeric_limits<S>::infinity();
  CHECK_FALSE(point(0.5, {infinity, infinity}));  // no real t
  CHECK_FALSE(point(1, {-infinity, -infinity}));
  CHECK(point(0.5).line_roots == 0);
  CHECK(point(0.5).roots.lo > point(0.5).roots.hi);
}

TEMPLATE_TEST_CASE_SIG("minus zero is zero", "[ray_sphere]", FLOATS_AND_DIMENSIONS) {
  const RaySphere<S> r =
      intersect<S, N>({at<S, N>(-1, -0.0), at<S, N>(-1, -0.0), between<S>(-0.0, -0.0)}, ball<S, N>());
  CHECK(r.surface == S(0));
  CHECK(r.solid == between<S>(0, 0));
}

TEMPLATE_TEST_CASE_SIG("NaN and infinite coordinates never hit", "[ray_sphere]", FLOATS_AND_DIMENSIONS) {
  for (const S bad : {static_cast<S>(not_a_number), static_cast<S>(inf), static_cast<S>(-inf)}) {
    const Ray<S, N> good = {at<S, N>(-3), at<S, N>(1)};
    for (int i = 0; i < N; ++i) {
      Ray<S, N> origin = good, direction = good;
      Sphere<S, N> center = ball<S, N>();
      origin.origin[i] = bad, direction.direction[i] = bad, center.center[i] = bad;
      CHECK_FALSE(intersect<S, N>(origin, ball<S, N>()));
      CHECK_FALSE(intersect<S, N>(direction, ball<S, N>()));
      CHECK_FALSE(intersect<S, N>(good, center));
    }
    CHECK_FALSE(intersect<S, N>(good, {at<S, N>(0), bad}));
  }
}

TEMPLATE_TEST_CASE_SIG("NaN at an end of the range never hits", "[ray_sphere]", FLOATS_AND_DIMENSIONS) {
  for (const double x : {-3.0, 0.0, -1.0}) {
    CHECK_FALSE(intersect<S, N>({at<S, N>(x), at<S, N>(1), between<S>(not_a_number, inf)}, ball<S, N>()));
    CHECK_FALSE(intersect<S, N>({at<S, N>(x), at<S, N>(1), between<S>(0, not_a_number)}, ball<S, N>()));
    CHECK_FALSE(intersect<S, N>({at<S, N>(x), at<S, N>(0), between<S>(0, not_a_number)}, ball<S, N>()));
  }
}

TEMPLATE_TEST_CASE_SIG("the range may be infinite at either end, and beyond every t is nothing", "[ray_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  const auto over = [](double lo, double hi) {
    return intersect<S, N>({at<S, N>(3), at<S, N>(1), between<S>(lo, hi)}, ball<S, N>());
  };
  CHECK(over(-inf, -2).solid == between<S>(-4, -2));
  CHECK(over(-inf, inf).solid == between<S>(-4, -2));
  CHECK_FALSE(over(inf, inf));
  CHECK_FALSE(over(-inf, -inf));
}

TEMPLATE_TEST_CASE_SIG("directions of any length give the same verdict", "[ray_sphere]", FLOATS_AND_DIMENSIONS) {
  constexpr int most = std::numeric_limits<S>::max_exponent - 4;
  for (const int e : {-most, -most / 2, 0, most / 2, most}) {
    const RaySphere<S> r = intersect<S, N>({at<S, N>(-3), at<S, N>(std::ldexp(1.0, e))}, ball<S, N>());
    CHECK(r.line_roots == 2);
    CHECK(r.roots == between<S>(std::ldexp(2.0, -e), std::ldexp(4.0, -e)));
  }
}

TEMPLATE_TEST_CASE_SIG("ray and sphere: lengths of any size give the same verdict", "[ray_sphere]",
                       FLOATS_AND_DIMENSIONS) {
  constexpr int most = std::numeric_limits<S>::max_exponent - 4;
  for (const int e : {-most, -most / 2, most / 2, most}) {
    const double k = std::ldexp(1.0, e);
    CHECK(intersect<S, N>({at<S, N>(-3 * k), at<S, N>(k)}, ball<S, N>(k)).roots == between<S>(2, 4));
    CHECK(intersect<S, N>({at<S, N>(-3 * k, k), at<S, N>(k)}, ball<S, N>(k)).line_roots == 1);
    CHECK_FALSE(intersect<S, N>({at<S, N>(-3 * k, 2 * k), at<S, N>(k)}, ball<S, N>(k)));
  }
}

TEMPLATE_TEST_CASE_SIG("a hit too far for the scalar is a hit at infinity", "[ray_sphere]", FLOATS_AND_DIMENSIONS) {
  const double huge = std::numeric_limits<S>::max() / 8, tiny = std::numeric_limits<S>::min();
  const RaySphere<S> r = intersect<S, N>({at<S, N>(-huge), at<S, N>(tiny)}, ball<S, N>());
  CHECK(r);
  CHECK(r.surface == static_cast<S>(inf));
  CHECK(r.line_roots == 2);
}

TEST_CASE("the published hard cases are decided rightly in float", "[ray_sphere]") {
  using R = Ray<float, 3>;
  CHECK_FALSE(intersect<float, 3>(R{{0, 0, 0}, {0, 0, 1}}, {{1.5f, 0, 5000}, 1}));
  CHECK(intersect<float, 3>(R{{0, 0, 0}, {0, 0, 1}}, {{0.5f, 0, 4100}, 1}).surface == 4099.13397f);
  CHECK(intersect<float, 3>(R{{0.1f, 0, -10}, {0, 0, 1}}, {{0, 0, 0}, 0.1f}).line_roots == 1);
  CHECK(intersect<float, 3>(R{{-400, 0.095f, 0}, {1, 0, 0}}, {{0, 0, 0}, 0.1f}).line_roots == 2);
  CHECK(intersect<float, 3>(R{{0, 0, -3}, {0, 0, 1e20f}}, {{0, 0, 0}, 1}).surface == Approx(2e-20f));
  CHECK(intersect<float, 3>(R{{0, 0, -3}, {0, 0, 1e-23f}}, {{0, 0, 0}, 1}).surface == Approx(2e23f));
  const R low = {{1000, 2, 3000}, {0.6f, -0.0078125f, 0.8f}};
  CHECK(*intersect<float, 3>(low, {{0, -6371000, 0}, 6371000}).surface == Approx(380.8685).epsilon(1e-6));
}

TEST_CASE("the published hard cases are decided rightly in double", "[ray_sphere]") {
  using R = Ray<double, 3>;
  CHECK_FALSE(intersect<double, 3>(R{{0, 0, 0}, {0, 0, 1}}, {{1.5, 0, 1e8}, 1}));
  CHECK(intersect<double, 3>(R{{0, 0, 0}, {0, 0, 1}}, {{0.5, 0, 1e8}, 1}).line_roots == 2);
  const RaySphere<double> centre = intersect<double, 3>(R{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, 2});
  CHECK(centre.roots == Interval<double>{-2, 2});  // B = 0: a sign of 0 must not lose the roots
}

TEST_CASE("the events tell the signs and the values, and each fallback", "[ray_sphere]") {
  Record<ray_sphere::Event> record;
  intersect<double, 3>({{-3, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, 1}, record);
  REQUIRE(record.events.size() == 2);
  const auto& decision = std::get<ray_sphere::Decision>(record.events[0]);
  CHECK(decision.a == 1);
  CHECK(decision.c == 8);
  CHECK(decision.discriminant == 1);
  CHECK(decision.verdict.line_roots == 2);
  CHECK(std::get<ray_sphere::Values>(record.events[1]).roots == Interval<double>{2, 4});

  record.events.clear();
  intersect<double, 3>({{-3, 1, 0}, {1, 0, 0}}, {{0, 0, 0}, 1}, record);
  CHECK(std::holds_alternative<Fallback>(record.events.front()));
  CHECK(std::get<ray_sphere::Decision>(*(record.events.end() - 2)).verdict.line_roots == 1);
  CHECK(std::get<ray_sphere::Values>(record.events.back()).roots == Interval<double>{3, 3});
}

}  // namespace ray_sphere_test
