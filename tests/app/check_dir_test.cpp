// Regression of a user's own presets: `check --dir`.

#include "tests/app/accepted.h"

namespace check_dir_test {
namespace fs = std::filesystem;
using namespace isect::test;
using Catch::Matchers::StartsWith;

namespace {

/// A folder with two presets.
class Course : public Shell {
 public:
  Course() {
    write(work() / "course/week-3.json", scene("overlapping"));
    write(work() / "course/sub/week-3.json", scene("touching"));
    write(work() / "course/manifest.json", "[]");
  }
};

/// A course with accepted baselines.
class AcceptedCourse : public Course {
 public:
  AcceptedCourse() { REQUIRE((*this)("isect check --dir course --update=missing").status == 0); }
};

}  // namespace

TEST_CASE("presets of one's own are checked against baselines in a folder of their own", "[check]") {
  const Course shell;
  const Ran missing = shell("isect check --dir course");
  CHECK(missing.status == 3);
  CHECK(accept_command(missing.out) == "isect check --dir course --update=missing");

  const Ran made = shell("isect check --dir course --update=missing");
  CHECK(made.status == 0);
  CHECK(fs::exists(shell.work() / "course/snapshots/intervals/week-3/trace.json"));
  CHECK(fs::exists(shell.work() / "course/snapshots/intervals/sub/week-3/04-relation.png"));
  const Ran whole = shell("isect check --dir course");
  CHECK_THAT(whole.out, StartsWith("ok: ") && Contains("2 presets"));
  CHECK(whole.err.empty());
}

TEST_CASE("a changed preset of a folder fails, and the other is left alone", "[check]") {
  const AcceptedCourse shell;
  write(shell.work() / "course/week-3.json", scene("b-after-a"));
  const Ran r = shell("isect check --dir course");
  CHECK(r.status == 1);
  CHECK_THAT(r.out, Contains("FAILED intervals week-3") && !Contains("sub/week-3"));
  CHECK(accept_command(r.out) == "isect check --dir course --update=failed");
  CHECK(shell("isect check --dir course --update").status == 0);
  CHECK(shell("isect check --dir course").status == 0);
}

TEST_CASE("one preset of a folder can be checked and accepted alone", "[check]") {
  const AcceptedCourse shell;
  write(shell.work() / "course/week-3.json", scene("b-after-a"));
  write(shell.work() / "course/sub/week-3.json", scene("b-after-a"));
  CHECK(shell("isect check --dir course --preset sub/week-3 --update").status == 0);
  CHECK(shell("isect check --dir course --preset sub/week-3.json").status == 0);
  CHECK(shell("isect check --dir course --preset week-3").status == 1);
  const Ran unknown = shell("isect check --dir course --preset week-4");
  CHECK(unknown.status == 2);
  CHECK_THAT(unknown.err, Contains("week-3"));
}

TEST_CASE("a preset that went away leaves orphans", "[check]") {
  const AcceptedCourse shell;
  fs::remove(shell.work() / "course/sub/week-3.json");
  const Ran r = shell("isect check --dir course");
  CHECK(r.status == 1);
  CHECK_THAT(r.out, Contains("belongs to no step of any preset"));
  CHECK(shell("isect check --dir course --preset week-3 --update").status == 0);
  CHECK(fs::exists(shell.work() / "course/snapshots/intervals/sub/week-3"));
  CHECK_THAT(shell("isect check --dir course --update").out, Contains("removed intervals sub/week-3"));
  CHECK_FALSE(fs::exists(shell.work() / "course/snapshots/intervals/sub"));
}

TEST_CASE("a preset that is broken is named, and its baselines are kept", "[check]") {
  const AcceptedCourse shell;
  const auto before = all_in(shell.work() / "course/snapshots");
  write(shell.work() / "course/week-3.json", R"({"lesson": "ray-sphere", "parameters": {"radus": 1}})");
  write(shell.work() / "course/package.json", R"({"name": "course"})");
  const Ran r = shell("isect check --dir course --update=all");
  CHECK(r.status == 2);
  CHECK_THAT(r.out, Contains("course/week-3.json") && Contains("radus") && Contains("mean \"radius\""));
  CHECK_THAT(r.out, Contains("1 failure in ") && Contains("1 preset"));  // the other was checked
  CHECK(r.err == "passed over: course/package.json is no preset\n");
  CHECK(all_in(shell.work() / "course/snapshots") == before);
  write(shell.work() / "course/week-3.json", R"({"lesson": "ray-sphere", "parameters": {)");
  CHECK_THAT(shell("isect check --dir course").out, Contains("course/week-3.json") && Contains("not JSON"));
  write(shell.work() / "course/sub/week-3.json", scene("overlapping"));
  CHECK(shell("isect check --dir course").status == 1);
}

TEST_CASE("a preset's file may be called as one of the lesson's own, and is guarded as any other", "[check]") {
  const Shell shell;
  const std::string text = R"({"lesson": "intervals", "preset": "touching"})";
  for (const std::string name : {"touching", "my-touching"}) write(shell.work() / name / (name + ".json"), text);
  for (const std::string name : {"touching", "my-touching"})
    CHECK(shell("isect check --dir " + name + " --update=missing").status == 0);
  const auto files = [&](const std::string& name) {
    return files_in(shell.work() / name / "snapshots/intervals" / name);
  };
  CHECK(files("touching").size() == 1 + 5);  // the trace, and a picture of each step but the card
  CHECK(files("touching") == files("my-touching"));

  // The lesson's own data stands in the trace of its first preset, not in that of a file of the same name.
  write(shell.work() / "first/overlapping.json", scene("overlapping"));
  CHECK(shell("isect check --dir first --update=missing").status == 0);
  CHECK_THAT(contents(shell.work() / "first/snapshots/intervals/overlapping/trace.json"), !Contains("\"exercises\""));
  const Ran without = shell("isect check --preset touching/touching.json");
  CHECK(without.status == 2);
  CHECK_THAT(without.err, Contains("for files of yours give --dir"));
}

TEST_CASE("a preset that was moved is told as moved, in a line, and is accepted as such", "[check]") {
  const AcceptedCourse shell;
  fs::create_directories(shell.work() / "course/new");
  fs::rename(shell.work() / "course/week-3.json", shell.work() / "course/new/week-4.json");
  const Ran r = shell("isect check --dir course");
  CHECK(r.status == 1);
  CHECK_THAT(r.out, StartsWith("MOVED intervals new/week-4: says and shows what week-3 did, which is no more\n"
                               "to accept it: isect check --dir course --update=failed\n1 failure in "));
  const auto result = nlohmann::json::parse(shell("isect check --dir course --json").out);
  REQUIRE(result["failures"].size() == 1);
  CHECK(result["failures"][0]["kind"] == "moved");

  CHECK(shell(result["failures"][0]["accept"].get<std::string>()).status == 0);
  CHECK_THAT(shell("isect check --dir course").out, StartsWith("ok: "));
  CHECK_FALSE(fs::exists(shell.work() / "course/snapshots/intervals/week-3"));
  CHECK(fs::exists(shell.work() / "course/snapshots/intervals/new/week-4/trace.json"));

  // A preset whose text differs is not the same preset under another name.
  fs::remove(shell.work() / "course/new/week-4.json");
  write(shell.work() / "course/week-5.json", scene("b-after-a"));
  CHECK_THAT(shell("isect check --dir course").out,
             Contains("MISSING intervals week-5") && Contains("belongs to no step") && !Contains("MOVED"));
}

TEST_CASE("a folder's only preset that was moved still has its baselines", "[check]") {
  const Shell shell;
  write(shell.work() / "notes/a.json", scene("overlapping"));
  CHECK(shell("isect check --dir notes --update=missing").status == 0);
  fs::rename(shell.work() / "notes/a.json", shell.work() / "notes/b.json");
  const Ran r = shell("isect check --dir notes");
  CHECK(r.status == 1);
  CHECK_THAT(r.out, StartsWith("MOVED intervals b: ") && !Contains("no baselines"));
  CHECK(shell(accept_command(r.out)).status == 0);
  CHECK_THAT(shell("isect check --dir notes").out, StartsWith("ok: "));
}

TEST_CASE("figures go beside the presets without touching the baselines", "[check]") {
  const AcceptedCourse shell;
  const auto before = all_in(shell.work() / "course/snapshots");
  fs::remove(shell.work() / "course/manifest.json");
  CHECK(shell("isect render --preset course/week-3.json --out course").status == 0);
  CHECK(all_in(shell.work() / "course/snapshots") == before);
  CHECK(shell("isect check --dir course").status == 0);
  CHECK(shell("isect render --preset course/week-3.json --out course/snapshots").status == 2);
}

TEST_CASE("baselines that lie beside the presets, as they once did, are to be moved", "[check]") {
  const AcceptedCourse shell;
  fs::rename(shell.work() / "course/snapshots/intervals", shell.work() / "course/intervals");
  fs::remove_all(shell.work() / "course/snapshots");
  const Ran r = shell("isect check --dir course --update");
  CHECK(r.status == 3);
  CHECK_THAT(r.err, Contains("To move them:"));
  CHECK_FALSE(fs::exists(shell.work() / "course/snapshots"));
  CHECK(shell(r.err.substr(r.err.find('\n') + 1)).status == 0);
  CHECK(shell("isect check --dir course").status == 0);
}

TEST_CASE("a folder of presets that does not do is told what is wrong", "[check]") {
  const Shell shell;
  CHECK(shell("isect check --dir nowhere").status == 4);
  write(shell.work() / "empty/package.json", "{}");
  const Ran empty = shell("isect check --dir empty");
  CHECK(empty.status == 2);
  CHECK_THAT(empty.err, Contains("empty holds no preset files"));

  write(shell.work() / "bad/x.json", R"({"lesson": "ray-spere", "parameters": {}})");
  const Ran bad = shell("isect check --dir bad");
  CHECK(bad.status == 2);
  CHECK_THAT(bad.out, Contains("bad/x.json") && Contains("ray-sphere"));
  write(shell.work() / "bad/y.json", scene("overlapping"));
  const Ran both = shell("isect check --dir bad");
  CHECK(both.status == 2);
  CHECK_THAT(both.out, Contains("bad/x.json") && Contains("no baselines here"));
  CHECK(shell("isect check --dir bad --snapshots bad").status == 2);

  // What is read by recursion, or by a regular expression, would overflow the stack.
  write(shell.work() / "bad/deep.json", R"({"lesson": "a", "preset": "b", "steps": [], "parameters": )" +
                                            std::string(300'000, '[') + std::string(300'000, ']') + "}");
  write(shell.work() / "bad/blanks.json", "{\"objects\"" + std::string(1'000'000, ' '));
  const Ran large = shell("isect check --dir bad");
  CHECK(large.status == 2);
  CHECK_THAT(large.out, Contains("bad/deep.json") && Contains("nest deeper than the 64 levels"));
  CHECK_THAT(large.out + large.err, Contains("bad/blanks.json"));
}

TEST_CASE("a camera that is another in a preset's file is a difference", "[check]") {
  const Shell shell;
  const auto seen_from = [](const std::string& camera) {
    return R"({"lesson": "intervals", "camera": {)" + camera + "}}";
  };
  write(shell.work() / "course/week-3.json", seen_from(R"("half_height": 2)"));
  CHECK(shell("isect check --dir course --update=missing").status == 0);
  CHECK(shell("isect check --dir course").status == 0);

  for (const std::string camera : {R"("half_height": 2.001)", R"("half_height": 2, "target": [0.001, 0, 0])", ""}) {
    INFO(camera);
    write(shell.work() / "course/week-3.json", seen_from(camera));
    const Ran r = shell("isect check --dir course");
    CHECK(r.status == 1);
    CHECK_THAT(r.out, Contains("FAILED intervals week-3, step 1"));
  }
}

}  // namespace check_dir_test
