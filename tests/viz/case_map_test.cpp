// The map of cases, of a lesson made up for the purpose: a disc, a circle and a half-plane.

#include "viz/chart/case_map.h"

#include "tests/catch.h"
#include "viz/chart/case_names.h"
#include "viz/player/played_walk.h"

namespace case_map_test {
using namespace isect::viz;

namespace {

enum Case { outside, disc, rim, right };

Vec2 place(const Parameters& p) { return {std::get<double>(p.at("x")), std::get<double>(p.at("y"))}; }
Parameters moved(const Parameters& p, const Vec2& to) {
  Parameters there = p;
  there["x"] = to.x(), there["y"] = to.y();
  return there;
}
int branch(const Parameters& p) {
  const Vec2 at = place(p);
  if (at.squaredNorm() == 1) return rim;
  return at.squaredNorm() < 1 ? disc : at.x() > 1.5 ? right : outside;
}

const CaseMap map = {"x", "y", {-2, -2}, {2, 2}, {"outside", "disc", "rim", "right"}, branch, place, moved};

Preset preset_at(const char* id, double x, double y) { return {id, id, "", {{"x", x}, {"y", y}}}; }

Lesson lesson() {
  Lesson l;
  l.id = "made-up";
  l.presets = {preset_at("a", 0.5, 0), preset_at("b", 0, 1), preset_at("c", 5, 0), preset_at("d", 0.5, 0)};
  l.map = &map;
  return l;
}

double area(const Cases& cases, int of) {
  double sum = 0;
  for (const Cases::Patch& patch : cases.patches) {
    if (patch.branch != of) continue;
    const auto& [a, b, c, d] = patch.corners;
    sum += (b.x() - a.x() + c.x() - d.x()) / 2 * (d.y() - a.y());
  }
  return sum;
}

}  // namespace

TEST_CASE("regions have the areas that the branches have", "[case_map]") {
  const Lesson l = lesson();
  const Cases cases = std::get<Cases>(case_map(l, l.presets[0].parameters).kind);
  CHECK(std::abs(area(cases, disc) - 3.14159265) < 0.01);
  CHECK(std::abs(area(cases, right) - 2) < 0.005);
  CHECK(area(cases, rim) == 0);
  CHECK(std::abs(area(cases, outside) + area(cases, disc) + area(cases, right) - 16) < 1e-9);
}

TEST_CASE("corners of regions are as sharp as they are, also between two lines of the sweep", "[case_map]") {
  // a triangle with its tip at (-1, 0.013) and an upright side, and a half-plane with a notch narrower than a line's
  // pitch
  const CaseMap plane = {"x",
                         "y",
                         {-2, -2},
                         {2, 2},
                         {"outside", "triangle", "right"},
                         [](const Parameters& p) {
                           const Vec2 at = place(p);
                           if (at.x() < 1.2 && std::abs(at.y() - 0.013) < 0.4 * (at.x() + 1)) return 1;
                           const double notch = 0.25 * std::max(0.0, 1 - std::abs(at.y() - 0.04) / 0.06);
                           return at.x() > 1.7 - notch ? 2 : 0;
                         },
                         place,
                         moved};
  Lesson l = lesson();
  l.map = &plane;
  const Cases cases = std::get<Cases>(case_map(l, l.presets[0].parameters).kind);
  CHECK(std::abs(area(cases, 1) - 0.4 * 2.2 * 2.2) < 2e-4);
  CHECK(std::abs(area(cases, 2) - (0.3 * 4 + 0.25 * 0.06)) < 2e-4);
  for (const Vec2& corner : {Vec2(-1, 0.013), Vec2(1.2, 0.893), Vec2(1.2, -0.867), Vec2(1.45, 0.04), Vec2(1.7, 0.1)}) {
    double nearest = HUGE_VAL;
    for (const std::vector<Vec2>& border : cases.borders)
      for (const Vec2& p : border) nearest = std::min(nearest, (p - corner).norm());
    CAPTURE(corner.x(), corner.y());
    CHECK(nearest < 0.005);  // of 4: a pixel of a large picture
  }
}

TEST_CASE("borders lie where the branch changes", "[case_map]") {
  const Lesson l = lesson();
  const Cases cases = std::get<Cases>(case_map(l, l.presets[0].parameters).kind);
  REQUIRE_FALSE(cases.borders.empty());
  for (const std::vector<Vec2>& border : cases.borders)
    for (const Vec2& p : border) {
      const bool on_line = std::abs(p.x() - 1.5) < 0.001, on_rim = std::abs(p.norm() - 1) < 0.005;
      CHECK((on_line || on_rim));
    }
}

TEST_CASE("presets on the map are marked once, with their own branch", "[case_map]") {
  const Lesson l = lesson();
  const Cases cases = std::get<Cases>(case_map(l, preset_at("", -1.75, 1.75).parameters).kind);
  REQUIRE(cases.presets.size() == 2);  // c lies beyond it, d where a is
  CHECK(cases.presets[0].branch == disc);
  CHECK(cases.presets[1].branch == rim);
  REQUIRE(cases.here);
  CHECK(cases.here->branch == outside);
  CHECK_FALSE(std::get<Cases>(case_map(l, preset_at("", 9, 0).parameters).kind).here);
}

TEST_CASE("a map names its regions and its lines, inside its plane", "[case_map]") {
  const Lesson l = lesson();
  const Chart chart = case_map(l, l.presets[0].parameters);
  for (const ThemeName name : {ThemeName::screen, ThemeName::print, ThemeName::grey, ThemeName::dark}) {
    const Theme styled = theme(name, 600, 400);
    const Composed composed = compose(chart, {0, 0}, 600, 400, styled);
    const Box2 plane = plane_of(std::get<Cases>(chart.kind), {0, 0}, 600, 400, styled);
    for (const std::string& branch : map.branches) {
      int found = 0;
      for (const PlacedLabel& label : composed.labels)
        if (label.text == branch) {
          ++found;
          CHECK((label.box.left >= plane.lo.x() && label.box.right <= plane.hi.x()));
          CHECK((label.box.top >= plane.lo.y() && label.box.bottom <= plane.hi.y()));
        }
      CHECK(found == 1);
    }
  }
}

TEST_CASE("a map made in parts is the map made at once", "[case_map]") {
  const Lesson l = lesson();
  const auto next_part = case_map_in_parts(l, l.presets[0].parameters);
  int parts = 1;
  std::optional<Chart> made;
  while (!(made = next_part())) ++parts;
  CHECK(parts > 50);
  const Cases cases = std::get<Cases>(made->kind), whole = std::get<Cases>(case_map(l, l.presets[0].parameters).kind);
  CHECK(cases.borders == whole.borders);
  CHECK(cases.patches.size() == whole.patches.size());
  CHECK(cases.presets.size() == whole.presets.size());
  CHECK(cases.here->at == whole.here->at);
}

TEST_CASE("a walk's map gets its regions when it is swept, a played walk's in parts", "[case_map]") {
  Lesson l = lesson();
  l.steps = [](const Parameters&) {
    Walk walk;
    walk.steps.resize(1);
    return walk;
  };
  l.parameters = {{"x", "x", "", 0.0}, {"y", "y", "", 0.0}};
  const Parameters& here = l.presets[0].parameters;
  const auto patches = [](const Walk& walk) {
    return std::get<Cases>(walk.steps.at(1).scene.chart->kind).patches.size();
  };
  CHECK(patches(l.walk(here)) == 0);
  const std::size_t all = patches(walk_with_map(l, here));
  CHECK(all > 0);

  PlayedWalk played(l, here);
  CHECK_FALSE(played.prepare(0));  // which shows no map
  CHECK(played.prepare(1));
  CHECK(patches(played.walk()) == 0);
  while (played.prepare(1)) continue;
  CHECK(patches(played.walk()) == all);
}

TEST_CASE("the name of a region stands in no plane without room", "[case_map]") {
  const Lesson l = lesson();
  const Cases cases = std::get<Cases>(case_map(l, l.presets[0].parameters).kind);
  for (const double width : {60.0, 0.0, -1e-7, -60.0}) {
    const CaseNames names(cases, {100, 100, 100 + width, 140});
    for (const int region : {outside, disc, right}) CHECK(names.place(region, {400, 20}).cost > 0);
  }
}

}  // namespace case_map_test
