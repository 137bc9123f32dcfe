// What a check leaves to read: one command that accepts, a page, JUnit XML, and a word where there is nothing.

#include <algorithm>
#include <cstring>
#include <set>

#include "tests/app/accepted.h"
#include "tests/settings.h"

namespace check_report_test {
namespace fs = std::filesystem;
using namespace isect::test;
using Catch::Matchers::StartsWith;

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

  // One change of each kind: a lesson that changed, one that is new, one that is gone.
  write(shell.work() / "my 'notes'/a.json", scene("near-points"));
  write(shell.work() / "my 'notes'/c.json", scene("a-after-b"));
  fs::remove(shell.work() / "my 'notes'/b.json");
  follow(dir);
  CHECK_FALSE(fs::exists(shell.work() / "my 'notes'/snapshots/clipping"));
}

TEST_CASE("each command that is printed accepts, for presets and scenes of any name", "[check]") {
  std::vector<std::string> names = {"a",      "two words", "-x",    "it's", "$(id)", "{b}", "a\nb", "sub/a", "touching",
                                    "a.json", "all",       "[1,2]", "a;b",  "über",  "%s",  "#1",   "="};
  if (!isect::tests::long_run()) names.resize(9);
  const std::string box = R"({"objects": [{"box": "A", "lo": [0, 0, 0], "hi": [1, 1, 1]},
                                          {"point": "p", "at": [0.5, 0.5, )";
  const auto change = [&](const Shell& shell, const std::string& number) {
    for (std::size_t i = 0; i < names.size(); ++i)
      write(shell.work() / "figs" / (names[i] + ".json"),
            i % 2 == 0 ? box + number + "]}], \"ask\": [[\"p\", \"A\"]]}"
                       : R"({"lesson": "intervals", "preset": "touching", "parameters": {"b_max": )" + number + "}}");
  };
  const Shell shell;
  change(shell, "4");
  REQUIRE(shell("isect check --dir figs --update=missing").status == 0);
  const std::string check_all = "isect check --dir figs";
  const auto failing = [&] { return nlohmann::json::parse(shell(check_all + " --json").out)["failures"]; };
  const auto preset_of = [](const nlohmann::json& f) { return f["preset"].get<std::string>(); };

  change(shell, "5");
  fs::remove(shell.work() / "figs/snapshots/scene/a/trace.json");
  REQUIRE(shell(check_all + " --junit all.xml --report all.html").status == 1);
  const std::string xml = contents(shell.work() / "all.xml"), html = contents(shell.work() / "all.html");
  const auto plain = [](std::string text) {
    for (const auto& [entity, c] : {std::pair{"&quot;", "\""}, {"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}})
      for (std::size_t at = 0; (at = text.find(entity, at)) != text.npos;) text.replace(at, std::strlen(entity), c);
    return text;
  };
  nlohmann::json failures = failing();
  std::set<std::string> seen;
  for (const nlohmann::json& f : failures) {
    if (!seen.insert(preset_of(f)).second) continue;
    const std::string command = f["accept"];
    INFO(command);
    CHECK_THAT(plain(html), Contains("To accept: <code>" + command + "</code>"));
    CHECK_THAT(plain(xml), Contains(preset_of(f) == "a" ? "isect check --preset a --dir figs --update=failed\n"
                                                        : "to accept: " + command + "\n"));
    for (const nlohmann::json& other : failures)  // what this one does not accept
      if (preset_of(other) == preset_of(f) && other["accept"] != command) CHECK(shell(other["accept"]).status <= 1);
    CHECK(shell(command).status == 0);
    if (seen.size() > 2) continue;  // it accepts nothing else
    const nlohmann::json left = failing();
    CHECK(std::ranges::none_of(left, [&](const nlohmann::json& l) { return preset_of(l) == preset_of(f); }));
    CHECK(left.size() + seen.size() >= names.size());
  }
  CHECK(seen.size() == names.size());
  CHECK_THAT(shell(check_all).out, StartsWith("ok: "));
  change(shell, "6");
  CHECK(shell(accept_command(shell(check_all).out)).status == 0);
  CHECK_THAT(shell(check_all).out, StartsWith("ok: "));
}

TEST_CASE("the command that accepts names the program as it was called", "[check]") {
  const Shell shell;
  const std::string elsewhere = "PATH=/usr/bin:/bin\n";
  fs::create_directory(shell.work() / "my bin");
  fs::create_symlink(ISECT_BIN "/isect", shell.work() / "my bin/isect");
  const Ran r = shell(elsewhere + "'my bin/isect' check intervals --preset touching");
  CHECK(accept_command(r.out) == "'my bin/isect' check intervals --preset touching --update=missing");
  CHECK(shell(elsewhere + accept_command(r.out)).status == 0);
}

TEST_CASE("a baseline that Git LFS has not fetched yet is told as such, and is not replaced", "[check]") {
  const Accepted shell;
  const std::string pointer =
      "version https://git-lfs.github.com/spec/v1\n"
      "oid sha256:4d7a214614ab2935c943f9e0ff69d22eadbb8f32b1258daaa5e2ca24d17e2393\nsize 12345\n";
  for (const std::string name : {"04-relation.png", "trace.json", "09-gone.png"}) {
    write(shell.file(name), pointer);
    const Ran r = shell(check);
    INFO(r.out);
    CHECK_THAT(r.out, Contains(baselines + "/" + name + " is a Git LFS pointer") && Contains("git lfs pull") &&
                          !Contains("not made by isect") && !Contains("move it away"));
    if (name != "09-gone.png") CHECK(r.status == 1);
    CHECK_THAT(shell(check + " --update=all").out, !Contains("not made by isect"));
    CHECK(contents(shell.file(name)) == pointer);
    fs::remove(shell.file(name));
    REQUIRE(shell(check + " --update=missing").status == 0);
  }
}

TEST_CASE("a report that can't be written is told before the work, and the result even where it fails after",
          "[check]") {
  const Accepted shell;
  accept_other_interval(shell);
  for (const std::string option : {"--report ", "--junit "}) {
    write(shell.work() / "file", "");
    const Ran early = shell(check + " " + option + "file/page");
    CHECK(early.status == 4);
    CHECK_THAT(early.err, Contains("file/page"));
    CHECK(early.out.empty());
    CHECK_FALSE(fs::exists(shell.file("04-relation.new.png")));  // nothing was drawn

    const Ran late = shell(check + " " + option + "/dev/full");
    CHECK(late.status == 4);
    CHECK_THAT(late.err, Contains("No space left"));
    CHECK_THAT(late.out,
               Contains("parameter b_min was") && Contains("failures in 5 pictures and the trace of 1 preset"));
    CHECK(accept_command(late.out) == check + " --update=failed");
    fs::remove(shell.file("04-relation.new.png"));
  }
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
  CHECK(pictures == 5);
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

TEST_CASE("a report is written over an earlier one, and over no other file", "[check]") {
  const Shell shell;
  REQUIRE(shell("isect check intervals --preset touching --update").status == 0);
  const std::string command = "isect check intervals --preset touching ";
  for (const std::string option : {"--report ", "--junit "}) {
    INFO(option);
    const std::string file = option == "--report " ? "page.html" : "result.xml";
    write(shell.work() / file, "mine\n");
    fs::remove(shell.work() / "snapshots/intervals/touching/04-relation.png");
    const Ran refused = shell(command + "--update " + option + file);
    CHECK(refused.status == 4);
    CHECK(refused.out.empty());
    CHECK_THAT(refused.err, Contains("cannot write '" + file + "'") && Contains("no report of isect's"));
    CHECK(contents(shell.work() / file) == "mine\n");
    CHECK_FALSE(fs::exists(shell.work() / "snapshots/intervals/touching/04-relation.png"));  // before the work
    REQUIRE(shell(command + "--update").status == 0);

    write(shell.work() / file, "");
    CHECK(shell(command + option + file).status == 0);
    const std::string first = contents(shell.work() / file);
    CHECK_THAT(first, Contains("isect check"));
    CHECK(shell(command + option + file).status == 0);  // over its own
    CHECK(contents(shell.work() / file) == first);
    CHECK(shell(command + option + "/dev/null").status == 0);
  }
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
  accept_other_interval(shell);
  CHECK(shell(check + " --junit bad.xml").status == 1);
  CHECK_THAT(read("bad.xml"), Contains("[[ATTACHMENT|snapshots/intervals/overlapping/04-relation.new.png]]"));
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
  CHECK(nlohmann::json::parse(shell(check + " --json").out)["failures"].size() == 6);

  // If some presets have baselines, those without are named, a line each.
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
