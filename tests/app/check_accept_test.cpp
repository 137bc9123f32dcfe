// What a person ticks in a report, and nothing else, is accepted; and what a check tells GitHub.

#include <algorithm>
#include <set>

#include "tests/app/accepted.h"

namespace check_accept_test {
namespace fs = std::filesystem;
using namespace isect::test;
using Catch::Matchers::StartsWith;
using nlohmann::json;

namespace {

/// What a report's ticks list, change by change.
std::vector<json> ticks_in(const std::string& page) {
  std::vector<json> ticks;
  for (std::string list : all_between(page, "data-accept=\"")) {
    for (std::size_t at = 0; (at = list.find("&quot;", at)) != list.npos;) list.replace(at, 6, "\"");
    ticks.push_back(json::parse(list));
  }
  return ticks;
}

/// The file that a report saves of such ticks, of those that `wanted` takes by their first file.
template <class Wanted>
std::string file_of(const std::vector<json>& ticks, const Wanted& wanted) {
  json files = json::array();
  for (const json& tick : ticks)
    if (wanted(tick[0]["file"].get<std::string>())) files.insert(files.end(), tick.begin(), tick.end());
  return json{{"accept", files}}.dump();
}

std::string all_of(const std::vector<json>& ticks) {
  return file_of(ticks, [](const std::string&) { return true; });
}

void preset(const Shell& shell, const std::string& name, const std::string& parameter, const std::string& value) {
  write(shell.work() / "figs" / (name + ".json"),
        R"({"lesson": "intervals", "preset": "touching", "parameters": {")" + parameter + "\": " + value + "}}");
}

/// Three presets changed by one cause, and one by another.
class Changed : public Shell {
 public:
  Changed() {
    const auto make = [&](const std::string& b_max, const std::string& a_min) {
      for (const std::string name : {"a", "b", "c"}) preset(*this, name, "b_max", b_max);
      preset(*this, "other", "a_min", a_min);
    };
    make("4", "0.5");
    REQUIRE((*this)("isect check --dir figs --update=missing").status == 0);
    make("5", "0.25");
    REQUIRE((*this)("isect check --dir figs --report r.html").status == 1);
    page = contents(work() / "r.html");
    REQUIRE_FALSE(ticks_in(page).empty());
  }
  Ran accept(const std::string& list, const std::string& more = "") const {
    write(work() / "accept.json", list);
    return (*this)("isect check --dir figs --accept accept.json" + more);
  }
  /// The presets whose checks fail.
  std::set<std::string> failing() const {
    std::set<std::string> names;
    const json result = json::parse((*this)("isect check --dir figs --json").out);
    for (const json& f : result["failures"]) names.insert(f["preset"].get<std::string>());
    return names;
  }

  std::string page;
};

}  // namespace

TEST_CASE("fifty pictures that one cause changed are one group, and are accepted in one pass", "[check][accept]") {
  const Shell shell;
  const auto make = [&](const std::string& b_max) {
    for (int i = 0; i < 10; ++i) preset(shell, "figure-" + std::to_string(i), "b_max", b_max);
  };
  make("4");
  REQUIRE(shell("isect check --dir figs --update=missing").status == 0);
  make("5");
  const Ran r = shell("isect check --dir figs --report r.html --github");
  CHECK(r.status == 1);
  CHECK_THAT(r.out, Contains("by cause:\n    50 pictures and 10 traces: parameter b_max was 4.0, is 5.0\n"));
  CHECK(count(r.out, "\n::error ") == 1);
  const std::string page = contents(shell.work() / "r.html");
  CHECK(all_between(page, "<li><a href=\"", '<') ==
        std::vector<std::string>{"#cause-1\">50 pictures and 10 traces: parameter b_max was 4.0, is 5.0"});
  CHECK(count(page, "of the pixels changed visibly; colours differ by up to ") == 50);

  const std::vector<json> ticks = ticks_in(page);
  CHECK(ticks.size() == 60);
  const std::vector<std::string> command = all_between(page, "data-command=\"");
  REQUIRE(command.size() == 1);
  write(shell.work() / "accept.json", all_of(ticks));
  const Ran accepted = shell(command[0] + " accept.json");
  CHECK(accepted.status == 0);
  CHECK_THAT(accepted.out, Contains("60 of 60 accepted\n") && !Contains("REFUSED"));
  CHECK_THAT(shell("isect check --dir figs").out, StartsWith("ok: 50 pictures of 10 presets\n"));
  for (const auto& [file, bytes] : all_in(shell.work() / "figs/snapshots"))
    CHECK_THAT(file, !Contains(".new.") && !Contains(".diff."));
}

TEST_CASE("what is not ticked stays, byte by byte", "[check][accept]") {
  const Changed shell;
  const auto before = all_in(shell.work() / "figs/snapshots");
  const std::vector<json> ticks = ticks_in(shell.page);
  const Ran one =
      shell.accept(file_of(ticks, [](const std::string& file) { return file == "intervals/a/04-relation.png"; }));
  CHECK(one.status == 0);
  CHECK(one.out == "accepted intervals/a/04-relation.png\n1 of 1 accepted\n");
  auto after = all_in(shell.work() / "figs/snapshots");
  CHECK(after["intervals/a/04-relation.png"] == before.at("intervals/a/04-relation.new.png"));
  CHECK_FALSE(after.contains("intervals/a/04-relation.new.png"));
  CHECK_FALSE(after.contains("intervals/a/04-relation.diff.png"));
  for (const auto& [file, bytes] : before)
    if (!file.starts_with("intervals/a/04-relation")) CHECK(after[file] == bytes);

  const Ran group =
      shell.accept(file_of(ticks, [](const std::string& file) { return !file.starts_with("intervals/other/"); }));
  CHECK(group.status == 0);
  CHECK_THAT(group.out,
             Contains("as reviewed already intervals/a/04-relation.png\n") && Contains("; 1 as reviewed already\n"));
  CHECK(shell.failing() == std::set<std::string>{"other"});
}

TEST_CASE("a picture that is something else by now is refused, and the others are accepted", "[check][accept]") {
  const Changed shell;
  const std::string all = all_of(ticks_in(shell.page));
  preset(shell, "b", "b_max", "5.5");
  const auto before = all_in(shell.work() / "figs/snapshots/intervals/b");
  const Ran r = shell.accept(all);
  CHECK(r.status == 1);
  CHECK_THAT(r.out,
             Contains("REFUSED intervals/b/04-relation.png: it is something else now than what was reviewed; look "
                      "at it in a new report\n") &&
                 Contains("REFUSED intervals/b/trace.json: ") && !Contains("REFUSED intervals/a/"));
  CHECK(all_in(shell.work() / "figs/snapshots/intervals/b") == before);
  CHECK(shell.failing() == std::set<std::string>{"b"});

  // For programs it is told as JSON. A picture that is as it was before the review is something else, too.
  preset(shell, "b", "b_max", "4");
  const auto then = all_in(shell.work() / "figs/snapshots/intervals/b");
  const Ran again = shell.accept(all, " --json");
  CHECK(again.status == 1);
  const json result = json::parse(again.out);
  CHECK(result["refused"].size() == 6);
  CHECK(result["accepted"].empty());
  CHECK(result["already"].size() == ticks_in(shell.page).size() - 6);
  CHECK(all_in(shell.work() / "figs/snapshots/intervals/b") == then);
}

TEST_CASE("new, left over and moved baselines are accepted by their ticks", "[check][accept]") {
  const Changed shell;
  REQUIRE(shell("isect check --dir figs --update").status == 0);
  preset(shell, "new", "b_max", "6");
  fs::remove(shell.work() / "figs/other.json");
  fs::rename(shell.work() / "figs/b.json", shell.work() / "figs/moved.json");
  REQUIRE(shell("isect check --dir figs --report r.html").status == 1);
  const std::vector<json> ticks = ticks_in(contents(shell.work() / "r.html"));
  // Nothing is removed that was changed since, or that is no orphan any more.
  const std::string all = all_of(ticks);
  const fs::path left = shell.work() / "figs/snapshots/intervals/other/04-relation.png";
  const std::string bytes = contents(left);
  write(left, bytes + "more");
  const Ran grown =
      shell.accept(file_of(ticks, [](const std::string& f) { return f == "intervals/other/04-relation.png"; }));
  CHECK(grown.status == 1);
  CHECK(fs::exists(left));
  write(left, bytes);
  const Ran wanted = shell.accept(
      R"({"accept": [{"file": "intervals/c/04-relation.png", "digest": "0123456789abcdef", "remove": true}]})");
  CHECK(wanted.status == 1);
  CHECK_THAT(wanted.out, Contains("it is not left over"));

  const Ran r = shell.accept(all);
  CHECK(r.status == 0);
  CHECK_THAT(r.out,
             Contains("accepted intervals/new/trace.json\n") && Contains("removed intervals/other/trace.json\n") &&
                 Contains("accepted intervals/moved/trace.json\n") && Contains("removed intervals/b/trace.json\n"));
  CHECK_FALSE(fs::exists(shell.work() / "figs/snapshots/intervals/other"));
  CHECK_FALSE(fs::exists(shell.work() / "figs/snapshots/intervals/b"));
  CHECK(shell.failing().empty());
}

TEST_CASE("what isect did not make is not accepted over, and is said so", "[check][accept]") {
  const Changed shell;
  const fs::path file = shell.work() / "figs/snapshots/intervals/a/04-relation.png";
  write(file, photo());
  const Ran r = shell.accept(all_of(ticks_in(shell.page)));
  CHECK(r.status == 1);
  CHECK_THAT(r.out, Contains("REFUSED intervals/a/04-relation.png: the file in its place was not made by isect"));
  CHECK(contents(file) == photo());
}

TEST_CASE("the lessons' own baselines are accepted by ticks as well", "[check][accept]") {
  const Accepted shell;
  accept_other_interval(shell);
  REQUIRE(shell(check + " --report r.html").status == 1);
  const std::string page = contents(shell.work() / "r.html");
  write(shell.work() / "accept.json", all_of(ticks_in(page)));
  CHECK(all_between(page, "data-command=\"") == std::vector<std::string>{"isect check --accept"});
  CHECK(shell("isect check --accept accept.json").status == 0);
  CHECK(shell(check).status == 0);
}

TEST_CASE("a list that is none, or is for another folder, is refused", "[check][accept]") {
  const Changed shell;
  const Ran none = shell.accept("{\"name\": \"left-pad\"}");
  CHECK(none.status == 2);
  CHECK_THAT(none.err, Contains("accept.json: this is no list that a report of isect check has saved"));
  CHECK(shell("isect check --dir figs --accept nowhere.json").status == 4);
  const Ran strange = shell.accept(R"({"accept": [{"file": "balls/x/01-a.png", "digest": "0123456789abcdef"}]})");
  CHECK(strange.status == 1);
  CHECK_THAT(strange.out, Contains("REFUSED balls/x/01-a.png: no step has a baseline of this name"));
  const std::string all = all_of(ticks_in(shell.page));
  for (const std::string more : {" --update", " --report x.html", " --github", " --preset a", " intervals"}) {
    INFO(more);
    CHECK(shell.accept(all, more).status == 2);
  }
  CHECK(shell.failing().size() == 4);
}

TEST_CASE("GitHub is told each cause, and its summary is added to", "[check][github]") {
  const Changed shell;
  write(shell.work() / "summary.md", "of another step\n");
  const Ran r = shell("export GITHUB_STEP_SUMMARY=summary.md\nisect check --dir figs --github");
  CHECK(r.status == 1);
  CHECK_THAT(r.out,
             Contains("\n::error file=figs/snapshots/intervals/a/trace.json,line=") &&
                 Contains(",title=isect check%3A 15 pictures and 3 traces%3A parameter b_max was 4.0%2C is 5.0::"));
  CHECK(count(r.out, "::error ") == 2);
  CHECK_THAT(contents(shell.work() / "summary.md"),
             StartsWith("of another step\n## isect check\n") &&
                 Contains("| 15 pictures and 3 traces | parameter b\\_max was 4.0, is 5.0 | intervals a; "));
  CHECK_THAT(shell("isect check --dir figs").out, !Contains("::error"));
  CHECK(shell("isect check --dir figs --github --json").status == 2);

  const Ran nowhere = shell("export GITHUB_STEP_SUMMARY=figs/a.json/x\nisect check --dir figs --github");
  CHECK(nowhere.status == 4);
  CHECK(nowhere.out.empty());  // said before the work
  REQUIRE(shell("isect check --dir figs --update").status == 0);
  const Ran good = shell("export GITHUB_STEP_SUMMARY=summary.md\nisect check --dir figs --github");
  CHECK(good.status == 0);
  CHECK_THAT(good.out, !Contains("::"));
  CHECK_THAT(contents(shell.work() / "summary.md"), Contains("ok: 19 pictures of 4 presets\n"));
}

}  // namespace check_accept_test
