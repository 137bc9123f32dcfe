// What the flat lessons say in the end is what the core's exact tests say: crossings, convex polygon, hull, collision.

#include <isect/convex_hull.h>
#include <isect/many/all_pairs.h>
#include "lessons/convex_polygon/picture.h"
#include "lessons/crossings/situations.h"
#include "lessons/lessons.h"
#include "lessons/robustness/settings.h"
#include "tests/catch.h"
#include "viz/walk/closing.h"

namespace flat_lessons_test {
using namespace isect;
using namespace isect::viz;

namespace {

const Lesson& lesson(const std::string& id) {
  for (const Lesson* l : lessons::all_lessons())
    if (l->id == id) return *l;
  throw std::runtime_error("no lesson " + id);
}

Verdict::Kind kind_of(Location l) {
  return l == Location::in ? Verdict::Kind::yes : l == Location::on ? Verdict::Kind::on : Verdict::Kind::no;
}
const Verdict& verdict(const Walk& walk) { return walk.steps.back().verdict; }

double value(const Step& step, const std::string& name) {
  for (const Value& v : step.values)
    if (v.name == name) return v.value;
  throw std::runtime_error("no value " + name);
}

}  // namespace

TEST_CASE("the half-open rule ends with the exact location, in every situation", "[crossings lesson]") {
  for (const auto& s : lessons::crossings_lesson::situations()) {
    INFO(s.id);
    const Winding truth = winding(s.p, s.polygon);
    const Walk walk = lesson("crossings").walk(preset(lesson("crossings"), s.id).parameters);
    CHECK(verdict(walk).kind == kind_of(truth.even_odd));
    if (truth.even_odd != Location::on) CHECK(value(walk.steps.back(), "count") == truth.crossings);
  }
}

TEST_CASE("the closed rule is wrong where a vertex lies on the ray between two sides", "[crossings lesson]") {
  const auto text = [](const char* id) {
    return verdict(lesson("crossings").walk(preset(lesson("crossings"), id).parameters)).text;
  };
  CHECK_THAT(text("vertex-passed-closed"), isect::test::Contains("Wrong"));
  CHECK_THAT(text("edge-along-z-closed"), isect::test::Contains("Wrong"));
  CHECK_THAT(text("inside-closed"), !isect::test::Contains("Wrong"));
}

TEST_CASE("the fan ends with the exact location, in twenty bisections for a million", "[convex-polygon lesson]") {
  const Lesson& l = lesson("convex-polygon");
  for (const Preset& p : l.presets) {
    if (p.group != "fan") continue;
    INFO(p.id);
    const Vec3& at = std::get<Vec3>(p.parameters.at("p"));
    const lessons::convex_polygon_lesson::Setup setup(std::stoi(std::get<std::string>(p.parameters.at("n"))),
                                                      {at.x(), at.y()});
    const Walk walk = l.walk(p.parameters);
    CHECK(verdict(walk).kind == kind_of(setup.truth));
    CHECK(make_convex(setup.polygon.vertices).has_value());
    CHECK(walk.steps.size() <= 25);
  }
}

TEST_CASE("collisions: tests that fail one after the other for one box are one step", "[collision lesson]") {
  for (const Lesson* lesson : isect::lessons::all_lessons()) {
    if (lesson->id != "collision") continue;
    for (const Preset& preset : lesson->presets) {
      if (!preset.id.starts_with("brute-force")) continue;
      const Walk walk = lesson->walk(preset.parameters);
      int told = 0, steps = 0;
      std::string before;
      for (const Step& s : walk.steps) {
        const bool fails = s.slug.starts_with("apart-") || (s.slug.starts_with("test-") && !s.decides);
        const std::string box = fails ? s.slug.substr(s.slug.find('-') + 1, 1) : "";
        CHECK((box.empty() || box != before));
        before = box;
        steps += s.slug.starts_with("apart-") || s.slug.starts_with("test-");
        if (steps > 0 && !s.values.empty() && told < 15) told = static_cast<int>(s.values.front().value);
      }
      CHECK(told == 15);
      CHECK(steps < 15);
    }
  }
}

TEST_CASE("collisions: each method finds the pairs of brute force", "[collision lesson]") {
  const auto last = [](const char* id) {
    return lesson("collision").walk(preset(lesson("collision"), id).parameters).steps.back();
  };
  for (const char* id : {"sweep", "hierarchy"}) {
    CHECK(value(last(id), "pairs") == value(last("brute-force"), "pairs"));
    CHECK(value(last((std::string(id) + "-apart").c_str()), "pairs") == value(last("brute-force-apart"), "pairs"));
  }
  CHECK(value(last("brute-force"), "tests") == 15);
  CHECK(value(last("brute-force"), "brute force, 1000 boxes") == 499500);
  CHECK(value(last("brute-force"), "sweep, 1000 boxes") < 499500);
  CHECK(verdict(lesson("collision").walk(preset(lesson("collision"), "tunnelling").parameters)).kind ==
        Verdict::Kind::yes);
}

TEST_CASE("the neighbour that a preset rings is one that the naive test has wrong", "[robustness lesson]") {
  for (const Preset& p : lesson("robustness").presets) {
    INFO(p.id);
    const auto text = [&](const char* name) { return std::get<std::string>(p.parameters.at(name)); };
    const auto number = [&](const char* name) { return static_cast<int>(std::get<double>(p.parameters.at(name))); };
    const auto s =
        lessons::robustness_lesson::setting(text("test"), text("scalar"), std::get<Vec3>(p.parameters.at("p")));
    const int truth = s.truth(number("right"), number("up")), answer = s.answer(number("right"), number("up"));
    CHECK(truth != answer);
    const Walk walk = lesson("robustness").walk(p.parameters);
    const std::string told = walk.steps[outcome(walk)].formula;
    CHECK(told == "ringed: " + s.in_words(truth) + ", naive says " + s.in_words(answer));
  }
}

TEST_CASE("the microscope's axes count its cells, away from the crosshair", "[robustness lesson]") {
  constexpr int half = lessons::robustness_lesson::half;
  for (const auto& [right, up] : {std::pair{6.0, -6.0}, {-half + 0.0, half + 0.0}, {20.0, 20.0}}) {
    Parameters p = preset(lesson("robustness"), "orientation").parameters;
    p["right"] = right, p["up"] = up;
    int numbers = 0, rasters = 0;
    for (const Step& step : lesson("robustness").walk(p).steps) {
      const auto raster =
          std::ranges::find_if(step.scene.items, [](const Item& i) { return std::holds_alternative<viz::Raster>(i); });
      if (raster == step.scene.items.end()) continue;
      const auto& cells = std::get<viz::Raster>(*raster);
      ++rasters;
      for (const Item& item : step.scene.items) {
        const auto* heading = std::get_if<viz::Heading>(&item);
        if (!heading || heading->role != Role::muted) continue;
        ++numbers;
        const Vec3 middle = cells.corner + (cells.across + cells.down) / 2, from = heading->at - middle;
        const bool below = heading->at.y() < (cells.corner + cells.down).y();
        const double cell = cells.across.x() / cells.columns;
        const double steps = (below ? from.x() : from.y()) / cell, looked_at = below ? right : up;
        INFO(heading->text << " at " << steps);
        CHECK(heading->text == shown(std::round(steps)));
        CHECK(std::abs(steps - std::round(steps)) < 1e-9);
        CHECK(std::abs(steps - looked_at) > 6);
      }
    }
    CHECK(rasters == 3);
    CHECK(numbers == (right < -20 ? 2 : 4) * rasters);
  }
}

TEST_CASE("under the microscope each naive test is wrong somewhere, as counted", "[robustness lesson]") {
  for (const std::string& test : lessons::robustness_lesson::tests())
    for (const std::string scalar : {"float", "double"}) {
      INFO(test << ", " << scalar);
      const auto s =
          lessons::robustness_lesson::setting(test, scalar, lessons::robustness_lesson::standard_point(test));
      int wrong = 0;
      for (int i = -32; i <= 32; ++i)
        for (int j = -32; j <= 32; ++j) {
          const int truth = s.truth(i, j), answer = s.answer(i, j);
          wrong += answer != truth && (truth != 0 || answer == 0);
        }
      CHECK(wrong > 0);
      const Parameters parameters = {{"test", test},
                                     {"scalar", scalar},
                                     {"p", lessons::robustness_lesson::standard_point(test)},
                                     {"right", 0.0},
                                     {"up", 0.0}};
      CHECK(value(lesson("robustness").walk(parameters).steps.back(), "wrong") == wrong);
    }
}

}  // namespace flat_lessons_test
