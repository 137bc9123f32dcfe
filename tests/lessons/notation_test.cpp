// One notation: a letter means the same in all lessons, and the list of letters says what.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "bench/rows.h"
#include "lessons/glossary.h"
#include "lessons/speed_against_error/results.h"
#include "tests/catch.h"
#include "tests/lessons/asked_for.h"
#include "viz/player/reader_state.h"
#include "viz/text/rich_text.h"

namespace notation_test {
using namespace isect;
using namespace isect::viz;

namespace {

struct Definition {
  std::string letter, as;  ///< plain text, without squares
};

/// The letters that a line defines: "l² ← l · l" does not define l, while "t₁ ← ..." defines t.
std::vector<Definition> defined(const std::string& line) {
  static const std::regex wanted("(^|[ ;,:])([A-Za-z]|Δ|ε)(₁|₂|²)? ← ([^;:]*)");
  std::vector<Definition> all;
  for (std::sregex_iterator at(line.begin(), line.end(), wanted), end; at != end; ++at) {
    if ((*at)[3] == "²" && (*at)[2] != "m") continue;
    std::string as = (*at)[4];
    for (const char* more : {" for", ", "}) as = as.substr(0, as.find(more));
    while (as.ends_with(' ')) as.pop_back();
    all.push_back({(*at)[2], as});
  }
  return all;
}

/// "**l** = **b** − **a**", "*s* = **l** · **d** = 3.5": a letter and its formula, as text. Numbers define no letter.
std::vector<Definition> stated(const std::string& formula) {
  static const std::regex wanted("^([A-Za-z]|Δ|ε) = ([^=]*[A-Za-z][^=]*?) *(=.*)?$");
  std::smatch m;
  const std::string text = plain(formula);
  if (!std::regex_match(text, m, wanted)) return {};
  return {{m[1], m[2]}};
}

const lessons::Letter* letter(const std::string& name) {
  const auto found = std::ranges::find(lessons::letters(), name, &lessons::Letter::name);
  return found == lessons::letters().end() ? nullptr : &*found;
}

void check(const Definition& d, const std::string& where) {
  INFO(where << ": " << d.letter << " as " << d.as);
  if (std::set<std::string>{"i", "j", "x"}.contains(d.letter)) return;  // indices and coordinates
  const lessons::Letter* known = letter(d.letter);
  REQUIRE(known);
  CHECK((known->given.empty() || std::ranges::count(known->given, d.as) > 0));
}

}  // namespace

TEST_CASE("definitions are found in algorithms and formulas", "[every lesson]") {
  CHECK(defined("l ← b − a; c_ij ← |a_i · b_j| + ε").front().as == "b − a");
  CHECK(defined("l² ← l · l").empty());
  CHECK(defined("t₁ ← (−B − √Δ) / A").front().letter == "t");
  CHECK(stated("*s* = **l** · **d** = 3.5").front().as == "l · d");
  CHECK(stated("*t* = 3.5").empty());
}

TEST_CASE("a letter is computed in one way wherever a lesson computes it", "[every lesson]") {
  std::size_t seen = 0;
  for (const Lesson* lesson : those_asked_for())
    for (const Preset& p : lesson->presets) {
      const Walk walk = lesson->walk(p.parameters);
      for (const std::string& line : walk.pseudocode)
        for (const Definition& d : defined(line)) check(d, lesson->id + ", " + line), ++seen;
      for (const Step& s : walk.steps)
        for (const Definition& d : stated(s.formula)) check(d, lesson->id + ", " + s.formula), ++seen;
    }
  if (those_asked_for().size() == lessons::all_lessons().size()) CHECK(seen > 500);
}

TEST_CASE("a value or a label that is a letter is in the list of letters", "[every lesson]") {
  static const std::regex single("([A-Za-z]|Δ|ε)([₀-₉²]|_[a-z0-9]+)*");
  const std::set<std::string> names = {"a", "b", "x", "y", "z", "e", "g", "r", "N"};  // of objects, axes and edges
  for (const Lesson* lesson : those_asked_for())
    for (const Preset& p : lesson->presets)
      for (const Step& s : lesson->walk(p.parameters).steps)
        for (const Value& v : s.values) {
          std::smatch m;
          const std::string name = plain(v.name);
          if (!std::regex_match(name, m, single) || names.contains(m[1])) continue;
          INFO(lesson->id << ", " << s.slug << ": " << name);
          CHECK(letter(m[1]));
        }
}

TEST_CASE("a method has one name, in its lesson and where it is measured", "[every lesson]") {
  // Methods that are measured but are not the lesson's: of other number types, or of many points at once.
  const std::set<std::string> apart = {"batch"};
  for (const auto& [id, suite] : std::map<std::string, std::string>{{"ray-sphere", "ray-sphere"},
                                                                    {"sphere-sphere", "sphere-sphere"},
                                                                    {"sphere-aabb", "sphere-aabb"},
                                                                    {"obb-obb", "obb-obb"},
                                                                    {"crossings", "point-polygon"}}) {
    const Lesson& lesson = lesson_named(lessons::all_lessons(), id);
    const std::vector<Opinion> said = lesson.opinions(lesson.presets.front().parameters);
    for (const bench::Row* row :
         bench::rows_of(lessons::speed_against_error_lesson::results(), suite, "double", "ordinary")) {
      if (row->library != "isect" || apart.contains(row->method)) continue;
      const std::string name = std::regex_replace(row->method, std::regex(" [0-9].*"), "");  // "epsilon" of 10^-6
      INFO(id << ": " << name);
      CHECK(std::ranges::any_of(said, [&](const Opinion& o) { return plain(o.method).starts_with(name); }));
    }
  }
}

TEST_CASE("letters stand once each, with a lesson that exists", "[every lesson]") {
  std::set<std::string> names;
  for (const lessons::Letter& l : lessons::letters()) {
    INFO(l.name);
    CHECK(names.insert(l.name).second);
    CHECK(l.meaning.ends_with('.'));
    CHECK(std::ranges::count(lessons::all_lessons(), l.lesson, &Lesson::id) == 1);
  }
}

}  // namespace notation_test
