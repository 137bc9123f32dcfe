// Snapshot regression as a maintainer meets it: what is noticed, and how it is reported.

#include "tests/app/accepted.h"

namespace check_test {
namespace fs = std::filesystem;
namespace viz = isect::viz;
using namespace isect::test;
using Catch::Matchers::StartsWith;

TEST_CASE("what was accepted passes, from any locale and with CI set", "[check]") {
  const Accepted shell;
  const Ran r = shell(check);
  CHECK(r.status == 0);
  CHECK_THAT(r.out, StartsWith("ok: 5 pictures of 1 preset\n"));
  CHECK(r.err.empty());
  CHECK(shell("CI=1 LC_ALL=C LANG=de_DE.UTF-8 " + check + " --backend egl").status == 0);
}

TEST_CASE("a radius larger by a thousandth fails and is named by lesson, step and first difference", "[check]") {
  const Accepted shell(ball);
  accept_with(shell, "radius", number(ball, "radius") / 1.001);
  const Ran r = shell(ball.check());
  CHECK(r.status == 1);
  CHECK_THAT(r.out, StartsWith("FAILED ray-sphere two-roots: trace: parameter radius was ") &&
                        Contains("\n    step 3: r² was "));
  CHECK_THAT(r.out, Contains("step 7 (half-chord): picture: the text of the page formula was") &&
                        Contains("the ball c is 1.001 times as large") && Contains("pixels differ by more than 8"));
  CHECK(accept_command(r.out) == ball.check() + " --update=failed");
}

TEST_CASE("the new picture and the difference lie beside the baseline until they are accepted", "[check]") {
  const Accepted shell;
  accept_other_interval(shell);
  const Ran r = shell(check);
  CHECK(r.status == 1);
  CHECK_THAT(r.out, Contains(baselines + "/04-relation.new.png") && Contains(baselines + "/04-relation.diff.png"));
  CHECK(viz::read_png(contents(shell.file("04-relation.diff.png"))).width == 960);

  CHECK(shell(check + " --update=missing").status == 1);  // nothing is missing
  CHECK(shell(check + " --update=failed").status == 0);
  CHECK(shell(check).status == 0);
  CHECK_FALSE(fs::exists(shell.file("04-relation.new.png")));
  CHECK_FALSE(fs::exists(shell.file("04-relation.diff.png")));
}

TEST_CASE("a missing baseline exits 3, a failed check outranks it", "[check]") {
  const Accepted shell;
  fs::remove(shell.file("03-b-beyond-a.png"));
  const Ran missing = shell(check);
  CHECK(missing.status == 3);
  CHECK_THAT(missing.out,
             Contains("MISSING intervals overlapping, step 3 (b-beyond-a)") && Contains("--update=missing"));

  fs::copy_file(shell.file("02-a-beyond-b.png"), shell.file("04-relation.png"), fs::copy_options::overwrite_existing);
  CHECK(shell(check).status == 1);
  CHECK(shell(check + " --update=missing").status == 1);
  CHECK(fs::exists(shell.file("03-b-beyond-a.png")));
  CHECK(shell(check + " --update").status == 0);
  CHECK(shell(check).status == 0);
}

TEST_CASE("with no baselines at all every one is missing, and nothing is written", "[check]") {
  const Shell shell;
  const Ran r = shell("CI=1 " + check);
  CHECK(r.status == 3);
  CHECK(fs::is_empty(shell.work()));
}

TEST_CASE("all failures come in one run", "[check]") {
  const Accepted shell;
  write(shell.file("07-left-over.png"),
        viz::png(viz::read_png(contents(shell.file("02-a-beyond-b.png"))),
                 {{"lesson", "intervals"}, {"file", "intervals/overlapping/07-left-over"}}));
  write(shell.file("04-relation.png"), "no picture");
  REQUIRE(shell("isect render intervals --preset overlapping --step 5 --size 480x300 --out - >" + baselines +
                "/05-cases.png")
              .status == 0);
  fs::copy_file(shell.file("02-a-beyond-b.png"), shell.file("03-b-beyond-a.png"), fs::copy_options::overwrite_existing);
  write(shell.file("trace.json"), "{}");
  fs::remove(shell.file("02-a-beyond-b.png"));
  const auto result = nlohmann::json::parse(shell(check + " --json --report report.html").out);
  CHECK(result["passed"] == false);
  std::map<std::string, nlohmann::json> failures;
  for (const auto& f : result["failures"]) failures[f["kind"]] = f;
  REQUIRE(failures.size() == 6);
  CHECK_THAT(failures["trace"]["what"].get<std::string>(), Contains("damaged"));
  CHECK(failures["unreadable"]["step"] == 4);
  CHECK_THAT(failures["size"]["what"].get<std::string>(), Contains("480x300") && Contains("960x600"));
  CHECK(failures["picture"]["slug"] == "b-beyond-a");
  CHECK(failures["picture"]["pixels_over_8"] > 24);
  CHECK(failures["missing"]["step"] == 2);
  CHECK_THAT(failures["orphan"]["baseline"].get<std::string>(), Contains("07-left-over.png"));
  CHECK(failures["orphan"]["accept"] == check + " --update=failed");
  CHECK(failures["unreadable"]["foreign"] == true);
  CHECK_FALSE(failures["unreadable"].contains("accept"));

  const std::string report = contents(shell.work() / "report.html");
  CHECK_THAT(report,
             StartsWith("<!DOCTYPE html>") && Contains("data:image/png;base64,iVBORw0KGgo") && Contains("480x300"));
  CHECK_THAT(report, !Contains("src=\"snapshots") && !Contains("src=\"http") && !Contains("href=\"http"));

  const Ran update = shell(check + " --update");
  CHECK(update.status == 1);  // two files there are not isect's
  CHECK_THAT(update.out, Contains("removed intervals overlapping: ") && Contains("; 3 accepted; 1 removed"));
  CHECK_FALSE(fs::exists(shell.file("07-left-over.png")));
  CHECK(contents(shell.file("04-relation.png")) == "no picture");
  CHECK(contents(shell.file("trace.json")) == "{}");
  CHECK_THAT(update.out, Contains("was not made by isect") && Contains("move it away"));
  CHECK_THAT(update.out, !Contains("to accept"));
  fs::remove(shell.file("04-relation.png")), fs::remove(shell.file("trace.json"));
  CHECK(shell(check + " --update=missing").status == 0);
  CHECK(shell(check).status == 0);
}

TEST_CASE("baselines made by another renderer or font are named", "[check]") {
  const Accepted shell;
  std::string trace = contents(shell.file("trace.json"));
  trace.replace(trace.find("llvmpipe"), 8, "softpipe");
  write(shell.file("trace.json"), trace);
  const Ran r = shell(check);
  CHECK(r.status == 1);
  CHECK_THAT(r.out, Contains("renderer was softpipe, is llvmpipe"));
}

TEST_CASE("a text that no picture shows is accepted without a change of any picture", "[check]") {
  const Accepted shell;
  const auto before = all_in(shell.work() / baselines);
  for (const std::string mode : {"failed", "all"}) {
    std::string trace = contents(shell.file("trace.json"));
    for (const std::string text : {"\"caption\": \"", "\"alt\": \""})
      trace.insert(trace.find(text) + text.size(), "It was said otherwise. ");
    write(shell.file("trace.json"), trace);
    const Ran r = shell(check);
    CHECK(r.status == 1);
    CHECK_THAT(r.out, Contains("caption was") && Contains("alt text was") && !Contains(".png"));
    CHECK(shell(check + " --update=" + mode).status == 0);
    CHECK(all_in(shell.work() / baselines) == before);
  }
}

TEST_CASE("a scene's title changes the picture that shows it, and no other", "[check]") {
  const Shell shell;
  const auto titled = [&](const std::string& title) {
    write(shell.work() / "s/balls.json", R"({"title": ")" + title + R"(", "objects": [
      {"sphere": "A", "center": [0, 0, 0], "radius": 1}, {"point": "p", "at": [0.5, 0, 0]}], "ask": [["p", "A"]]})");
  };
  const std::string objects = "scene/balls/01-objects.png", answer = "scene/balls/02-p-a.png";
  titled("A ball");
  REQUIRE(shell("isect check --dir s --update=missing").status == 0);
  auto before = all_in(shell.work() / "s/snapshots");
  titled("A ball and a point");
  CHECK(shell("isect check --dir s --update=all").status == 0);
  auto after = all_in(shell.work() / "s/snapshots");
  CHECK(before[objects] != after[objects]);
  CHECK(before[answer] == after[answer]);
  CHECK_THAT(shell("isect show s/snapshots/" + answer).err, Contains("name the scene's file instead"));
}

TEST_CASE("check refuses wrong names and unwritable places", "[check]") {
  const Shell shell;
  CHECK_THAT(shell("isect check ray-spere").err, Contains("mean \"ray-sphere\""));
  CHECK_THAT(shell("isect check --update=fialed").err, Contains("update") && Contains("mean \"failed\""));
  CHECK_THAT(shell("isect check ray-sphere --preset tangnt").err, Contains("mean \"tangent\""));
  CHECK_THAT(shell("isect check --backend mesa").err, Contains("mean \"osmesa\""));
  CHECK(shell("isect check --update=fialed").status == 2);
  CHECK(shell(check + " --update --snapshots /proc/nowhere").status == 4);
  CHECK(shell(check + " --report /proc/nowhere/r.html").status == 4);
}

TEST_CASE("the first preset of a group has a picture of each step but the card, the others of the last", "[check]") {
  const Shell shell;
  CHECK_THAT(shell("isect check points --preset copied --update").out, Contains("ok: 5 pictures of 1 preset;"));
  CHECK_THAT(shell("isect check points --preset chain --update").out, Contains("ok: 4 pictures of 1 preset;"));
  CHECK_THAT(shell("isect check points --preset nan --update").out, Contains("ok: 1 picture of 1 preset;"));
}

}  // namespace check_test
