// A playlist as a handout, as slides, as a quiz and as pages: the same stops in the same order, each with its number.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "app/pages/html.h"
#include "lessons/lessons.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/player/reader_state.h"
#include "viz/walk/given_answer.h"
#include "viz/walk/step_text.h"

namespace playlist_paper_test {
namespace fs = std::filesystem;
namespace viz = isect::viz;
using namespace isect::test;
using Catch::Matchers::StartsWith;

namespace {

/// Writes hour.json: a preset, another one, a scene, a setting made by hand, and a lesson's card.
void write_hour(const Shell& shell) {
  write(shell.work() / "disc.json",
        R"({"title": "A disc: inside?", "objects": [{"sphere": "A", "center": [0, 0], "radius": 2},
             {"point": "p", "at": [1, 1]}], "ask": [["p", "A"]]})");
  write(shell.work() / "hour.json", R"({"title": "Rays & balls", "stops": [
    {"lesson": "ray-sphere", "preset": "tangent", "steps": "3-6", "note": "Where does it *end*? 50 % know."},
    {"lesson": "ray-sphere", "preset": "miss", "steps": 5},
    {"scene": "disc.json"},
    {"lesson": "ray-sphere", "steps": "1-2", "parameters": {"radius": 1.25}},
    {"lesson": "ray-sphere", "preset": "two-roots", "steps": "closing"}]})");
}

bool in_order(const std::string& text, const std::vector<std::string>& parts) {
  std::size_t at = 0;
  for (const std::string& part : parts) {
    at = text.find(part, at);
    UNSCOPED_INFO("missing, or too early: " << part);
    if (at == text.npos) return false;
    at += part.size();
  }
  return true;
}

/// There are pictures, and each is a file.
void check_pictures(const fs::path& folder, const std::vector<std::string>& names) {
  CHECK_FALSE(names.empty());
  for (const std::string& picture : names) CHECK(fs::exists(folder / picture));
}

}  // namespace

TEST_CASE("a playlist's handout lists its stops, then prints each with its number and note", "[playlist][handout]") {
  const Shell shell;
  write_hour(shell);
  const Ran r = shell("isect handout hour.json");
  CHECK(r.err.empty());
  REQUIRE(r.status == 0);
  CHECK(r.out == "handouts/hour/handout.tex\nhandouts/hour/handout.html\n");
  const fs::path folder = shell.work() / "handouts/hour";
  const std::string tex = contents(folder / "handout.tex"), html = contents(folder / "handout.html");

  CHECK(in_order(
      tex,
      {"\\section*{Rays \\& balls}", "\\item[1.] Ray and sphere, steps 3--6",
       "\\item[2.] Ray and sphere, "
       "step 5",
       "\\item[3.] A disc: inside?", "\\item[5.] ", "\\clearpage", "\\subsection*{1 of 5: Ray and sphere}", "\\% know.",
       "\\textbf{Given}", "\\subsubsection*{3. Inside or outside?}", "\\input{01-ray-sphere/03-distance.tikz}",
       "\\subsection*{2 of 5: Ray and sphere}", "\\subsection*{3 of 5: A disc: inside?}",
       "Decided exactly for these numbers", "\\subsection*{4 of 5: Ray and sphere}",
       "\\subsection*{5 of 5: ", "\\textbf{Exercise 1.}", "\\subsection*{Answers}", "\\textbf{Question 1.}"}));
  CHECK(
      in_order(html, {"<h1>Rays &amp; balls</h1>", "<li value=\"1\"><a href=\"#stop-1\">Ray and sphere, steps 3–6</a>",
                      "<div class=\"page\"></div>", "<h2 id=\"stop-1\">1 of 5: Ray and sphere</h2>",
                      "<p>Where does it <i>end</i>? 50 % know.</p>", "<h3>3. Inside or outside?</h3>",
                      "<h2 id=\"stop-2\">2 of 5: ", "<h2>Answers</h2>"}));
  for (const std::string& text : {tex, html}) {
    // A setting's name may answer a question. What stands in a stop before is not printed again.
    CHECK_THAT(text.substr(0, text.find("1 of 5")), !Contains("tangent") && !Contains("miss"));
    CHECK(count(text, "Where a ray or a segment meets a sphere, by three methods.") == 1);
    CHECK(count(text, "The algorithm is that of stop 1.") == 3);
    // Questions are counted through all stops, and so are their answers.
    CHECK(in_order(text, {"Question 3.", "2 of 5: ", "Question 4.", "Answers", "Question 3.", "Question 4."}));
    CHECK(count(text, "Question 4.") == 2);
    CHECK_THAT(text, !Contains("Question 5."));
  }
  check_pictures(folder, all_between(tex, "\\input{", '}'));
  check_pictures(folder, all_between(html, "src=\""));
  for (const std::string& id : all_between(html, "href=\"#")) CHECK_THAT(html, Contains("id=\"" + id + "\""));
  // The first question of a stop has no picture above that might serve it.
  CHECK_THAT(tex, Contains("\\input{02-ray-sphere/05-passing-distance-question.tikz}"));

  const Ran shown = shell("isect show handouts/hour/02-ray-sphere/05-passing-distance.svg");
  CHECK(shown.status == 77);  // no display here, but the place is known
  CHECK_THAT(shown.err, Contains("isect render ray-sphere --preset miss"));
  REQUIRE(shell("isect handout hour.json").status == 0);  // over its own files
  CHECK(contents(folder / "handout.tex") == tex);
  write(folder / "handout.tex", "mine");
  CHECK(shell("isect handout hour.json").status == 4);
  CHECK(contents(folder / "handout.tex") == "mine");
}

TEST_CASE("a playlist without a title bears its file's name, one setting may be several stops", "[playlist][handout]") {
  const Shell shell;
  write(shell.work() / "week_2.json",
        R"({"stops": [{"lesson": "points", "steps": 1}, {"lesson": "points", "steps": 1}]})");
  REQUIRE(shell("isect handout week_2.json").status == 0);
  const fs::path folder = shell.work() / "handouts/week_2";
  CHECK_THAT(contents(folder / "handout.html"),
             Contains("<h1>week_2</h1>") && Contains("1 of 2: ") && Contains("2 of 2: "));
  CHECK_THAT(contents(folder / "handout.tex"), Contains("\\input{01-points/") && Contains("\\input{02-points/"));
}

TEST_CASE("a playlist's deck begins with its stops, their notes are the speaker's", "[playlist][deck]") {
  const Shell shell;
  write_hour(shell);
  REQUIRE(shell("isect deck hour.json").out == "decks/hour/deck.tex\ndecks/hour/deck.html\n");
  const fs::path folder = shell.work() / "decks/hour";
  const std::string tex = contents(folder / "deck.tex"), html = contents(folder / "deck.html");
  CHECK(in_order(tex, {"% The speaker's notes: \\setbeameroption", "\\begin{document}", "\\frametitle{Rays \\& balls}",
                       "\\item[1.] ", "\\item[5.] ", "\\frametitle{1 of 5: Ray and sphere}", "\\textbf{Given}",
                       "\\note{Where does it ", "\\frametitle{Algorithm}", "\\frametitle{Question 1}",
                       "\\frametitle{Question 3}", "\\frametitle{2 of 5: ", "\\frametitle{Question 4}",
                       "\\frametitle{3 of 5: A disc: inside?}", "\\frametitle{4 of 5: ", "\\frametitle{5 of 5: ",
                       "\\frametitle{Exercise 1}", "\\frametitle{Solution of exercise 1}"}));
  CHECK(std::ranges::all_of(tex, [](char c) { return static_cast<unsigned char>(c) < 128; }));
  CHECK(count(tex, "\\begin{frame}") == count(html, "<section>"));
  CHECK(count(tex, "\\note{") == 1);
  CHECK(count(tex, "\\frametitle{Algorithm}") == 1);
  CHECK_THAT(tex, !Contains("\\frametitle{Question 5}"));
  CHECK(in_order(html, {"<h2>1 of 5: Ray and sphere</h2>", "<aside class=\"note\">", "</section>"}));
  CHECK(count(html, "<aside") == 1);
  CHECK_THAT(html, !Contains("href=\"#stop"));  // an address there is a slide's number
  CHECK(count(html, "src=\"") == count(html, "src=\"data:"));
  check_pictures(folder, all_between(tex, "\\input{", '}'));
  REQUIRE(shell("isect deck ray-sphere --step 3").status == 0);
  CHECK_THAT(contents(shell.work() / "decks/ray-sphere/two-roots/deck.tex"),
             !Contains("\\note{") && !Contains("setbeameroption"));
}

TEST_CASE("a quiz has a lesson's questions and their pictures, then answers and replies, and no step", "[quiz]") {
  const Shell shell;
  REQUIRE(shell("isect quiz ray-sphere --preset tangent").out ==
          "quizzes/ray-sphere/tangent/quiz.tex\nquizzes/ray-sphere/tangent/quiz.html\n");
  const fs::path folder = shell.work() / "quizzes/ray-sphere/tangent";
  const std::string tex = contents(folder / "quiz.tex"), html = contents(folder / "quiz.html");
  for (const std::string& file : files_in(folder)) {
    INFO(file);
    CHECK((file.starts_with("quiz.") || file.find("-question.") != file.npos));
  }
  const viz::Lesson& lesson = viz::lesson_named(isect::lessons::all_lessons(), "ray-sphere");
  const viz::Walk walk = lesson.walk(viz::preset(lesson, "tangent").parameters);
  const std::string asked = html.substr(0, html.find("<h2>Answers</h2>")), answers = html.substr(asked.size());
  int questions = 0, replies = 0;
  for (int step = 0; step < static_cast<int>(walk.steps.size()); ++step) {
    CHECK_THAT(html, !Contains("<h2>" + std::to_string(step + 1) + ". "));
    const auto q = viz::question_text(walk, step);
    if (!q) continue;
    ++questions;
    INFO(q->prompt);
    CHECK_THAT(asked, Contains(isect::program::html_text(q->whole_prompt)));
    CHECK_THAT(asked, !Contains(isect::program::html_text(q->because)));
    CHECK_THAT(answers, Contains(isect::program::html_text(q->because)));
    for (std::size_t i = 0; !q->asked->order && !q->asked->line && i < q->choices.size(); ++i) {
      const std::string reply = i == q->right ? "" : viz::reply_to(walk, step, viz::GivenAnswer{static_cast<int>(i)});
      if (reply.empty()) continue;
      ++replies;
      CHECK_THAT(asked, !Contains(isect::program::html_text(reply)));
      CHECK_THAT(answers, Contains("<p>(" + std::string(1, viz::choice_letter(i)) + ") ") &&
                              Contains(": " + isect::program::html_text(reply)));
    }
  }
  CHECK((questions >= 4 && replies >= 2));
  CHECK(count(tex, "\\textbf{Question ") == 2 * questions);
  CHECK(in_order(tex, {"\\textbf{Given}", "Question 1.", "Question 4.", "\\clearpage", "{Answers}", "Question 1."}));
  check_pictures(folder, all_between(tex, "\\input{", '}'));
  CHECK(count(tex, "\\input{") >= 2);
  CHECK(shell("ray-sphere quiz --preset tangent --out one").status == 0);
}

TEST_CASE("the replies to wrong lines and orders stand in a quiz, too", "[quiz]") {
  const Shell shell;
  int lines = 0, orders = 0;
  for (const viz::Lesson* lesson : isect::lessons::all_lessons()) {
    const viz::Walk walk = lesson->walk(lesson->presets.front().parameters);
    std::vector<std::string> wanted;
    const auto want = [&](const std::string& given, const std::string& reply, int& of_kind) {
      if (reply.empty()) return;
      wanted.push_back(given + ": " + isect::program::html_text(reply));
      ++of_kind;
    };
    for (const viz::Step& step : walk.steps) {
      if (step.question && step.question->line)
        for (const viz::WrongLine& wrong : step.question->line->wrong)
          want("<p>Line " + std::to_string(wrong.line + 1), wrong.reply, lines);
      if (step.question && step.question->order)
        for (const viz::WrongOrder& wrong : step.question->order->wrong) want(")", wrong.reply, orders);
    }
    if (wanted.empty()) continue;
    INFO(lesson->id);
    REQUIRE(shell("isect quiz " + lesson->id + " --out out").status == 0);
    const std::string html = contents(shell.work() / "out" / lesson->id / lesson->presets.front().id / "quiz.html");
    for (const std::string& reply : wanted) CHECK_THAT(html.substr(html.find("<h2>Answers</h2>")), Contains(reply));
    if (lines > 0 && orders > 0) break;
  }
  CHECK((lines > 0 && orders > 0));
}

TEST_CASE("a playlist's quiz has the stops that ask, under their own numbers", "[playlist][quiz]") {
  const Shell shell;
  write_hour(shell);
  REQUIRE(shell("isect quiz hour.json").out == "quizzes/hour/quiz.tex\nquizzes/hour/quiz.html\n");
  const std::string html = contents(shell.work() / "quizzes/hour/quiz.html");
  CHECK(all_between(html, "<li value=\"") == std::vector<std::string>{"1", "2"});
  CHECK(in_order(html, {"1 of 5: ", "50 % know.", "Question 1.", "Question 3.", "2 of 5: ", "Question 4.",
                        "<h2>Answers</h2>", "Question 4."}));
  CHECK_THAT(html, !Contains("3 of 5") && !Contains("5 of 5") && !Contains("Exercise"));
}

TEST_CASE("a quiz without a question is refused", "[quiz]") {
  const Shell shell;
  write_hour(shell);
  write(shell.work() / "quiet.json", R"({"stops": [{"lesson": "ray-sphere", "steps": 1}]})");
  for (const char* words : {"disc.json", "ray-sphere --step 1", "quiet.json"}) {
    INFO(words);
    const Ran r = shell(std::string("isect quiz ") + words);
    CHECK(r.status == 2);
    CHECK(r.out.empty());
    CHECK_THAT(r.err, StartsWith("isect: step: no step of ") && Contains("asks a question") && Contains("handout"));
  }
  CHECK_FALSE(fs::exists(shell.work() / "quizzes"));
}

TEST_CASE("what is wrong with a playlist is said by every command that takes one, before it writes", "[playlist]") {
  const Shell shell;
  for (const std::string command : {"handout", "deck", "quiz", "book --playlist"}) {
    const auto refused = [&](const std::string& stops, const std::string& words, int status, const std::string& why) {
      write(shell.work() / "hour.json", "{\"stops\": [\n" + stops + "\n]}\n");
      const Ran r = shell("isect " + command + " hour.json" + words);
      INFO(command << words);
      CHECK(r.status == status);
      CHECK(r.out.empty());
      CHECK_THAT(r.err, StartsWith("isect: ") && Contains(why));
      CHECK(files_in(shell.work()) == std::vector<std::string>{"hour.json"});
    };
    refused("{\"lesson\": \"rays\"},\n{}", "", 2, "hour.json: stop 2, line 3: lesson: missing");
    refused("{\"lesson\": \"ray-sphere\", \"steps\": \"99\"}", "", 2, "hour.json: stop 1, line 2: steps: \"99\"");
    refused("{\"scene\": \"gone.json\"}", "", 4, "hour.json: stop 1, line 2: scene: ");
    refused("{\"lesson\": ", "", 2, "hour.json: line 3");
    if (command.starts_with("book")) continue;
    refused("{\"lesson\": \"rays\"}", " --step 3", 2, "step: not allowed with a playlist");
    refused("{\"lesson\": \"rays\"}", " --set radius=3", 2, "set: not allowed with a playlist");
  }
  const Ran single = shell("isect book ray-sphere --single --playlist hour.json");
  CHECK(single.status == 2);
  CHECK_THAT(single.err, Contains("playlist: ") && Contains("--single"));
  for (const char* file : {"hour.json", "other/hour.json"})
    write(shell.work() / file, R"({"stops": [{"lesson": "rays"}]})");
  const Ran twice = shell("isect book --playlist hour.json --playlist other/hour.json");
  CHECK(twice.status == 2);
  CHECK_THAT(twice.err, Contains("would both be hour-hour.html"));
  CHECK_FALSE(fs::exists(shell.work() / "book"));
}

TEST_CASE("a playlist in the book leads through the lessons' pages, step by step, question by question",
          "[playlist][book]") {
  const Shell shell;
  write_hour(shell);
  const Ran r = shell("isect book --playlist hour.json --out site");
  CHECK(r.err.empty());
  REQUIRE(r.status == 0);
  const fs::path site = shell.work() / "site";
  const auto page = [&](const std::string& file) { return contents(site / file); };
  CHECK_THAT(page("index.html"), Contains("<li><a href=\"hour-hour.html\">Rays &amp; balls</a></li>"));
  const std::string hour = page("hour-hour.html"), script = page("hour-hour.js");
  CHECK(in_order(hour, {"<h1>Rays &amp; balls</h1>", "data-hour=\"hour\"",
                        "<a href=\"ray-sphere.html?hour=hour&amp;stop=1#tangent/3\">Begin</a>", "<ol class=\"stops\">",
                        "<a href=\"ray-sphere.html?hour=hour&amp;stop=1#tangent/3\">Ray and sphere</a>, steps 3–6",
                        "<p>Where does it <i>end</i>? 50 % know.</p>", "stop=2#miss/5/question\">",
                        "hour-hour-3.html?hour=hour&amp;stop=3#setting/1\">A disc: inside?</a>", "hour-hour-4.html?",
                        "ray-sphere.html?hour=hour&amp;stop=5#remember"}));
  CHECK_THAT(hour, !Contains("tangent</a>") && !Contains("<svg"));

  const std::string begin = "var isect_hour = ";
  const std::size_t from = script.find(begin) + begin.size();
  const auto told = nlohmann::json::parse(script.substr(from, script.find(";\n", from) - from));
  CHECK(told["title"] == "Rays & balls");
  REQUIRE(told["stops"].size() == 5);
  CHECK(told["stops"][0]["places"] ==
        std::vector<std::string>{"ray-sphere.html#tangent/3", "ray-sphere.html#tangent/4/question",
                                 "ray-sphere.html#tangent/4", "ray-sphere.html#tangent/5/question",
                                 "ray-sphere.html#tangent/5", "ray-sphere.html#tangent/6/question",
                                 "ray-sphere.html#tangent/6"});
  CHECK(told["stops"][1]["places"] ==
        std::vector<std::string>{"ray-sphere.html#miss/5/question", "ray-sphere.html#miss/5"});
  CHECK(told["stops"][4]["places"] == std::vector<std::string>{"ray-sphere.html#remember"});
  CHECK(told["stops"][0]["note"] == "Where does it <i>end</i>? 50 % know.");
  for (const auto& stop : told["stops"])
    for (const std::string place : stop["places"]) {
      INFO(place);
      const std::size_t hash = place.find('#');
      CHECK_THAT(page(place.substr(0, hash)), Contains("id=\"" + place.substr(hash + 1) + "\""));
    }
  // A scene, and a setting that no page of a lesson shows.
  CHECK_THAT(page("hour-hour-3.html"),
             Contains("<h1>A disc: inside?</h1>") && Contains("Decided exactly for these numbers"));
  CHECK_THAT(page("hour-hour-4.html"), Contains("1.25") && Contains("<a href=\"ray-sphere.html\">The lesson</a>"));
  CHECK_FALSE(fs::exists(site / "hour-hour-1.html"));

  REQUIRE(shell("isect book --out site").status == 0);  // it is not asked for any more
  for (const std::string& file : files_in(site)) CHECK_FALSE(file.starts_with("hour-"));
}

TEST_CASE("a stop's time is in the address of its step, and in the picture of a page of its own", "[playlist][book]") {
  const Shell shell;
  const std::string timed = R"({"lesson": "moving-bodies", "preset": "boxes-meet", "step": 8, "time": 0.75})";
  const std::string own = R"({"lesson": "moving-bodies", "parameters": {"r_a": 0.875}, "step": 8, "time": 0.75})";
  write(shell.work() / "moves.json", "{\"stops\": [" + timed + ",\n" + own + "]}");
  REQUIRE(shell("isect book --playlist moves.json --out site").status == 0);
  const std::string script = contents(shell.work() / "site/hour-moves.js");
  CHECK_THAT(script,
             Contains("\"moving-bodies.html#boxes-meet/8?time=0.75\"") && Contains("\"hour-moves-2.html#setting/8\""));
  CHECK_THAT(contents(shell.work() / "site/hour-moves-2.html"), Contains("The picture shows "));
}

}  // namespace playlist_paper_test
