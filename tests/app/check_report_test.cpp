// What a check leaves to read: one command that accepts, a page, JUnit XML, and a word where there is nothing.

#include "tests/app/accepted.h"

namespace check_report_test {
namespace fs = std::filesystem;
using Catch::Matchers::StartsWith;
using isect::test::accept_command;
using isect::test::accept_other_interval;
using isect::test::Accepted;
using isect::test::check;
using isect::test::Contains;
using isect::test::contents;
using isect::test::Ran;
using isect::test::scene;
using isect::test::Shell;
using isect::test::write;

TEST_CASE("one command accepts all that failed, word by word", "[check]") {
  const Shell shell;
  const auto follow = [&](const std::string& command) {
    INFO(command);
    const Ran first = shell(command);
    CHECK(first.status != 0);
    const std::string accept = accept_command(first.out);
    INFO(accept);
    CHECK(first.out.find("--update", first.out.find(accept) + accept.size()) == std::string::npos);  // named once
    CHECK(shell(accept).status == 0);
    CHECK_THAT(shell(command).out, StartsWith("ok: "));
  };
  write(shell.work() / "my 'notes'/a.json", scene("a-after-b"));
  write(shell.work() / "my 'notes'/sub/a.json", scene("same-point"));
  write(shell.work() / "my 'notes'/b.json", R"({"lesson": "clipping", "preset": "polygon-inside"})");
  const std::string dir = "isect check --dir \"my 'notes'\"";
  follow(dir + " --preset sub/a");
  follow(dir + " clipping");
  follow(dir);
  follow("isect check hierarchy --preset ray-missed --snapshots 'a b'");

  // A lesson that changed is named where others did not.
  write(shell.work() / "my 'notes'/b.json", R"({"lesson": "clipping", "preset": "polygon-beyond"})");
  CHECK_THAT(accept_command(shell(dir).out), StartsWith("isect check clipping --dir 'my '\\''notes'\\'''"));
  follow(dir);

  // Of everything, something: a lesson that changed, one that is new, one that is gone.
  write(shell.work() / "my 'notes'/a.json", scene("near-points"));
  write(shell.work() / "my 'notes'/c.json", scene("a-after-b"));
  fs::remove(shell.work() / "my 'notes'/b.json");
  follow(dir);
  CHECK_FALSE(fs::exists(shell.work() / "my 'notes'/snapshots/clipping"));
}

TEST_CASE("where nothing can be written a difference is still told in words", "[check]") {
  const Accepted shell;
  accept_other_interval(shell);
  // A folder where the picture should go stops root as well.
  fs::create_directories(shell.file("04-relation.new.png"));
  fs::create_directories(shell.file("04-relation.diff.png/x"));
  const Ran r = shell(check);
  CHECK(r.status == 1);
  CHECK_THAT(r.out, Contains("step 4 (relation): picture:") && Contains("parameter b_min was") && Contains("note "));
  CHECK(shell(check + " --update").status == 0);

  accept_other_interval(shell);
  const Ran mounted = shell(
      "unshare -rm true 2>/dev/null || exit 99\nunshare -rm sh -c 'mount --bind . . && mount -o "
      "remount,bind,ro . && cd . && cd \"$PWD\" && " +
      check + "'");
  if (mounted.status != 99) {
    INFO(mounted.out << mounted.err);
    CHECK(mounted.status == 1);
    CHECK_THAT(mounted.out, Contains("parameter b_min was") && Contains("Read-only file system"));
  }
}

TEST_CASE("a report shows what would be accepted for the first time", "[check]") {
  const Shell shell;
  const Ran r = shell(check + " --report new.html");
  CHECK(r.status == 3);
  CHECK_FALSE(fs::exists(shell.work() / "snapshots"));
  const std::string page = contents(shell.work() / "new.html");
  std::size_t pictures = 0;
  for (std::size_t at = 0; (at = page.find("<img alt=\"New\"", at)) != std::string::npos; ++at) ++pictures;
  CHECK(pictures == 6);
  CHECK_THAT(page, Contains(check + " --update=missing"));
}

TEST_CASE("a report is never written over a baseline, a figure or another report", "[check]") {
  const Shell shell;
  REQUIRE(shell("isect check intervals --preset touching --update && isect render intervals --step 1").status == 0);
  const std::string command = "isect check intervals --preset touching ";
  const std::string trace = "snapshots/intervals/touching/trace.json",
                    figure = "figures/intervals/overlapping/01-opening.png";
  for (const std::string& file : {trace, figure})
    for (const std::string option : {"--report ", "--junit "}) {
      const std::string before = contents(shell.work() / file);
      const Ran ran = shell(command + option + file);
      CHECK(ran.status == 2);
      CHECK_THAT(ran.err, Contains("report: " + file + " is a baseline or a figure"));
      CHECK(contents(shell.work() / file) == before);
    }
  const Ran both = shell(command + "--report r --junit r");
  CHECK(both.status == 2);
  CHECK_THAT(both.err, Contains("junit: r is the page of --report too"));
}

TEST_CASE("a result as JUnit XML is read by programs, whatever the names", "[check]") {
  const Accepted shell;
  const auto read = [&](const std::string& file) {
    const Ran r = shell("command -v xmllint >/dev/null || exit 99; xmllint --noout " + file);
    CHECK((r.status == 0 || r.status == 99));
    CHECK(r.err.empty());
    return contents(shell.work() / file);
  };
  CHECK(shell(check + " --junit good.xml").status == 0);
  CHECK_THAT(read("good.xml"), Contains("<testsuites name=\"isect check\" tests=\"1\" failures=\"0\" errors=\"0\">") &&
                                   Contains("<testcase classname=\"intervals\" name=\"overlapping\"/>"));

  const std::string odd = "q <&> \"'\x01 ]]>";
  write(shell.work() / "odd" / (odd + ".json"), scene("overlapping"));
  write(shell.work() / "odd/\xff.json", scene("overlapping"));
  write(shell.work() / "odd/broken.json", R"({"lesson": "ray-sphere", "parameters": {"radus<": 1}})");
  const Ran r = shell("isect check --dir odd --json --junit odd.xml");
  CHECK(r.status == 2);
  CHECK(nlohmann::json::accept(r.out));
  CHECK_THAT(read("odd.xml"), Contains("tests=\"3\" failures=\"1\" errors=\"2\"") &&
                                  Contains("q &lt;&amp;&gt; &quot;") && Contains("<error type=\"preset\"") &&
                                  Contains("radus&lt;") && Contains("not UTF-8"));
  CHECK(shell("isect check --dir odd --report odd.html --junit /dev/stdout >out").status == 2);
  CHECK_THAT(contents(shell.work() / "out"), StartsWith("<?xml") && Contains("failure"));
  const Ran full = shell(check + " --junit /dev/full");
  CHECK(full.status == 4);
  CHECK_THAT(full.err, Contains("No space left"));
}

TEST_CASE("where there are no baselines it is said once, with the place and the way out", "[check]") {
  const Shell shell;
  const Ran r = shell("isect check intervals");
  CHECK(r.status == 3);
  CHECK_THAT(r.out, StartsWith("no baselines here: those of intervals are looked for in " +
                               fs::canonical(shell.work()).string() + "/snapshots\n"));
  CHECK_THAT(r.out, Contains("--snapshots DIR") && Contains("--dir DIR") && !Contains("MISSING"));
  CHECK(fs::is_empty(shell.work()));
  CHECK(nlohmann::json::parse(shell(check + " --json").out)["failures"].size() == 7);

  // Where others have theirs, those without are named, a line each.
  REQUIRE(shell(check + " --update").status == 0);
  const Ran some = shell("isect check intervals");
  CHECK(some.status == 3);
  CHECK_THAT(some.out, Contains("MISSING intervals touching: snapshots/intervals/touching\n"));
  CHECK_THAT(some.out, !Contains(".png") && !Contains("trace.json"));
}

TEST_CASE("another folder is named in the command that accepts", "[check]") {
  const Shell shell;
  const Ran r = shell(check + " --snapshots base/lines");
  CHECK(r.status == 3);
  CHECK(accept_command(r.out) == check + " --snapshots base/lines --update=missing");
}

}  // namespace check_report_test
