// Scenes, handouts and questions in other languages, as a user asks for them.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>

#include "app/scene/edit.h"
#include "app/scene/file.h"
#include "app/scene/lesson.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/lang/language.h"
#include "viz/text/rich_text.h"
#include "viz/walk/alt_text.h"

namespace lang_test {

namespace fs = std::filesystem;
namespace scene = isect::program::scene;
namespace viz = isect::viz;
using isect::test::Contains;
using isect::test::contents;
using isect::test::Ran;
using isect::test::Shell;
using isect::test::write;
using Json = nlohmann::ordered_json;

namespace {

const std::string two = R"({"objects": [{"circle": "A", "center": [-1.5, 0], "radius": 1},
    {"circle": "B", "center": [1.5, 0], "radius": 2}, {"ray": "r", "origin": [-4, 0], "dir": [1, 0]}],
 "ask": [["A", "B"], {"first hit": "r"}, ["r", "B"]]})";

std::string refused(const std::string& text) {
  try {
    scene::read_scene(text, "");
  } catch (const viz::BadInput& e) {
    return e.what();
  }
  return "";
}

/// Returns an example without what its author says in English; nothing of one that walks through an English lesson.
std::string without_own_words(const fs::path& file) {
  Json json = Json::parse(contents(file), nullptr, true, true);
  for (const char* field : {"title", "caption", "notes"}) json.erase(field);
  if (json.contains("marks"))
    for (Json& mark : json["marks"]) mark.erase("label");
  if (json.contains("ask") && json["ask"].is_array())
    for (Json& asked : json["ask"]) {
      if (!asked.is_object()) continue;
      if (asked.contains("walk")) return {};
      for (const char* field : {"title", "caption", "verdict", "question"}) asked.erase(field);
    }
  return json.dump();
}

/// Returns all that a lesson says.
std::string all_texts(const viz::Lesson& lesson) {
  const viz::Parameters& here = lesson.presets.front().parameters;
  const viz::Walk walk = lesson.walk(here);
  std::string all = viz::plain(lesson.title) + "\n" + viz::plain(lesson.summary) + "\n" + lesson.presets.front().title;
  for (std::size_t i = 0; i < walk.steps.size(); ++i)
    all += "\n" + viz::alt_text(lesson, here, walk, static_cast<int>(i));
  return all;
}

}  // namespace

TEST_CASE("nothing of an example scene stays English in German, whether it tells its answers or asks", "[lang]") {
  const std::regex field("\\.[a-z]+");  // A.center: as files call it
  const std::regex english(
      "\\b(the|and|of|is|are|lies|lie|meets?|misses|touch|overlap|disjoint|equal|inside|outside|boundary|which|where|"
      "what|how|points?|balls?|lines?|rays?|spheres?|circles?|boxes|hull|mesh|cloud|segments?|planes?|triangles?|"
      "volumes?|area|depth|nodes?|leaves|from|to|at|with|given|drawn|formula|scene|objects?|others?|first|all|exactly)"
      "\\b",
      std::regex::icase);
  int told = 0;
  for (const auto& entry : fs::directory_iterator(ISECT_EXAMPLE_SCENES)) {
    if (entry.path().extension() != ".json") continue;
    const std::string text = without_own_words(entry.path());
    if (text.empty()) continue;
    for (const bool hidden : {false, true}) {
      INFO(entry.path().filename() << (hidden ? ", asking" : ""));
      const std::string german = scene::with_language(scene::with_answers(text, hidden), "de");
      const std::string all = std::regex_replace(all_texts(scene::lesson_of(german, ISECT_EXAMPLE_SCENES)), field, "");
      std::smatch found;
      if (std::regex_search(all, found, english))
        FAIL_CHECK(
            found[0] << " in: ..."
                     << found.prefix().str().substr(found.prefix().length() > 80 ? found.prefix().length() - 80 : 0)
                     << found[0] << found.suffix().str().substr(0, 80));
      ++told;
    }
  }
  CHECK(told >= 20);
  CHECK(viz::spoken() == "en");
}

TEST_CASE("a scene has the same verdicts, numbers and steps in every language", "[lang]") {
  const viz::Lesson english = scene::lesson_of(two, "");
  const viz::Walk here = english.walk(english.presets.front().parameters);
  CHECK(here.steps[1].verdict.text == "**A** and **B** touch");
  for (const viz::Language& language : viz::languages()) {
    INFO(language.code);
    const viz::Lesson lesson = scene::lesson_of(scene::with_language(two, language.code), "");
    CHECK(lesson.language == language.code);
    const viz::Walk walk = lesson.walk(lesson.presets.front().parameters);
    REQUIRE(walk.steps.size() == here.steps.size());
    for (std::size_t i = 0; i < walk.steps.size(); ++i) {
      CHECK(walk.steps[i].slug == here.steps[i].slug);
      CHECK(walk.steps[i].verdict.kind == here.steps[i].verdict.kind);
      CHECK(walk.steps[i].values.size() == here.steps[i].values.size());
      CHECK((walk.steps[i].caption == here.steps[i].caption) == (language.code == "en"));
    }
  }
  const viz::Lesson german = scene::lesson_of(scene::with_language(two, "de"), "");
  const viz::Walk walk = german.walk(german.presets.front().parameters);
  CHECK(walk.steps[1].verdict.text == "**A** und **B** berühren sich");
  CHECK(walk.steps[2].verdict.text == "**r** trifft zuerst **A**, bei *t* = 1.5");
  CHECK(german.title == "Eine Szene");
}

TEST_CASE("a scene's language stands in its file, and the command line's counts before it", "[lang]") {
  CHECK_THAT(refused(R"({"lang": "xx", "objects": [{"point": "p", "at": [0, 0]}]})"),
             Contains("lang") && Contains("\"xx\"") && Contains("en, de, fr, es, zh"));
  const Shell shell;
  write(shell.work() / "two.json", two);
  write(shell.work() / "zwei.json", scene::with_language(two, "de"));
  const std::string german = shell("isect scene zwei.json").out;
  CHECK_THAT(german, Contains("A und B berühren sich"));
  CHECK(shell("isect scene two.json --lang de").out == german);
  CHECK(shell("isect scene zwei.json --lang en").out == shell("isect scene two.json").out);
  CHECK(shell("isect explain two.json --lang en").out == shell("isect explain two.json").out);
  CHECK_THAT(shell("isect explain two.json --lang de").out, Contains("Schritt 1 von") && Contains("Die Szene enthält"));
  const Ran unknown = shell("isect scene two.json --lang xx");
  CHECK(unknown.status == 2);
  CHECK_THAT(unknown.err, Contains("lang: \"xx\"") && Contains("de") && Contains("zh"));
  CHECK(shell("isect render two.json --lang xx --out figures").status == 2);
  CHECK_FALSE(fs::exists(shell.work() / "figures"));
}

TEST_CASE("handouts and quizzes of a translated lesson are in its language, of others they are English", "[lang]") {
  const Shell shell;
  REQUIRE(shell("isect handout sphere-sphere --step 1-4 --lang de").status == 0);
  const std::string page = contents(shell.work() / "handouts/sphere-sphere/overlapping+lang=de/handout.html");
  CHECK_THAT(page, Contains("<html lang=\"de\">") && Contains("Frage 1.") && Contains("Kugel und Kugel") &&
                       Contains("Wie liegen die zwei Kugeln zueinander?"));
  CHECK(page.find("Question") == page.npos);
  const Ran english = shell("isect explain points --lang de");
  CHECK(english.status == 0);
  CHECK_THAT(english.err, Contains("nobody has translated points to Deutsch"));
  CHECK(english.out == shell("isect explain points").out);
}

TEST_CASE("isect lang lists the languages with what each has, and a lesson's texts for translators", "[lang]") {
  const Shell shell;
  const Ran list = shell("isect lang");
  CHECK(list.status == 0);
  CHECK_THAT(list.out,
             Contains("de  Deutsch: scenes and pages, ") && Contains("    sphere-sphere, ") && Contains("zh  中文"));
  const Ran texts = shell("isect lang sphere-sphere");
  CHECK(texts.status == 0);
  CHECK_THAT(texts.out, Contains("msgid \"How are the two balls related?\"\nmsgstr \"\"\n") &&
                            Contains("a of radius {1} and b of radius {2}"));
  CHECK(shell("isect lang sphere-shpere").status == 2);
}

}  // namespace lang_test
