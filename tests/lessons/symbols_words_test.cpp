// A symbol of a formula is said where it first stands: in a sentence of its own step, or of one before.

#include <fmt/format.h>

#include <set>
#include <vector>

#include "tests/lessons/asked_for.h"
#include "tests/lessons/words.h"
#include "viz/text/rich_text.h"

namespace symbols_words_test {
using namespace isect;
using namespace isect::viz;
using namespace isect::tests;

namespace {

struct Symbol {
  std::string name;
  bool bold = false, indexed = false;  ///< indexed: a coordinate, an end or one of several
};

/// The letters and words in italics or bold, as they stand on the line.
std::vector<Symbol> symbols(const std::string& markup) {
  std::vector<Symbol> all;
  const std::vector<Run> runs = parse_markup(markup);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const bool letters = runs[i].text.find_first_not_of(" 0123456789−+·,()") != std::string::npos;
    if (!(runs[i].italic || runs[i].bold) || runs[i].script != Run::Script::base || !letters) continue;
    all.push_back({runs[i].text, runs[i].bold, i + 1 < runs.size() && runs[i + 1].script == Run::Script::sub});
  }
  return all;
}

/// Axes and indices name themselves.
bool known_to_all(const std::string& name) {
  return std::set<std::string>{"x", "y", "z", "i", "u", "v", "w"}.contains(name);
}

}  // namespace

TEST_CASE("symbols are found in formulas", "[words]") {
  const std::vector<Symbol> found = symbols("*p*_x = **n** · **x** + *D*, cost = 3");
  REQUIRE(found.size() == 4);
  CHECK((found[0].name == "p" && found[0].indexed && !found[0].bold));
  CHECK((found[1].name == "n" && found[1].bold));
  CHECK(found[3].name == "D");
}

TEST_CASE("each symbol of a formula stands in a sentence of its step, or of one before", "[every lesson]") {
  int asked = 0;
  for (const Lesson* lesson : those_asked_for())
    for (const Preset& p : lesson->presets) {
      std::set<std::pair<std::string, bool>> said;
      for (const Step& s : lesson->walk(p.parameters).steps) {
        for (const std::string& text : {s.title, s.caption})
          for (const Symbol& symbol : symbols(text)) said.insert({symbol.name, symbol.bold});
        for (const Symbol& symbol : symbols(s.formula)) {
          if (known_to_all(symbol.name)) continue;
          INFO(lesson->id << " " << p.id << ", " << s.slug << ": " << symbol.name << " in " << s.formula);
          ++asked;
          // *p*_x is a coordinate of **p**
          CHECK((said.contains({symbol.name, symbol.bold}) || (symbol.indexed && said.contains({symbol.name, true}))));
        }
      }
    }
  if (those_asked_for().size() == lessons::all_lessons().size()) CHECK(asked > 1000);
}

}  // namespace symbols_words_test
