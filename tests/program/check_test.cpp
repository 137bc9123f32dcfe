// Snapshot regression as a maintainer meets it: what is noticed, how it is told, what accepts it.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "tests/program/shell.h"
#include "viz/files.h"
#include "viz/place.h"
#include "viz/snapshot.h"

namespace check_test {
namespace fs = std::filesystem;
namespace viz = isect::viz;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using isect::test::contents;
using isect::test::Ran;
using isect::test::Shell;
using isect::test::write;

namespace {

const std::string check = "isect check ray-sphere --preset two-roots";
const std::string baselines = "snapshots/ray-sphere/two-roots";

/// A scratch folder with accepted baselines of one preset.
class Accepted : public Shell {
 public:
  Accepted() {
    const Ran r = (*this)(check + " --update");
    if (r.status != 0) throw std::runtime_error("could not make baselines: " + r.out + r.err);
  }
  fs::path file(const std::string& name) const { return work() / baselines / name; }
};

/// The baselines as they would be had the sphere another radius: trace by the library, pictures by render.
void accept_with_radius(const Accepted& shell, double radius) {
  const viz::Lesson& lesson = *isect::lessons::all_lessons()[0];
  viz::Parameters parameters = viz::preset(lesson, "two-roots").parameters;
  parameters["radius"] = radius;
  const auto made = nlohmann::json::parse(contents(shell.file("trace.json")))["made with"];
  const viz::Stamp stamp{made["renderer"], made["font"], made["theme"], made["size"]};
  write(shell.file("trace.json"),
        viz::trace_json(lesson, "two-roots", parameters, lesson.walk(parameters), stamp));
  const Ran r =
      shell("isect render ray-sphere --preset two-roots --out other --set radius=" + viz::to_text(radius) +
            " && cp other/ray-sphere/two-roots/*.png " + baselines);
  REQUIRE(r.status == 0);
}

std::string contents_of_preset(const std::string& id) {
  const viz::Lesson& lesson = *isect::lessons::all_lessons()[0];
  return "{\"lesson\": \"" + lesson.id +
         "\", \"parameters\": " + viz::to_json(viz::preset(lesson, id).parameters) + "}";
}

double radius() {
  const viz::Lesson& lesson = *isect::lessons::all_lessons()[0];
  return std::get<double>(viz::preset(lesson, "two-roots").parameters.at("radius"));
}

}  // namespace

TEST_CASE("what was accepted passes, from any locale and with CI set", "[check]") {
  const Accepted shell;
  const Ran r = shell(check);
  CHECK(r.status == 0);
  CHECK_THAT(r.out, StartsWith("ok: 12 pictures of 1 preset\n"));
  CHECK(r.err.empty());
  CHECK(shell("CI=1 LC_ALL=C LANG=de_DE.UTF-8 " + check + " --backend egl").status == 0);
}

TEST_CASE("a radius larger by a thousandth fails and is named by lesson, step and first difference",
          "[check]") {
  const Accepted shell;
  accept_with_radius(shell, radius() / 1.001);
  const Ran r = shell(check);
  CHECK(r.status == 1);
  const std::string first = r.out.substr(0, r.out.find('\n'));
  CHECK_THAT(first, StartsWith("FAILED ray-sphere two-roots, step "));
  CHECK_THAT(first, Contains("trace: r²") || Contains("trace: r was"));
  CHECK_THAT(r.out, Contains("parameter radius was"));
  CHECK_THAT(r.out, Contains("step 3 (distance): picture:") && Contains("pixels differ by more than 8"));
  CHECK_THAT(r.out,
             Contains(baselines + "/03-distance.new.png") && Contains(baselines + "/03-distance.diff.png"));
  CHECK_THAT(r.out, Contains("isect check ray-sphere --update=failed"));
  CHECK(viz::read_png(contents(shell.file("03-distance.diff.png"))).width == 960);

  CHECK(shell(check + " --update=missing").status == 1);  // nothing is missing
  CHECK(shell(check + " --update=failed").status == 0);
  CHECK(shell(check).status == 0);
  CHECK_FALSE(fs::exists(shell.file("03-distance.new.png")));
  CHECK_FALSE(fs::exists(shell.file("03-distance.diff.png")));
}

TEST_CASE("a missing baseline exits 3, a failed check outranks it", "[check]") {
  const Accepted shell;
  fs::remove(shell.file("02-along-the-ray.png"));
  const Ran missing = shell(check);
  CHECK(missing.status == 3);
  CHECK_THAT(missing.out, Contains("MISSING ray-sphere two-roots, step 2 (along-the-ray)") &&
                              Contains("--update=missing"));

  fs::copy_file(shell.file("01-to-center.png"), shell.file("03-distance.png"),
                fs::copy_options::overwrite_existing);
  CHECK(shell(check).status == 1);
  CHECK(shell(check + " --update=missing").status == 1);
  CHECK(fs::exists(shell.file("02-along-the-ray.png")));
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
  fs::copy_file(shell.file("01-to-center.png"), shell.file("13-left-over.png"));
  write(shell.file("03-distance.png"), "no picture");
  REQUIRE(shell("isect render ray-sphere --preset two-roots --step 4 --size 480x300 --out - >" + baselines +
                "/04-early-reject.png")
              .status == 0);
  fs::copy_file(shell.file("05-passing-distance.png"), shell.file("02-along-the-ray.png"),
                fs::copy_options::overwrite_existing);
  write(shell.file("trace.json"), "{}");
  fs::remove(shell.file("05-passing-distance.png"));
  const auto result = nlohmann::json::parse(shell(check + " --json --report report.html").out);
  CHECK(result["passed"] == false);
  std::map<std::string, nlohmann::json> failures;
  for (const auto& f : result["failures"]) failures[f["kind"]] = f;
  REQUIRE(failures.size() == 6);
  CHECK_THAT(failures["trace"]["what"].get<std::string>(), Contains("damaged"));
  CHECK(failures["unreadable"]["step"] == 3);
  CHECK_THAT(failures["size"]["what"].get<std::string>(), Contains("480x300") && Contains("960x600"));
  CHECK(failures["picture"]["slug"] == "along-the-ray");
  CHECK(failures["picture"]["pixels_over_8"] > 24);
  CHECK(failures["missing"]["step"] == 5);
  CHECK_THAT(failures["orphan"]["baseline"].get<std::string>(), Contains("13-left-over.png"));
  CHECK(failures["orphan"]["accept"] == "isect check ray-sphere --update=failed");

  const std::string report = contents(shell.work() / "report.html");
  CHECK_THAT(report, StartsWith("<!DOCTYPE html>") && Contains("data:image/png;base64,iVBORw0KGgo") &&
                         Contains("480x300"));
  CHECK_THAT(report, !Contains("src=\"snapshots") && !Contains("http"));

  CHECK(shell(check + " --update").status == 0);
  CHECK_FALSE(fs::exists(shell.file("13-left-over.png")));
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

TEST_CASE("baselines of a preset or lesson that is gone are left over", "[check]") {
  const Accepted shell;
  write(shell.work() / "snapshots/ray-sphere/gone/trace.json", "{}");
  write(shell.work() / "snapshots/no-lesson/x/01-a.png", "");
  write(shell.work() / "snapshots/README.md", "no baseline");
  const Ran one = shell(check);
  CHECK(one.status == 0);  // one preset was asked for, and that one is whole
  const auto orphans = [&](const std::string& command) {
    std::vector<std::string> files;
    const auto result = nlohmann::json::parse(shell(command).out);
    for (const auto& f : result["failures"])
      if (f["kind"] == "orphan") files.push_back(f["baseline"]);
    return files;
  };
  CHECK(orphans("isect check --json") ==
        std::vector<std::string>{"snapshots/no-lesson/x/01-a.png", "snapshots/ray-sphere/gone/trace.json"});
}

TEST_CASE("another folder is named in the command that accepts", "[check]") {
  const Shell shell;
  const Ran r = shell(check + " --snapshots base/lines");
  CHECK(r.status == 3);
  CHECK_THAT(r.out, Contains("isect check ray-sphere --snapshots base/lines --update=missing"));
}

TEST_CASE("check refuses wrong names and unwritable places", "[check]") {
  const Shell shell;
  CHECK_THAT(shell("isect check ray-spere").err, Contains("mean \"ray-sphere\""));
  CHECK_THAT(shell("isect check --update=fialed").err, Contains("update") && Contains("mean \"failed\""));
  CHECK_THAT(shell("isect check --preset tangnt").err, Contains("mean \"tangent\""));
  CHECK_THAT(shell("isect check --backend mesa").err, Contains("mean \"osmesa\""));
  CHECK(shell("isect check --update=fialed").status == 2);
  CHECK(shell(check + " --update --snapshots /proc/nowhere").status == 4);
  CHECK(shell(check + " --report /proc/nowhere/r.html").status == 4);
}

TEST_CASE("the first preset of a group has a picture of each step, the others of the last", "[check]") {
  const Shell shell;
  CHECK_THAT(shell("isect check ray-sphere --preset two-roots --update").out,
             Contains("ok: 12 pictures of 1 preset;"));
  CHECK_THAT(shell("isect check ray-sphere --preset two-roots-half-b --update").out,
             !Contains("ok: 1 picture of"));
  CHECK_THAT(shell("isect check ray-sphere --preset behind --update").out,
             Contains("ok: 1 picture of 1 preset;"));
}

TEST_CASE("presets of one's own are checked against baselines beside them", "[check]") {
  const Shell shell;
  write(shell.work() / "course/week-3.json", contents_of_preset("behind"));
  write(shell.work() / "course/week-4.json", contents_of_preset("tangent"));
  write(shell.work() / "course/manifest.json", "[]");

  const Ran missing = shell("isect check --dir course");
  CHECK(missing.status == 3);
  CHECK_THAT(missing.out, Contains("isect check ray-sphere --dir course --update=missing"));

  const Ran made = shell("isect check --dir course --update=missing");
  CHECK(made.status == 0);
  CHECK(fs::exists(shell.work() / "course/ray-sphere/week-3/trace.json"));
  CHECK(fs::exists(shell.work() / "course/ray-sphere/week-4/11-intersect.png"));
  CHECK_THAT(shell("isect check --dir course").out, StartsWith("ok: ") && Contains("2 presets"));

  SECTION("a changed preset fails, and the other is left alone") {
    write(shell.work() / "course/week-3.json", contents_of_preset("two-roots"));
    const Ran r = shell("isect check --dir course");
    CHECK(r.status == 1);
    CHECK_THAT(r.out, Contains("FAILED ray-sphere week-3") && !Contains("week-4"));
    CHECK_THAT(r.out, Contains("isect check ray-sphere --dir course --update=failed"));
    CHECK(shell("isect check --dir course --update").status == 0);
    CHECK(shell("isect check --dir course").status == 0);
  }
  SECTION("a preset that went away leaves orphans") {
    fs::remove(shell.work() / "course/week-4.json");
    const Ran r = shell("isect check --dir course");
    CHECK(r.status == 1);
    CHECK_THAT(r.out, Contains("belongs to no step of any preset"));
  }
}

TEST_CASE("a folder of presets that does not do is told what is wrong", "[check]") {
  const Shell shell;
  CHECK(shell("isect check --dir nowhere").status == 4);
  fs::create_directory(shell.work() / "empty");
  const Ran empty = shell("isect check --dir empty");
  CHECK(empty.status == 2);
  CHECK_THAT(empty.err, Contains("empty holds no preset files"));

  write(shell.work() / "bad/x.json", R"({"lesson": "ray-spere", "parameters": {}})");
  const Ran bad = shell("isect check --dir bad");
  CHECK(bad.status == 2);
  CHECK_THAT(bad.err, Contains("bad/x.json") && Contains("ray-sphere"));
  CHECK(shell("isect check --dir bad --snapshots bad").status == 2);
}

}  // namespace check_test
