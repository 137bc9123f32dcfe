// The lesson of points: its verdicts against rationals, which methods err where, and nearness that is not transitive.

#include <algorithm>
#include <map>

#include "bench/rational.h"
#include "lessons/lessons.h"
#include "lessons/points/picture.h"
#include "tests/catch.h"
#include "viz/walk/closing.h"

namespace points_test {
using namespace isect;
using namespace isect::lessons::points_lesson;
namespace viz = isect::viz;

namespace {

const viz::Lesson& lesson() {
  for (const viz::Lesson* l : lessons::all_lessons())
    if (l->id == "points") return *l;
  throw std::runtime_error("no such lesson");
}

viz::Walk walk_of(const std::string& id) { return lesson().walk(viz::preset(lesson(), id).parameters); }

/// The sign of |p - q|^2 - t^2.
int true_sign(const Point3& p, const Point3& q, double t) {
  const auto a = oracle::rational(p), b = oracle::rational(q);
  oracle::Rational sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  const oracle::Rational tolerance(t);
  return oracle::sign(oracle::Rational(sum - tolerance * tolerance));
}

}  // namespace

TEST_CASE("equality ends with what the numbers say, at the first axis that differs", "[points lesson]") {
  const std::map<std::string, std::pair<std::string, std::size_t>> expected = {
      {"copied", {"EQUAL", 5}},  // the opening, three axes, the verdict
      {"different", {"DIFFERENT", 4}},
      {"ten-steps", {"DIFFERENT", 3}},
      {"nan", {"DIFFERENT", 5}}};
  for (const auto& [id, what] : expected) {
    INFO(id);
    const viz::Walk walk = walk_of(id);
    CHECK(walk.steps.back().verdict.text == what.first);
    CHECK(viz::outcome(walk) + 1 == static_cast<int>(what.second));
  }
  CHECK_THAT(walk_of("copied").steps[2].caption, isect::test::Contains("−0"));
  CHECK_THAT(walk_of("ten-steps").steps[1].formula, isect::test::Contains("0.9999999999999999"));
}

TEST_CASE("nearness ends with the true sign, at every unit and wherever q is dragged", "[points lesson]") {
  int near = 0, far = 0;
  for (const viz::Preset& preset : lesson().presets) {
    if (preset.group != "near") continue;
    INFO(preset.id);
    viz::Parameters parameters = preset.parameters;
    for (int k = -1; k <= 8; ++k) {
      if (k >= 0) parameters["q"] = viz::Vec3(0.25 * k, 0.125 * k, -0.0625 * k);
      const Setup s(parameters);
      const bool truth = true_sign(s.tp, s.tq, s.tested_within) <= 0;
      ++(truth ? near : far);
      CHECK(lesson().walk(parameters).steps.back().verdict.text == (truth ? "NEAR" : "FAR"));
      const std::vector<viz::Opinion> opinions = lesson().opinions(parameters);
      REQUIRE(opinions.size() == 4);
      CHECK(opinions.front().says == (truth ? "near" : "far"));
    }
  }
  CHECK((near > 5 && far > 5));
}

TEST_CASE("each preset of nearness breaks the methods that it is made to break", "[points lesson]") {
  using Names = std::vector<std::string>;
  const std::map<std::string, Names> expected = {{"cube", {"coordinates"}},
                                                 {"on-sphere", {}},
                                                 {"rounding", {"squares", "distance", "coordinates"}},
                                                 {"overflow", {"distance"}},
                                                 {"underflow", {"squares", "distance", "coordinates"}}};
  for (const auto& [id, names] : expected) {
    INFO(id);
    Names wrong;
    for (const viz::Opinion& o : lesson().opinions(viz::preset(lesson(), id).parameters))
      if (!o.agrees) wrong.push_back(o.method);
    CHECK(wrong == names);
    int said = 0;
    for (const viz::Step& s : walk_of(id).steps) said += s.caption.find("and is wrong") != std::string::npos;
    CHECK(said == static_cast<int>(names.size()));
  }
}

TEST_CASE("only a point exactly on the sphere is said to lie on it", "[points lesson]") {
  const auto says = [](const char* id) {
    const viz::Walk walk = walk_of(id);
    return walk.steps[viz::outcome(walk)].caption;
  };
  CHECK_THAT(says("on-sphere"), isect::test::Contains("on the sphere"));
  CHECK_THAT(says("rounding"), !isect::test::Contains("on the sphere"));
  CHECK_THAT(says("cube"), !isect::test::Contains("on the sphere"));
}

TEST_CASE("a point with NaN is near to none, by any method", "[points lesson]") {
  viz::Parameters parameters = viz::preset(lesson(), "cube").parameters;
  parameters["z"] = std::string("NaN");
  parameters["q"] = viz::Vec3(0, 0, 0);
  for (const viz::Opinion& o : lesson().opinions(parameters)) CHECK(o.says == "far");
  CHECK(lesson().walk(parameters).steps.back().verdict.text == "FAR");
}

TEST_CASE("near to near need not be near, and the lesson tells when it is", "[points lesson]") {
  CHECK(walk_of("chain").steps.back().verdict.kind == viz::Verdict::Kind::no);
  viz::Parameters parameters = viz::preset(lesson(), "chain").parameters;
  const Setup s(parameters);
  CHECK(true_sign(s.tp, s.tq, 1) < 0);
  CHECK(true_sign(s.tq, s.tr, 1) < 0);
  CHECK(true_sign(s.tp, s.tr, 1) > 0);
  parameters["r"] = viz::Vec3(-0.5, 0, 0);
  CHECK(lesson().walk(parameters).steps.back().verdict.kind == viz::Verdict::Kind::yes);
}

}  // namespace points_test
