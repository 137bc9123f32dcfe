// What a report says of many failures: their causes, GitHub's annotations, where texts differ, and pages with many
// pictures.

#include "app/checks/causes.h"

#include <nlohmann/json.hpp>

#include "app/checks/check_report.h"
#include "app/checks/text_difference.h"
#include "app/figures/digest.h"
#include "tests/app/refusals.h"
#include "tests/app/shell.h"
#include "tests/catch.h"

namespace check_causes_test {
namespace fs = std::filesystem;
using namespace isect::test;
using Catch::Matchers::StartsWith;
using isect::program::Acceptance;
using isect::program::by_cause;
using isect::program::CauseGroup;
using isect::program::Failure;
using isect::program::first_difference;
using isect::program::heading;
using isect::program::Report;
using isect::program::Reviewed;
using isect::viz::Change;
using Kind = Failure::Kind;

namespace {

/// A failure of a preset's step, or of its trace.
Failure failed(Kind kind, const std::string& preset, int step, const std::string& cause = {}) {
  Failure f{kind, "lesson", preset, step};
  f.what = "something differs in " + preset;
  f.cause = cause;
  f.baseline = "snapshots/lesson/" + preset + (step < 0 ? "/trace.json" : "/0" + std::to_string(step + 1) + "-a.png");
  return f;
}

Report with(std::vector<Failure> failures) {
  Report r{{"isect", {}, {}, "figs", {}, {}}, "figs/snapshots"};
  r.failures = std::move(failures);
  return r;
}

/// Makes so many causes, a failure each.
Report of_causes(int causes) {
  std::vector<Failure> failures;
  for (int i = 0; i < causes; ++i) failures.push_back(failed(Kind::picture, "p", i, "cause " + std::to_string(i)));
  return with(failures);
}

}  // namespace

TEST_CASE("failures are grouped by cause, and the largest group comes first", "[causes]") {
  const Report r = with({failed(Kind::picture, "a", 0, "only pixels differ"), failed(Kind::trace, "b", -1, "r moved"),
                         failed(Kind::picture, "b", 0, "r moved"), failed(Kind::missing, "c", 0),
                         failed(Kind::picture, "b", 1, "r moved"), failed(Kind::missing, "c", -1)});
  const std::vector<CauseGroup> groups = by_cause(r);
  REQUIRE(groups.size() == 3);
  CHECK(heading(groups[0]) == "2 pictures and 1 trace: r moved");
  CHECK(heading(groups[1]) == "1 picture and 1 trace: no baseline yet");
  CHECK(heading(groups[2]) == "1 picture: only pixels differ");
  CHECK(groups[0].failures[0]->kind == Kind::trace);  // in the order of the report

  Report accepted = r;
  for (Failure& f : accepted.failures) f.accepted = true;
  CHECK(by_cause(accepted).empty());
}

TEST_CASE("a setting explains all pictures, a computed value those of its step, and else only pixels differ",
          "[causes]") {
  using isect::program::cause_of_picture;
  using isect::program::cause_of_trace;
  const Change drawing{2, "r moved 3 px", Change::Of::drawing, "r moved"};
  const Change course{3, "d was 1, is 2", Change::Of::course, "d changed"};
  const Change moved_there{3, "s moved 1 px", Change::Of::drawing, "s moved"};
  const Change setting{-1, "p was 1, is 2", Change::Of::setting, "p was 1, is 2"};
  const std::vector<Change> several = {course, drawing, moved_there};
  CHECK(cause_of_picture(several, 2) == "r moved");
  CHECK(cause_of_picture(several, 3) == "d changed");
  CHECK(cause_of_picture(several, 1) == "only pixels differ");
  CHECK(cause_of_picture({}, 0) == "only pixels differ");
  CHECK(cause_of_picture({course}, 3) == "only pixels differ");  // what it shows is the same
  CHECK(cause_of_trace(several) == "d changed");
  const std::vector<Change> all = {setting, course, drawing};
  for (const int step : {0, 2, 3}) CHECK(cause_of_picture(all, step) == "p was 1, is 2");
}

TEST_CASE("many failures of one cause are told in a line each, and the causes at the end", "[causes]") {
  std::vector<Failure> failures;
  for (int i = 0; i < 11; ++i) failures.push_back(failed(Kind::picture, "a", i, "r moved"));
  failures.push_back(failed(Kind::picture, "b", 0, "only pixels differ"));
  const std::string text = to_text(with(failures));
  CHECK(count(text, "FAILED ") == 12);
  CHECK(count(text, "    baseline ") == 2);  // of the first of each cause
  CHECK_THAT(text, Contains("by cause:\n    11 pictures: r moved\n    1 picture: only pixels differ\nto accept all"));
  failures.resize(3);
  const std::string few = to_text(with(failures));
  CHECK(count(few, "    baseline ") == 3);
  CHECK_THAT(few, !Contains("by cause"));

  failures.assign(11, failed(Kind::missing, "a", 0));  // these are a line each anyway
  CHECK_THAT(to_text(with(failures)), !Contains("by cause"));
}

TEST_CASE("texts are escaped as GitHub's commands demand", "[github]") {
  using isect::program::github_message;
  using isect::program::github_property;
  CHECK(github_message("50 %, a: b\r\nc %0A") == "50 %25, a: b%0D%0Ac %250A");
  CHECK(github_property("50 %, a: b\r\nc") == "50 %25%2C a%3A b%0D%0Ac");
  CHECK(github_message("“é”") == "“é”");
}

TEST_CASE("each cause is an annotation, and the tenth tells of the rest", "[github]") {
  CHECK(to_github(with({})).empty());
  Report two = of_causes(2);
  two.failures.push_back(two.failures[0]);
  two.failures[0].line = 7;
  two.failures[0].what = "50 %\nand more";
  const std::string text = to_github(two);
  CHECK(count(text, "\n") == 2);
  CHECK_THAT(text,
             StartsWith("::error file=snapshots/lesson/p/01-a.png,line=7,title=isect check%3A 2 pictures%3A cause "
                        "0::lesson p, step 1: 50 %25%0Aand more%0Ain lesson p, step 1; lesson p, step 1%0Ato "
                        "accept all of it: isect check --dir figs --update=failed\n::error "));
  CHECK_THAT(text, Contains("line=1,title=isect check%3A 1 picture%3A cause 1::"));

  CHECK(count(to_github(of_causes(10)), "::error ") == 10);
  const std::string many = to_github(of_causes(14));
  CHECK(count(many, "::error ") == 10);
  CHECK_THAT(many, Contains("title=isect check%3A 5 more causes::1 picture: cause 9%0A1 picture: cause 10%0A") &&
                       Contains("cause 13\n"));
}

TEST_CASE("an annotation is cut between letters, and names files as the repository does", "[github]") {
  Report r = of_causes(1);
  for (const std::size_t odd : {0, 1}) {
    r.failures[0].what = std::string(odd, 'x');
    for (int i = 0; i < 5000; ++i) r.failures[0].what += "é";
    r.failures[0].baseline = (fs::current_path() / "figs/a, b.png").string();
    const std::string text = to_github(r);
    CHECK(text.size() < 4000);
    CHECK_THAT(text, StartsWith("::error file=figs/a%2C b.png,line=1,") && Contains("é…\n"));
    CHECK_NOTHROW(nlohmann::json(text).dump());  // it is UTF-8
  }
}

TEST_CASE("the summary of a job is a table that no text breaks, and is bounded", "[github]") {
  CHECK(count(to_markdown(with({})), "\n|") == 0);
  Report r = of_causes(1);
  r.failures[0].cause = "a | b <script> `c` *d*\ne";
  const std::string text = to_markdown(r);
  CHECK_THAT(text, Contains("| 1 picture | a \\| b &lt;script> \\`c\\` \\*d\\* e | lesson p, step 1 |\n"));
  CHECK_THAT(text, Contains("isect check --dir figs --update=failed"));
  Report many = of_causes(3000);
  for (Failure& f : many.failures) f.cause += std::string(5000, '|'), f.preset = std::string(5000, '<');
  const std::string cut = to_markdown(many);
  CHECK(cut.size() < 100'000);
  CHECK_THAT(cut, Contains("and 2960 more causes"));
}

TEST_CASE("two texts differ first in a line, which is told with what is around", "[text]") {
  CHECK(first_difference("a\nb\n", "a\nb\n").line == 0);
  CHECK(in_words(first_difference("a\nb\n", "a\nb\n")).empty());
  CHECK(in_words(first_difference("a\nb\nc\n", "a\nx\nc\n")) == "line 2 was “b”, is “x”");
  CHECK(in_words(first_difference("a\n\nc\n", "a\nx\nc\n")) == "line 2 was “”, is “x”");
  CHECK(in_words(first_difference("a\nb\n", "a\n")) == "line 2 was “b”, is beyond the end");
  CHECK(in_words(first_difference("", "a")) == "line 1 was beyond the end, is “a”");
  CHECK(in_words(first_difference("a\n", "a")) == "line 1 ends in another way");
  CHECK(in_words(first_difference("aé", "aè")) == "line 1 was “aé”, is “aè”");  // they share their first byte
  const std::string before(100, '<'), after(100, '>');
  CHECK(in_words(first_difference(before + "1" + after, before + "2" + after)) ==
        "line 1 was “…" + std::string(24, '<') + "1" + std::string(35, '>') + "…”, is “…" + std::string(24, '<') + "2" +
            std::string(35, '>') + "…”");
}

TEST_CASE("a file of what was ticked is read back, and a broken one names entry and field", "[accept]") {
  using isect::program::read_accept_file;
  const std::vector<Reviewed> files = {{"a/b/01-c.png", "0123456789abcdef"},
                                       {"a/b/trace.json", "fedcba9876543210", true}};
  const std::vector<Reviewed> read = read_accept_file("{\"accept\": " + reviewed_json(files) + "}");
  REQUIRE(read.size() == 2);
  CHECK(read[0].file == files[0].file);
  CHECK(read[0].digest == files[0].digest);
  CHECK_FALSE(read[0].remove);
  CHECK(read[1].remove);

  const auto why = [](const std::string& text) { return refusal_of([&] { read_accept_file(text); }); };
  const auto entry = [&](const std::string& fields) {
    return why(R"({"accept": [{"file": "a/b.png", "digest": "0123456789abcdef"}, {)" + fields + "}]}");
  };
  for (const std::string text : {"", "[]", "{}", "{\"accept\": 1}", "{\"accept\""})
    CHECK_THAT(why(text), Contains("no list that a report of isect check has saved"));
  CHECK_THAT(why("{\"accept\": []}"), Contains("no file is named"));
  CHECK_THAT(why(std::string(100'000, '[')), Contains("no list"));
  CHECK_THAT(entry(R"("digest": "0123456789abcdef")"), StartsWith("accept 2: file: missing"));
  for (const std::string path : {"/etc/passwd", "../x.png", "a/../../x.png", "", "a/", "./a.png"})
    CHECK_THAT(entry(R"("digest": "0123456789abcdef", "file": ")" + path + "\""), StartsWith("accept 2: file: "));
  CHECK_THAT(entry(R"("file": "c.png", "digest": "0123")"), StartsWith("accept 2: digest: "));
  CHECK_THAT(entry(R"("file": "c.png", "digest": 3)"), StartsWith("accept 2: digest: 3 is no text"));
  CHECK_THAT(entry(R"("file": "c.png", "digest": "0123456789abcdef", "remove": 1)"), StartsWith("accept 2: remove: 1"));
  CHECK_THAT(entry(R"("file": "c.png", "digset": "0123456789abcdef")"), Contains("mean \"digest\""));
  CHECK_THAT(entry(R"("file": "a/b.png", "digest": "0123456789abcdef")"), Contains("named before"));
}

TEST_CASE("just what was reviewed is accepted", "[accept]") {
  const std::string good(16, 'a'), other(16, 'b');
  Acceptance list({{"f/new.png", good},
                   {"f/changed.png", good},
                   {"f/there.png", good},
                   {"f/passes.png", good},
                   {"f/foreign.png", good},
                   {"f/gone.png", good, true},
                   {"f/grown.png", good, true},
                   {"g/unknown.png", good}});
  CHECK(list.names("f/new.png"));
  CHECK_FALSE(list.names("f/gone.png"));  // that is to be removed
  CHECK(list.names_some_in("f"));
  CHECK_FALSE(list.names_some_in("f/new"));
  CHECK(list.removes());
  CHECK(list.takes("f/new.png", {good, "", true}));
  CHECK_FALSE(list.takes("f/changed.png", {other, "", true}));
  CHECK_FALSE(list.takes("f/there.png", {other, good, true}));
  CHECK_FALSE(list.takes("f/passes.png", {good, other, false}));
  CHECK_FALSE(list.takes("f/foreign.png", {good, other, true, "not ours"}));
  CHECK_FALSE(list.takes("f/not-listed.png", {good, "", true}));
  CHECK(list.takes_away("f/gone.png", good));
  CHECK_FALSE(list.takes_away("f/grown.png", other));
  list.close("/nowhere");
  CHECK(status(list) == 1);
  const auto json = nlohmann::json::parse(to_json(list));
  CHECK(json["accepted"] == nlohmann::json::array({"f/new.png"}));
  CHECK(json["removed"] == nlohmann::json::array({"f/gone.png"}));
  CHECK(json["already"] == nlohmann::json::array({"f/there.png", "f/passes.png"}));
  REQUIRE(json["refused"].size() == 4);
  CHECK(json["refused"][0]["file"] == "f/changed.png");
  CHECK_THAT(json["refused"][0]["why"].get<std::string>(), Contains("something else now than what was reviewed"));
  CHECK(json["refused"][1]["why"] == "not ours");
  CHECK_THAT(to_text(list), Contains("accepted f/new.png\n") && Contains("removed f/gone.png\n") &&
                                Contains("REFUSED g/unknown.png: ") &&
                                Contains("2 of 8 accepted; 2 as reviewed already; 4 refused\n"));
  Acceptance fine({{"f/new.png", good}, {"f/gone.png", good, true}});
  CHECK(fine.takes("f/new.png", {good, "", true}));
  fine.close("/nowhere");  // what is to be removed is gone
  CHECK(status(fine) == 0);
}

TEST_CASE("pictures that are too many for a page lie beside it, and those of an earlier report go", "[report]") {
  const Shell shell;
  const std::string page = (shell.work() / "check.html").string();
  const auto folder = shell.work() / "check-pictures";
  Report r = of_causes(2);
  r.failures[0].accepted_file = "old", r.failures[0].fresh_file = "new", r.failures[0].difference_file = "difference";
  r.failures[1].fresh_file = "new";  // the same bytes lie there once
  const auto inside = to_html(r, page);
  CHECK(inside.folder.empty());
  CHECK(count(inside.page, "src=\"data:image/png;base64,") == 4);
  write_html(inside, page);
  CHECK(files_in(shell.work()) == std::vector<std::string>{"check.html"});

  const auto beside = to_html(r, page, 10);
  CHECK(beside.folder == "check-pictures");
  CHECK(beside.pictures.size() == 3);
  CHECK_THAT(beside.page, Contains("src=\"check-pictures/" + isect::program::digest("old") + ".png\"") &&
                              !Contains("data:image/png"));
  write_html(beside, page);
  CHECK(files_in(folder).size() == 3);
  CHECK(contents(folder / (isect::program::digest("new") + ".png")) == "new");

  write(folder / "mine.png", "mine");
  r.failures[0].fresh_file = r.failures[1].fresh_file = "newer";
  write_html(to_html(r, page, 10), page);
  CHECK(files_in(folder).size() == 4);
  CHECK_FALSE(fs::exists(folder / (isect::program::digest("new") + ".png")));
  write_html(to_html(r, page), page);
  CHECK(files_in(folder) == std::vector<std::string>{"mine.png"});

  const auto taken = folder / (isect::program::digest("old") + ".png");
  write(taken, "another's");
  CHECK_THROWS_AS(write_html(to_html(r, page, 10), page), isect::viz::FileError);
  CHECK(contents(taken) == "another's");
}

TEST_CASE("a page has an index, an article a failure, and what its tick accepts", "[report]") {
  Report r = with({failed(Kind::picture, "a", 0, "b <moved>"), failed(Kind::picture, "a", 1, "only pixels differ"),
                   failed(Kind::trace, "a", -1, "b <moved>"), failed(Kind::blank, "a", 2)});
  for (Failure& f : r.failures)
    f.reviewed = {{"lesson/a/" + fs::path(f.baseline).filename().string(), "0123456789abcdef"}};
  const std::string page = to_html(r, "check.html").page;
  CHECK_THAT(page, Contains("<title>isect check: 3 pictures and 1 trace to look at</title>") &&
                       Contains("<h1>3 pictures and 1 trace to look at</h1>"));
  CHECK(all_between(page, "<li><a href=\"", '<') ==
        std::vector<std::string>{"#cause-1\">1 picture and 1 trace: b &lt;moved&gt;",
                                 "#cause-2\">1 picture: only pixels differ",
                                 "#cause-3\">1 picture: the picture is blank"});
  CHECK(count(page, "<section id=\"cause-") == 3);
  CHECK(count(page, "<article ") == 4);
  CHECK(count(page, " data-accept=\"[{&quot;file&quot;:&quot;lesson/a/") == 3);  // an empty picture is never accepted
  CHECK_THAT(page, Contains("data-command=\"isect check --dir figs --accept\""));
  CHECK(isect::program::begins_html_report(page));
  CHECK_THAT(to_html(with({}), "check.html").page, Contains("<h1>All is as accepted</h1>") && !Contains("<nav"));
}

}  // namespace check_causes_test
