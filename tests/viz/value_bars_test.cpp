// The bars beside values: one look and one scale for each unit, which is named.

#include "viz/window/value_bars.h"

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/viz/window_driver.h"
#include "viz/walk/closing.h"

namespace value_bars_test {
using namespace isect;
using namespace isect::viz;

namespace {

Step step_of(const std::vector<std::pair<std::string, std::string>>& values) {
  Step step;
  double number = 1;
  for (const auto& [name, unit] : values) step.values.push_back({name, number++, unit});
  return step;
}

}  // namespace

TEST_CASE("bars of different units look different, those of one share a scale", "[values]") {
  const std::vector<UnitBars> units =
      units_of(step_of({{"*s*", "length"}, {"*l*^2", "area"}, {"*m*^2", "area"}, {"*n*", ""}, {"*k*", "tests"}}));
  REQUIRE(units.size() == 3);
  CHECK(units[0].unit == "length");
  CHECK(units[0].fill == BarFill::full);
  CHECK(units[1].fill == BarFill::hatched);
  CHECK(units[1].scale.hi == 3);
  CHECK(units[2].fill == BarFill::blocks);

  const std::vector<UnitBars> counts = units_of(step_of({{"a", "tests"}, {"b", "questions"}, {"c", "rays"}}));
  REQUIRE(counts.size() == 3);
  CHECK(counts[0].fill != counts[1].fill);
  CHECK(counts[0].fill != counts[2].fill);
  CHECK(counts[1].fill != counts[2].fill);
}

TEST_CASE("no lesson's step has two units of one look", "[values]") {
  for (const Lesson* lesson : lessons::all_lessons())
    for (const Step& step : lesson->walk(lesson->presets.front().parameters).steps) {
      const std::vector<UnitBars> units = units_of(step);
      for (std::size_t i = 0; i < units.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
          INFO(lesson->id << ", " << step.slug << ": " << units[i].unit << ", " << units[k].unit);
          CHECK(units[i].fill != units[k].fill);
        }
    }
}

TEST_CASE("a condition is measured in the unit of the value that is one of its sides", "[values]") {
  const Step step = step_of({{"*s*", "length"}, {"*m*^2", "area"}, {"*t*", ""}});
  const std::vector<UnitBars> units = units_of(step);
  const auto unit = [&](const std::string& text) {
    const UnitBars* found = unit_of(units, step, {text, 0, 0, false, ""});
    return found ? found->unit : std::string();
  };
  CHECK(unit("*m*^2 ≤ *r*^2") == "area");
  CHECK(unit("*s* < 0") == "length");
  CHECK(unit("0 ≤ *s*") == "length");
  CHECK(unit("*t* < 0").empty());
  CHECK(unit("*ss* < 0").empty());
}

TEST_CASE("the units stand beside the heading of the values, each once", "[window]") {
  WindowDriver window(lessons::all_lessons(), 1280, 800, place_at("ray-sphere", "two-roots"));
  window.player().go_to(outcome(window.player().walk()));
  window.frames(2);
  const Rect values = window.rect("values"), length = window.rect("unit length"), area = window.rect("unit area");
  for (const Rect& unit : {length, area})
    CHECK((unit.left >= values.left && unit.right <= values.right && unit.top >= values.top));
  CHECK((length.right < area.left || area.right < length.left));
}

}  // namespace value_bars_test
