// A lesson to print: which files, what stands in them, and what is never written over.

#include <filesystem>

#include "tests/app/shell.h"
#include "tests/catch.h"

namespace handout_test {
using namespace isect::test;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

TEST_CASE("a handout has pictures, captions, pseudocode, questions, and the answers at the end", "[handout]") {
  const Shell shell;
  const Ran r = shell("isect handout ray-sphere --preset tangent");
  CHECK(r.status == 0);
  CHECK(r.err.empty());
  CHECK(r.out == "handouts/ray-sphere/tangent/handout.tex\nhandouts/ray-sphere/tangent/handout.html\n");
  const std::string folder = (shell.work() / "handouts/ray-sphere/tangent/").string();
  const std::string tex = contents(folder + "handout.tex"), html = contents(folder + "handout.html");

  CHECK_THAT(tex, StartsWith("% Made by isect handout.\n% Tags ") && Contains("\n\\documentclass[10pt]{article}\n") &&
                      EndsWith("\\end{document}\n"));
  CHECK_THAT(tex,
             Contains("\\input{03-distance.tikz}") && Contains("\\textbf{Question 1.}") && Contains("\\leftarrow"));
  CHECK_THAT(html, Contains("<img src=\"03-distance.svg\" alt=\"Ray and sphere: ") && Contains("<h2>Answers</h2>"));
  for (const std::string& text : {tex, html}) {
    CHECK(text.find("Answers") > text.rfind("03-distance"));
    CHECK(text.find("**") == text.npos);  // no mark is left
  }
  // Pseudocode has its names as the text has them.
  CHECK_THAT(tex, Contains("if $t > t_{\\mathrm{max}}$") && Contains("\\mathbf{l} \\cdot") && !Contains("t\\_max"));
  CHECK_THAT(html, Contains("<i>t</i><sub>max</sub>") && Contains("text-indent"));
  CHECK(std::filesystem::exists(folder + "03-distance.tikz"));
  CHECK(std::filesystem::exists(folder + "03-distance.svg"));
  CHECK(std::filesystem::exists(shell.work() / "handouts/manifest.json"));

  REQUIRE(shell("isect handout ray-sphere --preset tangent").status == 0);  // over its own files, with the same bytes
  CHECK(contents(folder + "handout.tex") == tex);
  CHECK(contents(folder + "handout.html") == html);
}

TEST_CASE("the solutions of a deck stand behind all its exercises, each with its number", "[handout]") {
  const Shell shell;
  REQUIRE(shell("isect deck ray-sphere --preset tangent").status == 0);
  REQUIRE(shell("isect handout ray-sphere --preset tangent").status == 0);
  for (const std::string kind : {"deck.tex", "deck.html"}) {
    INFO(kind);
    const std::string deck = contents(shell.work() / "decks/ray-sphere/tangent" / kind);
    std::size_t last = deck.find("Exercise 1");
    REQUIRE(last != deck.npos);
    for (const char* next : {"Exercise 2", "Exercise 3", "Solution of exercise 1", "Solution of exercise 2"}) {
      const std::size_t at = deck.find(next);
      REQUIRE(at != deck.npos);
      CHECK(at > last);
      last = at;
    }
  }
  const std::string html = contents(shell.work() / "handouts/ray-sphere/tangent/handout.html");
  const std::string answers = html.substr(html.find("<h2>Answers</h2>"));
  CHECK_THAT(answers, Contains("<b>Exercise 1.</b>") && Contains("<b>Exercise 2.</b>"));
}

TEST_CASE("the lit line of a handout's or a deck's step says yes or no", "[handout]") {
  const Shell shell;
  for (const std::string kind : {"handout", "deck"}) {
    INFO(kind);
    REQUIRE(shell("isect " + kind + " ray-sphere --step 4,7,8 --out out").status == 0);
    const std::string stem = (shell.work() / "out/ray-sphere/two-roots" / kind).string();
    const std::string tex = contents(stem + ".tex"), html = contents(stem + ".html");
    CHECK(count(tex, "\\quad\\textbf{yes}") == 1);
    CHECK(count(tex, "\\quad\\textbf{no}") == 1);
    CHECK(count(html, "  <b>yes</b></li>") == 1);
    CHECK(count(html, "  <b>no</b></li>") == 1);
    CHECK(count(html, "<li class=\"current\">") == (kind == "deck" ? 3 : 2));
  }
  const std::string html = contents(shell.work() / "out/ray-sphere/two-roots/handout.html");
  CHECK_THAT(html, Contains("<ol class=\"code\" start=\"10\">\n<li class=\"current\">if "));
}

TEST_CASE("a handout is never written over a file of somebody else's", "[handout]") {
  const Shell shell;
  const auto mine = shell.work() / "handouts/ray-sphere/two-roots/handout.tex";
  write(mine, "\\documentclass{letter}\n");
  const Ran r = shell("isect handout ray-sphere");
  CHECK(r.status == 4);
  CHECK_THAT(r.err, Contains("handout.tex") && Contains("--out"));
  CHECK(contents(mine) == "\\documentclass{letter}\n");
  CHECK(files_in(shell.work()).size() == 1);  // nothing else was written either
}

TEST_CASE("pages and pictures of a handout or deck that someone has edited are left alone", "[handout]") {
  const Shell shell;
  for (const std::string kind : {"handout", "deck"}) {
    INFO(kind);
    const std::string command = "isect " + kind + " intervals --out out", folder = "out/intervals/overlapping/";
    REQUIRE(shell(command).err.empty());
    CHECK(shell(command + " --theme grey").err.empty());  // over its own
    const auto tex = shell.work() / folder / (kind + ".tex");
    const std::string mine = contents(tex) + "% a note of mine\n";
    write(tex, mine);
    const Ran r = shell(command);
    CHECK(r.status == 0);
    CHECK_THAT(r.err, Contains("left alone: " + folder + kind + ".tex was edited; remove it"));
    CHECK(r.out == folder + kind + ".html\n");
    CHECK(contents(tex) == mine);
    std::filesystem::remove(tex);
    CHECK(shell(command).err.empty());
    CHECK_THAT(contents(tex), !Contains("a note of mine") && Contains("Made by isect"));
  }
  const auto picture = shell.work() / "out/intervals/overlapping/01-opening.tikz";
  REQUIRE(std::filesystem::exists(picture));
  write(picture, "% mine\n");
  CHECK_THAT(shell("isect handout intervals --out out").err, Contains("01-opening.tikz was edited"));
  CHECK(contents(picture) == "% mine\n");
}

TEST_CASE("a question stands before the title of its step, which may be the answer", "[handout]") {
  const std::tuple<const char*, const char*, const char*> all[] = {
      {"convex-hull/scattered", "How many points leave the chain?", ": drop one, then append"},
      {"crossings/grazed-two", "Which line settles it?", ": crossed on the right"},
      {"clipping/both-ends-cut", "Lines 1 to 3 need no more than", "outcodes"}};
  const Shell shell;
  for (const auto& [place, question, title] : all) {
    const std::string name = place, lesson = name.substr(0, name.find('/')), preset = name.substr(name.find('/') + 1);
    const std::string of = lesson + " --preset " + preset;
    std::vector<std::pair<std::string, std::string>> texts = {
        {"explain", shell("COLUMNS=200 isect explain " + of).out}};
    for (const std::string command : {"handout", "deck"}) {
      REQUIRE(shell("isect " + command + " " + of + " --out out").status == 0);
      for (const std::string suffix : {".tex", ".html"})
        texts.emplace_back(command + suffix, contents((shell.work() / "out" / name / (command + suffix)).string()));
    }
    for (const auto& [kind, text] : texts) {
      INFO(name << ", " << kind);
      const std::size_t asked = text.find(question), told = text.find(title);
      REQUIRE((asked != std::string::npos && told != std::string::npos));
      CHECK(asked < told);
    }
  }
}

TEST_CASE("a question of a handout has the picture and the numbers of its own step, and all that is given",
          "[handout]") {
  const Shell shell;
  REQUIRE(shell("isect handout obb-obb --preset normal-of-b").status == 0);
  const auto folder = shell.work() / "handouts/obb-obb/normal-of-b";
  const std::string tex = contents(folder / "handout.tex"), html = contents(folder / "handout.html");
  const std::size_t asked = tex.find("\\input{03-normals-b-question.tikz}"), words = tex.find("Of the normals of b");
  const std::size_t told = tex.find("\\input{03-normals-b.tikz}");
  CHECK((asked < words && words < told && told != tex.npos));
  CHECK_THAT(contents(folder / "03-normals-b.tikz"), Contains("1.2879"));
  CHECK_THAT(contents(folder / "03-normals-b-question.tikz"), !Contains("1.2879"));
  CHECK_THAT(html, Contains("<img src=\"03-normals-b-question.svg\" alt=\"Drawn: "));
  for (const std::string& text : {tex, html}) {
    const std::size_t given = text.find(">Given<") != text.npos ? text.find(">Given<") : text.find("{Given}");
    REQUIRE(given != text.npos);
    CHECK(text.find("0.625", given) < text.find("Which axes can separate?"));
    const std::size_t question = text.find("of b", text.find("Question 1."));
    CHECK(text.find("0.625", question) < text.find("Question 2."));  // h_v, which r_b is computed from
  }
  // A question that looks as the step before it has no second picture.
  CHECK_FALSE(std::filesystem::exists(folder / "04-relation-question.svg"));
  REQUIRE(shell("isect handout ray-sphere").status == 0);
  CHECK_FALSE(std::filesystem::exists(shell.work() / "handouts/ray-sphere/two-roots/06-passes-by-question.svg"));
  CHECK_THAT(contents(shell.work() / "handouts/ray-sphere/two-roots/handout.tex"),
             Contains("What is $m^{2}$? Given: $s = 4.472$, $l^{2} = 21.146$"));
}

}  // namespace handout_test
