// Alt text: the picture in words, with its numbers, for every step of every lesson.

#include "viz/walk/alt_text.h"

#include <algorithm>
#include <regex>
#include <set>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "viz/chart/case_map.h"
#include "viz/chart/chart.h"
#include "viz/player/reader_state.h"
#include "viz/text/rich_text.h"
#include "viz/walk/closing.h"

namespace alt_text_test {
using namespace isect::viz;
using Catch::Matchers::StartsWith;
using isect::lessons::all_lessons;
using isect::test::Contains;

TEST_CASE("alt text names what is drawn and from which numbers, the formula and the verdict", "[alt_text]") {
  for (const Lesson* lesson : all_lessons()) {
    const Preset& preset = lesson->presets.front();
    const Walk walk = lesson->walk(preset.parameters);
    for (int i = 0; i < static_cast<int>(walk.steps.size()); ++i) {
      const Step& step = walk.steps[i];
      const std::string alt = alt_text(*lesson, preset.parameters, walk, i);
      INFO(lesson->id << ", " << step.slug << ":\n" << alt);
      CHECK_THAT(alt, StartsWith(lesson->title + ": "));
      CHECK_THAT(alt, Contains(plain(step.caption)));
      if (i < outcome(walk)) CHECK_THAT(alt, !Contains(plain(walk.alt)));  // which says how it ends
      for (const Parameter& p : lesson->parameters)
        if (preset.parameters.contains(p.name)) CHECK_THAT(alt, Contains(p.label.empty() ? p.name : plain(p.label)));
      if (!step.formula.empty()) CHECK_THAT(alt, Contains("Formula: " + plain(step.formula)));
      if (step.verdict.kind != Verdict::Kind::open) CHECK_THAT(alt, Contains("Verdict: " + plain(step.verdict.text)));
      CHECK(alt.find('*') == alt.npos);  // no mark is left
      for (const char* wrong : {"?.", "!.", "..", " a 8", " a 18"}) CHECK_THAT(alt, !Contains(wrong));
      static const std::regex twice("\\b([a-z]+) \\1\\b");
      CHECK_FALSE(std::regex_search(alt, twice));
    }
  }
}

TEST_CASE("alt text of a scene tells its objects and their numbers", "[alt_text]") {
  const auto lessons = all_lessons();
  const Lesson& lesson = lesson_named(lessons, "ray-sphere");
  const Preset& p = preset(lesson, "two-roots");
  const std::string alt = alt_text(lesson, p.parameters, lesson.walk(p.parameters), 2);
  CHECK_THAT(alt, Contains("Drawn: ball c; ") && Contains("points") && Contains("radius r = 1.5234"));
  CHECK_THAT(alt, Contains("origin o = (−2.9609, 0.46875, 1.9766)"));
}

TEST_CASE("alt text of a map of cases says that it is a map, its scales, its regions and where this case lies",
          "[alt_text]") {
  int maps = 0, fewer = 0;
  for (const Lesson* lesson : all_lessons()) {
    if (!lesson->map) continue;
    for (const Preset& preset : lesson->presets) {
      const Walk walk = walk_with_map(*lesson, preset.parameters);
      const auto map = std::ranges::find(walk.steps, std::string(case_map_slug), &Step::slug);
      if (map == walk.steps.end()) continue;
      ++maps;
      const std::string alt = alt_text(*lesson, preset.parameters, walk, static_cast<int>(map - walk.steps.begin()));
      INFO(lesson->id << " " << preset.id << ":\n" << alt);
      CHECK_THAT(alt, Contains("A map of all cases") && Contains("Across: ") && Contains("This setting lies at ("));
      // those that have a place on this map, and no others
      const auto& cases = std::get<Cases>(map->scene.chart->kind);
      std::set<int> there = {cases.here->branch};
      for (const Cases::Patch& patch : cases.patches) there.insert(patch.branch);
      for (const Cases::Spot& spot : cases.presets) there.insert(spot.branch);
      std::string regions;
      for (const int branch : there)
        regions += (regions.empty() ? "" : ", ") + plain(cases.branches[static_cast<std::size_t>(branch)]);
      CHECK_THAT(alt, Contains("Regions: " + regions + ". This setting"));
      fewer += there.size() < cases.branches.size();
      CHECK_THAT(alt, !Contains(plain(walk.alt)));  // that is the scene, which is not shown
    }
  }
  CHECK(maps > 50);
  CHECK(fewer > 3);
}

}  // namespace alt_text_test
