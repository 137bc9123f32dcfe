#include <algorithm>
#include <map>

#include <isect/methods/ray_sphere.h>
#include <isect/ray_sphere.h>
#include "lessons/lessons.h"
#include "tests/catch.h"
#include "viz/compose/compose.h"
#include "viz/walk/closing.h"

namespace ray_sphere_test {
using namespace isect;
using namespace isect::viz;

namespace {

const Lesson& lesson() {
  for (const Lesson* l : lessons::all_lessons())
    if (l->id == "ray-sphere") return *l;
  throw std::runtime_error("no lesson ray-sphere");
}

Ray<double, 3> ray_of(const Parameters& p) {
  Ray<double, 3> ray = {std::get<Vec3>(p.at("origin")), std::get<Vec3>(p.at("direction"))};
  if (std::get<std::string>(p.at("extent")) == "segment") ray.range.hi = std::get<double>(p.at("t_max"));
  return ray;
}
Sphere<double, 3> ball_of(const Parameters& p) {
  return {std::get<Vec3>(p.at("center")), std::get<double>(p.at("radius"))};
}

}  // namespace

TEST_CASE("eleven situations stand ready for each of the three methods", "[ray-sphere lesson]") {
  std::map<std::string, int> by_method;
  for (const Preset& p : lesson().presets) ++by_method[p.group];
  CHECK(by_method == std::map<std::string, int>{{"haines", 11}, {"quadratic", 11}, {"half-b", 11}});
  for (const Preset& p : lesson().presets) CHECK_NOTHROW(validate(lesson(), p.parameters));
}

TEST_CASE("the presets are what their names say, exactly", "[ray-sphere lesson]") {
  const auto truth = [](const char* id) {
    const Parameters& p = preset(lesson(), id).parameters;
    return intersect(ray_of(p), ball_of(p));
  };
  CHECK(truth("two-roots").line_roots == 2);
  CHECK(truth("tangent").line_roots == 1);
  CHECK(truth("miss").line_roots == 0);
  CHECK(truth("inside").origin == Location::in);
  CHECK(truth("behind").roots.hi < 0);
  CHECK_FALSE(truth("segment-before"));
  CHECK(truth("segment-before").line_roots == 2);
  CHECK(truth("segment-inside").solid->hi == 2);
  CHECK(truth("surface-in").origin == Location::on);
  CHECK(truth("surface-in").roots.lo == 0);
  CHECK(truth("surface-out").origin == Location::on);
  CHECK(truth("surface-out").roots.hi == 0);
  for (const char* id : {"near-surface", "near-rounded"}) {
    CHECK(truth(id).origin == Location::out);
    CHECK(truth(id).roots.lo < 1e-10);
  }
}

TEST_CASE("just before the surface three methods lose digits that stable roots keep", "[ray-sphere lesson]") {
  for (const Preset& p : lesson().presets) {
    INFO(p.id);
    if (p.id.starts_with("near-rounded")) continue;  // there stable roots lose them, too: cancellation_words_test.cpp
    const bool near = p.id.starts_with("near-surface");
    for (const Opinion& o : lesson().opinions(p.parameters)) {
      CAPTURE(o.method, o.says);
      const bool stable = o.method == "exact" || o.method == "stable roots" || o.method == "robust discriminant";
      CHECK(o.agrees == (stable || !near));
      CHECK(o.says.ends_with("4 digits are right") == !o.agrees);
    }
    if (!near) continue;
    const Walk walk = lesson().walk(p.parameters);
    const double scale = p.group == "haines" ? std::get<Vec3>(p.parameters.at("direction")).norm() : 1;
    const double truth = *intersect(ray_of(p.parameters), ball_of(p.parameters)).surface * scale;
    const char* const slug = p.group == "haines" ? "nearest-root" : "first-root";
    const Step& step = *std::ranges::find(walk.steps, slug, &Step::slug);
    CHECK(step.caption.find("nearly cancel") != std::string::npos);
    CHECK(step.caption.find("Exactly it is " + shown(truth) + ".") != std::string::npos);
    CHECK_FALSE(step.formula.ends_with(shown(truth)));
  }
}

TEST_CASE("the method's answer in the last step is the exact one", "[ray-sphere lesson]") {
  for (const Preset& p : lesson().presets) {
    INFO(p.id);
    const Walk walk = lesson().walk(p.parameters);
    const RaySphere<double> truth = intersect(ray_of(p.parameters), ball_of(p.parameters));
    const Verdict::Kind expected = !truth.surface                 ? Verdict::Kind::no
                                   : truth.origin == Location::on ? Verdict::Kind::on
                                                                  : Verdict::Kind::yes;
    CHECK(walk.steps.back().verdict.kind == expected);
    for (int i = 0; i < outcome(walk); ++i) CHECK(walk.steps[i].verdict.kind == Verdict::Kind::open);
  }
}

TEST_CASE("the counters are those of the run: no root before it is needed", "[ray-sphere lesson]") {
  const auto last = [](const char* id) { return lesson().walk(preset(lesson(), id).parameters).steps.back().counters; };
  CHECK(last("behind").sqrt == 0);
  CHECK(last("behind").early_out);
  CHECK(last("two-roots").sqrt == 1);
  CHECK(last("two-roots").div == 0);
  CHECK(last("two-roots-quadratic").div == 2);
  CHECK(last("miss-half-b").sqrt == 0);
  CHECK(last("two-roots-half-b").mul < last("two-roots-quadratic").mul);
  for (const Preset& p : lesson().presets) {
    int before = 0;
    for (const Step& s : lesson().walk(p.parameters).steps) {
      const int now = s.counters.mul + s.counters.add + s.counters.div + s.counters.sqrt + s.counters.compare;
      CHECK(now >= before);
      before = now;
    }
  }
}

TEST_CASE("the values shown are those of the untraced call", "[ray-sphere lesson]") {
  const Parameters& p = preset(lesson(), "two-roots-quadratic").parameters;
  const auto t = ray_sphere::quadratic(ray_of(p), ball_of(p));
  REQUIRE(t);
  const Walk walk = lesson().walk(p);
  const std::vector<Value>& values = walk.steps.back().values;
  const auto t1 = std::find_if(values.begin(), values.end(), [](const Value& v) { return v.name == "*t*_1"; });
  REQUIRE(t1 != values.end());
  CHECK(t1->value == *t);
}

TEST_CASE("questions offer their answer, and the answer is the exact one", "[ray-sphere lesson]") {
  int asked = 0;
  for (const Preset& p : lesson().presets) {
    const RaySphere<double> truth = intersect(ray_of(p.parameters), ball_of(p.parameters));
    for (const Step& s : lesson().walk(p.parameters).steps) {
      if (!s.question) continue;
      ++asked;
      REQUIRE(s.question->answer >= 0);
      REQUIRE(s.question->answer < static_cast<int>(s.question->choices.size()));
      if (s.question->prompt.starts_with("How many points")) CHECK(s.question->answer == truth.line_roots);
      if (s.question->choices.back() == "neither") CHECK((s.question->answer == 2) == !truth.surface);
    }
  }
  CHECK(asked > 27);
}

TEST_CASE("a lesson bears any numbers a reader may drag or type", "[ray-sphere lesson]") {
  for (const char* method : {"haines", "quadratic", "half-b"}) {
    Parameters p = preset(lesson(), "two-roots").parameters;
    p["method"] = std::string(method);
    for (const Vec3& direction : {Vec3(0, 0, 0), Vec3(1e-6, 0, 0), Vec3(1e6, -1e6, 3), Vec3(0, 0, -1)}) {
      for (const double radius : {0.0, 1e-6, 1e6}) {
        p["direction"] = direction;
        p["radius"] = radius;
        const Walk walk = lesson().walk(p);
        REQUIRE_FALSE(walk.steps.empty());
        std::vector<const Scene*> scenes;
        for (const Step& s : walk.steps) scenes.push_back(&s.scene);
        const Figure f = figure(walk.steps.back(), frame(lesson().camera, scenes, 1.6), ThemeName::print, 960, 600);
        CHECK_FALSE(f.drawing.shapes.empty());
      }
    }
  }
}

}  // namespace ray_sphere_test
