// What `check --update` may touch: what isect made, and nothing else.

#include "tests/app/accepted.h"

namespace check_ownership_test {
namespace fs = std::filesystem;
namespace viz = isect::viz;
using namespace isect::test;
using Catch::Matchers::StartsWith;

TEST_CASE("no update changes or removes what isect did not make", "[check]") {
  const Shell shell;
  write(shell.work() / "notes/x.json", R"({"lesson": "intervals", "preset": "touching"})");
  REQUIRE(shell("isect check --dir notes --update").status == 0);
  const fs::path snapshots = shell.work() / "notes/snapshots", own = snapshots / "intervals/x";
  const std::string name = files_in(own).front(), stem = fs::path(name).stem(), picture = contents(own / name);
  const std::map<std::string, std::string> foreign = {
      {"intervals/x/beach.png", photo()},
      {"intervals/x/14-beach.png", photo()},
      {"intervals/x/" + stem + "-annotated.png", picture},  // with isect's metadata
      {"intervals/x/sub/" + name, picture},
      {"intervals/x-old/" + name, picture},
      {"photos/2024/beach.png", photo()},
      {"lib/a/trace.json", R"({"lesson": 3, "traceEvents": []})"},
      {"lib/b/trace.json", contents(own / "trace.json")},  // of another folder
  };
  for (const auto& [file, bytes] : foreign) write(snapshots / file, bytes);
  fs::create_directories(snapshots / "intervals/empty");
  fs::create_symlink(name, own / "15-link.png");

  const auto check_all = [&](const std::string& mode) {
    INFO(mode);
    const Ran r = shell("isect check --dir notes" + mode);
    CHECK(r.status == 0);
    for (const auto& [file, bytes] : foreign) {
      INFO(file);
      CHECK(contents(snapshots / file) == bytes);
      CHECK_THAT(r.out, Contains("left alone: notes/snapshots/" + file + " was not made by isect"));
    }
    CHECK(fs::is_symlink(own / "15-link.png"));
    CHECK(fs::exists(snapshots / "intervals/empty"));
    return r.out;
  };
  for (const std::string mode : {"", " --update=missing", " --update=all"})
    CHECK_THAT(check_all(mode), !Contains("removed") && StartsWith("left alone: "));
  write(shell.work() / "notes/x.json", R"({"lesson": "intervals", "preset": "b-after-a"})");
  CHECK_THAT(check_all(" --update"), Contains("accepted intervals x"));
}

TEST_CASE("a file of another's in the place of a baseline is an error, and stays", "[check]") {
  const Accepted shell;
  write(shell.file("04-relation.png"), photo());
  write(shell.file("trace.json"), R"({"traceEvents": []})");
  for (const std::string mode : {"", " --update=missing", " --update", " --update=all"}) {
    INFO(mode);
    const Ran r = shell(check + mode);
    CHECK(r.status == 1);
    CHECK_THAT(r.out, Contains("FAILED intervals overlapping, step 4 (relation): size:"));
    CHECK_THAT(r.out, Contains("the file in its place was not made by isect"));
    CHECK_THAT(r.out, !Contains("to accept"));
    CHECK(contents(shell.file("04-relation.png")) == photo());
    CHECK(contents(shell.file("trace.json")) == R"({"traceEvents": []})");
  }
}

TEST_CASE("a baseline without its metadata still serves, but is not replaced", "[check]") {
  const Accepted shell;
  const std::string stripped = viz::png(viz::read_png(contents(shell.file("04-relation.png"))));
  write(shell.file("04-relation.png"), stripped);
  CHECK(shell(check).status == 0);
  CHECK_THAT(shell(check + " --update=all").out, Contains("left alone: " + baselines + "/04-relation.png"));
  CHECK(contents(shell.file("04-relation.png")) == stripped);
}

TEST_CASE("pictures of another's are not replaced by the new one and the difference", "[check]") {
  const Accepted shell;
  fs::copy_file(shell.file("02-a-beyond-b.png"), shell.file("04-relation.png"), fs::copy_options::overwrite_existing);
  write(shell.file("04-relation.new.png"), photo());
  write(shell.file("04-relation.diff.png"), photo());
  CHECK_THAT(shell(check).out, Contains("not written: " + baselines + "/04-relation.new.png is there"));
  CHECK(shell(check + " --update").status == 0);
  CHECK(contents(shell.file("04-relation.new.png")) == photo());
  CHECK(contents(shell.file("04-relation.diff.png")) == photo());
}

TEST_CASE("a baseline that is a link is followed", "[check]") {
  const Accepted shell;
  fs::create_directory(shell.work() / "store");
  fs::rename(shell.file("04-relation.png"), shell.work() / "store/a.png");
  fs::create_symlink("../../../store/a.png", shell.file("04-relation.png"));
  fs::rename(shell.file("trace.json"), shell.work() / "store/t.json");
  fs::create_symlink("../../../store/t.json", shell.file("trace.json"));
  CHECK(shell(check).status == 0);
  accept_other_interval(shell);
  CHECK(shell(check).status == 1);
  CHECK(shell(check + " --update").status == 0);
  CHECK(fs::is_symlink(shell.file("04-relation.png")));
  CHECK(fs::is_symlink(shell.file("trace.json")));
  CHECK(viz::png_metadata(contents(shell.work() / "store/a.png")).contains("file"));
  CHECK(shell(check).status == 0);

  fs::remove(shell.work() / "store/a.png");
  CHECK(shell(check).status == 3);
  CHECK(shell(check + " --update=missing").status == 0);
  CHECK(fs::exists(shell.work() / "store/a.png"));
}

TEST_CASE("baselines of a preset or lesson that is gone are left over", "[check]") {
  const Accepted shell;
  std::string trace = contents(shell.file("trace.json"));
  trace.replace(trace.find("\"overlapping\""), 13, "\"gone\"");
  write(shell.work() / "snapshots/intervals/gone/trace.json", trace);
  const std::string picture = contents(shell.file("02-a-beyond-b.png"));
  write(shell.work() / "snapshots/intervals/gone/02-a-beyond-b.png", as_of(picture, {intervals.lesson, "gone"}, "02"));
  write(shell.work() / "snapshots/no-lesson/x/01-a.png",
        viz::png(viz::read_png(picture), {{"lesson", "no-lesson"}, {"file", "no-lesson/x/01-a"}}));
  write(shell.work() / "snapshots/README.md", "no baseline");
  const Ran one = shell(check);
  CHECK(one.status == 0);  // one preset was selected, and that one is whole
  const auto result = nlohmann::json::parse(shell("isect check --json").out);
  std::vector<std::string> files;
  for (const auto& f : result["failures"])
    if (f["kind"] == "orphan") files.push_back(f["baseline"]);
  CHECK(files == std::vector<std::string>{"snapshots/intervals/gone/02-a-beyond-b.png",
                                          "snapshots/intervals/gone/trace.json", "snapshots/no-lesson/x/01-a.png"});
  CHECK(result["accept"] == "isect check --update=failed");
  CHECK_THAT(shell("isect check intervals --update").out, Contains("removed intervals gone: "));
  CHECK_FALSE(fs::exists(shell.work() / "snapshots/intervals/gone"));
  CHECK(fs::exists(shell.work() / "snapshots/no-lesson/x/01-a.png"));
}

}  // namespace check_ownership_test
