// The lessons as web pages: which files, what stands in them, and what is never written over.

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include "lessons/lessons.h"
#include "tests/app/shell.h"
#include "tests/catch.h"
#include "viz/walk/branch.h"
#include "viz/walk/closing.h"
#include "viz/walk/review.h"

namespace book_test {
using namespace isect::test;
using Catch::Matchers::StartsWith;

/// A page without what its own scripts say, who write elements, too.
std::string without_scripts(const std::string& page) {
  std::string out;
  std::size_t from = 0;
  for (std::size_t at = page.find("<script>\n"); at != page.npos; at = page.find("<script>\n", from)) {
    out += page.substr(from, at - from);
    from = page.find("</script>", at);
    REQUIRE(from != page.npos);
  }
  return out + page.substr(from);
}

/// The ids that stand twice, references to missing ids, and tags that are not closed.
std::string faults(const std::string& page) {
  std::string out;
  std::set<std::string> ids;
  for (const std::string& id : all_between(page, " id=\""))
    if (!ids.insert(id).second) out += "twice: " + id + "\n";
  std::vector<std::string> wanted = all_between(page, "href=\"#");
  for (std::size_t at = page.find("url(#"); at != page.npos; at = page.find("url(#", at + 1))
    wanted.push_back(page.substr(at + 5, page.find(')', at) - at - 5));
  for (const std::string& id : wanted)
    if (!ids.contains(id)) out += "missing: " + id + "\n";
  for (const std::string tag : {"g", "svg", "figure", "article", "section", "p", "table", "tr", "li", "ol", "details"})
    if (count(page, "<" + tag + ">") + count(page, "<" + tag + " ") != count(page, "</" + tag + ">"))
      out += "open: " + tag + "\n";
  return out;
}

/// A page as a browser with scripts reads it: without what waits, which holds nothing else that waits.
std::string at_first(const std::string& page) {
  std::string out;
  std::size_t from = 0;
  for (std::size_t at = page.find("<noscript "); at != page.npos; at = page.find("<noscript ", from)) {
    const std::size_t end = page.find("</noscript>", at);
    REQUIRE(end != page.npos);
    CHECK(page.find("<noscript", at + 1) > end);
    out += page.substr(from, at - from);
    from = page.find('\n', end);
  }
  return out + page.substr(from);
}

int elements(const std::string& page) {
  int sum = 0;
  for (std::size_t at = page.find('<'); at != page.npos; at = page.find('<', at + 1))
    sum += page[at + 1] >= 'a' && page[at + 1] <= 'z';
  return sum;
}

/// A page opens with few elements, and what these refer to is among them.
void check_light(const std::string& page) {
  const std::string first = at_first(page);
  CHECK(elements(first) < 2500);  // scripts add some
  for (const std::string& id : all_between(first, "<use href=\"#"))
    CHECK_THAT(first, Contains("<g id=\"" + id + "\">"));
}

/// Every fifth lesson is followed by a page that asks again what these lessons ask.
void check_reviews(const std::filesystem::path& site) {
  const auto page = [&](const std::string& file) { return contents(site / file); };
  const auto& lessons = isect::lessons::all_lessons();
  const std::string index = page("index.html");
  for (int number = 1; number <= isect::viz::review_count(lessons); ++number) {
    const std::string file = "review-" + std::to_string(number) + ".html", review = page(file);
    INFO(file);
    CHECK(count(index, "href=\"" + file + "\"") == 1);
    const auto block = isect::viz::lessons_of_review(lessons, number);
    CHECK_THAT(page(block.back()->id + ".html"), Contains("href=\"" + file + "\""));
    if (block.size() > 1) CHECK_THAT(page(block.front()->id + ".html"), !Contains("href=\"" + file + "\""));
    std::set<std::string> questions;
    for (const isect::viz::Lesson* lesson : block)
      for (const auto& p : isect::viz::prompts_of(*lesson)) questions.insert(p.lesson + " " + p.question);
    const int asked = static_cast<int>(questions.size());
    CHECK(asked >= isect::viz::questions_a_review);
    const std::vector<std::string> names = all_between(review, "data-asked=\"");
    CHECK(std::set<std::string>(names.begin(), names.end()) == questions);
    CHECK(count(review, "<article class=\"ask\"") == asked);
    CHECK(count(review, "<noscript data-asked=") == asked);
    CHECK(count(review, "<svg class=\"picture\"") == asked);
    CHECK(count(review, " data-right>") == asked);
    CHECK(count(review.substr(review.find("<div class=\"answers\">")), "<b>Question ") == asked);
    for (const std::string& step : all_between(review, "data-step=\"")) {  // each leads to its lesson's step
      const std::size_t hash = step.find('#');
      CHECK_THAT(page(step.substr(0, hash)), Contains("id=\"" + step.substr(hash + 1) + "\"") &&
                                                 Contains("id=\"" + step.substr(hash + 1) + "/question\""));
    }
  }
}

/// A module of WebAssembly that holds nothing.
const std::string empty_wasm("\0asm\1\0\0\0", 8);
/// The card of a lesson says where it leads, what the lesson builds on and how long it takes.
void check_card(const std::string& card, const isect::viz::Lesson& lesson) {
  CHECK_THAT(card, Contains("<a href=\"" + lesson.id + ".html\">") && Contains("<p class=\"facts\">About "));
  CHECK_THAT(card, Contains("data-exercises=\"" + std::to_string(lesson.closing->exercises.size()) + "\""));
  for (const std::string& before : lesson.after) CHECK_THAT(card, Contains("<a href=\"" + before + ".html\">"));
  CHECK(count(card, "<a href=") == 1 + static_cast<int>(lesson.after.size()));
}

TEST_CASE("a book has a page for each lesson, with every preset and every step", "[book]") {
  const Shell shell;
  write(shell.work() / "live.js", "var isect_module;\nisect_module.packed = \"\";\n");
  write(shell.work() / "live.wasm", empty_wasm);
  const Ran r = shell("isect book --live live.js --live-scenes live.js --out site");
  REQUIRE(r.status == 0);
  CHECK(r.err.empty());
  const std::filesystem::path site = shell.work() / "site";
  const auto& lessons = isect::lessons::all_lessons();
  const std::size_t reviews = (lessons.size() + 4) / 5, files = lessons.size() + reviews + 13;
  CHECK(files_in(site).size() == files);
  CHECK(count(r.out, "\n") == static_cast<int>(files));

  std::uintmax_t bytes = 0;
  for (const std::string& file : files_in(site)) {
    const std::string text = contents(site / file);
    INFO(file);
    bytes += text.size();
    CHECK_THAT(text.substr(0, text.find('\n')), Contains("Made by isect book: " + file + "."));
    if (!file.ends_with(".html")) continue;
    CHECK(faults(text) == "");
    check_light(text);
    CHECK_THAT(text, Contains("<!DOCTYPE html>\n<html lang=\"en\">") && !Contains("**") && !Contains("http"));
    CHECK(count(text, "<meta name=\"description\"") == 1);
    CHECK(count(text, "<meta property=\"og:title\"") == 1);
    CHECK(count(text, "<link rel=\"icon\" href=\"data:image/svg+xml;base64,") == 1);
    for (const std::string& target : all_between(text, "href=\""))
      if (!target.starts_with("#") && !target.starts_with("data:"))
        CHECK(std::filesystem::exists(site / target.substr(0, target.find('#'))));
  }
  CHECK(bytes < 610'000 * lessons.size() + 350'000 * reviews);  // a page is read on a phone, too
  CHECK_THAT(contents(site / "convex-polygon.html"),
             Contains("<dd>Bisection: <a href=\"concave-polygon.html\">Point in concave polygon</a>"));

  const std::string scenes = contents(site / "scene.html");
  CHECK_THAT(scenes, Contains("<body data-lesson=\"scene\" data-live=\"scenes.js\">") &&
                         Contains("<h2>Segments that cross, touch and share a stretch</h2>") &&
                         Contains("{&quot;box&quot;: &quot;A&quot;, &quot;lo&quot;: [0, 0], &quot;hi&quot;: [4, 3]}"));
  CHECK_THAT(scenes, Contains("<div id=\"walks\" data-opens-at=\"1\">") && Contains("class=\"scene-state\""));
  CHECK(count(scenes, "<details class=\"written\">") == count(scenes, "<section class=\"walk"));

  // Terms tell where they are explained; letters are no terms.
  CHECK_THAT(contents(site / "book.js"),
             Contains("[\"discriminant\",") && Contains("\"ray-sphere.html\"]") && !Contains("[\"m\","));

  check_reviews(site);
  std::size_t last = 0;
  const std::string index = contents(site / "index.html");
  CHECK_THAT(index, Contains("href=\"scene.html\""));
  const isect::viz::Lesson& first = *lessons.front();
  CHECK_THAT(index, Contains("<a class=\"begin\" href=\"" + first.id + ".html\">Begin with “"));
  CHECK_THAT(index, Contains("<div class=\"hero\" data-shows=\"ray-sphere\" data-preset=\"two-roots\"") &&
                        Contains(" data-code=\"isect.js\">\n<figure") &&
                        Contains("<p class=\"facts\">" + std::to_string(lessons.size()) + " lessons in order, about "));
  const std::size_t verdict = index.find("<div class=\"outcome\">");
  CHECK(index.find("<p class=\"verdict yes\">", verdict) < index.find("</div>", verdict));
  CHECK_THAT(contents(site / "glossary.html"), Contains("<dt id=\"term-back-face\">back face</dt>"));
  CHECK_THAT(index, Contains("\"term-back-face\""));
  for (const isect::viz::Lesson* lesson : lessons) {
    INFO(lesson->id);
    const std::size_t at = index.find("<li data-of=\"" + lesson->id + "\"");
    REQUIRE(at != index.npos);
    check_card(index.substr(at, index.find("</li>", at) - at), *lesson);
    CHECK(at > last);  // in the order of the course
    last = at;
    const std::string page = contents(site / (lesson->id + ".html"));
    int steps = 0, questions = 0, said = 0;
    CHECK(count(page, "<noscript data-setting=\"") == static_cast<int>(lesson->presets.size()) - 1);
    for (const isect::viz::Preset& p : lesson->presets) {
      CHECK_THAT(page, Contains("id=\"" + p.id + "\"") && Contains("href=\"#" + p.id + "\""));
      const isect::viz::Walk walk = lesson->walk(p.parameters);
      for (const isect::viz::Step& step : walk.steps) {
        steps += step.slug != isect::viz::closing_slug;
        questions += bool(step.question);
        if (step.slug != isect::viz::closing_slug)
          said += isect::viz::taken(walk, static_cast<int>(&step - walk.steps.data())).has_value();
      }
      if (&p == &lesson->presets.front())
        CHECK_THAT(page, Contains("<noscript data-stations=\"" + std::to_string(steps + questions) +
                                  "\" data-steps=\"" + std::to_string(steps) + "\">"));
    }
    CHECK(count(page, " data-said=\"") == said);
    CHECK(count(page, "<b class=\"said ") == said);  // without scripts, too
    for (std::size_t ask = page.find("<article class=\"ask\""); ask != page.npos;
         ask = page.find("<article class=\"ask\"", ask + 1))
      CHECK_THAT(page.substr(ask, page.find('>', ask) - ask), !Contains("data-said") && !Contains("data-line"));
    CHECK(count(page, "<article class=\"step") == steps);
    CHECK(count(page, "<article class=\"ask\"") == questions);
    CHECK(count(page, "<svg class=\"picture\"") == steps + questions);
    CHECK(count(page, "role=\"img\" aria-label=\"\"") == 0);
    CHECK(count(page, " data-right>") == questions);
    const auto wrong = [](const isect::viz::Exercise& e) { return !e.program.empty(); };
    const int programs = static_cast<int>(std::ranges::count_if(lesson->closing->exercises, wrong));
    CHECK(count(page, "<summary>Correction</summary>") == programs);
    CHECK(count(page, "<summary>Solution</summary>") == static_cast<int>(lesson->closing->exercises.size()) - programs);
  }
}

TEST_CASE("a program with a wrong line has its lines as code, and its correction folded", "[book]") {
  const Shell shell;
  REQUIRE(shell("isect book intervals --single").status == 0);
  const std::string page = contents(shell.work() / "book/intervals.html");
  const std::string exercises = page.substr(page.find("<section class=\"exercises\""));
  const std::size_t code = exercises.find("<ol class=\"code\">");
  REQUIRE(code != exercises.npos);
  const std::string lines = exercises.substr(code, exercises.find("</ol>", code) - code);
  CHECK(count(lines, "<li>") == 4);
  CHECK_THAT(lines, Contains("return OVERLAP") && Contains("return DISJOINT"));
  const std::size_t correction = exercises.find("Line 3 should read"),
                    folded = exercises.find("<details><summary>Correction</summary>");
  CHECK((code < folded && folded < correction));
  CHECK(exercises.substr(folded, correction - folded).find("</details>") == exercises.npos);
}

TEST_CASE("the lit line of a page's step says yes or no", "[book]") {
  const Shell shell;
  REQUIRE(shell("isect book ray-sphere --single").status == 0);
  const std::string page = contents(shell.work() / "book/ray-sphere.html");
  const auto article = [&](const std::string& id) {
    const std::size_t from = page.find("<article class=\"step\" id=\"" + id + "\"");
    REQUIRE(from != page.npos);
    return page.substr(from, page.find("</article>", from) - from);
  };
  CHECK_THAT(article("two-roots/4"),
             Contains(" data-line=\"3\" data-said=\"no\"") && Contains("<b class=\"said no\">no</b>"));
  CHECK_THAT(article("two-roots/8"),
             Contains(" data-line=\"9\" data-said=\"yes\"") && Contains("<b class=\"said yes\">yes</b>"));
  CHECK_THAT(article("two-roots/7"), Contains(" data-line=\"8\"") && !Contains("data-said"));
}

TEST_CASE("a question stands before its step, and its picture does not tell what comes out", "[book]") {
  const Shell shell;
  REQUIRE(shell("isect book ray-sphere --single").status == 0);
  const std::string page = contents(shell.work() / "book/ray-sphere.html");
  const std::size_t asked = page.find("<article class=\"ask\""), step = page.find("</article>", asked);
  REQUIRE(asked != page.npos);
  const std::string question = page.substr(asked, step - asked);
  const std::string id = all_between(question, "id=\"").front();
  CHECK(page.find("id=\"" + id.substr(0, id.find("/question")) + "\"") > asked);
  CHECK_THAT(question, Contains("aria-label=\"Drawn: ") && !Contains("ray enters"));
}

TEST_CASE("without compiled lessons the picture of the first page stays as it is drawn", "[book]") {
  const Shell shell;
  REQUIRE(shell("isect book").status == 0);
  const std::string index = contents(shell.work() / "book/index.html");
  CHECK_THAT(index, Contains("<div class=\"hero\"") && !Contains("data-code") && !Contains("href=\"scene.html\""));
  CHECK_THAT(contents(shell.work() / "book/points.html"), Contains("<body data-lesson=\"points\">"));
}

TEST_CASE("one lesson in one file needs nothing beside it, and is the same each time", "[book]") {
  const Shell shell;
  const Ran r = shell("isect book points --single --out one");
  CHECK(r.status == 0);
  CHECK(r.out == "one/points.html\n");
  CHECK(files_in(shell.work()) == std::vector<std::string>{"one/points.html"});
  const std::string page = contents(shell.work() / "one/points.html");
  CHECK(faults(without_scripts(page)) == "");
  CHECK_THAT(page, Contains("@font-face") && Contains("SIL OPEN FONT LICENSE") && Contains("addEventListener") &&
                       Contains("var isect_terms = [[\"AABB\",\"Axis-aligned bounding box:") &&
                       !Contains("<link rel=\"stylesheet") && !Contains(" src=\"") && !Contains(".html\""));
  REQUIRE(shell("isect book points --single --out one").status == 0);
  CHECK(contents(shell.work() / "one/points.html") == page);
  REQUIRE(shell("ray-sphere book --out two").status == 0);
  CHECK(files_in(shell.work() / "two") == std::vector<std::string>{"ray-sphere.html"});
}

TEST_CASE("a page with compiled lessons has them, and its fonts for figures that are saved", "[book]") {
  const Shell shell;
  write(shell.work() / "live.js", "isect_module.packed = \"\";\n");
  const Ran r = shell("isect book ray-sphere --single --live live.js --out one");
  REQUIRE(r.status == 0);
  const std::string page = contents(shell.work() / "one" / "ray-sphere.html");
  CHECK_THAT(page, Contains("<body data-lesson=\"ray-sphere\" data-live=\"#live-code\">") &&
                       Contains("<script type=\"text/plain\" id=\"live-code\">") &&
                       Contains("isect_module.packed = ") && Contains("<style id=\"letters\">") &&
                       Contains("function isect_live(book)"));
  CHECK_THAT(page, !Contains(" src=\"isect.js\""));
}

TEST_CASE("a book has its compiled lessons for servers and packed for disk, each with isect's mark", "[book]") {
  const Shell shell;
  write(shell.work() / "live.js", "var isect_module;\nisect_module.packed = \"H4sI\";\n");
  write(shell.work() / "live.wasm", empty_wasm + std::string("\0\2\1x", 4));
  const auto site = shell.work() / "site";
  REQUIRE(shell("isect book --live live.js --out site").status == 0);
  CHECK_THAT(contents(site / "isect.js"), Contains("function isect_live(book)") && Contains("\nvar isect_module;\n") &&
                                              !Contains("isect_module.packed = "));
  CHECK_THAT(contents(site / "isect-packed.js"), Contains("\nisect_module.packed = \"H4sI\";\n"));
  CHECK_THAT(contents(site / "intervals.html"), Contains("data-live=\"isect.js\""));
  // Sections of its own before and behind, as a browser passes over them: 0, the size, the length of a name, the name.
  const std::string wasm = contents(site / "isect.wasm"), mark = "Made by isect book: isect.wasm.";
  REQUIRE(wasm.size() > 60);
  CHECK(wasm.starts_with(empty_wasm));
  std::vector<std::string> sections;
  for (std::size_t at = 8; at + 1 < wasm.size(); at += 2 + static_cast<unsigned char>(wasm[at + 1])) {
    CHECK(wasm[at] == '\0');
    sections.push_back(wasm.substr(at + 2, static_cast<unsigned char>(wasm[at + 1])));
  }
  REQUIRE(sections.size() == 3);
  CHECK(sections[0] == "\5isect" + mark);
  CHECK(sections[1] == "\1x");
  CHECK_THAT(sections[2], StartsWith("\5isectDigest of all above: "));

  write(site / "isect.wasm", wasm + std::string("\0\2\1y", 4));  // edited
  CHECK_THAT(shell("isect book --live live.js --out site").err, Contains("left alone: site/isect.wasm"));
  write(site / "isect.wasm", empty_wasm);  // somebody else's
  CHECK(shell("isect book --live live.js --out site").status == 4);
  write(shell.work() / "live.wasm", "not compiled");
  const Ran wrong = shell("isect book --live live.js --out other");
  CHECK(wrong.status == 2);
  CHECK_THAT(wrong.err, Contains("live.wasm"));
}

TEST_CASE("a book is never written over somebody else's files", "[book]") {
  for (const std::string mine : {"index.html", "picking.html", "book.css", "fonts.css"}) {
    const Shell shell;
    write(shell.work() / "book" / mine, "mine");
    const Ran r = shell("isect book");
    CHECK(r.status == 4);
    CHECK_THAT(r.err, Contains("book/" + mine) && Contains("--out"));
    CHECK(contents(shell.work() / "book" / mine) == "mine");
    CHECK(files_in(shell.work()).size() == 1);  // nothing else was written either
  }
  const Shell shell;
  write(shell.work() / "file", "mine");
  CHECK(shell("isect book --out file").status == 4);
  CHECK(contents(shell.work() / "file") == "mine");
  write(shell.work() / "s/points/far/trace.json",
        R"({"lesson": "points", "preset": "far", "parameters": {}, "steps": []})");
  const Ran among = shell("isect book --out s");
  CHECK(among.status == 2);
  CHECK_THAT(among.err, Contains("baselines"));
  CHECK(files_in(shell.work() / "s").size() == 1);
}

TEST_CASE("a book takes away its own pages of lessons that are gone, and nothing else", "[book]") {
  const Shell shell;
  const auto site = shell.work() / "book";
  const auto own = [](const std::string& file) { return "<!-- Made by isect book: " + file + ". -->\n"; };
  write(site / "gone.html", own("gone.html"));
  write(site / "copy.html", own("index.html"));
  write(site / "mine.html", "<p>mine</p>\n");
  write(site / "notes/gone.html", own("gone.html"));
  std::filesystem::create_symlink(site / "mine.html", site / "link.html");
  write(site / "index.html", own("index.html"));
  REQUIRE(shell("isect book").status == 0);
  CHECK(!std::filesystem::exists(site / "gone.html"));
  for (const std::string kept : {"copy.html", "mine.html", "notes/gone.html", "link.html"})
    CHECK(std::filesystem::exists(site / kept));
  CHECK(contents(site / "index.html").size() > 1000);
}

TEST_CASE("a page of a book that someone has edited is left alone", "[book]") {
  const Shell shell;
  const std::string book = "isect book points --single --out one";
  const auto page = shell.work() / "one/points.html";
  REQUIRE(shell(book).status == 0);
  const std::string own = contents(page);
  const std::size_t body = own.find("<body"), digest = own.rfind("\n<!-- Digest of all above: ");
  REQUIRE((body != own.npos && digest != own.npos));
  const std::string within = std::string(own).insert(body, "<!-- mine -->"), behind = own + "<!-- mine -->\n";
  for (const std::string& edited : {within, behind}) {
    write(page, edited);
    const Ran r = shell(book);
    CHECK(r.status == 0);
    CHECK(r.out.empty());
    CHECK(r.err == "left alone: one/points.html was edited; remove it to have isect's own again\n");
    CHECK(contents(page) == edited);
  }
  const std::string older = own.substr(0, digest);  // from before there were digests
  write(page, older);
  CHECK(shell(book).err.empty());
  CHECK(contents(page) == own);
}

TEST_CASE("what is wrong with the words of a book is said", "[book]") {
  const Shell shell;
  const std::tuple<const char*, const char*> all[] = {{"isect book ray-sphere", "--single"},
                                                      {"isect book --single", "ray-sphere --single"},
                                                      {"isect book ray-spere --single", "ray-sphere"},
                                                      {"isect book --out ''", "--out"}};
  for (const auto& [command, told] : all) {
    const Ran r = shell(command);
    INFO(command);
    CHECK(r.status == 2);
    CHECK_THAT(r.err, Contains(told));
    CHECK(files_in(shell.work()).empty());
  }
}

}  // namespace book_test
