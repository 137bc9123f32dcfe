// The note's three methods: right on ordinary rays, and wrong where rounding must defeat them.

#include <isect/methods/ray_sphere.h>

#include <cmath>

#include "bench/ray_sphere/judge.h"
#include "tests/catch.h"
#include "tests/core/common.h"
#include "tests/settings.h"

namespace ray_sphere_methods_test {
using namespace isect;
using namespace isect::bench;
using ray_sphere::haines;
using ray_sphere::half_b;
using ray_sphere::quadratic;
using tests::not_a_number;

namespace {

template <class S, int N>
Ray<S, N> along_x(double x, double y = 0, Interval<S> range = semi_infinite<S>) {
  Ray<S, N> ray = {Point<S, N>::Zero(), Vector<S, N>::Unit(0), range};
  ray.origin[0] = static_cast<S>(x), ray.origin[1] = static_cast<S>(y);
  return ray;
}

template <class S, int N>
const Sphere<S, N> unit_sphere = {Point<S, N>::Zero(), S(1)};

/// Calls check(method) for each of the three.
template <class S, int N, class Check>
void for_each_method(const Check& check) {
  check("quadratic", [](const auto& ray, const auto& sphere) { return quadratic<S, N>(ray, sphere); });
  check("half_b", [](const auto& ray, const auto& sphere) { return half_b<S, N>(ray, sphere); });
  check("haines", [](const auto& ray, const auto& sphere) { return haines<S, N>(ray, sphere); });
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("all three methods find the first surface point", "[ray_sphere_methods]",
                       FLOATS_AND_DIMENSIONS) {
  for_each_method<S, N>([](const char* name, const auto& method) {
    INFO(name);
    const Sphere<S, N> ball = unit_sphere<S, N>;
    CHECK(method(along_x<S, N>(-3), ball) == S(2));
    CHECK(method(along_x<S, N>(-3, 1), ball) == S(3));
    CHECK_FALSE(method(along_x<S, N>(-3, 1.5), ball));
    CHECK(method(along_x<S, N>(0.5), ball) == S(0.5));
    CHECK_FALSE(method(along_x<S, N>(3), ball));
  });
}

TEMPLATE_TEST_CASE_SIG("the closed range decides, where the note takes the smallest positive root",
                       "[ray_sphere_methods]", FLOATS_AND_DIMENSIONS) {
  for_each_method<S, N>([](const char* name, const auto& method) {
    INFO(name);
    const Sphere<S, N> ball = unit_sphere<S, N>;
    CHECK_FALSE(method(along_x<S, N>(-3, 0, {S(0), S(1.5)}), ball));
    CHECK(method(along_x<S, N>(-3, 0, {S(0), S(2)}), ball) == S(2));
    CHECK_FALSE(method(along_x<S, N>(0, 0, {S(0), S(0.5)}), ball));
  });
}

TEMPLATE_TEST_CASE_SIG("an origin on the surface is a hit at t = 0 heading in and heading out", "[ray_sphere_methods]",
                       FLOATS_AND_DIMENSIONS) {
  for_each_method<S, N>([](const char* name, const auto& method) {
    INFO(name);
    CHECK(method(along_x<S, N>(-1), unit_sphere<S, N>) == S(0));
    CHECK(method(along_x<S, N>(1), unit_sphere<S, N>) == S(0));
  });
}

TEMPLATE_TEST_CASE_SIG("NaN misses, and so does a ray without direction outside", "[ray_sphere_methods]",
                       FLOATS_AND_DIMENSIONS) {
  for_each_method<S, N>([](const char* name, const auto& method) {
    INFO(name);
    for (int i = 0; i < N; ++i) {
      Ray<S, N> origin = along_x<S, N>(-3), direction = origin;
      Sphere<S, N> center = unit_sphere<S, N>;
      origin.origin[i] = direction.direction[i] = center.center[i] = static_cast<S>(not_a_number);
      CHECK_FALSE(method(origin, unit_sphere<S, N>));
      CHECK_FALSE(method(direction, unit_sphere<S, N>));
      CHECK_FALSE(method(along_x<S, N>(-3), center));
    }
    CHECK_FALSE(method(along_x<S, N>(-3), Sphere<S, N>{Point<S, N>::Zero(), static_cast<S>(not_a_number)}));
    Ray<S, N> point = along_x<S, N>(-3);
    point.direction.setZero();
    CHECK_FALSE(method(point, unit_sphere<S, N>));
  });
}

TEMPLATE_TEST_CASE_SIG("the quadratic forms take a direction of any length", "[ray_sphere_methods]",
                       FLOATS_AND_DIMENSIONS) {
  Ray<S, N> ray = along_x<S, N>(-3);
  ray.direction *= S(0.25);
  CHECK(quadratic(ray, unit_sphere<S, N>) == S(8));
  CHECK(half_b(ray, unit_sphere<S, N>) == S(8));
}

TEMPLATE_TEST_CASE_SIG("on ordinary rays the methods agree with the truth", "[ray_sphere_methods][property]",
                       FLOATS_AND_DIMENSIONS) {
  Random random(stream(tests::seed(), "methods"));
  const S tolerance = 1000 * std::numeric_limits<S>::epsilon();
  int judged = 0;
  for (int i = 0; i < 5000; ++i) {
    const RaySphereCase<S, N> c = ray_sphere_family<S, N>("ordinary").draw(random);
    const oracle::RaySphere truth = oracle::ray_sphere(c.ray, c.sphere);
    const bool grazes = truth.line_roots > 0 && truth.t1.nearest - truth.t0.nearest < 0.05;
    const bool near_surface =
        truth.line_roots > 0 && std::min(std::abs(truth.t0.nearest), std::abs(truth.t1.nearest)) < 0.05;
    Sphere<S, N> wider = c.sphere;
    wider.radius *= S(1.001);
    const bool barely_misses = truth.line_roots == 0 && oracle::ray_sphere(c.ray, wider).line_roots > 0;
    if (grazes || near_surface || barely_misses) continue;

    ++judged;
    for_each_method<S, N>([&](const char* name, const auto& method) {
      INFO(name << ", ISECT_SEED=" << tests::seed() << ": " << text(c));
      const std::optional<S> t = method(c.ray, c.sphere);
      REQUIRE(t.has_value() == truth.surface.has_value());
      if (t) REQUIRE(std::abs(*t - static_cast<S>(truth.surface->nearest)) <= tolerance * (1 + *t));
    });
  }
  CHECK(judged > 4000);
}

// What follows is wrong, and known to be: the cases that the robustness pages show.

TEST_CASE("a float quadratic hits a sphere that the ray misses by half a radius", "[ray_sphere_methods][failure]") {
  const Ray<float, 3> ray = {{0, 0, 0}, {0, 0, 1}};
  const Sphere<float, 3> sphere = {{1.5f, 0, 5000}, 1};
  REQUIRE_FALSE(oracle::ray_sphere(ray, sphere).surface);
  CHECK(quadratic(ray, sphere));
  CHECK(half_b(ray, sphere));
}

TEST_CASE("a double quadratic does the same at 10^8", "[ray_sphere_methods][failure]") {
  const Ray<double, 3> ray = {{0, 0, 0}, {0, 0, 1}};
  const Sphere<double, 3> sphere = {{1.5, 0, 1e8}, 1};
  REQUIRE_FALSE(oracle::ray_sphere(ray, sphere).surface);
  CHECK(quadratic(ray, sphere));
  CHECK(half_b(ray, sphere));
}

TEST_CASE("far away the first hit is off by nearly a radius", "[ray_sphere_methods][failure]") {
  const Ray<float, 3> ray = {{0, 0, 0}, {0, 0, 1}};
  const Sphere<float, 3> sphere = {{0.5f, 0, 4100}, 1};
  CHECK(oracle::ray_sphere(ray, sphere).surface->nearest == Approx(4099.1339746).epsilon(1e-12));
  CHECK(quadratic(ray, sphere) == 4100.0f);
  CHECK(half_b(ray, sphere) == 4100.0f);
  CHECK(haines(ray, sphere) == 4099.0f);
}

TEST_CASE("above a planet no float method comes close", "[ray_sphere_methods][failure]") {
  const Ray<float, 3> ray = {{1000, 2, 3000}, {0.6f, -0.0078125f, 0.8f}};
  const Sphere<float, 3> sphere = {{0, -6371000, 0}, 6371000};
  const double truth = oracle::ray_sphere(ray, sphere).surface->nearest;
  CHECK(truth == Approx(380.8685).epsilon(1e-6));
  for_each_method<float, 3>([&](const char* name, const auto& method) {
    INFO(name);
    const std::optional<float> t = method(ray, sphere);
    CHECK(std::abs(t.value_or(0) - truth) > 1);
  });
}

TEST_CASE("Haines' method misses an exact tangent", "[ray_sphere_methods][failure]") {
  const Ray<float, 3> ray = {{0.1f, 0, -10}, {0, 0, 1}};
  const Sphere<float, 3> sphere = {{0, 0, 0}, 0.1f};
  REQUIRE(oracle::ray_sphere(ray, sphere).line_roots == 1);
  CHECK_FALSE(haines(ray, sphere));
}

TEST_CASE("squares of long and short directions overflow and vanish", "[ray_sphere_methods][failure]") {
  const Sphere<float, 3> sphere = {{0, 0, 0}, 1};
  for (const float length : {1e20f, 1e-23f}) {
    const Ray<float, 3> ray = {{0, 0, -3}, {0, 0, length}};
    const double truth = oracle::ray_sphere(ray, sphere).surface->nearest;
    CHECK(truth == Approx(2.0 / length));
    for_each_method<float, 3>([&](const char* name, const auto& method) {
      INFO(name);
      const std::optional<float> t = method(ray, sphere);
      CHECK_FALSE((t && std::abs(*t - truth) < 0.5 * truth));
    });
  }
}

TEST_CASE("Haines' method needs unit length", "[ray_sphere_methods][failure]") {
  Ray<double, 3> ray = along_x<double, 3>(-3);
  ray.direction *= 2;
  CHECK(oracle::ray_sphere(ray, unit_sphere<double, 3>).surface->nearest == 1);
  CHECK(haines(ray, unit_sphere<double, 3>) != 1.0);
}

TEST_CASE("the events are the lines of the pseudocode, in order", "[ray_sphere_methods]") {
  using namespace ray_sphere;
  Record<QuadraticEvent<double, 3>> record;
  half_b<double, 3>(along_x<double, 3>(-3), unit_sphere<double, 3>, record);
  REQUIRE(record.events.size() == 10);
  CHECK(std::get<FromCenter<double, 3>>(record.events[0]).f[0] == -3);
  CHECK(std::get<CoefficientB<double>>(record.events[2]).b == -3);
  CHECK(std::get<Discriminant<double>>(record.events[4]).d == 1);
  CHECK_FALSE(std::get<LineMisses<double>>(record.events[5]).holds);
  CHECK(std::get<Root<double>>(record.events[7]).t == 4);
  CHECK(std::get<RootInRange<double>>(record.events[8]).holds);
  CHECK(std::get<ray_sphere::Hit<double>>(record.events[9]).t == 2);
}

TEST_CASE("Haines' events end with the line that decided", "[ray_sphere_methods]") {
  using namespace ray_sphere;
  const auto last = [](const Ray<double, 3>& ray) {
    Record<HainesEvent<double, 3>> record;
    haines<double, 3>(ray, unit_sphere<double, 3>, record);
    return std::pair(*(record.events.end() - 2), record.events.back());
  };
  CHECK(std::get<Behind<double>>(last(along_x<double, 3>(3)).first).holds);
  CHECK(std::get<PassesBy<double>>(last(along_x<double, 3>(-3, 2)).first).holds);
  CHECK(std::get<TooFar<double>>(last(along_x<double, 3>(-3, 0, {0, 1})).first).holds);
  CHECK(std::holds_alternative<Reject>(last(along_x<double, 3>(3)).second));
  CHECK(std::get<Intersect<double, 3>>(last(along_x<double, 3>(-3)).second).p[0] == -1);
}

TEMPLATE_TEST_CASE_SIG("listening changes no answer of the methods", "[ray_sphere_methods][property]",
                       FLOATS_AND_DIMENSIONS) {
  Random random(stream(tests::seed(), "methods"));
  for (int i = 0; i < 2000; ++i) {
    const RaySphereCase<S, N> c = ray_sphere_family<S, N>("nudged").draw(random);
    Record<ray_sphere::QuadraticEvent<S, N>> record;
    Record<ray_sphere::HainesEvent<S, N>> steps;
    REQUIRE(quadratic(c.ray, c.sphere, record) == quadratic(c.ray, c.sphere));
    REQUIRE(half_b(c.ray, c.sphere, record) == half_b(c.ray, c.sphere));
    REQUIRE(haines(c.ray, c.sphere, steps) == haines(c.ray, c.sphere));
  }
}

}  // namespace ray_sphere_methods_test
