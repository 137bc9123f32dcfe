// Mathematics between dollars in the texts of a scene.

#include <nlohmann/json.hpp>

#include "app/scene/file.h"
#include "app/scene/lesson.h"
#include "app/scene/markup.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/text/rich_text.h"
#include "viz/walk/alt_text.h"

namespace scene_math_test {
namespace scene = isect::program::scene;
namespace viz = isect::viz;
using isect::test::Contains;
using isect::test::contents;
using isect::test::Ran;
using isect::test::Shell;
using isect::test::write;
using Json = nlohmann::ordered_json;

namespace {

/// A scene whose caption, verdict, label and note are this text.
std::string scene_of(const std::string& text) {
  Json all = Json::parse(R"({"objects": [{"circle": "A", "center": [0, 0], "radius": 1},
                                         {"circle": "B", "center": [3, 0], "radius": 1}],
    "ask": [{"of": ["A", "B"]}], "marks": [{"line": ["A.center", "B.center"]}], "notes": [{"at": [0, 2]}]})");
  all["title"] = all["caption"] = all["ask"][0]["caption"] = all["ask"][0]["verdict"] = text;
  all["marks"][0]["label"] = all["notes"][0]["text"] = text;
  return all.dump(1);
}

std::string refused(const std::string& text) {
  try {
    scene::read_scene(text, "");
  } catch (const viz::BadInput& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("mathematics in a scene's texts is read out and set without LaTeX's commands", "[scene]") {
  const viz::Lesson& lesson = scene::kept_lesson_of(scene_of("$r_1 \\le \\frac{a}{b}$"), "");
  const viz::Parameters& numbers = lesson.presets.front().parameters;
  const viz::Walk walk = lesson.walk(numbers);
  const std::string seen = "r₁ ≤ a/b";
  CHECK(viz::plain(walk.steps.at(0).title) == seen);
  CHECK(viz::plain(walk.steps.at(0).caption) == seen);
  CHECK(viz::plain(walk.steps.at(1).caption) == seen);
  CHECK(viz::plain(walk.steps.at(1).verdict.text) == seen);
  for (int step = 0; step < 2; ++step) {
    const std::string alt = viz::alt_text(lesson, numbers, walk, step);
    CHECK_THAT(alt, Contains(seen) && Contains("labelled " + seen));
    CHECK_THAT(alt, !Contains("frac") && !Contains("$") && !Contains("\\"));
  }
}

TEST_CASE("a dollar that is no mathematics stays a dollar", "[scene]") {
  for (const auto& [text, seen] : {std::pair("it costs $5", "it costs $5"), std::pair("$5 and $6", "$5 and $6"),
                                   std::pair("a \\$x\\$", "a $x$"), std::pair("US$", "US$")}) {
    const viz::Lesson& lesson = scene::kept_lesson_of(scene_of(text), "");
    const viz::Walk walk = lesson.walk(lesson.presets.front().parameters);
    CHECK(viz::plain(walk.steps.at(0).caption) == seen);
    CHECK_THAT(viz::plain(walk.alt), Contains(seen));  // two texts with one dollar each hold no mathematics
  }
}

TEST_CASE("what LaTeX refuses, and what is more than a line of letters, is refused with line and field", "[scene]") {
  const std::string text = R"({"objects": [{"point": "p", "at": [0, 0]}, {"point": "q", "at": [1, 0]}],
 "ask": [["p", "q"]],
 "notes": [{"at": [0, 1], "text": "TEXT"}]})";
  const auto with = [&](const std::string& note) {
    std::string now = text;
    return refused(now.replace(now.find("TEXT"), 4, note));
  };
  CHECK(with("$a \\\\cdot b$").empty());
  CHECK_THAT(with("$\\\\oint f$"),
             Contains("line 3: notes[0].text: \\oint in $\\oint f$") && Contains("--format tikz"));
  CHECK_THAT(with("$\\\\frac{a}$"), Contains("line 3: notes[0].text: ") && Contains("nothing follows \\frac"));
  CHECK_THAT(with("$5\\\\%$ of $a%$"), Contains("\\%"));
  CHECK_THAT(refused(scene_of("${a$")), Contains("title: ") && Contains("a brace is not closed"));
}

TEST_CASE("LaTeX gets mathematics as it was written, and more of it than other formats", "[scene]") {
  const Shell shell;
  write(shell.work() / "s.json", scene_of("$\\lVert a \\rVert_2 \\le r$"));
  const Ran tikz = shell("isect render s.json --step 2 --format tikz --out -");
  REQUIRE(tikz.status == 0);
  CHECK_THAT(tikz.out, Contains("{$\\lVert a \\rVert_2 \\le r$}") && Contains("\\usepackage{tikz,amsmath}"));
  const Ran svg = shell("isect render s.json --step 2 --format svg --out -");
  REQUIRE(svg.status == 0);
  const std::string drawn = svg.out.substr(svg.out.find("<title"));
  CHECK_THAT(drawn, Contains("‖") && !Contains("\\lVert"));
  REQUIRE(shell("isect handout s.json").status == 0);
  CHECK_THAT(contents(shell.work() / "handouts/scene/s/handout.tex"),
             Contains("$\\lVert a \\rVert_2 \\le r$") && Contains("\\usepackage{tikz,amsmath}"));

  write(shell.work() / "more.json", scene_of("$\\oint f$"));
  const Ran refused = shell("isect render more.json --step 2 --format tikz,svg --out more");
  CHECK(refused.status == 2);
  CHECK_THAT(refused.err, Contains("more.json: ") && Contains("\\oint") && Contains("--format tikz"));
  const Ran drawn_by_tex = shell("isect render more.json --step 2 --format tikz --out -");
  REQUIRE(drawn_by_tex.status == 0);
  CHECK_THAT(drawn_by_tex.out, Contains("{$\\oint f$}"));
  CHECK(shell("isect scene more.json").out == "A and B are disjoint\n");  // answers are told, not drawn
}

}  // namespace scene_math_test
