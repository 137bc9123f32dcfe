// Rays and spheres of the project's own cases and of public test suites judge the core, and the oracle of the other
// tests too. The files of the former are compared with what their generator writes.

#include "tests/peer_cases.h"

#include <set>
#include <sstream>

#include <isect/ray_sphere.h>
#include "bench/oracle.h"
#include "tests/cases/case_file.h"
#include "tests/catch.h"

namespace peer_cases_test {
using namespace isect;
using Json = nlohmann::json;

namespace {

/// Two-dimensional cases lie in the plane z = 0.
Vector<double, 3> vector(const Json& json, bool f32) {
  Vector<double, 3> v = Vector<double, 3>::Zero();
  for (std::size_t i = 0; i < json.size(); ++i) v[static_cast<int>(i)] = tests::peer_number(json[i], f32);
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
  const auto value = [](const std::optional<oracle::Real>& x) { return x ? std::optional(x->nearest) : std::nullopt; };
  return {r.line_roots, r.origin, r.t0.nearest, r.t1.nearest, value(r.surface), value(r.enter)};
}

template <class Solve>
void check(const Json& c, const Solve& solve, double allowed_ulps) {
  const bool f32 = tests::asks_for_floats(c);
  Ray<double, 3> ray = {vector(c.at("origin"), f32), vector(c.at("dir"), f32)};
  if (c.contains("tmin")) ray.range.lo = tests::peer_number(c["tmin"], f32);
  if (c.contains("tmax")) ray.range.hi = tests::peer_number(c["tmax"], f32);
  const Sphere<double, 3> sphere = {vector(c.at("center"), f32), tests::peer_number(c.at("radius"), f32)};
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

TEST_CASE("rays and spheres of every set of cases get the true answers", "[ray_sphere][peer]") {
  for (const auto& c : tests::all_cases("ray_sphere")) {
    INFO(c.name << ": " << c.content);
    check(c.content, core, 4);
  }
}

TEST_CASE("the oracle agrees with every set of cases to the last bit", "[oracle][peer]") {
  for (const auto& c : tests::all_cases("ray_sphere")) {
    INFO(c.name << ": " << c.content);
    check(c.content, truth, 0);
  }
}

TEST_CASE("the project's cases are what their generator writes", "[peer]") {
  std::size_t bytes = 0;
  std::set<std::filesystem::path> written;
  for (const cases::CaseFile& file : cases::all()) {
    const std::filesystem::path path = tests::own_cases() / (file.kind() + ".json");
    std::ostringstream kept;
    kept << std::ifstream(path, std::ios::binary).rdbuf();
    const std::string text = file.text();
    INFO(path << ": write it again by the target make_cases, and look at what changed");
    CHECK((kept.str() == text));
    CHECK(file.size() >= 30);
    CHECK(text.size() < 100'000);
    bytes += text.size();
    written.insert(path);
  }
  CHECK(bytes < 1'000'000);
  for (const auto& entry : std::filesystem::directory_iterator(tests::own_cases()))
    if (entry.path().extension() == ".json") CHECK(written.contains(entry.path()));
}

}  // namespace peer_cases_test
