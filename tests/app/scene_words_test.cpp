// What the author of a scene says: own words beside a question, answers hidden for an exercise sheet.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/scene/edit.h"
#include "app/scene/file.h"
#include "app/scene/lesson.h"
#include "tests/app/refusals.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/text/rich_text.h"

namespace scene_words_test {
namespace fs = std::filesystem;
namespace scene = isect::program::scene;
namespace viz = isect::viz;
using namespace isect::test;
using Json = nlohmann::ordered_json;

namespace {

const std::string coins = R"({"circle": "A", "center": [-1.5, 0], "radius": 1},
    {"circle": "B", "center": [1.5, 0], "radius": 1.25}, {"ray": "r", "origin": [-4, 0], "dir": [1, 0]})";

std::string scene_of(const std::string& ask, const std::string& more = "") {
  return "{\"objects\": [" + coins + "],\n\"ask\": [" + ask + "]" + more + "}";
}

viz::Parameters moved(const viz::Lesson& lesson, const std::string& name, const std::string& to) {
  viz::Parameters now = lesson.presets.front().parameters;
  viz::set(lesson, now, name, to);
  return now;
}

}  // namespace

TEST_CASE("words of one's own stand in the place of the usual ones, beside the core's verdict", "[scene]") {
  const viz::Lesson lesson = scene::lesson_of(
      scene_of(R"({"of": ["A", "B"], "title": "*Coins*", "caption": "They lie apart.", "verdict": "room for a thumb"},
                  {"first hit": "r", "caption": "Follow it."}, ["r", "B"])",
               R"(, "caption": "A table.")"),
      "");
  const viz::Walk walk = lesson.walk(lesson.presets.front().parameters);
  REQUIRE(walk.steps.size() == 5);
  CHECK(walk.steps[0].caption == "A table.");
  CHECK_THAT(walk.alt, Contains("The scene holds circle"));  // what there is, whatever the caption says
  const viz::Step& coin = walk.steps[1];
  CHECK(coin.title == "*Coins*");
  CHECK(coin.caption == "They lie apart.");
  CHECK(coin.verdict.text == "room for a thumb");
  CHECK(viz::plain(coin.verdict.exact) == "A and B are disjoint");
  CHECK(coin.verdict.kind == viz::Verdict::Kind::no);
  CHECK(walk.steps[2].caption == "Follow it.");
  CHECK(viz::plain(walk.steps[2].verdict.text) == "r meets A first, at t = 1.5");
  CHECK(walk.steps[2].verdict.exact.empty());
  CHECK_THAT(viz::plain(walk.steps[3].caption), Contains("Decided exactly for these numbers: r meets B."));
}

TEST_CASE("words that were written for another verdict do not stand, and that is said", "[scene]") {
  const viz::Lesson lesson = scene::lesson_of(
      scene_of(R"({"of": ["A", "B"], "title": "Apart", "caption": "They lie apart.", "verdict": "room for a thumb"})"),
      "");
  const viz::Step near = lesson.walk(moved(lesson, "A.center", "-1,0")).steps.at(1);  // still disjoint
  CHECK(near.verdict.text == "room for a thumb");
  CHECK(near.caption == "They lie apart.");
  const viz::Step met = lesson.walk(moved(lesson, "A.center", "0,0")).steps.at(1);
  CHECK(viz::plain(met.verdict.text) == "A and B overlap");
  CHECK(met.verdict.exact.empty());
  CHECK(viz::plain(met.title) == "A and B");
  CHECK(viz::plain(met.caption) ==
        "They lie apart.\nThis was written for other numbers: A and B are disjoint. Now: A and B overlap.");
}

TEST_CASE("no verdict is shown where the author wants none, and it stays in the trace and in --json", "[scene]") {
  const Shell shell;
  write(shell.work() / "coins.json", scene_of(R"({"of": ["A", "B"], "verdict": null, "caption": "Do they meet?"},
    {"of": ["r", "A"], "verdict": "it hits"})"));
  const Ran json = shell("isect scene coins.json --json");
  INFO(json.err);
  const Json all = Json::parse(json.out);
  CHECK(all[0]["verdict"] == "A and B are disjoint");
  CHECK(all[0]["said"] == Json::parse(R"({"caption": "Do they meet?", "verdict": null})"));
  CHECK(all[1]["verdict"] == "r meets A");
  CHECK(all[1]["said"]["verdict"] == "it hits");
  CHECK(shell("isect scene coins.json").out == "A and B are disjoint\nr meets A\n");
  const std::string told = shell("isect explain coins.json").out;
  CHECK_THAT(told, !Contains("are disjoint") && Contains("Verdict: it hits (exactly: r meets A)"));
  CHECK(shell("isect render coins.json --format svg --step 2").status == 0);
  CHECK_THAT(contents(shell.work() / "figures/scene/coins/02-a-b.svg"), !Contains("disjoint"));
  CHECK(shell("isect check --dir . --update").status == 0);
  const std::string trace = contents(shell.work() / "snapshots/scene/coins/trace.json");
  CHECK_THAT(trace, Contains("verdict of the core") && Contains("are disjoint"));
}

TEST_CASE("what is wrong with words of one's own is told by line and field", "[scene]") {
  CHECK_THAT(refused(scene_of(R"({"of": ["A", "B"], "captoin": "x"})")),
             Contains("line 3: ask[0].captoin") && Contains("did you mean \"caption\"?"));
  CHECK_THAT(refused(scene_of(R"({"of": ["A", "B"], "caption": 3})")), Contains("ask[0].caption: a text is expected"));
  CHECK_THAT(refused(scene_of(R"({"of": ["A", "B"], "verdict": ""})")), Contains("null leaves the verdict out"));
  CHECK_THAT(refused(scene_of(R"({"of": ["A"], "caption": "x"})")), Contains("ask[0].of: two names are expected"));
  CHECK_THAT(refused(scene_of(R"({"of": ["A", "C"]})")), Contains("no object is called \"C\""));
  CHECK_THAT(refused(scene_of(R"({"walk": ["A", "B"], "caption": "x"})")), Contains("ask[0].caption: unknown"));
  CHECK_THAT(refused(scene_of("", R"(, "answers": "none")")), Contains("answers: \"none\" is neither"));
}

TEST_CASE("a scene whose answers are hidden asks, and nothing of it tells an answer", "[scene]") {
  const std::string ask = R"(["A", "B"], {"of": ["r", "A"], "question": "Hit or miss?", "title": "A hit",
    "caption": "It hits at *t* = 1.5.", "verdict": "a hit"}, {"first hit": "r"}, {"clip": "r", "to": "Q"}, {"walk": "P"},
    {"fit": "P"}, {"hierarchy": "all"})";
  const std::string objects = "{\"objects\": [" + coins + R"(, {"box": "Q", "lo": [-1, -1], "hi": [1, 1]},
    {"cloud": "P", "points": [[0, 0], [1, 0], [0, 1]]}], "ask": [)" +
                              ask + "]";
  const viz::Lesson shown = scene::lesson_of(objects + "}", ""),
                    hidden = scene::lesson_of(objects + ", \"answers\": \"hidden\"}", "");
  const viz::Walk asks = hidden.walk(hidden.presets.front().parameters);
  const viz::Walk tells = shown.walk(shown.presets.front().parameters);
  REQUIRE(asks.steps.size() == 8);  // no card of all answers
  REQUIRE(tells.steps.size() > asks.steps.size());
  CHECK(asks.steps[0].caption == tells.steps[0].caption);
  for (std::size_t i = 1; i < asks.steps.size(); ++i) {
    const viz::Step& s = asks.steps[i];
    INFO(i << ": " << s.title << ": " << s.caption);
    CHECK(s.verdict.text.empty());
    CHECK(s.verdict.exact.empty());
    CHECK(s.verdict.kind == viz::Verdict::Kind::open);
    CHECK(s.formula.empty());
    CHECK(s.values.empty());
    CHECK(s.caption.ends_with("?"));
    for (const viz::Item& item : s.scene.items)
      std::visit(
          [](const auto& part) {
            if constexpr (requires { part.role; }) CHECK((part.role != viz::Role::hit && part.role != viz::Role::miss));
          },
          item);
    CHECK_FALSE(s.scene.handles.empty());
  }
  CHECK(asks.steps[1].slug == tells.steps[1].slug);
  CHECK(asks.steps[2].caption == "Hit or miss?");
  CHECK(viz::plain(asks.steps[2].title) == "r and A");
}

TEST_CASE("one file gives the exercise sheet and its solution", "[scene]") {
  const Shell shell;
  write(shell.work() / "coins.json", scene_of(R"(["r", "A"], ["A", "B"])"));
  CHECK(shell("isect render coins.json --format svg --step 2").status == 0);
  const Ran sheet = shell("isect render coins.json --format svg --step 2 --answers hidden");
  CHECK(sheet.out == "figures/scene/coins+answers=hidden/02-r-a.svg\n");
  const fs::path figures = shell.work() / "figures/scene";
  CHECK_THAT(contents(figures / "coins/02-r-a.svg"), Contains("r meets A"));
  const std::string asks = contents(figures / "coins+answers=hidden/02-r-a.svg");
  CHECK_THAT(asks, !Contains("meets") && Contains("do they meet?"));
  // The figure knows that its answers are hidden.
  CHECK(shell("isect render figures/scene/coins+answers=hidden/02-r-a.svg --format svg --out again").status == 0);
  CHECK_THAT(contents(shell.work() / "again/scene/coins+answers=hidden/02-r-a.svg"), !Contains("r meets A"));
  for (const std::string command : {"strip", "handout", "deck"})
    CHECK(shell("isect " + command + " coins.json --answers hidden").status == 0);
  CHECK_THAT(contents(shell.work() / "handouts/scene/coins+answers=hidden/handout.html"),
             !Contains("r meets A") && Contains("do they meet?"));

  write(shell.work() / "sheet.json", scene_of(R"(["r", "A"])", ",\n\"answers\": \"hidden\""));
  CHECK(shell("isect render sheet.json --format svg --step 2 --answers hidden").out ==
        "figures/scene/sheet/02-r-a.svg\n");
  CHECK(shell("isect render sheet.json --format svg --step 2 --answers shown").out ==
        "figures/scene/sheet+answers=shown/02-r-a.svg\n");
  CHECK(shell("isect scene sheet.json").out == "r meets A\n");  // who asks for answers gets them

  const Ran lesson = shell("isect render ray-sphere --answers hidden");
  CHECK(lesson.status == 2);
  CHECK_THAT(lesson.err, Contains("answers: those of a scene"));
  CHECK_THAT(shell("isect render coins.json --answers hiden").err, Contains("did you mean \"hidden\"?"));
}

TEST_CASE("edits know words of one's own: names in them, questions that are asked already, answers", "[scene]") {
  const std::string text = scene_of(R"({"of": ["A", "B"], "caption": "A and B"}, ["r", "A"])");
  CHECK_THAT(scene::with_name(text, "A", "C"), Contains(R"({"of": ["C", "B"], "caption": "A and B"})"));
  CHECK_THAT(scene::without_object(text, "B"), !Contains("\"of\"") && Contains(R"(["r", "A"])"));
  CHECK_THROWS_WITH(scene::with_question(text, Json{"A", "B"}), Contains("asked already"));
  const std::string hidden = scene::with_answers(text, true);
  CHECK(scene::read_scene(hidden, "").answers_hidden);
  CHECK_FALSE(scene::read_scene(scene::with_answers(hidden, false), "").answers_hidden);
  CHECK(scene::with_answers(text, false) == text);
}

}  // namespace scene_words_test
