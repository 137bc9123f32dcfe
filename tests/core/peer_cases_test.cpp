// Rays and spheres of public test suites judge the core, and the oracle of the other tests too.

#include "tests/peer_cases.h"

#include "bench/oracle.h"
#include "core/ray_sphere.h"
#include "tests/catch.h"

namespace peer_cases_test {
using namespace isect;
using isect::tests::peer_cases;
using Json = nlohmann::json;

namespace {

/// Two-dimensional cases lie in the plane z = 0.
Vector<double, 3> vector(const Json& json) {
  Vector<double, 3> v = Vector<double, 3>::Zero();
  for (std::size_t i = 0; i < json.size(); ++i) v[static_cast<int>(i)] = tests::peer_number(json[i]);
  return v;
}

Location location(const std::string& name) {
  return name == "in" ? Location::in : name == "on" ? Location::on : Location::out;
}

double ulps(double x, double expected) { return oracle::ulps(x, oracle::Real{expected, 0}); }

/// The answer over t >= 0 and over [0, 1] against the file's; both kinds of answer have the same members
/// there.
struct Answer {
  int line_roots;
  Location origin;
  double t0, t1;
  std::optional<double> surface, enter;
};

Answer core(const Ray<double, 3>& ray, const Sphere<double, 3>& sphere) {
  const RaySphere<double> r = intersect(ray, sphere);
  return {r.line_roots, r.origin,  r.roots.lo,
          r.roots.hi,   r.surface, r.solid ? std::optional(r.solid->lo) : std::nullopt};
}

Answer truth(const Ray<double, 3>& ray, const Sphere<double, 3>& sphere) {
  const oracle::RaySphere r = oracle::ray_sphere(ray, sphere);
  const auto value = [](const std::optional<oracle::Real>& x) {
    return x ? std::optional(x->nearest) : std::nullopt;
  };
  return {r.line_roots, r.origin, r.t0.nearest, r.t1.nearest, value(r.surface), value(r.enter)};
}

template <class Solve>
void check(const Json& c, const Solve& solve, double allowed_ulps) {
  Ray<double, 3> ray = {vector(c.at("origin")), vector(c.at("dir"))};
  ray.range = {c.contains("tmin") ? tests::peer_number(c["tmin"]) : 0,
               c.contains("tmax") ? tests::peer_number(c["tmax"]) : std::numeric_limits<double>::infinity()};
  const Sphere<double, 3> sphere = {vector(c.at("center")), tests::peer_number(c.at("radius"))};
  const Json& expected = c.at("expected");
  const Answer answer = solve(ray, sphere);
  if (expected.contains("policy")) {
    CHECK_FALSE(answer.enter);
    return;
  }

  const auto value = [&](const char* key, const std::optional<double>& x) {
    if (!expected.contains(key)) return;
    CHECK(x.has_value() == !expected[key].is_null());
    if (x && !expected[key].is_null()) CHECK(ulps(*x, tests::peer_number(expected[key])) <= allowed_ulps);
  };
  CHECK(answer.line_roots == expected.at("line_roots"));
  CHECK(answer.enter.has_value() == expected.at("ray_hit"));
  CHECK(answer.origin == location(expected.at("origin")));
  value("t_first_surface", answer.surface);
  value("t_enter_solid", answer.enter);
  if (answer.line_roots > 0) {
    value("t0", answer.t0);
    value("t1", answer.t1);
  }
  if (expected.contains("segment_hit_0_1")) {
    ray.range = {0, 1};
    CHECK(solve(ray, sphere).enter.has_value() == expected["segment_hit_0_1"]);
  }
}

}  // namespace

TEST_CASE("rays and spheres of public test suites get the true answers", "[ray_sphere][peer]") {
  const auto found = peer_cases("ray_sphere");
  if (found.empty()) WARN(tests::no_peer_cases());
  for (const auto& c : found) {
    INFO(c.name << ": " << c.content);
    check(c.content, core, 4);
  }
}

TEST_CASE("the oracle agrees with public test suites to the last bit", "[oracle][peer]") {
  const auto found = peer_cases("ray_sphere");
  if (found.empty()) WARN(tests::no_peer_cases());
  for (const auto& c : found) {
    INFO(c.name << ": " << c.content);
    check(c.content, truth, 0);
  }
}

}  // namespace peer_cases_test
