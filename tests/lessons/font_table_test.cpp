// The table of the font against Pango, on every text that a lesson draws.

#include "viz/font/table.h"

#include <cmath>
#include <set>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "viz/chart/case_map.h"
#include "viz/compose/compose.h"
#include "viz/text/text.h"

namespace font_table_test {
using namespace isect;

/// The largest distance between corresponding edges of two boxes.
double apart(const viz::TextBox& a, const viz::TextBox& b) {
  return std::max(
      {std::abs(a.left - b.left), std::abs(a.top - b.top), std::abs(a.right - b.right), std::abs(a.bottom - b.bottom)});
}

TEST_CASE("the table measures every text of every step within half a pixel of Pango", "[font table]") {
  std::set<std::pair<std::string, bool>> seen;
  for (const viz::Lesson* lesson : lessons::all_lessons())
    for (const viz::Preset& preset : lesson->presets) {
      const viz::Walk walk = viz::walk_with_map(*lesson, preset.parameters);
      for (const viz::Step& step : walk.steps)
        for (const viz::Shape& shape :
             viz::figure(step, viz::opening(*lesson), viz::ThemeName::screen, 960, 600).drawing.shapes) {
          const auto* text = std::get_if<viz::Text>(&shape);
          if (!text || !seen.insert({text->markup, text->bold}).second) continue;
          viz::Text large = *text;  // as large as any label is, or larger
          large.size = std::max(large.size, 24.0);
          INFO(lesson->id << ", " << preset.id << ", " << step.slug << ": " << text->markup);
          CHECK(viz::table_knows(large));
          CHECK(apart(viz::measured_by_table(large), viz::measure(large)) <= 0.5);
        }
    }
  CHECK(seen.size() > 1000);
}

TEST_CASE("the table has ligatures, kerning, scripts and anchors as Pango has", "[font table]") {
  for (const std::string markup :
       {"office, fluffy, first", "AVAVA To. Ty, WA", "*t*_1^2 + **d** · **n** ≤ −3", "*f*(*x*)", " a  b ", ""})
    for (const double align : {0.0, 0.5, 1.0})
      for (const bool bold : {false, true}) {
        INFO(markup << ", " << align << ", " << bold);
        const viz::Text text = {markup, {100, 50}, 24, {}, align, bold};
        CHECK(apart(viz::measured_by_table(text), viz::measure(text)) <= 0.5);
      }
  CHECK(!viz::table_knows({"\xE4\xB8\xAD", {0, 0}, 10, {}}));  // a Chinese character
}

}  // namespace font_table_test
