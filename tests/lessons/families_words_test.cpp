// What the lesson on speed and error says of its families: each that carries a result is explained, and what a
// convention decides is not called an error of rounding.

#include <set>

#include <isect/methods/sphere_aabb.h>
#include <isect/methods/sphere_sphere.h>
#include "bench/prose.h"
#include "bench/rows.h"
#include "lessons/speed_against_error/results.h"
#include "lessons/speed_against_error/telling.h"
#include "tests/lessons/texts.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"

namespace families_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;
using isect::test::Contains;
using lessons::speed_against_error_lesson::results;

namespace {

const Lesson& speed() { return lesson("speed-against-error"); }

/// The hard families of a test that the naive method was measured on.
std::vector<std::string> hard_families(const std::string& test) {
  std::vector<std::string> all;
  for (const std::string& family : bench::families_of(bench::rows_of(results(), test, "double"))) {
    const bench::Row* naive = bench::standard_of(bench::rows_of(results(), test, "double", family));
    if (naive != nullptr && naive->hard) all.push_back(family);
  }
  return all;
}

}  // namespace

TEST_CASE("every hard family is explained before its results are compared", "[words]") {
  for (const Preset& p : speed().presets) {
    const Walk walk = speed().walk(p.parameters);
    std::string told;
    for (const Step& s : walk.steps) {
      if (s.slug == "wrong-verdicts" || s.slug == "cost") break;
      told += s.title + ". " + plain(s.caption) + "\n";
    }
    for (const std::string& family : hard_families(p.id)) {
      INFO(p.id << ", " << family << ":\n" << told);
      CHECK_THAT(told, Contains(bench::sentence(bench::words(family))));
      CHECK_FALSE(results().note(p.id, family).empty());
    }
    const Step* const others = find(walk, "other-families");
    CHECK((others != nullptr) == (hard_families(p.id).size() > 3));
    if (others == nullptr) continue;
    const auto lines = std::ranges::count(others->caption, '\n') + 1;
    CHECK(static_cast<std::size_t>(lines) == hard_families(p.id).size() - 3);
  }
  const Walk rays = speed().walk(preset(speed(), "ray-sphere").parameters);
  const Step& others = *find(rays, "other-families");
  CHECK_THAT(others.caption, Contains("Exact tangent: rays that touch the ball in exactly one point.") &&
                                 Contains("Direction length: ") && Contains("On surface: ") &&
                                 Contains("Zero radius: balls that are points."));
}

TEST_CASE("a family that is the same as another but for its place is told with the other one", "[words]") {
  int told = 0;
  for (const Preset& p : speed().presets)
    for (const Step& s : speed().walk(p.parameters).steps) {
      INFO(p.id << ", " << s.slug << ": " << s.caption);
      const std::size_t at = s.caption.find("the same at");
      if (at != std::string::npos) CHECK(s.slug == "other-families");
      if (at != std::string::npos) CHECK(s.caption.rfind('\n', at) != std::string::npos);  // after the other one
      CHECK_THAT(s.caption, !Contains("The same at"));
      told += at != std::string::npos || says(s.caption, "As “") || says(s.caption, ": as “");
    }
  CHECK(told > 0);
}

TEST_CASE("every hard family has a picture of one of its cases, under its name", "[words]") {
  for (const Preset& p : speed().presets) {
    const Walk walk = speed().walk(p.parameters);
    const Step* const step = find(walk, "typical");
    REQUIRE(step);
    std::vector<std::string> named;
    int drawn = 0;
    for (const Item& item : step->scene.items) {
      const auto* heading = std::get_if<Heading>(&item);
      if (heading && heading->bold) named.push_back(plain(heading->text));
      drawn += heading == nullptr;
    }
    const std::vector<std::string> families = hard_families(p.id);
    CHECK(named.size() == families.size());
    CHECK(drawn >= static_cast<int>(families.size()));
    for (const std::string& family : families) {
      INFO(p.id << ", " << family);
      CHECK(std::ranges::count(named, bench::sentence(bench::words(family))) == 1);
    }
  }
}

TEST_CASE("a strict comparison leaves out touching by convention, and the lesson says so", "[words]") {
  for (const char* test : {"sphere-sphere", "sphere-aabb"}) {
    const Walk walk = speed().walk(preset(speed(), test).parameters);
    INFO(test);
    CHECK_THAT(find(walk, "exact-touch")->caption, Contains("100 % wrong") && Contains("by convention"));
    const std::string fails = plain(find(walk, "wrong-verdicts")->caption);
    CHECK_THAT(fails, Contains("On “exact touch”") && Contains("by convention") && !Contains("100 %"));
  }
  for (const Preset& p : speed().presets) {
    const std::string fails = plain(find(speed().walk(p.parameters), "wrong-verdicts")->caption);
    const bool strict = p.id == "sphere-sphere" || p.id == "sphere-aabb";
    INFO(p.id << ": " << fails);
    CHECK(says(fails, "convention") == strict);
  }

  // Numbers that are exact in every step: what differs is < or ≤ alone.
  const Sphere<double, 3> a = {{0, 0, 0}, 2}, b = {{3, 4, 0}, 3};
  CHECK_FALSE(sphere_sphere::squared_distance_naive(a, b));
  CHECK(sphere_sphere::closed_squared_distance(a, b));
  const Sphere<double, 3> ball = {{-3, -4, 0}, 5};
  const Aabb<double, 3> box = {{0, 0, 0}, {1, 1, 1}};
  CHECK_FALSE(sphere_aabb::accumulate_naive(ball, box));
  CHECK(sphere_aabb::clamped(ball, box));
}

TEST_CASE("on ordinary cases it is the verdicts that are said to be right, as values differ", "[words]") {
  CHECK_THAT(speed().closing->result,
             Contains("On our ordinary cases all verdicts are right") && !Contains("all methods are right"));
  for (const bench::Row& r : results().rows)
    if (!r.hard) CHECK(r.wrong() == 0);
  const auto ordinary = bench::rows_of(results(), "ray-sphere", "double", "ordinary");
  std::set<double> errors;
  for (const bench::Row* r : ordinary)
    if (r->ulps) errors.insert(r->ulps->p99);
  CHECK(errors.size() > 1);
}

}  // namespace families_words_test
