// Quadratics that cancel less: right where the textbook is, closer to the truth, and wrong all the same where B and C
// cancel.

#include <isect/methods/ray_sphere_stable.h>

#include <algorithm>
#include <cmath>

#include "bench/ray_sphere/judge.h"
#include "tests/catch.h"
#include "tests/settings.h"

namespace ray_sphere_stable_test {
using namespace isect;
using namespace isect::bench;
using ray_sphere::robust;
using ray_sphere::stable_roots;

namespace {

/// Calls check(name, method) for both.
template <class S, int N, class Check>
void for_each_method(const Check& check) {
  check("stable_roots", [](const auto& ray, const auto& sphere) { return stable_roots<S, N>(ray, sphere); });
  check("robust", [](const auto& ray, const auto& sphere) { return robust<S, N>(ray, sphere); });
}
template <class S, int N>
Ray<S, N> along_x(double x, double y = 0, Interval<S> range = semi_infinite<S>) {
  Ray<S, N> ray = {Point<S, N>::Zero(), Vector<S, N>::Unit(0), range};
  ray.origin[0] = static_cast<S>(x), ray.origin[1] = static_cast<S>(y);
  return ray;
}

/// Wrong verdicts and the median error of t in ulps over a family.
template <class S>
struct Score {
  int wrong = 0;
  double median = 0;
};
template <class S, class Method>
Score<S> score(const char* family, const Method& method) {
  Random random(stream(tests::seed(), family));
  Score<S> s;
  std::vector<double> errors;
  for (int i = 0; i < 2000; ++i) {
    const RaySphereCase<S, 3> c = ray_sphere_family<S, 3>(family).draw(random);
    const oracle::RaySphere truth = oracle::ray_sphere(c.ray, c.sphere);
    const std::optional<S> t = method(c.ray, c.sphere);
    s.wrong += t.has_value() != truth.surface.has_value();
    if (t && truth.surface) errors.push_back(oracle::ulps(*t, *truth.surface));
  }
  REQUIRE(errors.size() > 500);
  std::ranges::nth_element(errors, errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2));
  s.median = errors[errors.size() / 2];
  return s;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("both find the first surface point of the range", "[ray_sphere_stable]", FLOATS_AND_DIMENSIONS) {
  for_each_method<S, N>([](const char* name, const auto& method) {
    INFO(name);
    const Sphere<S, N> ball = {Point<S, N>::Zero(), S(1)};
    CHECK(method(along_x<S, N>(-3), ball) == S(2));
    CHECK(method(along_x<S, N>(-3, 1), ball) == S(3));
    CHECK_FALSE(method(along_x<S, N>(-3, 1.5), ball));
    CHECK(method(along_x<S, N>(0.5), ball) == S(0.5));
    CHECK(method(along_x<S, N>(0), ball) == S(1));   // B = 0
    CHECK(method(along_x<S, N>(-1), ball) == S(0));  // C = 0, heading in
    CHECK(method(along_x<S, N>(1), ball) == S(0));   // and out
    CHECK_FALSE(method(along_x<S, N>(3), ball));
    CHECK_FALSE(method(along_x<S, N>(-3, 0, {S(0), S(1.5)}), ball));
    CHECK(method(along_x<S, N>(-3, 0, {S(3), S(5)}), ball) == S(4));
    const Sphere<S, N> point = {Point<S, N>::Zero(), S(0)};
    CHECK(method(along_x<S, N>(-3), point) == S(3));  // both roots the same
    CHECK(method(along_x<S, N>(0), point) == S(0));   // and zero: no quotient of zeros
  });
}

TEMPLATE_TEST_CASE_SIG("directions of any length do, NaN and none at all miss", "[ray_sphere_stable]",
                       FLOATS_AND_DIMENSIONS) {
  for_each_method<S, N>([](const char* name, const auto& method) {
    INFO(name);
    const Sphere<S, N> ball = {Point<S, N>::Zero(), S(1)};
    Ray<S, N> ray = along_x<S, N>(-3);
    ray.direction *= S(0.25);
    CHECK(method(ray, ball) == S(8));
    ray.direction.setZero();
    CHECK_FALSE(method(ray, ball));
    ray = along_x<S, N>(-3);
    ray.origin[1] = std::numeric_limits<S>::quiet_NaN();
    CHECK_FALSE(method(ray, ball));
  });
}

TEMPLATE_TEST_CASE("they come closer to the truth than the textbook on ordinary rays", "[ray_sphere_stable]", float,
                   double) {
  using S = TestType;
  const Score<S> textbook =
      score<S>("ordinary", [](const auto& r, const auto& s) { return ray_sphere::quadratic(r, s); });
  const Score<S> better = score<S>("ordinary", [](const auto& r, const auto& s) { return robust(r, s); });
  CHECK(better.wrong <= textbook.wrong);
  CHECK(better.median <= textbook.median);
}

TEMPLATE_TEST_CASE("only the robust discriminant decides far away", "[ray_sphere_stable][failure]", float, double) {
  using S = TestType;
  CHECK(score<S>("far-small", [](const auto& r, const auto& s) { return stable_roots(r, s); }).wrong > 100);
  CHECK(score<S>("far-small", [](const auto& r, const auto& s) { return robust(r, s); }).wrong == 0);
}

TEMPLATE_TEST_CASE("both are wrong near tangency and beyond the range of squares", "[ray_sphere_stable][failure]",
                   float, double) {
  using S = TestType;
  for_each_method<S, 3>([](const char* name, const auto& method) {
    INFO(name);
    CHECK(score<S>("near-tangent", method).wrong > 0);
    CHECK(score<S>("direction-length", method).wrong > 100);
  });
}

TEST_CASE("they tell the lines of half-B", "[ray_sphere_stable]") {
  using Event = ray_sphere::QuadraticEvent<double, 3>;
  const Sphere<double, 3> ball = {{0, 0, 0}, 1};
  Record<Event> record;
  CHECK(stable_roots(along_x<double, 3>(-3), ball, record) == 2);
  REQUIRE(record.events.size() == 10);
  CHECK(std::get<ray_sphere::CoefficientB<double>>(record.events[2]).b == -3);
  CHECK(std::get<ray_sphere::Root<double>>(record.events[6]).t == 2);
  CHECK(std::get<ray_sphere::Root<double>>(record.events[7]).t == 4);
  record.events.clear();
  CHECK_FALSE(robust(along_x<double, 3>(-3, 2), ball, record));
  CHECK(std::holds_alternative<ray_sphere::Miss>(record.events.back()));
}

}  // namespace ray_sphere_stable_test
